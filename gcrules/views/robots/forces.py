r"""Where the forces that limbs apply are drawn: a force may stand anywhere on its line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import dist

from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.lines.wrenches import WrenchLine
from gcrules.views.drawing.bsp import XYZ, dot, minus
from gcrules.views.drawing.solids import center
from gcrules.views.robots.drawn_limb import DrawnLimb, unit_vector

__all__ = ["REACH", "force", "forces"]

REACH = 0.34
"""The length of the arrow of a force, in the robot's radius."""


def forces(
    a: RobotAnalysis, chain: DrawnLimb, points: Mapping[str, XYZ], ideal: Mapping[str, XYZ], plate: Sequence[XYZ]
) -> list[tuple[XYZ, XYZ]]:
    """Where the forces of a limb are drawn, and the unit vectors outwards."""
    limb = next(one for one in a.structure.limbs if one.limb is chain.limb)
    placed = (force(line, points, ideal, plate) for line in limb.lines or ())
    return [one for one in placed if one]


def force(
    line: WrenchLine, points: Mapping[str, XYZ], ideal: Mapping[str, XYZ], plate: Sequence[XYZ]
) -> tuple[XYZ, XYZ] | None:
    """Where a force is drawn: at the end of its line that is nearer to the platform, outwards; None for a couple."""
    middle = center(plate)
    near = sorted((n for n in line.ends if n in points), key=lambda n: _distance(points[n], plate))
    if not near:
        return None
    at = points[near[0]]
    if len(near) == 2:
        u = unit_vector(minus(at, points[near[1]]))
    else:
        u = ideal[next(n for n in line.ends if n in ideal)]
        outwards = round(dot(u, minus(at, middle)), 6)
        if outwards < 0 or (not outwards and u < (0.0, 0.0, 0.0)):
            u = (-u[0], -u[1], -u[2])
    return at, u


def _distance(p: XYZ, plate: Sequence[XYZ]) -> float:
    return round(min(dist(p, q) for q in plate), 6)
