r"""Proofs that a robot has no singular pose nearby, in rotation and in both, from σ at many rotations.

Rotation vectors are halved into cubes. The distance of two rotations is at most that of their vectors, so within a cube
of half width h every rotation is within √3 h of the one at the centre. There σ guarantees that no leg's turn below θ
leads to a singular pose; legs turn by at most κ(|d| + √3 h r_i)/l_i + √3 h (see `margin`). So all rotations of a
cube are free if that stays below θ with d = 0, and all shifts |d| below some δ are free with them. Derived here.
"""

from __future__ import annotations

from functools import partial
from itertools import product

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.screws.guarantees import guarantees, sigma_for
from gcrules.screws.margin import LegJacobians, jacobian

__all__ = ["MAX_POSES", "free_angle", "free_distance"]

Floats = NDArray[np.float64]

MAX_POSES = 30_000

_CORNERS = np.array(list(product((-1.0, 1.0), repeat=3)))
_ENOUGH = 0.98  # of the best that this argument can prove
_NEARLY = 1e-5  # of the distance that is looked for: cubes so near to the least are computed to the last digit


def free_angle(base: Floats, j: LegJacobians, target: float, limit: int = MAX_POSES) -> float:
    """An angle ≤ target such that no rotation by less about the centroid of the platform ends makes the robot singular.

    `j` is at the one pose from which it is turned; at most `limit` poses are looked at.
    """
    cubes, half, seen, free = np.zeros((1, 3)), target, 0, target
    while len(cubes):
        checkpoint()
        nearest = _nearest(cubes, half)
        order = np.argsort(nearest, kind="stable")
        order = order[nearest[order] < free]
        if seen + len(order) > limit:  # the nearest cubes first: what is left bounds the answer
            kept = order[: max(limit - seen, 0)]
            free = min(free, float(nearest[order[len(kept)]]))
            order = kept
        cubes = cubes[order]
        seen += len(cubes)
        if len(cubes):
            cubes = cubes[~_free(base, j, cubes, half)]
        half /= 2
        cubes = _halved(cubes, half)
    return free


def free_distance(base: Floats, j: LegJacobians, target: float, limit: int = MAX_POSES) -> float:
    """A distance ≤ target such that no nearer pose is singular, in the metric of `Guarantees.combined`.

    A singular pose in a cube has a shift of at least δ and a rotation of at least the cube's least φ, so its distance
    is at least the root of δ² + (ρφ)².
    """
    rho = j.radius
    half = min(target / rho, np.pi)
    cubes, seen, best = np.zeros((1, 3)), 0, target
    while len(cubes):
        checkpoint()
        cubes = cubes[rho * _nearest(cubes, half) < _ENOUGH * best]  # in the others no pose is near enough
        if not len(cubes):
            break
        seen += len(cubes)
        shifts, centres = _free_shift(_quick(base, j, cubes), half)
        # No cube can do better than its centre, so `best` bounds what can be proved at all.
        middles = np.hypot(centres, rho * np.linalg.norm(cubes, axis=1))
        bounds = np.hypot(np.maximum(shifts, 0.0), rho * _nearest(cubes, half))
        least = [values <= values.min() + _NEARLY * target for values in (middles, bounds)]
        few = least[0] | least[1]
        few[0] = True  # the first one's arms give the platform's size, which turning rounds
        shifts, centres = _free_shift(_thorough(base, j, cubes[few]), half)
        middles[few] = np.hypot(centres, rho * np.linalg.norm(cubes[few], axis=1))
        bounds[few] = np.hypot(np.maximum(shifts, 0.0), rho * _nearest(cubes[few], half))
        best = min(best, float(middles[few].min()))
        cubes, bounds = cubes[bounds < _ENOUGH * best], bounds[bounds < _ENOUGH * best]
        if seen + 8 * len(cubes) > limit:
            return min(_ENOUGH * best, float(bounds.min(initial=best)))
        half /= 2
        cubes = _halved(cubes, half)
    return _ENOUGH * best


@dataclass(frozen=True, eq=False)
class _Turned:
    """The platform turned by the vectors at the middles of cubes: for guarantees, and where a leg has no length."""

    sigma: Floats
    lengths: Floats
    reach: Floats
    radius: float
    gone: NDArray[np.bool_]


def _free(base: Floats, j: LegJacobians, cubes: Floats, half: float) -> NDArray[np.bool_]:
    """Whether all rotations of cubes are free."""
    rotations, gone = _rotations(base, j, cubes)
    least = partial(sigma_for, np.sqrt(3) * half, reach=j.reach)
    return j.keeps(rotations, base, least) & ~gone


def _quick(base: Floats, j: LegJacobians, cubes: Floats) -> _Turned:
    rotations, gone = _rotations(base, j, cubes)
    sigma, lengths = j.turned(rotations, base)
    return _Turned(sigma, lengths, j.reach, j.radius, gone)


def _rotations(base: Floats, j: LegJacobians, cubes: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Those at the middles of cubes, and which leave a leg without length: they are replaced by none."""
    rotations = matrices(from_vectors(cubes))
    gone = _without_length(j.arms[0] + (j.centroid[0] - base) @ rotations, j)
    rotations[gone] = np.eye(3)
    return rotations, gone


def _thorough(base: Floats, j: LegJacobians, cubes: Floats) -> _Turned:
    """To the last digit."""
    ends = np.einsum("nij,kj->nki", matrices(from_vectors(cubes)), j.arms[0]) + j.centroid[0]
    gone = _without_length(ends - base, j)
    ends[gone] = j.arms[0] + j.centroid[0]
    there = jacobian(base, ends)
    return _Turned(there.sigma, there.lengths, there.reach, there.radius, gone)


def _without_length(along: Floats, j: LegJacobians) -> NDArray[np.bool_]:
    found: NDArray[np.bool_] = (np.linalg.norm(along, axis=2) <= 1e-12 * j.radius).any(axis=1)
    return found


def _free_shift(there: _Turned, half: float) -> tuple[Floats, Floats]:
    """The δ of cubes (negative where not even all rotations are free), and that of their centres alone."""
    bounds = guarantees(there)
    spare = 1 - np.sqrt(3) * half / np.maximum(bounds.rotation, 1e-300)  # of θ, at the leg that is worst in rotation
    shift: Floats = bounds.shift * spare
    return np.where(there.gone, -1.0, shift), np.where(there.gone, 0.0, bounds.shift)


def _nearest(cubes: Floats, half: float) -> Floats:
    found: Floats = np.linalg.norm(np.maximum(np.abs(cubes) - half, 0.0), axis=1)
    return found


def _halved(cubes: Floats, half: float) -> Floats:
    return (cubes[:, None, :] + half * _CORNERS).reshape(-1, 3)
