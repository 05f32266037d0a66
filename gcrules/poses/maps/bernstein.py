r"""Cubics on cells as Bernstein coefficients: the values lie between the smallest and the largest one (convex hull).

All arrays hold N cells: shape (N, 4, 4) or (N, 4, 4, 4). A cell is a unit square or cube with whole corners.

Rounding: a coefficient is a sum of at most 64 products of the polynomial's coefficients with powers of a corner and
with numbers ≤ 1, found in fewer than 100 operations, each of relative error 2⁻⁵³ against `magnitude`, the same sum with
absolute values; halving only takes averages. `tolerance` is more than ten times as large.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["coefficients", "corners", "halves", "tolerance"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TO_BERNSTEIN = np.array([[1, 0, 0, 0], [1, 1 / 3, 0, 0], [1, 2 / 3, 1 / 3, 0], [1, 1, 1, 1]])
_BINOMIALS = np.array([[1, 1, 1, 1], [0, 1, 2, 3], [0, 0, 1, 3], [0, 0, 0, 1]], dtype=np.float64)
_RELATIVE = 2e-13


def coefficients(tensor: Floats, corner: Integers, width: tuple[int, ...] = (1, 1, 1)) -> Floats:
    """The Bernstein coefficients of a polynomial on cells (blocks of this width) with these lower corners (N, axes)."""
    axes = corner.shape[1]
    found = (_shift(corner[:, 0], width[0]).reshape(-1, 4) @ tensor.reshape(4, -1)).reshape(-1, *[4] * axes)
    for k in range(1, axes):  # the axis k stands at k + 1, after that of the cells
        last = np.moveaxis(found, k + 1, -1)
        found = np.moveaxis(
            np.matmul(last.reshape(len(corner), -1, 4), np.swapaxes(_shift(corner[:, k], width[k]), 1, 2)).reshape(
                last.shape
            ),
            -1,
            k + 1,
        )
    return found


def _shift(start: Integers, width: int) -> Floats:
    """From powers of w to Bernstein coefficients on [start, start + width]: (N, 4, 4)."""
    powers = np.zeros((len(start), 4, 4))
    w = start.astype(np.float64)
    for m in range(4):
        for k in range(m, 4):
            powers[:, m, k] = _BINOMIALS[m, k] * w ** (k - m) * width**m
    return np.asarray(np.matmul(_TO_BERNSTEIN, powers))


def tolerance(tensor: Floats, reach: tuple[int, ...]) -> float:
    """What a coefficient may be off by on cells within |w| ≤ reach."""
    size = np.abs(tensor)
    for k, r in enumerate(reach):
        powers = (float(r) + 1) ** np.arange(4)
        size = size * powers.reshape([-1 if i == k else 1 for i in range(size.ndim)])
    return float(_RELATIVE * size.sum())


def halves(b: Floats, axis: int) -> tuple[Floats, Floats]:
    """The coefficients on both halves of each cell along an axis (de Casteljau)."""
    c0, c1, c2, c3 = np.moveaxis(b, axis + 1, 0)
    d0, d1, d2 = (c0 + c1) / 2, (c1 + c2) / 2, (c2 + c3) / 2
    e0, e1 = (d0 + d1) / 2, (d1 + d2) / 2
    f = (e0 + e1) / 2
    low, high = np.stack([c0, d0, e0, f]), np.stack([f, e1, d2, c3])
    return np.moveaxis(low, 0, axis + 1), np.moveaxis(high, 0, axis + 1)


def corners(b: Floats) -> Floats:
    """The values at the corners, (N, 4) or (N, 8)."""
    ends = b
    for axis in range(1, b.ndim):
        ends = np.take(ends, [0, 3], axis=axis)
    return ends.reshape(len(b), 2 ** (b.ndim - 1))
