"""The relations of the language: those of incidence, with checks of their arguments, and those that are written out.

>>> [*INCIDENCES]
['collinear', 'coplanar', 'concurrent', 'incident']
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from itertools import combinations

from gcrules.algebra import conics, metric, quadric_forms
from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.letter_words import RELATIONS_OF_LETTERS
from gcrules.algebra.language.parse_tree import Node, span_of
from gcrules.algebra.language.words import FLAT, POINT, SEGMENT, Relation
from gcrules.algebra.letters import named_letter
from gcrules.algebra.metric import Infinity
from gcrules.algebra.names import step_name
from gcrules.algebra.screw_letters import refuse_screw
from gcrules.core.errors import InputError, StepError

__all__ = ["INCIDENCES", "RELATIONS", "RELATION_NAMES"]

_Equations = Iterable[Expr]


def _points_only(number: int) -> Callable[[tuple[Expr, ...], list[Node], int], None]:
    """A check that all arguments are points, at least so many different ones."""

    def check(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
        for arg, tree in zip(args, trees, strict=True):
            if arg.step != 1:
                joined = isinstance(arg, ex.Join) and named_letter(arg) is None
                hint = "separate the points with commas" if joined else None
                what = f"{step_name(arg.step, rank)} where a point is expected"
                raise StepError(what, span=span_of(tree), hint=hint)
        different = len({*args})
        if different < number:
            found = "1 point is" if different == 1 else f"{different} points are"
            raise InputError(f"{found} always so; at least {number} different ones are expected")

    return check


def _steps_between(number: int) -> Callable[[tuple[Expr, ...], list[Node], int], None]:
    """At least `number` extensors that are neither scalars nor the whole space."""

    def check(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
        for arg, tree in zip(args, trees, strict=True):
            refuse_screw(arg, span_of(tree))
            if not 1 <= arg.step < rank:
                raise StepError(f"{step_name(arg.step, rank)} where an extensor is expected", span=span_of(tree))
        if len(args) < number:
            raise InputError(f"at least {number} extensors are expected, found {len(args)}")

    return check


def _pair(args: tuple[Expr, ...], trees: list[Node], rank: int) -> None:
    _steps_between(2)(args, trees, rank)
    if len(args) != 2:
        raise InputError(f"incident(X, Y) has two extensors, found {len(args)}")


INCIDENCES: Mapping[str, Callable[[tuple[Expr, ...], list[Node], int], None]] = {
    "collinear": _points_only(3),
    "coplanar": _points_only(4),
    "concurrent": _steps_between(2),
    "incident": _pair,
}
"""Relations of points, lines and planes in any rank, each with the check of its arguments."""


# --- relations that are written out ---------------------------------------------------------------------------------


def _any_of(number: int, scalar: Callable[..., Expr], *, metric: bool = True) -> Callable[..., _Equations]:
    """A scalar of any so many of the points."""

    def whole(*args: object) -> _Equations:
        head, points = (args[:1], args[1:]) if metric else ((), args)
        return (scalar(*head, *some) for some in combinations(points, number))

    return whole


def _beside(number: int, scalar: Callable[..., Expr], *, metric: bool = True) -> Callable[..., _Equations]:
    """A scalar of the first points, one fewer than so many, with each of the others."""

    def chain(*args: object) -> _Equations:
        head, points = (args[:1], args[1:]) if metric else ((), args)
        return [scalar(*head, *points[: number - 1], p) for p in points[number - 1 :]]

    return chain


def _equidistant(at: Infinity, o: Expr, first: Expr, *others: Expr) -> _Equations:
    return [metric.equidistant(at, o, first, p) for p in others]


def _equal_distance(at: Infinity, first: tuple[Expr, Expr], *others: tuple[Expr, Expr]) -> _Equations:
    return [metric.equal_distances(at, first, pair) for pair in others]


def _one(scalar: Callable[..., Expr]) -> Callable[..., _Equations]:
    return lambda *args: [scalar(*args)]


_PLANE, _SPACE, _BOTH = (3,), (4,), (3, 4)

RELATIONS: Mapping[str, Relation] = {
    w.name: w
    for w in (
        Relation(
            "parallel(ab, cd)",
            "two lines have one direction, in space also a line and a plane; two planes meet at infinity",
            (FLAT, FLAT),
            _BOTH,
            whole=_one(metric.parallel),
        ),
        Relation(
            "perpendicular(ab, cd)",
            "two lines are at right angles, in space also planes, or a line and a plane",
            (FLAT, FLAT),
            _BOTH,
            whole=_one(metric.perpendicular),
        ),
        Relation(
            "concyclic(a, b, c, d, …)",
            "the points are on a circle, or on a line",
            (POINT,) * 4,
            _PLANE,
            open=True,
            whole=_any_of(4, metric.concyclic),
            chain=_beside(4, metric.concyclic),
        ),
        Relation(
            "cospherical(a, b, c, d, e, …)",
            "the points are on a sphere, or in a plane",
            (POINT,) * 5,
            _SPACE,
            open=True,
            whole=_any_of(5, metric.cospherical),
            chain=_beside(5, metric.cospherical),
        ),
        Relation(
            "equidistant(o, a, b, …)",
            "o is as far from a as from b and the others",
            (POINT,) * 3,
            _BOTH,
            open=True,
            whole=_equidistant,
        ),
        Relation(
            "equal_distance(ab, cd, …)",
            "a is as far from b as c from d",
            (SEGMENT, SEGMENT),
            _BOTH,
            open=True,
            whole=_equal_distance,
        ),
        Relation(
            "on_conic(a, b, c, d, e, f, …)",
            "the points are on a conic, which may be two lines",
            (POINT,) * 6,
            _PLANE,
            metric=False,
            letter="conic K",
            open=True,
            whole=_any_of(6, conics.on_conic, metric=False),
            chain=_beside(6, conics.on_conic, metric=False),
        ),
        Relation(
            "on_quadric(a, b, c, d, e, f, g, h, i, j, …)",
            "the points are on a quadric, which may be a cone or two planes",
            (POINT,) * 10,
            _SPACE,
            metric=False,
            letter="quadric Q",
            open=True,
            whole=_any_of(10, quadric_forms.on_quadric, metric=False),
            chain=_beside(10, quadric_forms.on_quadric, metric=False),
        ),
    )
}
"""Relations that are equations of brackets, joins and meets, by their names."""

RELATION_NAMES = tuple(
    dict.fromkeys((*INCIDENCES, *RELATIONS, *(n for some in RELATIONS_OF_LETTERS.values() for n in some)))
)
"""The names of all relations, which grammar.lark lists too."""
