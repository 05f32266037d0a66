r"""Corners of a way cut off, so that its direction changes in smaller steps: Chaikin's algorithm where there is room.

Source: Chaikin, An algorithm for high-speed curve generation (Computer Graphics and Image Processing 3, 1974).
"""

from __future__ import annotations

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.space import Space

__all__ = ["rounded_corners"]

_ROUNDS = 2
_CUT = 0.25  # of the pieces beside a corner


def rounded_corners(space: Space, rows: Floats) -> Floats:
    """The way through states (N, width), each corner replaced by two where straight ways lead past it; the corners that
    come of that likewise.
    """
    found = rows
    for _ in range(_ROUNDS):
        checkpoint()
        parts = [found[:1]]
        for k in range(1, len(found) - 1):
            parts.append(_cut(space, found[k - 1 : k + 2]))
        parts.append(found[-1:])
        found = np.concatenate(parts)
    return found


def _cut(space: Space, three: Floats) -> Floats:
    """Two states in place of the middle one of three, or that one where they cannot be joined."""
    before, corner, after = (three[k : k + 1] for k in range(3))
    part = np.array([_CUT])
    first = space.gone(corner, space.between(corner, before, part))
    last = space.gone(corner, space.between(corner, after, part))
    if not (first.whole[0] and last.whole[0]):
        return corner
    past = space.gone(first.ends, last.ends)
    if not (past.whole[0] and space.alike(past.ends, last.ends)[0]):
        return corner
    return np.concatenate([first.ends, last.ends])
