"""Wanted values along a way through several poses, at many of its places at once."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.rigid_motions import Floats, change_about, changed_about
from gcrules.mechanisms.kinematics.targets import Target

__all__ = ["Itinerary"]


@dataclass(frozen=True, eq=False)
class Itinerary:
    """A way through poses of the same coordinates, with one course from each of them to the next: the parameter is 0 at
    the first one, 1 at the second one. What is wanted, a goal, is as for `Course.goal`.
    """

    m: Linkage
    poses: tuple[Target, ...]

    @cached_property
    def courses(self) -> tuple[Course, ...]:
        """Those of all segments."""
        ways = pairwise(self.poses)
        return tuple(Course(self.m, target.after(before, self.m.centre)) for before, target in ways)

    @property
    def course(self) -> Course:
        """One of them, for the equations, which are the same ones throughout."""
        return self.courses[0]

    def segments(self, parameters: Floats) -> NDArray[np.intp]:
        """The segments (N,) in which parameters lie; a pose belongs to the one that begins there."""
        return np.minimum(np.floor(parameters).astype(np.intp), len(self.courses) - 1)

    def goals(self, parameters: Floats) -> Floats:
        """What is wanted at parameters (N,)."""
        k = self.segments(parameters)
        return self.further(self._starts[k], (parameters - k)[:, None] * self._values[k])

    def grown(self, first: Floats, last: Floats) -> Floats:
        """By how much the wanted values grow (N, names) from each parameter to one of the same segment."""
        return np.asarray((last - first)[:, None] * self._values[self.segments(first)])

    def further(self, goals: Floats, changes: Floats) -> Floats:
        """Goals from which the wanted values grew by changes (N, names)."""
        return changed_about(self.m.centre, goals, changes) if self._whole else goals + changes

    def changes(self, before: Floats, after: Floats) -> Floats:
        """By how much the wanted values grow (N, names) from goals straight to others."""
        return change_about(self.m.centre, before, after) if self._whole else after - before

    @property
    def _whole(self) -> bool:
        return self.course.target.whole is not None

    @cached_property
    def _starts(self) -> Floats:
        return np.array([c.target.start for c in self.courses])

    @cached_property
    def _values(self) -> Floats:
        return np.array([c.target.values for c in self.courses])
