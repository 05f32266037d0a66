"""The widget of `gcrules.view`. It needs anywidget (the extra `widget`)."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot, isfinite
from typing import Any

import anywidget
import traitlets

from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import judged
from gcrules.core.arguments import described
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.pose import pose as report_at
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.views.report.robot_report import robot_scene
from gcrules.views.report.scene_json import Scenery, scene
from gcrules.views.viewer import viewer_script

__all__ = ["RobotWidget"]

HOME = {"translation": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}


def _module() -> str:
    """The bundle of the viewer, a classic script, as the ES module that a notebook loads."""
    return f"{viewer_script()}\nexport default GcrulesViewer.widget;\n"


class RobotWidget(anywidget.AnyWidget):
    """A robot in 3D. `pose` (shift and unit quaternion, scalar first) goes both ways; it may be set as text too.

    `margin` (the singularity margin, 0 singular to 1) and `verdict` (regular | close | singular within rounding) are
    those of the pose, for `observe`; None for a robot with other limbs than six legs, which moves by its actuators.
    """

    _esm = _module()

    scene = traitlets.Dict().tag(sync=True)
    pose = traitlets.Any().tag(sync=True)
    margin = traitlets.Float(None, allow_none=True)
    verdict = traitlets.Unicode(None, allow_none=True)

    def __init__(self, robot: Analysis | RobotAnalysis, pose: Any = None) -> None:
        self._analysis = _on_legs(robot)
        self._scenery = Scenery.of(self._analysis) if self._analysis else None
        shown = robot_scene(robot) if isinstance(robot, RobotAnalysis) else scene(robot)
        super().__init__(scene=shown, pose=HOME if pose is None else pose)

    @traitlets.validate("pose")
    def _posed(self, proposal: Mapping[str, Any]) -> dict[str, list[float]]:
        return _read(proposal["value"], self._scenery.unit if self._scenery else "")

    @traitlets.observe("pose")
    def _moved(self, change: Mapping[str, Any]) -> None:
        if self._scenery is None:
            return
        self.margin, self.verdict = judged(self._scenery.structure, self._scenery.points(change["new"]))

    def numbers(self, **options: Any) -> PoseReport:
        """The report of `gcrules.pose` for the pose that is shown, with its options.

        Raises InputError for a robot without coordinates.
        """
        if self._analysis is None or self._analysis.platform is None:
            raise InputError("numbers are for robots that are given by legs and coordinates")
        t, q = (" ".join(map(repr, self.pose[key])) for key in ("translation", "quaternion"))
        found = report_at(self._analysis, f"{t}; quaternion {q}", **options)
        assert isinstance(found, PoseReport)
        return found


def _on_legs(robot: Analysis | RobotAnalysis) -> Analysis | None:
    """The analysis of six legs, which move; None for other robots."""
    if isinstance(robot, Analysis):
        return robot
    try:
        return mechanism(robot).six_legs().analysis
    except InputError:
        return None


def _read(value: Any, unit: str) -> dict[str, list[float]]:
    """A pose of any form in that of the viewer. Raises InputError for what is none."""
    if isinstance(value, str):
        value = parse_pose(value, unit)
    if isinstance(value, Pose):
        return {"translation": list(map(float, value.translation)), "quaternion": list(value.unit_quaternion)}
    try:
        found = {key: [float(c) for c in value[key]] for key in ("translation", "quaternion")}
    except (TypeError, KeyError, IndexError, ValueError, OverflowError):
        raise InputError(f"{described(value)} is not a pose", hint='write "x=10, z=5, yaw=30deg"') from None
    numbers = [c for cs in found.values() for c in cs]
    size = hypot(*found["quaternion"])
    if len(found["translation"]) != 3 or len(numbers) != 7 or not size or not all(map(isfinite, numbers)):
        raise InputError("a pose has three finite numbers as translation and four, not all 0, as quaternion")
    return {**found, "quaternion": [c / size for c in found["quaternion"]]}
