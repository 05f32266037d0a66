r"""That there is no way, with all that another program needs to see it again: `check_plan.py` reads this.

>>> from gcrules.poses.plans.plan import plan
>>> points = {"a": (0, 0, 0), "b": (4, 0, 0), "c": (2, 3, 0), "d": (1, 1, 2), "e": (3, 1, 2), "f": (2, 2, 2)}
>>> robot = {"legs": "ad ae be bf cf cd", "points": points}
>>> plan_certificate(plan(robot, "home", "0 0 -4"))["signs"]
{'start': -1, 'goal': 1}
"""

from __future__ import annotations

from typing import Any, Protocol

from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.certificate_files import platform_parts, pose_parts, signed
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.screws.pose import Pose

__all__ = ["FORMAT", "plan_certificate"]

FORMAT = "gcrules plan certificate 1"


class _Plan(Protocol):
    """A `Plan`, as far as it is needed here."""

    @property
    def title(self) -> str: ...
    @property
    def outcome(self) -> str: ...
    @property
    def mechanism(self) -> Mechanism: ...
    @property
    def start(self) -> Any: ...
    @property
    def goal(self) -> Any: ...


def plan_certificate(p: _Plan) -> dict[str, Any]:
    """The platform, both poses, and the signs of the determinant of its wrenches there. Raises InputError for a plan
    that is not a proof that there is no way, LimitReached for one of another robot than a platform on six legs, and
    where the determinant itself has the same sign at both ends.
    """
    if p.outcome != "none":
        raise InputError(
            "this plan has no certificate: only that there is no way has one",
            hint="the proof of a way is that of gcrules path",
        )
    if not isinstance(p.mechanism, SixLegs):
        raise LimitReached(
            f"that there is no way of {p.title} has no certificate: its signs are computed in floats",
            hint="there is one for platforms on six legs",
        )
    poses = {"start": p.start, "goal": p.goal}
    signs = {end: _sign(p.mechanism, pose) for end, pose in poses.items()}
    if signs["start"] * signs["goal"] >= 0:
        raise LimitReached(
            "that there is no way has no certificate here: factors of the condition have opposite signs, and their"
            " product has not",
            hint="gcrules analyze --certificate proves that the factors are those of the condition",
        )
    ends = {end: pose_parts(pose) for end, pose in poses.items()}
    return signed(FORMAT, p.title, **platform_parts(p.mechanism.rig), poses=ends, signs=signs)


def _sign(m: SixLegs, pose: Pose) -> int:
    """That of the determinant of the rows (f, m), f from the base to the platform: the superbracket's, turned round."""
    value = superbracket_at(m.rig.legs, m.rig.exact(pose))
    return (value < 0) - (value > 0)
