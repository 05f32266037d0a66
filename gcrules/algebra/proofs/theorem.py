r"""A theorem with its proof, as anyone can check it: a claim, and exchange relations that add up to it, or cases."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction, Within, step_on
from gcrules.algebra.bracket import Coefficient, Monomial
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Meet, Point, Product, Sum, points_of
from gcrules.algebra.letters import conic_of, letter_of, marked
from gcrules.algebra.proofs.basis import IN_A_BASIS, has_large_superbracket, in_a_basis
from gcrules.algebra.proofs.coverage import Flat, Multiple, equal, flats
from gcrules.algebra.proofs.relations import MAX_RELATIONS, Relation, relations
from gcrules.algebra.proofs.sequences import Sequences
from gcrules.algebra.proofs.written import Written
from gcrules.algebra.prove import difference_of
from gcrules.algebra.straightening.order import orders, reordered
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError, LimitReached
from gcrules.core.frozen import FrozenMap

__all__ = ["PlacedPoint", "Theorem", "asked", "has_part", "placed_theorem", "with_roles"]

_SHORT = 5_000  # exchanges within which every order is tried before longer proofs are sought


@dataclass(frozen=True)
class PlacedPoint:
    """A constructed point, the extensor that it is on, fresh points of its step, and flats that show that; or the
    expression that it is `equal` to, and why; or any point, on the join of as many free ones as there are coordinates.
    """

    name: str
    within: Expr
    fresh: tuple[str, ...]
    flats: tuple[Flat, ...]
    equal: Multiple | None = None

    def expressions(self) -> Iterator[Expr]:
        """All that are named."""
        yield self.within
        for flat in self.flats:
            yield from flat.expressions()

    def to_json(self, written: Written, place: Mapping[str, int]) -> dict[str, Any]:
        """The point as `proof.schema.json` describes it, with the numbers of points by name."""
        return {
            "name": self.name,
            "on": written.of(self.within),
            "fresh": list(self.fresh),
            "flats": [flat.to_json(written, place) for flat in self.flats],
            **({"equal": self.equal.to_json(place)} if self.equal else {}),
        }


@dataclass(frozen=True)
class Theorem:
    """`left` == `right` at all positions of the points at which the expressions of `given` vanish and those of
    `nonzero` do not.

    `placed` are the points that `given` binds, in terms of those of `order`, of which the first `ideal` are at
    infinity. Some of both may be auxiliary: `meets` of the others that the claim does not name. Written out in these,
    the difference of both sides, closed by further points where it is no scalar, is the sum of `relations`, whose rows
    are numbers of points in this order.

    Or there are `cases` in the place of these: of what is given the first says that a product vanishes, and each of the
    others is the same claim where one of its factors does. With a `split` there are two: where it vanishes, and where
    it does not.
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
    meets: Mapping[str, Expr] = FrozenMap()
    cases: tuple[Theorem, ...] = ()
    split: Expr | None = None

    @property
    def at_once(self) -> bool:
        """Whether the left side vanishes since a part of it is given to, so that there is nothing more to prove."""
        return self.right == ZERO and not self.cases and has_part(self.left, self.given)

    @property
    def in_a_basis(self) -> bool:
        """Whether points of which nothing is asked are written in others that are a basis."""
        return any(p.within.step == self.rank for p in self.placed) or any(case.in_a_basis for case in self.cases)

    @property
    def size(self) -> int:
        """How many exchanges the proof takes."""
        return sum(len(r.multiplier) for r in self.relations) + sum(case.size for case in self.cases)

    def to_json(self, *, anywhere: list[str] | None = None) -> dict[str, Any]:
        """The theorem as `proof.schema.json` describes it; of a case those points stand for all points that do so in
        the whole theorem.
        """
        if anywhere is None and (self.given or self.placed):
            anywhere = sorted(set(points_of(*self.given)) - {*self.order, *(p.name for p in self.placed)})
        anywhere = anywhere and [n for n in anywhere if n not in self.order]
        written = Written(self._expressions())
        of = written.of
        more: dict[str, Any] = {}
        if anywhere is not None:
            points = (*self.order, *anywhere, *(p.name for p in self.placed))
            place = {n: i for i, n in enumerate(n for n in points if n not in self.meets)}
            more = {
                "any": anywhere,
                "given": [of(e) for e in self.given],
                "nonzero": [of(e) for e in self.nonzero],
                **({"meets": [[n, of(e)] for n, e in self.meets.items()]} if self.meets else {}),
                "placed": [p.to_json(written, place) for p in self.placed],
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
            "relations": [r.to_json() for r in self.relations],
            **({"split": of(self.split)} if self.split is not None else {}),
            **({"cases": [case.to_json(anywhere=anywhere) for case in self.cases]} if self.cases else {}),
        }

    def _expressions(self) -> Iterator[Expr]:
        yield from (self.left, self.right, *self.given, *self.nonzero, *self.meets.values())
        yield from () if self.split is None else (self.split,)
        for p in self.placed:
            yield from p.expressions()


