"""Small SVG drawings whose parts a page can point at: the legs as a graph, and a sketch of a robot in space.

Their colours are those of the page (classes and `currentColor`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from math import cos, pi, radians, sin

from gcrules.algebra.structure import Structure
from gcrules.views.drawing.drawing import XY, name_runs
from gcrules.views.drawing.graph import layered_order, ring_order
from gcrules.views.drawing.legend import convex_hull

__all__ = ["schematic", "sketch"]

_GAP, _ROWS, _MARGIN = 64.0, 118.0, 30.0
_RING = 74.0


def schematic(s: Structure) -> str:
    """The legs between a row of base joints and a row of platform joints; elements carry `data-point`, `data-leg`."""
    at = _places(s)
    width = max(x for x, _ in at.values()) + _MARGIN
    height = max(y for _, y in at.values()) + _MARGIN
    parts = [
        f'<line class="leg" data-leg="{escape(a + b)}" data-ends="{escape(f"{a} {b}")}" '
        f'x1="{at[a][0]:.1f}" y1="{at[a][1]:.1f}" x2="{at[b][0]:.1f}" y2="{at[b][1]:.1f}"/>'
        for a, b in s.joined
    ]
    middle = sum(y for _, y in at.values()) / len(at)
    for name, (x, y) in at.items():
        side = s.sides.get(name, "none")
        below = y > middle if s.base else y >= middle
        label = y + (21 if below else -12)
        parts.append(
            f'<g class="joint {side}" data-point="{escape(name)}" tabindex="0" role="button"'
            f' aria-label="{escape(f"joint {name}")}"><circle class="hit" cx="{x:.1f}" cy="{y:.1f}" r="14"/>'
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5.5"/>'
            f'<text x="{x:.1f}" y="{label:.1f}" text-anchor="middle">{_label(name)}</text></g>'
        )
    title = escape(f"Legs {s.text()}")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="schematic" viewBox="0 0 {width:.0f} {height:.0f}" '
        f'role="group" aria-label="{title}">{"".join(parts)}</svg>'
    )


def _places(s: Structure) -> dict[str, XY]:
    legs = s.joined
    layered = bool(legs) and all({s.sides.get(a), s.sides.get(b)} == {"base", "platform"} for a, b in legs)
    if not layered:
        names = ring_order(legs)
        angles = [2 * pi * i / len(names) - pi / 2 for i in range(len(names))]
        middle = _RING + _MARGIN
        return {n: (middle + _RING * cos(a), middle + _RING * sin(a)) for n, a in zip(names, angles, strict=True)}
    lower, upper = layered_order(legs, s.base, s.platform)
    width = _GAP * max(len(lower), len(upper), 4)
    at: dict[str, XY] = {}
    for row, y in ((upper, _MARGIN), (lower, _MARGIN + _ROWS)):
        gap = width / len(row)
        at |= {n: (gap * (i + 0.5) + _MARGIN / 2, y) for i, n in enumerate(row)}
    return at


def _label(name: str) -> str:
    parts = []
    drop = 0
    for run in name_runs(name):
        low = run.style == "subscript"
        shift = f' dy="{4 if low else -4}"' if low != bool(drop) else ""
        drop = low
        size = ' font-size="72%"' if low else ""
        italic = ' font-style="italic"' if run.style == "italic" else ""
        parts.append(f"<tspan{shift}{size}{italic}>{escape(run.text)}</tspan>")
    return "".join(parts)


_TURN, _TILT = radians(-28), radians(24)


def sketch(
    points: Mapping[str, Sequence[float]],
    strokes: Iterable[Sequence[str]],
    bodies: Mapping[str, Sequence[str]],
    *,
    seen: Callable[[Sequence[float]], XY] | None = None,
    size: float = 120.0,
) -> str:
    """A robot without words, by default seen obliquely from above: `strokes` are legs or limbs, through points in
    sequence.
    """
    flat = {n: (seen or _seen)(p) for n, p in points.items()}
    xs, ys = [x for x, _ in flat.values()], [y for _, y in flat.values()]
    scale = (size - 16) / max(max(xs) - min(xs), max(ys) - min(ys), 1e-9)
    middle = ((max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2)
    at = {n: (size / 2 + scale * (x - middle[0]), size / 2 + scale * (y - middle[1])) for n, (x, y) in flat.items()}
    parts = []
    for body, names in bodies.items():
        outline = convex_hull([at[n] for n in names if n in at])
        parts.append(f'<polygon class="{body}" points="{_listed(outline)}"/>')
    for names in strokes:
        parts.append(f'<polyline class="leg" points="{_listed([at[n] for n in names if n in at])}"/>')
    used = {n for body in bodies.values() for n in body}
    parts += [f'<circle cx="{at[n][0]:.1f}" cy="{at[n][1]:.1f}" r="2.4"/>' for n in at if n in used]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="sketch" viewBox="0 0 {size:.0f} {size:.0f}" '
        f'aria-hidden="true">{"".join(parts)}</svg>'
    )


def _seen(p: Sequence[float]) -> XY:
    x, y, z = map(float, p)
    right = x * cos(_TURN) - y * sin(_TURN)
    away = x * sin(_TURN) + y * cos(_TURN)
    return right, -(z * cos(_TILT) + away * sin(_TILT))


def _listed(points: Iterable[XY]) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
