"""The points at infinity of a structure, and what its condition makes of them."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from gcrules.algebra.expr import Join, points_of, subexpressions
from gcrules.algebra.language.text import text
from gcrules.core.english import agreeing
from gcrules.rules.condition import Condition

__all__ = ["at_infinity"]


def at_infinity(
    ideal: Sequence[str], condition: Condition | None, names: Sequence[str] = (), axes: Collection[str] = ()
) -> str:
    """ "x, z, y; xzy is the plane at infinity", where the condition joins three of them. `axes` are the names of fixed
    directions at right angles; others may be parallel to one plane, where their join is no plane.
    """
    planes = {
        text(e, names=tuple(names)): set(points_of(e)) <= {*axes}
        for side in ((condition.expression, condition.cofactor) if condition else ())
        for e in subexpressions(side)
        if isinstance(e, Join) and e.step == 3 and set(points_of(e)) <= {*ideal}
    }
    if not planes:
        return ", ".join(ideal)
    unless = "" if all(planes.values()) else ", unless its three directions are parallel to one plane"
    return f"{', '.join(ideal)}; {agreeing(sorted(planes), 'is', 'are')} the plane at infinity{unless}"
