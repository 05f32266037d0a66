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
    "cross_matrix",
    "exponential",
    "inverse",
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
    found[..., 2, 1] = v[..., 0]
    found[..., 0, 2] = v[..., 1]
    found[..., 1, 0] = v[..., 2]
    return found - np.swapaxes(found, -1, -2)


def rotations(vectors: Floats) -> Floats:
    """The matrices that turn about each vector by its length (rad)."""
    screws = np.concatenate([vectors, np.zeros_like(vectors)], axis=-1)
    return exponential(screws, np.ones(np.shape(vectors)[:-1]))[..., :3, :3]


def exponential(screws: Floats, amounts: Floats | float) -> Floats:
    """The motions that the twists make in the given amounts (rad for unit turns, lengths for unit slides)."""
    turned = screws[..., :3] * np.asarray(amounts)[..., None]
    moved = screws[..., 3:] * np.asarray(amounts)[..., None]
    a = np.sqrt((turned * turned).sum(axis=-1))[..., None, None]
    small = a < _SMALL
    b = np.where(small, 1.0, a)
    sine = np.where(small, 1 - a**2 / 6, np.sin(b) / b)
    cosine = np.where(small, 0.5 - a**2 / 24, (1 - np.cos(b)) / b**2)
    rest = np.where(small, 1 / 6 - a**2 / 120, (b - np.sin(b)) / b**3)
    w = cross_matrix(turned)
    square = w @ w
    found = np.zeros((*turned.shape[:-1], 4, 4))
    found[..., :3, :3] = np.eye(3) + sine * w + cosine * square
    found[..., :3, 3] = ((np.eye(3) + cosine * w + rest * square) @ moved[..., None])[..., 0]
    found[..., 3, 3] = 1
    return found


def rotation_vector(matrix: Floats) -> Floats:
    """The axis of one rotation times its angle, from 0 to π."""
    odd = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2
    sine, cosine = float(np.linalg.norm(odd)), (float(np.trace(matrix)) - 1) / 2
    angle = float(np.arctan2(sine, cosine))
    if sine > _SMALL:
        return np.asarray(odd * (angle / sine))
    if cosine > 0:
        return np.asarray(odd * (1 + sine**2 / 6))
    # near half a turn the axis is read off the symmetric part
    around = (matrix + matrix.T) / 2 + np.eye(3)
    axis = around[:, int(np.argmax(np.diag(around)))]
    axis = axis / np.linalg.norm(axis)
    return np.asarray(axis * angle * (-1 if axis @ odd < 0 else 1))


def rotation_vector_rates(turn: Floats) -> Floats:
    """The matrix that takes an angular velocity to the rate of the rotation vector `turn` (shorter than a turn)."""
    w = cross_matrix(turn)
    return np.asarray(np.eye(3) - w / 2 + _back(float(np.linalg.norm(turn))) * (w @ w))


def _back(angle: float) -> float:
    half = angle / 2
    return 1 / 12 if angle < _SMALL else float((1 - half / np.tan(half)) / angle**2)


def logarithm(motion: Floats) -> Floats:
    """The twist (ω; v) whose exponential one motion is."""
    turn = rotation_vector(motion[:3, :3])
    return np.concatenate([turn, rotation_vector_rates(turn) @ motion[:3, 3]])


def inverse(motion: Floats) -> Floats:
    """The motion back; for stacks too."""
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
    v = (turn @ screws[..., 3:, None])[..., 0] + (cross_matrix(motions[..., :3, 3]) @ w[..., None])[..., 0]
    return np.concatenate([w, v], axis=-1)
