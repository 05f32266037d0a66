r"""Assumptions resolved by construction, so that what is proved under them is proved exactly.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> space = parse_assumption("collinear(a, b, c), collinear(a, b, d)", Context(rank=3))
>>> construction = resolve(space)
>>> [f"{s.name} on {s.within}" for s in construction.steps], [str(e) for e in construction.nonzero]
(['c on ab', 'd on ab'], ['ab'])
>>> (assumption,) = parse_assumption("collinear(b, c, d)", Context(rank=3)).given
>>> holds(assumption, space)
True
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations, islice

from gcrules.algebra.assumptions.construction import Construction, Step, Within, coordinates, step_on
from gcrules.algebra.assumptions.elimination import Turn, orders
from gcrules.algebra.assumptions.images import Kind, with_images
from gcrules.algebra.assumptions.incidences import Condition, Facts, equations, fault
from gcrules.algebra.assumptions.nondegeneracy import assumed, fewest
from gcrules.algebra.assumptions.position_kinds import Alternative, Task, alternatives, flats
from gcrules.algebra.assumptions.strategies import ROADS, on_pascal_line, understood
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.canonical import Canonical, renamings
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, random_rational_points
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr, Meet, Point, join, points_of, subexpressions
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.spelling import normal
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import DRAWN, drawn, seed

__all__ = ["Kind", "equations", "holds", "kinds", "resolve"]

MAX_ORDERS = 200  # orders of a group that are tried
_SMALL = 20_000  # terms of an assumption that may hold always
_ENOUGH = 500  # conditions of the constructions among which the simplest is chosen
_TRIED = "no construction that was tried satisfies it; in the one that came farthest,"
_APART = "the kinds of positions that are allowed cannot be told apart"
_NAME_IT = "name the common point: given incident(p, X), incident(p, Y)"


def kinds(space: Space, names: Iterable[str] = (), claim: Sequence[Expr] = ()) -> tuple[Kind, ...]:
    """The kinds of positions that the assumptions allow, each with a construction of all points (those named, and
    those of the assumptions). A position that satisfies the assumptions is of one of these kinds, or an extensor of
    the `nonzero` of one of the constructions vanishes there.

    They are sought in canonical names, so that they don't depend on how points are called or on the order of the
    assumptions. Where the assumptions leave a choice between points, a claim (expressions) decides.

    Raises InputError for assumptions that are not resolved, with the place of one of them.
    """
    used = (*names, *(n for a in space.given for e in a.args for n in points_of(e)))
    order = tableau_order(used, space.points, space.ideal)
    ideal = tuple(n for n in order if n in space.ideal)
    if not space.given:
        return (Kind((), Construction(space.rank, order, ideal, points=order)),)
    failure: InputError | None = None
    best: tuple[int, tuple[Kind, ...], Canonical] | None = None
    for found in renamings(space.rank, order, ideal, space.given, claim):
        try:
            told = _kinds(space.rank, *_tableau(found, ideal), found.given, found.symmetries)
        except InputError as fault:
            failure = failure or found.fault_back(fault)
            continue
        except LimitReached as limited:
            raise found.fault_back(limited) from None
        merged = max(len(_merged(kind.construction)) for kind in told)
        if best is None or merged < best[0]:
            best = merged, told, found
        if not merged:
            break
    if best is None:
        assert failure is not None
        raise failure
    return _renamed(*best[1:], order)


def _tableau(found: Canonical, ideal: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The canonical points in tableau order, and those at infinity."""
    order = tableau_order(found.points, found.points, [found.names[n] for n in ideal])
    return order, order[: len(ideal)]


