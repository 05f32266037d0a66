r"""Where incidences fail: positions at which something vanishes that their proofs assume not to vanish.

>>> from gcrules.algebra.language.statements import parse_script
>>> at = parse_script("rank 3  given collinear(a, b, c), collinear(a, b, d)").context
>>> (kind,) = kinds(at)
>>> from gcrules.algebra.language.syntax import parse
>>> tried, found = failing(at, kind, kind.construction.nonzero, (), [[parse("[acd]", rank=3)]], 10)
>>> print(*tried, *found[0])
ab ab
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from gcrules.algebra.assumptions.assumed import PositionKind, kinds
from gcrules.algebra.assumptions.nondegeneracy import met
from gcrules.algebra.expr import Expr
from gcrules.algebra.space import Assumption, Space
from gcrules.core.budget import checkpoint, within
from gcrules.core.errors import InputError, LimitReached

__all__ = ["failing"]


def failing(
    space: Space,
    kind: PositionKind,
    extensors: Iterable[Expr],
    nonzero: Sequence[Expr],
    claims: Sequence[Iterable[Expr]],
    seconds: float,
) -> tuple[tuple[Expr, ...], tuple[tuple[Expr, ...], ...]]:
    """Those of the extensors that were tried; and for each claim, which is that expressions vanish, those that vanish
    at some positions where the assumptions hold, the claim fails, and nothing of `nonzero` vanishes.

    Such positions are looked for with the assumption that the extensor vanishes, if that is resolved in this time.
    """
    found: list[list[Expr]] = [[] for _ in claims]
    tried = []
    try:
        with within(seconds=seconds):
            for e in extensors if claims else ():
                there = _where_vanishing(space, kind, e, nonzero)
                if there is not None:
                    failed = [any(not k.construction.vanishes(s) for k in there for s in claim) for claim in claims]
                    tried.append(e)
                    for known, fails in zip(found, failed, strict=True):
                        known += [e] if fails else []
    except LimitReached:
        checkpoint()  # the time of all may be over
    return tuple(tried), tuple(map(tuple, found))


def _where_vanishing(
    space: Space, kind: PositionKind, e: Expr, nonzero: Sequence[Expr]
) -> Sequence[PositionKind] | None:
    more = (Assumption("zero", (s,), f"{s} == 0") for s in (*kind.where, e))
    try:
        return met(kinds(replace(space, given=(*space.given, *more)), kind.construction.names), nonzero)
    except InputError:
        return None
    except LimitReached:
        checkpoint()
        return None
