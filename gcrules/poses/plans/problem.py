"""What a plan is made for, of any kind of mechanism: states, start and goal, what excludes a way, what proves one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.report import OpposedSign, Waypoint
from gcrules.poses.plans.space import Space

__all__ = ["Problem", "Proved", "margin_kept"]

_SPARE = 1.03  # times the margin asked for


@dataclass(frozen=True)
class Proved:
    """What is proved of a path: its `least` margin, and the places of the segments that do not keep to what is asked
    for, or are not proved to do so.
    """

    path: PathReport | RobotPath
    least: float
    failures: tuple[int, ...]

    @classmethod
    def of(cls, path: PathReport | RobotPath, least: float, places: Iterable[float], pieces: int) -> Proved:
        """With failures at these parameters of a path of so many segments."""
        return cls(path, least, tuple(sorted({min(int(p), pieces - 1) for p in places})))


class Problem(Protocol):
    """From `start` to `goal` of a mechanism `m`, whose `size` makes lengths numbers: the states `roots` (1 or 2, width)
    are the start and, where its configuration is known, the goal, of which `end` (width,) has the pose.

    `whereto` says in words what the goal is; `proves_margin` tells whether the margin of a path is proved between
    samples, `notes` what is to be said of any answer.
    """

    @property
    def m(self) -> Mechanism: ...
    @property
    def size(self) -> float: ...
    @property
    def start(self) -> Waypoint: ...
    @property
    def goal(self) -> Waypoint: ...
    @property
    def space(self) -> Space: ...
    @property
    def roots(self) -> Floats: ...
    @property
    def end(self) -> Floats: ...
    @property
    def whereto(self) -> str: ...
    @property
    def proves_margin(self) -> bool: ...
    @property
    def notes(self) -> tuple[str, ...]: ...

    def opposed(self) -> tuple[OpposedSign, ...]:
        """What has opposite signs at start and goal."""
        ...

    def prove(self, way: Sequence[Waypoint]) -> Proved:
        """The path straight through waypoints, and what is proved of it."""
        ...

    def waypoint(self, state: Floats, *, rounded: bool) -> Waypoint:
        """The pose of a state; rounded it has few digits."""
        ...

    def length(self, way: Sequence[Waypoint]) -> float:
        """How long the way straight through waypoints is."""
        ...


def margin_kept(space: Space, ends: Floats, asked: float) -> float:
    """The margin that a search keeps: a little more than what is asked for, so that there is room for rounding and for
    the proof, but not more than start and goal have. Raises InputError where these do not keep to what is asked for.
    """
    least = asked * _SPARE
    for state, name in zip(ends, ("start", "goal"), strict=False):
        if not space.region.holds(space.coordinates(state[None]))[0]:
            raise InputError(f"the {name} lies outside of the region", hint="widen it by --within, or leave it out")
        if space.limits is not None and not space.limits.allow(space.reach(state[None]))[0]:
            raise InputError(f"the {name} does not keep to the limits: {space.limits.text}", hint="widen them")
        sigma = float(space.margins(state[None])[0])
        if sigma < asked:
            raise InputError(
                f"at the {name} the margin is {sigma:.4g}, less than the {asked:.4g} asked for",
                hint="ask for less by --margin",
            )
        least = min(least, sigma)
    return least
