r"""Branch and bound over one box of poses: a tree of boxes that are free, outside, or cut once more, the largest first.

It ends where all is decided, or the share that was asked for, where a box certainly holds a singular pose, or with the
time or the number of boxes. Then the free boxes with the lowest bounds are cut, so that the least margin is known
better: a cut counts only where both halves are proved, so that nothing is lost by it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from time import monotonic

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.poses.boxes.deciding import Boxes, Decided, Decider
from gcrules.poses.boxes.ties import LOWER, highest, lowest, upwards
from gcrules.poses.boxes.trees import NEGATIVE
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED

__all__ = ["OTHER", "Search"]

Floats = NDArray[np.float64]
Places = NDArray[np.intp]

OTHER = FREE + NEGATIVE
"""The status of a free box where the determinant has not the sign that it has at home."""
_CUT = 9
_BATCH = 1024
_CLOSE = 0.9  # the least margin is known well enough where its bound is this part of it
_SIDES = 1e-6  # of a box: what it is cut by at least


class Search:
    """The tree of a box. `status` (K,), `sides` and `first` (the place of the first half) of each box, `bounds` of free
    ones; `looked` is how many were looked at; `least` is the smallest margin that a pose in the range and within the
    limits has, with its place; a pose below `margin` is no better than a singular one.
    """

    def __init__(self, decider: Decider, whole: Boxes, home: int, margin: float) -> None:
        self.decider, self.home = decider, home
        self.crossing = replace(decider, margin=margin)
        self.middles, self.halves = whole.middles.copy(), whole.halves.copy()
        self.status = np.full(1, UNDECIDED, dtype=np.int8)
        self.sides, self.first = np.zeros(1, dtype=np.intp), np.full(1, -1, dtype=np.intp)
        self.bounds = np.zeros(1)
        self.least, self.place = np.inf, np.full(whole.middles.shape[1], np.nan)
        self.crossed: int | None = None
        self.looked = 0

    # --- what is known ---

    def boxes(self, some: Places) -> Boxes:
        return Boxes(self.middles[some], self.halves[some])

    @property
    def volumes(self) -> Floats:
        """The parts of the range that boxes fill."""
        return np.asarray(np.prod(self.halves / self.halves[0], axis=1))

    def share(self, *status: int) -> float:
        """The part of the range with such a status."""
        return float(self.volumes[np.isin(self.status, status)].sum())

    @property
    def bound(self) -> float | None:
        """What the margin is at least in all free boxes; None where none is."""
        free = np.isin(self.status, (FREE, OTHER))
        return float(self.bounds[free].min()) if free.any() else None

    @property
    def leaves(self) -> Places:
        """The boxes that are not cut."""
        return np.flatnonzero(self.status != _CUT)

    def preorder(self) -> Iterator[int]:
        """All boxes, each before its halves, the lower half first."""
        waiting = [0]
        while waiting:
            k = waiting.pop()
            yield k
            if self.status[k] == _CUT:
                waiting += [int(self.first[k]) + 1, int(self.first[k])]

    def side_of(self, k: int) -> int | None:
        """The coordinate across which a box is cut; None where it is not."""
        return int(self.sides[k]) if self.status[k] == _CUT else None

    # --- growing ---

    def cut(self, some: Places, sides: Places) -> Places:
        """Cut boxes; the places of the halves."""
        halves = self.boxes(some).cut(sides)
        start = len(self.status)
        new = np.arange(start, start + len(halves))
        self.middles = np.concatenate([self.middles, halves.middles])
        self.halves = np.concatenate([self.halves, halves.halves])
        self.status = np.concatenate([self.status, np.full(len(halves), UNDECIDED, dtype=np.int8)])
        self.sides = np.concatenate([self.sides, np.zeros(len(halves), dtype=np.intp)])
        self.first = np.concatenate([self.first, np.full(len(halves), -1, dtype=np.intp)])
        self.bounds = np.concatenate([self.bounds, np.zeros(len(halves))])
        self.status[some], self.sides[some], self.first[some] = _CUT, sides, new[::2]
        return new

    def run(self, until: float, target: float, most: int) -> None:
        """Decide boxes until the moment `until` of the monotonic clock, or the share `target` or all is decided, or
        there are `most` boxes.
        """
        some = np.flatnonzero(self.status == UNDECIDED)
        while len(some):
            checkpoint()
            order = upwards(-self.volumes[some])
            now, later = some[order[:_BATCH]], some[order[_BATCH:]]
            found = self.decider.decided(self.boxes(now))
            self.looked += len(now)
            self._note(now, found)
            left = self.status[now] == UNDECIDED
            undecided = now[left]
            if self._crossing(undecided):
                return
            done = self.share(FREE, OTHER, OUTSIDE)
            report(f"{100 * done:.4g} % decided, {len(self.status):,} boxes")
            sides = found.sides[left]
            if done >= target or monotonic() >= until or len(self.status) + 2 * len(undecided) > most:
                return
            small = self._too_small(undecided, sides)
            some = np.concatenate([later, self.cut(undecided[~small], sides[~small])])

    def _too_small(self, some: Places, sides: Places) -> NDArray[np.bool_]:
        rows = np.arange(len(some))
        return np.asarray(self.halves[some][rows, sides] < _SIDES * self.halves[0][sides])

    def raise_bound(self, until: float, most: int, looks: float) -> None:
        """Cut the free boxes with the lowest bounds until the moment `until`, there are `most` boxes, so many more are
        looked at, or the least margin is known well.
        """
        last = self.looked + looks
        stuck = np.zeros(len(self.status), dtype=bool)
        while np.isfinite(self.least):
            room = min((most - len(self.status)) // 2, _BATCH)
            if monotonic() >= until or self.looked >= last or room < 1:
                return
            checkpoint()
            free = np.flatnonzero(np.isin(self.status, (FREE, OTHER)) & ~stuck)
            low = free[self.bounds[free] < _CLOSE * self.least * LOWER]
            if not len(low):
                return
            low = low[upwards(self.bounds[low])[:room]]
            sides = highest((self.halves[low] / np.asarray(self.decider.weights)).T)
            halves = self.boxes(low).cut(sides)
            found = self.decider.decided(halves)
            self.looked += len(halves)
            fine = (found.free | found.outside).reshape(-1, 2).all(axis=1)
            stuck[low[~fine]] = True
            if not fine.any():
                continue
            new, chosen = self.cut(low[fine], sides[fine]), np.repeat(fine, 2)
            stuck = np.concatenate([stuck, np.zeros(len(new), dtype=bool)])
            before = np.repeat(self.bounds[low[fine]], 2)
            self._note(new, _some(found, chosen))
            self.bounds[new] = np.maximum(self.bounds[new], before)
            report(f"least margin from {self.bound or 0.0:.4g} to {self.least:.4g}, {len(self.status):,} boxes")

    def _note(self, now: Places, found: Decided) -> None:
        free = found.free & ~found.outside
        self.status[now[free]] = np.where(found.signs[free] * self.home < 0, OTHER, FREE)
        self.status[now[found.outside]] = OUTSIDE
        self.bounds[now] = np.where(free, np.nan_to_num(found.bounds), 0.0)
        better = np.flatnonzero(free & (found.margins < self.least))
        if len(better):
            self._see(now[better], found.margins[better])

    def see(self, some: Places) -> None:
        """Look at the margins in the middles of boxes."""
        self._see(some, self.decider.margins_at(self.middles[some]))

    def _see(self, some: Places, margins: Floats) -> None:
        points = Boxes(self.middles[some], np.zeros_like(self.halves[some]))
        outside, inside = self.decider.reached(points)  # margins of poses that are not within the limits say nothing
        if not self.decider.forms.reached:  # nothing shows that a pose is reached, but that it has a closed form
            inside = ~outside
        seen = np.where(inside, np.nan_to_num(margins, nan=np.inf), np.inf)
        k = lowest(seen)
        if seen[k] < self.least * LOWER:
            self.least, self.place = float(seen[k]), self.middles[some[k]]

    def _crossing(self, some: Places) -> bool:
        """Whether one of these boxes certainly holds a singular pose, or one below the margin; it is noted then."""
        if not len(some):
            return False
        crossed = some[self.crossing.crossed(self.boxes(some))]
        if not len(crossed):
            return False
        self.crossed = int(crossed[np.argmin(self.volumes[crossed])])
        self.status[crossed] = CROSSED
        return True


def _some(found: Decided, chosen: NDArray[np.bool_]) -> Decided:
    return Decided(*(getattr(found, name)[chosen] for name in Decided.__dataclass_fields__))
