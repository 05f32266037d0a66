"""A plan for a robot of joints: configurations on one branch, and paths whose margin is known at samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any

import numpy as np

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.path import path_of_limbs, path_targets
from gcrules.poses.limits import parse_limits
from gcrules.poses.plans.leg_problem import LegProblem, leg_problem
from gcrules.poses.plans.limb_space import LimbSpace
from gcrules.poses.plans.opposed import opposed_limbs
from gcrules.poses.plans.problem import Proved, margin_kept
from gcrules.poses.plans.region import Region
from gcrules.poses.plans.report import OpposedSign, Waypoint
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS
from gcrules.screws.threshold import DEFAULT

__all__ = ["LimbProblem", "limb_problem"]

_SAMPLES = 200  # of a path
_ROOM = 0.5, np.pi / 2  # around home, start and goal: sizes, rad
_STEEPEST = np.radians(85)  # of the pitch, which stays below a right angle
_DOUBT = "that the straight ways from home follow one branch to start and goal is not proved"
_ELSEWHERE = "the straight way from home does not lead to the goal, so it is known by its pose alone"


@dataclass(frozen=True, eq=False)
class LimbProblem:
    """A `Problem`: coordinates of the platform; `configurations` are those of the start and, where the straight way
    from home leads there, of the goal.
    """

    m: Limbs
    start: Waypoint
    goal: Waypoint
    asked: float
    space: LimbSpace
    configurations: tuple[Configuration, ...]
    notes: tuple[str, ...]
    proves_margin: bool = False
    whereto: str = "the configuration at the goal to which the straight way from home leads"

    @property
    def size(self) -> float:
        return self.m.linkage.size

    @property
    def roots(self) -> Floats:
        return np.stack([self.space.row_of(c) for c in self.configurations])

    @property
    def end(self) -> Floats:
        return self._row(self.goal)

    def opposed(self) -> tuple[OpposedSign, ...]:
        return opposed_limbs(self.m, *self.configurations) if len(self.configurations) > 1 else ()

    def prove(self, way: Sequence[Waypoint]) -> Proved:
        path = path_of_limbs(self.m, list(way), samples=max(_SAMPLES, len(way) - 1), threshold=DEFAULT)
        least, at = path.least
        failures = [c.first for c in path.crossings] + [a for a, _ in path.undecided]
        failures += path.parameters[path.verdicts == "singular"].tolist()
        if least < self.asked:
            failures.append(at)
        if path.branch_doubt is not None:
            failures.append(path.branch_doubt)
        if self.space.limits is not None:
            failures += path.parameters[~self.space.limits.allow(path.actuator_values)].tolist()
        return Proved.of(path, least, failures, len(way) - 1)

    def waypoint(self, state: Floats, *, rounded: bool) -> Waypoint:
        return self.space.waypoint(state, rounded=rounded)

    def length(self, way: Sequence[Waypoint]) -> float:
        rows = np.stack([self._row(p) for p in way])
        return float(self.space.lengths(rows[:-1], rows[1:]).sum())

    def _row(self, pose: Waypoint) -> Floats:
        assert isinstance(pose, Mapping)
        width = sum(map(len, self.configurations[0].joint_values))
        return np.concatenate([[pose[n] for n in self.space.names], np.zeros(width)])


def limb_problem(
    m: Limbs, start: Any, goal: Any, asked: float, limits: str | None, within: str | None
) -> LimbProblem | LegProblem:
    """What is asked for; of a robot whose limbs are six legs by its platform. Raises InputError where start or goal do
    not keep to it.
    """
    try:
        legs = m.six_legs()
    except InputError:
        pass
    else:
        return leg_problem(legs, start, goal, asked, limits, within)
    k = m.linkage
    first, last = path_targets(k, [start, goal])
    found = [solve(k, first)]
    check_target(k, last)
    try:
        found.append(solve(k, last))
    except InputError:
        if last.whole is not None:
            raise
    notes = list(k.notes)
    if len(found) < 2:
        notes.append(_ELSEWHERE)
    elif any(one.doubt is not None for one in found):
        notes.append(_DOUBT)
    configurations = tuple(one.configuration for one in found)
    names = first.names if first.whole is None else (*SHIFTS, *TURNS)
    poses = [_pose(k, names, t, c) for t, c in zip_longest((first, last), configurations)]
    region = _region(k, names, poses).within(within, m.unit).clipped("pitch", -_STEEPEST, _STEEPEST)
    kinds = {a.name: a.angle for a in k.actuators}
    reach = None if limits is None else parse_limits(limits, tuple(kinds), m.unit, tuple(kinds.values()))
    bare = LimbSpace(m, names, region, 0.0, reach)
    kept = margin_kept(bare, np.stack([bare.row_of(c) for c in configurations]), asked)
    space = LimbSpace(m, names, region, kept, reach)
    return LimbProblem(m, poses[0], poses[1], asked, space, configurations, tuple(notes))


def _pose(m: Linkage, names: Sequence[str], given: Target, c: Configuration | None) -> Mapping[str, float]:
    """The coordinates as they are given, or of a whole pose those of its configuration."""
    if given.whole is None:
        return FrozenMap(zip(given.names, given.values.tolist(), strict=True))
    assert c is not None
    place = without_rounding(names, coordinates(names, c.platform[None], m.centre)[0], m.size)
    return FrozenMap(zip(names, map(float, place), strict=True))


def _region(m: Linkage, names: tuple[str, ...], poses: Sequence[Mapping[str, float]]) -> Region:
    """Around home, start and goal."""
    angles = tuple(n in ANGLES for n in names)
    room = np.array([_ROOM[1] if a else _ROOM[0] * m.size for a in angles])
    zero = (0.0,) * len(names)
    return Region(names, zero, zero, angles).around(np.array([[p[n] for n in names] for p in poses]), room)
