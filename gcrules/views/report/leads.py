"""What leads the robot of a report's 3D view: along a path, or to poses one by one.

A section's view is made from the scene of the page when it comes into sight; where scripts are off, there is no viewer
or the page is printed, nothing of it is seen.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.methods import has_six_legs
from gcrules.poses.paths.report import PathReport
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import pose_of
from gcrules.views.report.report_page import in_script

__all__ = ["Step", "lead_html", "path_lead", "pose_step"]

_SHOWN = 120  # samples of a path that the view is led through

Step = dict[str, Any]
"""A place that the robot is led to: its `pose`, the amounts of its actuators to `drive` to with the `margin` there, or
a `scene` of its own; and a `text`.
"""


def lead_html(steps: Sequence[Step], about: Iterable[Any], *, along: bool) -> str:
    """A 3D view that goes to steps; `along` adds what plays them one after the other."""
    if not steps:
        return ""
    data = in_script({"about": [float(c) for c in about], "steps": list(steps)})
    name = "Place on the way" if along else "Pose on show"
    play = '<button type="button" class="play">Play</button>' if along else ""
    range_ = f'<input type="range" min="0" max="{len(steps) - 1}" value="0" aria-label="{name}">' if along else ""
    return (
        f'<div class="lead" hidden><div class="stage"></div><div class="tour">{play}{range_}<output></output></div>'
        f'<script type="application/json">{data}</script></div>'
    )


def pose_step(pose: Pose, text: str) -> Step:
    """The step to a pose of a platform on six legs."""
    turn = list(pose.unit_quaternion)
    return {"pose": {"translation": [float(c) for c in pose.translation], "quaternion": turn}, "text": text}


def path_lead(r: PathReport | RobotPath, m: SixLegs | Limbs) -> str:
    """The view that goes along a path."""
    places = np.linspace(0, len(r.parameters) - 1, min(len(r.parameters), _SHOWN)).round().astype(int).tolist()
    if isinstance(r, PathReport):
        return lead_html([_at(r, k) for k in places], r.rig.centre, along=True)
    assert isinstance(m, Limbs)
    if has_six_legs(m):
        poses = [pose_of(dict(zip(r.names, r.coordinates[k].tolist(), strict=True))) for k in places]
        steps = [pose_step(pose, _words(r, k)) for pose, k in zip(poses, places, strict=True)]
    else:  # moved by its actuators
        lead = [r.actuators.index(a) for a in leading(m.linkage)]
        amounts = r.actuator_values[:, lead].tolist()
        steps = [{"drive": amounts[k], "margin": float(r.margins[k]), "text": _words(r, k)} for k in places]
    return lead_html(steps, m.linkage.centre, along=True)


def _at(r: PathReport, k: int) -> Step:
    pose = {"translation": r.translations[k].tolist(), "quaternion": r.quaternions[k].tolist()}
    return {"pose": pose, "text": _words(r, k)}


def _words(r: PathReport | RobotPath, k: int) -> str:
    margins = r.numbers.margin if isinstance(r, PathReport) else r.margins
    return f"parameter {float(r.parameters[k]):.3f}, σ = {float(margins[k]):.4g}"
