r"""The nearest singular poses of a robot: in translation, in rotation, in both; each pose is checked again."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.nearest.cover import free_angle, free_distance
from gcrules.poses.nearest.multistart import Determinant, best_zero
from gcrules.poses.nearest.zero import nearest_zero
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.cubic import superbracket_at, translation_polynomial
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.screws.guarantees import guarantees
from gcrules.screws.margin import LegJacobians, jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import from_vector, product, rotation, short

__all__ = ["nearest_poses", "nearest_translation"]

Floats = NDArray[np.float64]

_COVERED = 0.01  # the proof for rotations covers the angles below that of the pose found, but for this part
_BESIDE = 1e-9  # relative distance at which a change of sign is looked for, exactly


def nearest_poses(rig: MovingPlatform, pose: Pose, j: LegJacobians, *, singular: bool) -> tuple[NearestPose, ...]:
    """Translation, rotation, combined; all at distance 0 where the pose itself is `singular`. `j` is at the pose."""
    translation = nearest_translation(rig, pose, j, singular=singular)
    if singular:
        return translation, replace(translation, kind="rotation"), replace(translation, kind="combined")
    seeds = np.zeros((0, 6))
    if translation.pose is not None:
        shift = [float(c - d) for c, d in zip(translation.pose.translation, pose.translation, strict=True)]
        seeds = np.array([[*shift, 0.0, 0.0, 0.0]])
    bounds = guarantees(j)
    f = Determinant.of(rig.base, j)
    vector = best_zero(f, 3, math.pi, free=float(bounds.rotation[0]))
    target = math.pi if vector is None else (1 - _COVERED) * float(np.linalg.norm(vector))
    free = max(float(bounds.rotation[0]), free_angle(rig.base, j, target))
    rotated = _found(rig, pose, "rotation", vector, free, j)
    if vector is not None:
        seeds = np.concatenate([seeds, [[0.0, 0.0, 0.0, *(j.radius * vector)]]])
    reach = float(np.linalg.norm(seeds, axis=1).min(initial=math.pi * j.radius))
    vector = best_zero(f, 6, reach, seeds, free=float(bounds.combined[0]))
    target = reach if vector is None else float(np.linalg.norm(vector))
    free = max(float(bounds.combined[0]), free_distance(rig.base, j, target))
    return translation, rotated, _found(rig, pose, "combined", vector, free, j)


def nearest_translation(rig: MovingPlatform, pose: Pose, j: LegJacobians, *, singular: bool) -> NearestPose:
    """The nearest singular pose at the same orientation."""
    points = rig.exact(pose)
    if singular:
        same = superbracket_at(rig.structure.legs, points) == 0
        return NearestPose("translation", 0.0, 0.0, 0.0 if same else None, pose, float(j.sigma[0]), same)
    step = Fraction(2) ** round(math.log2(rig.size))
    f = translation_polynomial(rig.structure.legs, points, rig.structure.platform, step)
    zero = nearest_zero(f, rig.size)
    found = NearestPose("translation", zero.distance, zero.lower, zero.upper, None, never=zero.never)
    if zero.point is None:
        return found
    x, y, z = (c + d for c, d in zip(pose.translation, zero.point, strict=True))
    return _checked(rig, found, Pose((x, y, z), pose.quaternion))


def _found(rig: MovingPlatform, pose: Pose, kind: str, x: Floats | None, lower: float, j: LegJacobians) -> NearestPose:
    """The answer of a search, checked by an exact change of sign beyond the zero."""
    if x is None:
        return NearestPose(kind, math.inf, lower, None, None, never=kind == "rotation" and lower >= math.pi)
    distance = float(np.linalg.norm(x))
    beyond = _displaced(rig, pose, x * (1 + _BESIDE), j.radius)
    crossed = _superbracket(rig, pose) * _superbracket(rig, beyond) <= 0
    found = NearestPose(kind, distance, lower, distance * (1 + 2 * _BESIDE) if crossed else None, None)
    return _checked(rig, found, _displaced(rig, pose, x, j.radius))


def _superbracket(rig: MovingPlatform, pose: Pose) -> Fraction:
    """At a pose, 0 where a leg has no length."""
    try:
        return superbracket_at(rig.structure.legs, rig.exact(pose))
    except InputError:
        return Fraction(0)


def _checked(rig: MovingPlatform, found: NearestPose, pose: Pose) -> NearestPose:
    """With the pose and the numbers there; a leg may have no length in a singular pose."""
    exact = _superbracket(rig, pose) == 0
    try:
        sigma = float(jacobian(rig.base, rig.ends(*from_poses([pose]))).sigma[0])
    except InputError as fault:
        return replace(
            found, pose=pose, sigma=0.0, exact=exact, causes=(f"{fault.message[0].upper()}{fault.message[1:]}.",)
        )
    return replace(found, pose=pose, sigma=sigma, exact=exact)


def _displaced(rig: MovingPlatform, pose: Pose, x: Floats, radius: float) -> Pose:
    """The pose after a displacement: a rotation vector about the centroid of the ends, after a shift if there are six
    coordinates (the last three are radius times the rotation vector).
    """
    shift, vector = (np.zeros(3), x) if len(x) == 3 else (x[:3], x[3:] / radius)
    turn = short(product(from_vector([Fraction(float(c)) for c in vector], degrees=False), pose.quaternion))
    ends = [rig.points[b] for _, b in rig.legs]
    arm = [sum(c, Fraction(0)) / 6 - m for c, m in zip(zip(*ends, strict=True), rig.centre, strict=True)]
    before, after = (
        [sum((r * c for r, c in zip(row, arm, strict=True)), Fraction(0)) for row in matrix]
        for matrix in (pose.rotation, rotation(turn))
    )
    x_, y_, z_ = (
        Fraction(float(t + b - a)) + Fraction(float(s))
        for t, b, a, s in zip(pose.translation, before, after, shift, strict=True)
    )
    return Pose((x_, y_, z_), turn)
