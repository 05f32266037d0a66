"""The working modes of a robot with limbs, for the page."""

from __future__ import annotations

from gcrules.apps.studio.protocol.answer_views import ModesAnswer, ModeView
from gcrules.apps.studio.subject import Subject, robot_of
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.core.budget import report
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.modes.working import WorkingMode, WorkingModes, working_modes
from gcrules.views.results.working_modes import amounts, ways
from gcrules.views.robots.pose_picture import pose_picture

__all__ = ["modes_view"]


def modes_view(subject: Subject, limit: str | None) -> ModesAnswer:
    """All modes of the robot whose home the file gives, whatever mode is open. Raises InputError for platforms."""
    if subject.robot is None:
        raise InputError("a platform on six legs has one working mode")
    report("finding the ways of each limb")
    home = Limbs.of(robot_of(subject.source))
    found = working_modes(home.analysis, threshold=threshold_of(limit, ""))
    modes = [_view(found, mode, home) for mode in found.modes]
    return {"modes": modes, "number": found.number, "ways": list(ways(found))}


def _view(found: WorkingModes, mode: WorkingMode, limbs: Limbs) -> ModeView:
    return {
        "name": mode.name,
        "verdict": mode.pose.verdict if mode.pose else None,
        "margin": mode.pose.margin if mode.pose else None,
        "signs": mode.signs,
        "svg": pose_picture(limbs, mode.pose).svg() if mode.pose else "",
        "drives": ", ".join(f"{a.name} {v}" for a, v in zip(found.actuators, amounts(found, mode), strict=True)),
    }
