r"""The one point that the planes and lines of a vanishing factor have in common."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Meet, Point, join, points_of
from gcrules.conditions.gained_motion import common_point, factors
from gcrules.core.linear_algebra import kernel
from gcrules.mechanisms.conditions.at_infinity import INFINITY
from gcrules.mechanisms.conditions.factor_causes import FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.poses.limbs.exact_values import Values, lines_at

__all__ = ["exact_meeting", "meeting"]


def exact_meeting(a: RobotAnalysis, part: FactorCause, values: Values) -> tuple[Fraction, ...] | None:
    """The one point (homogeneous) that planes and lines of a vanishing factor have in common; None where there is not
    one.
    """
    points = lines_at(a.robot.family, a.structure, values)
    if a.robot.family.plane:
        lines = [join(*map(Point, leg)) for leg in a.structure.legs if set(leg) <= set(points_of(part.expression))]
        rows = [_flat_row(evaluate(line, points)) for line in lines]
        found = kernel(rows, 3) if len(rows) > 2 else []
        return (found[0][0], found[0][1], Fraction(0), found[0][2]) if len(found) == 1 else None
    for factor in factors(part.expression):
        if isinstance(factor, Meet) and INFINITY not in factor.children and (met := common_point(factor, points)):
            return met
    return None


def _flat_row(p: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """The equation of a line in the plane z = 0 from its coordinates 12, 13, 14, 23, 24, 34: of points (x, y, w)."""
    return p[4], -p[2], p[0]


def meeting(a: RobotAnalysis, part: FactorCause, values: Values) -> tuple[tuple[float, float, float], bool] | None:
    """The same in floats: the point in the unit of the file, or its direction if it is at infinity (then True)."""
    met = exact_meeting(a, part, values)
    if met is None:
        return None
    x, y, z = (float(c / (met[3] or 1)) for c in met[:3])
    return (x, y, z), not met[3]
