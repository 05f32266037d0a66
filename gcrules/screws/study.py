r"""Study parameters of motions: the dual quaternion x + ε y, x0 … x3, y0 … y3.

The motion p ↦ R p + t has the quaternion x of R, of any length but 0, and y = t x / 2, so that x0 y0 + … + x3 y3 = 0;
multiples are one motion, and the identity is x = (1, 0, 0, 0), y = 0. All but `study` work with numbers of any kind.

>>> quarter = (1, 0, 0, 1, 0, 0, -1, 0)  # of a turn about the vertical line through (1, 0, 0)
>>> matrix_of(quarter), shift_of(quarter)  # times |x|² = 2
(((0, -2, 0), (2, 0, 0), (0, 0, 2)), (2, -2, 0))
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["DualQuaternion", "matrix_of", "product", "quaternion_product", "shift_of", "study"]

DualQuaternion = tuple[Any, ...]
"""Eight numbers, x then y."""


def quaternion_product(a: Sequence[Any], b: Sequence[Any]) -> tuple[Any, ...]:
    """The product of quaternions (w, x, y, z): first b, then a, as turns."""
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


def product(a: Sequence[Any], b: Sequence[Any], modulus: int | None = None) -> DualQuaternion:
    """The product of dual quaternions: first b, then a, as seen from the base."""
    x = quaternion_product(a[:4], b[:4])
    parts = quaternion_product(a[:4], b[4:]), quaternion_product(a[4:], b[:4])
    y = (p + q for p, q in zip(*parts, strict=True))
    return tuple(c if modulus is None else c % modulus for c in (*x, *y))


def matrix_of(x: Sequence[Any]) -> tuple[tuple[Any, ...], ...]:
    """The turn of a quaternion, or of a dual one, times |x|²: a matrix whose entries are quadratic in x."""
    back = (x[0], -x[1], -x[2], -x[3])
    units = ((0, *(int(n == k) for k in range(3))) for n in range(3))
    columns = (quaternion_product(quaternion_product(x[:4], e), back)[1:] for e in units)
    return tuple(zip(*columns, strict=True))


def shift_of(motion: Sequence[Any]) -> tuple[Any, Any, Any]:
    """The shift t of a dual quaternion times |x|²: the vector 2 y x̄."""
    x = motion[:4]
    t = quaternion_product(motion[4:], (x[0], -x[1], -x[2], -x[3]))
    return 2 * t[1], 2 * t[2], 2 * t[3]


def study(motion: NDArray[np.float64]) -> NDArray[np.float64]:
    """The Study parameters (8,) of a motion (4, 4), with x of length 1; of x and −x either."""
    r, t = motion[:3, :3], motion[:3, 3]
    outer = np.empty((4, 4))  # 4 x xᵀ, of which the longest row is taken
    outer[0, 0] = 1 + np.trace(r)
    outer[0, 1:] = outer[1:, 0] = r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]
    outer[1:, 1:] = r + r.T + (1 - np.trace(r)) * np.eye(3)
    x = outer[int(np.argmax(np.diag(outer)))]
    x = x / np.linalg.norm(x)
    return np.concatenate([x, np.array(quaternion_product((0.0, *t), x)) / 2])
