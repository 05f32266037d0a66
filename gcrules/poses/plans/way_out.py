r"""The way out of the neighbourhood of a singularity: the nearest pose with a margin that a straight way leads to.

Ways are tried in random directions, farther and farther, until one reaches the margin; then directions around the best
one are, on shorter and shorter ways. The length is that of `Space.lengths`: parts of the robot's size, and rad. It is
the shortest one that was found, which is no proof that there is no shorter one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.space import Space

__all__ = ["nearest_with_margin"]

_FIRST, _LAST, _FARTHER = 0.005, 3.0, 1.3  # lengths that are tried
_DIRECTIONS = 256
_AROUND = 64  # directions around the best one
_SHORTER = (0.7, 0.85, 0.95, 0.98, 0.995)
_SPREADS = (0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01)  # of directions around the best one
_ROUNDS = 8  # with one spread, while they lead to something


def nearest_with_margin(space: Space, start: Floats, margin: float, random: Any) -> Floats | None:
    """The state with this margin to which the shortest straight way leads, or None."""
    found = _first(space, start, margin, random)
    for spread in _SPREADS if found is not None else ():
        for _ in range(_ROUNDS):
            assert found is not None
            shorter = _shorter(space, start, margin, found[1], spread, random)
            if shorter is None:
                break
            found = shorter
    return None if found is None else found[0]


Reached = tuple[Floats, Floats]
"""A state, and the displacement to it from the start."""


def _first(space: Space, start: Floats, margin: float, random: Any) -> Reached | None:
    directions = _unit(random.normal(size=(_DIRECTIONS, space.freedoms)))
    length = _FIRST
    while length <= _LAST:
        found = _best(space, start, margin, length * directions)
        if found is not None:
            return found
        length *= _FARTHER
    return None


def _shorter(space: Space, start: Floats, margin: float, best: Floats, spread: float, random: Any) -> Reached | None:
    length = float(np.linalg.norm(best))
    around = best / length + spread * random.normal(size=(_AROUND, len(best))) / np.sqrt(len(best))
    directions = _unit(np.concatenate([best[None] / length, around]))
    return _best(space, start, margin, np.concatenate([s * length * directions for s in _SHORTER]))


def _best(space: Space, start: Floats, margin: float, displacements: Floats) -> Reached | None:
    """The nearest of the states that straight ways by displacements (K, freedoms) lead to and that have the margin."""
    checkpoint()
    starts = np.repeat(start[None], len(displacements), axis=0)
    ways = space.gone(starts, space.moved(starts, displacements))
    there = np.flatnonzero(ways.whole)
    there = there[space.margins(ways.ends[there]) >= margin] if len(there) else there
    if not len(there):
        return None
    k = there[np.argmin(np.linalg.norm(displacements[there], axis=1))]
    return ways.ends[k], displacements[k]


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
