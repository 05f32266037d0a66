"""Exact coefficients of a polynomial as a combination of given bracket monomials, by normal forms."""

from __future__ import annotations

from collections.abc import Iterable

from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Monomial
from gcrules.algebra.straightening.straighten import straighten_terms
from gcrules.core.linear_algebra import echelon

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
    solved, pivots = echelon(rows)
    if len(columns) in pivots:
        return None
    return normal.with_terms({columns[i]: row[-1] for i, row in zip(pivots, solved, strict=True)})


def simplicity(poly: BracketPolynomial) -> tuple[object, ...]:
    """What makes one form simpler than another: fewer terms, then smaller coefficients, then the sequence of terms."""
    sizes = sorted((max(abs(c.numerator), c.denominator) for c in poly.terms.values()), reverse=True)
    return len(poly), sizes, sum(c < 0 for c in poly.terms.values()), tuple(poly.terms)
