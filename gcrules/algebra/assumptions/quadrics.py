r"""Points that an equation puts on a conic or a quadric, constructed from a point of it that is known.

Let F(p) be a scalar in which p occurs twice in each term, and F(x, y) the sum of all terms with x in one of the places
of p and y in the other, so that F(x, x) = 2 F(x). If F vanishes at another point a whatever the positions are, then
F(r) a - F(a, r) r is, for any point r, the second point of the quadric on the line ar. Where F(a, p) is not zero, each
point p of the quadric comes of r = p. Where F vanishes at no other point, fourth corners of parallelograms are tried:
equations between lengths vanish at some.

>>> from gcrules.algebra.language.syntax import parse
>>> found = quadric(parse("[abp][cdp] - 2 [acp][bdp]", rank=3), "p", 3)
>>> print(*found.known, found.polar(Point("a"), Point("r")), sep=", ")
a, b, c, d, [abr][cda] - 2[acr][bda]
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import ZERO, Expr, Number, Point, points_of
from gcrules.algebra.scalars import bracket
from gcrules.algebra.straightening.straighten import is_zero
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Quadric", "quadric"]

_MAX_TERMS = 200  # of an equation that is looked at

_Row = tuple[str, ...]
_Term = tuple[int | Fraction, _Row, _Row, tuple[_Row, ...]]


@dataclass(frozen=True)
class Quadric:
    """The equation of a point: for each term its number, the other points of the two brackets that hold the point,
    which comes last in them, and the other brackets. `known` are points, or sums of points, at which it vanishes at
    all positions.
    """

    rank: int
    terms: tuple[_Term, ...]
    known: tuple[Expr, ...] = ()

    def at(self, x: Expr) -> Expr:
        """F(x)."""
        return ex.add(*(self._term(t, x, x) for t in self.terms), rank=self.rank)

    def polar(self, x: Expr, y: Expr) -> Expr:
        """F(x, y), in brackets in which no point occurs twice."""
        both = (self._term(t, *places) for t in self.terms for places in ((x, y), (y, x)))
        return ex.add(*(e for e in both if e != ZERO), rank=self.rank)

    def parts(self, known: Expr, other: str) -> tuple[Expr, Expr]:
        """Two points whose sum is the second point on the line through a known point and another one."""
        r = Point(other)
        return ex.mul(self.at(r), known), ex.mul(Number(-1), self.polar(known, r), r)

    def passes_through(self, known: Expr, name: str) -> bool:
        """Whether it vanishes at a point at all positions, and lines through that have one more point of it in common:
        it is not a double point.
        """
        value, polar = self.at(known), self.polar(known, Point(name))
        zero = (is_zero(e, rank=self.rank, limit=_MAX_TERMS * 20) for e in (value, polar))
        return tuple(zero) == (True, False)

    def _term(self, term: _Term, x: Expr, y: Expr) -> Expr:
        number, one, two, others = term
        if any(x == Point(n) for n in one) or any(y == Point(n) for n in two):
            return ZERO
        brackets = (
            bracket(*map(Point, one), x, rank=self.rank),
            bracket(*map(Point, two), y, rank=self.rank),
            *(bracket(*map(Point, row), rank=self.rank) for row in others),
        )
        return ex.mul(Number(number), *brackets)


def quadric(e: Expr, name: str, rank: int) -> Quadric | None:
    """The equation of one point of a scalar; None where it does not occur twice in each term, and where no point at
    which it vanishes is among those of the scalar.
    """
    try:
        poly = expand(e, rank=rank, limit=_MAX_TERMS)
        if e.step or not isinstance(poly, BracketPolynomial):
            return None
        terms: list[_Term] = []
        for number, rows in poly.named():
            holding = [row for row in rows if name in row]
            if len(holding) != 2:
                return None
            sign = -1 if sum(rank - 1 - row.index(name) for row in holding) % 2 else 1
            one, two = (tuple(n for n in row if n != name) for row in holding)
            terms.append((sign * number, one, two, tuple(row for row in rows if name not in row)))
        found = Quadric(rank, tuple(terms))
        points: list[Expr] = [Point(n) for n in points_of(e) if n != name]
        known = [p for p in points if found.passes_through(p, name)]
        known = known or [p for p in _fourth_corners(found.terms, rank) if found.passes_through(p, name)]
    except LimitReached:
        return None
    return Quadric(rank, found.terms, tuple(known)) if known and terms else None


def _fourth_corners(terms: Sequence[_Term], rank: int) -> Iterator[Expr]:
    """x + y - z, where x z y are three corners of a parallelogram: of points that stand in brackets with the points at
    infinity, their weights, as equations between lengths have them.
    """
    rows = {row for *_, others in terms for row in others}
    for infinite in dict.fromkeys(one for _, one, two, _ in terms if one == two):
        finite = sorted(n for row in rows if {*infinite} < {*row} for n in row if n not in infinite)
        weight = {n: bracket(*map(Point, (*infinite, n)), rank=rank) for n in finite}
        for z in weight:
            for x, y in combinations([n for n in weight if n != z], 2):
                corners = ((x, y, z, 1), (y, z, x, 1), (z, x, y, -1))
                yield ex.add(
                    *(ex.mul(Number(sign), weight[m], weight[n], Point(p)) for p, m, n, sign in corners), rank=rank
                )
