r"""Claims whose points are written in some of their own, where exchange relations take too many terms.

Points of which nothing is asked are combinations of as many others as there are coordinates, wherever these are a
basis. Brackets of the points that are left are numbers times that of the basis, so that there is nothing to exchange.
Superbrackets of more than six lines are expanded in no other way.

>>> from gcrules.algebra.language.syntax import parse
>>> free = Construction(3, tuple("abcdef"), (), points=tuple("abcdef"))
>>> [str(step.within) for step in in_a_basis(free, parse("[abc][def]", rank=3)).steps]
['abc', 'abc', 'abc']
"""

from __future__ import annotations

from dataclasses import replace

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction, Within, step_on
from gcrules.algebra.assumptions.frame import occurrences
from gcrules.algebra.expr import Expr, Point, Superbracket, subexpressions
from gcrules.core.errors import InputError

__all__ = ["IN_A_BASIS", "has_large_superbracket", "in_a_basis"]

IN_A_BASIS = 5  # times as many terms may be made: none of them is exchanged
_RANK = 4  # the highest one in which superbrackets are polynomials in brackets to a checker


def has_large_superbracket(e: Expr) -> bool:
    """Whether it has superbrackets of more than six lines."""
    return any(isinstance(x, Superbracket) and x.rank > _RANK for x in subexpressions(e))


def in_a_basis(c: Construction, e: Expr) -> Construction:
    """The construction with its free points on the join of those at infinity and of those that an expression has most
    often. Raises InputError where more points are at infinity than may be points like the others.
    """
    fresh = {n for s in c.steps for n in s.fresh}
    ideal = [n for n in c.order[: c.at_infinity] if n not in fresh]
    free = [n for n in c.free if n not in fresh and n not in c.meets]
    if len(ideal) >= c.rank:
        raise InputError(f"{len(ideal)} points at infinity are too many to be points like the others")
    times = occurrences(free, c.steps, e)
    free.sort(key=lambda n: (n not in ideal, -times[n]))
    base, others = free[: c.rank], free[c.rank :]
    whole = ex.join(*map(Point, base), rank=c.rank)
    placed = tuple(step_on(Within(n, whole, ()), c.rank) for n in others)
    return replace(c, free=tuple(n for n in c.free if n not in others), ideal=(), steps=(*placed, *c.steps))
