"""Labels beside their points, kept clear of each other and of everything drawn, by search over fixed offsets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from math import cos, dist, hypot, pi, sin

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.drawing import XY, Run, Text, text_width

__all__ = ["Box", "Label", "label_box", "overlap", "place_labels"]

Box = tuple[float, float, float, float]
"""left, top, right, bottom"""

_DIRECTIONS = 24
_GAPS = (3.0, 7.0, 12.0, 19.0, 28.0, 40.0)
_LED = 19.0  # from this gap on a line leads to the label
_ASCENT, _DESCENT = 0.72, 0.24
_SWEEPS = 8
_AGAINST = 8.0  # what a square point of overlap of two labels costs
_OVER = 60.0  # and what it costs that they overlap at all
_ASTRAY = 20.0  # what it costs to stand nearer to something else
_SAME = 4.0  # points within which two places are one


@dataclass(frozen=True, slots=True)
class Label:
    """Text to be placed near `at`, outside a disc of the given radius, rather in the direction `toward`."""

    runs: tuple[Run, ...]
    at: XY
    toward: XY = (0.0, -1.0)
    radius: float = 5.0
    size: float = 15.0
    fill: str = "ink"


def label_box(text: Text) -> Box:
    """The area that a text covers, by the estimate of `text_width`."""
    width = text_width(text)
    left = text.at[0] - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * width
    return left, text.at[1] - _ASCENT * text.size, left + width, text.at[1] + _DESCENT * text.size


def overlap(a: Box, b: Box, margin: float = 0.0) -> float:
    """The area common to two boxes, one of them enlarged by a margin."""
    if a[2] <= b[0] - margin or b[2] + margin <= a[0] or a[3] <= b[1] - margin or b[3] + margin <= a[1]:
        return 0.0
    width = min(a[2], b[2] + margin) - max(a[0], b[0] - margin)
    height = min(a[3], b[3] + margin) - max(a[1], b[1] - margin)
    return width * height


def place_labels(
    labels: Sequence[Label],
    *,
    discs: Sequence[tuple[XY, float]] = (),
    strokes: Sequence[tuple[XY, XY]] = (),
    taken: Sequence[Box] = (),
    places: Sequence[XY] = (),
    bounds: Box | None = None,
) -> list[Text]:
    """One text for each label, in order.

    Labels stay inside the bounds and keep off each other and the `taken` boxes, then off the discs (centre, radius),
    then off the strokes, and are rather nearest to what they name than to others of the `places`; a line leads to those
    that stand far away. Starting from each label's own best place, labels are moved in turn until none gains by it.
    """
    choices = []
    for label in labels:
        options = [(text, label_box(text), bias) for text, bias in _options(label)]
        elsewhere = [p for p in places if dist(p, label.at) > _SAME]
        choices.append(
            [
                (bias + _cost(box, discs, strokes, taken, bounds) + _astray(text, box, label.at, elsewhere), text, box)
                for text, box, bias in options
            ]
        )
    chosen = [min(placed, key=lambda o: round(o[0], 6)) for placed in choices]  # equals are decided by their order
    for _ in range(_SWEEPS):
        before = list(chosen)
        for i, placed in enumerate(choices):
            others = [box for j, (_, _, box) in enumerate(chosen) if j != i]
            chosen[i] = min(
                placed,
                key=lambda o: round(
                    o[0] + sum(_OVER + _AGAINST * area for box in others if (area := overlap(o[2], box, 1.5))), 6
                ),
            )
        if chosen == before:
            break
    return [text for _, text, _ in chosen]


def _options(label: Label) -> list[tuple[Text, float]]:
    """All places for a label, each with what speaks against it from the start."""
    length = hypot(*label.toward) or 1.0
    wish = (label.toward[0] / length, label.toward[1] / length)
    half_width = text_width(Text((0.0, 0.0), label.runs, label.size)) / 2
    half_height = (_ASCENT + _DESCENT) * label.size / 2
    found = []
    for gap in _GAPS:
        for dx, dy in _directions():
            reach = (
                label.radius
                + gap
                + min(half_width / abs(dx) if abs(dx) > 1e-9 else 1e9, half_height / abs(dy) if abs(dy) > 1e-9 else 1e9)
            )
            x = label.at[0] + dx * reach
            baseline = label.at[1] + dy * reach + half_height - _DESCENT * label.size
            bias = 6 * (1 - dx * wish[0] - dy * wish[1]) + 1.5 * (gap - _GAPS[0])
            text = Text((x, baseline), label.runs, label.size, "middle", label.fill, halo=True)
            if gap >= _LED:
                text = replace(text, leader=_leader(label, text, (dx, dy)))
            found.append((text, bias))
    return found


def _leader(label: Label, text: Text, along: XY) -> tuple[XY, XY]:
    """From the rim of what is named to the box of its label."""
    (x, y), (dx, dy), (left, top, right, bottom) = label.at, along, label_box(text)
    start = (x + label.radius * dx, y + label.radius * dy)
    return start, (min(max(start[0], left), right), min(max(start[1], top), bottom))


@cache
def _directions() -> tuple[XY, ...]:
    angles = [2 * pi * k / _DIRECTIONS for k in range(_DIRECTIONS)]
    return tuple((round(cos(a), 9), round(sin(a), 9)) for a in angles)


def _astray(text: Text, box: Box, own: XY, others: Sequence[XY]) -> float:
    """What speaks against a label that is nearer to something else, unless a line leads to it."""
    return 0.0 if text.leader else _ASTRAY * sum(_away(box, p) < _away(box, own) for p in others)


def _away(box: Box, p: XY) -> float:
    """How far a place is from a box."""
    return round(hypot(max(box[0] - p[0], 0.0, p[0] - box[2]), max(box[1] - p[1], 0.0, p[1] - box[3])), 6)


def _cost(
    box: Box,
    discs: Sequence[tuple[XY, float]],
    strokes: Sequence[tuple[XY, XY]],
    taken: Sequence[Box],
    bounds: Box | None,
) -> float:
    cost = sum(_OVER + _AGAINST * area for other in taken if (area := overlap(box, other)))
    cost += 4 * sum(overlap(box, (x - r, y - r, x + r, y + r), 1.0) for (x, y), r in discs)
    cost += 1.6 * sum(_inside(box, start, end) for start, end in strokes)
    if bounds:
        outside = (bounds[0] - box[0], bounds[1] - box[1], box[2] - bounds[2], box[3] - bounds[3])
        cost += 100 * sum(max(o, 0.0) for o in outside)
    return cost


def _inside(box: Box, start: XY, end: XY) -> float:
    """The length of a stroke inside a box (Liang and Barsky's clipping)."""
    (x, y), (u, v), (left, top, right, bottom) = start, end, box
    if (x < left and u < left) or (x > right and u > right) or (y < top and v < top) or (y > bottom and v > bottom):
        return 0.0
    dx, dy = u - x, v - y
    low, high = 0.0, 1.0
    for p, q in (
        (-dx, x - left),
        (dx, right - x),
        (-dy, y - top),
        (dy, bottom - y),
    ):
        if abs(p) < 1e-12:
            if q < 0:
                return 0.0
        elif p < 0:
            low = max(low, q / p)
        else:
            high = min(high, q / p)
    return max(high - low, 0.0) * hypot(dx, dy)
