r"""Six points of the plane on a conic, recognised in the equation that says so.

>>> from gcrules.algebra.language.syntax import parse
>>> six = hexagon(parse("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", rank=3), 3)
>>> print(*six, *pascal(six), sep=", ")
a, b, c, d, e, f, ab /\ de, bc /\ ef, cd /\ af
"""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, tableau_order
from gcrules.algebra.conics import on_conic
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.errors import LimitReached

__all__ = ["hexagon", "pascal"]

_MAX_TERMS = 200  # of an equation that may be that of a conic


def hexagon(e: Expr, rank: int) -> tuple[str, ...] | None:
    """The six points of a scalar that vanishes exactly where they lie on a conic, None for any other expression."""
    names = tableau_order(ex.points_of(e))
    if rank != 3 or e.step or len(names) != 6:
        return None
    try:
        poly, conic = (straighten(s, points=names, rank=3, limit=_MAX_TERMS) for s in (e, on_conic(*map(Point, names))))
    except LimitReached:
        return None
    assert isinstance(poly, BracketPolynomial)
    assert isinstance(conic, BracketPolynomial)
    if poly.terms.keys() != conic.terms.keys():
        return None
    (first, c), *_ = conic.terms.items()
    return names if (poly * c).terms == (conic * poly.terms[first]).terms else None


def pascal(six: Sequence[str]) -> tuple[Expr, Expr, Expr]:
    """The points in which opposite sides of the hexagon meet: [ab /\\ de, bc /\\ ef, cd /\\ af] vanishes exactly where
    its corners lie on a conic, by an identity between both polynomials.

    So a sixth point is constructed from five, and a line through one of them (Braikenridge, Maclaurin).
    """
    a, b, c, d, e, f = map(Point, six)
    sides = [ex.join(p, q, rank=3) for p, q in ((a, b), (d, e), (b, c), (e, f), (c, d), (a, f))]
    one, two, three = (ex.meet(*sides[i : i + 2], rank=3) for i in (0, 2, 4))
    return one, two, three
