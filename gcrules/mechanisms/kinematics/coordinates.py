"""Coordinates of a pose from home: x, y, z of the platform's centre; its turn as roll, pitch, yaw or as a vector."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats, cross_matrix, rotation_vector, rotation_vector_rates
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS, VECTOR

__all__ = ["coordinates", "principal", "slopes", "without_rounding", "wrapped"]

_STEEPEST = 1e-12  # of cos pitch, by which is divided
_NOTHING = 1e-9  # in parts of the robot's size, or rad: loops are closed no better


def coordinates(names: Sequence[str], motions: Floats, centre: Floats) -> Floats:
    """The coordinates of these names after motions from home (..., 4, 4)."""
    r = motions[..., :3, :3]
    shift = r @ centre + motions[..., :3, 3] - centre
    known = {n: shift[..., k] for k, n in enumerate(SHIFTS)}
    if any(n in TURNS for n in names):
        known["pitch"] = np.arctan2(-r[..., 2, 0], np.hypot(r[..., 0, 0], r[..., 1, 0]))
        known["roll"], known["yaw"] = np.arctan2(r[..., 2, 1], r[..., 2, 2]), np.arctan2(r[..., 1, 0], r[..., 0, 0])
    if any(n in VECTOR for n in names):
        turn = rotation_vector(r)
        known |= {n: turn[..., k] for k, n in enumerate(VECTOR)}
    return np.stack([known[n] for n in names], axis=-1) if names else np.zeros((*motions.shape[:-2], 0))


def slopes(names: Sequence[str], motions: Floats, centre: Floats) -> Floats:
    """How fast the coordinates change with a twist (ω; v) of the platform, (..., names, 6). Where roll and yaw, or a
    rotation vector of half a turn, have no rates, some are infinite or arbitrary.
    """
    r = motions[..., :3, :3]
    rates = np.zeros((*motions.shape[:-2], 9, 6))
    rates[..., :3, :3] = -cross_matrix(r @ centre + motions[..., :3, 3])
    rates[..., :3, 3:] = np.eye(3)
    if any(n in TURNS for n in names):
        rates[..., 3:6, :3] = _rates_of_angles(r)
    if any(n in VECTOR for n in names):
        rates[..., 6:, :3] = rotation_vector_rates(rotation_vector(r))
    order = (*SHIFTS, *TURNS, *VECTOR)
    return np.asarray(rates[..., [order.index(n) for n in names], :])


def _rates_of_angles(r: Floats) -> Floats:
    """The rates of roll, pitch and yaw for an angular velocity: it is the sum of these rates times their axes."""
    yaw = np.arctan2(r[..., 1, 0], r[..., 0, 0])
    zero = np.zeros_like(yaw)
    level = np.stack([-np.sin(yaw), np.cos(yaw), zero], axis=-1)  # the axis of pitch
    steep = np.maximum(np.hypot(r[..., 0, 0], r[..., 1, 0]), _STEEPEST)  # cos pitch
    roll = np.stack([np.cos(yaw), np.sin(yaw), zero], axis=-1) / steep[..., None]
    return np.stack([roll, level, np.array([0.0, 0.0, 1.0]) - r[..., 2, 0, None] * roll], axis=-2)


def without_rounding(names: Sequence[str], values: Floats, size: float) -> Floats:
    """Coordinates of a robot of this size, those that are 0 within what the loops are closed to as 0."""
    units = np.array([size if n in SHIFTS else 1.0 for n in names])
    return np.where(np.abs(values) <= _NOTHING * units, 0.0, values)


def wrapped(names: Sequence[str], differences: Floats) -> Floats:
    """Differences of angles between −π and π."""
    angle = np.array([n in ANGLES for n in names], dtype=bool)
    return np.where(angle, principal(differences), differences)


def principal(angles: Floats) -> Floats:
    """The same angles between −π and π."""
    found: Floats = (angles + np.pi) % (2 * np.pi) - np.pi
    return found
