r"""What six legs that slide make of their rates, in many poses at once."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.amplification import Amplifications, Drives, amplifications
from gcrules.mechanisms.kinematics.transmission import Transmissions, shaken, transmitted

__all__ = ["LEGS", "amplified_by_legs"]

Floats = NDArray[np.float64]

_OF_A_LEG = 3  # joints: U, P and S

LEGS = Drives((False,) * 6, 6, (False,) * 6, plain=True, constraints=0)
"""Six legs that slide."""


def amplified_by_legs(base: Floats, ends: Floats, centres: Floats) -> Amplifications:
    """What legs from base points (6, 3) to ends (N, 6, 3) make of their rates, about centres (N, 3). Legs of no length
    apply no wrench.
    """
    along = ends - base
    lengths = np.linalg.norm(along, axis=2, keepdims=True)
    forces = along / np.where(lengths > 0, lengths, np.nan)
    arms = ends - centres[:, None]
    rows = np.concatenate([forces, np.cross(arms, forces)], axis=2)
    spread = ends - ends.mean(axis=1, keepdims=True)
    size = float(np.sqrt((spread[0] ** 2).sum(axis=1).mean()))
    found = amplifications(rows, np.zeros((len(rows), 0, 6)), LEGS, size)
    known = np.where(np.isfinite(rows), rows, 0.0)
    legs = [known[:, k : k + 1] for k in range(6)]
    bounds = shaken(legs, [[(_OF_A_LEG, leg[..., :3])] for leg in legs], range(6), size)
    inputs, outputs = np.isfinite(forces).all(axis=2).astype(float), transmitted(rows, found.twists, arms)
    passing = Transmissions(inputs, outputs, np.zeros((len(rows), 0)), *bounds)
    return replace(found, transmissions=passing)
