"""Coordinates of a pose from home: x, y, z of the platform's centre; its turn as roll, pitch, yaw or as a vector."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats, exponential, rotation_vector
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS, VECTOR

__all__ = ["coordinates", "slopes", "wrapped"]

_STEP = 1e-6


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


def slopes(names: Sequence[str], motion: Floats, centre: Floats, size: float) -> Floats:
    """How fast the coordinates change with a twist (ω; v) of the platform, (names, 6), by central differences."""
    found = np.empty((len(names), 6))
    for k, unit in enumerate(np.diag([1.0, 1.0, 1.0, size, size, size])):
        ends = [coordinates(names, exponential(unit, s * _STEP) @ motion, centre) for s in (1, -1)]
        found[:, k] = wrapped(names, ends[0] - ends[1]) / (2 * _STEP)
    return np.asarray(found / np.array([1, 1, 1, size, size, size]))


def wrapped(names: Sequence[str], differences: Floats) -> Floats:
    """Differences of angles between −π and π."""
    angle = np.array([n in ANGLES for n in names], dtype=bool)
    return np.where(angle, (differences + np.pi) % (2 * np.pi) - np.pi, differences)
