r"""Permutations of the points that take a polynomial to plus or minus itself, and orbits under them.

Exchanges of up to three pairs of points are tried. Each that is used is proved by normal forms; there may be more
symmetries, so orbits may be finer than they could be, which costs time and nothing else.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Mapping, Sequence
from itertools import combinations
from typing import TypeVar

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Row, primitive
from gcrules.algebra.factoring.brackets import vanishing_pairs
from gcrules.algebra.factoring.modular import MODULUS, Ints
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.letters import marked
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached

__all__ = ["Swap", "Symmetries", "exchangeable", "exchanges", "moved_row", "sign_under"]

_PAIRS = 3
_MOST = 20_000

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
        self._seeming = exchanges(poly)
        self._known: dict[int, bool] = {}

    def orbits(self, items: Sequence[T], moved: Callable[[T, Swap], T]) -> list[list[T]]:
        """Items in classes that symmetries take into each other; `moved` is an item after an exchange of points."""
        home = {item: item for item in items}
        place = {item: n for n, item in enumerate(items)}

        def root(item: T) -> T:
            while home[item] != item:
                item = home[item]
            return item

        for number, permutation in enumerate(self._seeming.tolist()):
            swap = {i: j for i, j in enumerate(permutation) if i != j}
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
            self._known[number] = bool(sign_under(self.poly, self._seeming[number], self.limit))
        return self._known[number]


def exchanges(poly: BracketPolynomial) -> Ints:
    """Exchanges of pairs of points that seem to be symmetries at two random positions, one permutation in each row."""
    n = len(poly.points)
    often = Counter(i for row in next(iter(poly.terms), ()) for i in row)
    pairs = [
        (i, j)
        for i, j in combinations(range(n), 2)
        if 0 < often[i] == often[j] and (i < poly.ideal) == (j < poly.ideal)
    ]
    orders = []
    for size in range(1, _PAIRS + 1):
        for chosen in combinations(pairs, size):
            if len({i for pair in chosen for i in pair}) == 2 * size:
                order = np.arange(n)
                for i, j in chosen:
                    order[i], order[j] = j, i
                orders.append(order)
            if len(orders) >= _MOST:
                break
    live = np.array(orders, dtype=np.int64).reshape(-1, n)
    vanishing = np.zeros((n, n), dtype=bool)  # the pairs whose coincidence makes the polynomial vanish are permuted
    for i, j in vanishing_pairs(poly):
        vanishing[i, j] = vanishing[j, i] = True
    kept = [
        some[(vanishing[some[:, :, None], some[:, None, :]] == vanishing).all(axis=(1, 2))] for some in _blocks(live)
    ]
    live = np.concatenate(kept)
    at = random_positions(2, n, poly.rank, MODULUS, ideal=poly.ideal, seed=5)
    for position, value in zip(at, values(poly, at, MODULUS), strict=True):
        moved = np.concatenate([values(poly, position[some], MODULUS) for some in _blocks(live)])
        live = live[(moved == value) | (moved == (MODULUS - value) % MODULUS)]
    return live


def exchangeable(poly: BracketPolynomial, *, limit: int) -> tuple[tuple[tuple[str, ...], int], ...]:
    """Classes of two points or more of which any two may be exchanged, each with the sign that this brings, as far as
    the time and `limit` terms go.

    The exchanges of a with b and of b with c are proved by normal forms; that of a with c is made of them, and so has
    their sign.
    """
    home: dict[str, list[str]] = {}
    signs: dict[str, int] = {}
    degrees = poly.degrees() or {}
    try:
        normal = straighten(poly, limit=limit)
        assert isinstance(normal, BracketPolynomial)
        for one, other in combinations((n for n in poly.points if n in degrees and not marked(n)), 2):
            checkpoint()
            a, b = (home.setdefault(n, [n]) for n in (one, other))
            if a is b or degrees[one] != degrees[other]:
                continue
            order = np.arange(len(poly.points))
            i, j = poly.points.index(one), poly.points.index(other)
            order[i], order[j] = j, i
            if (i < poly.ideal) == (j < poly.ideal) and (sign := _seeming_sign(poly, order)):
                if sign_under(normal, order, limit) != sign:
                    continue
                a += b
                home.update(dict.fromkeys(b, a))
                signs.update(dict.fromkeys(a, sign))
    except LimitReached:
        pass
    classes = {id(some): some for some in home.values() if len(some) > 1}
    return tuple((tuple(some), signs[some[0]]) for some in classes.values())


def _seeming_sign(poly: BracketPolynomial, order: Ints) -> int:
    """1 or −1 where a permuted polynomial is plus or minus the polynomial at two random positions, else 0."""
    at = random_positions(2, len(poly.points), poly.rank, MODULUS, ideal=poly.ideal, seed=5)
    whole = primitive(poly)[1]
    one, other = values(whole, at, MODULUS), values(whole, at[:, order], MODULUS)
    return 1 if (one == other).all() else -1 if ((one + other) % MODULUS == 0).all() else 0


def _blocks(live: Ints) -> list[Ints]:
    return np.array_split(live, 1 + len(live) // 500)


def sign_under(poly: BracketPolynomial, permutation: Ints, limit: int) -> int:
    """1 or −1 where the permuted polynomial is plus or minus the polynomial, else 0; decided by normal forms."""
    names = tuple(poly.points[i] for i in permutation)
    moved = BracketPolynomial(poly.rank, names, poly.terms, poly.ideal).over(poly.points, poly.ideal)
    normal = straighten(moved, limit=limit)
    return 1 if normal == poly else -1 if normal == -poly else 0
