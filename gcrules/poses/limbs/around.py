r"""Singular configurations around a configuration: the first one along each coordinate of the platform, both ways.

Courses along single actuators come to a stop, as a rule, where the actuators no longer hold the platform: the loops do
not close beyond, and no factor changes its sign. So the platform is led along one of its free coordinates at a time
while the others keep their values, and the actuators follow. This is a search along straight courses, and no proof that
nothing singular lies nearer.

>>> from gcrules.mechanisms.kinematics.linkage import linkage
>>> from gcrules.mechanisms.load import load
>>> m = linkage(load("3-rpr"))
>>> first = first_along(m, Heading("yaw", 1))
>>> round(first.distance, 4), first_along(m, Heading("x", 1))
(0.3092, None)
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.solve import Solution, check_target, free_coordinates, goal
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.limbs.first_singular import first_singular
from gcrules.poses.limbs.nearest import nearest_singular
from gcrules.screws.pose_text import ANGLES

__all__ = ["Heading", "SingularAlong", "actuator_values", "first_along", "headings", "nearest_around"]

REACH = np.pi / 3, 0.75
"""How far it is looked: radians, and parts of the robot's size."""


@dataclass(frozen=True)
class Heading:
    """One coordinate of the platform, and whether it grows (1) or falls (−1)."""

    name: str
    sign: int

    @property
    def angle(self) -> bool:
        """Whether it is measured in radians."""
        return self.name in ANGLES

    def __str__(self) -> str:
        return f"{'+' if self.sign > 0 else '−'}{self.name}"


@dataclass(frozen=True, eq=False)
class SingularAlong:
    """A singular configuration on a way, `distance` (a length or radians) from its start; `apart` is that in radians or
    in parts of the robot's size. The way is None for the nearest of all directions, of which `apart` is the distance.
    """

    way: Heading | None
    distance: float
    apart: float
    solution: Solution
    course: Course
    part: float

    def before(self, short: float) -> Configuration:
        """The configuration that lies short of it by this part of the way. Raises InputError."""
        start = Solution(self.course.m.home, self.course.target)
        return goal(self.course, start, 0.0, self.part * (1 - short)).configuration


def headings(m: Linkage) -> Iterator[Heading]:
    """Both ways along all coordinates on which the platform's pose depends at home."""
    return (Heading(name, sign) for name in free_coordinates(m) for sign in (1, -1))


def first_along(m: Linkage, way: Heading) -> SingularAlong | None:
    """The first singular configuration on a way from home, or None. Raises InputError where the robot does not assemble
    before it, or is singular at home.
    """
    names = free_coordinates(m)
    far = REACH[0] if way.angle else REACH[1] * m.size
    wanted = Target(names, np.array([way.sign * far if n == way.name else 0.0 for n in names]), text=str(way))
    check_target(m, wanted)
    found = first_singular(m, wanted)
    if found.solution is None:
        return None
    apart = found.part * (REACH[0] if way.angle else REACH[1])
    return SingularAlong(way, found.part * far, apart, found.solution, Course(m, wanted), found.part)


def nearest_around(m: Linkage) -> SingularAlong | None:
    """The nearest one of a search in all directions from home, or None."""
    found = nearest_singular(m)
    if found is None or found.solution is None:
        return None
    course = Course(m, found.solution.target)
    return SingularAlong(None, found.distance, found.distance, found.solution, course, 1.0)


def actuator_values(m: Linkage, c: Configuration) -> list[float]:
    """The amounts of the actuators that lead, in a configuration: lengths and radians."""
    return [float(c.joint_values[a.place][a.coordinate]) for a in leading(m)]
