r"""A lower bound for the number of terms: what is left of a polynomial where points are merged.

Let P be a sum of k bracket monomials. Where some points are merged, the monomials with two of them in one bracket
vanish, and the others still add up to what P has become: at least m of them are left if that is no sum of fewer than m
monomials (m = 1 if it is not 0). A permutation of the points that takes P to ±P takes a sum to one as long, so the
same holds for all images of a merging. Let x(O) be the average number, over all symmetries, of terms in an orbit O of
monomials, and s(O) the part of O that a merging leaves; then

    Σ x(O) = k    and    Σ s(O) x(O) ≥ m    for every merging,

and the least Σ x(O) under these conditions is a lower bound for k. Any weights y ≥ 0 of mergings with Σ y s(O) ≤ 1 for
every orbit O prove Σ y m ≤ k. A further condition of the same form: not all terms are in orbits that cancel, since the
signed average of P's images under its symmetries is P. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations
from math import ceil

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.factoring.modular import MODULUS, Ints, inverse, minor, reduced
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.shortening.linear_program import maximized
from gcrules.algebra.shortening.monomials import Monomials
from gcrules.algebra.shortening.result import Merging
from gcrules.algebra.shortening.symmetry import Orbits
from gcrules.core.budget import Count
from gcrules.core.dataclass import dataclass

__all__ = ["MergingBound", "merging_bound"]

_ORBITS = 1_500
_FRONTIER = 60
_SAMPLES = 4
_DENOMINATOR = 5_040


_Blocks = tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class MergingBound:
    """No sum of fewer than `lower` monomials equals the polynomial; Σ weight · least, rounded up, is `lower`.

    `tight` says for each orbit, in the sequence of their names, whether its weights add up to 1: a sum of Σ weight ·
    least monomials would have none outside such orbits, and short sums have few.
    """

    lower: int
    conditions: tuple[Merging, ...]
    tight: tuple[bool, ...]


@dataclass(frozen=True)
class _Row:
    """A condition: how many monomials of each orbit count, and at least how many terms do."""

    counts: tuple[int, ...]
    least: int
    blocks: tuple[tuple[int, ...], ...]


def merging_bound(
    poly: BracketPolynomial, monomials: Monomials, orbits: Orbits, work: Count, enough: int
) -> MergingBound | None:
    """The bound, or None where there are too many orbits; the search ends where the bound is `enough`.

    `poly` is homogeneous and not 0. Raises LimitReached.
    """
    names, which, sizes = np.unique(orbits.label, return_inverse=True, return_counts=True)
    if len(names) > _ORBITS:
        return None
    kept = tuple(int(n) * (not c) for n, c in zip(sizes, orbits.cancels[names], strict=True))
    rows = [_Row(tuple(map(int, sizes)), 1, ()), _Row(kept, 1, ())]
    best = _best(poly, rows, sizes)
    for level in _Mergings(poly, monomials, which, sizes, work).levels():
        if best.lower >= enough:
            break
        rows += level
        best = max(best, _best(poly, rows, sizes), key=lambda bound: bound.lower)
    return best


def _best(poly: BracketPolynomial, rows: list[_Row], sizes: Ints) -> MergingBound:
    """The best weights, made fractions, and checked exactly."""
    counts = np.array([row.counts for row in rows], dtype=np.float64)
    found = maximized(np.array([float(row.least) for row in rows]), (counts / sizes).T)
    weights = [Fraction(float(y)).limit_denominator(_DENOMINATOR) for y in found]
    used = [(y, row) for y, row in zip(weights, rows, strict=True) if y]
    load = [sum(y * Fraction(row.counts[o], int(n)) for y, row in used) for o, n in enumerate(sizes)]
    most = max(*load, Fraction(1))
    used = [(y / most, row) for y, row in used]
    lower = ceil(sum(y * row.least for y, row in used))
    conditions = (
        Merging(y, row.least, tuple(tuple(poly.points[i] for i in block) for block in row.blocks)) for y, row in used
    )
    return MergingBound(lower, tuple(conditions), tuple(one == most for one in load))


class _Mergings:
    """Mergings of points, one after the other, that do not make the polynomial vanish."""

    def __init__(self, poly: BracketPolynomial, monomials: Monomials, which: Ints, sizes: Ints, work: Count) -> None:
        self.poly = poly
        self.monomials = monomials
        self.work = work
        self.order = np.argsort(which, kind="stable")
        self.starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
        n = len(poly.points)
        self.used = [i for i in range(n) if monomials.degrees[i]]
        rows = monomials.rows
        has = np.stack([(rows == i).any(axis=-1) for i in range(n)])
        self.has = has
        self.together = {(i, j): (has[i] & has[j]).any(axis=-1) for i, j in combinations(self.used, 2)}
        self.at = random_positions(_SAMPLES, n, poly.rank, MODULUS, ideal=poly.ideal, seed=11)

    def levels(self) -> Iterator[list[_Row]]:
        """Conditions that differ, level by level: each level merges two blocks more."""
        frontier: list[_Blocks] = [tuple((i,) for i in self.used)]
        seen: set[tuple[int, ...]] = set()
        while frontier:
            grown = dict.fromkeys(m for blocks in frontier for m in _merged(blocks))
            frontier, rows = [], []
            for blocks, alive in self._not_vanishing(list(grown)):
                counts = tuple(np.add.reduceat(alive[self.order].astype(np.int64), self.starts).tolist())
                if counts in seen:
                    continue
                seen.add(counts)
                rows.append(_Row(counts, self._least(blocks, alive), tuple(b for b in blocks if len(b) > 1)))
                if len(frontier) < _FRONTIER and len(blocks) > self.poly.rank:
                    frontier.append(blocks)
            yield rows

    def _not_vanishing(self, mergings: list[_Blocks]) -> Iterator[tuple[_Blocks, np.ndarray]]:
        """Those whose value at a position is not 0, with the monomials that are left."""
        for low in range(0, len(mergings), 1000):
            some = mergings[low : low + 1000]
            at = np.stack([self.at[0][self._home(blocks)] for blocks in some])
            for blocks, value in zip(some, values(self.poly, at, MODULUS).tolist(), strict=True):
                self.work.spend(len(self.monomials) // 8)
                if value:
                    yield blocks, self._alive(blocks)

    def _home(self, blocks: _Blocks) -> Ints:
        """For each point the one at which it is put: the first of its block, so one at infinity if there is one."""
        home = np.arange(len(self.poly.points))
        for block in blocks:
            home[list(block)] = block[0]
        return home

    def _alive(self, blocks: _Blocks) -> np.ndarray:
        """Which monomials have no bracket with two points of a block, nor one with points at infinity only."""
        dead = np.zeros(len(self.monomials), dtype=bool)
        if self.poly.ideal:
            finite = [i for block in blocks if block[0] >= self.poly.ideal for i in block]
            dead |= ~self.has[finite].any(axis=0).all(axis=-1)
        for block in blocks:
            for pair in combinations(block, 2):
                dead |= self.together[pair]
        return ~dead

    def _least(self, blocks: _Blocks, alive: np.ndarray) -> int:
        """How many terms are left at least: 1, or 2 or 3 if one or two monomials do not make what is left."""
        at = self.at[:, self._home(blocks)]
        value = self.monomials.values(at, chosen=alive)
        self.work.spend(value.size)
        target = values(self.poly, at, MODULUS)
        if not target[0] or not len(value):
            return 1
        x = minor(value[:, 1], target[0], value[:, 0], target[1])
        y = minor(value[:, 2], target[0], value[:, 0], target[2])
        if (x == 0).any():
            return 1
        key = reduced(y * inverse(x))
        order = np.argsort(key)
        key, value, x = key[order], value[order], x[order]
        same = key[1:] == key[:-1]
        own = minor(value[1:, 1], value[:-1, 0], value[1:, 0], value[:-1, 1])
        return 2 if (same & (own != 0)).any() else 3


def _merged(blocks: _Blocks) -> Iterator[_Blocks]:
    """All ways to merge two of the blocks."""
    for a, b in combinations(blocks, 2):
        yield tuple(sorted((*(c for c in blocks if c not in (a, b)), tuple(sorted((*a, *b))))))
