r"""Permutations of the points that take a polynomial to plus or minus itself, and orbits under them.

Exchanges of up to three pairs of points are tried. Each that is used is proved by normal forms; there may be more
symmetries, so orbits may be finer than they could be, which costs time and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import TypeVar

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.factoring.brackets import MODULUS
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint

__all__ = ["Swap", "Symmetries", "moved_row"]

_PAIRS = 3
_MOST = 20_000

_Exchange = tuple[tuple[int, int], ...]
Swap = Mapping[int, int]
T = TypeVar("T", bound=Hashable)


def moved_row(row: Row, swap: Swap) -> Row:
    """A bracket after an exchange of points."""
    return tuple(sorted(swap.get(i, i) for i in row))


class Symmetries:
    """The exchanges that are symmetries of a polynomial in normal form; each is proved when it is first used."""

    def __init__(self, poly: BracketPolynomial, *, limit: int) -> None:
        self.poly = poly
        self.limit = limit
        self._seeming = [{**dict(x), **{b: a for a, b in x}} for x in _symmetries(poly)]
        self._known: dict[int, bool] = {}

    def orbits(self, items: Sequence[T], moved: Callable[[T, Swap], T]) -> list[list[T]]:
        """Items in classes that symmetries take into each other; `moved` is an item after an exchange of points."""
        home = {item: item for item in items}
        place = {item: n for n, item in enumerate(items)}

        def root(item: T) -> T:
            while home[item] != item:
                item = home[item]
            return item

        for number, swap in enumerate(self._seeming):
            images = [(item, moved(item, swap)) for item in items]
            if any(root(a) != root(b) for a, b in images if b in home) and self._holds(number):
                for a, b in images:
                    if b in home:
                        first, second = sorted((root(a), root(b)), key=place.__getitem__)
                        home[second] = first
        classes: dict[T, list[T]] = {}
        for item in items:
            classes.setdefault(root(item), []).append(item)
        return list(classes.values())

    def _holds(self, number: int) -> bool:
        if number not in self._known:
            self._known[number] = _proved(self.poly, self._seeming[number], self.limit)
        return self._known[number]


def _symmetries(poly: BracketPolynomial) -> Iterator[_Exchange]:
    """Exchanges of pairs of points that seem to be symmetries at a random position."""
    degrees = poly.degrees() or {}
    pairs = [
        (i, j)
        for i, j in combinations(range(len(poly.points)), 2)
        if degrees.get(poly.points[i]) == degrees.get(poly.points[j]) and (i < poly.ideal) == (j < poly.ideal)
    ]
    exchanges: list[_Exchange] = []
    for size in range(1, _PAIRS + 1):
        for chosen in combinations(pairs, size):
            if len({i for pair in chosen for i in pair}) == 2 * size:
                exchanges.append(chosen)
                if len(exchanges) >= _MOST:
                    break
    if not exchanges:
        return
    (position,) = random_positions(1, len(poly.points), poly.rank, MODULUS, ideal=poly.ideal, seed=5)
    order = np.tile(np.arange(len(poly.points)), (len(exchanges), 1))
    for n, exchange in enumerate(exchanges):
        for i, j in exchange:
            order[n, i], order[n, j] = j, i
    (value,) = values(poly, position[None], MODULUS).tolist()
    for low in range(0, len(exchanges), 1000):
        checkpoint()
        moved = values(poly, position[order[low : low + 1000]], MODULUS).tolist()
        yield from (x for x, v in zip(exchanges[low : low + 1000], moved, strict=True) if v in (value, MODULUS - value))


def _proved(poly: BracketPolynomial, swap: Swap, limit: int) -> bool:
    names = tuple(poly.points[swap.get(i, i)] for i in range(len(poly.points)))
    moved = BracketPolynomial(poly.rank, names, poly.terms, poly.ideal).over(poly.points, poly.ideal)
    normal = straighten(moved, limit=limit)
    return normal in (poly, -poly)
