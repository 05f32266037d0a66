"""A construction of points that satisfies assumptions: orders are tried, and the simplest that works is kept."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import combinations, islice

from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.elimination import Turn, orders
from gcrules.algebra.assumptions.incidences import Facts, IncidenceCondition, fault
from gcrules.algebra.assumptions.placing import Aim, Failure, Placement, parallel
from gcrules.algebra.assumptions.position_kinds import flats
from gcrules.algebra.assumptions.strategies import FURTHER_ROADS, ROADS, on_known_lines, on_pascal_line
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, random_rational_points
from gcrules.algebra.expr import Expr, Meet, Point
from gcrules.algebra.letters import letter, letters_of, named_letter, names_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError
from gcrules.core.seeds import DRAWN, remembered, seed

__all__ = ["coinciding", "collapsed", "constructed", "merged"]

MAX_ORDERS = 200  # orders of a group that are tried
_ENOUGH = 500  # conditions of the constructions among which the simplest is chosen
_TRIED = "no construction that was tried satisfies it; in the one that got farthest,"


def constructed(aim: Aim) -> Construction:
    """A construction of what is given, at which no extensor vanishes, and no meet unless there is no other.

    Raises InputError where there is none.
    """
    found = _attempted(aim)
    if isinstance(found, Failure):
        # Equal assumptions may have been written at another place, where the failure was known before.
        cause = next((a for a in aim.space.given if a == found.cause), found.cause)
        raise fault(cause, f"{_TRIED} {found.why}" if found.tried else found.why, found.hint)
    return found


@remembered(256)
def _attempted(aim: Aim) -> Construction | Failure:
    """The first construction at which no points coincide unsaid, else the first one, else the failure that came
    farthest; equal aims may differ in where they were written.
    """
    space, rank = aim.space, aim.space.rank
    if not space.given:
        free = space.points
        return Construction(rank, free, space.ideal, equations=aim.wanted, points=free, extensors=aim.extensors)
    failure: Failure | None = None
    best: Construction | None = None
    for road in (*ROADS, on_known_lines, *FURTHER_ROADS) if aim.lines else ROADS:
        if road in FURTHER_ROADS and best is not None:
            break
        try:
            found = road(space.given, rank)
            if found is not None:
                made = _Builder(aim, found).construction()
                made = replace(made, nonzero=()) if _one_conic(space) else made
                if not merged(made):
                    return made
                best = best or made
        except Failure as failed:
            failure = failed if failure is None or failed.depth > failure.depth else failure
        except InputError:
            if best is None and failure is None:
                raise
    known = best or failure
    assert known is not None
    return known


def _one_conic(space: Space) -> bool:
    """Whether all that is given is that six finite points lie on a conic.

    Such positions are an irreducible hypersurface, in which those that are reached are dense, so that an identity that
    holds on them holds everywhere.
    """
    given = space.given
    return len(given) == 1 and not space.ideal and on_pascal_line(given[0], space.rank) is not given[0]


def collapsed(c: Construction, named: Iterable[Expr]) -> set[tuple[Expr, ...]]:
    """The extensors that vanish, and the pairs of them that coincide, wherever the construction leads."""
    at = Evaluator(c.random_points(8), c.rank, PRIME)
    values = {e: at.value(e) for e in named}
    return {(e,) for e in values if not any(values[e])} | {
        (e, other)
        for e, other in combinations(values, 2)
        if e.step == other.step and parallel(values[e], values[other])
    }


def merged(c: Construction) -> set[tuple[Expr, ...]]:
    """The pairs of points that coincide wherever the construction leads, but for those of which it was said."""
    said = {s.name for s in c.steps if s.exact or isinstance(s.within, Point)}
    return collapsed(c, [Point(n) for n in c.points if n not in said])


def coinciding(c: Construction, given: Iterable[Assumption]) -> tuple[tuple[str, str], ...]:
    """The names of points, and of letters, that coincide wherever the construction leads, but for those of which it was
    said: that one letter is on the other, or that two hyperplanes have no meet.
    """
    letters = {n: letter(n, k) for n, k in letters_of(c.points).items() if {*names_of(n, k)} <= {*c.points}}
    met = (a.args[0].args if a.kind == "zero" and isinstance(a.args[0], Meet) else a.args for a in given)
    said = [{*map(named_letter, args)} for args in met]
    found = (tuple(map(str, pair)) for pair in collapsed(c, letters.values()) | merged(c) if len(pair) == 2)
    return tuple(sorted((a, b) for a, b in found if {a, b} not in said))


class _Builder:
    """Tries orders of construction on random points modulo a prime, and keeps the simplest that works."""

    def __init__(self, aim: Aim, found: list[Facts]) -> None:
        self.aim, self.space = aim, aim.space
        rank, points, given = aim.space.rank, aim.space.points, aim.space.given
        written = (a for a in given if a.kind not in ("collinear", "coplanar"))
        self.named = (*aim.extensors, *aim.meets, *flats(written, rank), *map(Point, points))
        self.helpers = {h.name: h for f in found for h in f.helpers}
        self.nonzero = tuple(dict.fromkeys(e for f in found for e in f.nonzero))
        place = {n: i for i, n in enumerate((*points, *self.helpers))}
        conditions = {c.equation: c for f in found for c in f.conditions}
        self.conditions = sorted(
            (c for c in conditions.values() if not self._always(c)),
            key=lambda c: (c.equation.step, sorted(place[n] for n in c.names), str(c.equation)),
        )

    def _always(self, c: IncidenceCondition) -> bool:
        """At exact points, since coefficients may be multiples of any prime."""
        space, names = self.space, [*self.space.points, *self.helpers]
        at = seed("always", str(c.equation))
        points = random_rational_points(names, rank=space.rank, ideal=space.ideal, seed=at, size=DRAWN)
        return not any(Evaluator(points, space.rank).value(c.equation))

    def construction(self) -> Construction:
        """Raises Failure where none of the orders tried works."""
        # What fails in one order mostly fails in others, so orders with the same turn come in the second round only.
        barren: set[Turn] = set()
        worst: Failure | None = None
        best: Construction | None = None
        done: set[frozenset[Turn]] = set()
        order, late = (*self.space.points, *self.helpers), (*self.helpers, *self.space.ideal)
        for left_out in (barren, ()):
            for group in orders(self.conditions, order, late, self.space.rank, left_out):
                found = [] if best is None else [best]
                number = len(found)
                for turns in islice(group, MAX_ORDERS):
                    checkpoint()
                    try:
                        # In another order the same turns place the same points, and the first construction is kept.
                        if frozenset(turns) not in done:
                            found.append(self._attempt(turns))
                            done.add(frozenset(turns))
                        number += 1
                    except Failure as failed:
                        barren |= set(turns[failed.depth : failed.depth + 1])
                        worst = failed if worst is None or failed.depth > worst.depth else worst
                    if number * len(self.conditions) > _ENOUGH:
                        break
                best = self._simplest(found)
                if best is not None and self._clean(best):
                    return best
        if best is not None:
            return best
        raise worst or self._no_order()

    def _simplest(self, found: Iterable[Construction]) -> Construction | None:
        """The first one in which the least collapses, among these the one with most extensors and the least cost."""
        best: Construction | None = None
        least = -1
        for c in sorted(found, key=lambda c: (-len(c.extensors), _cost(c))):
            number = len(collapsed(c, self.named))
            if best is None or number < least:
                best, least = c, number
            if not least:
                break
        return best

    def _clean(self, c: Construction) -> bool:
        """Whether nothing vanishes that the assumptions name, and no points coincide that were not said to."""
        return len(c.extensors) == len(self.aim.extensors) + len(self.aim.meets) and not merged(c)

    def _no_order(self) -> Failure:
        stuck = next((c for c in self.conditions if not c.within), self.conditions[0])
        why = "no point of it can be constructed from the others"
        if not stuck.within:
            why = "it is not linear in any of its points"
        hint = "name the points that it is about, and say on which lines and planes they lie"
        return Failure(0, stuck.cause, why, hint, tried=False)

    def _attempt(self, turns: list[Turn]) -> Construction:
        """The construction that one order gives. Raises Failure where it leads nowhere."""
        constructed = {n for n, _ in turns}
        free = tuple(n for n in (*self.space.points, *self.helpers) if n not in constructed)
        values = random_points(free, rank=self.space.rank, ideal=self.space.ideal, seed="construction")
        placed = Placement(self.aim, self.helpers, values)
        for depth, (name, conditions) in enumerate(turns):
            checkpoint()
            placed.place(depth, name, conditions)
        return placed.construction(free, self.nonzero)


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
