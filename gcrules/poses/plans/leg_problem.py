"""A plan for a platform on six legs: exact poses, and paths with a bound of the margin that holds everywhere."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limits import parse_limits
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.poses.path_report import path_of_legs
from gcrules.poses.paths.lengths import keeps_to
from gcrules.poses.paths.segments import segments
from gcrules.poses.plans.leg_space import MOST_TURNED, LegSpace, region_of, row_of
from gcrules.poses.plans.opposed import opposed_legs
from gcrules.poses.plans.problem import Proved, margin_kept
from gcrules.poses.plans.report import OpposedSign, Waypoint
from gcrules.screws.pose import Pose

__all__ = ["LegProblem", "leg_problem"]

_SAMPLES = 100  # of a path


@dataclass(frozen=True, eq=False)
class LegProblem:
    """A `Problem`: poses with a margin `asked` at least."""

    m: SixLegs
    start: Pose
    goal: Pose
    asked: float
    space: LegSpace
    proves_margin: bool = True
    whereto: str = "the goal"

    @property
    def size(self) -> float:
        return self.m.rig.size

    @property
    def roots(self) -> Floats:
        return np.stack([row_of(self.start), row_of(self.goal)])

    @property
    def end(self) -> Floats:
        return np.asarray(self.roots[-1])

    @property
    def notes(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.start.notes, *self.goal.notes)))

    def opposed(self) -> tuple[OpposedSign, ...]:
        return opposed_legs(self.m, self.start, self.goal)

    def prove(self, way: Sequence[Waypoint]) -> Proved:
        poses = [p for p in way if isinstance(p, Pose)]
        path = path_of_legs(self.m, poses, samples=max(_SAMPLES, len(poses) - 1))
        failures = [float(z.lower) for z in path.zeros] + [float(stretch.start) for stretch in path.stretches]
        if path.least.bound < self.asked:
            failures.append(path.least.parameter)
        if (limits := self.space.limits) is not None:
            failures += [k for k, s in enumerate(segments(self.m.rig, poses)) if not keeps_to(limits, s)]
        return Proved.of(path, path.least.bound, failures, len(poses) - 1)

    def waypoint(self, state: Floats, *, rounded: bool) -> Pose:
        return self.space.waypoint(state, rounded=rounded)

    def length(self, way: Sequence[Waypoint]) -> float:
        rows = np.stack([row_of(p) for p in way if isinstance(p, Pose)])
        return float(self.space.lengths(rows[:-1], rows[1:]).sum())


def leg_problem(m: SixLegs, start: Any, goal: Any, asked: float, limits: str | None, within: str | None) -> LegProblem:
    """What is asked for. Raises InputError where start or goal do not keep to it."""
    first, last = (read_one(given, m.unit) for given in (start, goal))
    m.rig.ends(*from_poses([first, last]))  # refuses poses that are too far away, and legs of no length
    reach = None if limits is None else parse_limits(limits, m.actuators, m.unit)
    rows = np.stack([row_of(first), row_of(last)])
    room = np.array([m.rig.size / 2] * 3 + [0.0])
    near = region_of(m.rig)
    region = near.around(LegSpace(m.rig, near, 0.0).coordinates(rows), room).within(within, m.unit)
    region = region.clipped("turn", 0.0, MOST_TURNED)
    kept = margin_kept(LegSpace(m.rig, region, 0.0, reach), rows, asked)
    return LegProblem(m, first, last, asked, LegSpace(m.rig, region, kept, reach))
