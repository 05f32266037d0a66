"""Frames as 4×4 matrices, from the ways in which model files write them.

>>> frame((1, 2, 3), roll_pitch_yaw(0, 0, np.pi / 2)).round(9)[:3].tolist()
[[0.0, -1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 2.0], [0.0, 0.0, 1.0, 3.0]]
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats, exponential, rotation_vector, rotations
from gcrules.mechanisms.models.model import Vector

__all__ = [
    "about_axis",
    "angle_between",
    "euler",
    "frame",
    "from_axes",
    "from_quaternion",
    "from_z",
    "length",
    "moved",
    "roll_pitch_yaw",
    "turn_between",
    "vector",
]


def vector(v: Floats | Sequence[float]) -> Vector:
    """Three floats, with no negative zeros."""
    x, y, z = (float(c) + 0.0 for c in v)
    return x, y, z


def length(v: Floats | Sequence[float]) -> float:
    return float(np.linalg.norm(v))


def frame(at: Sequence[float] | Floats = (0, 0, 0), turn: Floats | None = None) -> Floats:
    """The frame with its origin there, and turned."""
    found = np.eye(4)
    found[:3, 3] = at
    if turn is not None:
        found[:3, :3] = turn
    return found


def about_axis(axis: Sequence[float] | Floats, angle: float) -> Floats:
    """The turn (3, 3) about an axis of length 1."""
    return np.asarray(rotations(np.asarray(axis, dtype=float) * angle))


def roll_pitch_yaw(roll: float, pitch: float, yaw: float) -> Floats:
    """Turns about x, y and z of the frame that stays, one after the other."""
    return euler((roll, pitch, yaw), "XYZ")


def euler(angles: Sequence[float] | Floats, sequence: str) -> Floats:
    """Turns one after the other: small letters are axes that turn along, capital ones those of the frame that stays."""
    found = np.eye(3)
    for angle, letter in zip(angles, sequence, strict=True):
        turn = about_axis(np.eye(3)["xyz".index(letter.lower())], angle)
        found = found @ turn if letter.islower() else turn @ found
    return found


def from_quaternion(w: float, x: float, y: float, z: float) -> Floats | None:
    """The turn of a quaternion of any length, None of that which is 0."""
    size = length((w, x, y, z))
    if size < 1e-12:
        return None
    w, x, y, z = (c / size for c in (w, x, y, z))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def from_axes(x: Floats, y: Floats) -> Floats | None:
    """The turn whose first axis is along x and whose second one is in the plane of both; None for parallel ones."""
    if length(x) < 1e-12:
        return None
    first = x / length(x)
    second = y - first * (first @ y)
    if length(second) < 1e-9 * max(length(y), 1e-300):
        return None
    second = second / length(second)
    return np.column_stack([first, second, np.cross(first, second)])


def from_z(z: Floats) -> Floats | None:
    """The smallest turn that brings the third axis there; None for no direction."""
    if length(z) < 1e-12:
        return None
    z = z / length(z)
    axis = np.cross((0, 0, 1), z)
    if length(axis) < 1e-12:
        return np.eye(3) if z[2] > 0 else about_axis((1, 0, 0), np.pi)
    return about_axis(axis / length(axis), float(np.arctan2(length(axis), z[2])))


def angle_between(a: Floats, b: Floats) -> float:
    """The angle of two axes, whose senses do not matter, from 0 to π/2."""
    return float(np.arctan2(length(np.cross(a, b)), abs(a @ b)))


def turn_between(a: Floats, b: Floats) -> float:
    """The angle of the turn from one frame to another."""
    return length(rotation_vector(a[:3, :3].T @ b[:3, :3]))


def moved(kind: str, at: Floats, axis: Floats, amount: float, pitch: float = 0.0) -> Floats:
    """The motion (4, 4) of a joint with one freedom by so much, its point and axis being there."""
    if kind == "prismatic":
        return frame(axis * amount)
    moment = np.cross(at, axis) + pitch * axis
    return np.asarray(exponential(np.concatenate([axis, moment]), amount))
