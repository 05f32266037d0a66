"""What a plan is made for: start and goal in a domain, and what excludes a way between them."""

from __future__ import annotations

from typing import Protocol

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.domain import Domain
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.plans.space import Space
from gcrules.poses.signs.sign import ConditionSign

__all__ = ["Problem", "margin_kept"]

_WIDEN = "widen it by --within, or leave it out; a pitch stays below 85 degrees, where roll and yaw are one"
_SPARE = 1.03  # times the margin asked for


class Problem(Protocol):
    """From `start` to `goal` in a `domain`: the states `roots` (1 or 2, width) are the start and, where its
    configuration is known, the goal, of which `end` (width,) has the pose.

    `whereto` says in words what the goal is, `notes` what is to be said of any answer.
    """

    @property
    def domain(self) -> Domain: ...
    @property
    def start(self) -> Waypoint: ...
    @property
    def goal(self) -> Waypoint: ...
    @property
    def roots(self) -> Floats: ...
    @property
    def end(self) -> Floats: ...
    @property
    def whereto(self) -> str: ...
    @property
    def notes(self) -> tuple[str, ...]: ...

    def opposed(self) -> tuple[tuple[ConditionSign, ConditionSign], ...]:
        """What has opposite signs at start and goal, in both."""
        ...


def margin_kept(space: Space, ends: Floats, asked: float) -> float:
    """The margin that a search keeps: a little more than what is asked for, so that there is room for rounding and for
    the proof, but not more than start and goal have. Raises InputError where these do not keep to what is asked for.
    """
    least = asked * _SPARE
    for state, name in zip(ends, ("start", "goal"), strict=False):
        if not space.region.holds(space.coordinates(state[None]))[0]:
            raise InputError(f"the {name} lies outside the region: {space.region.text()}", hint=_WIDEN)
        if space.limits is not None and not space.limits.allow(space.reach(state[None]))[0]:
            raise InputError(f"the {name} is not within the limits: {space.limits.text}", hint="widen them")
        sigma = float(space.margins(state[None])[0])
        if sigma < asked:
            raise InputError(
                f"at the {name} the margin is {sigma:.4g}, less than the {asked:.4g} asked for",
                hint="ask for less by --margin",
            )
        least = min(least, sigma)
    return least
