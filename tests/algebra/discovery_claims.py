"""What discoveries say, asked part by part at places modulo a prime."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from algebra.quadric_figures import Vector

import gcrules as gc
from gcrules.algebra.evaluate import PRIME

__all__ = ["check_all", "holds", "place"]

Holding = Callable[[str, Sequence[str]], bool]


def place(v: Sequence[int]) -> Vector:
    """The multiple that begins with 1."""
    lead = pow(next(x for x in v if x % PRIME), -1, PRIME)
    return tuple(x * lead % PRIME for x in v)


def check_all(
    text: str, counts: Mapping[str, int], points: Mapping[str, Vector], flats: Iterable[str], holding: Holding
) -> None:
    """The discoveries in a drawing, each of which holds; with what is trivial they are as many as were counted."""
    found = gc.discover(text, limit=5_000, seconds=0)
    assert (set(found.points), set(found.flats)) == (set(points), set(flats))
    assert len(found.found) + found.trivial == sum(counts.values()), (text, counts)
    for d in found.found:
        assert holds(d.claim, points, holding), (d.claim, text)


def holds(claim: str, points: Mapping[str, Vector], holding: Holding) -> bool:
    """Whether a claim holds: that points are one, or relations, each by its word and the names in it."""
    if claim.endswith(" == 0"):
        return all(len({points[n] for n in part.split()[0]}) == 1 for part in claim.split(", "))
    for part in claim.replace("), incident", ")|incident").split("|"):
        word, _, rest = part.removesuffix(")").partition("(")
        if not holding(word, rest.replace("polar(", "").replace(")", "").split(", ")):
            return False
    return True
