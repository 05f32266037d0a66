r"""The picture of a free region: the range of each coordinate as a bar, and the pose at which the proof ended."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from gcrules.core.dataclass import dataclass
from gcrules.poses.regions.report import FreeRegion
from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import XY, Drawing, Polygon, Run, Shape, Stroke, Text
from gcrules.views.plots.plot_parts import keyed, marker, signed, words_at
from gcrules.views.results.free_region import facts, ranges

__all__ = ["picture", "svg"]

_WIDTH, _LEFT, _RIGHT, _HEAD = 560.0, 92.0, 78.0, 56.0
_ROW, _THICK, _BELOW = 30.0, 14.0, 40.0
_ROOM = 1.12  # of the longest bar, to both sides of its middle


@dataclass(frozen=True)
class _Bar:
    """A coordinate with its range and where the proof ended, in the shown unit, and the ends in digits."""

    name: str
    unit: str
    low: float
    high: float
    worst: float | None
    ends: tuple[str, str]


def picture(r: FreeRegion) -> Drawing:
    """Lengths on one axis, angles on another, in a row each."""
    shapes: list[Shape] = [Text((_LEFT, 20), (Run(r.title),), 14.0)]
    what = f"{r.shape} around {r.pose}, in which nothing is singular"
    fixed = dict(facts(r)).get("fixed")
    shapes.append(Text((_LEFT, 37), (Run(f"{what}{f'; fixed: {fixed}' if fixed else ''}"),), 11.0, "start", "muted"))
    top = _HEAD
    for bars in _groups(r):
        more, top = _panel(bars, top)
        shapes += more
    key: list[tuple[Shape, str]] = [(_box(0.0, 16.0, -9.0, 0.0), _proved(r))]
    if r.tried is not None:
        key.append((marker("crosses", (8.0, -4.0)), _ended(r)))
    shapes, bottom = keyed(shapes, key, _LEFT, top)
    title = f"{r.title}: a {r.shape} around {r.pose} that is free of singular poses"
    return Drawing(_WIDTH, bottom, tuple(shapes), title)


def svg(r: FreeRegion) -> str:
    """The picture as SVG."""
    return picture(r).svg()


def _proved(r: FreeRegion) -> str:
    if r.shape == "box":
        return f"free, proved for all values together, by {r.boxes:,} boxes"
    return f"axes of the ball that is free, proved, by {r.boxes:,} boxes"


def _ended(r: FreeRegion) -> str:
    assert r.tried is not None
    times = f"in a region {r.tried / r.scale:.4g} times as large"
    if r.margin > 0:
        return f"where the proof ended, {times}: margin σ = {r.margin:.3g}"
    return f"a pose {times} that is singular, or past a singular one"


def _groups(r: FreeRegion) -> Iterator[list[_Bar]]:
    """Lengths, then angles."""
    ends = {name: (low, high) for name, low, high, _ in ranges(r)}
    bars = []
    for name, angle, (low, high) in zip(r.names, r.angles, r.ranges.values(), strict=True):
        if name in ends:
            shown = [degrees(v) if angle else v for v in (low, high)]
            worst = r.worst.get(name) if r.tried is not None else None
            worst = degrees(worst) if angle and worst is not None else worst
            bars.append(_Bar(name, "deg" if angle else r.unit, shown[0], shown[1], worst, ends[name]))
    for angle in (False, True):
        some = [bar for bar in bars if (bar.unit == "deg") == angle]
        if some:
            yield some


def _panel(bars: list[_Bar], top: float) -> tuple[list[Shape], float]:
    """Bars on one axis, the pose where the proof ended as a mark on each; and where the next panel begins."""
    reach = max((bar.high - bar.low) / 2 for bar in bars) * _ROOM
    middles = [(bar.low + bar.high) / 2 for bar in bars]
    x = Axis(min(middles) - reach, max(middles) + reach, _LEFT, _WIDTH - _RIGHT)
    bottom = top + _ROW * len(bars)
    shapes: list[Shape] = []
    for tick in x.ticks(6):
        shapes.append(Stroke((x(tick), top), (x(tick), bottom), "muted", 0.5, 0.35))
        shapes.append(Stroke((x(tick), bottom), (x(tick), bottom + 4), "ink", 1.0))
        shapes.append(words_at((x(tick), bottom + 17), signed(f"{tick:.4g}"), "middle"))
    shapes.append(Stroke((x.start, bottom), (x.end, bottom), "ink", 1.0))
    if bars[0].unit:
        shapes.append(words_at((x.end + 10, bottom + 17), bars[0].unit))
    marks: list[XY] = []
    for n, bar in enumerate(bars):
        y = top + _ROW * (n + 0.5)
        shapes.append(_box(x(bar.low), x(bar.high), y - _THICK / 2, y + _THICK / 2))
        middle = x((bar.low + bar.high) / 2)
        shapes.append(Stroke((middle, y - _THICK / 2), (middle, y + _THICK / 2), "entity1", 1.6))
        shapes.append(Text((16.0, y + 4), (Run(bar.name, "italic"),), 13.0))
        shapes.append(words_at((x.start - 6, y + 4), signed(bar.ends[0]), "end"))
        shapes.append(words_at((x.end + 6, y + 4), signed(bar.ends[1])))
        if bar.worst is not None:
            marks.append((x(min(max(bar.worst, x.low), x.high)), y))
    shapes += [Stroke(p, q, "mark", 0.9, 0.6, dash=(3, 3)) for p, q in pairwise(marks)]
    shapes += [marker("crosses", at) for at in marks]
    return shapes, bottom + _BELOW


def _box(left: float, right: float, top: float, bottom: float) -> Polygon:
    corners = ((left, top), (right, top), (right, bottom), (left, bottom))
    return Polygon(corners, fill="entity1", stroke="entity1", fill_opacity=0.28, width=1.2)
