r"""Boxes that are halved until they are decided, as trees: a number for each box, level by level.

A box that is cut has the number 1 + k, k the coordinate across which it is cut; its halves stand on the next level,
the lower one first, in the order of the boxes that are cut. Others have `LEAF` + a status, and more where the
determinant is known to have the other sign than at home.

>>> tree = np.array([1, LEAF + FREE + NEGATIVE, 2, LEAF + OUTSIDE, LEAF + CROSSED], dtype=np.uint8)
>>> leaves = leaves_of(tree, Boxes(np.array([[0.0, 0.0]]), np.array([[1.0, 1.0]])))
>>> leaves.boxes.middles.tolist(), leaves.depths.tolist()
([[-0.5, 0.0], [0.5, -0.5], [0.5, 0.5]], [1, 2, 2])
>>> leaves.status.tolist(), leaves.negative.tolist()  # free, outside, crossed
([0, 3, 1], [True, False, False])
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.poses.boxes.deciding import Boxes, Decider
from gcrules.poses.boxes.ties import LOWER, lowest
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED

__all__ = ["LEAF", "NEGATIVE", "Leaves", "Tree", "grown", "leaves_of"]

Codes = NDArray[np.uint8]
Floats = NDArray[np.float64]

LEAF = 16
"""The number of a box that is not cut, without its status."""
NEGATIVE = 4
"""What is added where the determinant has not the sign that it has at home."""


@dataclass(frozen=True, eq=False)
class Tree:
    """The numbers of all boxes, and of free ones the least margin in a middle with that place (n,), and what the margin
    is at least in all of them; infinite and no numbers where there are none.
    """

    codes: Codes
    margin: float
    place: Floats
    bound: float


@dataclass(frozen=True, eq=False)
class Leaves:
    """The N boxes that are not cut: how often they were halved (N,), their status, and of free ones whether
    the determinant has another sign than at home.
    """

    boxes: Boxes
    depths: NDArray[np.intp]
    status: Codes
    negative: NDArray[np.bool_]

    @property
    def shares(self) -> Floats:
        """The parts (N,) of the whole that they fill."""
        return np.asarray(0.5**self.depths)


def grown(decider: Decider, whole: Boxes, most: int, home: int) -> Tree:
    """One box, halved until all is decided, or would be more than `most` boxes in all; `home` is the sign of the
    determinant at home.
    """
    boxes, levels = whole, []
    margin, place, bound = np.inf, np.full(whole.middles.shape[1], np.nan), np.inf
    count = 0
    while True:
        found = decider.decided(boxes)
        free = found.free & ~found.outside
        if free.any():
            k = lowest(np.where(free, np.nan_to_num(found.margins, nan=np.inf), np.inf))
            if found.margins[k] < margin * LOWER:
                margin, place = float(found.margins[k]), boxes.middles[k]
            bound = min(bound, float(found.bounds[free].min()))
        codes = np.full(len(boxes), LEAF + UNDECIDED, dtype=np.uint8)
        codes[free] = LEAF + FREE + NEGATIVE * (found.signs[free] * home < 0)
        codes[found.outside] = LEAF + OUTSIDE
        left = np.flatnonzero(~free & ~found.outside)
        levels.append(codes)
        if not len(left):
            break
        count += len(boxes)
        if count + 2 * len(left) > most:
            codes[left[decider.crossed(boxes[left])]] = LEAF + CROSSED
            break
        codes[left] = 1 + found.sides[left]
        boxes = boxes[left].cut(found.sides[left])
    return Tree(np.concatenate(levels), margin, place, bound)


def leaves_of(codes: Codes, whole: Boxes) -> Leaves:
    """The boxes of a tree that are not cut; numbers 0 at its end are no boxes."""
    boxes, at, depth = whole, 0, 0
    kept, depths, numbers = [], [], []
    while len(boxes):
        own = codes[at : at + len(boxes)]
        at += len(boxes)
        ends = own >= LEAF
        kept.append(boxes[ends])
        depths.append(np.full(int(ends.sum()), depth))
        numbers.append(own[ends] - LEAF)
        boxes = boxes[~ends].cut(own[~ends].astype(np.intp) - 1)
        depth += 1
    every = np.concatenate(numbers)
    found = Boxes(np.concatenate([b.middles for b in kept]), np.concatenate([b.halves for b in kept]))
    return Leaves(found, np.concatenate(depths), (every & 3).astype(np.uint8), (every & NEGATIVE).astype(bool))
