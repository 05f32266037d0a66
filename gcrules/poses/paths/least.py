r"""The least margin along a path with a lower bound that holds in between too: branch and bound in the parameter.

Seen from the platform a leg's direction w changes when the leg turns against it; σ, the least length of (w_i·v_i) over
twists with Σ |v_i|² = 1, changes by no more than the largest |w_i − w′_i| = 2 sin(turn/2). A leg of length l whose end
moves by x < l turns by at most asin(x/l), and turning the platform by φ adds φ; x ≤ d + rφ for an end at the distance r
from the centre, which moves by d. Derived here, from the proofs in docs/pose.md.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.many import CHUNK
from gcrules.poses.paths.motions import Motions
from gcrules.poses.paths.segments import Segments
from gcrules.screws.guarantees import ROUNDING, noise
from gcrules.screws.margin import jacobian

__all__ = ["CLOSEST", "MOST", "Least", "aim_of", "least"]

Floats = NDArray[np.float64]

MOST = 40_000
"""Poses that are looked at, at most, to prove the bound."""

CLOSEST = 1e-4
"""How close the margin that is asked for may be to the least one that was met, in parts of it, to be proved."""

_NEAR = 0.99  # the bound is driven up to this times the least margin that was met
_ROUNDING = 1e-12


@dataclass(frozen=True)
class Least:
    """The least margin σ that was met, at `parameter`; nowhere on the path is it below `bound`, which is proved.

    `rounding` is how much σ may be wrong there by errors of the arithmetic.
    """

    margin: float
    parameter: float
    bound: float
    rounding: float = 0.0


def least(path: Segments, samples: int, most: int = MOST, asked: float = 0.0) -> Least:
    """Of the whole path, `samples` pieces of each segment to begin with. The margin `asked` for is proved where that is
    possible.
    """
    rig, motions = path.rig, path.motions
    edges = np.linspace(0, 1, samples + 1)
    numbers = np.repeat(np.arange(len(path)), samples)
    cells = np.stack([numbers, np.tile(edges[:-1], len(path)), np.tile(edges[1:], len(path))], axis=1)
    most = max(most, 4 * len(cells))
    best, proved, seen = Least(np.inf, 0.0, 0.0), np.inf, 0
    while len(cells):
        checkpoint()
        sigma, low, wrong = _bounds(rig, motions, cells)
        n = int(np.argmin(sigma))
        if sigma[n] < best.margin:
            best = Least(float(sigma[n]), float(cells[n, 0] + cells[n, 1:].mean()), 0.0, float(wrong[n]))
        seen += len(cells)
        wanted = aim_of(best.margin, asked, _NEAR)
        done = (low >= wanted) | (best.margin <= best.rounding)
        if seen + 2 * int((~done).sum()) > most:
            done[:] = True
        proved = min(proved, float(low[done].min(initial=np.inf)))
        k, a, b = cells[~done].T
        middle = (a + b) / 2
        cells = np.concatenate([np.stack([k, a, middle], axis=1), np.stack([k, middle, b], axis=1)])
    return Least(best.margin, best.parameter, max(0.0, min(proved, best.margin)), best.rounding)


def aim_of(met: float, asked: float, near: float) -> float:
    """Up to what a bound is driven where the least margin that was met is so large: so `near` to that, and to what is
    `asked` for where it is not too close to be proved.
    """
    return max(near * met, asked if asked <= met * (1 - CLOSEST) else 0.0)


def _bounds(rig: MovingPlatform, motions: Motions, cells: Floats) -> tuple[Floats, Floats, Floats]:
    """For cells (segment, from, to): σ at the middle, a lower bound of it in the cell, what rounding may do to it."""
    parts = [_chunk(rig, motions, cells[i : i + CHUNK]) for i in range(0, len(cells), CHUNK)]
    sigma, low, wrong = (np.concatenate(p) for p in zip(*parts, strict=True))
    return sigma, low, wrong


def _chunk(rig: MovingPlatform, motions: Motions, cells: Floats) -> tuple[Floats, Floats, Floats]:
    shift, quaternion, moved, angle = motions.spans(cells[:, 0].astype(int), cells[:, 1:])
    ends = np.einsum("nij,kj->nki", matrices(quaternion), rig.arms)
    ends += (rig.centre_of_turns + shift)[:, None, :]
    lengths = np.linalg.norm(ends - rig.base, axis=2)
    whole = lengths.min(axis=1) > ROUNDING * rig.size  # where a leg has no length σ is 0
    sigma, low, wrong = np.zeros(len(cells)), np.zeros(len(cells)), np.zeros(len(cells))
    if whole.any():
        j = jacobian(rig.base, ends[whole])
        reach = np.linalg.norm(rig.arms, axis=1)
        path_of_end = moved[whole, None] + reach * angle[whole, None]
        share = path_of_end / lengths[whole]
        turn = np.where(share < 1, np.arcsin(np.minimum(share, 1)) + angle[whole, None], np.pi)
        change = 2 * np.sin(np.minimum(turn.max(axis=1), np.pi) / 2)
        sigma[whole], low[whole] = j.sigma, np.maximum(j.sigma - change - _ROUNDING, 0.0)
        wrong[whole] = noise(j, ROUNDING * rig.size)
    return sigma, low, wrong
