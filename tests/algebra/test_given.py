"""Claims under assumptions: theorems are proved, their false siblings refuted, and nothing is assumed silently.

The second road knows nothing of constructions: it draws all positions over a small field."""

from __future__ import annotations

import random
from collections.abc import Sequence
from contextlib import suppress
from itertools import combinations

import pytest
from algebra.under_assumptions import (
    THEOREMS,
    _kinds_of_assumptions,
    check,
    decided,
    everything,
    positions,
    script_of,
    shuffle,
    vanish,
)
from hypothesis import example, given, settings
from hypothesis import strategies as st
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import kinds, resolve
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import Proof, prove
from gcrules.core.errors import InputError
from gcrules.rules.script import run_script


@pytest.mark.parametrize(("text", "claim", "sibling"), THEOREMS.values(), ids=THEOREMS)
def test_theorems(text: str, claim: str, sibling: str) -> None:
    at = script_of(text)
    for asked, verdict in ((claim, "proved"), (sibling, "refuted")):
        proof = decided(asked, at)
        assert proof.verdict == verdict, proof.text()
        check(proof, at)
    # Without the assumptions the theorem is none.
    bare = Context(at.rank, at.points, at.ideal, (), at.bound)
    assert decided(claim, bare).verdict == "refuted"


def check_everywhere(
    proofs: Sequence[Proof], at: Context, names: Sequence[str], seed: int, number: int, moduli: Sequence[int] = (2, 3)
) -> int:
    """Proved claims hold at every position that satisfies the assumptions; returns how many were looked at."""
    wanted = everything(at)
    told = [(p, ex.sub(p.left, p.right, rank=at.rank), [parse(t, context=at) for t in p.assumed]) for p in proofs]
    seen = 0
    for modulus in moduli:
        for points in positions(names, at, modulus, seed, number):
            if not vanish(wanted, points, at.rank, modulus):
                continue
            for proof, difference, assumed in told:
                if not any(vanish([e], points, at.rank, modulus) for e in assumed):
                    seen += 1
                    assert vanish([difference], points, at.rank, modulus), (at.given, proof.text(), points, modulus)
    return seen


SMALL = [
    "Pappus", "five in a plane", "a line in a plane", "a line on a line", "three planes through a line", "equal points",
    "planes through a point", "Ceva", "Menelaus", "lines through a point in space", "Desargues, lines",
    "a chain in a plane", "parallelogram", "Ceva, converse",
]  # fmt: skip


@pytest.mark.parametrize("name", SMALL)
def test_theorems_over_small_fields(name: str) -> None:
    text, claim, _ = THEOREMS[name]
    at = script_of(text)
    proof = decided(claim, at)
    names = resolve(at, points_of(proof.left, proof.right)).names
    assert check_everywhere([proof], at, names, 5, 2500) > 20


def _assumption(rank: int, draw: st.DrawFn) -> str:
    most = draw(st.integers(3, 4))
    return draw(st.sampled_from(_kinds_of_assumptions(rank, lambda n: draw(st.permutations("abcdef"))[:n], most)))()


@st.composite
def assumptions(draw: st.DrawFn, most: int = 4) -> tuple[int, list[str], str]:
    rank = draw(st.sampled_from([3, 3, 4]))
    ideal = draw(st.sampled_from(["", "", "a", "ab", "ef", "cde"]))
    return rank, [_assumption(rank, draw) for _ in range(draw(st.integers(1, most)))], ideal


def context_of(rank: int, texts: Sequence[str], ideal: str) -> Context | None:
    at = Context(rank, tuple("abcdef"), tuple(ideal))
    try:
        for t in texts:
            at = parse_assumption(t, at)
        resolve(at, "abcdef")
    except InputError:
        return None
    return at


@settings(max_examples=40)
@given(assumptions(), st.integers(0, 1000))
@example((3, ["collinear(e, b, c)", "incident(ac, bd)"], ""), 0)  # also where b is d
@example((4, ["coplanar(a, b, c, d)", "incident(abd, cef)"], ""), 0)
def test_nothing_false_is_proved(case: tuple[int, list[str], str], seed: int) -> None:
    rank, texts, ideal = case
    at = context_of(rank, texts, ideal)
    if at is None:
        return
    found = [kind.construction for kind in kinds(at, "abcdef")]
    dependent = [f"{''.join(some)} == 0" for k in range(2, rank) for some in combinations("abcdef", k)]
    claims = dependent + [f"[{''.join(some)}] == 0" for some in combinations("abcdef", rank)]
    proofs = []
    for claim in claims:
        left, right = parse_equation(claim, context=at)
        if all(c.vanishes(left) for c in found):
            with suppress(InputError):  # a claim may lead to an arrangement in which no construction is found
                proofs.append(prove(left, right, points=at.points, ideal=at.ideal, rank=rank, given=at.given))
                assert proofs[-1].verdict == "proved"
    if proofs:
        check_everywhere(proofs, at, "abcdef", seed, 250, (3, 5))  # modulo 2 `[abc] == [bac]` says nothing
    refuted = [c for c in claims if not all(k.vanishes(parse_equation(c, context=at)[0]) for k in found)]
    if refuted:
        with suppress(InputError):
            proof = decided(refuted[seed % len(refuted)], at)
            assert proof.verdict == "refuted"
            check(proof, at)


