r"""Rigid motions as 4×4 matrices: exponentials of screws, logarithms, and how motions carry screws.

Twists are rows (ω; v), v the velocity of the origin. Everything works for stacks of screws and matrices at once.

>>> quarter = exponential(np.array([0, 0, 1, 0, -1, 0.0]), np.pi / 2)  # about the line through (1, 0, 0) along z
>>> (quarter @ [2, 0, 0, 1]).round(9).tolist()
[1.0, 1.0, 0.0, 1.0]
>>> logarithm(quarter).round(6).tolist()
[0.0, 0.0, 1.570796, 0.0, -1.570796, 0.0]
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Floats",
    "carried",
    "change_about",
    "changed_about",
    "cross_matrix",
    "crossed",
    "exponential",
    "inverse",
    "lengths",
    "logarithm",
    "rotation_vector",
    "rotation_vector_rates",
    "rotations",
]

Floats = NDArray[np.float64]

_SMALL = 1e-6  # angles below which series take the place of quotients


def cross_matrix(vectors: Floats) -> Floats:
    """The matrices of w ↦ v × w, shape (..., 3, 3)."""
    v = np.asarray(vectors, dtype=float)
    found = np.zeros((*v.shape, 3))
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        found[..., j, i] = v[..., k]
        found[..., i, j] = -v[..., k]
    return found


def crossed(a: Floats, b: Floats) -> Floats:
    """a × b, for stacks of vectors that fit each other; quicker than NumPy's own."""
    x, y, z = a[..., 0], a[..., 1], a[..., 2]
    u, v, w = b[..., 0], b[..., 1], b[..., 2]
    first = y * w - z * v
    found = np.empty((*first.shape, 3))
    found[..., 0] = first
    found[..., 1] = z * u - x * w
    found[..., 2] = x * v - y * u
    return found


def lengths(vectors: Floats, axis: int = -1, *, keepdims: bool = False) -> Floats:
    """The lengths of vectors, as NumPy's own norm has them to the last digit; quicker for few of them."""
    return np.asarray(np.sqrt((vectors * vectors).sum(axis=axis, keepdims=keepdims)))


def rotations(vectors: Floats) -> Floats:
    """The matrices that turn about each vector by its length (rad)."""
    screws = np.concatenate([vectors, np.zeros_like(vectors)], axis=-1)
    return exponential(screws, np.ones(np.shape(vectors)[:-1]))[..., :3, :3]


def exponential(screws: Floats, amounts: Floats | float) -> Floats:
    """The motions that the twists make in the given amounts (rad for unit turns, lengths for unit slides)."""
    whole = screws * np.asarray(amounts)[..., None]
    whole = whole.transpose(whole.ndim - 1, *range(whole.ndim - 1)).copy()
    w, v = whole[:3], whole[3:]
    square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2]
    along = w[0] * v[0] + w[1] * v[1] + w[2] * v[2]
    a = np.sqrt(square)
    small = a < _SMALL
    b = np.where(small, 1.0, a)
    turning, twice = np.sin(b), b * b
    sine = np.where(small, 1 - square / 6, turning / b)
    cosine = np.where(small, 0.5 - square / 24, (1 - np.cos(b)) / twice)
    rest = np.where(small, 1 / 6 - square / 120, (b - turning) / (twice * b))
    found = np.zeros((*square.shape, 4, 4))
    turned, bent, moved = sine * w, cosine * w, cosine * v
    kept, stretched, along = 1 - cosine * square, 1 - rest * square, rest * along
    for k in range(3):  # entry by entry: 1 + sine W + cosine W², W² = w wᵀ − |w|²; of inner axes so short NumPy is slow
        i, j = (k + 1) % 3, (k + 2) % 3
        found[..., k, k] = kept + bent[k] * w[k]
        found[..., j, i] = bent[i] * w[j] + turned[k]
        found[..., i, j] = bent[i] * w[j] - turned[k]
        found[..., k, 3] = stretched * v[k] + (w[i] * moved[j] - w[j] * moved[i]) + along * w[k]
    found[..., 3, 3] = 1
    return found


