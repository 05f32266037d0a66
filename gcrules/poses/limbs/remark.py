"""What is to be said of a home configuration that is singular, or nearly so."""

from __future__ import annotations

from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.pose_report import report_of_limbs
from gcrules.poses.limbs.report import RobotPose

__all__ = ["home_remark", "remark"]


def home_remark(analysis: RobotAnalysis) -> str:
    """That home is singular, or nearly so, with cause and motion; nothing of a regular home, of none, or of one that
    cannot be moved.
    """
    if analysis.robot.home is None:
        return ""
    try:
        return remark(report_of_limbs(Limbs.of(analysis)))
    except InputError:
        return ""


def remark(home: RobotPose) -> str:
    """The verdict with its causes and the motion that is gained; nothing of a regular home."""
    if home.verdict == "regular":
        return ""
    causes = home.causes or (home.reason,)
    why = "; ".join(cause[:1].lower() + cause[1:].removesuffix(".") for cause in causes)
    if home.verdict == "close":
        return f"home is close to singular (margin {home.margin:.2g}): {why}"
    if len(home.motions) > 1:
        return f"home is singular: {why}; the platform gains {len(home.motions)} independent motions"
    ways = "".join(f"; the platform can {motion.text()}, which no limb resists" for motion in home.motions)
    return f"home is singular: {why}{ways}"
