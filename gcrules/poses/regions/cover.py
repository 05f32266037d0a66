r"""Whether all of a box, or of a ball in it, is free of singular configurations: boxes that are proved, or halved.

Of a box that is not proved both halves along its longest side are tried. The middle of a box lies in each of its
halves, so a half whose proof holds the configuration in the middle of the whole hangs together with it, and by and by
with the middle of all.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Cover", "Prover", "Tried", "covered"]

Truths = NDArray[np.bool_]

_SINGULAR = 1e-6  # of a margin in the middle of a box: nothing is proved around it


@dataclass(frozen=True, eq=False)
class Tried:
    """Of N boxes: what is `proved` (N,), the states in their middles (N, width), and the margins (N,) there, with a
    sign that changes at singular ones; 0 where there is no configuration.
    """

    proved: Truths
    states: Floats
    margins: Floats


class Prover(Protocol):
    """Boxes of coordinates, in parts of the `weights`, around a state `start` (width,)."""

    @property
    def start(self) -> Floats: ...
    @property
    def weights(self) -> Floats: ...

    def tried(self, middles: Floats, halves: Floats, known: Floats, at: Floats) -> Tried:
        """What is proved of boxes with these middles (N, n), reaching so far (N, n), where the states `known`
        (N, width) at the coordinates `at` (N, n), which lie in the boxes, are on the branch that is meant.
        """


@dataclass(frozen=True, eq=False)
class Cover:
    """Whether all is `proved`, by how many `boxes`; else the coordinates and the margin in the middle of the worst box
    that is not.
    """

    proved: bool
    boxes: int
    worst: Floats
    margin: float


def covered(p: Prover, scale: float, most: int, *, ball: bool) -> Cover:
    """Whether the box of coordinates of at most `scale`, or the ball with this radius, is free; by `most` boxes."""
    n = len(p.weights)
    middles, halves = np.zeros((1, n)), np.where(p.weights > 0, scale, 0.0)[None]
    known, at = p.start[None], np.zeros((1, n))
    count, worst, margin = 0, np.zeros(n), np.inf
    sign = 0.0
    while len(middles):
        checkpoint()
        report(f"{count:,} boxes at {scale:.3g}")
        count += len(middles)
        tried = p.tried(middles, halves, known, at)
        if sign == 0.0:
            sign = float(np.sign(tried.margins[0]))
        left = ~tried.proved
        signed = tried.margins[left] * sign
        if len(signed):
            k = int(np.argmin(signed))
            worst, margin = middles[left][k], float(signed[k])
            if margin <= _SINGULAR or count + 2 * len(signed) > most:
                return Cover(False, count, worst, max(margin, 0.0))
        parents = middles[left]
        middles, halves, owner = _halved(parents, halves[left])
        known, at = tried.states[left][owner], parents[owner]
        if ball:
            near = np.linalg.norm(np.maximum(np.abs(middles) - halves, 0.0), axis=1) <= scale
            middles, halves, known, at = middles[near], halves[near], known[near], at[near]
    return Cover(True, count, worst, 0.0 if margin == np.inf else margin)


def _halved(middles: Floats, halves: Floats) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Both halves of boxes along the longest side, and whose they are."""
    number = np.arange(len(middles))
    side = np.argmax(halves, axis=1)
    thin = halves.copy()
    thin[number, side] /= 2
    step = np.zeros_like(middles)
    step[number, side] = thin[number, side]
    return np.concatenate([middles - step, middles + step]), np.concatenate([thin, thin]), np.tile(number, 2)
