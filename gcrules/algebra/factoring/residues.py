r"""Exact arithmetic modulo a prime in float64 arrays, and values of bracket polynomials at random positions.

Residues are balanced (between −p/2 and p/2) and p is so small that a sum of as many products as occur anywhere stays
below 2⁵³: sums and matrix products of doubles are then exact, and the fast routines for doubles can be used.
"""

from __future__ import annotations

from functools import cache
from math import comb, isqrt

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.factoring.modular import Ints, determinants
from gcrules.core import seeds
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass

__all__ = ["Floats", "Ints", "PrimeField", "random_positions", "residues", "values"]

Floats = NDArray[np.float64]

_EXACT = 2**53


@dataclass(frozen=True)
class PrimeField:
    """Arithmetic modulo the prime `p`."""

    p: int

    def reduced(self, x: Floats) -> Floats:
        """Balanced residues of whole numbers below 2⁵³ in size; 0 exactly for the multiples of p. Overwrites x."""
        quotient = x * (1.0 / self.p)
        np.rint(quotient, out=quotient)
        quotient *= self.p
        x -= quotient
        return x

    def multiples(self, x: Floats) -> tuple[Ints, Ints]:
        """The places (row, column) of the multiples of p in a matrix of whole numbers below 2⁵³ in size."""
        quotient = x * (1.0 / self.p)
        np.rint(quotient, out=quotient)
        quotient *= self.p
        rows, columns = divmod(np.flatnonzero((quotient == x).ravel()), x.shape[1])
        return rows, columns

    def inverse(self, x: Floats) -> Floats:
        """Inverses of nonzero residues, one power for all: products of neighbours are inverted first."""
        if len(x) < 2:
            return np.array([float(pow(int(v) % self.p, -1, self.p)) for v in x])
        half = len(x) // 2
        first, second = x[:half], x[half : 2 * half]
        inverted = self.inverse(self.reduced(first * second))
        rest = self.inverse(x[2 * half :])
        return np.concatenate([self.reduced(inverted * second), self.reduced(inverted * first), rest])


@cache
def residues(rank: int) -> PrimeField:
    """The arithmetic for extensors of this rank: the largest prime for which sums of 2·C(rank, rank/2) products, the
    longest that occur, are exact.
    """
    most = 2 * comb(rank, rank // 2)
    p = isqrt(4 * _EXACT // most) - 4
    while any(p % q == 0 for q in range(2, isqrt(p) + 1)):
        p -= 1
    return PrimeField(p)


def random_positions(number: int, points: int, rank: int, p: int, *, ideal: int = 0, seed: int = 0) -> Ints:
    """Random positions, shape (number, points, rank): residues 0 … p − 1, the first `ideal` points at infinity.

    The same in one run for the same seed, and such that nobody can foresee them (see `seeds`).
    """
    at = np.random.default_rng(seeds.seed("positions", seed)).integers(0, p, (number, points, rank))
    at[:, :ideal, -1] = 0
    return at


def values(poly: BracketPolynomial, at: Ints, p: int) -> Ints:
    """The values modulo p < 2³¹ of a polynomial at positions of shape (samples, points, rank): shape (samples,).

    Coefficients are whole numbers of any size, or fractions whose denominators p does not divide.
    """
    rows = sorted({row for m in poly.terms for row in m})
    if not rows:
        return np.full(len(at), sum(map(int, poly.terms.values())) % p, dtype=np.int64)
    brackets = dict(zip(rows, determinants(at, np.array(rows), p), strict=True))
    total = np.zeros(len(at), dtype=np.int64)
    for m, c in poly.terms.items():
        checkpoint()
        value = np.full(len(at), c.numerator * pow(c.denominator, -1, p) % p, dtype=np.int64)
        for row in m:
            value = value * brackets[row] % p
        total = (total + value) % p
    return total
