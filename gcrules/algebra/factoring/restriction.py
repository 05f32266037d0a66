r"""A bracket polynomial on a curve of positions: a polynomial in one unknown with rational coefficients."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Bracket, Point
from gcrules.core.budget import checkpoint

__all__ = ["Position", "restricted", "value_at"]

Position = Mapping[str, tuple[int, ...]]


def restricted(poly: BracketPolynomial, curve: Callable[[int], Position], degree: int) -> Any:
    """The restriction as a sympy.Poly; `curve` gives the position for a whole parameter, along which the polynomial has
    at most this degree.
    """
    import sympy  # heavy, and needed for large polynomials only

    samples = []
    for t in range(degree + 1):
        samples.append(value_at(poly, curve(t)))
    coefficients = [sympy.Rational(c.numerator, c.denominator) for c in _interpolated(samples)]
    return sympy.Poly(coefficients[::-1], sympy.Symbol("t"))


def value_at(poly: BracketPolynomial, position: Position) -> Fraction:
    """The exact value; each bracket is evaluated once."""
    at = Evaluator(position, poly.rank)
    rows = {row for m in poly.terms for row in m}
    brackets = {row: at.value(Bracket(tuple(Point(poly.points[i]) for i in row)))[0] for row in rows}
    total = Fraction(0)
    for m, c in poly.terms.items():
        checkpoint()
        value = 1
        for row in m:
            value *= brackets[row]
        total += c * value
    return total


def _interpolated(samples: Sequence[Fraction]) -> Iterator[Fraction]:
    """The coefficients, lowest degree first, of the polynomial with these values at 0, 1, 2, … (Newton's form)."""
    differences = []
    row = list(samples)
    while row:
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
    whole = [Fraction(0)] * len(samples)
    basis = [Fraction(1)]
    for k, difference in enumerate(differences):
        for i, c in enumerate(basis):
            whole[i] += difference * c
        basis = [(a - k * b) / (k + 1) for a, b in zip([Fraction(0), *basis], [*basis, Fraction(0)], strict=True)]
    yield from whole
