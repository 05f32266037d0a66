r"""Formulas in pieces: one for each monomial, factor or operand, so that a page can break and point at them.

>>> from gcrules.algebra.language.syntax import parse
>>> [p["tex"] for p in pieces(parse(r"-[abcd][efgh] + [abce][dfgh]"))]
['-[abcd][efgh]', '{}+[abce][dfgh]']
>>> [p["tex"] for p in pieces(parse(r"abc /\ aef /\ bdf /\ cde"))]
['abc', '{}\\wedge aef', '{}\\wedge bdf', '{}\\wedge cde']
"""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Bracket, Expr, Join, Point, points_of
from gcrules.apps.studio.protocol.study_views import Monomial, Piece
from gcrules.views.formulas.latex import latex, latex_parts

__all__ = ["monomials", "pieces"]


def pieces(e: Expr) -> list[Piece]:
    """TeX that KaTeX renders piece by piece, with the points of each and its brackets and joins of points."""
    return [
        {"tex": tex, "points": list(points_of(part)), "brackets": [list(b) for b in dict.fromkeys(_together(part))]}
        for tex, part in latex_parts(e)
    ]


def _together(e: Expr) -> Iterator[tuple[str, ...]]:
    """The points that stand together in brackets, planes and lines."""
    if isinstance(e, (Bracket, Join)) and all(isinstance(c, Point) for c in e.children):
        yield points_of(e)
        return
    for child in e.children:
        yield from _together(child)


def monomials(poly: BracketPolynomial, sign: int = 1) -> list[Monomial]:
    """The terms of a bracket polynomial as a table of brackets."""
    found: list[Monomial] = []
    for rows, c in poly.terms.items():
        names = [tuple(poly.points[i] for i in row) for row in rows]
        size = abs(c)
        found.append(
            {
                "sign": 1 if c * sign > 0 else -1,
                "coefficient": "" if size == 1 else str(size),
                "brackets": [{"points": list(n), "tex": latex(Bracket(tuple(map(Point, n))))} for n in names],
            }
        )
    return found