def rotation_vector(matrices: Floats) -> Floats:
    """The axes of rotations (..., 3, 3) times their angles, from 0 to π."""
    m = np.asarray(matrices, dtype=float)
    odd = np.stack([m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1]], -1) / 2
    sine = np.sqrt((odd * odd).sum(axis=-1))
    cosine = (np.trace(m, axis1=-2, axis2=-1) - 1) / 2
    small = sine <= _SMALL
    stretch = np.where(small, 1 + sine**2 / 6, np.arctan2(sine, cosine) / np.where(small, 1.0, sine))
    found: Floats = odd * stretch[..., None]
    half = small & (cosine <= 0)
    if half.any():
        found[half] = _half_turns(m[half], odd[half], np.arctan2(sine, cosine)[half])
    return found


def _half_turns(m: Floats, odd: Floats, angle: Floats) -> Floats:
    """Near half a turn the axis is read off the symmetric part."""
    around = (m + np.swapaxes(m, -1, -2)) / 2 + np.eye(3)
    largest = np.argmax(np.diagonal(around, axis1=-2, axis2=-1), axis=-1)
    axis = np.take_along_axis(around, largest[:, None, None], axis=2)[..., 0]
    axis = axis / np.linalg.norm(axis, axis=-1, keepdims=True)
    return np.asarray(axis * np.where((axis * odd).sum(axis=-1) < 0, -angle, angle)[:, None])


def rotation_vector_rates(turns: Floats) -> Floats:
    """The matrices (..., 3, 3) that take an angular velocity to the rate of the rotation vectors `turns` (shorter than
    a turn).
    """
    w = cross_matrix(turns)
    angle = np.sqrt((turns * turns).sum(axis=-1))
    half = np.where(angle < _SMALL, 1.0, angle / 2)
    back = np.where(angle < _SMALL, 1 / 12, (1 - half / np.tan(half)) / (4 * half**2))
    return np.asarray(np.eye(3) - w / 2 + back[..., None, None] * (w @ w))


def logarithm(motions: Floats) -> Floats:
    """The twists (ω; v) whose exponentials the motions are."""
    turn = rotation_vector(motions[..., :3, :3])
    shift = (rotation_vector_rates(turn) @ motions[..., :3, 3:])[..., 0]
    return np.concatenate([turn, shift], axis=-1)


def inverse(motion: Floats) -> Floats:
    """The motion back."""
    back = np.swapaxes(motion[..., :3, :3], -1, -2)
    found = np.zeros_like(motion)
    found[..., :3, :3] = back
    found[..., :3, 3] = -(back @ motion[..., :3, 3:])[..., 0]
    found[..., 3, 3] = 1
    return found


def carried(motions: Floats, screws: Floats) -> Floats:
    """The screws (ω; v) as they stand after the motions."""
    turn = motions[..., :3, :3]
    w = (turn @ screws[..., :3, None])[..., 0]
    v = (turn @ screws[..., 3:, None])[..., 0] + crossed(motions[..., :3, 3], w)
    return np.concatenate([w, v], axis=-1)


def change_about(centre: Floats, before: Floats, after: Floats) -> Floats:
    """How motions (..., 4, 4) change: the shift of a point that was at `centre`, then the rotation vector, (..., 6)."""
    turn = rotation_vector(after[..., :3, :3] @ np.swapaxes(before[..., :3, :3], -1, -2))
    off = after - before
    return np.concatenate([off[..., :3, :3] @ centre + off[..., :3, 3], turn], axis=-1)


def changed_about(centre: Floats, before: Floats, change: Floats) -> Floats:
    """The motions after such a change."""
    found = np.zeros((*change.shape[:-1], 4, 4))
    found[..., :3, :3] = rotations(change[..., 3:]) @ before[..., :3, :3]
    place = before[..., :3, :3] @ centre + before[..., :3, 3] + change[..., :3]
    found[..., :3, 3] = place - found[..., :3, :3] @ centre
    found[..., 3, 3] = 1
    return found
