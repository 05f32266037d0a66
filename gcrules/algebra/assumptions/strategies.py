r"""Roads to a construction: the conditions of all assumptions, as they are written, or brought into another form.

As written, each assumption is read by itself. Where that leads nowhere, assumptions are read together (several points
on one plane, several equations between the same points), or points that are written as meets get names of their own, as
do those of the line of Pascal of a conic, whose hexagon may have lines that are given as sides.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> given = parse_assumption("incident(x, abc), incident(y, abc)").given
>>> for road in (as_written, together):
...     print(*(c.equation for f in road(given, 4) for c in f.conditions), sep=", ")
[abcx], [abcy]
[abcx], [abcy], [abxy], [acxy], [bcxy]
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, pairwise, permutations, product
from math import comb
from typing import TypeVar

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.conics import hexagon, pascal
from gcrules.algebra.assumptions.incidences import (
    MAX_CONDITIONS,
    Facts,
    Helper,
    IncidenceCondition,
    all_of,
    dependent,
    equal,
    facts,
    fault,
    name_key,
    of_points,
    on,
    small_first,
)
from gcrules.algebra.assumptions.linear import is_extensor, weights
from gcrules.algebra.assumptions.quadrics import Quadric, quadric
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, points_of
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Assumption
from gcrules.core.errors import StepError

__all__ = [
    "FURTHER_ROADS",
    "ROADS",
    "as_written",
    "on_known_lines",
    "on_pascal_line",
    "on_quadrics",
    "together",
    "understood",
    "with_named_meets",
]

_T = TypeVar("_T")


def understood(assumption: Assumption, read: Callable[[Assumption], _T]) -> _T:
    """What is read from an assumption; extensors that cannot be joined or met as it asks are its fault."""
    try:
        return read(assumption)
    except StepError as wrong:
        raise fault(assumption, wrong.message, wrong.hint) from None


def as_written(given: Sequence[Assumption], rank: int) -> list[Facts]:
    """The conditions of each assumption by itself."""
    return [understood(a, lambda a: facts(a, rank)) for a in given]


# --- assumptions of the same points --------------------------------------------------------------------------------


def together(given: Sequence[Assumption], rank: int) -> list[Facts] | None:
    """Points on one line or plane lie there together, and equations are solved together; None if there are no such."""
    merged = {**_on_flats(given, rank), **_solved(given, rank)}
    if not merged:
        return None
    return [merged[i] if i in merged else understood(a, lambda a: facts(a, rank)) for i, a in enumerate(given)]


def _on_flats(given: Sequence[Assumption], rank: int) -> Mapping[int, Facts]:
    """Points x, y on the plane abc, which is not zero: any four of a, b, c, x, y are in a plane."""
    flats: dict[frozenset[Expr], dict[int, tuple[Expr, ...]]] = {}
    for i, a in enumerate(given):
        if a.kind == "incident":
            X, Y = small_first(*a.args)
            if isinstance(Y, Join) and of_points(X) and of_points(Y):
                flats.setdefault(frozenset(Y.args), {})[i] = X.args if isinstance(X, Join) else (X,)
    found: dict[int, Facts] = {}
    for span, members in flats.items():
        points = span.union(*members.values())
        size = len(span) + 1
        if len(points) > size and comb(len(points), size) <= MAX_CONDITIONS:
            first, *others = members
            plane = small_first(*given[first].args)[1]
            any_of_them = dependent(given[first], sorted(points, key=name_key), size, rank)
            found[first] = all_of([any_of_them, Facts(nonzero=(plane,))])
            found.update(dict.fromkeys(others, Facts()))
    return found


def _solved(given: Sequence[Assumption], rank: int) -> Mapping[int, Facts]:
    """Equations between points, reduced: each is solved for a point that occurs in no other."""
    rows = {i: weights(a.args[0]) for i, a in enumerate(given) if a.kind == "zero" and a.args[0].step == 1}
    if len(rows) < 2:
        return {}
    hidden = {n for row in rows.values() for e in row if not isinstance(e, Point) for n in points_of(e)}
    for i, row in rows.items():
        points = [e for e in row if isinstance(e, Point) and e.name not in hidden]
        if points:
            pivot = max(points, key=name_key)
            for j in rows:
                if j != i and pivot in rows[j]:
                    rows[j] = _without(pivot, rows[j], row)
    return {i: equal(given[i], row, rank) for i, row in rows.items()}


def _without(pivot: Expr, row: Mapping[Expr, Fraction], other: Mapping[Expr, Fraction]) -> dict[Expr, Fraction]:
    """The row minus the multiple of the other that leaves the pivot out."""
    factor = row[pivot] / other[pivot]
    found = {e: row.get(e, Fraction(0)) - factor * other.get(e, Fraction(0)) for e in {**row, **other}}
    return {e: c for e, c in found.items() if c}


# --- names for meets -----------------------------------------------------------------------------------------------


def with_named_meets(given: Sequence[Assumption], rank: int) -> list[Facts] | None:
    """The conditions with a new point in place of each point that is written as a meet; None if there are none such.

    Six points on a conic are read as three such points on a line.
    """
    return _renamed(given, rank, ())[0]


def on_known_lines(given: Sequence[Assumption], rank: int) -> list[Facts] | None:
    """The same where assumptions name lines on which such new points may be: hexagons in conics have them as sides,
    and what follows for the new points on them is added; None if there are no such lines.
    """
    lines = {line for a in given for line, _ in _lines(a)}
    found, helpers = _renamed(given, rank, lines)
    return [*found, *_beside(given, rank, helpers)] if found and lines else None


def _renamed(
    given: Sequence[Assumption], rank: int, lines: Collection[frozenset[Expr]]
) -> tuple[list[Facts] | None, Mapping[Expr, Helper]]:
    """The conditions with names for meets, None if there are no meets; and the new points."""
    helpers: dict[Expr, Helper] = {}
    found = [understood(on_pascal_line(a, rank, lines), lambda a: _named_meets(a, rank, helpers)) for a in given]
    return found if helpers else None, helpers


def on_pascal_line(a: Assumption, rank: int, lines: Collection[frozenset[Expr]] = ()) -> Assumption:
    """An assumption that six points lie on a conic as one about the points in which opposite sides meet; or itself.

    Of the sides of the hexagon as many as can be are among `lines`, of which more is said.
    """
    six = hexagon(a.args[0], rank) if a.kind == "zero" else None
    return a if six is None else Assumption("collinear", pascal(_through(six, lines)), a.text, a.place)


def _through(six: Sequence[str], lines: Collection[frozenset[Expr]]) -> Sequence[str]:
    """The hexagon with these corners that has most of the lines as sides, the first such one."""
    known = {frozenset((a, b)) for a, b in combinations(six, 2) if frozenset((Point(a), Point(b))) in lines}
    if not known:
        return six
    hexagons = ((six[0], *rest) for rest in permutations(six[1:]))
    return max(hexagons, key=lambda h: sum(frozenset(side) in known for side in pairwise((*h, h[0]))))


def _named_meets(assumption: Assumption, rank: int, helpers: dict[Expr, Helper]) -> Facts:
    """The facts of an assumption in which each point that is a meet has got a name."""
    new: list[Helper] = []

    def walk(e: Expr) -> Expr:
        match e:
            # The meet lies on what is met only if that is a line or a plane, and not a sum of lines.
            case Meet(args=args) if e.step == 1 and all(is_extensor(a, rank) for a in args):
                if e not in helpers:
                    helpers[e] = Helper(f"meet:{len(helpers) + 1}", meet=e)
                    new.append(helpers[e])
                return Point(helpers[e].name)
            case Join(args=args):
                return ex.join(*map(walk, args), rank=rank)
            case Meet(args=args):
                return ex.meet(*map(walk, args), rank=rank)
            case Bracket(args=args):
                return bracket(*map(walk, args), rank=rank)
        return e

    def inside(e: Expr) -> Expr:
        """That a meet is zero says nothing of a point."""
        return ex.meet(*map(walk, e.args), rank=rank) if isinstance(e, Meet) and assumption.kind == "zero" else walk(e)

    args = tuple(map(inside, assumption.args))
    renamed = Assumption(assumption.kind, args, assumption.text, assumption.place)
    conditions = [on(renamed, Point(h.name), a, rank) for h in new for a in _met(h)]
    meets = tuple(h.meet for h in new if h.meet is not None)
    return all_of([facts(renamed, rank), Facts(tuple(conditions), meets, tuple(new))])


def _beside(given: Sequence[Assumption], rank: int, helpers: Mapping[Expr, Helper]) -> Iterator[Facts]:
    """What follows for a meet with a line cd on which more is said to lie: it is on a line with that and c, or d."""
    for a in given:
        for line, others in _lines(a):
            for h in helpers.values():
                if line in map(frozenset, (e.children for e in _met(h) if isinstance(e, Join))):
                    for some in product([Point(h.name)], others, sorted(line, key=name_key)):
                        yield dependent(a, some, 3, rank)


def _lines(a: Assumption) -> Iterator[tuple[frozenset[Expr], list[Expr]]]:
    """The lines through two points on which an assumption says that more lies, and what."""
    if a.kind == "collinear":
        for pair in combinations([e for e in a.args if isinstance(e, Point)], 2):
            yield frozenset(pair), [e for e in a.args if e not in pair]
    elif a.kind == "incident":
        x, line = small_first(*a.args)
        if x.step == 1 and line.step == 2 and isinstance(line, Join) and of_points(line):
            yield frozenset(line.args), [x]


def _met(helper: Helper) -> tuple[Expr, ...]:
    return helper.meet.args if isinstance(helper.meet, Meet) else ()


# --- quadratic equations -------------------------------------------------------------------------------------------


def on_quadrics(given: Sequence[Assumption], rank: int) -> list[Facts] | None:
    """The conditions as they are written; of those that are quadratic in a point with the quadric on which it is. None
    if there are none such.
    """
    found = as_written(given, rank)
    curved = {c: some for f in found for c in f.conditions if (some := _through_points(c, rank))}
    if not curved:
        return None
    return [
        replace(f, conditions=tuple(replace(c, through=curved[c]) if c in curved else c for c in f.conditions))
        for f in found
    ]


def _through_points(c: IncidenceCondition, rank: int) -> Mapping[str, Quadric]:
    if c.equation.step:
        return {}
    names = [n for n in points_of(c.equation) if n not in c.within]
    return {n: q for n in names if (q := quadric(c.equation, n, rank)) is not None}


FURTHER_ROADS: tuple[Callable[[Sequence[Assumption], int], list[Facts] | None], ...] = (on_quadrics,)
"""Those that are tried where no other one leads anywhere."""

ROADS: tuple[Callable[[Sequence[Assumption], int], list[Facts] | None], ...] = (as_written, together, with_named_meets)
