r"""Why a construction reaches every position that satisfies the assumptions, in steps that a checker can follow.

A point X that is constructed on an extensor W lies there at every such position, since it lies on flats F of which W is
made by meets and joins. F ∨ X = 0 is an equation of the assumptions, or it has more points than there is room for on an
extensor on which all of them lie. An auxiliary point is a meet of others, so that F ∨ X may vanish as it stands.
A point that is said to be equal to an expression W is placed as W, since X − W = 0 is an equation.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction, ConstructionStep
from gcrules.algebra.bracket import Coefficient, Terms
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Product, Sum, points_of
from gcrules.algebra.parts import substitute
from gcrules.algebra.proofs.relations import Relation, relations
from gcrules.algebra.proofs.written import Written, number
from gcrules.core.dataclass import dataclass

__all__ = ["Flat", "Multiple", "equal", "flats", "is_plain", "quotient", "turned"]

_MOST = 1_000  # exchanges
_SIZE = 1_000  # of coordinates at which expressions are compared
_TRIES = 5  # positions
_OF_ANY_WEIGHT = 100  # a seed from which on points have different weights, so that a difference of two is finite


@dataclass(frozen=True)
class Multiple:
    """Something is `number` · the equation with this `index` and the sum of `relations`, whose rows are numbers of the
    points of `order`, so that it vanishes; or it does as it stands, without an index. It may be so only where the
    points that were placed before are `written_out`.
    """

    index: int | None = None
    number: Coefficient = 0
    relations: tuple[Relation, ...] = ()
    order: tuple[str, ...] = ()
    written_out: bool = False

    def to_json(self, place: Mapping[str, int]) -> list[Any]:
        """The multiple as `proof.schema.json` describes it, with the numbers of points by name."""
        if self.index is None:
            return []
        found = [self.index, number(self.number)]
        if not self.relations:
            return found
        closing = len(self.relations[0].first)  # as many as there are coordinates: the points that close an extensor
        numbers = [*(place[n] for n in self.order), *(len(place) + k for k in range(closing))]
        return [*found, [r.to_json(numbers) for r in self.relations]]


@dataclass(frozen=True)
class Flat:
    """`extensor` ∨ the point vanishes: `because` of one equation, or for want of room on `room`, which does not."""

    extensor: Expr
    because: tuple[Multiple, ...]
    room: Expr | None = None

    def expressions(self) -> tuple[Expr, ...]:
        """All that are named."""
        return (self.extensor,) if self.room is None else (self.extensor, self.room)

    def to_json(self, written: Written, place: Mapping[str, int]) -> dict[str, Any]:
        """The flat as `proof.schema.json` describes it, with the numbers of points by name."""
        return {
            "flat": written.of(self.extensor),
            "room": None if self.room is None else written.of(self.room),
            "because": [m.to_json(place) for m in self.because],
        }


def flats(step: ConstructionStep, construction: Construction) -> tuple[Flat, ...] | None:
    """Flats on which a constructed point lies, from which it follows that it lies on the extensor of its step; None
    where they are not found.
    """
    found: list[Flat] = []
    if not is_plain(step.within, construction.rank):
        return None
    return tuple(dict.fromkeys(found)) if _lies(step, step.within, construction, found) else None


def equal(step: ConstructionStep, construction: Construction) -> Multiple | None:
    """Why a point equals the expression of its step, by one equation; None where none says so."""
    difference = ex.sub(Point(step.name), step.within, rank=construction.rank)
    return (
        _multiple(difference, construction)
        or _with_relations(difference, construction)
        or _written_out(difference, step.name, construction)
    )


def turned(flat: Flat, name: str, extensor: Expr, construction: Construction) -> Flat | None:
    """The flat that is the same extensor up to a number, its meets in another sequence; None where no equation says of
    it that the point is there.
    """
    if extensor == flat.extensor:
        return flat
    own = _with_relations(ex.join(extensor, Point(name), rank=construction.rank), construction)
    return None if own is None else Flat(extensor, (own,))


def is_plain(e: Expr, rank: int) -> bool:
    """Whether an expression is made by joins and meets of points and hyperplanes, and so is an extensor; sums of points
    are points, and sums of hyperplanes are hyperplanes.
    """
    if isinstance(e, Join | Meet):
        return all(is_plain(a, rank) for a in e.args)
    return isinstance(e, Point) or (isinstance(e, Sum | Product) and e.step in (1, rank - 1))


def _lies(step: ConstructionStep, within: Expr, c: Construction, found: list[Flat]) -> bool:
    """Whether the point of a step lies on an extensor; the flats from which that follows are added to those `found`."""
    flat = _flat(step.name, within, c)
    if flat is not None:
        found.append(flat)
        return True
    match within:
        case Meet(args=args):
            return all(_lies(step, a, c, found) for a in args)
        case Join(args=args):
            kept = [a for a in args if not (isinstance(a, Point) and a.name in step.fresh)]
            return len(kept) < len(args) and _lies(step, ex.join(*kept, rank=c.rank), c, found)
    return False


def _flat(name: str, extensor: Expr, c: Construction) -> Flat | None:
    """The extensor as a flat on which a point lies by one equation, or for want of room; None where neither says so."""
    if extensor.step >= c.rank:
        return None
    joined = ex.join(extensor, Point(name), rank=c.rank)
    own = _multiple(joined, c)
    if own is not None:
        return Flat(extensor, (own,))
    for room in _rooms(c):
        if room.step < joined.step:
            because = _inside(joined, room, c)
            if because is not None:
                return Flat(extensor, because, room)
    own = _with_relations(joined, c) or _written_out(joined, name, c)
    return None if own is None else Flat(extensor, (own,))


def _rooms(c: Construction) -> Iterator[Expr]:
    """Extensors of joined points that must not vanish, as they are or as parts."""
    waiting = list(c.nonzero)
    while waiting:
        e = waiting.pop(0)
        if isinstance(e, Join) and all(isinstance(a, Point) for a in e.args):
            yield e
        elif isinstance(e, Join | Meet | Bracket | Product):
            waiting += e.children


def _inside(joined: Expr, room: Expr, c: Construction) -> tuple[Multiple, ...] | None:
    """Why every part of a join lies on an extensor that does not vanish; None where one may not."""
    because = []
    for part in joined.children:
        if part in room.children:
            continue
        with_room = ex.join if isinstance(part, Point) else ex.meet
        if not isinstance(part, Point) and room.step != c.rank - 1:
            return None
        why = _multiple(with_room(part, room, rank=c.rank), c)
        if why is None:
            return None
        because.append(why)
    return tuple(because)


def _multiple(e: Expr, c: Construction) -> Multiple | None:
    """An expression as a multiple of an equation, or with auxiliary points of 0, term by term as the checker expands
    both; None where it is none.
    """
    e = substitute(e, c.meets, c.rank)
    terms = _free(c, points_of(e)).closed_terms(e, as_defined=True)
    if c.meets and not any(terms.values()):
        return Multiple()
    for index, equation in _alike(e, c):
        factor = _ratio(terms, _free(c, points_of(e)).closed_terms(equation, as_defined=True))
        if factor:
            return Multiple(index, factor)
    return None


def _with_relations(e: Expr, c: Construction) -> Multiple | None:
    """An expression as a multiple of an equation up to exchange relations; None where it is none."""
    e = substitute(e, c.meets, c.rank)
    free = _free(c, points_of(e))
    return next((found for index, equation in _alike(e, c) if (found := _by(e, index, equation, free))), None)


def _by(e: Expr, index: int, equation: Expr, c: Construction, first: int = 0) -> Multiple | None:
    """An expression as a multiple of one equation up to exchange relations, wherever a construction leads; None where
    it is none. Both are compared at points of seeds from the `first` on.
    """
    factor = quotient(e, equation, c, first)
    terms, other = (c.closed_terms(x, as_defined=True) for x in (e, equation))
    rest = {m: terms.get(m, 0) - factor * other.get(m, 0) for m in {**terms, **other}}
    found = relations(rest, c.at_infinity, _MOST) if factor else None
    return None if found is None else Multiple(index, factor, found, c.order)


def _written_out(e: Expr, name: str, c: Construction) -> Multiple | None:
    """An expression with a point that is placed next as a multiple of an equation, once those placed before are written
    out as what they are; None where it is none.
    """
    at = next(i for i, step in enumerate(c.steps) if step.name == name)
    if c.meets or not at:
        return None
    later = tuple(step.name for step in c.steps[at:])
    ideal = tuple(c.order[: c.at_infinity])
    so_far = Construction(c.rank, (*c.free, *later), ideal, c.steps[:at])
    for index, equation in enumerate(c.equations):
        known = {*points_of(equation)} <= {*so_far.names}
        if name not in points_of(equation) or not known or equation.step % c.rank != e.step % c.rank:
            continue
        found = _by(e, index, equation, so_far, _OF_ANY_WEIGHT)
        if found is not None:
            return replace(found, written_out=True)
    return None


def _alike(e: Expr, c: Construction) -> Iterator[tuple[int, Expr]]:
    """The equations of the same points and step."""
    for index, equation in enumerate(c.equations):
        if set(points_of(equation)) == set(points_of(e)) and equation.step % c.rank == e.step % c.rank:
            yield index, equation


def quotient(e: Expr, other: Expr, construction: Construction, first: int = 0) -> Coefficient:
    """What an expression is, scalar or extensor, by what another one is, at random points to which a construction
    leads, those of some seeds from the `first` on; 0 where that is no number.
    """
    found: set[Fraction] = set()
    for seed in range(first, first + _TRIES):
        points = construction.rational_points(seed, _SIZE)
        if points is not None:
            both = (Evaluator(points, construction.rank).value(x) for x in (e, other))
            found |= {Fraction(v) / by if by else Fraction(0) for v, by in zip(*both, strict=True) if v or by}
    (ratio,) = found if len(found) == 1 else (Fraction(0),)
    return ratio.numerator if ratio.denominator == 1 else ratio


def _free(c: Construction, names: Iterable[str]) -> Construction:
    """The points by themselves, without what is assumed of them; of those that are placed none is known to be at
    infinity.
    """
    points = tuple(sorted(set(names)))
    return Construction(c.rank, points, tuple(n for n in c.order[: c.at_infinity] if n in points))


def _ratio(terms: Terms, other: Terms) -> Coefficient:
    """The number by which terms are a multiple of other ones; 0 where they are not."""
    live, known = ({m: k for m, k in some.items() if k} for some in (terms, other))
    if not live or live.keys() != known.keys():
        return 0
    first = next(iter(live))
    factor = Fraction(live[first]) / known[first]
    return factor if all(k == factor * known[m] for m, k in live.items()) else 0
