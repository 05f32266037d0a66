"""From where to look at a platform: the viewpoint from which points, legs and planes hide each other least."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain, combinations
from math import cos, dist, hypot, inf, radians, sin

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.drawing.drawing import XY

__all__ = ["View", "choose_view", "distance_to_stroke"]

Segment = tuple[XYZ, XYZ]

_AZIMUTHS = range(0, 360, 10)
_ELEVATIONS = (14, 20, 27)
_OFF_LEGS = 0.05  # sizes of the picture from a joint to a leg of others
_OFF_AXIS = 0.3  # of what is seen edge on or from its end
_ROUNDING = 1e-6  # costs are compared in so large steps
_CROSSED = 2.0  # what it costs that links of two limbs cross
_LIMBS_APART = 0.33  # sizes of the picture between the middles of two limbs
_SHORTENED = 0.5  # of its length a link is seen at least
_LINK = 0.12  # of the size of the robot a link is long that counts
_STEEP = 0.03  # what each degree from above costs, where limbs are seen
_UPRIGHT = (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True)
class View:
    """Orthographic projection along `eye` (the direction towards the viewer); x goes along `right`, −y along `up`."""

    eye: XYZ
    right: XYZ
    up: XYZ

    @classmethod
    def at(cls, azimuth: float, elevation: float, upright: XYZ = _UPRIGHT) -> View:
        """From the given angles in degrees, with the z axis, or another unit vector, upright in the picture."""
        a, e = radians(azimuth), radians(elevation)
        ca, sa, ce, se = (round(f(x), 12) for f, x in ((cos, a), (sin, a), (cos, e), (sin, e)))  # alike everywhere
        turned = _standing(upright)
        eye, right = turned((ca * ce, sa * ce, se)), turned((-sa, ca, 0.0))
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
    limbs: Sequence[Sequence[Segment]] = (),
    elevations: Sequence[float] = _ELEVATIONS,
    apart: float = 0.09,
    upright: XYZ = _UPRIGHT,
) -> tuple[View, float]:
    """The best of a fixed set of viewpoints, and how much still hides each other there (0 for nothing).

    Joints should be `apart` from each other (in sizes of the picture) and off foreign legs, the planes with the given
    unit normals should not be seen edge on, nor lines with the given unit directions from their ends. The links of
    `limbs` should neither cross those of others nor be seen from their ends, and limbs should stand apart. `elevations`
    are angles in degrees over the plane whose unit normal is `upright`. Equal merits are decided by the order of the
    viewpoints.
    """
    views = [(e, View.at(a - 60, e, upright)) for e in elevations for a in _AZIMUTHS]
    best, least = views[0][1], inf
    foreign = list(_foreign([*points.values()], limbs))
    places = set(chain.from_iterable(foreign))
    for elevation, view in views:
        total = _STEEP * elevation if limbs else 0.0
        size = _size(view, points)
        clutter = _clutter(view, points, legs, normals, directions, apart, size)
        for fault in chain(clutter, _limb_clutter(view, limbs, foreign, places, size)):
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


def _standing(upright: XYZ) -> Callable[[XYZ], XYZ]:
    """The turn that takes the z axis to a unit vector and keeps the picture of the x axis as it can."""
    if upright == _UPRIGHT:
        return lambda p: p
    aside = cross((1.0, 0.0, 0.0) if abs(upright[0]) < 0.9 else (0.0, 1.0, 0.0), upright)
    length = dot(aside, aside) ** 0.5
    v = (aside[0] / length, aside[1] / length, aside[2] / length)
    u, w = cross(v, upright), upright
    u = (-u[0], -u[1], -u[2]) if abs(upright[0]) < 0.9 and u[0] < 0 else u
    v = cross(w, u)

    def turned(p: XYZ) -> XYZ:
        x, y, z = (p[0] * u[i] + p[1] * v[i] + p[2] * w[i] for i in range(3))
        return x, y, z

    return turned


def _size(view: View, points: Mapping[str, XYZ]) -> float:
    at = [view.flat(p) for p in points.values()]
    xs, ys = [x for x, _ in at], [y for _, y in at]
    return max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0


def _clutter(
    view: View,
    points: Mapping[str, XYZ],
    legs: Sequence[tuple[str, str]],
    normals: Sequence[XYZ],
    directions: Sequence[XYZ],
    apart: float,
    size: float,
) -> Iterator[float]:
    """What speaks against a viewpoint, each part positive; who adds them up may stop at any."""
    at = {name: view.flat(p) for name, p in points.items()}
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


def _limb_clutter(
    view: View,
    limbs: Sequence[Sequence[Segment]],
    foreign: Sequence[tuple[XYZ, XYZ, XYZ]],
    places: Iterable[XYZ],
    size: float,
) -> Iterator[float]:
    """The same of links: those seen from their ends, places near `foreign` links (`places` are all that these name),
    limbs near each other, links that cross those of others.
    """
    at = {p: view.flat(p) for p in places}
    reach = _OFF_LEGS * size
    for p, a, b in foreign:
        (x, y), (left, top), (right, bottom) = at[p], at[a], at[b]
        if left > right:
            left, right = right, left
        if top > bottom:
            top, bottom = bottom, top
        if not (left - x > reach or x - right > reach or top - y > reach or y - bottom > reach):
            yield _near(distance_to_stroke(at[p], at[a], at[b]) / size, _OFF_LEGS)
    seen = [[(view.flat(a), view.flat(b)) for a, b in links] for links in limbs]
    for links, flat in zip(limbs, seen, strict=True):
        for (a, b), (start, end) in zip(links, flat, strict=True):
            if (length := dist(a, b)) > _LINK * size + _ROUNDING:
                yield _near(dist(start, end) / length, _SHORTENED)
    middles = [_middle(flat) for flat in seen if flat]
    for here, there in combinations(middles, 2):
        yield _near(dist(here, there) / size, _LIMBS_APART)
    for one, other in combinations(seen, 2):
        yield _CROSSED * sum(_cross(stroke, against) for stroke in one for against in other)


def _foreign(points: Sequence[XYZ], limbs: Sequence[Sequence[Segment]]) -> Iterator[tuple[XYZ, XYZ, XYZ]]:
    """Joints, and the middles of links, with each link of the limbs on which they are not."""
    size = max((dist(points[0], p) for p in points), default=0.0)
    middles = [_halfway(a, b) for own in limbs for a, b in own if dist(a, b) > _LINK * size + _ROUNDING]
    for p in (*points, *middles):
        for own in limbs:
            if not _on_limb(p, own):
                yield from ((p, a, b) for a, b in own)


def _halfway(a: XYZ, b: XYZ) -> XYZ:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2


def _on_limb(p: XYZ, links: Sequence[Segment]) -> bool:
    return any(dist(p, a) + dist(p, b) - dist(a, b) < 1e-6 for a, b in links)


def _middle(strokes: Sequence[tuple[XY, XY]]) -> XY:
    """The middle of strokes, by their lengths."""
    weights = [dist(p, q) or 1e-9 for p, q in strokes]
    x, y = (sum(w * (p[i] + q[i]) / 2 for w, (p, q) in zip(weights, strokes, strict=True)) for i in (0, 1))
    return x / sum(weights), y / sum(weights)


def _cross(one: tuple[XY, XY], other: tuple[XY, XY]) -> bool:
    """Whether two strokes cross between their ends."""
    (a, b), (c, d) = one, other
    return _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0


def _side(a: XY, b: XY, p: XY) -> float:
    return round((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]), 9)


def _near(distance: float, enough: float) -> float:
    """0 from `enough` on, growing to 10 for nothing."""
    lack = max(0.0, 1 - distance / enough)
    return lack + 9 * lack**3
