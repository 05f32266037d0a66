"""The points at infinity of a structure, and what its condition makes of them."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.algebra.expr import Join, points_of, subexpressions
from gcrules.algebra.language.text import text
from gcrules.core.english import agreeing
from gcrules.rules.condition import Condition

__all__ = ["at_infinity"]


def at_infinity(ideal: Sequence[str], condition: Condition | None, names: Sequence[str] = ()) -> str:
    """ "x, z, y; xzy is the plane at infinity", where the condition joins three of them."""
    shown = ", ".join(ideal)
    if condition is None:
        return shown
    planes = {
        text(e, names=tuple(names))
        for side in (condition.expression, condition.cofactor)
        for e in subexpressions(side)
        if isinstance(e, Join) and e.step == 3 and set(points_of(e)) <= set(ideal)
    }
    return f"{shown}; {agreeing(sorted(planes), 'is', 'are')} the plane at infinity" if planes else shown
