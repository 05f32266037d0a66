r"""A theorem with its proof, as anyone can check it: a claim, and exchange relations that add up to it.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> found = theorem("a line meets a plane", *parse_equation("ab /\\ cde == cde /\\ ab"))
>>> found.to_json()["claim"]
[['meet', ['join', 'a', 'b'], ['join', 'c', 'd', 'e']], ['meet', ['join', 'c', 'd', 'e'], ['join', 'a', 'b']]]
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.bracket import Coefficient, Monomial
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr, Superbracket, common_rank, points_of, subexpressions
from gcrules.algebra.proofs.coverage import Flat, flats
from gcrules.algebra.proofs.relations import MAX_RELATIONS, Relation, relations
from gcrules.algebra.proofs.written import Written, number
from gcrules.algebra.prove import difference_of
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.straightening.order import orders, reordered
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError, LimitReached

__all__ = ["PlacedPoint", "Theorem", "theorem"]

_SUPERBRACKETS = 4  # the highest rank in which the checker expands them
_SHORT = 5_000  # exchanges within which every order is tried before longer proofs are sought


@dataclass(frozen=True)
class PlacedPoint:
    """A constructed point, the extensor that it is on, fresh points of its step, and flats that show that."""

    name: str
    within: Expr
    fresh: tuple[str, ...]
    flats: tuple[Flat, ...]

    def expressions(self) -> Iterator[Expr]:
        """All that are named."""
        yield self.within
        for flat in self.flats:
            yield from flat.expressions()

    def to_json(self, written: Written) -> dict[str, Any]:
        """The point as `proof.schema.json` describes it."""
        return {
            "name": self.name,
            "on": written.of(self.within),
            "fresh": list(self.fresh),
            "flats": [flat.to_json(written) for flat in self.flats],
        }


@dataclass(frozen=True)
class Theorem:
    """`left` == `right` at all positions of the points at which the expressions of `given` vanish and those of
    `nonzero` do not.

    `placed` are the points that `given` binds, in terms of those of `order`, of which the first `ideal` are at
    infinity. Written out in these, the difference of both sides, closed by further points where it is no scalar, is the
    sum of `relations`, whose rows are numbers of points in this order.
    """

    name: str
    rank: int
    left: Expr
    right: Expr
    order: tuple[str, ...]
    ideal: int
    relations: tuple[Relation, ...]
    given: tuple[Expr, ...] = ()
    nonzero: tuple[Expr, ...] = ()
    placed: tuple[PlacedPoint, ...] = ()

    @property
    def size(self) -> int:
        """How many exchanges the proof takes."""
        return sum(len(r.multiplier) for r in self.relations)

    def to_json(self) -> dict[str, Any]:
        """The theorem as `proof.schema.json` describes it."""
        written = Written(self._expressions())
        of = written.of
        more: dict[str, Any] = {}
        if self.given:
            more = {
                "any": sorted(set(points_of(*self.given)) - {*self.order, *(p.name for p in self.placed)}),
                "given": [of(e) for e in self.given],
                "nonzero": [of(e) for e in self.nonzero],
                "placed": [p.to_json(written) for p in self.placed],
            }
        claim = [of(self.left), of(self.right)]
        return {
            "name": self.name,
            "rank": self.rank,
            "points": list(self.order),
            "ideal": self.ideal,
            "definitions": written.definitions,
            "claim": claim,
            **more,
            "relations": [
                [list(r.first), list(r.second), r.number, [[number(c), *map(list, m)] for m, c in r.multiplier.items()]]
                for r in self.relations
            ],
        }

    def _expressions(self) -> Iterator[Expr]:
        yield from (self.left, self.right, *self.given, *self.nonzero)
        for p in self.placed:
            yield from p.expressions()


def theorem(
    name: str,
    left: Expr,
    right: Expr,
    *,
    ideal: Iterable[str] = (),
    rank: int | None = None,
    given: Iterable[Assumption] = (),
    limit: int = MAX_TERMS,
) -> Theorem:
    """The proof that two expressions are equal, under assumptions where there are any.

    Raises EngineFault where they are not equal, InputError where the proof cannot be written down yet, LimitReached
    where it is too long.
    """
    assumptions, at_infinity = tuple(given), tuple(ideal)
    if any(
        isinstance(e, Superbracket) and e.rank > _SUPERBRACKETS for side in (left, right) for e in subexpressions(side)
    ):
        raise InputError(f"proof files have no superbrackets of rank {_SUPERBRACKETS + 1} or more")
    rank = common_rank(rank, left, right, *(e for a in assumptions for e in a.args))
    difference = difference_of(left, right, rank)
    found = kinds(Space(rank, (), at_infinity, assumptions), points_of(left, right), (difference,))
    if len(found) > 1:
        raise InputError(f"the assumptions allow {len(found)} kinds of positions, of which no proof is written")
    c = found[0].construction
    places, proof = _shortest(c.closed_terms(difference, limit, as_defined=True), len(c.order), c.at_infinity)
    order = tuple(c.order[i] for i in places)
    return Theorem(name, rank, left, right, order, c.at_infinity, proof, c.equations, c.nonzero, tuple(_placed(c)))


def _placed(c: Construction) -> Iterator[PlacedPoint]:
    for step in c.steps:
        found = None if step.exact else flats(step, c)
        if found is None:
            raise InputError(f"that {step.name} is on {step.within} does not follow from one assumption")
        yield PlacedPoint(step.name, step.within, step.fresh, found)


def _shortest(
    terms: Mapping[Monomial, Coefficient], points: int, ideal: int
) -> tuple[tuple[int, ...], tuple[Relation, ...]]:
    """The shortest proof that terms add up to nothing among those in some orders of the points, and its order; points
    at infinity stay before the others, those that close extensors behind them. Raises EngineFault where they do not add
    up to nothing, LimitReached where the proof is too long in every order.
    """
    for most in (_SHORT, MAX_RELATIONS):
        found = []
        reached: LimitReached | None = None
        for order in orders(terms, points, ideal):
            try:
                proof = relations(reordered(terms, order), ideal, most)
            except LimitReached as limited:
                reached = limited
                continue
            if proof is None:
                raise EngineFault("there is no proof of equality: the sides are not equal")
            found.append((sum(len(r.multiplier) for r in proof), order, proof))
        if found:
            return min(found, key=lambda one: one[0])[1:]
    assert reached is not None
    raise reached
