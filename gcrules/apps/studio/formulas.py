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
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Number, Point, Product, Sum, neg, points_of
from gcrules.apps.studio.protocol.study_views import Monomial, Piece
from gcrules.views.formulas.latex import latex, latex_name

__all__ = ["bracket_tex", "monomials", "pieces"]

_Part = tuple[str, Expr]


def pieces(e: Expr) -> list[Piece]:
    """TeX that KaTeX renders piece by piece, with the points of each and its brackets and joins of points."""
    return [
        {"tex": tex, "points": list(points_of(part)), "brackets": [list(b) for b in dict.fromkeys(_together(part))]}
        for tex, part in _parts(e)
    ]


def _together(e: Expr) -> Iterator[tuple[str, ...]]:
    """The points that stand together in brackets, planes and lines."""
    if isinstance(e, (Bracket, Join)) and all(isinstance(c, Point) for c in e.children):
        yield points_of(e)
        return
    for child in e.children:
        yield from _together(child)


def _parts(e: Expr) -> Iterator[_Part]:
    match e:
        case Sum(terms=terms):
            for i, term in enumerate(terms):
                yield from _term(term, first=i == 0)
        case Product(factors=factors):
            yield from _factors(factors)
        case Meet(args=args):
            for i, operand in enumerate(args):
                sign = r"{}\wedge " if i else ""
                yield sign + _operand(operand), operand
        case _:
            yield latex(e), e


def _operand(e: Expr) -> str:
    bare = isinstance(e, Point) or (isinstance(e, Join) and all(isinstance(c, Point) for c in e.children))
    return latex(e) if bare else f"({latex(e)})"


def _term(term: Expr, *, first: bool) -> Iterator[_Part]:
    """A monomial is one piece; a term with sums or meets inside is broken further."""
    lead = term.factors[0] if isinstance(term, Product) else term
    negative = isinstance(lead, Number) and lead.value < 0
    if first:
        yield from _factors(term.factors) if isinstance(term, Product) else _parts(term)
        return
    shown = neg(term) if negative else term
    sign = "{}-" if negative else "{}+"
    inside = list(_factors(shown.factors)) if isinstance(shown, Product) else [(latex(shown), shown)]
    yield sign + inside[0][0], inside[0][1]
    yield from inside[1:]


def _factors(factors: tuple[Expr, ...]) -> Iterator[_Part]:
    """Brackets side by side are one piece; sums and meets stand in parentheses, piece by piece."""
    run: list[Expr] = []
    sign = ""

    def close() -> Iterator[_Part]:
        if run:
            whole = Product(tuple(run)) if len(run) > 1 else run[0]
            yield latex(whole), whole
            run.clear()

    for f in factors:
        if isinstance(f, (Sum, Meet)):
            if run == [Number(-1)]:
                sign = "-"
                run.clear()
            yield from close()
            inner = list(_parts(f))
            for i, (tex, part) in enumerate(inner):
                yield (sign + "(") * (i == 0) + tex + ")" * (i == len(inner) - 1), part
            sign = ""
        else:
            run.append(f)
    yield from close()


def bracket_tex(names: tuple[str, ...]) -> str:
    """[abcd] in TeX, words set apart."""
    shown = [latex_name(n) for n in names]
    return "[" + (r"\," if any("mathit" in s for s in shown) else "").join(shown) + "]"


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
                "brackets": [{"points": list(n), "tex": bracket_tex(n)} for n in names],
            }
        )
    return found
