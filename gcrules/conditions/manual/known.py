"""Which kind of condition an expression is that was proved: by its shape, or as one of the readings that are known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Number, Point, Power, Product, Sum, Superbracket
from gcrules.conditions.manual.automatic import automatic, oracle_of
from gcrules.conditions.manual.board import KINDS, Board
from gcrules.conditions.manual.follow import follow
from gcrules.rules.catalog.file import load
from gcrules.rules.claims import PROVED, describe
from gcrules.rules.condition import Condition, Entity, starred
from gcrules.rules.statement import NOTHING, Part, Statement, filled, listing, say

__all__ = ["named_condition", "shape"]


def named_condition(board: Board, e: Expr, cofactor: Expr, coefficient: int) -> Condition:
    """cofactor · superbracket = coefficient · e, which is proved, with a kind and a sentence.

    The kind is that of the same expression (whatever its signs and the sequence of its parts) among what follows from
    the entities and among the readings of the automatic analysis, else that of its shape, else `expression`.
    """
    analysis = automatic(board.structure)
    statements = load(()).statements
    following = [describe(c, board.structure, oracle_of(board.structure), statements) for c in follow(board).claims]
    readings = (*following, analysis.condition, *analysis.readings)
    for known in (*(r for r in readings if r.expression == e), *readings):  # the same expression before a like one
        if shape(known.expression) == shape(e):
            return replace(known, expression=e, cofactor=cofactor, coefficient=coefficient, certificate=PROVED)
    kind, entities, meaning = _by_shape(e, statements)
    if not kind:
        kind = "expression"
        where = "The" if isinstance(cofactor, Number) else say("Where {} is not zero, the", cofactor)
        meaning = say("{} robot is singular exactly when {} is zero.", where, e)
    return Condition(kind, e, meaning, PROVED, cofactor, coefficient, entities)


def shape(e: Expr) -> object:
    """What is left of an expression without signs, numbers and the sequence of parts."""
    match e:
        case Point(name=name):
            return name
        case Number():
            return ""
        case Product(factors=factors):
            parts = [shape(f) for f in factors if not isinstance(f, Number)]
            return parts[0] if len(parts) == 1 else ("Product", tuple(sorted(parts, key=repr)))
        case Power(base=base, exponent=n):
            return ("Product", (shape(base),) * n)
    return (type(e).__name__, tuple(sorted(map(shape, e.children), key=repr)))


def _by_shape(e: Expr, statements: Mapping[str, str]) -> tuple[str, tuple[Entity, ...], Statement]:
    """Kind, entities and meaning of products of brackets with at most one meet; nothing for anything else."""
    brackets, meets = [], []
    for factor in e.factors if isinstance(e, Product) else (e,):
        base, times = (factor.base, factor.exponent) if isinstance(factor, Power) else (factor, 1)
        if isinstance(base, Bracket):
            brackets += [_points(base.args)] * times
        elif isinstance(base, Meet):
            meets.append([_points(a.args) if isinstance(a, Join) else () for a in base.args] * times)
        elif not isinstance(base, (Number, Superbracket, Sum)):
            return "", (), NOTHING
    parts = sorted(meets[0], key=len, reverse=True) if len(meets) == 1 else []
    sizes = (len(brackets), tuple(map(len, parts)), len(meets))
    kind = _SHAPES.get(sizes, "")
    if not kind or not all(brackets) or not all(parts):
        return "", (), NOTHING
    found = [("tetrahedron", n) for n in brackets] + [(KINDS[len(n)], n) for n in parts]
    flats = {k: [Join(tuple(map(Point, n))) for what, n in found if what == k] for k in KINDS.values()}
    template = statements[kind]
    if kind == "three-tetrahedra" and len({frozenset(n) for n in brackets}) == 1:
        template = statements["three-tetrahedra/one"]
    named: dict[str, Part] = {
        "tetrahedra": listing(flats["tetrahedron"]),
        "planes": listing(sorted(flats["plane"], key=str)),
        "line": listing(flats["line"]),
    }
    return kind, starred(found), filled(template, named.__getitem__)


_SHAPES = {
    (3, (), 0): "three-tetrahedra",
    (0, (3, 3, 3, 3), 1): "four-planes",
    (1, (3, 3, 2), 1): "tetrahedron-planes-line",
}
"""Numbers of brackets, steps of the parts of the meet, number of meets -> kind."""


def _points(args: tuple[Expr, ...]) -> tuple[str, ...]:
    """Names of points; () if there is anything else."""
    return tuple(a.name for a in args if isinstance(a, Point)) if all(isinstance(a, Point) for a in args) else ()
