r"""Poses around others that are regular, proved by the legs' coordinates.

Rows (l, b × l), l along a leg and b its end on the base, make a matrix J that is singular exactly where the pose is.
Around a pose the platform shifts by d and turns by a vector ω, so that the end of a leg, at a from the centre, moves by
d + ω × a but for at most φ² |a| / 2, φ the largest turn. So |1 − J₀⁻¹ J| is in all entries at most a matrix A: the sum
of |J₀⁻¹ ∂J| times the largest components of d and ω, and |J₀⁻¹| times what is left. Where the spectral radius of A is
below 1, all J around the pose are regular; it is at most max (A v)ᵢ / vᵢ for each positive v (Collatz and Wielandt).
Derived here, as for Krawczyk's operator.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.moving_platform import MovingPlatform

__all__ = ["are_regular"]

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

_ROUNDING = 1e-12
_POWERS = 4  # of a matrix: they bring a vector near to the one by which its radius is bounded best


def are_regular(
    rig: MovingPlatform,
    ends: Floats,
    rotations: Floats,
    shifts: Iterable[tuple[Floats, float]],
    axes: Iterable[Floats],
    turn: float,
) -> Booleans:
    """Whether it is proved (N,) that all poses around others are regular.

    These others have the legs' ends (N, 6, 3) on the platform and its rotations (N, 3, 3). The platform shifts along
    each direction of `shifts` (3,) by no more than the length with it, and turns by no more than `turn` (rad), by a
    vector that is a sum of multiples of the `axes` (N, 3), each at most that long.
    """
    base = (rig.base - rig.base.mean(axis=0)) / rig.size  # a change of the origin changes no rank
    rows = _moved(base, (ends - rig.base) / rig.size)
    found = np.asarray(np.linalg.det(rows) != 0)
    if not found.any():
        return found
    rows = rows[found]
    inverse = np.linalg.inv(rows)
    arms = np.swapaxes(rotations[found] @ rig.arms.T, 1, 2) / rig.size
    bound = np.abs(np.eye(6) - inverse @ rows) + _ROUNDING * np.abs(inverse) @ np.abs(rows)
    for along, far in shifts:
        bound += far / rig.size * np.abs(inverse @ _moved(base, np.broadcast_to(along, base.shape)))
    for axis in axes:
        bound += turn * np.abs(inverse @ _moved(base, np.cross(axis[found][:, None], arms)))
    left = turn**2 / 2 * np.linalg.norm(arms, axis=2, keepdims=True)
    reached = np.concatenate([np.ones((6, 3)), np.repeat(np.linalg.norm(base, axis=1)[:, None], 3, axis=1)], axis=1)
    found[found] = _radius(bound + np.abs(inverse) @ (left * reached)) < 1
    return found


def _moved(base: Floats, legs: Floats) -> Floats:
    """The rows (l, b × l) of legs (..., 6, 3), or their change."""
    return np.concatenate([legs, np.cross(base, legs)], axis=-1)


def _radius(bound: Floats) -> Floats:
    """An upper bound of the spectral radius of matrices without negative entries (N, n, n)."""
    v = np.ones((*bound.shape[:2], 1))
    for _ in range(_POWERS):
        v = bound @ v + v / 8
        v /= v.max(axis=1, keepdims=True)
    return np.asarray((bound @ v / v).max(axis=(1, 2)))
