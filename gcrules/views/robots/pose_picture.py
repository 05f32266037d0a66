"""A mechanism of any kind in a pose, small and without words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.pose_report import report_of_limbs
from gcrules.poses.limbs.report import RobotPose
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import Vector
from gcrules.views.drawing.drawing import Drawing, scaled, without_text
from gcrules.views.drawing.figures import robot_figure
from gcrules.views.robots.robot_drawing import robot_thumbnail

__all__ = ["pose_picture", "waypoint_picture"]

_SCALE = 0.3
_SAME = 1e-6


def pose_picture(m: SixLegs | Limbs, at: Pose | RobotPose, title: str = "") -> Drawing:
    """The mechanism at a pose; a robot of joints in a configuration, or, if its limbs are six legs, at a pose too."""
    analysis = m.analysis
    if isinstance(at, RobotPose):
        assert isinstance(analysis, RobotAnalysis)
        places = {n: _exact(p) for n, p in at.points.items()}
        drawn = robot_thumbnail(analysis, {**analysis.robot.values_at(), **places})  # the frame's directions stay
    else:
        legs = m.six_legs()
        assert isinstance(legs.analysis, Analysis)
        joints = {n: p[:3] for n, p in legs.rig.exact(at).items()}
        drawn = scaled(without_text(robot_figure(legs.analysis, joints, key=False)), _SCALE)
    return replace(drawn, title=title) if title else drawn


def waypoint_picture(m: SixLegs | Limbs, at: Pose | Mapping[str, float], margin: float, title: str) -> Drawing | None:
    """The mechanism at a pose that a result tells, with its margin. Of a robot of joints the picture is that of the
    configuration that is reached from home; None where it has another margin, and so is another one.
    """
    if isinstance(at, Pose):
        return pose_picture(m, at, title)
    assert isinstance(m, Limbs)
    try:
        found = report_of_limbs(m, dict(at))
    except InputError:
        return None
    return pose_picture(m, found, title) if abs(found.margin - margin) <= _SAME else None


def _exact(place: tuple[float, ...]) -> Vector:
    x, y, z = map(Fraction, place)
    return x, y, z
