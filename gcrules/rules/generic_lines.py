r"""Lines built from points, first treated as general lines: what is found for their two points is written back.

An identity that holds for the line through any two points u and v holds for a line L in its place, wherever u and v
occur joined only.

>>> from gcrules.algebra.language.syntax import parse
>>> line = parse(r"abc /\ def")
>>> print(written_back(parse(r"[uvgh] (gu \/ v /\ hi)"), [(("u", "v"), line)]))
[abc /\ def, g, h] * (((abc /\ def) \/ g) /\ hi)
>>> written_back(parse("[ughi]"), [(("u", "v"), line)]) is None
True
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Terms, sorted_row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Bracket, Expr, Join, Point, points_of
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.algebra.scalars import bracket
from gcrules.core.budget import checkpoint
from gcrules.rules.statement import Statement

__all__ = ["alive", "statement_of_lines", "written_back", "written_out"]

StandIns = Sequence[tuple[Leg, Expr]]


def written_back(e: Expr, stand_ins: StandIns, rank: int = 4) -> Expr | None:
    """The expression with lines in the place of their two points; None where these occur apart."""
    found = _walk(e, stand_ins, rank)
    names = {n for ends, _ in stand_ins for n in ends}
    return None if names & set(points_of(found)) else found


def _walk(e: Expr, stand_ins: StandIns, rank: int) -> Expr:
    match e:
        case Join(args=args) | Bracket(args=args):
            parts = [_walk(a, stand_ins, rank) for a in args]
            sign = 1
            for (first, second), line in stand_ins:
                if Point(first) in parts and Point(second) in parts:
                    for n in (second, first):  # to the front, past points and lines
                        at = parts.index(Point(n))
                        sign *= (-1) ** sum(p.step for p in parts[:at])
                        parts.insert(0, parts.pop(at))
                    parts[:2] = [line]
            made = ex.join(*parts, rank=rank) if isinstance(e, Join) else bracket(*parts, rank=rank)
            return ex.signed(sign, made)
        case ex.Meet(args=args, rank=r):
            factors = [_walk(a, stand_ins, rank) for a in args]
            sign = 1
            for i, f in enumerate(factors):
                if isinstance(f, ex.Product) and f.factors[0] == ex.Number(-1):
                    sign, factors[i] = -sign, ex.mul(*f.factors[1:])
            return ex.signed(sign, ex.meet(*factors, rank=r))
        case ex.Sum(terms=terms):
            return ex.add(*(_walk(t, stand_ins, rank) for t in terms), rank=rank)
        case ex.Product(factors=factors):
            return ex.mul(*(_walk(f, stand_ins, rank) for f in factors))
    return e


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
        e = _walk(e, stand_ins, 8) if names.intersection(points_of(e)) else e
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
