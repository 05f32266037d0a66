r"""Pieces of the picture of a platform as shapes: areas, strokes, and legs with gaps under them where they cross."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import dist

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.bsp import XYZ, CutPolygon, crossing, minus
from gcrules.views.drawing.drawing import XY, Polygon, Shape, Stroke
from gcrules.views.drawing.frame import Frame
from gcrules.views.drawing.sample import Legs

__all__ = ["SAME", "Look", "crossings", "piece_shapes"]

SAME = 1e-6
"""What is nearer than this counts as one place, in radii of the robot."""

_CASING = 9.0


@dataclass(frozen=True, slots=True)
class Look:
    """How a piece is drawn: a fill with outline for areas, a width for strokes."""

    role: str
    fill: float = 0.0
    edge: float = 0.0
    width: float = 1.0
    dash: tuple[float, float] | None = None
    leg: int | None = None
    line: int | None = None


def crossings(legs: Legs, points: Mapping[str, XYZ], eye: XYZ) -> dict[int, list[XYZ]]:
    """For each leg the places where it passes in front of another one."""
    found: dict[int, list[XYZ]] = {}
    ends = [(points[a], points[b]) for a, b in legs]
    for i, first in enumerate(ends):
        for j, second in enumerate(ends):
            cross_at = crossing(first, second, eye)
            if cross_at and cross_at[2] < -SAME and i != j:
                step = minus(first[1], first[0])
                s = cross_at[0]
                found.setdefault(i, []).append(
                    (first[0][0] + s * step[0], first[0][1] + s * step[1], first[0][2] + s * step[2])
                )
    return found


def piece_shapes(
    piece: CutPolygon[Look],
    frame: Frame,
    over: Mapping[int, Sequence[XYZ]],
) -> list[Shape]:
    """An area with its true edges, or a stroke; under a leg the gaps where it passes `over` others."""
    look = piece.tag
    at = [frame.place(c) for c in piece.corners]
    if len(at) > 2:
        edges = zip(at, [*at[1:], at[0]], piece.edges, strict=True)
        return [
            Polygon(tuple(at), look.role, fill_opacity=look.fill),
            *(Stroke(a, b, look.role, look.width, look.edge) for a, b, original in edges if original),
        ]
    stroke = Stroke(at[0], at[1], look.role, look.width, dash=look.dash, round_ends=False)
    if look.leg is None:
        return [stroke]
    gaps = (_gap(frame.place(p), at[0], at[1]) for p in over.get(look.leg, ()))
    return [*(gap for gap in gaps if gap is not None), stroke]


def _gap(place: XY, start: XY, end: XY) -> Stroke | None:
    """A short clear stretch under a leg where it passes in front of another."""
    length = dist(start, end)
    if length < 1e-9:
        return None
    u = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
    along = (place[0] - start[0]) * u[0] + (place[1] - start[1]) * u[1]
    low, high = max(along - _CASING, 0.0), min(along + _CASING, length)
    if high - low < 1.0:
        return None
    a, b = ((start[0] + t * u[0], start[1] + t * u[1]) for t in (low, high))
    return Stroke(a, b, "paper", 7.0, round_ends=False)
