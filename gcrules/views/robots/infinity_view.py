r"""The plane at infinity, as the sky over the robot: directions are points of a half sphere seen from the viewpoint,
lines at infinity great circles on it. Three couples depend on each other where their circles have a common point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import cos, pi, sin

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.drawing.drawing import XY, Circle, Run, Shape, Stroke, Text, name_runs
from gcrules.views.drawing.labels import Label, place_labels
from gcrules.views.drawing.viewpoint import View
from gcrules.views.robots.drawn_limb import unit_vector
from gcrules.views.robots.symbols import basis

__all__ = ["SKY", "Far", "infinity_shapes"]

SKY = 150.0
"""Width and height of the picture of the sky."""

_RADIUS = 54.0
_STEPS = 24


@dataclass(frozen=True)
class Far:
    """What lies at infinity: directions (unit vectors), each by its name or by two points on a line; lines, each by two
    directions and its colour; normals of circles that are marked because points lie on them; marked directions.
    """

    points: Mapping[tuple[str, ...], XYZ]
    lines: Sequence[tuple[XYZ, XYZ, str]]
    circles: Sequence[XYZ] = ()
    marks: Sequence[XYZ] = ()


def infinity_shapes(far: Far, view: View, left: float, top: float) -> list[Shape]:
    """The half sphere with everything on it, inside a square with this corner."""
    middle = (left + SKY / 2, top + SKY / 2)
    shapes: list[Shape] = [Circle(middle, _RADIUS, "paper", "muted", 1.2)]
    strokes: list[tuple[XY, XY]] = []
    for u, v, role in far.lines:
        drawn = _circle(cross(u, v), view, middle, role, 2.4, None)
        shapes += drawn
        strokes += [(s.start, s.end) for s in drawn]
    for normal in far.circles:
        shapes += _circle(normal, view, middle, "mark", 1.8, (5.0, 3.0))
    labels = []
    for names, u in far.points.items():
        at = _place(u, view, middle)
        shapes.append(Circle(at, 3.4, "ink", "paper", 1.0))
        labels.append(Label(name_runs(*names), at, (at[0] - middle[0], at[1] - middle[1]), 3.6, size=13.0))
    for u in far.marks:
        shapes.append(Circle(_place(u, view, middle), 5.0, "mark", "paper", 1.4))
    discs = [(_place(u, view, middle), 3.4) for u in (*far.points.values(), *far.marks)]
    bounds = (left, top, left + SKY, top + SKY)
    words = Text((middle[0], top - 4), (Run("at infinity"),), 12, "middle", "muted")
    return [*shapes, words, *place_labels(labels, discs=discs, strokes=strokes, bounds=bounds)]


def _place(u: XYZ, view: View, middle: XY) -> XY:
    """A direction and its opposite are one point: that on the side of the viewer."""
    near = u if round(dot(u, view.eye), 9) >= 0 else (-u[0], -u[1], -u[2])
    x, y = view.flat(near)
    return middle[0] + _RADIUS * x, middle[1] + _RADIUS * y


def _circle(
    normal: XYZ, view: View, middle: XY, role: str, width: float, dash: tuple[float, float] | None
) -> list[Stroke]:
    """The visible half of the great circle perpendicular to a vector."""
    n = unit_vector(normal)
    rim = cross(n, view.eye)
    first = unit_vector(rim) if dot(rim, rim) > 1e-9 else basis(n)[0]
    second = cross(n, first)
    if round(dot(second, view.eye), 9) < 0:
        second = (-second[0], -second[1], -second[2])
    whole = dot(rim, rim) <= 1e-9
    steps = 2 * _STEPS if whole else _STEPS
    places = []
    for k in range(steps + 1):
        c, s = round(cos(pi * k / _STEPS), 9), round(sin(pi * k / _STEPS), 9)
        x, y = view.flat((c * first[0] + s * second[0], c * first[1] + s * second[1], c * first[2] + s * second[2]))
        places.append((middle[0] + _RADIUS * x, middle[1] + _RADIUS * y))
    return [
        Stroke(a, b, role, width, round_ends=dash is None)
        for k, (a, b) in enumerate(pairwise(places))
        if dash is None or k % 2 == 0
    ]
