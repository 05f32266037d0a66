"""Lines built from points, first treated as general lines: what is found for their two points is written back."""

from __future__ import annotations

from collections.abc import Iterable

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Terms, sorted_row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.for_two_points import StandIns, put_back
from gcrules.algebra.language.legs_text import Structure
from gcrules.core.budget import checkpoint
from gcrules.rules.statement import Statement

__all__ = ["alive", "statement_of_lines", "written_out"]


def alive(e: Expr, structure: Structure) -> Expr:
    """Sums without the terms that are zero wherever the points may be, proved: two of the lines then always meet."""
    if isinstance(e, ex.Product):
        return ex.mul(*(alive(f, structure) for f in e.factors))
    if not isinstance(e, ex.Sum):
        return e
    left = [t for t in e.terms if not structure.vanishes(t)]
    return e if len(left) == len(e.terms) else ex.add(*left, rank=structure.rank)


def statement_of_lines(statement: Statement, stand_ins: StandIns) -> Statement | None:
    r"""A statement with lines in the place of their two points, alone or in a longer join; None where they stand apart.

    >>> from gcrules.algebra.language.syntax import parse
    >>> from gcrules.rules.statement import say
    >>> planes = say("the planes {} and {}", parse("au1v1"), parse("bcd"))
    >>> print(statement_of_lines(planes, [(("u1", "v1"), parse("abc ^ def"))]))
    the planes (abc /\ def) \/ a and bcd
    """
    names = {n for ends, _ in stand_ins for n in ends}

    def written(e: Expr) -> Expr:
        e = put_back(e, stand_ins, 8) if names.intersection(points_of(e)) else e
        return ex.neg(e) if str(e).startswith("-") else e

    found = statement.with_flats(written)
    return None if any(n in str(found) for n in names) else found


def written_out(poly: BracketPolynomial, stand_ins: StandIns, points: Iterable[str]) -> BracketPolynomial:
    """The polynomial with the lines written out: Σ (bracket polynomial) · xy for uv, in these points.

    It is bilinear and alternating in the two points of each line, as a superbracket is.
    """
    names = tuple(points)
    ideal = sum(n in poly.points[: poly.ideal] for n in names)
    every = (*names, *(n for ends, _ in stand_ins for n in ends))
    found = poly.over(every, ideal)
    for (first, second), line in stand_ins:
        parts = expand(line, points=names, ideal=names[:ideal])
        assert isinstance(parts, ExtensorPolynomial)
        u, v = every.index(first), every.index(second)
        terms: Terms = {}
        for row, factor in parts.parts.items():
            x, y = (every.index(parts.points[i]) for i in row)
            coefficient = factor.over(every, ideal)
            for m, c in found.terms.items():
                checkpoint()
                rows, sign = [], 1
                for old in m:
                    s, new = sorted_row({u: x, v: y}.get(i, i) for i in old)
                    sign *= s if new[-1] >= ideal else 0
                    rows.append(new)
                for n, k in coefficient.terms.items() if sign else ():
                    key = tuple(sorted((*rows, *n)))
                    terms[key] = terms.get(key, 0) + sign * c * k
        found = found.with_terms(terms)
    return found.over(names, ideal)
