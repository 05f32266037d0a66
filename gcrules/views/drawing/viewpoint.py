"""From where to look at a platform: the viewpoint from which points, legs and planes hide each other least."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from math import cos, hypot, inf, radians, sin

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.drawing.drawing import XY

__all__ = ["View", "choose_view", "distance_to_stroke"]

_AZIMUTHS = range(0, 360, 10)
_ELEVATIONS = (14, 20, 27)
_OFF_LEGS = 0.05  # sizes of the picture from a joint to a leg of others
_OFF_AXIS = 0.3  # of what is seen edge on or from its end
_ROUNDING = 1e-6  # costs are compared in so large steps


@dataclass(frozen=True, slots=True)
class View:
    """Orthographic projection along `eye` (the direction towards the viewer); x goes along `right`, −y along `up`."""

    eye: XYZ
    right: XYZ
    up: XYZ

    @classmethod
    def at(cls, azimuth: float, elevation: float) -> View:
        """From the given angles in degrees, with the z axis upright in the picture."""
        a, e = radians(azimuth), radians(elevation)
        ca, sa, ce, se = (round(f(x), 12) for f, x in ((cos, a), (sin, a), (cos, e), (sin, e)))  # alike everywhere
        eye = (ca * ce, sa * ce, se)
        right = (-sa, ca, 0.0)
        return cls(eye, right, cross(eye, right))

    def flat(self, point: XYZ) -> XY:
        """The place of a point in the picture, in the unit of the coordinates."""
        return dot(self.right, point), -dot(self.up, point)


def choose_view(
    points: Mapping[str, XYZ],
    legs: Sequence[tuple[str, str]],
    normals: Sequence[XYZ] = (),
    directions: Sequence[XYZ] = (),
    *,
    elevations: Sequence[float] = _ELEVATIONS,
    apart: float = 0.09,
) -> tuple[View, float]:
    """The best of a fixed set of viewpoints, and how much still hides each other there (0 for nothing).

    Joints should be `apart` from each other (in sizes of the picture) and off foreign legs, the planes with the given
    unit normals should not be seen edge on, nor lines with the given unit directions from their ends. `elevations` are
    angles in degrees. Equal merits are decided by the order of the viewpoints.
    """
    views = list(_views(elevations))
    best, least = views[0], inf
    for view in views:
        total = 0.0
        for fault in _clutter(view, points, legs, normals, directions, apart):
            total += fault
            if total > least + _ROUNDING:
                break
        else:
            if round(total, 6) < least:
                best, least = view, round(total, 6)
    return best, least


def distance_to_stroke(p: XY, start: XY, end: XY) -> float:
    """The distance of a place from a segment."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    t = max(0.0, min(1.0, ((p[0] - start[0]) * dx + (p[1] - start[1]) * dy) / square)) if square else 0.0
    return hypot(p[0] - start[0] - t * dx, p[1] - start[1] - t * dy)


def _views(elevations: Sequence[float]) -> Iterator[View]:
    for elevation in elevations:
        for azimuth in _AZIMUTHS:
            yield View.at(azimuth - 60, elevation)


def _clutter(
    view: View,
    points: Mapping[str, XYZ],
    legs: Sequence[tuple[str, str]],
    normals: Sequence[XYZ],
    directions: Sequence[XYZ],
    apart: float,
) -> Iterator[float]:
    """What speaks against a viewpoint, each part positive; who adds them up may stop at any."""
    at = {name: view.flat(p) for name, p in points.items()}
    xs, ys = [x for x, _ in at.values()], [y for _, y in at.values()]
    size = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    for p, q in combinations(at.values(), 2):
        if (distance := hypot(p[0] - q[0], p[1] - q[1]) / size) < apart:
            yield _near(distance, apart)
    reach = _OFF_LEGS * size
    strokes = [(a, b, at[a], at[b], sorted((at[a][0], at[b][0])), sorted((at[a][1], at[b][1]))) for a, b in legs]
    for name, (x, y) in at.items():
        for a, b, start, end, (left, right), (top, bottom) in strokes:
            if left - x > reach or x - right > reach or top - y > reach or y - bottom > reach or name in (a, b):
                continue
            yield _near(distance_to_stroke((x, y), start, end) / size, _OFF_LEGS)
    for normal in normals:
        yield _near(abs(dot(normal, view.eye)), _OFF_AXIS)
    for direction in directions:
        yield _near(1 - abs(dot(direction, view.eye)), _OFF_AXIS)


def _near(distance: float, enough: float) -> float:
    """0 from `enough` on, growing to 10 for nothing."""
    lack = max(0.0, 1 - distance / enough)
    return lack + 9 * lack**3
