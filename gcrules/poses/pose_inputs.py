r"""What numbers begin with: a mechanism, and the method by which a computation is done for it.

Much is computed for platforms on six legs only, by the exact road of their superbracket. What comes to a robot of
joints whose limbs are six legs takes this road too; for any other the one answer stands here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.six_legs import SixLegs

__all__ = ["on_six_legs", "six_legged"]


def on_six_legs(found: Mechanism, what: str) -> SixLegs:
    """The mechanism as a platform on six legs. Raises InputError where it is none: `what` has no method for it."""
    if isinstance(found, SixLegs):
        return found
    if not isinstance(found, Limbs):
        raise InputError(f"{what} is for platforms on six legs, and {found.title} is none")
    robot = found.robot
    try:
        return SixLegs(as_platform(robot), found.about)
    except InputError as fault:
        raise InputError(
            f"{what} is for platforms on six legs; {fault.message}",
            hint=f'numbers in single configurations: gcrules pose {robot.id} --at "…" (gc.pose); the first singular one'
            f' on a way: gcrules robot pose {robot.id} --at "…" --search (gc.singular)',
        ) from None


def six_legged(source: Source, about: str | Sequence[Any], what: str) -> tuple[Analysis, MovingPlatform]:
    """The analysis, and the platform on six legs as it moves, on which `what` is computed. Raises InputError for legs
    without coordinates, for other mechanisms and for degenerate robots.
    """
    found = on_six_legs(mechanism(source, about=about), what)
    return found.analysis, found.rig