def _renamed(told: Iterable[Kind], found: Canonical, order: tuple[str, ...]) -> tuple[Kind, ...]:
    """In the names of the user."""
    place = {n: i for i, n in enumerate(order)}

    def shown(es: Iterable[Expr], rank: int) -> tuple[Expr, ...]:
        return tuple(normal(e, place, rank).expr for e in es)

    made = []
    for k in told:
        c = k.construction.renamed(found.name_back, order)
        where = shown((found.back(e, c.rank) for e in k.where), c.rank)
        made.append(Kind(where, replace(c, nonzero=shown(c.nonzero, c.rank)), k.image))
    return tuple(sorted(made, key=lambda k: [str(e) for e in k.where]))


def resolve(space: Space, names: Iterable[str] = (), claim: Sequence[Expr] = ()) -> Construction:
    """One construction of all points that satisfies what is given, as for `kinds`.

    Where assumptions allow several kinds of positions, the construction reaches one of them, and `nonzero` tells
    which: it leaves out positions at which one of these extensors vanishes, and no others.
    """
    found = [kind for kind in kinds(space, names, claim) if not kind.image]
    for kind in found:
        nonzero = _without(kind.construction, [other.where for other in found if other is not kind])
        if nonzero is not None:
            return replace(kind.construction, nonzero=nonzero)
    raise fault(space.given[-1], _APART)


@lru_cache(maxsize=64)
def _kinds(
    rank: int,
    points: tuple[str, ...],
    ideal: tuple[str, ...],
    given: tuple[Assumption, ...],
    symmetries: tuple[FrozenMap[str, str], ...] = (),
) -> tuple[Kind, ...]:
    given = tuple(a for a in given if not _always(a, Construction(rank, points, ideal)))
    if not given:
        return (Kind((), Construction(rank, points, ideal, points=points)),)
    wanted = tuple(e for a in given for e in understood(a, lambda a: equations(a, rank)))
    extensors = _lines_and_planes(given)
    task = Task(rank, points, ideal, lambda some: _constructed(rank, points, ideal, some, wanted))
    ways = alternatives(given, task)
    meets = _meets(given, rank, points, ideal)
    failed: dict[Alternative, InputError] = {}
    found: dict[Alternative, Construction] = {}
    for way in ways:
        if way.fault is not None:
            failed[way] = way.fault
            continue
        try:
            found[way] = _constructed(rank, points, ideal, way.given, wanted, (*extensors, *way.nonzero), meets)
        except InputError as failure:
            failed[way] = failure
    if not found:
        raise failed[ways[0]]
    if len(found) > 1:
        found = _least_collapsed(found, (*extensors, *meets, *flats(given, rank), *map(Point, points)))
    larger = {way: [other for other in found if _within(way, other, found)] for way in found}
    made = [way for way in found if not larger[way]]
    missed = [way.where for way in ways if way not in found]
    told = []
    for way in made:
        # What is said of positions that are of another kind too was said where their own construction leads.
        parts = [way, *(other for other in found if way in larger[other])]
        nonzero = fewest(e for part in parts for e in (*found[part].nonzero, *part.nonzero))
        left = _without(replace(found[way], nonzero=nonzero), missed)
        if left is None:
            raise next((failed[w] for w in ways if w in failed), fault(given[-1], _APART))
        told.append(Kind(way.where if len(made) > 1 else (), replace(found[way], nonzero=left)))
    return with_images(told, symmetries)


def _always(a: Assumption, free: Construction) -> bool:
    """Whether an assumption holds at all positions."""
    try:
        wanted = understood(a, lambda a: equations(a, free.rank))
    except InputError:
        return False
    known = frozenset(free.free)
    if not all(known.issuperset(points_of(e)) for e in wanted):
        return False
    try:
        return all(map(free.vanishes, wanted)) and all(free.is_zero(e, limit=_SMALL) for e in wanted)
    except LimitReached:
        return False


def _least_collapsed(
    found: Mapping[Alternative, Construction], named: Iterable[Expr]
) -> dict[Alternative, Construction]:
    """Without those in which more of what the assumptions name collapses than in another one: extensors that vanish,
    lines or planes that coincide.
    """
    named = tuple(named)
    collapsed = {way: _collapsed(c, named) for way, c in found.items()}
    return {way: c for way, c in found.items() if not any(other < collapsed[way] for other in collapsed.values())}


