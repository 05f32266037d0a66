r"""Whether all of a box, or of a ball in it, is free of singular configurations: boxes that are proved, or halved.

Of a box that is not proved both halves along its longest side are tried. Where it is cut, a point of the region is
chosen, with a state there: every proved box that holds the point has to hold this state. So the proved boxes on both
sides of the cut are connected, and by induction all are, with the one that holds the middle of the region.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Cover", "Prover", "Tried", "covered"]

Truths = NDArray[np.bool_]

_ROOM = 1e-12  # for rounding
_SINGULAR = 1e-6  # of a margin in the middle of a box: nothing is proved around it


@dataclass(frozen=True, eq=False)
class Tried:
    """Of N boxes: what is `proved` (N,), the states in their middles (N, width), how far (N, width) those of the branch
    that is proved are from there at most, and the margins (N,) in the middles, with a sign that changes at singular
    ones; 0 where there is no configuration.
    """

    proved: Truths
    states: Floats
    reach: Floats
    margins: Floats


class Prover(Protocol):
    """Boxes of coordinates, in parts of the `weights`, around a state `start` (width,)."""

    @property
    def start(self) -> Floats: ...
    @property
    def weights(self) -> Floats: ...

    def tried(self, middles: Floats, halves: Floats, known: Floats, at: Floats) -> Tried:
        """What is proved of boxes with these middles (N, n), reaching so far (N, n); `known` are states (N, width) at
        the coordinates `at` (N, n) near by.
        """

    def led(self, known: Floats, at: Floats, to: Floats) -> Floats:
        """The states (N, width) at coordinates (N, n), not numbers where none is reached."""


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
    points, states = np.zeros((1, n)), p.start[None]  # where boxes are cut, the middle of all first
    held = [[0]]  # by each box
    count, worst, margin = 0, np.zeros(n), np.inf
    sign = 0.0
    while len(middles):
        checkpoint()
        report(f"{count:,} boxes at {scale:.3g}")
        count += len(middles)
        tried = p.tried(middles, halves, known, at)
        if sign == 0.0:
            sign = float(np.sign(tried.margins[0]))
        left = ~(tried.proved & _holds(tried, states, held))
        signed = tried.margins[left] * sign
        if len(signed):
            k = int(np.argmin(signed))
            worst, margin = middles[left][k], float(signed[k])
            if margin <= _SINGULAR or count + 2 * len(signed) > most:
                return Cover(False, count, worst, max(margin, 0.0))
        cut = _cuts(middles[left], halves[left], ball=ball)
        there = p.led(tried.states[left], middles[left], cut) if ball else tried.states[left]
        fresh = np.arange(len(points), len(points) + len(cut))
        points, states = np.concatenate([points, cut]), np.concatenate([states, there])
        before = [[*held[k], int(new)] for k, new in zip(np.flatnonzero(left), fresh, strict=True)]
        parents = middles[left]
        middles, halves, owner = _halved(parents, halves[left])
        if ball:
            near = np.linalg.norm(np.maximum(np.abs(middles) - halves, 0.0), axis=1) <= scale * (1 + _ROOM)
            middles, halves, owner = middles[near], halves[near], owner[near]
        known, at = tried.states[left][owner], parents[owner]
        held = [_inside(before[o], points, m, h) for o, m, h in zip(owner.tolist(), middles, halves, strict=True)]
    return Cover(True, count, worst, 0.0 if margin == np.inf else margin)


def _holds(tried: Tried, states: Floats, held: Sequence[Sequence[int]]) -> Truths:
    """Whether boxes hold all the states (M, width) that they have to, by their numbers."""
    owner = np.repeat(np.arange(len(held)), [len(h) for h in held])
    number = np.array([k for h in held for k in h], dtype=np.intp)
    inside = (np.abs(states[number] - tried.states[owner]) <= tried.reach[owner]).all(axis=1)
    found = np.ones(len(held), dtype=bool)
    found[owner[~inside]] = False
    return found


def _inside(numbers: Sequence[int], points: Floats, middle: Floats, half: Floats) -> list[int]:
    """Those of the points, by their numbers, that lie in a box or on its border."""
    there = (np.abs(points[numbers] - middle) <= half * (1 + _ROOM) + _ROOM).all(axis=1)
    return [k for k, inside in zip(numbers, np.atleast_1d(there), strict=True) if inside]


def _cuts(middles: Floats, halves: Floats, *, ball: bool) -> Floats:
    """A point in each face along which a box is cut: its middle, of a ball the one nearest to the middle of the ball,
    which lies in it if any point of the face does.
    """
    if not ball:
        return middles
    found = np.clip(0.0, middles - halves, middles + halves)
    number, side = np.arange(len(middles)), np.argmax(halves, axis=1)
    found[number, side] = middles[number, side]
    return np.asarray(found)


def _halved(middles: Floats, halves: Floats) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Both halves of boxes along the longest side, and whose they are."""
    number = np.arange(len(middles))
    side = np.argmax(halves, axis=1)
    thin = halves.copy()
    thin[number, side] /= 2
    step = np.zeros_like(middles)
    step[number, side] = thin[number, side]
    return np.concatenate([middles - step, middles + step]), np.concatenate([thin, thin]), np.tile(number, 2)
