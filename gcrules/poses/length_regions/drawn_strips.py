r"""The strips of a plane as they are drawn: the heights of its branches at some places of each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import cos, floor, log2, pi

from gcrules.core.budget import checkpoint
from gcrules.poses.length_regions.integer_polynomials import root_of
from gcrules.poses.length_regions.report import Strip
from gcrules.poses.length_regions.slabs import Cell, Plane

__all__ = ["drawn_strips"]

Heights = tuple[float, ...]

_PLACES = 40  # of the whole width
_LEAST = 5  # of each strip
_ENDS = 1e-3  # of its width, the way from its ends to the first and the last place


def drawn_strips(found: Plane, scale: int, names: Mapping[Cell, str]) -> tuple[Strip, ...]:
    """All of them; lengths are the roots of what the plane counts with, divided by `scale`."""
    ends = [root_of(x, scale) for x in found.box[0]]
    strips = []
    for k in range(len(found.lines) + 1):
        checkpoint()
        low, high = (root_of(x, scale) for x in found.strip(k))
        number = _LEAST + int(_PLACES * (high - low) / (ends[1] - ends[0]))
        shares = [(1 - cos(pi * n / (number - 1))) / 2 for n in range(number)]
        at = [low + (high - low) * (_ENDS + (1 - 2 * _ENDS) * s) for s in shares]
        short = 1 << (4 - floor(log2(_ENDS * (high - low))))
        at = [round(a * short) / short for a in at]
        every = [found.branches(Fraction(a) ** 2 * scale) for a in at]
        count = len(every[0])
        every = [own if len(own) == count else every[0] for own in every]
        heights = [tuple(root_of((a + b) / 2, scale) for a, b in own) for own in every]
        first = _end(found, scale, k - 1, low, at[:2], heights[:2])
        last = _end(found, scale, k, high, at[:-3:-1], heights[:-3:-1])
        strips.append(
            Strip(
                at=(low, *at, high),
                heights=(first, *heights, last),
                regions=tuple(names.get((k, n), "") for n in range(count + 1)),
                edges=tuple(a == b and a in found.box[1] for a, b in every[0]),
            )
        )
    return tuple(strips)


def _end(found: Plane, scale: int, line: int, x: float, at: Sequence[float], heights: Sequence[Heights]) -> Heights:
    """The heights at an end of a strip, from the two places next to it, and from the double point there."""
    share = (x - at[0]) / (at[0] - at[1])
    made = [max(a + share * (a - b), 0.0) for a, b in zip(*heights, strict=True)]
    for point in found.double:
        if point.number == line:
            for n in point.left if x > at[0] else point.right:
                made[n] = root_of(point.middle, scale)
    return tuple(made)
