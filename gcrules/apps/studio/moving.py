"""Robots with limbs on the move: their actuators as sliders, and the numbers where these take them."""

from __future__ import annotations

from math import log10, radians

import numpy as np

from gcrules.apps.studio.protocol.answer_views import Numbers
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import Axis
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import close_margin
from gcrules.core.errors import InputError
from gcrules.poses.limbs.pose_report import report_at
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.extensors import coordinates
from gcrules.poses.numbers.motion import Twist
from gcrules.screws.threshold import DEFAULT
from gcrules.views.robots.limb_views import Values, all_places, directions, limb_views
from gcrules.views.scene_data import MotionView

__all__ = ["actuator_axes", "configuration", "motion_view", "robot_numbers", "values_at"]

_TURN, _SHIFT = 30.0, 0.35
"""How far the sliders of actuators reach: degrees, and parts of the robot's size."""


def actuator_axes(subject: Subject) -> list[Axis]:
    """One slider for each actuator, from home; none where the joints cannot be moved."""
    assert subject.robot is not None
    try:
        actuators = subject.linkage.actuators
    except InputError:
        return []
    size = subject.size
    step = 10.0 ** round(log10(size) - 2.7)
    return [
        {"name": f"{a.name}, {a.limb}", "unit": "deg", "low": -_TURN, "high": _TURN, "step": 0.1}
        if a.angle
        else {
            "name": f"{a.name}, {a.limb}",
            "unit": subject.unit,
            "low": -_SHIFT * size,
            "high": _SHIFT * size,
            "step": step,
        }
        for a in actuators
    ]


def configuration(subject: Subject, pose: PoseJson, threshold: str | None = None) -> RobotPose:
    """The robot where its actuators have these amounts from home (lengths, degrees); at home where none are given.

    Raises InputError where the robot does not assemble.
    """
    robot, m = subject.robot, subject.linkage
    assert robot is not None
    given = pose.get("coordinates")
    if given is not None and len(given) != len(m.actuators):
        raise InputError(f"{len(given)} coordinates, and the robot has {len(m.actuators)} actuators")
    amounts = None
    if given and any(given):
        amounts = [radians(v) if a.angle else v for a, v in zip(m.actuators, given, strict=True)]
    return report_at(m, lambda: robot, None, amounts, threshold=threshold or DEFAULT)


def values_at(subject: Subject, pose: PoseJson) -> dict[str, list[float]]:
    """Coordinates of all points and directions, for which nothing is solved at home. Raises InputError likewise."""
    return values_of(subject, configuration(subject, pose)) if any(pose.get("coordinates", ())) else subject.home


def values_of(subject: Subject, found: RobotPose) -> dict[str, list[float]]:
    """Coordinates of all points and directions there, those of the frame among them."""
    return {**subject.home, **{n: list(p) for n, p in found.points.items()}}


def robot_numbers(subject: Subject, pose: PoseJson, threshold: str | None) -> Numbers:
    """The numbers in a configuration. Raises InputError where the robot does not assemble."""
    robot = subject.robot
    assert robot is not None
    found = configuration(subject, pose, threshold)
    values = values_of(subject, found)
    names = subject.points
    near = found.verdict != "regular"
    return {
        "pose": pose,
        "points": {n: values[n] for n in names},
        "value": _value(subject, values, found.margin),
        "margin": found.margin,
        "close": close_margin(found.threshold),
        "verdict": found.verdict,
        "reason": found.reason,
        "causes": list(found.causes),
        "readings": [
            {
                "part": f.expression,
                "name": "normalised value",
                "meaning": f.statement or f"a factor of the condition ({f.kind})",
                "value": f.value,
                "unit": "",
                "why": "",
            }
            for f in found.factors
        ],
        "constructed": [],
        "motion": motion_view(found.softest, found.centre, subject.unit) if near else None,
        "stress": [limb.share for limb in found.limbs] if near else [],
        "limbs": limb_views(robot, values),
        "notes": [*found.notes, f"Assembly mode: {found.mode}."],
    }


def _value(subject: Subject, values: Values, margin: float) -> float:
    """The superbracket of the equivalent lines by the lengths of their coordinates, with its sign, the points at unit
    scale about their centroid and directions of length 1; the margin where there are no lines.
    """
    robot, a = subject.robot, subject.analysis
    if robot is None or a is None:
        return margin
    far, all_of = directions(robot), all_places(robot, values)
    finite = np.array([all_of[n] for n in a.structure.names if n not in far])
    centre = finite.mean(axis=0)
    size = float(np.sqrt(((finite - centre) ** 2).sum(axis=1).mean())) or 1.0
    keep = [0, 1, 3] if robot.robot.family.plane else [0, 1, 2, 3]
    at = {}
    for n in a.structure.names:
        v = all_of[n]
        row = [*(v / (np.linalg.norm(v) or 1.0)), 0.0] if n in far else [*((v - centre) / size), 1.0]
        at[n] = np.array([row])[:, keep]
    found = float(coordinates(a.structure.superbracket, at)[0, 0])
    for line in a.structure.lines:
        found /= float(np.linalg.norm(coordinates(line, at))) or 1.0
    return found


def motion_view(twist: Twist, centre: tuple[float, ...], unit: str) -> MotionView:
    """What the platform can do, to first order, although its actuators are locked; a shift is drawn at the centre."""
    through = twist.point or centre
    words = f"the platform can {twist.text(unit)}"
    return {"axis": list(twist.axis), "through": list(through), "pitch": twist.pitch, "text": words}
