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

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from gcrules.algebra.assumptions.building import collapsed, constructed, merged
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.images import PositionKind, with_images
from gcrules.algebra.assumptions.incidences import equations, fault
from gcrules.algebra.assumptions.nondegeneracy import fewest
from gcrules.algebra.assumptions.placing import Aim
from gcrules.algebra.assumptions.position_kinds import Alternative, ConstructionTask, alternatives, flats
from gcrules.algebra.assumptions.strategies import understood
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.canonical import Canonical, renamings
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr, Meet, Point, points_of, subexpressions
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.spelling import normal
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import remembered

__all__ = ["PositionKind", "equations", "holds", "kinds", "resolve"]

_SMALL = 20_000  # terms of an assumption that may hold always
_APART = "the kinds of positions that are allowed cannot be told apart"


def kinds(space: Space, names: Iterable[str] = (), claim: Sequence[Expr] = ()) -> tuple[PositionKind, ...]:
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
        return (PositionKind((), Construction(space.rank, order, ideal, points=order)),)
    failure: InputError | None = None
    best: tuple[int, tuple[PositionKind, ...], Canonical] | None = None
    for lines in (False, True):
        if best is not None and not best[0]:
            break
        for found in renamings(space.rank, order, ideal, space.given, claim):
            try:
                told = _kinds(_canonical_space(found, space.rank, ideal), found.symmetries, lines)
            except InputError as fault:
                failure = failure or found.fault_back(fault)
                continue
            except LimitReached as limited:
                raise found.fault_back(limited) from None
            together = max(len(merged(kind.construction)) for kind in told)
            if best is None or together < best[0]:
                best = together, told, found
            if not together:
                break
    if best is None:
        assert failure is not None
        raise failure
    return _renamed(*best[1:], order)


def _canonical_space(found: Canonical, rank: int, ideal: Sequence[str]) -> Space:
    """The canonical points in tableau order, and what is given of them."""
    order = tableau_order(found.points, found.points, [found.names[n] for n in ideal])
    return Space(rank, order, order[: len(ideal)], found.given)


def _renamed(told: Iterable[PositionKind], found: Canonical, order: tuple[str, ...]) -> tuple[PositionKind, ...]:
    """In the names of the user."""
    place = {n: i for i, n in enumerate(order)}

    def shown(es: Iterable[Expr], rank: int) -> tuple[Expr, ...]:
        return tuple(normal(e, place, rank).expr for e in es)

    made = []
    for k in told:
        c = k.construction.renamed(found.name_back, order)
        where = shown((found.back(e, c.rank) for e in k.where), c.rank)
        made.append(PositionKind(where, replace(c, nonzero=shown(c.nonzero, c.rank)), k.image))
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


@remembered(64)
def _kinds(
    space: Space, symmetries: tuple[FrozenMap[str, str], ...] = (), lines: bool = False
) -> tuple[PositionKind, ...]:
    """The kinds of positions in a space whose points are in tableau order; `lines` as for an aim."""
    rank, points = space.rank, space.points
    free = Construction(rank, points, space.ideal, points=points)
    given = tuple(a for a in space.given if not _always(a, free))
    if not given:
        return (PositionKind((), free),)
    wanted = tuple(e for a in given for e in understood(a, lambda a: equations(a, rank)))
    extensors = _lines_and_planes(given)
    task = ConstructionTask(
        replace(space, given=given), lambda some: constructed(Aim(replace(space, given=some), wanted, lines=lines))
    )
    ways = alternatives(task)
    meets = _meets(given, free)
    failed: dict[Alternative, InputError] = {}
    found: dict[Alternative, Construction] = {}
    for way in ways:
        if way.fault is not None:
            failed[way] = way.fault
            continue
        try:
            there = replace(space, given=way.given)
            found[way] = constructed(Aim(there, wanted, (*extensors, *way.nonzero), meets, lines))
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
        told.append(PositionKind(way.where if len(made) > 1 else (), replace(found[way], nonzero=left)))
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
    extent = {way: collapsed(c, named) for way, c in found.items()}
    return {way: c for way, c in found.items() if not any(other < extent[way] for other in extent.values())}


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


def _meets(given: Iterable[Assumption], free: Construction) -> tuple[Expr, ...]:
    """The points and lines that assumptions name as meets, but for those that are always zero."""
    named = (e for a in given if a.kind != "zero" for arg in a.args for e in subexpressions(arg))
    return tuple(e for e in dict.fromkeys(named) if isinstance(e, Meet) and e.step and not free.vanishes(e))


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