def has_part(e: Expr, given: Collection[Expr]) -> bool:
    """Whether something given is a part of an expression, which vanishes with it."""
    inside = e.children if isinstance(e, Join | Meet | Bracket | Product) else ()
    return e in given or any(has_part(part, given) for part in inside)


def placed_theorem(
    name: str, left: Expr, right: Expr, c: Construction, nonzero: Iterable[Expr], limit: int = MAX_TERMS
) -> Theorem:
    """The proof that two expressions are equal at all positions to which a construction leads. `nonzero` must not
    vanish: what is `asked` for, at the least. Raises as `theorem` does.
    """
    difference = difference_of(left, right, c.rank)
    if has_large_superbracket(difference):
        return _theorem(name, left, right, in_a_basis(c, difference), nonzero, limit)
    try:
        return _theorem(name, left, right, c, nonzero, limit)
    except LimitReached as limited:
        try:
            return _theorem(name, left, right, in_a_basis(c, difference), nonzero, IN_A_BASIS * limit)
        except (InputError, LimitReached):
            raise limited from None


def _theorem(name: str, left: Expr, right: Expr, c: Construction, nonzero: Iterable[Expr], limit: int) -> Theorem:
    """The proof with the points placed as they are here."""
    said = tuple(nonzero)
    wanted = Sequences(said, {}, c.rank)
    c = replace(c, meets=FrozenMap((n, wanted.of(e)) for n, e in c.meets.items()))
    placed = tuple(_placed(c))
    closed = c.closed_terms(difference_of(left, right, c.rank), limit, as_defined=True)
    places, proof = _shortest(closed, len(c.order), c.at_infinity)
    order = tuple(c.order[i] for i in places)
    return Theorem(name, c.rank, left, right, order, c.at_infinity, proof, c.equations, said, placed, c.meets)


def asked(c: Construction) -> tuple[Expr, ...]:
    """What must not vanish so that a construction reaches every position: its extensors, and points that others are
    said to be, but for the first that is.
    """
    seen: set[str] = set()
    points: list[Expr] = []
    for step in c.steps:
        if isinstance(step.within, Point) and step.within.name in seen - c.meets.keys():
            points.append(step.within)
        seen |= {step.name, *points_of(step.within)}
    return tuple(dict.fromkeys((*c.nonzero, *points)))


def _placed(c: Construction) -> Iterator[PlacedPoint]:
    if c.meets and not c.nonzero:
        raise InputError("that all six points of a conic are reached is an argument of density, which is not written")
    for step in c.steps:
        if step.within.step == c.rank:
            yield PlacedPoint(step.name, step.within, (), ())
            continue
        if isinstance(step.within, Sum) and step.within.step == 1 and step.fresh:
            raise InputError(f"proof files do not know how {_called(step.name)} is placed on a conic or a quadric")
        why = equal(step, c) if step.exact else None
        if why is not None:
            yield PlacedPoint(step.name, step.within, (), (), why)
            continue
        found = None if step.exact else flats(step, c)
        if found is None:
            there = "where it is placed" if any(map(marked, points_of(step.within))) else f"on {step.within}"
            raise InputError(f"that {_called(step.name)} is {there} does not follow from one assumption")
        yield PlacedPoint(step.name, step.within, step.fresh, found)


def _called(point: str) -> str:
    """A point by its name, or by the letter to which it belongs, since nobody can write that name."""
    letter = letter_of(point)
    if letter is not None:
        return f"a point of {letter[0]}"
    quadric = conic_of(point)
    return f"a point of {quadric}" if quadric is not None else point


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


def with_roles(t: Theorem, roles: Mapping[str, str]) -> Theorem:
    """The same claim at the positions where of the points that depend on each other by a step others are placed:
    instead of a point (a key of `roles`) one that it was placed on, among the others and it.

    Such positions are reached where the extensor of the step vanishes; the claim holds at them too (see the rules at
    the head of `checkers/check_proof.py`).
    """
    placed = tuple(_in_role(p, roles[p.name], t.rank) if p.name in roles else p for p in t.placed)
    fresh = {f for p in placed for f in p.fresh}
    places = {by: name for name, by in roles.items()}
    free = tuple(places.get(n, n) for n in t.order if n not in fresh)
    steps = tuple(
        step_on(
            Within(p.name, p.within, (), tuple(n for n in p.fresh if n in points_of(p.within))),
            t.rank,
            exact=p.equal is not None,
        )
        for p in placed
    )
    c = Construction(t.rank, free, free[: t.ideal], steps)
    closed = c.closed_terms(difference_of(t.left, t.right, t.rank), as_defined=True)
    order, proof = _shortest(closed, len(c.order), c.at_infinity)
    return replace(t, order=tuple(c.order[i] for i in order), relations=proof, placed=placed)


def _in_role(p: PlacedPoint, by: str, rank: int) -> PlacedPoint:
    others = ex.join(*(Point(p.name if n == by else n) for n in points_of(p.within)), rank=rank)
    return PlacedPoint(by, others, (), ())
