"""What drawings of answers have in common: words, marks of singular places, axes with their numbers, keys."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import XY, Circle, Polygon, Run, Shape, Stroke, Text, mapped

__all__ = ["axis_below", "keyed", "marker", "plane", "signed", "ticks", "words_at"]

_SIZE = 11.0
_ROW = 20.0  # of a key
_HALF_TURN = 180.0


def words_at(at: XY, text: str, anchor: Literal["start", "middle", "end"] = "start") -> Text:
    """Words of the size of labels."""
    return Text(at, (Run(text),), _SIZE, anchor)


def signed(digits: str) -> str:
    """With the sign of mathematics."""
    return digits.replace("-", "−")


def marker(kind: str, at: XY) -> Shape:
    """A full diamond where something is crossed, an open circle where it is touched, a full square at its ends."""
    (u, v), d = at, 4.5
    if kind == "touches":
        return Circle(at, d, fill="paper", stroke="mark", width=1.8)
    if kind == "crosses":
        return Polygon(((u - d, v), (u, v - d), (u + d, v), (u, v + d)), fill="mark", stroke="paper", width=0.8)
    d *= 0.75
    return Polygon(((u - d, v - d), (u + d, v - d), (u + d, v + d), (u - d, v + d)), fill="mark", stroke="paper")


def ticks(axis: Axis) -> list[float]:
    """Round numbers; of a whole turn in degrees every 60."""
    if (axis.low, axis.high) == (-_HALF_TURN, _HALF_TURN):
        return [60.0 * k for k in range(-3, 4)]
    return axis.ticks(7)


def axis_below(x: Axis, bottom: float, label: str) -> Iterator[Shape]:
    """The numbers of an axis, and what it is, below a picture."""
    for tick in ticks(x):
        yield Stroke((x(tick), bottom), (x(tick), bottom + 4), "ink", 1.0)
        yield words_at((x(tick), bottom + 17), signed(f"{tick:.4g}"), "middle")
    yield words_at(((x.start + x.end) / 2, bottom + 34), label, "middle")


def plane(x: Axis, y: Axis, across: str, up: str) -> Iterator[Shape]:
    """A field with a grid, an axis below and one to the left of it."""
    for tick in ticks(x):
        yield Stroke((x(tick), y.start), (x(tick), y.end), "muted", 0.5, 0.3)
    for tick in ticks(y):
        yield Stroke((x.start, y(tick)), (x.end, y(tick)), "muted", 0.5, 0.3)
        yield Stroke((x.start - 4, y(tick)), (x.start, y(tick)), "ink", 1.0)
        yield words_at((x.start - 8, y(tick) + 4), signed(f"{tick:.4g}"), "end")
    yield Polygon(((x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end)), stroke="ink")
    yield from axis_below(x, y.start, across)
    yield words_at((x.start - 38, y.end - 9), up)


def keyed(
    shapes: Sequence[Shape], key: Sequence[tuple[Shape, str]], left: float, top: float
) -> tuple[list[Shape], float]:
    """With what the marks mean below, and the height of all. Marks are drawn around (8, −4), beside the words."""
    found = list(shapes)
    for n, (sign, said) in enumerate(key):
        place = left, top + _ROW * n + 8
        found += [mapped(sign, 1.0, place), words_at((place[0] + 24, place[1]), signed(said))]
    return found, top + _ROW * len(key) + 6
