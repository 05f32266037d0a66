"""Robots with limbs on the move: their actuators as sliders, and the numbers where these take them."""

from __future__ import annotations

from math import isfinite, log10, radians

import numpy as np

from gcrules.apps.studio.protocol.answer_views import Numbers
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import Axis
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import close_margin
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import superbracket_value
from gcrules.poses.limbs.pose_report import report_of_limbs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.motion import Twist
from gcrules.screws.threshold import DEFAULT
from gcrules.views.results.amplification import conditioning
from gcrules.views.results.singularity_types import in_words
from gcrules.views.robots.limb_views import limb_views
from gcrules.views.scene_data import MotionView

__all__ = ["actuator_axes", "configuration", "motion_view", "numbers_of_limbs", "values_at"]

_TURN, _SHIFT = 30.0, 0.35
"""How far the sliders of actuators reach: degrees, and parts of the robot's size."""


def actuator_axes(limbs: Limbs, size: float) -> list[Axis]:
    """One slider for each actuator, from home; none where the joints cannot be moved."""
    try:
        actuators = limbs.linkage.actuators
    except InputError:
        return []
    step = 10.0 ** round(log10(size) - 2.7)
    return [
        {"name": f"{a.name}, {a.limb}", "unit": "deg", "low": -_TURN, "high": _TURN, "step": 0.1}
        if a.angle
        else {
            "name": f"{a.name}, {a.limb}",
            "unit": limbs.unit,
            "low": -_SHIFT * size,
            "high": _SHIFT * size,
            "step": step,
        }
        for a in actuators
    ]


def configuration(limbs: Limbs, pose: PoseJson, threshold: str | None = None) -> RobotPose:
    """The robot where its actuators have these amounts from home (lengths, degrees); at home where none are given.

    Raises InputError where the robot does not assemble.
    """
    m = limbs.linkage
    given = pose.get("coordinates")
    if given is not None and len(given) != len(m.actuators):
        raise InputError(f"{len(given)} coordinates, and the robot has {len(m.actuators)} actuators")
    amounts = None
    if given and any(given):
        amounts = [radians(v) if a.angle else v for a, v in zip(m.actuators, given, strict=True)]
    return report_of_limbs(limbs, actuators=amounts, threshold=threshold or DEFAULT)


def values_at(subject: Subject, pose: PoseJson) -> dict[str, list[float]]:
    """Coordinates of all points and directions, for which nothing is solved at home. Raises InputError likewise."""
    if subject.limbs is None or not any(pose.get("coordinates", ())):
        return subject.home
    return values_of(subject, configuration(subject.limbs, pose))


def values_of(subject: Subject, found: RobotPose) -> dict[str, list[float]]:
    """Coordinates of all points and directions there, those of the frame among them."""
    return {**subject.home, **{n: list(p) for n, p in found.points.items()}}


def numbers_of_limbs(limbs: Limbs, subject: Subject, pose: PoseJson, threshold: str | None) -> Numbers:
    """The numbers in a configuration. Raises InputError where the robot does not assemble."""
    robot = limbs.analysis
    found = configuration(limbs, pose, threshold)
    values = values_of(subject, found)
    names = subject.points
    near = found.verdict != "regular"
    value = superbracket_value(robot, {n: np.asarray(v) for n, v in values.items()})
    return {
        "pose": pose,
        "points": {n: values[n] for n in names},
        "value": found.margin if value is None else value,
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
            if isfinite(f.value)
        ],
        "constructed": [],
        "motion": motion_view(found.softest, found.centre, subject.unit) if near else None,
        "stress": [limb.share for limb in found.limbs] if near else [],
        "limbs": limb_views(robot, values),
        "notes": [
            *(f"{t.symbol}, {in_words(t)}." for t in found.types),
            f"Actuators: {conditioning(found.jacobian.amplification, subject.unit)}.",
            *found.notes,
            f"Assembly mode: {found.mode}.",
            *([] if found.assembly.doubt is None else [f"Branch: {found.assembly.branch}."]),
        ],
    }


def motion_view(twist: Twist, centre: tuple[float, ...], unit: str) -> MotionView:
    """What the platform can do, to first order, although its actuators are locked; a shift is drawn at the centre."""
    through = twist.point or centre
    words = f"the platform can {twist.text(unit)}"
    return {"axis": list(twist.axis), "through": list(through), "pitch": twist.pitch, "text": words}