@settings(max_examples=40)
@given(assumptions(), st.randoms(use_true_random=False))
def test_order_does_not_matter(case: tuple[int, list[str], str], rng: random.Random) -> None:
    rank, texts, ideal = case
    at = context_of(rank, texts, ideal)
    shuffled = [shuffle(t, rng) for t in texts]
    rng.shuffle(shuffled)
    other = context_of(rank, shuffled, ideal)
    assert (at is None) == (other is None), (texts, shuffled)
    if at is None or other is None:
        return
    claim = f"[{''.join(rng.sample('abcdef', rank))}] == 0"
    assert decided(claim, at).verdict == decided(claim, other).verdict


# --- what was assumed ----------------------------------------------------------------------------------------------

ASSUMED = [
    # one dependency of free points: its positions are the closure of those that are reached
    (3, "collinear(a, b, c)", "[abc] == 0", ()),
    (4, "coplanar(a, b, c, d), collinear(e, f, g)", "efg == 0", ()),
    # two that share points: a and b could be one point, and c and d anywhere
    (3, "collinear(a, b, c), collinear(a, b, d)", "[acd] == 0", ("ab",)),
    (4, "coplanar(a, b, c, d), coplanar(a, b, c, e)", "[abde] == 0", ("abc",)),
    (3, r"incident(p, ab /\ cd)", "[pab] == 0", (r"ab /\ cd",)),
    (3, "p == a + b", "[pab] == 0", ()),
]


@pytest.mark.parametrize(("rank", "assumption", "claim", "assumed"), ASSUMED)
def test_assumed(rank: int, assumption: str, claim: str, assumed: tuple[str, ...]) -> None:
    proof = gc.prove(claim, rank=rank, given=assumption)
    assert (proof.verdict, proof.assumed) == ("proved", assumed)
    assert proof.to_json()["assumed"] == list(assumed)
    assert ("assumed not to vanish" in proof.text()) == bool(assumed)


def test_words_of_what_was_assumed() -> None:
    text = gc.prove("[acd] == 0", rank=3, given=["collinear(a, b, c)", "collinear(a, b, d)"]).text()
    assert "assumed not to vanish: ab (the points a and b differ)" in text


def test_the_other_component_is_excluded() -> None:
    """Where a and b are one point, c and d need not be in line with it; the answer says that it leaves this out."""
    at = parse_assumption("collinear(a, b, c), collinear(a, b, d)", Context(3))
    points = {"a": (0, 0, 1), "b": (0, 0, 1), "c": (1, 0, 1), "d": (0, 1, 1)}
    assert vanish(everything(at), points, 3)
    assert not vanish([parse("[acd]", rank=3)], points, 3)


REDUNDANT = [
    (3, "collinear(a, b, c), collinear(b, c, d), collinear(c, d, a), collinear(d, a, b)", "[abd] == 0"),
    (4, "[abcd] == 0, [abcd] == 0, [bacd] == 0, [abcd]**2 == 0", "[abcd] == 0"),
    (4, "collinear(a, b, c), coplanar(a, b, c, d)", "abc == 0"),
    (3, "coplanar(a, b, c, d), collinear(a, b, c)", "[abc] == 0"),
    (4, "[aabc] == 0, 0 == 0, concurrent(abc, def), concurrent(ab, cde)", "[aabc] == 0"),
    (4, "incident(p, abc), incident(p, ab)", "abp == 0"),
    # nine lines with three points each: the ninth follows by the theorem of Pappus
    (
        3,
        "collinear(a, b, c), collinear(d, e, f), collinear(x, b, f), collinear(x, c, e), collinear(y, c, d),"
        "collinear(y, a, f), collinear(z, a, e), collinear(z, b, d), collinear(x, y, z)",
        "[xyz] == 0",
    ),
]


@pytest.mark.parametrize(("rank", "assumption", "claim"), REDUNDANT)
def test_assumptions_that_follow_from_others(rank: int, assumption: str, claim: str) -> None:
    proof = gc.prove(claim, rank=rank, given=assumption)
    assert proof.verdict == "proved"
    check(proof, parse_assumption(assumption, Context(rank)))


def test_points_that_coincide_without_being_said_to_are_named() -> None:
    """j on ia and on ib is i, or a, b and i are on a line: the claim is proved where i and j are one point."""
    one = gc.prove("[aij] == 0", rank=3, ideal="i j", given="incident(j, ia), incident(j, ib)")
    assert one.proved
    assert one.together == (("i", "j"),)
    assert "i and j coincide, which the assumptions do not say" in str(one)
    assert one.to_json()["together"] == [["i", "j"]]
    said = gc.prove("[abx] == 0", rank=3, given="x == a")
    assert said.proved
    assert not said.together


BUTTERFLY_GIVEN = r"""
rank 3
isotropic i j
points p q a b c d
let m = midpoint(p, q)
given collinear(a, b, m), collinear(c, d, m)
given on_conic(p, q, a, b, c, d)
claim m \/ midpoint(ad /\ pq, bc /\ pq) == 0
"""


@pytest.mark.parametrize("name", ["butterfly", "radical-axes", "reim"])
def test_lines_through_points_of_a_conic_need_not_be_chosen_freely(name: str) -> None:
    """The sixth point of a conic is constructed on a line that other assumptions determine; no points coincide. The
    points of the butterfly are given here, where the example constructs them.
    """
    file = EXAMPLES / "theorems" / f"{name}.gca"
    text = BUTTERFLY_GIVEN if name == "butterfly" else file.read_text(encoding="utf-8")
    (claim,) = run_script(parse_script(text)).claims
    assert claim.proof is not None
    assert claim.proof.proved
    assert not claim.proof.together
