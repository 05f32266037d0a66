"""Which factors of a condition are decided by a robot's design, and which change as it moves.

A factor whose points and directions all ride on one body, the base or the platform, keeps its value in every pose: it
is a scalar, and a rigid motion changes none. So where it vanishes the robot is singular in every pose, and a motion
neither leads there nor away.
"""

from __future__ import annotations

from collections.abc import Collection

from gcrules.algebra.expr import Bracket, Expr, Point, points_of
from gcrules.mechanisms.description.carriers import attachments, carrier
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.robot import Robot

__all__ = ["is_of_design", "rigid_bodies"]


def rigid_bodies(robot: Robot) -> tuple[frozenset[str], frozenset[str]]:
    """The names that ride on the base, and those that ride on the platform; a hinge of both may be in both."""
    own = attachments(robot)
    base, platform = (
        frozenset(name for name, on in own.items() if any(carrier(robot, a) == f"the {body}" for a in on))
        for body in (BASE, PLATFORM)
    )
    return base | AXES.keys(), platform


def is_of_design(bodies: Collection[frozenset[str]], ideal: Collection[str], e: Expr) -> bool:
    """Whether all that a factor names rides on one of the bodies; `ideal` are the directions. A bracket of three
    directions and a point is their volume, whatever the point.
    """
    names = set(points_of(e))
    if isinstance(e, Bracket) and all(isinstance(a, Point) for a in e.args):
        far = names & set(ideal)
        names = far if len(far) == len(e.args) - 1 else names
    return any(names <= body for body in bodies)
