"""Letters that stand for quadrics, compared with symmetric matrices modulo a prime.

A quadric is given here by its matrix, a pole by the adjugate of that; no lines or tetrahedra on it are chosen, and
nothing of the engine is used. A claim that is proved has to hold at random positions, one that is refuted not.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import combinations
from random import Random
from typing import Any

import pytest
from algebra.quadric_figures import WORDS, Figure, Vector, determinant, dot, drawn_claim, plane_through, tower, truths
from commands import invoke
from faults import refused
from places import checker

import gcrules as gc
from gcrules.algebra import quadric_forms
from gcrules.algebra.evaluate import PRIME, evaluate
from gcrules.algebra.expr import Point
from gcrules.algebra.language.statements import parse_assumption, parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import conic_points
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import InputError
from gcrules.rules.script import run_script

SPACE = parse_letters("quadric Q", Context())
CORNERS = conic_points("Q", 4)
CHECK = checker("check_proof")
CLAIMS = 40
TOWERS = 24


def random_claim(seed: int) -> tuple[str, str, list[bool]]:
    """What is given, what is claimed, and whether it holds at four random positions."""
    rng = Random(f"quadric {seed}")
    names = "abcdef"[: rng.randrange(3, 6)]
    on = tuple(names[: rng.randrange(len(names) + 1)])
    conjugate = {n: names[0] for n in names if n not in on and n != names[0] and rng.random() < 0.4}
    given = [f"incident({n}, Q)" for n in on] + [f"incident({n}, polar({p}, Q))" for n, p in conjugate.items()]
    claim, decided = drawn_claim(rng, names, on)
    holds = [decided(Figure(rng, on, conjugate, square)) for square in (True, False, True, False)]
    return ", ".join(given), claim, holds


def test_random_claims_are_decided_as_matrices_say() -> None:
    """What holds for quadrics with lines holds for the others too."""
    verdicts = []
    for seed in range(CLAIMS):
        given, claim, holds = random_claim(seed)
        assert len({*holds}) == 1, (given, claim)
        try:
            found = gc.prove(claim, given=given or (), letters="quadric Q", limit=2_000)
        except InputError as fault:  # the meet of a line with a plane in which it is
            verdicts.append(fault.message)
            continue
        verdicts.append(found.verdict)
        assert found.verdict == "undecided" or (found.verdict == "proved") == all(holds), (given, claim, holds)
        assert not any({*"¹²³⁴"} & {*e} for e in (*found.assumed, *found.meanings)), found
    assert verdicts.count("proved") > CLAIMS // 4
    assert verdicts.count("refuted") > CLAIMS // 3
    assert all("vanish" in v or "does not exist" in v for v in verdicts if " " in v)


def test_claims_about_points_one_after_the_other_are_decided_as_matrices_say() -> None:
    """All that is told then is that joins on which points are given do not vanish."""
    verdicts, refusals = [], list[str]()
    for seed in range(TOWERS):
        rng = Random(f"tower {seed}")
        given = tower(rng)
        on = tuple(n for n, (word, _) in given.items() if word.startswith("on"))
        claim, holds = drawn_claim(rng, "".join(given), on)
        written = ", ".join(WORDS[word].format(*names, x=x) for x, (word, names) in given.items() if WORDS[word])
        expected = truths(given, holds, rng)
        try:
            found = gc.prove(claim, given=written or (), letters="quadric Q", limit=1_000)
        except InputError as fault:
            refusals.append(fault.message)
            continue
        verdicts.append(found.verdict)
        assert found.verdict == "undecided" or (found.verdict == "proved") == all(expected), (written, claim, expected)
        assert not {*"¹²³⁴"} & {*"".join((*found.assumed, *found.meanings))}, found
    assert not {*"¹²³⁴"} & {*"".join(refusals)}
    assert verdicts.count("proved") > TOWERS // 5
    assert verdicts.count("refuted") > TOWERS // 5


# --- words -----------------------------------------------------------------------------------------------------------


def quadric_of(points: dict[str, Vector]) -> list[list[int]]:
    """The matrix of the quadric through nine points, the corners of its tetrahedron and others with y1 y2 = y3 y4: the
    numbers that are orthogonal to their products of coordinates.
    """
    corners = [points[n] for n in CORNERS]
    ys = [
        (1, 0, 0, 0),
        (0, 1, 0, 0),
        (0, 0, 1, 0),
        (0, 0, 0, 1),
        (1, 0, 2, 0),
        (3, 0, 0, 1),
        (0, 1, 5, 0),
        (0, 2, 0, 7),
    ]
    on = [[dot(column, y) for column in zip(*corners, strict=True)] for y in (*ys, (1, 1, 1, 1))]
    pairs = [(i, j) for i in range(4) for j in range(i, 4)]
    rows = [[p[i] * p[j] * (1 + (i != j)) % PRIME for i, j in pairs] for p in on]
    matrix = [[0] * 4 for _ in range(4)]
    for (i, j), value in zip(pairs, kernel(rows), strict=True):
        matrix[i][j] = matrix[j][i] = value
    return matrix


def kernel(rows: Sequence[Sequence[int]]) -> list[int]:
    """The numbers that are orthogonal to nine rows of ten, modulo the prime."""
    left, pivots = [list(row) for row in rows], list[int]()
    for column in range(10):
        k = len(pivots)
        pivot = next((i for i in range(k, 9) if left[i][column] % PRIME), None)
        if pivot is None:
            continue
        left[k], left[pivot] = left[pivot], left[k]
        inverse = pow(left[k][column], -1, PRIME)
        left[k] = [x * inverse % PRIME for x in left[k]]
        for i in range(9):
            if i != k:
                share = left[i][column]
                left[i] = [(x - share * y) % PRIME for x, y in zip(left[i], left[k], strict=True)]
        pivots.append(column)
    (free,) = {*range(10)} - {*pivots}
    found = [0] * 10
    found[free] = 1
    for row, column in zip(left, pivots, strict=True):
        found[column] = -row[free] % PRIME
    return found


def proportional(p: Sequence[int], q: Sequence[int]) -> bool:
    pairs = combinations(range(len(p)), 2)
    return any(p) and any(q) and not any((p[i] * q[j] - p[j] * q[i]) % PRIME for i, j in pairs)


def test_words_are_what_the_matrix_says() -> None:
    rng = Random("words")
    points = {n: tuple(rng.randrange(1, PRIME) for _ in range(4)) for n in (*CORNERS, *"abcx")}
    at = Figure(rng)
    at.matrix = quadric_of(points)
    points["r"] = points[CORNERS[2]]
    at.points = points
    context = parse_assumption("incident(r, Q)", SPACE)

    def value_of(text: str) -> Any:
        found = evaluate(parse(text, context=context), points, modulus=PRIME)
        return tuple(v % PRIME for v in found) if isinstance(found, tuple) else found % PRIME

    assert determinant(at.matrix)
    share = value_of("quadric(a, Q)") * pow(at.form(points["a"]), -1, PRIME) % PRIME
    assert value_of("[x polar(a, Q)]") == 2 * share * dot(points["x"], at.polar(points["a"])) % PRIME
    assert value_of("quadric(r, Q)") == 0 == at.form(points["r"])
    assert proportional(value_of("pole(abc, Q)"), at.pole(plane_through(*(points[n] for n in "abc"))))
    assert proportional(value_of("second_on_quadric(a, r, Q)"), at.second(points["a"], points["r"]))
    assert value_of("tangent(r, Q)") == value_of("polar(r, Q)")
    assert proportional(value_of("polar(ab, Q)"), value_of("polar(a, Q) /\\ polar(b, Q)"))


def test_a_quadric_is_a_cone_where_the_corners_are_in_a_plane() -> None:
    rng = Random("discriminant")
    points = {n: tuple(rng.randrange(1, PRIME) for _ in range(4)) for n in CORNERS}
    proper = quadric_forms.discriminant(*map(Point, CORNERS))
    assert evaluate(proper, points, modulus=PRIME) % PRIME != 0 != determinant(quadric_of(points))


# --- claims ----------------------------------------------------------------------------------------------------------

LINE_ON = "on_quadric(a, b, Q), incident(b, polar(a, Q))"
VERDICTS = [
    ("", "[a polar(b, Q)] == [b polar(a, Q)]", "proved"),
    ("", "[a polar(a, Q)] == 2 quadric(a, Q)", "proved"),
    ("", "pole(polar(p, Q), Q) \\/ p == 0", "proved"),
    ("plane P", "incident(pole(P, Q), P)", "refuted"),
    ("plane P, incident(a, P)", "incident(pole(P, Q), polar(a, Q))", "proved"),
    ("line L, incident(a, L)", "incident(polar(L, Q), polar(a, Q))", "proved"),
    ("line L", "incident(polar(polar(L, Q), Q), L)", "proved"),
    ("incident(b, polar(a, Q))", "incident(a, polar(b, Q))", "proved"),
    ("collinear(a, b, c)", "incident(polar(ab, Q), polar(c, Q))", "proved"),
    ("incident(a, Q)", "touches(tangent(a, Q), Q)", "proved"),
    ("incident(a, Q)", "touches(abc, Q)", "refuted"),
    ("incident(a, Q), incident(b, tangent(a, Q))", "touches(ab, Q)", "proved"),
    ("plane P, touches(P, Q)", "incident(pole(P, Q), P)", "proved"),
    ("touches(abc, Q)", "incident(pole(abc, Q), Q)", "proved"),
    ("touches(abc, Q)", "incident(a, Q)", "refuted"),
    ("plane P R, touches(P, Q), touches(R, Q)", "incident(pole(P, Q), R)", "refuted"),
    ("line L, touches(L, Q)", "touches(polar(L, Q), Q)", "proved"),
    ("touches(ab, Q), touches(ac, Q)", "touches(abc, Q)", "refuted"),
    ("incident(a, Q)", "touches(ab, Q)", "refuted"),
    (f"{LINE_ON}, incident(p, ab)", "incident(p, Q)", "proved"),
    ("on_quadric(a, b, c, Q), incident(c, polar(b, Q)), incident(p, bc)", "incident(p, Q)", "proved"),
    ("on_quadric(a, b, Q), incident(p, ab)", "incident(p, Q)", "refuted"),
    ("on_quadric(a, b, c, Q)", "incident(pole(abc, Q), tangent(c, Q))", "proved"),
    ("on_quadric(a, b, c, d, e, Q)", "incident(second_on_quadric(p, e, Q), Q)", "proved"),
    ("on_quadric(a, b, c, d, e, f, Q)", "[abcd][abef] == 0", "refuted"),
    ("quadric R, on_quadric(a, b, Q), on_quadric(a, b, R)", "incident(a, polar(b, R))", "refuted"),
    ("", "[ab polar(cd, Q)] + [ac polar(db, Q)] + [ad polar(bc, Q)] == 0", "proved"),
    ("[ab polar(cd, Q)] == 0, [ac polar(bd, Q)] == 0", "[ad polar(bc, Q)] == 0", "proved"),
    ("[ab polar(cd, Q)] == 0, [ac polar(be, Q)] == 0", "[ad polar(bc, Q)] == 0", "refuted"),
    ("line L, incident(p, polar(L, Q))", "incident(L, polar(p, Q))", "proved"),
    ("incident(c, polar(ab, Q))", "[ab polar(ac, Q)] == 0", "proved"),
    ("incident(c, polar(ab, Q))", "[bc polar(ac, Q)] == 0", "refuted"),
    ("", "a pole(bcd, Q) - b pole(acd, Q) + c pole(abd, Q) - d pole(abc, Q) == 0", "proved"),
    ("", "a pole(bcd, Q) - b pole(acd, Q) + c pole(abd, Q) + d pole(abc, Q) == 0", "refuted"),
]


@pytest.mark.parametrize(("given", "claim", "verdict"), VERDICTS)
def test_claims_about_quadrics_are_decided(given: str, claim: str, verdict: str) -> None:
    found = gc.prove(claim, given=given or (), letters="quadric Q")
    assert found.verdict == verdict, found.text()


def test_a_counterexample_satisfies_what_is_given_and_refutes_the_claim() -> None:
    given = "on_quadric(a, b, c, Q), incident(p, ab)"
    found = gc.prove("incident(p, tangent(c, Q))", letters="quadric Q", given=given)
    points = found.counterexample
    assert points is not None
    at = parse_assumption(given, SPACE)
    assert [evaluate(a.args[0], points) for a in at.given[:3]] == [0, 0, 0]
    assert not any(evaluate(parse("abp"), points))
    assert evaluate(parse("[p tangent(c, Q)]", context=at), points) != 0
    assert evaluate(quadric_forms.discriminant(*map(Point, CORNERS)), points) != 0
    text = found.text()
    squares = "x², y², z², w², yz, zx, xy, xw, yw and zw"
    assert f"coefficients of {squares}" in text
    assert not {*"¹²³⁴"} & {*text.replace(squares, "")}
    numbers = next(line for line in text.splitlines() if line.startswith("  Q = ("))
    form = [int(n) for n in numbers[7 : numbers.index(")")].split(",")]
    mixed = ((1, 2), (2, 0), (0, 1), (0, 3), (1, 3), (2, 3))
    for name in "abc":
        v = points[name]
        squared = [x * x for x in v] + [v[i] * v[j] for i, j in mixed]
        assert sum(x * y for x, y in zip(form, squared, strict=True)) == 0


CONDITIONS = [
    ("on_quadric(a, b, c, d, Q)", "incident(a, tangent(a, Q))", set()),
    (f"{LINE_ON}, incident(p, ab)", "incident(p, Q)", {"ab"}),
    ("on_quadric(a, b, Q), incident(p, polar(ab, Q))", "incident(a, polar(p, Q))", {"ab"}),
    ("on_quadric(a, b, Q), incident(p, ab)", "incident(polar(ab, Q), polar(p, Q))", {"ab", "polar(ab, Q)"}),
]


def test_a_sum_of_what_is_given_asks_for_no_conditions() -> None:
    given = "[ab polar(cd, Q)] == 0, [ac polar(bd, Q)] == 0"
    found = gc.prove("[ad polar(bc, Q)] == 0", given=given, letters="quadric Q")
    assert found.reason.startswith("both sides of its equation differ by a sum of multiples of what is given")
    assert found.assumed == ("polar(bc, Q)",)


def test_conditions_that_cannot_be_said_leave_a_claim_undecided() -> None:
    """Where the two planes on which d is are one, d can be any of their points."""
    given = "[ab polar(cd, Q)] == 0, [ac polar(bd, Q)] == 0"
    found = gc.prove("[ad polar(bc, Q)] quadric(e, Q) == 0", given=given, letters="quadric Q")
    assert found.verdict == "undecided"
    assert found.reason.endswith("that cannot be said without the corners of Q")
    assert (found.assumed, found.kinds) == ((), ())


@pytest.mark.parametrize(("given", "claim", "expected"), CONDITIONS)
def test_conditions_are_said_of_quadrics(given: str, claim: str, expected: set[str]) -> None:
    found = gc.prove(claim, given=given, letters="quadric Q")
    assert found.proved
    assert expected == {*found.assumed}
    assert not {*"¹²³⁴"} & {*found.text()}


def test_points_that_are_one_point_are_refused_without_the_points_of_letters() -> None:
    with pytest.raises(InputError) as fault:
        gc.prove("[abcp] == 0", letters="quadric Q", given="on_quadric(a, b, c, Q), c \\/ a == 0")
    assert not {*"¹²³⁴"} & {*fault.value.message}


# --- scripts, faults, proof files -------------------------------------------------------------------------------------


def test_scripts_and_the_prompt_know_quadrics() -> None:
    script = "quadric Q given incident(a, Q) let b = second_on_quadric(p, a, Q) let t = tangent(b, Q)"
    answer = run_script(parse_script(f'{script} claim "b": incident(b, Q) claim "t": touches(t, Q) show t'))
    assert [r.verdict for r in answer.results] == ["proved", "proved", "shown"]
    assert "a tetrahedron on Q has the corners Q¹, Q², Q³ and Q⁴" in answer.text()
    prompt = [a.text for a in Interpreter().feed("quadric Q\npole(abc, Q) \\/ d == 0\n:context")]
    assert prompt[-1].splitlines()[-1].split(maxsplit=1)[1].startswith("Q, a quadric")


FAULTS = [
    ("rank 3 quadric Q", "a quadric is a surface of space (rank 4); this is rank 3"),
    ("conic Q", "a conic is a curve of the plane (rank 3); this is rank 4"),
    ("quadric Q plane Q", "Q is already declared"),
    ("quadric Q points Q", "Q is already a quadric"),
    ("quadric Q show [Q a b c]", "Q is a quadric, not a point or a line"),
    ("quadric Q claim collinear(Q, a, b)", "Q is a quadric, not a point or a line"),
    ("quadric Q claim concurrent(ab, Q)", "concurrent(…) says nothing of the quadric Q"),
    ("quadric Q claim on_conic(a, Q)", "on_conic(…) says nothing of the quadric Q"),
    ("quadric Q show polar(Q, p)", "Q is a quadric, not a point or a line"),
    ("quadric Q show polar(abc, Q)", "a plane (step 3) where a point or a line is expected"),
    ("quadric Q show pole(ab, Q)", "a line (step 2) where a plane is expected"),
    ("quadric Q show pole(abc, d, Q)", "pole(P, Q) takes 2 arguments, found 3"),
    ("quadric Q show tangent(p, Q)", "nothing says that p is on Q"),
    ("quadric Q show second_on_quadric(p, q, Q)", "nothing says that q is on Q"),
    ("quadric Q claim touches(p, Q)", "a point (step 1) where a line or a plane is expected"),
    ("quadric Q given touches(p, Q)", "a point (step 1) where a line or a plane is expected"),
    ("quadric Q given touches(polar(p, Q), Q)", "is assumed of letters and of joins of points"),
    ("claim touches(abc, d)", "touches(…) is said of a letter, which stands last"),
    ("given on_quadric(a, b, c)", "takes at least 10 arguments, found 3"),
    ("show quadric(a, b)", "takes 10 arguments, found 2"),
    ("show second_on_quadric(p, a, b)", "second_on_quadric(…) is said of a letter, which stands last"),
    ("rank 3 conic K show quadric(a, K)", "quadric(…) says nothing of the conic K"),
    ("quadric Q claim dual(pole(abc, Q) == a)", "duality multiplies pole(abc, Q) and a by different factors"),
    ("quadric Q rule r: quadric(p, Q) => 0", "Q is a quadric, and rules are about points"),
    ("quadric Q show [Q¹ a b c]", "unexpected character '¹'"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults_say_what_is_wrong(text: str, message: str) -> None:
    refused(text, message)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("factor", "quadric(p, Q)"), "only expressions of points are factored, and Q is a quadric"),
        (("analyze", "ab cd ef gh ij kl"), "Q is a quadric, and what is assumed of legs is said of their points"),
    ],
)
def test_what_takes_no_quadrics_says_so(arguments: tuple[str, ...], message: str) -> None:
    done = invoke(*arguments, "--letters", "quadric Q")
    assert done.exit_code == 2
    assert message in done.stderr


@pytest.mark.parametrize(
    ("arguments", "message", "column"),
    [
        (("ab Q cd ef gh ij", "--letters", "quadric Q"), "Q is a quadric, not a leg", 4),
        (("ab bc cd ef gh ij", "--given", "quadric Q, on_quadric(a, Q)"), "Q is a quadric, and what is assumed", 12),
    ],
)
def test_legs_are_not_quadrics(arguments: tuple[str, ...], message: str, column: int) -> None:
    done = invoke("analyze", *arguments)
    assert done.exit_code == 2
    assert f"<input>:1:{column}: {message}" in done.stderr


def test_formulas_set_the_corners_of_quadrics() -> None:
    assert "Q_{1}" in gc.expand("polar(p, Q)", letters="quadric Q").latex()


CHECKED = [
    ("", "[a polar(b, Q)] == [b polar(a, Q)]", {*CORNERS, "a", "b"}),
    ("collinear(a, b, c)", "incident(polar(ab, Q), polar(c, Q))", {*CORNERS, *"abc"}),
    ("on_quadric(a, b, Q), incident(p, ab)", "incident(polar(ab, Q), polar(p, Q))", {"Q³", "Q⁴", *"abp"}),
]


@pytest.mark.parametrize(("given", "claim", "points"), CHECKED)
def test_proofs_about_quadrics_are_checked_without_the_engine(given: str, claim: str, points: set[str]) -> None:
    proof = gc.prove(claim, given=given or (), letters="quadric Q")
    for one in json.loads(gc.proof_file(proof).json_text())["theorems"]:
        assert points <= {*one["points"], *(p["name"] for p in one.get("placed", ()))}
        CHECK.check(one)
