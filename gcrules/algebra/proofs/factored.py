r"""Joins and meets of points as brackets times an extensor, up to a number, by what their parts have in common.

>>> from gcrules.algebra.language.syntax import parse
>>> print(*factored(parse(r"abc /\ abd"), 4))
[abcd] ab
>>> print(*factored(parse(r"a \/ (ab /\ cde)"), 4))
[acde] ab
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Power, Product
from gcrules.algebra.scalars import bracket

__all__ = ["factored"]


def factored(e: Expr, rank: int) -> tuple[Expr, ...]:
    """Factors of which at most the last one is an extensor; the expression itself where none are found.

    Parts that are a product give their scalars. Two joins of points that span the space have the join of the points in
    common as their meet: AB ∧ AC = [ABC] A. A hyperplane Y leaves of p ∨ (X ∧ Y) a multiple of X where p is one of the
    points of X: [pY] X. Signs are left out.
    """
    match e:
        case Product(factors=factors):
            found = [f for part in factors for f in factored(part, rank)]
            return (*(f for f in found if not f.step), *(f for f in found if f.step))
        case Power(base=base, exponent=n):
            return factored(base, rank) * n
        case Meet(args=args):
            scalars, cores = _taken(args, rank)
            return (*scalars, *_met(cores, rank))
        case Join(args=args) | Bracket(args=args):
            scalars, cores = _taken(args, rank)
            more, cores = _joined(cores, rank)
            joined = ex.join(*cores, rank=rank)
            whole = bracket(joined, rank=rank) if joined.step == rank else joined
            return (*scalars, *more, *(factored(whole, rank) if more else (whole,)))
    return (e,)


def _taken(args: Sequence[Expr], rank: int) -> tuple[list[Expr], list[Expr]]:
    """The scalars that the parts give, and what is left of each."""
    found = [factored(a, rank) for a in args]
    return [f for some in found for f in some[:-1]], [some[-1] for some in found]


def _met(cores: Sequence[Expr], rank: int) -> tuple[Expr, ...]:
    """The factors of a meet."""
    for one, other in combinations(cores, 2):
        first, second = _points(one), _points(other)
        common = [p for p in first if p in second]
        joined = list(dict.fromkeys((*first, *second)))
        if common and len(joined) == rank and len(first) + len(second) == rank + len(common):
            rest = [c for c in cores if c is not one and c is not other]
            core = ex.join(*common, rank=rank)
            scalar = bracket(*joined, rank=rank)
            return (scalar, *(factored(ex.meet(core, *rest, rank=rank), rank) if rest else (core,)))
    return (ex.meet(*cores, rank=rank),)


def _joined(cores: list[Expr], rank: int) -> tuple[list[Expr], list[Expr]]:
    """Scalars and the cores that are left, where a point is joined with a meet of something that has the point."""
    points = [p for c in cores for p in _points(c)]
    for meet in (c for c in cores if isinstance(c, Meet)):
        for Y in (a for a in meet.args if a.step == rank - 1):
            others = [a for a in meet.args if a is not Y]
            p = next((p for p in points if p not in _points(Y) and all(p in _points(a) for a in others)), None)
            if p is None:
                continue
            rest = [a for c in cores if c is not meet for a in (c.args if isinstance(c, Join) else (c,))]
            rest.remove(p)
            return [bracket(p, Y, rank=rank)], [*rest, ex.meet(*others, rank=rank)]
    return [], cores


def _points(e: Expr) -> list[Expr]:
    """Those of which it is the join; none where it is something else, or a point stands twice."""
    args = e.args if isinstance(e, Join) else (e,)
    return list(args) if all(isinstance(a, Point) for a in args) and len({*args}) == len(args) else []
