"""The irreducible factors of one polynomial: brackets, and what they leave, split where it splits."""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from operator import mul

from gcrules.algebra.bracket import BracketPolynomial, Row, primitive, sorted_row
from gcrules.algebra.expr import Number
from gcrules.algebra.factoring.blocks import blocks_apart, each_point_once
from gcrules.algebra.factoring.brackets import bracket_factors
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.factoring.normal import normal
from gcrules.algebra.factoring.splitting import split
from gcrules.algebra.straightening.order import easy_order
from gcrules.core.dataclass import dataclass

__all__ = ["Decomposition", "decomposed"]


@dataclass(frozen=True)
class Decomposition:
    """number · Π brackets · Π parts, the parts with whole coprime coefficients.

    `irreducible` says whether each of the parts is known to be so; else there is one part.
    """

    number: int | Fraction
    rows: tuple[Row, ...]
    parts: tuple[BracketPolynomial, ...]
    irreducible: bool


def decomposed(poly: BracketPolynomial, limit: int) -> Decomposition:
    """The factors of a polynomial, over the points in their order; equal ones stand as often as they divide.

    Raises InputError where it is zero or not homogeneous in the points, LimitReached.
    """
    points, ideal = poly.points, poly.ideal
    content, easy = primitive(normal(poly if ideal else poly.over(easy_order(poly)), limit))
    found, rest = bracket_factors(easy, limit=limit)
    number = content
    rows = []
    for row in found:
        sign, back = sorted_row(points.index(easy.points[i]) for i in row)
        number *= sign
        rows.append(back)
    if set(rest.terms) == {()}:
        return Decomposition(Number(number * rest.terms[()]).value, tuple(sorted(rows)), (), True)
    whole = irreducible(rest)
    several = None
    if not whole and not rest.ideal and each_point_once(rest):
        several = blocks_apart(rest, limit=limit)
        whole = True if several is not None and len(several) == 1 else None
    parts = [rest] if whole else several or split(rest, limit=limit) or [rest]
    if len(parts) > 1:
        # The product of the parts is a multiple of the rest, and both have coprime coefficients.
        product = normal(reduce(mul, parts), limit)
        leading, c = next(iter(product.terms.items()))
        number = Number(number * Fraction(rest.terms[leading]) / c).value
    final = []
    for part in parts:
        factor, one = primitive(part.over(points, ideal))
        number = Number(number * factor).value
        final.append(one)
    return Decomposition(number, tuple(sorted(rows)), tuple(final), bool(whole) or len(parts) > 1)
