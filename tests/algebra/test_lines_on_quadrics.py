"""Lines on quadrics, and lines that touch them, compared with symmetric matrices modulo a prime.

Positions are drawn for the quadric x y = z w; nothing of the engine is used.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from itertools import combinations
from random import Random

import pytest
from places import checker

import gcrules as gc
from gcrules.algebra.evaluate import PRIME
from gcrules.core.errors import InputError

CHECK = checker("check_proof")
LINE = "on_quadric(a, b, c, Q)"
Vector = list[int]
Position = dict[str, Vector]


def polar(p: Sequence[int], q: Sequence[int]) -> int:
    """The bilinear form of x y - z w."""
    return (p[0] * q[1] + p[1] * q[0] - p[2] * q[3] - p[3] * q[2]) % PRIME


def combined(rng: Random, *points: Sequence[int]) -> Vector:
    numbers = [rng.randrange(1, PRIME) for _ in points]
    return [sum(n * p[i] for n, p in zip(numbers, points, strict=True)) % PRIME for i in range(4)]


def anywhere(rng: Random) -> Vector:
    return [rng.randrange(PRIME) for _ in range(4)]


def on_quadric(rng: Random) -> Vector:
    x, z, w = (rng.randrange(1, PRIME) for _ in range(3))
    return [x, z * w * pow(x, -1, PRIME) % PRIME, z, w]


def line_through(p: Vector, rng: Random) -> tuple[Vector, Vector]:
    """A point and another one on a line of either family: the form is the determinant of [[x, z], [w, y]]."""
    s = rng.randrange(1, PRIME)
    other = [p[0], s * p[1] % PRIME, p[2], s * p[3] % PRIME]
    other = [p[0], s * p[1] % PRIME, s * p[2] % PRIME, p[3]] if rng.random() < 0.5 else other
    assert not any((polar(p, p), polar(other, other), polar(p, other)))
    return p, other


def on_a_line(rng: Random) -> Position:
    """Points a, b, c, d, x of a line of the quadric, and p of space."""
    base = line_through(on_quadric(rng), rng)
    found = {n: combined(rng, *base) for n in "abcdx"}
    return {**found, "p": anywhere(rng)}


def touching(rng: Random) -> Position:
    """The line of a, b and x touches in a; d is on its polar, which is in the tangent plane of a too."""
    a = on_quadric(rng)
    tangent = [_projected(anywhere(rng), a, rng) for _ in range(2)]
    b = combined(rng, a, tangent[0])
    found = {"a": a, "b": b, "c": combined(rng, a, b), "x": combined(rng, a, b), "p": anywhere(rng)}
    conjugate = [polar(b, t) for t in (tangent[0], tangent[1])]
    d = [(conjugate[0] * v - conjugate[1] * u) % PRIME for u, v in zip(*tangent, strict=True)]
    return {**found, "d": combined(rng, a, d)}


def _projected(p: Vector, a: Vector, rng: Random) -> Vector:
    """A point of the tangent plane of a."""
    q = anywhere(rng)
    return [(polar(q, a) * u - polar(p, a) * v) % PRIME for u, v in zip(p, q, strict=True)]


LINES = [
    (f"{LINE}, collinear(a, b, c), collinear(a, b, x)", {"ab", "ac", "bc"}),
    (f"ideal a, {LINE}, collinear(a, b, c), collinear(a, b, x)", {"ab", "ac", "bc"}),
    (f"{LINE}, incident(c, ab), incident(x, ab)", {"ab", "ac", "bc"}),
    (f"{LINE}, a \\/ b \\/ c == 0, incident(x, ac)", {"ab", "ac", "bc"}),
    (f"line L, {LINE}, incident(a, L), incident(b, L), incident(c, L), incident(x, L)", {"ab", "ac", "bc"}),
    (f"{LINE}, incident(a, xy), incident(b, xy), incident(c, xy)", {"ab", "ac", "bc", "xy"}),
    (f"{LINE}, incident(a, polar(b, Q)), incident(a, polar(c, Q)), incident(c, polar(b, Q)), incident(x, ab)", {"ab"}),
    ("on_quadric(a, b, c, d, Q), collinear(a, b, c), collinear(b, d, a), incident(x, ab)", {"ab", "ac", "bc"}),
    ("line L, on_quadric(a, b, Q), incident(a, L), incident(b, L), incident(c, L), incident(c, polar(L, Q)), "
     "incident(x, L)", {"ac"}),
]  # fmt: skip
TOUCHING = [
    ("line L, incident(a, L), incident(a, polar(L, Q)), incident(x, L), incident(d, polar(L, Q))", set()),
    ("incident(a, bx), incident(a, polar(bx, Q)), incident(d, polar(bx, Q))", {"ab", "bx"}),
]
CLAIMS: dict[str, Callable[[Position], bool]] = {
    "incident(x, polar(a, Q))": lambda at: not polar(at["x"], at["a"]),
    "incident(x, Q)": lambda at: not polar(at["x"], at["x"]),
    "incident(a, Q)": lambda at: not polar(at["a"], at["a"]),
    "touches(ax, Q)": lambda at: not (polar(at["a"], at["a"]) * polar(at["x"], at["x"]) - polar(at["a"], at["x"]) ** 2),
    "incident(p, polar(a, Q))": lambda at: not polar(at["p"], at["a"]),
    "incident(x, polar(p, Q))": lambda at: not polar(at["x"], at["p"]),
}


def same(told: Sequence[str], expected: set[str]) -> bool:
    return {frozenset(t) for t in told} == {frozenset(t) for t in expected}


@pytest.mark.parametrize(("given", "apart"), [*LINES, *TOUCHING])
def test_claims_are_decided_as_the_form_says(given: str, apart: set[str]) -> None:
    """What is told is that points differ, and nothing else."""
    drawn = on_a_line if (given, apart) in LINES else touching
    for claim, holds in CLAIMS.items():
        found = gc.prove(claim, letters="quadric Q", given=given)
        expected = {holds(drawn(Random(f"{given} {seed}"))) for seed in range(3)}
        assert {found.verdict} == {{True: "proved", False: "refuted"}[one] for one in expected}, (given, claim)
        assert not found.proved or {frozenset(t) for t in found.assumed} <= {frozenset(t) for t in apart}, found.text()
    assert same(gc.prove("incident(a, Q)", letters="quadric Q", given=given).assumed, apart)


def test_two_lines_of_a_quadric_meet() -> None:
    given = "on_quadric(a, b, c, d, e, Q), collinear(a, b, c), collinear(c, d, e)"
    found = gc.prove("incident(d, polar(c, Q))", letters="quadric Q", given=given)
    assert found.proved
    assert same(found.assumed, {*map("".join, [*combinations("abc", 2), *combinations("cde", 2)])})
    assert gc.prove("incident(d, polar(b, Q))", letters="quadric Q", given=given).verdict == "refuted"


def test_a_counterexample_has_three_different_points_of_the_line() -> None:
    """At positions of which two points are one the claim would fail more easily."""
    given = f"{LINE}, collinear(a, b, c)"
    assert gc.prove("incident(b, polar(a, Q))", letters="quadric Q", given=given).proved
    points = gc.prove("incident(p, polar(a, Q))", letters="quadric Q", given=given).counterexample
    assert points is not None
    for one, other in combinations("abc", 2):
        u, v = points[one], points[other]
        assert any(u[i] * v[j] != u[j] * v[i] for i, j in combinations(range(4), 2))


@pytest.mark.parametrize("claim", ["incident(polar(L, Q), polar(a, Q))", "incident(a, polar(b, Q))"])
def test_a_line_that_is_a_letter_has_a_polar(claim: str) -> None:
    given = "line L, incident(a, L), incident(b, polar(L, Q))"
    found = gc.prove(claim, letters="quadric Q", given=given)
    assert (found.verdict, found.assumed) == ("proved", ())


@pytest.mark.parametrize("claim", ["incident(x, polar(a, Q))", "touches(ax, Q)"])
@pytest.mark.parametrize("given", [LINES[0][0], LINES[4][0], *(given for given, _ in TOUCHING)])
def test_such_proofs_are_checked_without_the_engine(given: str, claim: str) -> None:
    proof = gc.prove(claim, letters="quadric Q", given=given)
    file = gc.proof_file(proof)
    assert not file.left_out
    for one in json.loads(file.json_text())["theorems"]:
        CHECK.check(one)


# --- errors show no points that nobody can write ----------------------------------------------------------------------

HIDDEN = [
    (
        "quadric Q R",
        "incident(pole(polar(a, Q), R), polar(a, R))",
        "vanishes at all positions that were found to satisfy what is assumed of Q and R",
        None,
    ),
    (
        "quadric Q",
        "on_quadric(a, b, Q), a \\/ b == 0",
        "vanishes at all positions that were found to satisfy what is assumed of Q",
        "the points a and b are taken to differ, and their line not to be on Q; if it is, assume incident(b, polar(a",
    ),
    (
        "quadric Q, line L M",
        "incident(L, polar(a, Q)), incident(M, polar(a, Q)), L \\/ M == 0, incident(a, L), incident(a, M), "
        "incident(b, L), incident(b, M)",
        "cannot be resolved",
        None,
    ),
]


@pytest.mark.parametrize(("letters", "given", "message", "hint"), HIDDEN)
def test_errors_name_what_was_written(letters: str, given: str, message: str, hint: str | None) -> None:
    with pytest.raises(InputError) as fault:
        gc.prove("quadric(a, Q) == 0" if "Q" in letters else "ab == 0", letters=letters, given=given)
    told = fault.value.render()
    assert message in told
    assert not {*"¹²³⁴⁵₁₂₃₄"} & {*told}
    assert fault.value.span is not None
    assert hint is None or hint in (fault.value.hint or "")
