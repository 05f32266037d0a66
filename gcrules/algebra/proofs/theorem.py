r"""A theorem with its proof, as anyone can check it: a claim, and exchange relations that add up to it.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> found = identity("a line meets a plane", *parse_equation("ab /\\ cde == cde /\\ ab"))
>>> found.to_json()["claim"]
[['meet', ['join', 'a', 'b'], ['join', 'c', 'd', 'e']], ['meet', ['join', 'c', 'd', 'e'], ['join', 'a', 'b']]]
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.bracket import Coefficient, Monomial, Terms, sorted_row, tableau_order
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import ZERO, Dotted, Expr, Number, Point, Power, common_rank, neg, points_of, sub
from gcrules.algebra.proofs.relations import Relation, relations
from gcrules.algebra.scalars import written_out
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["Theorem", "identity"]

_SHALLOW = 2  # joins and brackets of points are written each time


@dataclass(frozen=True)
class Theorem:
    """`left` == `right` at all positions of the points: those of `order`, of which the first `ideal` are at infinity,
    and those that are constructed from them. The difference of both sides, closed by further points where it is no
    scalar, is the sum of `relations`, whose rows are numbers of points in this order.
    """

    name: str
    rank: int
    left: Expr
    right: Expr
    order: tuple[str, ...]
    ideal: int
    relations: tuple[Relation, ...]

    @property
    def size(self) -> int:
        """How many exchanges the proof takes."""
        return sum(len(r.multiplier) for r in self.relations)

    def to_json(self) -> dict[str, Any]:
        """`{name, rank, points, ideal, definitions, claim, relations}`, as `proof.schema.json` describes it."""
        written = _Written((self.left, self.right))
        claim = [written.of(self.left), written.of(self.right)]
        return {
            "name": self.name,
            "rank": self.rank,
            "points": list(self.order),
            "ideal": self.ideal,
            "definitions": written.definitions,
            "claim": claim,
            "relations": [
                [
                    list(r.first),
                    list(r.second),
                    r.number,
                    [[_number(c), *map(list, m)] for m, c in r.multiplier.items()],
                ]
                for r in self.relations
            ],
        }


def identity(
    name: str,
    left: Expr,
    right: Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_TERMS,
) -> Theorem:
    """The proof of an identity. Raises InputError where it does not hold, LimitReached where the proof is too long."""
    rank = common_rank(rank, left, right)
    at_infinity = tuple(ideal)
    order = tableau_order(points_of(left, right), tuple(points), at_infinity)
    free = Construction(rank, order, tuple(n for n in order if n in at_infinity), points=order)
    difference = neg(right) if left == ZERO else left if right == ZERO else sub(left, right, rank=rank)
    places, moved = _by_frequency(free.closed_terms(difference, limit), len(order), free.at_infinity)
    found = relations(moved, free.at_infinity)
    if found is None:
        raise InputError(f"{name}: the sides are not equal, so there is no proof")
    return Theorem(name, rank, left, right, tuple(order[i] for i in places), free.at_infinity, found)


def _by_frequency(terms: Mapping[Monomial, Coefficient], points: int, ideal: int) -> tuple[tuple[int, ...], Terms]:
    """The numbers of the points in an order in which proofs are short, and the terms in it: those that occur often
    first, so that many rows agree in their first points; points at infinity stay before the others, those that close
    extensors behind them.
    """
    often = Counter(i for m in terms for row in m if len(row) > 1 for i in row)
    order = sorted(range(points), key=lambda i: (i >= ideal, -often[i], i))
    place = {x: n for n, x in enumerate(order)}
    moved: Terms = {}
    for m, c in terms.items():
        rows = []
        for row in m:
            sign, new = sorted_row(place.get(i, i) for i in row) if len(row) > 1 else (1, row)
            c = c * sign
            rows.append(new)
        key = tuple(sorted(rows))
        moved[key] = moved.get(key, 0) + c
    return tuple(order), moved


class _Written:
    """Expressions as lists of the operation and its parts. Larger parts that occur again are definitions: #1, #2, …"""

    def __init__(self, exprs: Iterable[Expr]) -> None:
        self.definitions: list[list[Any]] = []
        self.named: dict[Expr, str] = {}
        self.known: set[Expr] = set()
        self.again: set[Expr] = set()
        stack = list(exprs)
        while stack:
            e = stack.pop()
            if isinstance(e, Dotted):
                e = written_out(e)
            if e in self.known:
                self.again.add(e)
                continue
            self.known.add(e)
            stack += e.children

    def of(self, e: Expr) -> Any:
        if isinstance(e, Dotted):
            e = written_out(e)
        if isinstance(e, Point):
            return e.name
        if isinstance(e, Number):
            return ["number", _number(e.value)]
        if e not in self.again or e.depth <= _SHALLOW:
            return self._parts(e)
        if e not in self.named:
            parts = self._parts(e)
            self.named[e] = f"#{len(self.definitions) + 1}"
            self.definitions.append([self.named[e], parts])
        return self.named[e]

    def _parts(self, e: Expr) -> list[Any]:
        last = [e.exponent] if isinstance(e, Power) else []
        return [type(e).__name__.lower(), *map(self.of, e.children), *last]


def _number(value: Coefficient) -> int | str:
    exact = Fraction(value)
    return exact.numerator if exact.denominator == 1 else str(exact)
