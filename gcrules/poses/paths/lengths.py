r"""Whether the legs keep to limits on all of a segment of a path: bounds of their lengths between samples.

The end of a leg on the platform moves by no more than the centre does, and by its distance from the centre times the
angle of the turn; a leg's length changes by no more than its end moves. Stretches in which that does not suffice are
halved. Derived here.
"""

from __future__ import annotations

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.paths.segment import Segment

__all__ = ["keeps_to"]

_HALVINGS = 16
_PIECES = 16
_ROUNDING = 1e-12  # of the robot's size


def keeps_to(limits: LengthLimits, s: Segment) -> bool:
    """Whether it is proved that the legs keep to them on the whole segment."""
    rig = s.rig
    reach = np.linalg.norm(rig.arms, axis=1)
    low, high = np.array(limits.low), np.array(limits.high)
    edges = np.linspace(0, 1, _PIECES + 1)
    cells = np.stack([edges[:-1], edges[1:]], axis=1)
    for _ in range(_HALVINGS):
        checkpoint()
        shift, quaternion, moved, angle = s.motion.spans(0, cells)
        ends = np.einsum("nij,kj->nki", matrices(quaternion), rig.arms)
        ends += (rig.centre_of_turns + shift)[:, None, :]
        lengths = np.linalg.norm(ends - rig.base, axis=2)
        if ((lengths < low) | (lengths > high)).any():
            return False
        room = moved[:, None] + reach * angle[:, None] + _ROUNDING * rig.size
        left = ((lengths - room < low) & (low > 0) | (lengths + room > high)).any(axis=1)
        if not left.any():
            return True
        a, b = cells[left].T
        half = (a + b) / 2
        cells = np.concatenate([np.stack([a, half], axis=1), np.stack([half, b], axis=1)])
    return False
