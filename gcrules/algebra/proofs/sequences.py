r"""Meets in the sequence in which they are said not to vanish: that another one does not is no identity of brackets.

>>> from gcrules.algebra.language.syntax import parse
>>> wanted = Sequences([parse(r"(ab /\ cd) \/ e", rank=3)], {"m": parse(r"cd /\ ab", rank=3)}, 3)
>>> print(wanted.of(parse(r"dc /\ ab", rank=3)))
ab /\ cd
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.expr import Expr, Join, Meet, Product, Sum, points_of, subexpressions
from gcrules.algebra.parts import substitute

__all__ = ["Sequences"]


class Sequences:
    """Of the meets in the expressions of `nonzero`; auxiliary points are `meets`."""

    def __init__(self, nonzero: Iterable[Expr], meets: Mapping[str, Expr], rank: int) -> None:
        self.meets, self.rank = meets, rank
        parts = (part for e in nonzero for part in subexpressions(e))
        self.said = {self._plain_key(part): part for part in parts if isinstance(part, Meet)}

    def of(self, e: Expr) -> Expr:
        """A meet of the same parts as one of those, in its sequence; any other expression as it is."""
        like = self.said.get(self._key(e))
        if like is None or not isinstance(e, Meet):
            return e
        if not self.meets.keys() & set(points_of(e)):
            return like
        parts = {self._key(a): a for a in e.args}
        return ex.meet(*(parts[self._plain_key(a)] for a in like.args), rank=self.rank)

    def _key(self, e: Expr) -> Any:
        return self._plain_key(substitute(e, self.meets, self.rank))

    def _plain_key(self, e: Expr) -> Any:
        """The same for joins and for meets of the same parts in any sequence, and for sums that are multiples."""
        if isinstance(e, Join | Meet):
            return (type(e).__name__, *sorted(map(self._plain_key, e.args)))
        if not isinstance(e, Sum | Product):
            return (str(e),)
        points = tuple(sorted(points_of(e)))
        closed = Construction(self.rank, points, ()).closed_terms(e, as_defined=True)
        terms = sorted((m, c) for m, c in closed.items() if c)
        shares = [(m, Fraction(c) / terms[0][1]) for m, c in terms]
        return ("sum", *points, str(shares))
