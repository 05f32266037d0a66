r"""Exact values at a configuration of a robot: its points, its expressions, and its free motions."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Expr
from gcrules.core.floats import int_if_whole
from gcrules.core.linear_algebra import kernel
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.wrenches import PLANAR
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS

__all__ = ["Values", "Vector", "gained", "lines_at", "value_at"]

Vector = tuple[Fraction, Fraction, Fraction]
Values = Mapping[str, Vector]
"""Cartesian coordinates of all points and directions."""


def lines_at(family: Family, structure: Equivalent, values: Values) -> dict[str, tuple[Fraction, ...]]:
    """Homogeneous coordinates (x, y, z, w) of all points and directions, derived ones among them, exact."""
    every = (*structure.derived, *(d for limb in structure.limbs for d in limb.derived))
    return family.homogeneous(values) | with_derived(every, values, RATIONALS)


def value_at(family: Family, structure: Equivalent, values: Values, e: Expr) -> Fraction:
    """The value of a scalar expression, exact; in the plane points are (x, y, w).

    Whole numbers go in as such, for fractions take ten times as long.
    """
    rows = (0, 1, 3) if family.plane else (0, 1, 2, 3)
    points = {n: tuple(int_if_whole(p[i]) for i in rows) for n, p in lines_at(family, structure, values).items()}
    return Fraction(Evaluator(points, 3 if family.plane else 4).value(e)[0])


def gained(robot: Robot, values: Values) -> list[tuple[Fraction, ...]]:
    """A basis of the twists (ω; v) of the platform that no wrench of a limb with locked actuators opposes."""
    rows = [tuple(map(Fraction, row)) for row in PLANAR] if robot.family.plane else []
    for text in robot.limbs:
        rows += text.at(values, RATIONALS).locked(RATIONALS)
    return [tuple(v) for v in kernel([(*r[3:], *r[:3]) for r in rows], 6)]
