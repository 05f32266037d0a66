"""Which factors of a condition are decided by a robot's design, and which change as it moves.

A factor whose points and directions all ride on one body, the base or the platform, keeps its value in every pose: it
is a scalar, and a rigid motion changes none. So where it vanishes the robot is singular in every pose, and a motion
neither leads there nor away.
"""

from __future__ import annotations

from collections.abc import Collection

from gcrules.algebra.expr import Bracket, Expr, Point, points_of
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.attachments import attachments
from gcrules.mechanisms.kinematics.chains import shape_of
from gcrules.mechanisms.robot import Robot

__all__ = ["is_of_design", "rigid_bodies"]


def rigid_bodies(robot: Robot) -> tuple[frozenset[str], frozenset[str]]:
    """The names that ride on the base, and those that ride on the platform; a hinge of both may be in both."""
    own = attachments(robot)
    last = [sum(len(shape_of(j.kind).motions) for j in limb.joints) for limb in robot.limbs]
    base = {name for name, on in own.items() if any(a.link == 0 for a in on)}
    platform = {name for name, on in own.items() if any(a.link == last[a.limb] for a in on)}
    return frozenset(base | AXES.keys()), frozenset(platform)


def is_of_design(bodies: Collection[frozenset[str]], ideal: Collection[str], e: Expr) -> bool:
    """Whether all that a factor names rides on one of the bodies; `ideal` are the directions. A bracket of three
    directions and a point is their volume, whatever the point.
    """
    names = set(points_of(e))
    if isinstance(e, Bracket) and all(isinstance(a, Point) for a in e.args):
        far = names & set(ideal)
        names = far if len(far) == len(e.args) - 1 else names
    return any(names <= body for body in bodies)