def _collapsed(c: Construction, named: Iterable[Expr]) -> set[tuple[Expr, ...]]:
    """The extensors that vanish, and the pairs of them that coincide, wherever the construction leads."""
    at = Evaluator(c.random_points(8), c.rank, PRIME)
    values = {e: at.value(e) for e in named}
    return {(e,) for e in values if not any(values[e])} | {
        (e, other)
        for e, other in combinations(values, 2)
        if e.step == other.step and _parallel(values[e], values[other])
    }


def _merged(c: Construction) -> set[tuple[Expr, ...]]:
    """The pairs of points that coincide, but for those of which it was said."""
    said = {s.name for s in c.steps if s.exact or isinstance(s.within, Point)}
    return _collapsed(c, [Point(n) for n in c.points if n not in said])


def _within(way: Alternative, other: Alternative, found: Mapping[Alternative, Construction]) -> bool:
    """Whether what a construction reaches is reached by another one, which is larger or comes before it."""
    if other is way or not _inside(way, other, found):
        return False
    order = list(found)
    return order.index(other) < order.index(way) or not _inside(other, way, found)


def _inside(way: Alternative, other: Alternative, found: Mapping[Alternative, Construction]) -> bool:
    c = found[way]
    return all(map(c.vanishes, other.where)) and not any(map(c.vanishes, (*found[other].nonzero, *other.nonzero)))


def _without(c: Construction, others: Iterable[Sequence[Expr]]) -> tuple[Expr, ...] | None:
    """What must not vanish so that of these other kinds nothing is met; None where that would exclude this one too."""
    nonzero = list(c.nonzero)
    for where in others:
        told = next((e for e in where if not c.vanishes(e)), None)
        if told is None:
            return None
        nonzero.append(told)
    return fewest(nonzero)


def _lines_and_planes(given: Iterable[Assumption]) -> tuple[Expr, ...]:
    """The extensors that assumptions speak of: they are taken to be what they are called."""
    named = (e for a in given if a.kind in ("incident", "concurrent") for e in a.args if e.step > 1)
    return tuple(dict.fromkeys(named))


def _meets(given: Iterable[Assumption], rank: int, points: tuple[str, ...], ideal: tuple[str, ...]) -> tuple[Expr, ...]:
    """The points and lines that assumptions name as meets, but for those that are always zero."""
    named = (e for a in given if a.kind != "zero" for arg in a.args for e in subexpressions(arg))
    free = Construction(rank, points, ideal)
    return tuple(e for e in dict.fromkeys(named) if isinstance(e, Meet) and e.step and not free.vanishes(e))


def _constructed(
    rank: int,
    points: tuple[str, ...],
    ideal: tuple[str, ...],
    given: tuple[Assumption, ...],
    wanted: tuple[Expr, ...],
    extensors: tuple[Expr, ...] = (),
    meets: tuple[Expr, ...] = (),
) -> Construction:
    """A construction of what is given, at which no extensor vanishes, and no meet unless there is no other.

    Raises InputError where there is none.
    """
    found = _attempted(rank, points, ideal, given, wanted, extensors, meets)
    if isinstance(found, _Failure):
        # Equal assumptions may have been written at another place, where the failure was known before.
        cause = next((a for a in given if a == found.cause), found.cause)
        raise fault(cause, f"{_TRIED} {found.why}" if found.tried else found.why, found.hint)
    return found


