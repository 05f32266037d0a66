"""A plan for a robot of joints: configurations on one branch, and paths whose margin is known at samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.path import path_of_limbs
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.maps.limits import parse_limits
from gcrules.poses.plans.leg_problem import LegProblem, leg_problem
from gcrules.poses.plans.limb_space import LimbSpace
from gcrules.poses.plans.opposed import opposed_limbs
from gcrules.poses.plans.problem import Proved, margin_kept
from gcrules.poses.plans.region import Region
from gcrules.poses.plans.report import OpposedSign, Waypoint
from gcrules.screws.pose_text import ANGLES, HOME, SHIFTS, TURNS
from gcrules.screws.threshold import DEFAULT

__all__ = ["LimbProblem", "limb_problem"]

_SAMPLES = 200  # of a path
_ROOM = 0.5, np.pi / 2  # around home, start and goal: sizes, rad
_STEEPEST = np.radians(85)  # of the pitch, which stays below a right angle
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
    proves_margin: bool = False

    @property
    def title(self) -> str:
        return self.m.title

    @property
    def unit(self) -> str:
        return self.m.unit

    @property
    def size(self) -> float:
        return self.m.linkage.size

    @property
    def roots(self) -> Floats:
        return np.stack([self.space.row_of(c) for c in self.configurations])

    @property
    def end(self) -> Floats:
        return self._row(self.goal)

    @property
    def region(self) -> str:
        return self.space.region.text(self.unit)

    @property
    def limits(self) -> str:
        return self.space.limits.text if self.space.limits else ""

    @property
    def notes(self) -> tuple[str, ...]:
        return (*self.m.linkage.notes, *([_ELSEWHERE] if len(self.configurations) < 2 else []))

    def opposed(self) -> tuple[OpposedSign, ...]:
        return opposed_limbs(self.m, *self.configurations) if len(self.configurations) > 1 else ()

    def prove(self, way: Sequence[Waypoint]) -> Proved:
        path = path_of_limbs(self.m, list(way), samples=max(_SAMPLES, len(way) - 1), threshold=DEFAULT)
        least, at = path.least
        failures = {int(c.first) for c in path.crossings} | {int(a) for a, _ in path.undecided}
        if least < self.asked:
            failures.add(int(at))
        if path.branch_doubt is not None:
            failures.add(int(path.branch_doubt))
        if self.space.limits is not None:
            failures |= set(path.parameters[~self.space.limits.allow(path.actuator_values)].astype(int).tolist())
        last = len(way) - 2
        return Proved(path, least, tuple(sorted({min(k, last) for k in failures})))

    def waypoint(self, state: Floats, *, rounded: bool) -> Waypoint:
        return self.space.waypoint(state, rounded=rounded)

    def length(self, way: Sequence[Waypoint]) -> float:
        rows = np.stack([self._row(p) for p in way])
        return float(self.space.lengths(rows[:-1], rows[1:]).sum())

    def _row(self, pose: Waypoint) -> Floats:
        assert isinstance(pose, Mapping)
        places = len(self.configurations[0].joint_values)
        width = sum(len(self.configurations[0].joint_values[k]) for k in range(places))
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
    targets = [_target(k, given) for given in (start, goal)]
    names = _names(k, targets)
    first = k.home if targets[0] is None else solve(k, targets[0]).configuration
    found = [first]
    try:
        found.append(k.home if targets[1] is None else solve(k, targets[1]).configuration)
    except InputError:
        if targets[1] is None or targets[1].whole is not None:
            raise
    poses = [_pose(k, names, t, found[n] if n < len(found) else None) for n, t in enumerate(targets)]
    region = _region(k, names, poses).within(within, m.unit)
    kinds = {a.name: a.angle for a in k.actuators}
    reach = None if limits is None else parse_limits(limits, tuple(kinds), m.unit, tuple(kinds.values()))
    bare = LimbSpace(m, names, region, 0.0, reach)
    kept = margin_kept(bare, np.stack([bare.row_of(c) for c in found]), asked)
    return LimbProblem(m, poses[0], poses[1], asked, LimbSpace(m, names, region, kept, reach), tuple(found))


def _target(m: Linkage, given: Any) -> Target | None:
    home = isinstance(given, str) and given.strip().lower() == HOME
    return None if home else target_of(m, given, None)


def _names(m: Linkage, targets: Sequence[Target | None]) -> tuple[str, ...]:
    """The coordinates that start and goal name, or those that are free near home. Raises InputError."""
    given = [t.names for t in targets if t is not None and t.whole is None]
    if m.robot.mobility == len(SHIFTS) + len(TURNS):
        return (*SHIFTS, *TURNS)
    if len(given) > 1 and set(given[0]) != set(given[1]):
        raise InputError(
            f"the start gives {', '.join(given[0])}, the goal {', '.join(given[1])}",
            hint="both name the same coordinates",
        )
    return given[0] if given else free_coordinates(m)


def _pose(m: Linkage, names: Sequence[str], given: Target | None, c: Configuration | None) -> Mapping[str, float]:
    """The coordinates as they are given, or those of the configuration."""
    if given is None:
        return FrozenMap(dict.fromkeys(names, 0.0))
    if given.whole is None:
        values = dict(zip(given.names, given.values.tolist(), strict=True))
        return FrozenMap({n: values[n] for n in names})
    assert c is not None  # of a whole pose it is known
    place = without_rounding(names, coordinates(names, c.platform[None], m.centre)[0], m.size)
    return FrozenMap(zip(names, map(float, place), strict=True))


def _region(m: Linkage, names: tuple[str, ...], poses: Sequence[Mapping[str, float]]) -> Region:
    """Around home, start and goal."""
    angles = tuple(n in ANGLES for n in names)
    room = np.array([_ROOM[1] if a else _ROOM[0] * m.size for a in angles])
    zero = (0.0,) * len(names)
    region = Region(names, zero, zero, angles).around(np.array([[p[n] for n in names] for p in poses]), room)
    steep = [n == "pitch" for n in names]
    low = tuple(max(v, -_STEEPEST) if s else v for v, s in zip(region.low, steep, strict=True))
    high = tuple(min(v, _STEEPEST) if s else v for v, s in zip(region.high, steep, strict=True))
    return Region(names, low, high, angles)
