"""Assumptions: what is refused, what holds, and how scripts, Python and commands take them."""

from __future__ import annotations

import json

import pytest
from algebra.under_assumptions import (
    THEOREMS,
    check,
    decided,
    everything,
    one,
    script_of,
    vanish,
)
from click.testing import CliRunner, Result

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import holds, resolve
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError
from gcrules.rules.script import run_script

# --- what is refused ------------------------------------------------------------------------------------------------

REFUSED = [
    (4, "1 == 0", "1 is not 0"),
    (4, "a == 0", "never zero"),
    (4, "ab == cd", "not linear"),
    (4, "[abcd] == 1", "not linear"),
    (4, "[abcd][abef] + [cdef][abce] == [cdef]**2", "not linear"),
    (4, "ideal i j k, collinear(i, a, j)", "the finite point a would have to lie at infinity"),
    (4, "ideal p, p == a", "would have to lie at infinity"),
    (3, "collinear(a, b, c), [abc] == 1", ""),
    # the plane of seven points, of which only degenerate ones exist
    (
        3,
        "incident(x, ab), incident(x, cd), incident(y, ac), incident(y, bd), incident(z, ad),incident(z, bc),[xyz]==0",
        "asks too much",
    ),
    (3, r"abc /\ def == 0", "step 4"),
    (4, r"concurrent(ab, cd, efg)", "name the point"),
    (6, r"incident(abcde /\ fghij, klmn /\ opqrs)", "not a join of points"),
    (4, r"concurrent(abc /\ def, gh, kl)", "name the point"),
]


@pytest.mark.parametrize(("rank", "assumption", "why"), REFUSED)
def test_refused(rank: int, assumption: str, why: str) -> None:
    with pytest.raises(InputError) as found:
        gc.prove("a == b", rank=rank, given=assumption)
    assert "cannot be resolved" in found.value.message
    assert why in found.value.render()
    assert found.value.exit_code == 2
    assert found.value.span is not None


EQUATIONS = [
    "a - c == d - b, a == c",
    "a == c, a - c == d - b",
    "a == c, a - (d - b) == c",
    "a + b == c + d, c == a",
    "a + b - (c + d) == 0, 2 a - c == a",
    "a + b == c + d, a - b == c - d",
    "c == a, -(c + d) == -a - b, b == d",
    "d == a + b - c, 1/2 a == 1/2 c",
]


@pytest.mark.parametrize("text", EQUATIONS)
def test_spelling_of_equations_does_not_matter(text: str) -> None:
    for names in ("a b c d", "d c b a", "c a d b"):
        at = Context(3, tuple(names.split()))
        for claim, verdict in (("a == c", "proved"), ("b == d", "proved"), ("[abe] == 0", "refuted")):
            proof = gc.prove(claim, rank=3, points=names, given=text)
            assert (proof.verdict, proof.assumed) == (verdict, ())
            check(proof, parse_assumption(text, at))


@pytest.mark.parametrize(
    ("given", "claim", "sibling"),
    [
        ("PRIME [abc] + PRIME [abd] == 0", "[abc] == -[abd]", "[abc] == 0"),
        ("PRIME a + PRIME b == PRIME c", "a + b == c", "a == c"),
        ("a == c + PRIME d", "[acd] == 0", "[abd] == 0"),
        ("[abc] + PRIME [abd] == 0", "[abc] == -PRIME [abd]", "[abd] == 0"),
    ],
)
def test_multiples_of_the_prime_are_not_dropped(given: str, claim: str, sibling: str) -> None:
    # the prime of the oracle: a condition that is a multiple of it is still one
    given, claim, sibling = (text.replace("PRIME", str(PRIME)) for text in (given, claim, sibling))
    assert gc.prove(claim, rank=3, given=given).verdict == "proved"
    proof = gc.prove(sibling, rank=3, given=given)
    assert proof.verdict == "refuted"
    check(proof, parse_assumption(given, Context(3)))


def test_a_script_names_the_line() -> None:
    script = parse_script("rank 3\n\ngiven collinear(a, b, c),\n      [abc] == 1\nclaim a == b\n", "file.gca")
    with pytest.raises(InputError) as found:
        run_script(script)
    assert found.value.place == "file.gca:4:7"


# --- interfaces -----------------------------------------------------------------------------------------------------


