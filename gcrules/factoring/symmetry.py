r"""Permutations of the points that take a polynomial to plus or minus itself, and orbits of brackets under them.

Exchanges of up to three pairs of points are tried. Each that is used is proved by normal forms; there may be more
symmetries, so orbits may be finer than they could be, which costs time and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.straighten import straighten
from gcrules.factoring.brackets import MODULUS
from gcrules.factoring.residues import random_positions, values

__all__ = ["orbits"]

_PAIRS = 3
_MOST = 20_000

_Exchange = tuple[tuple[int, int], ...]


def orbits(poly: BracketPolynomial, rows: list[Row], *, limit: int) -> list[list[Row]]:
    """The brackets in classes that symmetries of the polynomial (in normal form) take into each other."""
    home = {row: row for row in rows}

    def root(row: Row) -> Row:
        while home[row] != row:
            row = home[row]
        return row

    for exchange in _symmetries(poly):
        swap = {**dict(exchange), **{b: a for a, b in exchange}}
        merging = [(r, tuple(sorted(swap.get(i, i) for i in r))) for r in rows]
        if any(root(r) != root(s) for r, s in merging) and _proved(poly, swap, limit):
            for r, s in merging:
                home[max(root(r), root(s))] = min(root(r), root(s))
    classes: dict[Row, list[Row]] = {}
    for row in rows:
        classes.setdefault(root(row), []).append(row)
    return list(classes.values())


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
        moved = values(poly, position[order[low : low + 1000]], MODULUS).tolist()
        yield from (x for x, v in zip(exchanges[low : low + 1000], moved, strict=True) if v in (value, MODULUS - value))


def _proved(poly: BracketPolynomial, swap: dict[int, int], limit: int) -> bool:
    names = tuple(poly.points[swap.get(i, i)] for i in range(len(poly.points)))
    moved = BracketPolynomial(poly.rank, names, poly.terms, poly.ideal).over(poly.points, poly.ideal)
    normal = straighten(moved, limit=limit)
    return normal in (poly, -poly)
