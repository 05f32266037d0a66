"""Robots some of whose wrenches are screws: the condition in which letters stand for them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
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
