"""Letters that stand for screws, compared with six free Plücker coordinates modulo a prime."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import combinations
from random import Random

import pytest
from commands import invoke
from faults import refused
from places import checker

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import declarations, plain_name
from gcrules.algebra.screw_letters import Screw, screw, screw_points
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import GcrulesError, InputError
from gcrules.core.linear_algebra import determinant
from gcrules.rules.script import run_script

LETTERS = "screw S T, line L M, plane P Q"
SPACE = parse_letters(LETTERS, Context(4))
SIGNS = (1, -1, 1, 1, -1, 1)
"""Of the products of a Plücker coordinate with the opposite one in the mutual moment."""


def position(*texts: str) -> dict[str, tuple[int, ...]]:
    rng = Random(str(texts))
    names = points_of(*(parse(t, context=SPACE) for t in texts))
    return {n: tuple(rng.randrange(PRIME) for _ in range(4)) for n in names}


def line(a: Sequence[int], b: Sequence[int]) -> list[int]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in combinations(range(4), 2)]


def coordinates(name: str, at: dict[str, tuple[int, ...]]) -> list[int]:
    """The six coordinates of a screw: no quadratic relation holds."""
    a, b, c, d = (at[n] for n in screw_points(name))
    return [x + y for x, y in zip(line(a, b), line(c, d), strict=True)]


def moment(p: Sequence[int], q: Sequence[int]) -> int:
    """The mutual moment of two screws."""
    return sum(sign * x * q[5 - i] for i, (sign, x) in enumerate(zip(SIGNS, p, strict=True)))


def value(e: str | Expr, at: dict[str, tuple[int, ...]]) -> list[int]:
    made = parse(e, context=SPACE) if isinstance(e, str) else e
    return [v % PRIME for v in Evaluator(at, 4, PRIME).value(made)]


def test_brackets_and_meets_of_screws_are_what_six_coordinates_say() -> None:
    at = position("[S T] [a b c d]")
    s, t, ab = coordinates("S", at), coordinates("T", at), line(at["a"], at["b"])
    assert value("S", at) == [x % PRIME for x in s]
    assert value("[S T]", at) == value(r"S /\ T", at) == value(r"T \/ S", at) == [moment(s, t) % PRIME]
    assert value("[a S b]", at) == value(r"S /\ ab", at) == [moment(s, ab) % PRIME]
    assert value(r"S /\ S", at) == [2 * (s[0] * s[5] - s[1] * s[4] + s[2] * s[3]) % PRIME] != [0]
    rows = [s, t, ab, *(line(at[x], at[y]) for x, y in ("ac", "bd", "cd"))]
    assert value("[[S, T, ab, ac, bd, cd]]", at) == [determinant([[x % PRIME for x in row] for row in rows], PRIME)]


def test_lines_through_the_null_point_of_a_plane_in_it_are_reciprocal() -> None:
    at = position("[S a b] [a b c d]")
    assert value(r"[(S /\ abc) a b c]", at) == [0]
    assert value(r"S \/ a \/ (S /\ abc)", at) == [0]
    assert value(r"(S \/ d) /\ d", at) == [0]
    assert value(r"S \/ d \/ (S /\ abc)", at) != [0]


EXPRESSIONS = [
    "[S a b]",
    r"S /\ T",
    r"S /\ S",
    r"2 S + ab - T",
    r"S /\ P",
    r"(a S) /\ (b T)",
    r"[(S /\ P), (T /\ Q), L]",
    r"[S a b] [S c d] - (S /\ S) [a b c d]",
    r"[(S /\ P) a b c]",
    r"(S /\ P) \/ (S /\ Q)",
    r"[[S, ab, ac, bd, ce, de]]",
    r"[S L] ((a T) /\ M)",
    r"(S \/ a) /\ (T \/ a) /\ L",
    r"S /\ P + a",
]


@pytest.mark.parametrize("text", EXPRESSIONS)
def test_what_is_printed_has_whole_screws_is_equal_and_reads_back(text: str) -> None:
    shown = str(expand(parse(text, context=SPACE)))
    assert not set("₁₂₃ᵃᵇᶜᵈ") & set(shown), shown
    at = position(text)
    assert value(shown, at) == value(text, at)
    assert str(parse(shown, context=SPACE)) == shown
    assert value(str(parse(text, context=SPACE)), at) == value(text, at)


def test_what_is_of_the_third_degree_says_what_its_points_are() -> None:
    shown = gc.expand(r"[S a b] [S c d] [S e f]", letters="screw S").text()
    assert "# S = Sᵃ ∨ Sᵇ + Sᶜ ∨ Sᵈ, whichever points these are" in shown
    at = position(text := "[S a b] [S c d] [S e f]")
    assert value(expand(parse(text, context=SPACE)).to_expr(), at) == value(text, at)


LINEAR = [
    (r"[X a b] == -[X b a]", "proved"),
    (r"(X /\ abc) /\ abc == 0", "proved"),
    (r"[X a b] == [X c d]", "refuted"),
    (r"[X a b] c - [X a c] b + [X b c] a == -(X /\ abc)", "refuted"),
    (r"X /\ abc == [X b c] a - [X a c] b + [X a b] c", "proved"),
    (r"[[X, ab, ac, ad, bc, bd]] == [X c d] [a b c d]**2", "refuted"),
    (r"[[X, ab, ac, ad, bc, bd]] == -[X a b] [a b c d]**2", "proved"),
    (r"(X a) /\ (bcd) /\ (X a) == 0", "proved"),
    (r"[[X, ab, cd, ef, ag, bh]] == -[[ab, X, cd, ef, ag, bh]]", "proved"),
]


@pytest.mark.parametrize(("claim", "verdict"), LINEAR)
def test_a_claim_that_is_linear_in_a_screw_holds_where_it_holds_for_lines(claim: str, verdict: str) -> None:
    of_lines = gc.prove(claim.replace("X", "L"), letters="line L").verdict
    of_screws = gc.prove(claim.replace("X", "S"), letters="screw S").verdict
    assert of_lines == of_screws == verdict


QUADRATIC = [r"X /\ X == 0", r"(X a) /\ X == 0", r"(X /\ abc) \/ X == 0", r"(X a) /\ (X b) == [X a b] X"]


@pytest.mark.parametrize("claim", QUADRATIC)
def test_what_needs_the_quadratic_relation_holds_for_lines_only(claim: str) -> None:
    assert gc.prove(claim.replace("X", "L"), letters="line L").proved
    found = gc.prove(claim.replace("X", "S"), letters="screw S")
    assert found.verdict == "refuted"
    assert found.counterexample is not None
    s = coordinates("S", dict(found.counterexample))
    assert moment(s, s) != 0
    assert f"S = ({', '.join(map(str, s))}), Plücker coordinates, of pitch " in found.text()


def test_what_is_quadratic_is_decided_with_the_norm_of_the_screw() -> None:
    for claim in (r"(S a) /\ S == 1/2 (S /\ S) a", r"(S /\ P) \/ S == 1/2 (S /\ S) P"):
        assert gc.prove(claim, letters="screw S, plane P").proved, claim


def test_a_counterexample_tells_lines_and_couples_from_screws() -> None:
    found = gc.prove("[S a b] == 0", letters="screw S", ideal="a b")
    points = dict(found.counterexample or {})
    z, y, fx, x, fy, fz = coordinates("S", points)
    force, moments = (-fx, -fy, -fz), (x, -y, z)
    power = sum(f * m for f, m in zip(force, moments, strict=True))
    kind = "a couple" if not any(force) else "of pitch" if power else "a line"
    assert kind in found.text()


def test_a_screw_is_its_own_dual() -> None:
    for claim in (r"S /\ ab == 0", "[[S, T, ab, cd, ef, gh]] == -[[T, S, ab, cd, ef, gh]]", "[S a b] == [S b a]"):
        plain, dual = (gc.prove(c, letters="screw S T") for c in (claim, f"dual({claim})"))
        assert plain.verdict == dual.verdict
        assert dual.dual is not None
        assert dual.dual.letters[-1].startswith("screw S")
        other = parse_script("\n".join((*dual.dual.letters, *(f"claim {c}" for c in dual.dual.claims)))).statements
        written = gc.prove(dual.dual.claims[0], letters=", ".join(dual.dual.letters))
        assert len(other) == 1
        assert written.verdict == plain.verdict


FAULTS = [
    ("rank 3 screw S", "a screw is a wrench or a twist of space (rank 4); this is rank 3"),
    ("screw S line S", "S is already declared"),
    ("line S screw S", "S is already declared"),
    ("screw S points S", "S is already a screw (step 2)"),
    ("screw S let S = ab", "S is already declared"),
    ("screw S claim incident(a, S)", "S is a screw, which has no points"),
    ("screw S claim concurrent(ab, S + cd)", "S + cd is a screw, which has no points"),
    ("screw S orthonormal i j k claim parallel(S, ab)", "S is a screw, which has no points"),
    ("screw S orthonormal i j k show direction(2 S)", "2 * S is a screw, which has no points"),
    ("screw S show [.a S b][.c d e f]", "a dotted bracket can only hold points"),
    ("screw S show [.S a b][.c d e f]", "a dotted bracket can only hold points, and S is a screw"),
    ("screw S rule r: [S a b] => [a b S]", "S is a screw (step 2), and rules are about points"),
    ("screw S show [S a]", "a bracket of step 3, expected 4 in rank 4"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults_say_what_is_wrong(text: str, message: str) -> None:
    refused(text, message)


def test_what_is_factored_is_of_points() -> None:
    with pytest.raises(InputError, match="only expressions of points are factored, and S is a screw") as caught:
        gc.factor(parse("[S a b]", context=SPACE))
    assert caught.value.hint == "write it as a sum of two lines, ab + cd"


@pytest.mark.parametrize("command", ["factor", "factors", "shorten"])
def test_the_shell_tells_where_a_screw_is_refused(command: str) -> None:
    done = invoke(command, "--letters", "screw S", " [S a b] ")
    assert done.exit_code == 2
    assert re.match(r"error: <input>:1:2: only expressions of points are \w+, and S is a screw\n", done.stderr)
    assert "\n   ^^^^^^^\n" in done.stderr


def test_screws_are_declared_again_and_beside_lines() -> None:
    script = parse_script("screw S screw S T line L plane P")
    assert (dict(script.context.letters), script.context.screws) == ({"S": 2, "T": 2, "L": 2, "P": 3}, ("S", "T"))
    assert declarations(script.context.letters, 4, script.context.screws) == ("line L", "plane P", "screw S T")
    assert [plain_name(n) for n in screw_points("S")] == ["S1", "S2", "S3", "S4"]


def test_a_screw_stays_together() -> None:
    s = screw("S")
    assert gc.parse("a") | s == parse("a S", context=SPACE)
    assert str(parse("-S + ab", context=SPACE)) == "-S + ab"
    assert [type(e) for e in (parse("S + ab", context=SPACE)).children] == [Screw, type(gc.parse("ab"))]


LEGS = ":transversals Aa Ab Bc Bd S T\n:context"


def test_the_prompt_knows_screws() -> None:
    answers = [a.text for a in Interpreter().feed("screw S T\nS /\\ T == T /\\ S\n[S a b]\n" + LEGS)]
    assert answers[0].startswith("proved: S")
    assert "[Sab]" in answers[1]
    assert "Each of S and T" in " ".join(answers[2].split())
    assert "letters     S, a screw (step 2)" in answers[-1]


def test_legs_that_are_no_screws_are_refused() -> None:
    for legs in ("ab cd ef gh ij S + T", "ab cd ef gh ij Sa"):
        with pytest.raises(GcrulesError):
            gc.analyze(legs, letters="screw S T")


RECIPROCAL = [
    (r"S \/ ab == 0", r"S \/ ab == 0", "proved", ("ab",)),
    (r"[S a b] == 0", r"S \/ ac == 0", "refuted", ()),
    (r"S \/ ac == 0", r"S \/ ab == 0, collinear(a, b, c)", "proved", ("ab",)),
    (r"S \/ L == 0", r"S /\ L == 0", "proved", ()),
    (r"T \/ S == 0", r"S /\ T == 0", "proved", ()),
    (r"T \/ ab == 0", r"S /\ T == 0", "refuted", ()),
    (r"collinear(a, b, S /\ abc)", r"[S a b] == 0", "proved", ("ab",)),
    (r"collinear(a, c, S /\ abc)", r"[S a b] == 0", "refuted", ()),
    (r"[S a b] == [S b a]", r"S /\ abc /\ abd == 0", "proved", None),
    (r"S \/ T == 0", r"S \/ ab == 0, T \/ S == 0, [T c d] == 0", "refuted", None),
    (r"[[S, ab, T, cd, ef, gh]] == 0", r"S \/ ab == 0, T \/ S == 0", "refuted", ()),
    (r"S /\ S == 0", r"S /\ S == 0", "proved", None),
]


@pytest.mark.parametrize(("claim", "given", "verdict", "assumed"), RECIPROCAL)
def test_screws_are_assumed_to_be_reciprocal(
    claim: str, given: str, verdict: str, assumed: tuple[str, ...] | None
) -> None:
    if given.count("T") == 2:
        with pytest.raises(InputError, match="T is assumed to be reciprocal to something else already"):
            gc.prove(claim, letters="screw S T, line L", given=given)
        return
    found = gc.prove(claim, letters="screw S T, line L", given=given)
    assert found.verdict == verdict, found
    assert assumed is None or found.assumed == assumed
    assert not set("₁₂ᵃᵇᶜᵈ") & set("".join(found.assumed))
    if found.counterexample is not None:
        at = dict(found.counterexample)
        known = [a.args[0] for a in found.given if a.kind == "zero" and set(points_of(*a.args)) <= set(at)]
        assert all(v == 0 for e in known for v in Evaluator(at, 4).value(e))
        assert known or "S" not in claim
        assert not {"S₁", "S₂"} & set(at)
        sides = [tuple(Evaluator(at, 4).value(e)) for e in (found.left, found.right)]
        assert sides[0] != sides[1]


def test_scripts_assume_that_screws_are_reciprocal() -> None:
    script = "screw S\ngiven S \\/ ab == 0, incident(c, ab)\nclaim S \\/ ac == 0\nclaim [S c d] == 0"
    assert [r.verdict for r in run_script(parse_script(script)).results] == ["proved", "refuted"]


SAY_NOTHING = [
    (r"S \/ aa == 0", "everywhere"),
    (r"S \/ (abc /\ abc) == 0", "everywhere"),
    ("[S a a] == 0", "everywhere"),
    (r"2 S \/ (ab + ba) == 0", "everywhere"),
    (r"S \/ (T - T) == 0", "everywhere"),
    (r"S \/ ((ab /\ acd) \/ a) == 0", "everywhere"),
    (r"collinear(a, b, c), S \/ (abc /\ abd) == 0", "wherever the other assumptions hold"),
    (r"T \/ ab == 0, S \/ ([T a b] T) == 0", "wherever the other assumptions hold"),
]


@pytest.mark.parametrize(("given", "where"), SAY_NOTHING)
def test_what_every_screw_satisfies_is_refused(given: str, where: str) -> None:
    with pytest.raises(InputError, match=f"it holds for every screw, since .* is zero {where}$") as caught:
        gc.prove("S == 0", letters="screw S T", given=given)
    assert caught.value.span is not None


def test_scripts_refuse_what_every_screw_satisfies_with_its_place() -> None:
    script = parse_script("screw S\ngiven S \\/ aa == 0\nclaim S == 0", filename="t.gca")
    with pytest.raises(InputError, match=r"^t\.gca:2:7: .* it holds for every screw, since aa is zero everywhere"):
        run_script(script)


@pytest.mark.parametrize("given", [r"2 S \/ ab == 0", r"S \/ (2 ab) == 0", r"-(S \/ ab) == 0", "2/3 [S a b] == 0"])
def test_numbers_make_no_difference_to_what_is_assumed(given: str) -> None:
    found = gc.prove(r"S \/ ac == 0", letters="screw S", given=f"{given}, collinear(a, b, c)")
    assert (found.verdict, found.assumed) == ("proved", ("ab",))


CONDITIONS = [
    ("coplanar(a, b, c, d)", r"incident(c, S /\ abd)", (r"abd /\ S",)),
    ("collinear(a, b, c)", r"S \/ ab == 0, incident(c, S /\ abd)", (r"abd /\ S",)),
    ("coplanar(a, b, c, d)", r"T \/ ab == 0, S \/ T == 0, incident(c, S /\ abd)", (r"abd /\ S",)),
    (r"S \/ ad == 0", r"S \/ ab == 0, incident(d, (S /\ abc) \/ a)", (r"a \/ (abc /\ S)",)),
]


@pytest.mark.parametrize(("claim", "given", "assumed"), CONDITIONS)
def test_conditions_are_those_of_the_screws_themselves(claim: str, given: str, assumed: tuple[str, ...]) -> None:
    found = gc.prove(claim, letters="screw S T", given=given)
    assert (found.verdict, found.assumed) == ("proved", assumed)
    for shown, condition in zip(found.assumed, found.conditions, strict=True):
        at = position(shown)
        assert value(shown, at) == value(condition, at)
        assert any(value(shown, at))


@pytest.mark.parametrize("given", [r"incident(c, (2 S + T) /\ abd)", "[S a c] [a b c d] == 0"])
def test_what_cannot_be_said_of_a_screw_is_not_proved(given: str) -> None:
    claim = "[S a c] [a b c d] == 0" if given.startswith("[") else "coplanar(a, b, c, d)"
    found = gc.prove(claim, letters="screw S T", given=rf"S \/ ab == 0, {given}")
    assert found.verdict == "undecided"
    assert "something does not vanish that cannot be said of S" in found.reason
    assert not found.assumed
    assert not found.kinds


def test_nothing_is_assumed_of_screws_that_are_legs() -> None:
    with pytest.raises(InputError, match=r"S \\/ Aa == 0 is said of a screw, and what is assumed of legs"):
        gc.analyze("Aa Ab Ac Bd Be S", letters="screw S", given=r"S \/ Aa == 0")


OF_RECIPROCAL = {
    "a line": (r"collinear(a, b, S /\ abc)", r"S \/ ab == 0"),
    "points on the line": (r"S \/ ac == 0", r"S \/ ab == 0, collinear(a, b, c)"),
    "a superbracket": ("[[ab, S, ac, ad, bc, bd]] == 0", r"S \/ ab == 0"),
    "two screws": ("[[S, T, ab, ac, ad, bc]] == 0", r"S \/ ab == 0, T \/ ab == 0"),
    "screws of each other": (r"S /\ T == 0", r"T \/ S == 0"),
    "only one of two": (r"T \/ ac == 0", r"S \/ T == 0, T \/ ab == 0, collinear(a, b, c)"),
    "both sides": (r"S \/ ba == T \/ dc", r"S \/ ab == 0, T \/ cd == 0"),
    "a line of two planes": (r"(abc /\ def) \/ (S /\ abc) == 0", r"S \/ (abc /\ def) == 0"),
    "twice in a product": (r"coplanar(a, b, S /\ acd, S /\ abe)", r"S \/ ab == 0"),
    "twice in a sum": (
        r"(S /\ abc + S /\ abd) \/ (S /\ abe) == -1/2 (S /\ S) ([abce] + [abde]) ab",
        r"S \/ ab == 0",
    ),
    "twice on both sides": (r"(S /\ abc) \/ (S /\ abd) == -1/2 (S /\ S) [abcd] ab", r"S \/ ab == 0"),
}


@pytest.mark.parametrize(("claim", "given"), OF_RECIPROCAL.values(), ids=OF_RECIPROCAL)
def test_claims_about_reciprocal_screws_have_proof_files(claim: str, given: str) -> None:
    proof = gc.prove(claim, letters="screw S T", given=given)
    (theorem,) = gc.proof_file(proof).theorems
    assert {str(e).strip("()") for e in theorem.nonzero} <= {*map(str, proof.conditions), "S", "T"}
    printed = checker("check_proof").check(theorem.to_json())
    assert "y" not in printed


def test_proof_files_are_of_screws_of_which_nothing_is_given() -> None:
    (theorem,) = gc.proof_file(gc.prove(r"(S /\ abc) \/ S == 1/2 (S /\ S) abc", letters="screw S")).theorems
    checker("check_proof").check(data := theorem.to_json())
    assert {"Sᵃ", "Sᵇ", "Sᶜ", "Sᵈ"} < set(data["points"])
