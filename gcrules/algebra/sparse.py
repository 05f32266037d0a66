r"""Polynomials in many variables with exact coefficients: dictionaries whose keys are monomials.

A monomial is one number, whose bit fields are the exponents, so that monomials are multiplied by adding these numbers.

    >>> ring = Ring(degree=3, limit=100)
    >>> x, y = ring.variable(0), ring.variable(1)
    >>> (x + y) * (x - y) - (x * x - y * y)
    Polynomial of 0 terms
    >>> 2 * (x * y + 1) + y
    Polynomial of 3 terms
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gcrules.core.budget import MORE_TERMS, Count, watched

__all__ = ["Polynomial", "Ring"]

Coefficient = int | Fraction

_PRODUCTS_PER_TERM = 20  # products of terms that are made for each term that may be held
_LONG = 64  # terms of a factor with each of whose products the clock is looked at


class Ring:
    """Polynomials in whose monomials no exponent exceeds `degree`, each of at most `limit` terms, made in at most
    `20 * limit` products of terms: beyond, LimitReached is raised.
    """

    def __init__(self, degree: int, limit: int) -> None:
        self.width = degree.bit_length()
        self.terms = Count(limit, "the expansion in coordinates has", "terms", MORE_TERMS)
        self.products = Count(
            _PRODUCTS_PER_TERM * limit, "the expansion in coordinates takes", "products of terms", MORE_TERMS
        )

    def variable(self, number: int) -> Polynomial:
        """The variable of this number, 0 or more."""
        return Polynomial(self, {1 << (number * self.width): 1})


class Polynomial:
    """A polynomial of a ring, which numbers may be added to and multiplied with; false where it is zero."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: Ring, terms: Mapping[int, Coefficient]) -> None:
        self.ring = ring
        self.terms = terms

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __repr__(self) -> str:
        return f"Polynomial of {len(self.terms)} terms"

    def __neg__(self) -> Polynomial:
        return Polynomial(self.ring, {m: -c for m, c in self.terms.items()})

    def __add__(self, other: Polynomial | Coefficient) -> Polynomial:
        more = other.terms if isinstance(other, Polynomial) else {0: other} if other else {}
        few, many = sorted((self.terms, more), key=len)
        found = dict(many)
        for m, c in watched(few.items(), 1_000):
            value = found.get(m, 0) + c
            if value:
                found[m] = value
            else:
                del found[m]
        self.ring.terms.check(len(found))
        return Polynomial(self.ring, found)

    __radd__ = __add__

    def __sub__(self, other: Polynomial | Coefficient) -> Polynomial:
        return self + -other

    def __rsub__(self, other: Polynomial | Coefficient) -> Polynomial:
        return other + -self

    def __mul__(self, other: Polynomial | Coefficient) -> Polynomial:
        if not isinstance(other, Polynomial):
            return Polynomial(self.ring, {m: c * other for m, c in self.terms.items()} if other else {})
        few, many = sorted((self.terms, other.terms), key=len)
        self.ring.products.spend(len(few) * len(many))
        found: dict[int, Coefficient] = {}
        for m, c in watched(few.items(), 1 if len(many) > _LONG else _LONG):
            for n, d in many.items():
                found[m + n] = found.get(m + n, 0) + c * d
            self.ring.terms.check(len(found))
        return Polynomial(self.ring, {m: c for m, c in found.items() if c})

    __rmul__ = __mul__