@lru_cache(maxsize=256)
def _attempted(
    rank: int,
    points: tuple[str, ...],
    ideal: tuple[str, ...],
    given: tuple[Assumption, ...],
    wanted: tuple[Expr, ...],
    extensors: tuple[Expr, ...],
    meets: tuple[Expr, ...],
) -> Construction | _Failure:
    if not given:
        return Construction(rank, points, ideal, equations=wanted, points=points, extensors=extensors)
    failure: _Failure | None = None
    for road in ROADS:
        try:
            found = road(given, rank)
            if found is not None:
                made = _Builder(rank, points, ideal, given, found, wanted, extensors, meets).construction()
                return replace(made, nonzero=()) if _one_conic(given, rank, ideal) else made
        except _Failure as failed:
            failure = failed if failure is None or failed.depth > failure.depth else failure
        except InputError:
            if failure is None:
                raise
    assert failure is not None
    return failure


def _one_conic(given: Sequence[Assumption], rank: int, ideal: tuple[str, ...]) -> bool:
    """Whether all that is given is that six finite points lie on a conic.

    Such positions are an irreducible hypersurface, in which those that are reached are dense, so that an identity that
    holds on them holds everywhere.
    """
    return len(given) == 1 and not ideal and on_pascal_line(given[0], rank) is not given[0]


def holds(assumption: Assumption, space: Space, *, limit: int = MAX_TERMS) -> bool:
    """Whether an assumption follows from what is given in a space, proved by normal forms.

    As all that is proved there, it follows where the construction's `nonzero` extensors do not vanish; in a space
    without assumptions, everywhere. Raises InputError as `resolve` does, LimitReached beyond `limit` terms.
    """
    wanted = equations(assumption, space.rank)
    found = [kind.construction for kind in kinds(space, points_of(*wanted))]
    return all(c.vanishes(e) for e in wanted for c in found) and all(
        c.is_zero(e, limit=limit) for e in wanted for c in found
    )


# --- construction --------------------------------------------------------------------------------------------------


class _Failure(Exception):
    """An order of construction that leads nowhere: at which assumption, and why."""

    def __init__(self, depth: int, cause: Assumption, why: str, hint: str | None = None, *, tried: bool = True) -> None:
        super().__init__(why)
        self.depth, self.cause, self.why, self.hint, self.tried = depth, cause, why, hint, tried


