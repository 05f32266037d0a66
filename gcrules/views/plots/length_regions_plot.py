r"""The plane of two lengths, coloured by the number of assembly modes, with the singular curve and its cusps."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Literal

from gcrules.core.errors import InputError
from gcrules.poses.length_regions.report import LengthRegions, Strip
from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Run, Shape, Stroke, Text, text_width

__all__ = ["picture", "svg"]

_WIDTH, _LEFT, _RIGHT, _TOP, _BOTTOM = 520.0, 56.0, 18.0, 44.0, 52.0
_TALLEST = 2.0  # times as tall as wide
_SIZE = 11.0
_OVERHANG = 3  # times the width of a strip that a name may take
_LEAST = 12.0  # width and height on paper of a region in which its name is written
_OPACITY = {0: 0.0, 2: 0.22, 4: 0.5, 6: 0.85}
_COLOUR = "entity1"


def picture(r: LengthRegions) -> Drawing:
    """Raises InputError for regions of three lengths."""
    if not r.strips:
        raise InputError("a picture is of two lengths", hint="give two ranges, and hold the third leg")
    first, second = r.over
    wide = _WIDTH - _LEFT - _RIGHT
    tall = min(max((second.high - second.low) / (first.high - first.low), 1 / _TALLEST), _TALLEST) * wide
    x = Axis(first.low, first.high, _LEFT, _LEFT + wide)
    y = Axis(second.low, second.high, _TOP + tall, _TOP)
    modes = {s.name: s.modes for s in r.regions}
    shapes: list[Shape] = []
    for strip in r.strips:
        shapes += _areas(strip, x, y, modes)
    for strip in r.strips:
        shapes += _curves(strip, x, y)
    shapes += [Circle((x(a), y(b)), 2.6, fill="mark", stroke="paper", width=0.8) for a, b in r.cusps]
    shapes += _names(r, x, y)
    shapes += _frame(r, x, y)
    shapes += _legend(r)
    title = f"{r.title}: {r.most} regions of {first.name} and {second.name}"
    return Drawing(_WIDTH, _TOP + tall + _BOTTOM, tuple(shapes), title)


def svg(r: LengthRegions) -> str | None:
    """The picture as SVG; nothing for three lengths."""
    return picture(r).svg() if r.strips else None


def _line(strip: Strip, n: int, x: Axis, y: Axis) -> list[XY]:
    return [(x(a), y(heights[n])) for a, heights in zip(strip.at, strip.heights, strict=True)]


def _areas(strip: Strip, x: Axis, y: Axis, modes: dict[str, int]) -> Iterator[Shape]:
    for n, name in enumerate(strip.regions):
        if name and modes[name]:
            outline = _line(strip, n - 1, x, y) + _line(strip, n, x, y)[::-1]
            yield Polygon(tuple(outline), fill=_COLOUR, fill_opacity=_OPACITY.get(modes[name], 1.0))


def _curves(strip: Strip, x: Axis, y: Axis) -> Iterator[Shape]:
    for n, edge in enumerate(strip.edges):
        if not edge and (strip.regions[n] or strip.regions[n + 1]):
            places = _line(strip, n, x, y)
            for start, end in pairwise(places):
                yield Stroke(start, end, "ink", 0.9)


def _names(r: LengthRegions, x: Axis, y: Axis) -> Iterator[Shape]:
    """The name of each region where there is most room, if there is enough."""
    best: dict[str, tuple[float, XY]] = {}
    for strip in r.strips:
        middle = len(strip.at) // 2
        width = abs(x(strip.at[-1]) - x(strip.at[0]))
        for n, name in enumerate(strip.regions):
            if name:
                low, high = (y(strip.heights[middle][k]) for k in (n - 1, n))
                room = min(_OVERHANG * width, abs(high - low))
                if room > best.get(name, (0.0, (0.0, 0.0)))[0]:
                    best[name] = room, (x(strip.at[middle]), (low + high) / 2 + 4)
    for name, (room, at) in best.items():
        if room >= _LEAST:
            yield Text(at, (Run(name),), _SIZE, "middle", halo=True)


def _frame(r: LengthRegions, x: Axis, y: Axis) -> Iterator[Shape]:
    corners = ((x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end))
    yield Polygon(corners, stroke="ink", width=1.0)
    for tick in x.ticks(8):
        yield Stroke((x(tick), y.start), (x(tick), y.start + 4), "ink", 1.0)
        yield _words((x(tick), y.start + 17), f"{tick:.4g}", "middle")
    for tick in y.ticks(8):
        yield Stroke((x.start - 4, y(tick)), (x.start, y(tick)), "ink", 1.0)
        yield _words((x.start - 8, y(tick) + 4), f"{tick:.4g}", "end")
    held = ", ".join(f"{n} = {value:.6g}" for n, value in r.held)
    first, second = r.over
    yield _words(((x.start + x.end) / 2, y.start + 36), f"length of {first.name} ({held})", "middle")
    yield _words((x.start - 44, y.end - 10), f"length of {second.name}")


def _legend(r: LengthRegions) -> Iterator[Shape]:
    u = _LEFT + 70
    for modes in r.counts:
        corners = ((u, 10), (u + 14, 10), (u + 14, 22), (u, 22))
        yield Polygon(corners, fill=_COLOUR if modes else "paper", fill_opacity=_OPACITY.get(modes, 1.0) or 1.0)
        yield Polygon(corners, stroke="muted", width=0.6)
        words = _words((u + 19, 20), f"{modes} modes")
        yield words
        u += 32 + text_width(words)
    if r.cusps:
        yield Circle((u + 4, 16), 2.6, fill="mark", stroke="paper", width=0.8)
        yield _words((u + 12, 20), "cusp")


def _words(at: XY, text: str, anchor: Literal["start", "middle", "end"] = "start") -> Text:
    return Text(at, (Run(text),), _SIZE, anchor)
