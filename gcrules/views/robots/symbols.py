r"""The signs of joints, forces and couples, as they are seen from the viewpoint of a drawing: small solids.

A revolute joint is a cylinder along its axis, a prismatic one a box along its direction, a spherical one a ball, a
universal one a cross of two pins, a cylindrical one a cylinder on a rod, a helical one a cylinder with a thread, a
planar one a plate on its normal. What is driven has the colour of drives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin

from gcrules.core.frozen import FrozenMap
from gcrules.screws import JOINTS
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.drawing.drawing import XY, Circle, Polygon, Shape, Stroke
from gcrules.views.drawing.frame import Frame
from gcrules.views.drawing.legend import convex_hull
from gcrules.views.robots.drawn_limb import DrawnJoint, plus, unit_vector

__all__ = ["SIGN", "arrow", "basis", "couple", "sign", "turn_arrow"]

SIGN = 13.0
"""Points around the place of a joint that its sign covers."""

_BALL = 6.2
_RIM = 24  # corners of a circle


def basis(axis: XYZ) -> tuple[XYZ, XYZ]:
    """Two unit vectors that make a right-handed frame with a unit vector."""
    other = (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0)
    u = unit_vector(cross(other, axis))
    return u, cross(axis, u)


def sign(place: DrawnJoint, frame: Frame, role: str) -> list[Shape]:
    """The sign of a joint in the colour of its limb: one of its own, or one that its freedoms and axes make."""
    return SIGNS.get(place.kind, _by_freedoms)(place, frame, role, "drive" if place.driven else role)


def _by_freedoms(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    """A box along what only slides, a cylinder about one axis, pins about several, a ball where there is none."""
    at, axes = place.at, place.axes
    if not axes:
        (x, y), r, shine = frame.place(at), _BALL * frame.size, 2.0 * frame.size
        gloss = Circle((x - shine, y - shine), 0.75 * shine, "paper", "paper", 0.4)
        return [Circle((x, y), r, fill, "ink", 1.2), gloss]
    if JOINTS[place.kind].slides:
        return _box(frame, at, axes[0], (13, 6.6, 6.6), ink, fill)
    if len(axes) == 1:
        return _cylinder(frame, at, axes[0], 12, 6.4, ink, fill)
    pins = sorted(axes, key=lambda u: abs(round(dot(u, frame.view.eye), 6)))
    return [s for u in pins for s in _cylinder(frame, at, u, 10, 3.3, ink, fill)]


def _cylindrical(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    at, axis = place.at, place.axes[0]
    return [_rod(frame, at, axis, 24, ink), *_cylinder(frame, at, axis, 13, 6.4, ink, fill)]


def _helical(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    return [*_cylindrical(place, frame, ink, fill), *_thread(frame, place.at, place.axes[0], ink)]


def _carriage(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    return _box(frame, place.at, place.axes[0], (17, 7.6, 7.6), ink, fill)


def _planar(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    at, normal = place.at, place.axes[0]
    plate = _box(frame, at, normal, (2, 13, 13), ink, fill)
    return [*plate, *_cylinder(frame, plus(at, normal, 4 * frame.point), normal, 5, 4.0, ink, fill)]


def _pin(place: DrawnJoint, frame: Frame, ink: str, fill: str) -> list[Shape]:
    return [Circle(frame.place(place.at), 4.2 * frame.size, fill if place.driven else "paper", ink, 1.8)]


SIGNS: Mapping[str, Callable[[DrawnJoint, Frame, str, str], list[Shape]]] = FrozenMap(
    {"C": _cylindrical, "H": _helical, "E": _planar, "carriage": _carriage, "pin": _pin}
)
"""Signs that the freedoms alone would not make: of kinds of joints, and of places that a drawing adds."""


def _solid(points: Sequence[XY], ink: str, fill: str, shade: float) -> list[Shape]:
    """An area that hides what lies behind it, tinted."""
    corners = tuple(points)
    return [Polygon(corners, "paper"), Polygon(corners, fill, ink, fill_opacity=shade, width=1.3)]


def _shade(fill: str, light: float) -> float:
    return light if fill != "drive" else min(1.0, 0.55 + light / 2)


def _cylinder(frame: Frame, at: XYZ, axis: XYZ, half: float, radius: float, ink: str, fill: str) -> list[Shape]:
    u, v = basis(axis)
    near = axis if frame.sight(axis) >= 0 else (-axis[0], -axis[1], -axis[2])
    caps = []
    for end in (-half, half):
        middle = plus(at, near, end * frame.point)
        ring = [plus(plus(middle, u, radius * c * frame.point), v, radius * s * frame.point) for c, s in _circle()]
        caps.append([_rounded(frame.place(p)) for p in ring])
    hull = convex_hull([*caps[0], *caps[1]])
    return [*_solid(hull, ink, fill, _shade(fill, 0.5)), *_solid(convex_hull(caps[1]), ink, fill, _shade(fill, 0.15))]


def _rounded(p: XY) -> XY:
    """So that what is equal but for the last bit is equal."""
    return round(p[0], 4), round(p[1], 4)


def _circle() -> list[XY]:
    return [(round(cos(2 * pi * k / _RIM), 9), round(sin(2 * pi * k / _RIM), 9)) for k in range(_RIM)]


def _rod(frame: Frame, at: XYZ, axis: XYZ, half: float, ink: str) -> Stroke:
    ends = (frame.place(plus(at, axis, s * half * frame.point)) for s in (-1, 1))
    return Stroke(next(ends), next(ends), ink, 3.0)


def _thread(frame: Frame, at: XYZ, axis: XYZ, ink: str) -> list[Shape]:
    (x, y), (ax, ay) = frame.place(at), frame.view.flat(axis)
    length = hypot(ax, ay) or 1.0
    ux, uy = ax / length, ay / length
    lines = []
    for along in (-7.0, 0.0, 7.0):
        cx, cy = x + along * ux, y + along * uy
        lines.append(
            Stroke(
                (cx - 5.5 * uy - 2.5 * ux, cy + 5.5 * ux - 2.5 * uy),
                (cx + 5.5 * uy + 2.5 * ux, cy - 5.5 * ux + 2.5 * uy),
                ink,
                1.4,
            )
        )
    return list(lines)


def _box(frame: Frame, at: XYZ, axis: XYZ, half: tuple[float, float, float], ink: str, fill: str) -> list[Shape]:
    """The three sides of a box that are seen, its length along the axis."""
    u, v = basis(axis)
    sides = list(zip((axis, u, v), half, strict=True))
    shapes: list[Shape] = []
    for k, (normal, reach) in enumerate(sides):
        seen = frame.sight(normal)
        if abs(seen) < 1e-6:
            continue
        (a, la), (b, lb) = (s for i, s in enumerate(sides) if i != k)
        middle = plus(at, normal, (reach if seen > 0 else -reach) * frame.point)
        corners = [
            frame.place(plus(plus(middle, a, s * la * frame.point), b, t * lb * frame.point))
            for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
        shapes += _solid(corners, ink, fill, _shade(fill, (0.12, 0.3, 0.5)[k]))
    return shapes


# --- wrenches and motions ------------------------------------------------------------------------------------------


def arrow(
    start: XY, end: XY, role: str, width: float = 2.4, dash: tuple[float, float] | None = None, heads: int = 1
) -> list[Shape]:
    """An arrow from one place to another, with one or two heads."""
    length = hypot(end[0] - start[0], end[1] - start[1])
    if length < 1e-6:
        return []
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    size = 3.2 * width + 1.6
    foot = max(length - 0.8 * size, 0.0)
    shapes: list[Shape] = [
        Stroke(start, (start[0] + foot * ux, start[1] + foot * uy), role, width, dash=dash, round_ends=False)
    ]
    for k in range(heads):
        shapes.append(_head((end[0] - 0.75 * k * size * ux, end[1] - 0.75 * k * size * uy), (ux, uy), size, role))
    return shapes


def _head(tip: XY, along: XY, size: float, role: str) -> Polygon:
    ux, uy = along
    x, y = tip[0] - size * ux, tip[1] - size * uy
    wide = 0.42 * size
    return Polygon((tip, (x - wide * uy, y + wide * ux), (x + wide * uy, y - wide * ux)), role)


def turn_arrow(frame: Frame, at: XYZ, axis: XYZ, role: str, radius: float = 15.0, width: float = 2.2) -> list[Shape]:
    """Three quarters of a circle about an axis, with a head: a turn or a moment in the right-handed sense."""
    u, v = basis(axis)
    steps = 18
    ring = []
    for k in range(steps + 1):
        angle = 0.6 + 1.5 * pi * k / steps
        c, s = round(cos(angle), 9), round(sin(angle), 9)
        ring.append(frame.place(plus(plus(at, u, radius * c / frame.scale), v, radius * s / frame.scale)))
    shapes: list[Shape] = [Stroke(a, b, role, width) for a, b in pairwise(ring[:-1])]
    (x0, y0), (x1, y1) = ring[-3], ring[-1]
    length = hypot(x1 - x0, y1 - y0)
    if length > 1e-6:
        along = ((x1 - x0) / length, (y1 - y0) / length)
        size = 3.2 * width + 1.6
        shapes.append(_head((x1 + 0.3 * size * along[0], y1 + 0.3 * size * along[1]), along, size, role))
    return shapes


def couple(frame: Frame, at: XYZ, axis: XYZ, role: str, dash: tuple[float, float] | None = None) -> list[Shape]:
    """A moment: an arrow with two heads along its direction, and the turn about it."""
    start, end = (frame.place(plus(at, axis, s / frame.scale)) for s in (-6, 30))
    return [*turn_arrow(frame, at, axis, role, radius=12.0, width=1.8), *arrow(start, end, role, 2.0, dash, heads=2)]
