"""Coordinates of a pose from home: x, y, z of the platform's centre; its turn as roll, pitch, yaw or as a vector."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats, cross_matrix, rotation_vector, rotation_vector_rates
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS, VECTOR

__all__ = ["coordinates", "slopes", "wrapped"]

_STEEPEST = 1e-12  # of cos pitch, by which is divided


def coordinates(names: Sequence[str], motion: Floats, centre: Floats) -> Floats:
    """The coordinates of these names after a motion from home."""
    shift = motion[:3, :3] @ centre + motion[:3, 3] - centre
    known = dict(zip(SHIFTS, shift, strict=True))
    r = motion[:3, :3]
    if any(n in TURNS for n in names):
        pitch = np.arctan2(-r[2, 0], np.hypot(r[0, 0], r[1, 0]))
        known |= dict(zip(TURNS, (np.arctan2(r[2, 1], r[2, 2]), pitch, np.arctan2(r[1, 0], r[0, 0])), strict=True))
    if any(n in VECTOR for n in names):
        known |= dict(zip(VECTOR, rotation_vector(r), strict=True))
    return np.array([known[n] for n in names])


def slopes(names: Sequence[str], motion: Floats, centre: Floats) -> Floats:
    """How fast the coordinates change with a twist (ω; v) of the platform, (names, 6). Where roll and yaw, or a
    rotation vector of half a turn, have no rates, some are infinite or arbitrary.
    """
    rates = np.zeros((9, 6))
    place = motion[:3, :3] @ centre + motion[:3, 3]
    rates[:3] = np.concatenate([-cross_matrix(place), np.eye(3)], axis=1)
    if any(n in TURNS for n in names):
        rates[3:6, :3] = _rates_of_angles(motion[:3, :3])
    if any(n in VECTOR for n in names):
        rates[6:, :3] = rotation_vector_rates(rotation_vector(motion[:3, :3]))
    order = (*SHIFTS, *TURNS, *VECTOR)
    return np.asarray(rates[[order.index(n) for n in names]])


def _rates_of_angles(r: Floats) -> Floats:
    """The rates of roll, pitch and yaw for an angular velocity: it is the sum of these rates times their axes."""
    yaw = np.arctan2(r[1, 0], r[0, 0])
    level = np.array([-np.sin(yaw), np.cos(yaw), 0.0])  # the axis of pitch
    steep = max(float(np.hypot(r[0, 0], r[1, 0])), _STEEPEST)  # cos pitch
    ahead = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    roll = ahead / steep
    return np.array([roll, level, [0, 0, 1] - r[2, 0] * roll])


def wrapped(names: Sequence[str], differences: Floats) -> Floats:
    """Differences of angles between −π and π."""
    angle = np.array([n in ANGLES for n in names], dtype=bool)
    return np.where(angle, (differences + np.pi) % (2 * np.pi) - np.pi, differences)
