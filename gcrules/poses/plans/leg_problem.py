"""A plan for a platform on six legs."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.everywhere import check_architecture
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.poses.plans.leg_domain import LegDomain, leg_space
from gcrules.poses.plans.leg_space import row_of
from gcrules.poses.plans.problem import margin_kept
from gcrules.poses.signs.of_legs import signs_of_legs
from gcrules.poses.signs.sign import ConditionSign, opposite
from gcrules.screws.pose import Pose

__all__ = ["LegProblem", "leg_problem"]


@dataclass(frozen=True, eq=False)
class LegProblem:
    """A `Problem`: exact poses."""

    domain: LegDomain
    start: Pose
    goal: Pose
    whereto: str = "the goal"

    @property
    def roots(self) -> Floats:
        return np.stack([row_of(self.start), row_of(self.goal)])

    @property
    def end(self) -> Floats:
        return np.asarray(self.roots[-1])

    @property
    def notes(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.start.notes, *self.goal.notes)))

    def opposed(self) -> tuple[tuple[ConditionSign, ConditionSign], ...]:
        return opposite(*(signs_of_legs(self.domain.m, p) for p in (self.start, self.goal)))


def leg_problem(m: SixLegs, start: Any, goal: Any, asked: float, limits: str | None, within: str | None) -> LegProblem:
    """What is asked for. Raises InputError where start or goal do not keep to it."""
    first, last = (read_one(given, m.unit) for given in (start, goal))
    m.rig.ends(*from_poses([first, last]))  # refuses poses that are too far away, and legs of no length
    check_architecture(m)
    rows = np.stack([row_of(first), row_of(last)])
    bare = leg_space(m, rows, 0.0, limits, within)
    kept = margin_kept(bare, rows, asked)
    return LegProblem(LegDomain(m, asked, replace(bare, margin=kept)), first, last)
