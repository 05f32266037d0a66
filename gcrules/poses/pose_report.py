r"""A platform on six legs at poses: numbers, nearest singular poses, causes; or arrays for many poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gcrules.algebra.evaluate import evaluate
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.dimensions.dimensions import architecture_at
from gcrules.core.errors import EngineFault, InputError
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.nearest.poses import nearest_poses, nearest_translation
from gcrules.poses.numbers.arrays import from_poses, normalised_note, read_arrays
from gcrules.poses.numbers.causes import causes, near_causes, nearest_cause
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.poses.numbers.incidence_measures import readings
from gcrules.poses.numbers.many import PoseNumbers, homogeneous, numbers
from gcrules.poses.numbers.motion import dependence, exact_dependence, scaled, softest_twist
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.poses.numbers.reason import verdict as verdict_of
from gcrules.poses.numbers.report import PoseReading, PoseReport
from gcrules.rules.condition import Condition
from gcrules.screws.guarantees import ROUNDING, guarantees, noise
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import Threshold

__all__ = ["numbers_of_legs", "readings_at", "report_of_legs"]

_QUICK = 3
"""Conditions that a quick report tells of: those with the smallest cofactors stand first, and each takes a while."""


def numbers_of_legs(
    m: SixLegs,
    at: Any,
    turns: Mapping[str, Any],
    degrees: bool,
    threshold: Threshold,
    accuracy: float,
) -> PoseNumbers:
    """Arrays for many poses: a sequence of poses, or translations (N, 3) with turns beside them, N or one of each."""
    if isinstance(at, (list, tuple)) and at and isinstance(at[0], (Pose, str, Mapping)):
        if any(t is not None for t in turns.values()):
            raise InputError("poses that contain their turns, and a turn as well")
        poses = [read_one(p, m.unit, degrees) for p in at]
        arrays, notes = from_poses(poses), tuple(dict.fromkeys(n for p in poses for n in p.notes))
    else:
        quaternion = turns["quaternion"]
        arrays = read_arrays(
            at,
            quaternions=quaternion,
            rotation_vectors=turns["rotation_vector"],
            euler=turns["euler"],
            degrees=degrees,
        )
        notes = () if quaternion is None else normalised_note(quaternion)
    found = numbers(m.rig, (m.analysis.condition, *m.analysis.readings), arrays, threshold, accuracy)
    return replace(found, notes=(*notes, *found.notes))


def report_of_legs(
    m: SixLegs,
    at: Pose,
    *,
    threshold: Threshold,
    accuracy: float | None = None,
    nearest: bool = True,
    quick: bool = False,
) -> PoseReport:
    """All numbers of one pose, with joints as exact as floats where no `accuracy` is given. A `quick` report rests on
    one road to the superbracket, and tells of the first three conditions only. Raises InputError for a leg of no
    length.
    """
    analysis, moving = m.analysis, m.rig
    accuracy = ROUNDING * moving.size if accuracy is None else accuracy
    points, arrays = moving.exact(at), from_poses([at])
    j = jacobian(moving.base, moving.ends(*arrays))
    bounds = guarantees(j)
    value = superbracket_at(moving.structure.legs, points)
    conditions = (analysis.condition, *analysis.readings)
    if quick:
        conditions = conditions[:_QUICK]
    else:
        _two_roads(value, analysis, points)
    spread = float(noise(j, accuracy)[0])
    floor = float(noise(j, ROUNDING * moving.size)[0])
    singular = value == 0 or float(j.sigma[0]) <= floor
    found: Sequence[NearestPose] = ()
    if nearest:
        found = nearest_poses(moving, at, j, singular=singular)
    elif threshold.length is not None:
        found = (nearest_translation(moving, at, j, singular=singular),)
    verdict, reason = verdict_of(j, bounds, value, floor, spread, threshold, found, moving.unit)
    always = None if verdict == "regular" else architecture_at(moving.structure, moving.points)
    if always is not None and always.sentence:
        reason = f"{reason} {always.sentence}"
    depends = None
    if value == 0:
        depends = exact_dependence(moving.legs, moving.names, points, j.centroid[0])
    elif singular:
        depends = dependence(j, moving.names)
    held = {name: number for name, number in bounds.at(0).items() if name != "sigma"}
    if value == 0:
        held = dict.fromkeys(held, 0.0)
    wrenches = m.wrenches(at)
    return PoseReport(
        rig=moving,
        pose=at,
        condition=analysis.condition,
        verdict=verdict,
        reason=reason,
        causes=() if verdict == "regular" else _causes(conditions, moving, at, value, singular=singular),
        superbracket=value,
        margin=0.0 if value == 0 else float(j.sigma[0]),
        accuracy=accuracy,
        noise=spread,
        threshold=threshold,
        jacobian=wrenches if value else replace(wrenches, condition_number=float("inf")),
        readings=readings_at(conditions, homogeneous(moving, *arrays), moving.unit),
        nearest=tuple(_explained(n, conditions, moving) for n in found) if nearest else (),
        softest=softest_twist(j),
        stress=scaled(j.stress[0].tolist()),
        dependence=depends,
        notes=at.notes,
        architecture=always,
        **held,
    )


def _explained(n: NearestPose, conditions: Sequence[Condition], moving: MovingPlatform) -> NearestPose:
    if n.pose is None or n.causes:
        return n
    value = superbracket_at(moving.structure.legs, moving.exact(n.pose))
    return replace(n, causes=_causes(conditions, moving, n.pose, value, singular=True))


def _causes(
    conditions: Sequence[Condition], moving: MovingPlatform, at: Pose, value: Fraction, *, singular: bool
) -> tuple[str, ...]:
    names = moving.structure.names
    if value == 0:
        return causes(conditions, moving.exact(at), names, moving.unit)
    near = near_causes if singular else nearest_cause
    return near(conditions, homogeneous(moving, *from_poses([at])), names)


def _two_roads(value: Fraction, analysis: Analysis, points: dict[str, tuple[Fraction, ...]]) -> None:
    """The determinant of the legs and the condition must agree. Raises EngineFault where they do not."""
    c = analysis.condition
    if evaluate(c.cofactor, points) * value != evaluate(c.right_side, points):
        raise EngineFault(f"the superbracket and the condition {c.expression} disagree at a pose")


def readings_at(conditions: Sequence[Condition], points: Any, unit: str) -> tuple[PoseReading, ...]:
    """The readings at one pose, given by homogeneous coordinates (1, 4)."""
    found = []
    for r in readings(conditions, points):
        valid = bool(r.valid[0])
        value = float(r.values[0]) if valid else None
        why = "" if valid else r.why
        found.append(PoseReading(r.part, r.name, r.meaning, value, unit if r.power else "", r.published, why))
    return tuple(found)
