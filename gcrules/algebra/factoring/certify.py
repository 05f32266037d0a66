"""Proofs that a polynomial is a multiple of an expression, and what is said where there is none in the time."""

from __future__ import annotations

from fractions import Fraction
from itertools import count
from math import isfinite

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.evaluate import Evaluator, random_rational_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.restriction import value_at
from gcrules.algebra.straightening.straighten import is_zero
from gcrules.core.budget import seconds_left, within
from gcrules.core.errors import LimitReached
from gcrules.core.seeds import DRAWN, error_below, seed

__all__ = ["PROVED", "certified", "proved"]

PROVED = Certificate("normal-form", "both sides have the same normal form of standard tableaux")

_FURTHER = 3
_SIZE = DRAWN // 2  # coordinates of positions that decide lie between −_SIZE and _SIZE: more than DRAWN whole numbers
_SHARE = 0.8  # of the time that is left, for the proof


def proved(poly: BracketPolynomial, e: Expr, terms: int) -> int | Fraction | None:
    """The c with poly = c · e, proved by normal forms; None if there is none. Raises LimitReached."""
    c = _ratio(poly, e)
    value = expand(e, points=poly.points, ideal=poly.points[: poly.ideal], rank=poly.rank, limit=terms)
    assert isinstance(value, BracketPolynomial)
    if c is None:
        return None
    return c if is_zero(poly - value.over(poly.points, poly.ideal) * c, limit=terms) else None


def certified(poly: BracketPolynomial, e: Expr, terms: int) -> tuple[int | Fraction, Certificate]:
    """The c with poly = c · e for an expression that was found, with the proof, or with the reason why there is none.

    The proof takes most of the time that is left. Raises LimitReached where the equation does not hold after all.
    """
    left = seconds_left()
    try:
        with within(_SHARE * left if isfinite(left) else None):
            coefficient = proved(poly, e, terms)
    except LimitReached as reached:
        return _tested(poly, e, reached.message)
    if coefficient is None:
        raise LimitReached("an expression that holds at random positions has another normal form")
    return coefficient, PROVED


def _ratio(poly: BracketPolynomial, e: Expr) -> int | Fraction | None:
    """poly / e at a position where e is not 0; None where both are not in a ratio."""
    for n in count():
        value, other = _values(poly, e, n, 9 + n)
        if other:
            return Number(value / other).value if value else None
        if n > 100:  # e is zero, if anything ever was
            return None
    return None


def _tested(poly: BracketPolynomial, e: Expr, reason: str) -> tuple[int | Fraction, Certificate]:
    """The ratio at a position that nobody can foresee, the same at others."""
    claim = seed("factor", tuple(poly.terms.items()), str(e))
    ratio, *others = (_values(poly, e, claim + n, _SIZE) for n in range(_FURTHER + 1))
    if not ratio[0] or not ratio[1] or any(a * ratio[1] != b * ratio[0] for a, b in others):
        raise LimitReached("a factorization that was found does not hold at further random positions")
    letters = sum((poly.degrees() or {}).values())
    return Number(ratio[0] / ratio[1]).value, Certificate(
        "random-points",
        f"found, not proved: equal at {_FURTHER} exact random points, {error_below(letters, 0, _FURTHER)}; "
        f"no normal form: {reason}",
    )


def _values(poly: BracketPolynomial, e: Expr, number: int, size: int) -> tuple[Fraction, Fraction]:
    """Exact values at a random position."""
    ideal = poly.points[: poly.ideal]
    at = random_rational_points(poly.points, rank=poly.rank, ideal=ideal, seed=number, size=size)
    return value_at(poly, at), Fraction(Evaluator(at, poly.rank).value(e)[0])
