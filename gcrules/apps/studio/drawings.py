"""Small SVG drawings whose parts a page can point at: the legs as a graph, and a sketch of a robot in space.

Their colours are those of the page (classes and `currentColor`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from math import cos, pi, radians, sin

from gcrules.algebra.structure import Structure
from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.drawing import XY, name_runs
from gcrules.views.drawing.graph import layered_order, ring_order, shortened, widest_name
from gcrules.views.drawing.legend import convex_hull

__all__ = ["schematic", "sketch"]

_GAP, _ROWS, _MARGIN = 64.0, 118.0, 30.0
_RING = 74.0
_LINE, _APART = 17.0, 12.0  # of names: from line to line, and beside each other


def schematic(s: Structure) -> str:
    """The legs between a row of base joints and a row of platform joints; elements carry `data-point`, `data-leg`.

    Long names are drawn without their middle, in two lines by turns where one has no room for them.
    """
    names = _Names(widest_name(s.names), _layered(s))
    at = _places(s, names)
    width = max(x for x, _ in at.values()) + names.beside
    height = max(y for _, y in at.values()) + names.above
    parts = [
        f'<line class="leg" data-leg="{escape(a + b)}" data-ends="{escape(f"{a} {b}")}" '
        f'x1="{at[a][0]:.1f}" y1="{at[a][1]:.1f}" x2="{at[b][0]:.1f}" y2="{at[b][1]:.1f}"/>'
        for a, b in s.joined
    ]
    middle = sum(y for _, y in at.values()) / len(at)
    for name, (x, y) in at.items():
        side = s.sides.get(name, "none")
        below = y > middle if s.base else y >= middle
        further = _LINE * names.lines_by_turns * (sum(at[n] < (x, y) for n in at if at[n][1] == y) % 2)
        label = y + (21 + further if below else -12 - further)
        parts.append(
            f'<g class="joint {side}" data-point="{escape(name)}" tabindex="0" role="button"'
            f' aria-label="{escape(f"joint {name}")}"><circle class="hit" cx="{x:.1f}" cy="{y:.1f}" r="14"/>'
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5.5"/>'
            f'<text x="{x:.1f}" y="{label:.1f}" text-anchor="middle">{_label(shortened(name))}</text></g>'
        )
    title = escape(f"Legs {s.text()}")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="schematic" viewBox="0 0 {width:.0f} {height:.0f}" '
        f'role="group" aria-label="{title}">{"".join(parts)}</svg>'
    )


@dataclass(frozen=True)
class _Names:
    """What room the names of joints take that are `wide`, in rows or on a ring."""

    wide: float
    rows: bool

    @property
    def lines_by_turns(self) -> bool:
        """Whether neighbours in a row have their names in different lines."""
        return self.rows and self.wide > _GAP

    @property
    def gap(self) -> float:
        """From joint to joint."""
        return max(_GAP, (self.wide + _APART) / 2)

    @property
    def beside(self) -> float:
        """From the outermost joint to the edge."""
        return max(_MARGIN, self.wide / 2 + 4)

    @property
    def above(self) -> float:
        return _MARGIN + _LINE * self.lines_by_turns


def _layered(s: Structure) -> bool:
    """Whether each leg runs from the base to the platform."""
    return bool(s.joined) and all({s.sides.get(a), s.sides.get(b)} == {"base", "platform"} for a, b in s.joined)


def _places(s: Structure, names: _Names) -> dict[str, XY]:
    if not names.rows:
        ring = ring_order(s.joined)
        radius = max(_RING, names.wide)
        angles = [2 * pi * i / len(ring) - pi / 2 for i in range(len(ring))]
        x, y = radius + names.beside, radius + _MARGIN
        return {n: (x + radius * cos(a), y + radius * sin(a)) for n, a in zip(ring, angles, strict=True)}
    lower, upper = layered_order(s.joined, s.base, s.platform)
    width = names.gap * max(len(lower), len(upper), 4)
    first = max(_MARGIN / 2, names.beside - width / max(len(lower), len(upper)) / 2)
    at: dict[str, XY] = {}
    for row, y in ((upper, names.above), (lower, names.above + _ROWS)):
        gap = width / len(row)
        at |= {n: (gap * (i + 0.5) + first, y) for i, n in enumerate(row)}
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
