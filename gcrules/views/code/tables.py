"""Tables of numbers in the source code of each language."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate
from math import isfinite
from typing import Any

from gcrules.core.errors import InputError
from gcrules.poses.compiling.loop_tables import LoopTables
from gcrules.views.code.languages import Language

__all__ = ["number", "table", "tables_of", "written"]


def number(x: float | Fraction) -> str:
    """As a literal of all these languages. Raises InputError where it is beyond floats."""
    try:
        found = float(x)
    except OverflowError:
        found = float("inf")
    if not isfinite(found):
        raise InputError("a number of this robot is too large for floats", hint="choose another unit")
    return repr(found)


def table(spelt: Language, rows: Sequence[Sequence[float]]) -> str:
    """An array of arrays, one a line."""
    lines = [written(spelt, [float(x) for x in row]) for row in rows]
    return spelt.array.format(items="\n    " + ",\n    ".join(lines))


def written(spelt: Language, value: Any) -> str:
    """A number, an array of numbers, or one of such arrays; whole numbers and truths without a point."""
    if isinstance(value, int):
        return str(int(value))
    if isinstance(value, float):
        return number(value)
    items = list(value)
    if items and not isinstance(items[0], int | float):
        inner = [written(spelt, item) for item in items]
        if isinstance(items[0][0], float):
            return spelt.array.format(items="\n    " + ",\n    ".join(inner))
        return spelt.array.format(items=", ".join(inner))
    return spelt.array.format(items=", ".join(written(spelt, item) for item in items))


def tables_of(t: LoopTables) -> dict[str, Any]:
    """What the templates of loops name."""
    held = [pair for hold in t.holds for pair in hold.pairs]
    starts = [0, *accumulate(len(hold.pairs) for hold in t.holds)]
    return {
        "motions": len(t.parents),
        "amounts": t.number,
        "gaps": len(t.gaps),
        "rank": t.rank,
        "platform": t.platform,
        "holds": len(t.holds),
        "longest": 6 * max(len(hold.pairs) for hold in t.holds),
        "points": len(t.places),
        "width": len(t.keep),
        "pairs": len(held),
        "size": t.size,
        "centre": t.centre,
        "parent": t.parents,
        "used": t.amounts,
        "twist": t.twists.tolist(),
        "gap": t.gaps,
        "coordinate": t.coordinates,
        "locked": t.locked,
        "driven": t.driven,
        "actuated": t.actuators,
        "unit": t.units,
        "link": [place.link for place in t.places],
        "is_point": [place.point for place in t.places],
        "home": [place.home for place in t.places],
        "pair": held,
        "pair_from": starts,
        "hold_rank": [hold.rank for hold in t.holds],
        "hold_count": [hold.count for hold in t.holds],
        "end": [hold.end for hold in t.holds],
        "arm": [hold.arm for hold in t.holds],
        "plus": [hold.plus for hold in t.holds],
        "minus": [hold.minus for hold in t.holds],
        "keep": t.keep,
        "scale": t.scale.tolist(),
    }
