"""What the figures share about entities: names, the legend, and areas with rounded corners."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import atan2, ceil, cos, pi, sin
from typing import Protocol

from gcrules.views.drawing.drawing import XY, Circle, Polygon, Run, Shape, Stroke, Text, name_runs, text_width
from gcrules.views.drawing.palette import entity_role

__all__ = ["EntityLike", "LegendEntry", "convex_hull", "entity_entries", "legend", "legend_width", "rounded"]


class EntityLike(Protocol):
    """Anything that has a kind (tetrahedron, plane, line or point) and the names of its points."""

    @property
    def kind(self) -> str: ...

    @property
    def points(self) -> tuple[str, ...]: ...


LegendEntry = tuple[str, tuple[Run, ...], str]
"""Role of the colour, text, and how the sample looks: area, dashed, dot or ring."""

ROW = 20.0
_SIZE = 13.0
_SAMPLE = 18.0


def entity_entries(entities: Sequence[EntityLike], flat: Collection[int] = ()) -> list[LegendEntry]:
    """One legend entry for each entity: its kind and its points; `flat` says which tetrahedra are so in the pose."""
    looks = {"line": "dashed", "point": "ring"}
    return [
        (
            entity_role(i),
            (Run(f"{e.kind} "), *name_runs(*e.points), *([Run(", flat")] if i in flat else [])),
            looks.get(e.kind, "area"),
        )
        for i, e in enumerate(entities)
    ]


def legend_width(entries: Sequence[LegendEntry]) -> float:
    """The room that a legend takes from left to right, 0 without entries."""
    return max((_SAMPLE + 8 + text_width(Text((0, 0), runs, _SIZE)) for _, runs, _ in entries), default=0.0)


def legend(entries: Sequence[LegendEntry], left: float, top: float) -> list[Shape]:
    """One row for each entry, from the given corner downwards."""
    shapes: list[Shape] = []
    for i, (role, runs, look) in enumerate(entries):
        y = top + ROW * i + ROW / 2
        if look == "dashed":
            shapes.append(Stroke((left, y), (left + _SAMPLE, y), role, 2.2, dash=(6, 4)))
        elif look == "dot":
            shapes.append(Circle((left + _SAMPLE / 2, y), 4.0, role, "paper", 1.2))
        elif look == "ring":
            shapes.append(Circle((left + _SAMPLE / 2, y), 6.0, "paper", role, 2.0))
        else:
            corners = ((left, y - 5), (left + _SAMPLE, y - 5), (left + _SAMPLE, y + 5), (left, y + 5))
            shapes.append(Polygon(corners, role, role, fill_opacity=0.3, width=1.4))
        shapes.append(Text((left + _SAMPLE + 8, y + 4.5), runs, _SIZE))
    return shapes


def convex_hull(points: Sequence[XY]) -> list[XY]:
    """The corners of the convex hull, counterclockwise for y upwards (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered

    def half(run: Sequence[XY]) -> list[XY]:
        out: list[XY] = []
        for p in run:
            while len(out) > 1 and _turn(out[-2], out[-1], p) <= 1e-9:
                out.pop()
            out.append(p)
        return out[:-1]

    return half(ordered) + half(ordered[::-1])


def rounded(points: Sequence[XY], radius: float, step: float = pi / 12) -> tuple[XY, ...]:
    """The outline of all places within `radius` of the convex hull; for one point a disc, for two a capsule."""
    hull = convex_hull(points)
    outline: list[XY] = []
    for i, (x, y) in enumerate(hull):
        if len(hull) == 1:
            first, last = 0.0, 2 * pi
        else:
            before, after = hull[i - 1], hull[(i + 1) % len(hull)]
            first = atan2(y - before[1], x - before[0]) - pi / 2
            last = atan2(after[1] - y, after[0] - x) - pi / 2
            while last < first - 1e-9:
                last += 2 * pi
        count = max(1, ceil((last - first) / step - 1e-6))
        angles = [first + (last - first) * k / count for k in range(count + 1)]
        outline += [(x + radius * cos(a), y + radius * sin(a)) for a in angles]
    return tuple(outline)


def _turn(a: XY, b: XY, c: XY) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
