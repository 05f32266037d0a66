"""Kinds of positions, and those that come of them by symmetries of the assumptions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from math import comb
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.parts import substitute
from gcrules.algebra.scalars import bracket
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass

__all__ = ["MAX_KINDS", "PositionKind", "with_images"]

MAX_KINDS = 64
_MAX_SETS = 5_000  # sets of points of which it is asked whether they are dependent


@dataclass(frozen=True)
class PositionKind:
    """The positions at which the scalars of `where` vanish beside what is given, by their construction.

    A kind that is an `image` of another one comes of it by a symmetry of the assumptions. The construction of the other
    one leaves it out, as an extensor of its `nonzero` vanishes there.
    """

    where: tuple[Expr, ...]
    construction: Construction
    image: bool = False


def with_images(told: Sequence[PositionKind], symmetries: Sequence[Mapping[str, str]]) -> tuple[PositionKind, ...]:
    """With the kinds that come of these by symmetries of the assumptions, and are others.

    Constructions are dense in what they reach, and these are as large as those that they come of; so where other points
    are dependent, the positions are others.
    """
    c = told[0].construction
    if not symmetries or comb(len(c.names), min(c.rank, len(c.names) // 2)) > _MAX_SETS:
        return tuple(told)
    found = {_dependent(kind.construction): kind for kind in told}
    if len(found) < len(told):
        return tuple(told)
    waiting = list(told)
    for kind in waiting:
        for s in symmetries:
            checkpoint()
            c = kind.construction.renamed(partial(_image, s), kind.construction.points)
            if len(found) < MAX_KINDS and (dependent := _dependent(c)) not in found:
                names: dict[str, Expr] = {old: Point(new) for old, new in s.items()}
                where = tuple(substitute(e, names, c.rank) for e in kind.where)
                waiting.append(PositionKind(where, c, image=True))
                found[dependent] = waiting[-1]
    if len(found) == len(told):
        return tuple(told)
    return tuple(
        replace(kind, where=kind.where or _only_there(dependent, [d for d in found if d != dependent], kind))
        for dependent, kind in found.items()
    )


def _image(symmetry: Mapping[str, str], name: str) -> str:
    stem, colon, rest = name.partition(":")
    return f"{symmetry.get(stem, stem)}{colon}{rest}"


def _dependent(c: Construction) -> frozenset[tuple[str, ...]]:
    """The points that are dependent, as many as the rank at most, wherever a construction leads."""
    at = Evaluator(c.random_points("dependent"), c.rank, PRIME)
    found: set[tuple[str, ...]] = set()
    joined: dict[tuple[str, ...], list[Any]] = {(n,): at.value(Point(n)) for n in c.names}
    for size in range(2, c.rank + 1):
        for some in combinations(sorted(c.names), size):
            checkpoint()
            if any(part in found for part in combinations(some, size - 1)):
                found.add(some)
                continue
            joined[some] = at.joined(joined[some[:-1]], size - 1, joined[some[-1:]], 1)
            if not any(joined[some]):
                found.add(some)
    return frozenset(found)


def _only_there(
    dependent: frozenset[tuple[str, ...]], others: Iterable[frozenset[tuple[str, ...]]], kind: PositionKind
) -> tuple[Expr, ...]:
    """What vanishes there and at no other kind, or else what tells it from each of the others."""
    rank = kind.construction.rank
    order = sorted(dependent, key=lambda some: (-len(some), some))

    def vanishing(some: tuple[str, ...]) -> Expr:
        e = ex.join(*map(Point, some), rank=rank)
        return bracket(e, rank=rank) if e.step == rank else e

    left = list(others)
    alone = next((some for some in order if not any(some in other for other in left)), None)
    if alone is not None:
        return (vanishing(alone),)
    told = []
    for some in order:
        if any(some not in other for other in left):
            told.append(vanishing(some))
            left = [other for other in left if some in other]
    return tuple(told)
