"""Configurations of a robot of joints on one branch, and paths with a bound of the margin where that is proved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.coordinates import principal, wrapped
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import limits_of
from gcrules.poses.limbs.path import path_of_limbs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.modes.report import AssemblyMode
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.domain import Place, Proved, outside, samples_of
from gcrules.poses.plans.limb_space import LimbSpace
from gcrules.poses.plans.region import Region
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.signs.of_limbs import signs_of_limbs
from gcrules.poses.signs.sign import ConditionSign
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.threshold import DEFAULT

__all__ = ["STEEPEST", "LimbDomain", "limb_space"]

_SAMPLES = 200  # of a path
STEEPEST = np.radians(85)
"""Of the pitch, which stays below a right angle."""

_ROOM = 0.5, np.pi / 2  # around home and others: sizes, rad
_ALIKE = 1e-6  # of actuators and coordinates: sizes, rad
_ELSEWHERE = "the straight way from home does not lead there"
_ANOTHER = "the straight way from home leads to another configuration at its pose"


@dataclass(frozen=True, eq=False)
class LimbDomain:
    """A `Domain`: configurations to which ways from home lead, with a margin `asked` at least."""

    m: Limbs
    asked: float
    space: LimbSpace

    @property
    def notes(self) -> tuple[str, ...]:
        return tuple(self.m.linkage.notes)

    @property
    def size(self) -> float:
        return self.m.linkage.size

    def prove(self, way: Sequence[Waypoint], samples: int | None = None) -> Proved:
        path = path_of_limbs(
            self.m,
            list(way),
            samples=samples_of(_SAMPLES, samples, len(way) - 1),
            threshold=DEFAULT,
            asked=self.asked,
        )
        failures = [c.first for c in path.crossings] + [a for a, _ in path.undecided]
        failures += path.parameters[path.verdicts == "singular"].tolist()
        if path.branch_doubt is not None:
            failures.append(path.branch_doubt)
        kept, limits = True, self.space.limits
        if limits is not None:
            failures += path.parameters[~limits.allow(path.actuator_values)].tolist()
            kept = bool(limits.allow(path.actuator_ranges.T).all())
        failures += outside(self.space, np.stack([self.unsolved(p) for p in way]))
        doubts = np.flatnonzero(path.segment_bounds < self.asked).tolist()
        return Proved.of(path, self.asked, len(way) - 1, failures, doubts, limits_proved=kept)

    def waypoint(self, state: Floats, *, rounded: bool) -> Waypoint:
        return self.space.waypoint(state, rounded=rounded)

    def continued(self, way: Sequence[Waypoint]) -> list[Waypoint]:
        names, found = self.space.names, list(way[:1])
        for pose in way[1:]:
            last = self.unsolved(found[-1])[: len(names)]
            change = self.unsolved(pose)[: len(names)] - last
            turned = np.abs(wrapped(names, change) - change) > 1.0
            values = np.where(turned, last + wrapped(names, change), last + change)
            found.append(FrozenMap(zip(names, values.tolist(), strict=True)) if turned.any() else pose)
        return found

    def length(self, way: Sequence[Waypoint]) -> float:
        rows = np.stack([self.unsolved(p) for p in way])
        return float(self.space.lengths(rows[:-1], rows[1:]).sum())

    def unsolved(self, pose: Waypoint) -> Floats:
        """The state of a pose whose joints are not known."""
        assert isinstance(pose, Mapping)
        return np.concatenate([[pose[n] for n in self.space.names], np.zeros(self.space.joints)])

    def home(self) -> Place:
        zero = np.zeros(len(self.space.names) + self.space.joints)
        return Place(FrozenMap(dict.fromkeys(self.space.names, 0.0)), zero)

    def places(self, states: Floats) -> list[Place]:
        poses = [self.waypoint(row, rounded=True) for row in states]
        if not poses:
            return []
        rows, reached = self.space.from_home(np.stack([self.unsolved(p)[: len(self.space.names)] for p in poses]))
        good = np.zeros(len(rows), dtype=bool)
        good[reached] = self.space.at(rows[reached]).sound & self.space.good(rows[reached])
        return [Place(p, row) for p, row, kept in zip(poses, rows, good.tolist(), strict=True) if kept]

    def place_of(self, mode: AssemblyMode) -> Place | str:
        names = self.space.names
        pose = FrozenMap((n, mode.coordinates[n]) for n in names)
        rows, reached = self.space.from_home(self.unsolved(pose)[None, : len(names)])
        if not reached[0]:
            return _ELSEWHERE
        there, every = self.space.at(rows), tuple(mode.coordinates)
        apart = wrapped(every, there.coordinates[0] - np.array([*mode.coordinates.values()]))
        units = np.array([1.0 if n in ANGLES else self.size for n in every])
        same = self.reach_alike(there.actuators[0], np.array([v for _, v in mode.actuators]))
        return Place(pose, rows[0]) if same and (np.abs(apart) <= _ALIKE * units).all() else _ANOTHER

    def ends_at(self, path: PathReport | RobotPath, place: Place) -> bool:
        assert isinstance(path, RobotPath)
        return self.reach_alike(path.actuator_values[-1], self.space.reach(place.row[None])[0])

    def reach_alike(self, one: Floats, other: Floats) -> bool:
        """Whether amounts of the actuators are the same, turns up to whole ones."""
        angle = np.array([a.angle for a in self.m.linkage.actuators])
        apart = np.where(angle, principal(one - other), one - other)
        return bool((np.abs(apart) <= _ALIKE * np.where(angle, 1.0, self.size)).all())

    def signs(self, place: Place) -> tuple[ConditionSign, ...]:
        return signs_of_limbs(self.m, self.space.at(place.row[None]))


def limb_space(
    m: Limbs,
    names: tuple[str, ...],
    poses: Sequence[Mapping[str, float]],
    margin: float,
    limits: str | None,
    within: str | None,
) -> LimbSpace:
    """The states around home and around poses that keep to what is asked for. Raises InputError."""
    k = m.linkage
    angles = tuple(n in ANGLES for n in names)
    room = np.array([_ROOM[1] if a else _ROOM[0] * k.size for a in angles])
    zero = (0.0,) * len(names)
    places = np.array([list(zero), *([p[n] for n in names] for p in poses)])
    region = Region(names, zero, zero, angles).around(places, room)
    region = region.within(within, m.unit).clipped("pitch", -STEEPEST, STEEPEST)
    return LimbSpace(m, names, region, margin, limits_of(m, limits))
