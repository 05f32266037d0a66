r"""All bracket monomials of one multidegree, and their values at positions modulo a prime.

Different monomials are no multiples of each other, since brackets are irreducible and different. Among points at
infinity that takes care: a bracket of d − 1 points at infinity and one finite point x is the product of the
weight of x and a determinant of one dimension less, so [ijka][lmnb] = [ijkb][lmna]; of equal monomials one is kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import combinations
from math import factorial, prod
from typing import Any

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row
from gcrules.algebra.factoring.modular import MODULUS, Ints, determinants, reduced
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Monomials", "canonical", "degree_vector"]

_NODES_PER_MONOMIAL = 20
_MOST_BRACKETS = 100  # in a monomial


def degree_vector(monomial: Monomial, points: int) -> tuple[int, ...]:
    """How often each of so many points occurs.

    >>> degree_vector(((0, 1), (0, 3)), 4)
    (2, 1, 0, 1)
    """
    found = [0] * points
    for row in monomial:
        for i in row:
            found[i] += 1
    return tuple(found)


def canonical(monomial: Monomial, ideal: int) -> Monomial | None:
    """The representative of the monomials equal to this one; None if one of its brackets vanishes.

    >>> canonical(((0, 1, 4), (1, 2, 3)), 3), canonical(((0, 1, 2), (0, 3, 4)), 3)
    (((0, 1, 3), (1, 2, 4)), None)
    """
    if any(row[-1] < ideal for row in monomial):
        return None
    split = [row for row in monomial if row[-2] < ideal]
    if len(split) < 2:
        return monomial
    others = [row for row in monomial if row[-2] >= ideal]
    heads, finite = sorted(row[:-1] for row in split), sorted(row[-1] for row in split)
    return tuple(sorted((*others, *((*head, x) for head, x in zip(heads, finite, strict=True)))))


@dataclass(frozen=True)
class Monomials:
    """All bracket monomials of the multidegree `degrees`, one of equal ones, over points of which the first `ideal`
    are at infinity.
    """

    rank: int
    degrees: tuple[int, ...]
    ideal: int
    all: tuple[Monomial, ...]

    @classmethod
    def of(cls, poly: BracketPolynomial, limit: int) -> Monomials:
        """Those of the multidegree of a homogeneous polynomial. Raises LimitReached beyond `limit`."""
        example = next(iter(poly.terms))
        if len(example) > _MOST_BRACKETS:
            raise LimitReached(f"the bracket monomials of more than {_MOST_BRACKETS} brackets are not listed")
        degrees = degree_vector(example, len(poly.points))
        found: dict[Monomial, None] = {}
        for monomial in _all(degrees, poly.rank, poly.ideal, limit):
            kept = canonical(monomial, poly.ideal)
            if kept is not None:
                found.setdefault(kept)
            if len(found) > limit:
                raise _too_many(limit)
        return cls(poly.rank, degrees, poly.ideal, tuple(found))

    def __len__(self) -> int:
        return len(self.all)

    @cached_property
    def place(self) -> dict[Monomial, int]:
        """The places of the monomials."""
        return {m: i for i, m in enumerate(self.all)}

    @cached_property
    def rows(self) -> Ints:
        """The brackets as an array: (monomial, bracket, point)."""
        return np.array(self.all, dtype=np.int64)

    @cached_property
    def brackets(self) -> tuple[Ints, Ints]:
        """The different brackets, an array (bracket, point), and which of them the monomials have."""
        different, which = np.unique(self.rows.reshape(-1, self.rank), axis=0, return_inverse=True)
        return different, which.reshape(self.rows.shape[:2])

    def values(self, at: Ints, p: int = MODULUS, chosen: Any = slice(None)) -> Ints:
        """Values modulo p, of all monomials or of those that are chosen (an index of numpy), at positions of shape
        (samples, points, rank): an array (monomial, sample).
        """
        different, which = self.brackets
        bracket = determinants(at, different, p)
        first, *others = which[chosen].T
        product: Ints = bracket[first]
        for other in others:
            product = reduced(product * bracket[other], p)
        return product

    def coefficient_bound(self) -> int:
        """No coefficient of a monomial, expanded in the coordinates of the points outside a frame, is larger: such a
        point, if it occurs m times, has its m coordinates distributed over its m brackets in at most m! ways, and
        determinants have coefficients ±1.

        The frame holds as many points as there are coordinates, which are put at the unit vectors, and one more at
        (1, …, 1); there a bracket has coefficients ±1 still. A change of coordinates and of the points' scales takes
        almost every position there and multiplies all monomials of a multidegree alike, so that nothing is lost. With
        points at infinity the frame holds these, up to d − 1, and one finite point: it must keep what is at infinity.
        """
        ideal = sorted(self.degrees[: self.ideal])
        finite = sorted(self.degrees[self.ideal :])
        if self.ideal:
            outside = [*ideal[: max(0, len(ideal) - self.rank + 1)], *finite[:-1]]
        else:
            outside = finite[: max(0, len(finite) - self.rank - 1)]
        return prod(map(factorial, outside))


def _too_many(limit: int) -> LimitReached:
    return LimitReached(
        f"the polynomial has more than {limit:,} bracket monomials of its multidegree",
        hint="raise the limit with --limit (in Python limit=...)",
    )


def _all(degrees: Sequence[int], rank: int, ideal: int, limit: int) -> Iterator[Monomial]:
    """Sorted monomials in sequence. Of the points that are left the first stands in the next bracket."""
    left = list(degrees)
    visited = 0

    def complete(least: Row, brackets: int) -> Iterator[Monomial]:
        nonlocal visited
        checkpoint()
        visited += 1
        if visited > _NODES_PER_MONOMIAL * limit:
            raise _too_many(limit)
        if not brackets:
            yield ()
            return
        if max(left) > brackets or sum(left[:ideal]) > (rank - 1) * brackets:
            return
        first = next(i for i, d in enumerate(left) if d)
        rest = [i for i in range(first + 1, len(left)) if left[i]]
        for others in combinations(rest, rank - 1):
            row = (first, *others)
            if row < least or row[-1] < ideal:
                continue
            for i in row:
                left[i] -= 1
            for below in complete(row, brackets - 1):
                yield (row, *below)
            for i in row:
                left[i] += 1

    yield from complete((), sum(degrees) // rank)
