"""Exact coefficients of a polynomial as a combination of given bracket monomials, by normal forms."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Monomial
from gcrules.algebra.straighten import straighten_terms

__all__ = ["combination", "simplicity"]


def combination(normal: BracketPolynomial, monomials: Iterable[Monomial], limit: int) -> BracketPolynomial | None:
    """The combination of the monomials that equals a polynomial in normal form; None if there is none.

    The monomials' normal forms are the columns of a system of linear equations over the rationals. Raises LimitReached.
    """
    columns = list(monomials)
    forms = [straighten_terms({m: 1}, normal.ideal, limit) for m in columns]
    rows: list[list[Coefficient]] = [
        [*(form.get(tableau, 0) for form in forms), normal.terms.get(tableau, 0)]
        for tableau in dict.fromkeys(t for form in (*forms, normal.terms) for t in form)
    ]
    solved: list[list[Fraction]] = []
    pivots: list[int] = []
    for row in rows:
        left = [Fraction(x) for x in row]
        for pivot, one in zip(pivots, solved, strict=True):
            if left[pivot]:
                factor = left[pivot]
                left = [x - factor * y for x, y in zip(left, one, strict=True)]
        place = next((i for i, x in enumerate(left) if x), None)
        if place is None:
            continue
        if place == len(columns):
            return None
        left = [x / left[place] for x in left]
        for n, one in enumerate(solved):
            if one[place]:
                factor = one[place]
                solved[n] = [x - factor * y for x, y in zip(one, left, strict=True)]
        solved.append(left)
        pivots.append(place)
    return normal.with_terms({columns[i]: one[-1] for i, one in zip(pivots, solved, strict=True)})


def simplicity(poly: BracketPolynomial) -> tuple[object, ...]:
    """What makes one form simpler than another: fewer terms, then smaller coefficients, then the sequence of terms."""
    sizes = sorted((max(abs(c.numerator), c.denominator) for c in poly.terms.values()), reverse=True)
    return len(poly), sizes, sum(c < 0 for c in poly.terms.values()), tuple(poly.terms)
