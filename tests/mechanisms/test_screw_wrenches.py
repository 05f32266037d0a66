"""Robots some of whose wrenches are screws: the condition in which letters stand for them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from random import Random
from typing import Any

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, evaluate
from gcrules.core.linear_algebra import determinant
from gcrules.screws import RATIONALS, jacobian, plucker

FOUR = """
title: four legs and a limb of hinges
points: {A: free, B: free, a: free, b: free, c: free, d: free, O: free, P: free, Q: free, R: free, T: free}
directions: {o: free, g: free, h: free, r: free, t: free, u1: free, v1: free, u2: free, v2: free,
             u3: free, v3: free, u4: free, v4: free}
limbs:
- {name: leg 1, joints: "U(A, u1, v1) P*(A a) S(a)"}
- {name: leg 2, joints: "U(A, u2, v2) P*(A b) S(b)"}
- {name: leg 3, joints: "U(B, u3, v3) P*(B c) S(c)"}
- {name: leg 4, joints: "U(B, u4, v4) P*(B d) S(d)"}
"""
HINGES = '- {name: hinges, joints: "R*(O, o) R(P, g) R(Q, h) R(R, r) R(T, t)"}\nmobility: 5\n'


def test_a_limb_of_hinges_has_letters_for_its_wrenches() -> None:
    found = gc.analyze(gc.load(FOUR + HINGES))
    assert found.condition is None
    assert found.statement.endswith(
        "Let W1 and W2 be screws that span the wrenches of hinges. Without the wrenches along W1 and W2 the platform "
        "can turn, to first order, about p, the line AB, and about q, the common line of the planes Aab and Bcd. Each "
        "of W1 and W2 allows these two turns in one ratio only. The robot is singular exactly when the two ratios "
        "agree. This holds unless a limb is singular by itself."
    )


def moment(x: Sequence[Any], y: Sequence[Any]) -> Any:
    return sum(s * a * b for s, a, b in zip((1, -1, 1, 1, -1, 1), x, reversed(y), strict=True))


def residue(x: Fraction) -> int:
    return x.numerator * pow(x.denominator, -1, PRIME) % PRIME


def test_the_two_ratios_are_the_determinant_of_the_wrenches() -> None:
    """At exact random configurations the determinant of all locked wrenches is a multiple of the comparison of ratios,
    with a factor that is known from the lengths of the rows.
    """
    robot = gc.load(FOUR + HINGES)
    rng = Random(7)
    for _ in range(3):
        values = {n: tuple(rng.randrange(-9, 10) for _ in range(3)) for n in robot.family.sorts}
        limbs = robot.limbs_at(values)
        rows = [row for limb in limbs for row in limb.locked(RATIONALS)]
        points = {n: (*values[n], 1) for n in "ABabcd"}
        lines = [evaluate(gc.parse(t), points) for t in ("Aa", "Ab", "Bc", "Bd")]
        coordinates = [plucker(row) for row in rows]
        scale = Fraction(1)
        for line, own in zip(lines, coordinates, strict=False):
            k = next(i for i, x in enumerate(line) if x)
            scale *= Fraction(own[k]) / line[k]
            assert [x * own[k] for x in line] == [x * line[k] for x in own]
        p, q = (evaluate(gc.parse(t), points) for t in ("AB", r"Aab /\ Bcd"))

        first, second = coordinates[4:]
        ratios = moment(p, first) * moment(q, second) - moment(p, second) * moment(q, first)
        residues = [[residue(x) for x in row] for row in coordinates]
        assert determinant(residues, PRIME) == residue(-scale * ratios) != 0
        assert jacobian(limbs).rank() == 6


BALL = """
title: a leg, a ball and a limb of hinges
points: {A: free, C: free, a: free, O: free, P: free, Q: free, R: free, T: free}
directions: {o: free, g: free, h: free, r: free, t: free, u1: free, v1: free}
limbs:
- {name: leg 1, joints: "U(A, u1, v1) P*(A a) S(a)"}
- {name: hinges, joints: "R*(O, o) R(P, g) R(Q, h) R(R, r) R(T, t)"}
- {name: ball, joints: "S(C)"}
mobility: 2
"""


def test_what_never_vanishes_is_not_told() -> None:
    said = str(gc.analyze(gc.load(BALL)).statement)
    assert "parallel to one plane" not in said
    assert said.endswith(
        "The robot is singular exactly when the screw W2 is reciprocal to the line through C in the plane ACa that is "
        "reciprocal to W1. Where one of these is not determined, the robot is also singular. This holds unless a limb "
        "is singular by itself."
    )


def test_one_line_is_reciprocal_to_all_wrenches_but_the_last() -> None:
    """So that all of them depend on each other where the last one is reciprocal to it, too."""
    robot = gc.load(BALL)
    rng = Random(8)
    for _ in range(3):
        values = {n: tuple(rng.randrange(-9, 10) for _ in range(3)) for n in robot.family.sorts}
        leg, hinges, ball = ([plucker(row) for row in limb.locked(RATIONALS)] for limb in robot.limbs_at(values))
        first, second = hinges
        at = {n: (*values[n], 1) for n in "ACa"}
        sides = [_join(at[x], at[y]) for x, y in ("Ca", "aA", "AC")]
        null = [sum(moment(first, side) * at[n][i] for side, n in zip(sides, "ACa", strict=True)) for i in range(4)]
        line = _join(at["C"], null)
        assert not any(moment(row, line) for row in (*leg, *ball, first))
        residues = [[residue(Fraction(x)) for x in row] for row in (*leg, *ball, first, second)]
        assert moment(second, line)
        assert determinant(residues, PRIME)


def _join(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    return [p[i] * q[j] - p[j] * q[i] for i, j in combinations(range(4), 2)]


def test_factors_that_can_vanish_are_told() -> None:
    three = FOUR.replace("U(B, u3, v3) P*(B c)", "U(A, u3, v3) P*(A c)")
    said = str(gc.analyze(gc.load(three + HINGES)).statement)
    assert "the tetrahedron Aabc is flat" in said


CABLES = """
title: four cables and a limb of hinges
points: {A: free, B: free, a: free, b: free, c: free, d: free, O: free, P: free, Q: free, R: free, T: free}
directions: {o: free, g: free, h: free, r: free, t: free}
limbs:
- {name: c1, cable: "A a"}
- {name: c2, cable: "A b"}
- {name: c3, cable: "B c"}
- {name: c4, cable: "B d"}
"""


def test_cables_beside_a_limb_of_hinges_only_pull() -> None:
    said = str(gc.analyze(gc.load(CABLES + HINGES)).statement)
    assert said.endswith(
        "This holds unless a limb is singular by itself. Its cables only pull, and are too few to balance each other: "
        "they need a load, such as its weight."
    )