class _Builder:
    """Tries orders of construction on random points modulo a prime, and keeps the simplest that works."""

    def __init__(
        self,
        rank: int,
        points: tuple[str, ...],
        ideal: tuple[str, ...],
        given: tuple[Assumption, ...],
        found: list[Facts],
        wanted: tuple[Expr, ...],
        extensors: tuple[Expr, ...],
        meets: tuple[Expr, ...],
    ) -> None:
        self.rank, self.points, self.ideal, self.given, self.wanted = rank, points, ideal, given, wanted
        self.extensors, self.meets = extensors, meets
        written = (a for a in given if a.kind not in ("collinear", "coplanar"))
        self.named = (*extensors, *meets, *flats(written, rank), *map(Point, points))
        self.helpers = {h.name: h for f in found for h in f.helpers}
        self.nonzero = tuple(dict.fromkeys(e for f in found for e in f.nonzero))
        place = {n: i for i, n in enumerate((*points, *self.helpers))}
        conditions = {c.equation: c for f in found for c in f.conditions}
        self.conditions = sorted(
            (c for c in conditions.values() if not self._always(c)),
            key=lambda c: (c.equation.step, sorted(place[n] for n in c.names), str(c.equation)),
        )

    def _always(self, c: Condition) -> bool:
        """At exact points, since coefficients may be multiples of any prime."""
        names = [*self.points, *self.helpers]
        at = seed("always", str(c.equation))
        points = random_rational_points(names, rank=self.rank, ideal=self.ideal, seed=at, size=DRAWN)
        return not any(Evaluator(points, self.rank).value(c.equation))

    def always_on(self, within: Expr, name: str) -> bool:
        r"""Whether an extensor of step 1 is a multiple of a point whatever is assumed, as ab /\ ac is of a."""
        if within.step > 1:
            return False
        e = join(within, Point(name), rank=self.rank)
        return Construction(self.rank, points_of(e), self.ideal).vanishes(e)

    def construction(self) -> Construction:
        """Raises _Failure where none of the orders tried works."""
        # What fails in one order mostly fails in others, so orders with the same turn come in the second round only.
        barren: set[Turn] = set()
        worst: _Failure | None = None
        best: Construction | None = None
        for left_out in (barren, ()):
            order, late = (*self.points, *self.helpers), (*self.helpers, *self.ideal)
            for group in orders(self.conditions, order, late, self.rank, left_out):
                found = [] if best is None else [best]
                for turns in islice(group, MAX_ORDERS):
                    checkpoint()
                    try:
                        found.append(self._attempt(turns))
                    except _Failure as failed:
                        barren |= set(turns[failed.depth : failed.depth + 1])
                        worst = failed if worst is None or failed.depth > worst.depth else worst
                    if len(found) * len(self.conditions) > _ENOUGH:
                        break
                best = min(
                    found, key=lambda c: (len(_collapsed(c, self.named)), -len(c.extensors), _cost(c)), default=None
                )
                if best is not None and self._clean(best):
                    return best
        if best is not None:
            return best
        raise worst or self._no_order()

    def _clean(self, c: Construction) -> bool:
        """Whether nothing vanishes that the assumptions name, and no points coincide that were not said to."""
        return len(c.extensors) == len(self.extensors) + len(self.meets) and not _merged(c)

    def _no_order(self) -> _Failure:
        stuck = next((c for c in self.conditions if not c.within), self.conditions[0])
        why = "no point of it can be constructed from the others"
        if not stuck.within:
            why = "it is not linear in any of its points"
        hint = "name the points that it is about, and say on which lines and planes they lie"
        return _Failure(0, stuck.cause, why, hint, tried=False)

    def _attempt(self, turns: list[Turn]) -> Construction:
        constructed = {n for n, _ in turns}
        free = tuple(n for n in (*self.points, *self.helpers) if n not in constructed)
        values = random_points(free, rank=self.rank, ideal=self.ideal, seed="construction")
        state = _State(self, values)
        for depth, (name, conditions) in enumerate(turns):
            checkpoint()
            state.place(depth, name, conditions)
        return state.construction(free)