def test_each_claim_has_the_assumptions_before_it() -> None:
    found = run_script(
        parse_script(
            "rank 3 claim [abc]==0 given collinear(a, b, c) claim [abc]==0 given collinear(a, b, d) claim [bcd]==0"
        )
    )
    assert [c.verdict for c in found.claims] == ["refuted", "proved", "proved"]
    assert "ab (the points a and b differ)" in found.text()


def test_given_as_text_or_several() -> None:
    one = gc.prove("[bcd] == 0", rank=3, given="collinear(a, b, c), collinear(a, b, d)")
    two = gc.prove("[bcd] == 0", rank=3, given=["collinear(a, b, c)", "collinear(a, b, d)"])
    assert one == two
    e = gc.parse("[bcd]", rank=3)
    assert gc.prove(e, ex.ZERO, given="collinear(a, b, c), collinear(a, b, d)").proved


def test_command_line() -> None:
    def run(*words: str) -> Result:
        return CliRunner().invoke(cli, ["prove", *words])

    done = run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c)", "--given=collinear(a, b, d)", "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["assumed"] == ["ab"]
    assert run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c)").exit_code == 1
    assert run("ijk == 0", "--given", "ideal i j, collinear(i, j, k)").exit_code == 2
    assert run("ijk == 0", "--given", "ideal i j k, collinear(i, j, k)").exit_code == 0
    assert run("abc == 0", "--given", "collinear(a, b, c) claim a == b").exit_code == 2
    assert run("a == b", "--given", "").exit_code == 2
    shown = run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c), collinear(a, b, d)", "--latex").stdout
    assert "% " in shown.splitlines()[-1]
    assert "assumed not to vanish" in shown.splitlines()[-1]


def test_long_names() -> None:
    proof = gc.prove(
        "[left right top] == 0",
        rank=3,
        points="left right top base",
        given="collinear(left, right, base), incident(top, left right)",
    )
    assert proof.proved
    assert proof.assumed == ("left right",)


def test_names_bound_by_let() -> None:
    found = run_script(
        parse_script(
            r"rank 3 let x = ab/\cd given incident(p, x) let l = ac given incident(q, l) claim [pab]==0 claim [qac]==0"
        )
    )
    assert found.verdict == "proved"


def test_undecided_says_so() -> None:
    text, claim, _ = THEOREMS["Moebius"]
    proof = decided(claim, script_of(text), limit=10)
    assert proof.verdict == "undecided"
    assert "satisfy the assumptions" in proof.reason
    assert "limit" in proof.reason


def test_random_points_satisfy_the_assumptions() -> None:
    for text, *_ in THEOREMS.values():
        at = script_of(text)
        construction = resolve(at)
        points = construction.random_points(7)
        assert vanish(everything(at), points, at.rank, PRIME)
        assert all(points[n][-1] == 0 for n in construction.names if n in at.ideal)


HOLDS = [
    ("rank 3", "collinear(a, b, c)", False),
    ("rank 3", "coplanar(a, b, c, d)", True),
    ("rank 3", "collinear(a, b, ab /\\ cd)", True),
    ("rank 3 given collinear(a, b, c), collinear(a, b, d)", "collinear(a, b, c, d)", True),
    ("rank 3 given collinear(a, b, c), collinear(a, d, e)", "collinear(a, b, c, d)", False),
    ("given incident(q, ab), incident(q, cd), incident(q, ef)", "concurrent(ab, cd, ef)", True),
    ("given coplanar(a, b, c, d), coplanar(a, b, e, f), coplanar(c, d, e, f)", "concurrent(ab, cd, ef)", True),
    ("given coplanar(a, b, c, d), coplanar(a, b, c, e), coplanar(a, b, c, f)", "concurrent(ab, cd, ef)", False),
    ("given concurrent(ab, cd, ef)", "concurrent(cd, ef, ab)", True),
    ("", "[abcd] == -[bacd]", True),
    ("ideal i j k l", "coplanar(i, j, k, l)", True),
    ("", "coplanar(i, j, k, l)", False),
]


@pytest.mark.parametrize(("text", "assumption", "expected"), HOLDS)
def test_holds(text: str, assumption: str, expected: bool) -> None:
    at = script_of(text)
    assert holds(one(assumption, at), at) is expected
