r"""A bracket polynomial as a product of irreducible bracket polynomials, for polynomials with many letters.

The polynomial is restricted to curves of positions that all pass through two fixed positions x and y, and the
restrictions are factored over the rationals. The ratio A(y) : A(x) tells a factor A of the polynomial from the others,
so it can be followed from curve to curve: degrees along suitable curves give its multidegree, values along others its
coefficients in standard tableaux. The d points that occur most often, a frame, are the same in x and y and move only to
tell their own degrees; no factor is constant for that. What comes out is multiplied and compared with the polynomial,
which is the proof.

A restriction may have more factors than the polynomial. Then the product does not come out, and nothing is claimed.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, reduce
from math import gcd, isqrt, lcm
from operator import mul
from typing import Any

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Terms
from gcrules.algebra.factoring.brackets import solution, standard_tableaux
from gcrules.algebra.factoring.irreducible import MOST_LETTERS, frame_of
from gcrules.algebra.factoring.modular import MODULUS
from gcrules.algebra.factoring.residues import values
from gcrules.algebra.factoring.restriction import restricted
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["split"]

_SIZE = 9
_SPARE = 6
_TRIES = 8

_Position = dict[str, tuple[int, ...]]
_Ratio = Fraction


class _TooMany(Exception):
    """A factor has more standard tableaux than are solved for."""


@dataclass(frozen=True)
class _Factor:
    """A factor of the restriction to a curve: its multiplicity, degree, and coefficients, the value at x being 1."""

    multiplicity: int
    coefficients: tuple[Fraction, ...]  # lowest degree first

    @property
    def degree(self) -> int:
        return len(self.coefficients) - 1

    def __call__(self, t: int) -> Fraction:
        return reduce(lambda value, c: value * t + c, reversed(self.coefficients), Fraction(0))


def split(poly: BracketPolynomial, *, limit: int) -> list[BracketPolynomial] | None:
    """Irreducible polynomials in normal form whose product is a multiple of the polynomial (in normal form, without
    ideal points and brackets that divide it), each as often as it occurs; None where they were not found."""
    degrees = poly.degrees() or {}
    held = frame_of(degrees, poly.rank)
    if poly.ideal or sum(d for n, d in degrees.items() if n not in held) > MOST_LETTERS:
        return None
    for seed in range(_TRIES):
        checkpoint()
        try:
            found = _Splitting(poly, seed).parts()
        except _TooMany:
            return None
        if found and len(found) > 1 and _is_product(poly, found, limit):
            return found
    return None


def _is_product(poly: BracketPolynomial, parts: Sequence[BracketPolynomial], limit: int) -> bool:
    product = straighten(reduce(mul, parts), limit=limit)
    assert isinstance(product, BracketPolynomial)
    leading, c = next(iter(poly.terms.items()))
    return leading in product.terms and (product * (Fraction(c) / product.terms[leading])).terms == poly.terms


class _Splitting:
    def __init__(self, poly: BracketPolynomial, seed: int) -> None:
        self.poly = poly
        self.degrees = poly.degrees() or {}
        self.rng = random.Random(seed)
        self.held = frame_of(self.degrees, poly.rank)
        self.x = self._random()
        self.y = {n: self.x[n] if n in self.held else at for n, at in self._random().items()}

    def _random(self) -> _Position:
        return {n: tuple(self.rng.randint(-_SIZE, _SIZE) for _ in range(self.poly.rank)) for n in self.degrees}

    def parts(self) -> list[BracketPolynomial] | None:
        line = self._factors({})
        if line is None or sum(f.multiplicity for f in line.values()) < 2:
            return None
        found = []
        for ratio, factor in line.items():
            multidegree = self._multidegree(ratio, factor)
            part = multidegree and self._polynomial(ratio, factor, multidegree)
            if not part:
                return None
            found += [part] * factor.multiplicity
        return found

    @cached_property
    def _bends(self) -> dict[str, dict[_Ratio, _Factor] | None]:
        """For each point the factors along a curve on which this point alone leaves the line from x to y."""
        return {n: self._factors({n: self._random()[n]}) for n in self.degrees}

    def _multidegree(self, ratio: _Ratio, factor: _Factor) -> dict[str, int] | None:
        """A point on a curve of degree two adds its degree once more, or twice where it was held."""
        found = {}
        for n, factors in self._bends.items():
            if not factors or ratio not in factors:
                return None
            found[n], odd = divmod(factors[ratio].degree - factor.degree, 2 if n in self.held else 1)
            if odd or found[n] < 0:
                return None
        return found if sum(d for n, d in found.items() if n not in self.held) == factor.degree else None

    def _polynomial(self, ratio: _Ratio, factor: _Factor, multidegree: Mapping[str, int]) -> BracketPolynomial | None:
        """The factor in standard tableaux, whose coefficients its values determine."""
        degrees = [multidegree.get(n, 0) for n in self.poly.points]
        if sum(degrees) % self.poly.rank:
            return None
        try:
            tableaux = list(standard_tableaux(degrees, self.poly.rank, 0))
        except LimitReached as reached:
            checkpoint()
            raise _TooMany from reached
        rows: list[tuple[int, ...]] = []
        while len(rows) < len(tableaux) + _SPARE:
            bend = {n: at for n, at in self._random().items() if n not in self.held}
            factors = self._factors(bend)
            if not factors or ratio not in factors:
                return None
            at = range(-factor.degree, factor.degree + 1)
            columns = [*self._at(bend, at, tableaux), [_residue(factors[ratio](t)) for t in at]]
            rows += zip(*columns, strict=True)
        found = solution(np.array(rows, dtype=np.int64))
        return None if found is None else self._primitive(tableaux, found)

    def _at(self, bend: Mapping[str, tuple[int, ...]], at: Iterable[int], tableaux: Sequence[Monomial]) -> list[Any]:
        """For each tableau its values at positions of a curve, modulo the prime."""
        blank = (0,) * self.poly.rank
        places = [self._position(bend, t) for t in at]
        points = np.array([[place.get(n, blank) for n in self.poly.points] for place in places], dtype=np.int64)
        return [values(self.poly.with_terms({m: 1}), points % MODULUS, MODULUS).tolist() for m in tableaux]

    def _primitive(self, tableaux: Sequence[Monomial], residues: Sequence[int]) -> BracketPolynomial | None:
        """Whole coprime coefficients in the ratios of the residues."""
        leading = next((c for c in residues if c), None)
        if leading is None:
            return None
        inverse = pow(leading, -1, MODULUS)
        fractions = [_fraction(c * inverse % MODULUS) for c in residues]
        if None in fractions:
            return None
        known = [f for f in fractions if f is not None]
        scale = Fraction(lcm(*(f.denominator for f in known)), gcd(*(f.numerator for f in known)))
        terms: Terms = {m: (f * scale).numerator for m, f in zip(tableaux, known, strict=True) if f}
        return self.poly.with_terms(terms)

    def _position(self, bend: Mapping[str, tuple[int, ...]], t: int) -> _Position:
        """x + t (y − x) + t (t − 1) bend."""
        none = (0,) * self.poly.rank
        return {
            n: tuple(a + t * (b - a) + t * (t - 1) * c for a, b, c in zip(x, self.y[n], bend.get(n, none), strict=True))
            for n, x in self.x.items()
        }

    def _factors(self, bend: Mapping[str, tuple[int, ...]]) -> dict[_Ratio, _Factor] | None:
        """The factors of the restriction to a curve by their ratios at y and x; None where these do not tell them
        apart, or the restriction has not the full degree.
        """
        degree = sum(d * (2 if n in bend else n not in self.held) for n, d in self.degrees.items())
        poly = restricted(self.poly, lambda t: self._position(bend, t), degree)
        if poly.degree() < degree:
            return None
        found: dict[_Ratio, _Factor] = {}
        for part, multiplicity in poly.factor_list()[1]:
            factor = _normalised(part, multiplicity)
            if factor is None or factor(1) in found or not factor(1):
                return None
            found[factor(1)] = factor
        return found


def _residue(value: Fraction) -> int:
    return value.numerator * pow(value.denominator, -1, MODULUS) % MODULUS


def _normalised(part: Any, multiplicity: int) -> _Factor | None:
    coefficients = [Fraction(int(c.p), int(c.q)) for c in reversed(part.all_coeffs())]
    if not coefficients[0]:
        return None
    return _Factor(multiplicity, tuple(c / coefficients[0] for c in coefficients))


def _fraction(residue: int) -> Fraction | None:
    """The fraction with small numerator and denominator that a residue stands for (Euclid's algorithm)."""
    bound = isqrt(MODULUS // 2)
    r, s = (MODULUS, residue), (0, 1)
    while r[1] > bound:
        q = r[0] // r[1]
        r, s = (r[1], r[0] - q * r[1]), (s[1], s[0] - q * s[1])
    return Fraction(r[1], s[1]) if s[1] and abs(s[1]) <= bound else None