@dataclass
class _State:
    """The points placed so far, with random coordinates modulo the prime."""

    builder: _Builder
    values: dict[str, tuple[int, ...]]
    steps: list[Step] = field(default_factory=list)
    causes: list[tuple[Condition, ...]] = field(default_factory=list)
    rng: random.Random = field(default_factory=lambda: drawn("construction"))

    def zero(self, e: Expr) -> bool:
        return not any(Evaluator(self.values, self.builder.rank, PRIME).value(e))

    def place(self, depth: int, name: str, conditions: tuple[Condition, ...]) -> None:
        rank = self.builder.rank
        usable = sorted((c for c in conditions if name in c.within), key=lambda c: (not c.exact, c.within[name].step))
        within: Within | None = None
        used: list[Condition] = []
        for c in usable:
            if within is not None:
                self.put(step_on(within, rank, exact=used[0].exact))
                if self.zero(c.equation):
                    continue
            s = c.within[name]
            if self.zero(s):
                continue
            smaller = Within(name, s, (s,)) if within is None else self.smaller(within, c, used[0].exact)
            if smaller is not None:
                within = smaller
                used.append(c)
        if within is None:
            raise _Failure(depth, conditions[0].cause, f"nothing is left on which {name} could lie")
        step = step_on(within, rank, exact=used[0].exact)
        self.put(step)
        for c in conditions:
            if not self.zero(c.equation):
                why = (
                    f"it asks too much of the point {name}"
                    if name in c.within
                    else "it is not linear in a point that the others leave, nor does it follow from them"
                )
                raise _Failure(depth, c.cause, why, "leave out an assumption, or name more points")
        self.check(depth, step, used)
        self.steps.append(step)
        self.causes.append(tuple(used))

    def smaller(self, within: Within, c: Condition, exact: bool) -> Within | None:
        """Where a point lies that satisfies one more condition, if that can be told and is not nothing."""
        rank, s = self.builder.rank, c.within[within.name]
        if exact or c.exact:
            return None
        candidates = [within.met(s, rank)]
        for extra in range(1, rank):
            candidates += within.met_inside(s, rank, extra)
        for found in candidates:
            if found is not None and not any(self.zero(e) for e in found.nonzero):
                step = step_on(found, rank)
                self.put(step)
                if any(self.values[found.name]) and self.zero(c.equation):
                    return found
        return None

    def put(self, step: Step) -> None:
        b = self.builder
        points = {**self.values, **random_points(step.fresh, rank=b.rank, seed=("fresh", len(self.steps)))}
        value = coordinates(step, points, b.rank, lambda: self.rng.randrange(DRAWN), PRIME)
        self.values[step.name] = tuple(value)

    def check(self, depth: int, step: Step, used: list[Condition]) -> None:
        """Points stay what they are: not zero, at infinity or not as declared, and different from the others."""
        b, value, cause = self.builder, self.values[step.name], used[-1].cause
        if not any(value):
            raise _Failure(depth, cause, f"no place is left for the point {step.name}")
        if step.name in b.helpers:
            return
        if step.name in b.ideal and value[-1]:
            hint = f"leave out `ideal {step.name}`, or say on which line or plane at infinity it lies"
            raise _Failure(depth, cause, f"the point {step.name} at infinity would have to be a finite point", hint)
        if step.name not in b.ideal and not value[-1]:
            hint = f"declare it with `ideal {step.name}`"
            raise _Failure(depth, cause, f"the finite point {step.name} would have to lie at infinity", hint)
        at = b.helpers.get(step.within.name) if isinstance(step.within, Point) else None
        within = step.within if at is None or at.meet is None else at.meet
        if used[0].exact or isinstance(within, Point):
            return  # so it was asked for
        for other, there in self.values.items():
            if other != step.name and ":" not in other and _parallel(value, there) and not b.always_on(within, other):
                hint = "say so with == if that is meant"
                why = f"{other} and {step.name} would be one point"
                raise _Failure(depth, cause, why, hint)

    def construction(self, free: tuple[str, ...]) -> Construction:
        b, cause = self.builder, self.causes[-1][-1].cause if self.causes else self.builder.given[-1]
        nonzero = assumed(self.steps, b.nonzero, free, b.ideal, b.helpers, b.rank)
        if nonzero is None:
            raise _Failure(len(self.steps), cause, "the common point of the lines needs a name", _NAME_IT)
        for e in (*nonzero, *b.extensors):
            if self.zero(e):
                raise _Failure(len(self.steps), cause, f"{e} would be zero", _NAME_IT)
        extensors = (*b.extensors, *(e for e in b.meets if not self.zero(e)))
        return Construction(b.rank, free, b.ideal, tuple(self.steps), fewest(nonzero), b.wanted, b.points, extensors)


def _parallel(a: Sequence[int], b: Sequence[int]) -> bool:
    return all((a[i] * b[j] - a[j] * b[i]) % PRIME == 0 for i in range(len(a)) for j in range(i))


def _cost(c: Construction) -> tuple[int, int]:
    """How many points satisfy several conditions at once, and about how many terms the constructed points have.

    Where points may be in several kinds of positions, the first tells the general one from one that was not meant: of
    coplanar(a, b, c, d), coplanar(b, c, d, e) that all lie in one plane, and not that b lies on cd.
    """
    sizes: dict[str, int] = {}

    def size(e: Expr) -> int:
        if isinstance(e, Point):
            return sizes.get(e.name, 1)
        found = 1
        for child in e.children:
            found *= size(child)
        return found * (2 * len(e.children) if isinstance(e, Meet) else 1)

    for s in c.steps:
        sizes[s.name] = sum(map(size, s.parts))
    return sum(isinstance(s.within, Meet) for s in c.steps), sum(sizes.values())
