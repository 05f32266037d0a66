"""Poses of a platform on six legs: exact ones, and paths with a bound of the margin that holds everywhere."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.mechanism import limits_of
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.modes.report import AssemblyMode
from gcrules.poses.path_report import path_of_legs
from gcrules.poses.paths.lengths import keeps_to
from gcrules.poses.paths.report import PathReport
from gcrules.poses.paths.segments import segments
from gcrules.poses.plans.domain import Place, Proved, outside, samples_of
from gcrules.poses.plans.leg_space import MOST_TURNED, LegSpace, region_of, row_of
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.signs.of_legs import signs_of_legs
from gcrules.poses.signs.sign import ConditionSign
from gcrules.screws.pose import Pose

__all__ = ["LegDomain", "leg_space"]

_SAMPLES = 100  # of a path
_ROOM = 0.5  # sizes: around the poses that are to lie in the region


@dataclass(frozen=True, eq=False)
class LegDomain:
    """A `Domain`: poses with a margin `asked` at least."""

    m: SixLegs
    asked: float
    space: LegSpace
    notes: tuple[str, ...] = ()

    @property
    def size(self) -> float:
        return self.m.rig.size

    def prove(self, way: Sequence[Waypoint], samples: int | None = None) -> Proved:
        poses = [p for p in way if isinstance(p, Pose)]
        path = path_of_legs(self.m, poses, samples=samples_of(_SAMPLES, samples, len(poses) - 1), asked=self.asked)
        failures = [float(z.lower) for z in path.zeros] + [float(stretch.start) for stretch in path.stretches]
        if (limits := self.space.limits) is not None:
            failures += [k for k, s in enumerate(segments(self.m.rig, poses)) if not keeps_to(limits, s)]
        failures += outside(self.space, np.stack([row_of(p) for p in poses]))
        return Proved.of(path, self.asked, len(poses) - 1, failures, [path.least.parameter])

    def waypoint(self, state: Floats, *, rounded: bool) -> Pose:
        return self.space.waypoint(state, rounded=rounded)

    def continued(self, way: Sequence[Waypoint]) -> list[Waypoint]:
        return list(way)

    def length(self, way: Sequence[Waypoint]) -> float:
        rows = np.stack([row_of(p) for p in way if isinstance(p, Pose)])
        return float(self.space.lengths(rows[:-1], rows[1:]).sum())

    def home(self) -> Place:
        return Place(Pose(), row_of(Pose()))

    def places(self, states: Floats) -> list[Place]:
        poses = [self.waypoint(row, rounded=True) for row in states]
        if not poses:
            return []
        rows = np.stack([row_of(p) for p in poses])
        good = self.space.good(rows)
        return [Place(p, row) for p, row, kept in zip(poses, rows, good.tolist(), strict=True) if kept]

    def place_of(self, mode: AssemblyMode) -> Place | str:
        return Place(mode.pose, row_of(mode.pose))

    def ends_at(self, path: PathReport | RobotPath, place: Place) -> bool:
        return True

    def signs(self, place: Place) -> tuple[ConditionSign, ...]:
        assert isinstance(place.pose, Pose)
        return signs_of_legs(self.m, place.pose)


def leg_space(m: SixLegs, rows: Floats, margin: float, limits: str | None, within: str | None) -> LegSpace:
    """The states around home and around others (N, width) that keep to what is asked for. Raises InputError."""
    reach = limits_of(m, limits)
    near = region_of(m.rig)
    room = np.array([m.rig.size * _ROOM] * 3 + [0.0])
    region = near.around(LegSpace(m.rig, near, 0.0).coordinates(rows), room).within(within, m.unit)
    return LegSpace(m.rig, region.clipped("turn", 0.0, MOST_TURNED), margin, reach)
