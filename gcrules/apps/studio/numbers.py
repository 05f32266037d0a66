"""The numbers at a pose, quickly: what a slider asks for many times a second.

Floats throughout; the exact superbracket is computed only where it may be zero. What is slow (the nearest singular
pose) has a request of its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.evaluate import evaluate
from gcrules.apps.studio.moving import motion_view, robot_numbers
from gcrules.apps.studio.protocol.answer_views import Along, Numbers, ReadingView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import close_margin, threshold_of
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import judged, line_measure
from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import FAR, MovingPlatform
from gcrules.poses.nearest.poses import nearest_translation
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.causes import causes, near_causes, nearest_cause
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.poses.numbers.incidence_measures import readings
from gcrules.poses.numbers.many import homogeneous, scaled_superbracket
from gcrules.poses.numbers.many import numbers as numbers_of
from gcrules.poses.numbers.motion import scaled, softest_twist
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.poses.numbers.reason import verdict
from gcrules.rules.condition import Condition
from gcrules.screws.guarantees import ROUNDING, guarantees, noise
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import DEFAULT, Threshold
from gcrules.screws.verdict import CLOSE
from gcrules.views.robots.limb_views import limb_views

__all__ = ["arrays", "exact_pose", "margins", "numbers"]

Floats = NDArray[np.float64]

_READ = 3
"""Conditions of which readings are taken: those with the smallest cofactors stand first, and each takes a while."""

_MAY_BE_ZERO = 1e-7
"""Below this measure the exact superbracket is computed."""


def exact_pose(pose: PoseJson) -> Pose:
    """The pose as exact numbers: each float counts as what it is."""
    x, y, z = (Fraction(c) for c in pose["translation"])
    w, i, j, k = (Fraction(c) for c in pose["quaternion"])
    return Pose((x, y, z), (w, i, j, k))


def arrays(poses: Sequence[PoseJson]) -> tuple[Floats, Floats]:
    """Translations (N, 3) and rotations (N, 3, 3)."""
    shifts = np.array([p["translation"] for p in poses], dtype=np.float64).reshape(-1, 3)
    return shifts, matrices(np.array([p["quaternion"] for p in poses], dtype=np.float64).reshape(-1, 4))


def numbers(subject: Subject, pose: PoseJson, threshold: str | None = None) -> Numbers:
    """Everything that changes with the pose. Raises InputError for a leg of no length, and for poses too far away."""
    if subject.limbed:
        return robot_numbers(subject, pose, threshold)
    limit = threshold_of(threshold, subject.unit)
    if subject.moving is None:
        return _by_lines(subject, pose, limit)
    return _of_rig(subject, subject.moving, pose, limit)


def _of_rig(subject: Subject, moving: MovingPlatform, pose: PoseJson, limit: Threshold) -> Numbers:
    assert subject.analysis is not None
    assert subject.scenery is not None
    at = arrays([pose])
    j = jacobian(moving.base, moving.ends(*at))
    bounds = guarantees(j)
    sigma = float(j.sigma[0])
    floor, spread = float(noise(j, ROUNDING * moving.size)[0]), 0.0
    value = scaled_superbracket(moving, j)
    exact = Fraction(1)
    if sigma <= _MAY_BE_ZERO:
        exact = superbracket_at(moving.structure.legs, moving.exact(exact_pose(pose)))
    found: tuple[NearestPose, ...] = ()
    if limit.length is not None:
        found = (nearest_translation(moving, exact_pose(pose), j, singular=sigma <= floor),)
    said, reason = verdict(j, bounds, exact, floor, spread, limit, found, moving.unit)
    conditions = (subject.analysis.condition, *subject.analysis.readings)[:_READ]
    points = homogeneous(moving, *at)
    places = {n: (float(c[0, 0]), float(c[0, 1]), float(c[0, 2])) for n, c in points.items()}
    near = said != "regular"
    return {
        "pose": pose,
        "points": {n: list(p) for n, p in places.items()},
        "value": 0.0 if exact == 0 else float(value[0]),
        "margin": 0.0 if exact == 0 else sigma,
        "close": close_margin(limit),
        "verdict": said,
        "reason": reason,
        "causes": list(_causes(conditions, moving, pose, points, exact == 0, said)) if near else [],
        "readings": _readings(conditions, points, moving.unit),
        "constructed": subject.scenery.constructed(places),
        "motion": motion_view(softest_twist(j), tuple(j.centroid[0].tolist()), moving.unit) if near else None,
        "stress": list(scaled(j.stress[0].tolist())) if near else [],
        "limbs": limb_views(subject.robot, {**subject.home, **places}) if subject.robot else [],
        "notes": [],
    }


def _causes(
    conditions: Sequence[Condition], moving: MovingPlatform, pose: PoseJson, points: Any, zero: bool, said: str
) -> tuple[str, ...]:
    if zero:
        return causes(conditions, moving.exact(exact_pose(pose)), moving.structure.names, moving.unit)
    return (near_causes if said == "singular" else nearest_cause)(conditions, points, moving.structure.names)


def _readings(conditions: Sequence[Condition], points: Any, unit: str) -> list[ReadingView]:
    return [
        {
            "part": r.part,
            "name": r.name,
            "meaning": r.meaning,
            "value": float(r.values[0]) if r.valid[0] else None,
            "unit": unit if r.power else "",
            "why": "" if r.valid[0] else r.why,
        }
        for r in readings(conditions, points)
    ]


def _by_lines(subject: Subject, pose: PoseJson, limit: Threshold) -> Numbers:
    """Where the legs do not make a platform with a Jacobian: their six lines alone."""
    a, scenery = subject.analysis, subject.scenery
    if a is None or scenery is None:
        raise InputError(subject.why_not or "this structure cannot be drawn in space")
    if max(map(abs, pose["translation"])) > FAR * subject.size:
        raise InputError(f"a pose is more than {FAR:g} times the robot's size away", hint="check the unit")
    places = scenery.points(_plain(pose))
    close = close_margin(limit)
    size, said = judged(a.structure, places, CLOSE if close is None else close)
    always = a.condition.kind == "always-singular"
    value = 0.0 if always else _sign(a, places) * line_measure(a.structure.legs, places)
    points = {n: np.array([[*p, 1.0]]) for n, p in places.items()}
    why = f" ({subject.why_not})" if subject.why_not else ""
    return {
        "pose": pose,
        "points": {n: list(p) for n, p in places.items()},
        "value": value,
        "margin": 0.0 if always else size,
        "close": close,
        "verdict": "singular" if always else said,
        "reason": f"Told by the six lines alone{why}.",
        "causes": [a.condition.sentence] if always else [],
        "readings": _readings((a.condition, *a.readings), points, subject.unit),
        "constructed": scenery.constructed(places),
        "motion": scenery.motion(places),
        "stress": [],
        "limbs": [],
        "notes": [],
    }


def _plain(pose: PoseJson) -> dict[str, list[float]]:
    return {"translation": pose["translation"], "quaternion": pose["quaternion"]}


def _sign(a: Analysis, places: Mapping[str, Sequence[float]]) -> float:
    value = float(evaluate(a.structure.superbracket, {n: (*p, 1.0) for n, p in places.items()}))
    return float(np.sign(value))


def margins(subject: Subject, poses: Sequence[PoseJson], threshold: str | None = None) -> Along:
    """Margin, value and verdict at many poses, for a plot."""
    moving = subject.moving
    if moving is None or subject.analysis is None:
        found = [numbers(subject, p, threshold) for p in poses]
        return {
            "margin": [n["margin"] for n in found],
            "value": [n["value"] for n in found],
            "verdicts": [n["verdict"] for n in found],
        }
    limit = threshold_of(threshold, subject.unit)
    if limit.angle is None:
        limit = DEFAULT
    at = arrays(poses)
    many = numbers_of(moving, (), at, limit, ROUNDING * moving.size)
    j = jacobian(moving.base, moving.ends(*at))
    return {
        "margin": many.margin.tolist(),
        "value": scaled_superbracket(moving, j).tolist(),
        "verdicts": many.verdict.tolist(),
    }
