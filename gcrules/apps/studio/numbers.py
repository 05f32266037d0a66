"""The numbers at a pose, quickly: what a slider asks for many times a second.

It is a quick report; what is slow (the nearest singular pose) has a request of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.evaluate import evaluate
from gcrules.apps.studio.actuators_view import actuator_views, jacobian_facts
from gcrules.apps.studio.moving import motion_view, numbers_of_limbs
from gcrules.apps.studio.protocol.answer_views import Along, Numbers, ReadingView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import close_margin, threshold_of
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import judged, line_measure
from gcrules.core.english import as_sentence
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.many import homogeneous, scaled_superbracket
from gcrules.poses.numbers.many import numbers as numbers_of
from gcrules.poses.numbers.report import PoseReading
from gcrules.poses.pose_report import readings_at, report_of_legs
from gcrules.poses.signs.of_legs import signs_of_legs
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import FAR, Pose, too_far
from gcrules.screws.threshold import DEFAULT, Threshold
from gcrules.screws.verdict import CLOSE
from gcrules.views.results.amplification import actuator_notes
from gcrules.views.robots.limb_views import limb_views

__all__ = ["arrays", "exact_pose", "margins", "numbers"]

Floats = NDArray[np.float64]


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
    return method(_NUMBERS, subject.mechanism, "a pose")(subject, pose, threshold)


def _of_legs(m: SixLegs, subject: Subject, pose: PoseJson, threshold: str | None) -> Numbers:
    limit = threshold_of(threshold, m.unit)
    if subject.moving is None or subject.scenery is None:
        return _by_lines(subject, pose, limit)
    here = exact_pose(pose)
    found = report_of_legs(m, here, threshold=limit, nearest=False, quick=True)
    at = arrays([pose])
    j = jacobian(m.rig.base, m.rig.ends(*at))
    places = {n: (float(x), float(y), float(z)) for n, ((x, y, z, _),) in homogeneous(m.rig, *at).items()}
    lengths = dict(zip(found.jacobian.actuators, j.lengths[0].tolist(), strict=True))
    near = found.verdict != "regular"
    return {
        "pose": pose,
        "freedoms": [],
        "platform": None,
        "points": {n: list(p) for n, p in places.items()},
        "value": float(scaled_superbracket(m.rig, j)[0]) if found.superbracket else 0.0,
        "margin": found.margin,
        "close": close_margin(limit),
        "verdict": found.verdict,
        "reason": found.reason,
        "causes": list(found.causes),
        "readings": _views(found.readings),
        "constructed": subject.scenery.constructed(places),
        "motion": motion_view(found.softest, tuple(j.centroid[0].tolist()), m.unit) if near else None,
        "stress": list(found.stress) if near else [],
        "limbs": limb_views(subject.robot, {**subject.home, **places}) if subject.robot else [],
        "skeleton": None,
        "directions": {},
        "notes": list(actuator_notes(found.jacobian.amplification, m.unit)),
        "actuators": actuator_views(m, lengths, found.jacobian),
        "jacobian": jacobian_facts(found.jacobian, m.unit),
        "signs": [
            {"expression": s.expression, "sign": s.sign, "statement": s.statement} for s in signs_of_legs(m, here)
        ],
    }


_NUMBERS: Methods[Numbers] = {SixLegs: _of_legs, Limbs: numbers_of_limbs}


def _views(found: Iterable[PoseReading]) -> list[ReadingView]:
    return [
        {"part": r.part, "name": r.name, "meaning": r.meaning, "value": r.value, "unit": r.unit, "why": r.why}
        for r in found
    ]


def _by_lines(subject: Subject, pose: PoseJson, limit: Threshold) -> Numbers:
    """Where the legs do not make a platform with a Jacobian: their six lines alone."""
    a, scenery = subject.analysis, subject.scenery
    if a is None or scenery is None:
        raise InputError(subject.why_not or "this structure cannot be drawn in space")
    if max(map(abs, pose["translation"])) > FAR * subject.size:
        raise too_far("a pose is")
    places = scenery.points(_plain(pose))
    close = close_margin(limit)
    size, said = judged(a.structure, places, CLOSE if close is None else close)
    always = a.condition.kind == "always-singular"
    value = 0.0 if always else _sign(a, places) * line_measure(a.structure.legs, places)
    points = {n: np.array([[*p, 1.0]]) for n, p in places.items()}
    return {
        "pose": pose,
        "freedoms": [],
        "platform": None,
        "points": {n: list(p) for n, p in places.items()},
        "value": value,
        "margin": 0.0 if always else size,
        "close": close,
        "verdict": "singular" if always else said,
        "reason": _told_by_lines(subject, a, said),
        "causes": [a.condition.sentence] if always else [],
        "readings": _views(readings_at((a.condition, *a.readings), points, subject.unit)),
        "constructed": scenery.constructed(places),
        "motion": scenery.motion(places),
        "stress": [],
        "limbs": [],
        "skeleton": None,
        "directions": {},
        "notes": [],
        "actuators": [],
        "jacobian": [],
        "signs": [],
    }


def _told_by_lines(subject: Subject, a: Analysis, said: str) -> str:
    """Why no more than the six lines is examined, and what they say."""
    if a.condition.kind == "always-singular":
        return "The way in which the legs are joined makes their six lines depend on each other in every pose: proved."
    lines = f"Only the six lines of the legs, as they lie in this pose, were examined: {_DEPENDENCE[said]}."
    told = all(n in a.structure.sides for n in a.structure.names)  # what belongs to the base
    unit = "" if told else " Their σ is the size of their determinant, from 0 to 1, and not an angle."
    return f"{as_sentence(subject.why_not)} {lines}{unit}"


_DEPENDENCE = {
    "singular": "within rounding they depend on each other, so the pose is singular",
    "close": "they nearly depend on each other, so the pose is close to singular",
    "regular": "they do not depend on each other, so the pose is not singular",
}
"""What the six lines say, by the verdict."""


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
