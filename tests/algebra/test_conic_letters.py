"""Letters that stand for conics, compared with symmetric matrices modulo a prime.

A conic is given here by its matrix, a pole by the adjugate of that; no five points of it are chosen, and nothing of the
engine is used. A claim that is proved has to hold at random positions, one that is refuted not.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest
from algebra.conic_figures import Figure, cross
from algebra.quadric_figures import Vector, combined, dot
from commands import invoke
from faults import refused
from places import checker

import gcrules as gc
from gcrules.algebra import conics
from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.evaluate import PRIME, evaluate
from gcrules.algebra.expr import Point
from gcrules.algebra.language.statements import parse_assumption, parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import conic_points
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import InputError
from gcrules.rules.script import run_script

PLANE = parse_letters("conic K", Context(3))
FIVE = conic_points("K")
CHECK = checker("check_proof")
CLAIMS = 24


Thing = tuple[str, int, Any]  # text, step, and how it is made: a name, or a word and things


def value(thing: Thing, at: Figure) -> Vector:
    """Coordinates of a point or of a line."""
    _, _, how = thing
    if isinstance(how, str):
        return at.points[how]
    word, *parts = how
    values = [value(part, at) for part in parts]
    if word in ("polar", "tangent"):
        return at.polar(*values)
    if word == "pole":
        return at.pole(*values)
    return at.second(*values) if word == "second" else cross(*values)


def point(rng: Random, names: str, on: tuple[str, ...], depth: int) -> Thing:
    kind = rng.randrange(4) if depth else 0
    if kind == 1:
        line = made_line(rng, names, on, depth - 1)
        return f"pole({line[0]}, K)", 1, ("pole", line)
    if kind == 2:
        one, two = made_line(rng, names, on, depth - 1), made_line(rng, names, on, depth - 1)
        return f"(({one[0]}) /\\ ({two[0]}))", 1, ("meet", one, two)
    if kind == 3 and on:
        p, a = point(rng, names, on, depth - 1), rng.choice(on)
        return f"second_on_conic({p[0]}, {a}, K)", 1, ("second", p, (a, 1, a))
    name = rng.choice(names)
    return name, 1, name


def made_line(rng: Random, names: str, on: tuple[str, ...], depth: int) -> Thing:
    kind = rng.randrange(4)
    if kind == 0 and on:
        a = rng.choice(on)
        return f"tangent({a}, K)", 2, ("tangent", (a, 1, a))
    if kind == 1:
        p = point(rng, names, on, depth)
        return f"polar({p[0]}, K)", 2, ("polar", p)
    one, two = rng.sample(names, 2)
    return f"{one}{two}", 2, ("join", (one, 1, one), (two, 1, two))


def random_claim(seed: int) -> tuple[str, str, list[bool]]:
    """What is given, what is claimed, and whether it holds at three random positions."""
    rng = Random(f"conic {seed}")
    names = "abcdef"[: rng.randrange(2, 6)]
    on = tuple(names[: rng.randrange(len(names) + 1)])
    conjugate = {n: names[0] for n in names if n not in on and n != names[0] and rng.random() < 0.4}
    given = [f"incident({n}, K)" for n in on] + [f"incident({n}, polar({p}, K))" for n, p in conjugate.items()]
    kind = rng.randrange(5)
    if kind == 0:
        things = [point(rng, names, on, 1)]
        claim = f"incident({things[0][0]}, K)"
    elif kind == 1:
        things = [point(rng, names, on, 1), made_line(rng, names, on, 1)]
        claim = f"incident({things[0][0]}, {things[1][0]})"
    elif kind == 2:
        things = [point(rng, names, on, 1) for _ in range(3)]
        claim = f"collinear({', '.join(t[0] for t in things)})"
    elif kind == 3:
        things = [made_line(rng, names, on, 1)]
        claim = f"touches({things[0][0]}, K)"
    else:
        things = [made_line(rng, names, on, 1) for _ in range(3)]
        claim = f"[({things[0][0]}) /\\ ({things[1][0]}), ({things[2][0]})] == 0"
    holds = []
    for _ in range(3):
        at = Figure(rng, on, conjugate)
        values = [value(t, at) for t in things]
        if kind == 0:
            holds.append(at.form(values[0]) == 0)
        elif kind == 3:
            holds.append(dot(values[0], at.pole(values[0])) == 0)
        else:
            holds.append(dot(*values) == 0 if kind == 1 else dot(cross(*values[:2]), values[2]) == 0)
    return ", ".join(given), claim, holds


def test_random_claims_are_decided_as_matrices_say() -> None:
    verdicts = []
    for seed in range(CLAIMS):
        given, claim, holds = random_claim(seed)
        try:
            found = gc.prove(claim, given=given or (), letters="conic K", rank=3, limit=2_000)
        except InputError as fault:  # a second point of a line that is none
            verdicts.append(fault.message)
            continue
        verdicts.append(found.verdict)
        assert found.verdict == "undecided" or (found.verdict == "proved") == all(holds), (given, claim, holds)
        assert not any(set("¹²³⁴⁵") & set(e) for e in (*found.assumed, *found.meanings)), found
    assert verdicts.count("proved") > CLAIMS // 4
    assert verdicts.count("refuted") > CLAIMS // 3
    assert all("vanish" in v or "does not exist" in v for v in verdicts if " " in v)


# --- words -----------------------------------------------------------------------------------------------------------


def matrix_of(points: dict[str, Vector]) -> list[list[int]]:
    """Of the conic through five points: the numbers that are orthogonal to their products of coordinates."""
    rows = [[x * x, y * y, z * z, 2 * y * z, 2 * z * x, 2 * x * y] for x, y, z in (points[n] for n in FIVE)]
    a, b, c, d, e, f = (
        (-1) ** i * determinant([[row[j] for j in range(6) if j != i] for row in rows]) for i in range(6)
    )
    return [[a, f, e], [f, b, d], [e, d, c]]


def determinant(rows: Sequence[Sequence[int]]) -> int:
    if len(rows) == 1:
        return rows[0][0] % PRIME
    minors = ([row[:i] + row[i + 1 :] for row in map(list, rows[1:])] for i in range(len(rows)))
    return sum((-1) ** i * rows[0][i] * determinant(m) for i, m in enumerate(minors)) % PRIME


def proportional(p: Sequence[int], q: Sequence[int]) -> bool:
    return any(p) and any(q) and not any(cross(p, q))


def test_words_are_what_the_matrix_says() -> None:
    rng = Random("words")
    points = {n: tuple(rng.randrange(1, PRIME) for _ in range(3)) for n in (*FIVE, *"pq")}
    at = Figure(rng)
    at.matrix = matrix_of(points)

    def value_of(text: str) -> Vector:
        found = evaluate(parse(text, context=parse_assumption("incident(r, K)", PLANE)), points, modulus=PRIME)
        return found if isinstance(found, tuple) else (found,)

    line = cross(points["p"], points["q"])
    assert proportional([-v for v in reversed(value_of("polar(p, K)"))], flipped(at.polar(points["p"])))
    assert proportional(value_of("pole(pq, K)"), at.pole(line))
    points["r"] = points[FIVE[2]]
    assert at.form(points["r"]) == 0 == value_of("conic(r, K)")[0]
    assert at.form(points["p"]) * value_of("conic(q, K)")[0] % PRIME == (
        at.form(points["q"]) * value_of("conic(p, K)")[0] % PRIME
    )
    assert proportional(value_of("second_on_conic(p, r, K)"), at.second(points["p"], points["r"]))
    assert value_of("tangent(r, K)") == value_of("polar(r, K)")


def flipped(h: Sequence[int]) -> Vector:
    """The Plücker coordinates 12, 13, 23 of a line of the plane, with the signs of a covector, in reversed order."""
    return tuple((-1) ** i * -h[i] % PRIME for i in range(3))


def test_a_conic_through_five_points_is_two_lines_where_three_are_on_a_line() -> None:
    rng = Random("discriminant")
    points = {n: tuple(rng.randrange(1, PRIME) for _ in range(3)) for n in FIVE}
    five = tuple(map(Point, FIVE))
    assert evaluate(conics.discriminant(*five), points, modulus=PRIME) % PRIME != 0 != determinant(matrix_of(points))
    points["K³"] = combined(2, points["K¹"], 3, points["K²"])
    assert evaluate(conics.discriminant(*five), points, modulus=PRIME) % PRIME == 0 == determinant(matrix_of(points))


# --- claims ----------------------------------------------------------------------------------------------------------

TRIANGLE = "concurrent(pole(ab, K) c, pole(bc, K) a, pole(ca, K) b)"
VERDICTS = [
    ("", "[a polar(b, K)] == [b polar(a, K)]", "proved"),
    ("", "[a polar(a, K)] == 2 conic(a, K)", "proved"),
    ("", "pole(polar(p, K), K) \\/ p == 0", "proved"),
    ("line L", "incident(pole(L, K), L)", "refuted"),
    ("incident(b, polar(a, K))", "incident(a, polar(b, K))", "proved"),
    ("on_conic(a, b, c, d, K)", "incident(ab /\\ cd, polar(ac /\\ bd, K))", "proved"),
    ("on_conic(a, b, c, d, e, f, K)", "collinear(ab /\\ de, bc /\\ ef, cd /\\ fa)", "proved"),
    ("on_conic(a, b, c, d, e, K)", "collinear(ab /\\ de, bc /\\ ef, cd /\\ fa)", "refuted"),
    ("conic L, on_conic(a, b, K), on_conic(a, b, L)", "incident(tangent(a, K) /\\ tangent(b, L), ab)", "refuted"),
    ("on_conic(a, b, K)", "touches(tangent(a, K), K)", "proved"),
    ("on_conic(a, b, K)", "touches(ab, K)", "refuted"),
    ("incident(a, K), incident(b, tangent(a, K))", "touches(ab, K)", "proved"),
    ("isotropic i j, on_conic(i, j, a, b, c, d, K)", "concyclic(a, b, c, d)", "proved"),
    ("line L, touches(L, K)", "incident(pole(L, K), L)", "proved"),
    ("line L, touches(L, K)", "incident(pole(L, K), K)", "proved"),
    ("touches(ab, K)", "touches(ab, K)", "proved"),
    ("touches(ab, K), touches(ac, K)", "touches(bc, K)", "refuted"),
    ("touches(ab, K)", "incident(a, K)", "refuted"),
    ("touches(ab, K), touches(bc, K), touches(ca, K)", TRIANGLE, "proved"),
    ("touches(ab, K), touches(bc, K), touches(ca, K)", TRIANGLE.replace(", K) b", ", K) a"), "refuted"),
]


@pytest.mark.parametrize(("given", "claim", "verdict"), VERDICTS)
def test_claims_about_conics_are_decided(given: str, claim: str, verdict: str) -> None:
    found = gc.prove(claim, given=given or (), letters="conic K", rank=3)
    assert found.verdict == verdict, found.text()


def test_a_counterexample_satisfies_what_is_given_and_refutes_the_claim() -> None:
    given = "on_conic(a, b, K), incident(p, ab)"
    found = gc.prove("incident(p, tangent(a, K))", letters="conic K", given=given, rank=3)
    points = found.counterexample
    assert points is not None
    at = parse_assumption(given, PLANE)
    for a in at.given[:2]:
        assert evaluate(a.args[0], points) == 0
    assert evaluate(parse("[p tangent(a, K)]", context=at), points) != 0
    assert "coefficients of x², y², z², yz, zx and xy" in found.text()
    assert not any(mark in found.text().replace("x², y², z²", "") for mark in "¹²³⁴⁵")


def test_the_point_in_which_a_line_touches_has_a_name_that_nobody_else_has() -> None:
    found = gc.prove("incident(t_abK, K)", letters="conic K", given="touches(ab, K)", points="t_abK", rank=3)
    assert found.verdict == "refuted"
    assert found.counterexample is not None
    assert {"t_abK", "t_abK'"} <= found.counterexample.keys()


@pytest.mark.parametrize("there", [True, False])
def test_a_line_touches_in_its_pole(there: bool) -> None:
    """What is assumed holds, with the pole of the oracle, exactly where its line is a tangent."""
    for seed in range(10):
        rng = Random(f"touching {seed}")
        at = Figure(rng, on=tuple("abcdef"))
        line = at.polar(at.points["a"]) if there else at.random()
        p, q = (cross(line, at.random()) for _ in range(2))
        five = dict(zip(FIVE, (at.points[n] for n in "bcdef"), strict=True))
        points = {**five, "p": p, "q": q, "t_pqK": at.pole(line)}
        assumed = parse_assumption("touches(pq, K)", PLANE).given
        values = [evaluate(e, points, modulus=PRIME) for a in assumed for e in equations(a, 3)]
        assert (not any(any(v) if isinstance(v, tuple) else v for v in values)) == there


@pytest.mark.parametrize(
    ("given", "claim", "assumed"),
    [
        ("incident(c, pole(b, K)), incident(c, pole(a, K))", "incident(c, pole(b, K))", ("pole(b, K)",)),
        ("incident(c, pole(b, K))", "incident(b, pole(c, K))", ("pole(c, K)",)),
    ],
)
def test_conditions_on_a_point_of_a_line_ask_for_no_choice_of_it(given: str, claim: str, assumed: tuple[str]) -> None:
    """Joined with a pole it vanishes for one point of the line at most; no line is zero, nor is the pole of one."""
    found = gc.prove(claim, rank=3, letters="conic K, line a b c", given=given)
    assert (found.verdict, found.assumed) == ("proved", assumed)


def test_points_on_a_conic_are_assumed_to_differ_where_more_is_given() -> None:
    claim, on = "incident(pole(ab, K), polar(p, K))", "on_conic(a, b, K)"
    found = gc.prove(claim, letters="conic K", given=f"{on}, incident(p, ab)", rank=3)
    assert dict(zip(found.assumed, found.meanings, strict=True))["ab"] == "the points a and b differ"
    alone = gc.prove("incident(tangent(a, K) /\\ tangent(b, K), polar(a, K))", letters="conic K", given=on, rank=3)
    assert (alone.verdict, alone.assumed) == ("proved", ())


def test_three_points_are_off_a_line_only_where_one_conic_holds_them() -> None:
    """On circles through a and b, b and d, d and a, with these on a line, da ∧ db = 0 puts d on no N that one likes."""
    found = gc.prove(
        "incident(d, N)",
        rank=3,
        letters="conic K L M N",
        given="on_conic(a, b, K), on_conic(b, d, L), on_conic(d, a, M), incident(da /\\ db, N)",
    )
    where = {"a": (0, 0, 1), "b": (1, 0, 1), "d": (2, 0, 1)}
    conditions = [evaluate(gc.parse(e, rank=3), where) for e in found.assumed]
    assert conditions.count(0) == 1, "the claim fails there, so one of the conditions has to"
    assert set(found.assumed) == {"[abd]", "ab", "bd", "da"}


@pytest.mark.parametrize("given", ["collinear(ab /\\ cd, a, f)", "[abc][abf] == 0"])
def test_what_needs_a_conic_that_no_claim_names_says_so_in_its_proof_file(given: str) -> None:
    """That three points are not on a line, since a conic that is not two lines has them."""
    on = f"on_conic(a, b, c, d, e, K), {given}"
    (theorem,) = gc.proof_file(gc.prove("[abf] == 0", rank=3, letters="conic K", given=on)).theorems
    assert "[a c d] != 0" in (said := CHECK.check(theorem.to_json())) or "[a b c] != 0" in said


UNNAMED = [
    ("collinear(ab /\\ cd, a, f)", "collinear(a, b, f)", "proved"),
    ("[abc][abf] == 0", "[abf] == 0", "proved"),
    ("", "[abc][abd] == [abd][abe]", "refuted"),
    ("incident(ab /\\ cd, ef)", "incident(f, ab)", "refuted"),
    ("concurrent(ef, cb, bf)", "fe /\\ fd == 0", "refuted"),
]


@pytest.mark.parametrize(("given", "claim", "verdict"), UNNAMED)
def test_a_conic_is_no_pair_of_lines_also_where_no_claim_names_it(given: str, claim: str, verdict: str) -> None:
    """The claims that are proved are false for two lines, and counterexamples are none of these."""
    more = f", {given}" if given else ""
    found = gc.prove(claim, rank=3, letters="conic K", given=f"on_conic(a, b, c, d, e, K){more}")
    assert found.verdict == verdict
    if found.counterexample is not None:
        brackets = conics.discriminant(*map(Point, "abcde"))
        assert evaluate(brackets, found.counterexample) != 0


def test_conics_without_five_points_have_coordinates_in_a_refutation() -> None:
    found = gc.prove("[abc] == 0", rank=3, letters="conic K", given="on_conic(a, b, K)")
    assert found.verdict == "refuted"
    assert {*FIVE} <= {*(found.counterexample or {})}


def test_assumptions_that_hold_nowhere_say_where_else_they_may() -> None:
    """f = a would do, where what a proof assumes vanishes."""
    with pytest.raises(InputError, match="or where one of these vanishes: af"):
        gc.prove("fa == 0", rank=3, letters="conic K", given="on_conic(a,b,c,d,e,K), incident(f, ab), incident(f, ac)")


def test_conditions_are_said_of_conics_and_lines_not_of_their_points() -> None:
    given = "incident(a, K), concurrent(M, ab, polar(a, K))"
    found = gc.prove("(ba) /\\ (ab) == 0", rank=3, letters="conic K, line M", given=given)
    assert found.assumed == ("b \\/ polar(a, K)",)
    assert found.meanings == ("b is not on the polar of a",)


def test_points_on_a_conic_that_are_one_point_are_refused() -> None:
    """What is given says that they are, and points of a conic are taken to differ."""
    with pytest.raises(InputError) as fault:
        gc.prove("[a b p] == 0", letters="conic K", given="on_conic(a, b, K), a \\/ b == 0", rank=3)
    assert fault.value.hint == "points that are given on one conic are taken to differ"


# --- scripts, faults, proof files -------------------------------------------------------------------------------------


def test_scripts_and_the_prompt_know_conics() -> None:
    script = "rank 3 conic K given incident(a, K) let b = second_on_conic(p, a, K) let t = tangent(b, K)"
    answer = run_script(parse_script(f'{script} claim "b": incident(b, K) claim "t": incident(b, t) show t'))
    assert [r.verdict for r in answer.results] == ["proved", "proved", "shown"]
    assert "K is the conic through K¹, K², K³, K⁴ and K⁵" in answer.text()
    prompt = [a.text for a in Interpreter().feed("rank 3\nconic K\npole(ab, K) \\/ c == 0\n:context")]
    assert prompt[-1].splitlines()[-1].split(maxsplit=1)[1].startswith("K, a conic")


FAULTS = [
    ("conic K", "a conic is a curve of the plane (rank 3); this is rank 4"),
    ("rank 3 conic K line K", "K is already declared"),
    ("rank 3 line K conic K", "K is already declared"),
    ("rank 3 conic K points K", "K is already a conic"),
    ("rank 3 conic K let K = ab", "K is already declared"),
    ("rank 3 given collinear(K, a, b) conic K", "K is already a point in what stands before"),
    ("rank 3 conic K show [K a b]", "K is a conic, not a point or a line"),
    ("rank 3 conic K show [.K a b][.c d e]", "K is a conic, not a point or a line"),
    ("rank 3 conic K claim collinear(K, a, b)", "K is a conic, not a point or a line"),
    ("rank 3 conic K claim concurrent(ab, K)", "concurrent(…) says nothing of the conic K"),
    ("rank 3 conic K show polar(K, p)", "K is a conic, not a point or a line"),
    ("rank 3 conic K show polar(K)", "polar(p, K) takes 2 arguments, found 1"),
    ("rank 3 conic K show pole(p, K)", "a point (step 1) where a line is expected"),
    ("rank 3 conic K claim touches(p, K)", "a point (step 1) where a line is expected"),
    ("rank 3 conic K given touches(a, K)", "a point (step 1) where a line is expected"),
    ("rank 3 conic K show tangent(p, K)", "nothing says that p is on K"),
    ("rank 3 conic K show second_on_conic(p, q, K)", "nothing says that q is on K"),
    (
        "rank 3 conic K claim dual(conic(p, K) == [abc])",
        "duality multiplies 1/2[p, polar(p, K)] and [abc] by different factors",
    ),
    ("rank 3 conic K rule r: conic(p, K) => 0", "K is a conic, and rules are about points"),
    ("rank 3 conic K show [K¹ a b]", "unexpected character '¹'"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults_say_what_is_wrong(text: str, message: str) -> None:
    refused(text, message)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("factor", "conic(p, K)"), "only expressions of points are factored, and K is a conic"),
        (("analyze", "ab cd ef"), "K is a conic, and what is assumed of legs is said of their points"),
    ],
)
def test_what_takes_no_conics_says_so(arguments: tuple[str, ...], message: str) -> None:
    done = invoke(*arguments, "--rank", "3", "--letters", "conic K")
    assert done.exit_code == 2
    assert message in done.stderr


def test_formulas_set_the_points_of_conics() -> None:
    assert "K_{1}" in gc.expand("polar(p, K)", letters="conic K", rank=3).latex()


CHECKED = [
    ("", "[a polar(b, K)] == [b polar(a, K)]", {*FIVE, "a", "b"}),
    ("on_conic(a, b, c, d, K)", "incident(ab /\\ cd, polar(ac /\\ bd, K))", {*"abcd", "K⁵"}),
    ("on_conic(a, b, K), incident(p, ab)", "[pole(ab, K) polar(p, K)] == 0", {"K³", "K⁴", "K⁵", *"ab"}),
]


@pytest.mark.parametrize(("given", "claim", "points"), CHECKED)
def test_proofs_about_conics_are_checked_without_the_engine(given: str, claim: str, points: set[str]) -> None:
    proof = gc.prove(claim, given=given or (), letters="conic K", rank=3)
    (one,) = json.loads(gc.proof_file(proof).json_text())["theorems"]
    assert points <= {*one["points"], *(p["name"] for p in one.get("placed", ()))}
    CHECK.check(one)
