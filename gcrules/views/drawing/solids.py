"""The shapes in space that stand for bodies, tetrahedra, planes and lines, as corners of polygons and strokes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import atan2, dist

from gcrules.views.drawing.bsp import XYZ, cross, dot, minus
from gcrules.views.drawing.legend import convex_hull, rounded

__all__ = ["center", "direction", "flat_normal", "outline", "patch", "stretched", "tetrahedron", "through_ball"]


_THICK = 0.25  # of its size a body is high that is drawn as a solid
_MOST = 12  # joints of one


def center(points: Sequence[XYZ]) -> XYZ:
    """The mean of points (the origin for none)."""
    n = len(points) or 1
    return sum(p[0] for p in points) / n, sum(p[1] for p in points) / n, sum(p[2] for p in points) / n


def flat_normal(corners: Sequence[XYZ]) -> XYZ | None:
    """The unit normal of the largest triangle of the corners; None if they are all in one line."""
    size = max((dist(a, b) for a, b in combinations(corners[:12], 2)), default=0.0)
    if not size:
        return None
    normals = [cross(minus(b, a), minus(c, a)) for a, b, c in combinations(corners[:12], 3)]
    largest = max(normals, key=lambda n: round(dot(n, n) / size**4, 9), default=(0.0, 0.0, 0.0))
    length = dot(largest, largest) ** 0.5
    return None if length <= 1e-6 * size * size else _scaled(largest, 1 / length)


def direction(a: XYZ, b: XYZ) -> XYZ | None:
    """The unit vector from one point to another; None if they coincide."""
    length = dist(a, b)
    return _scaled(minus(b, a), 1 / length) if length else None


def outline(corners: Sequence[XYZ]) -> list[tuple[tuple[XYZ, ...], tuple[bool, ...]]]:
    """A body through its joints as polygons, each with the marks of its true edges.

    Joints in one plane give their convex hull, those of a thick body the faces of theirs, others triangles around their
    centre; fewer than three, or all in one line, give nothing.
    """
    normal = flat_normal(corners)
    if len(corners) < 3 or normal is None:
        return []
    origin = center(corners)
    u, v = _basis(corners, normal)
    size = max(dist(c, origin) for c in corners)
    flat = [_flat(_scaled(minus(c, origin), 1 / size), u, v) for c in corners]
    if all(abs(dot(minus(c, origin), normal)) <= 0.01 * size for c in corners):
        hull = convex_hull(flat)
        return [(tuple(corners[flat.index(p)] for p in hull), (True,) * len(hull))]
    if max(abs(dot(minus(c, origin), normal)) for c in corners) > _THICK * size and len(corners) <= _MOST:
        return [(face, (True,) * len(face)) for face in _faces(corners, size)]
    order = sorted(range(len(corners)), key=lambda i: atan2(flat[i][1], flat[i][0]))
    ring = [corners[i] for i in order]
    return [((origin, a, b), (False, True, False)) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]


def _faces(corners: Sequence[XYZ], size: float) -> list[tuple[XYZ, ...]]:
    """The faces of the convex hull of points that are not in one plane."""
    found: dict[frozenset[int], tuple[XYZ, ...]] = {}
    for i, j, k in combinations(range(len(corners)), 3):
        normal = flat_normal([corners[i], corners[j], corners[k]])
        if normal is None:
            continue
        heights = [dot(minus(c, corners[i]), normal) / size for c in corners]
        face = frozenset(n for n, h in enumerate(heights) if abs(h) <= 1e-6)
        if face in found or (min(heights) < -1e-6 and max(heights) > 1e-6):
            continue
        own = [corners[n] for n in sorted(face)]
        u, v = _basis(own, normal)
        flat = [_flat(_scaled(minus(c, own[0]), 1 / size), u, v) for c in own]
        found[face] = tuple(own[flat.index(p)] for p in convex_hull(flat))
    return list(found.values())


def tetrahedron(corners: Sequence[XYZ]) -> list[tuple[XYZ, ...]]:
    """The four faces."""
    return list(combinations(corners, 3))


def patch(corners: Sequence[XYZ], margin: float, also: Sequence[XYZ] = ()) -> tuple[XYZ, ...] | None:
    """A part of the plane of three points, reaching beyond them by a margin, with round corners; None for a line.

    It also covers those of the further points that lie in the plane (within a twentieth of the margin).
    """
    normal = flat_normal(corners)
    if normal is None:
        return None
    origin = center(corners)
    u, v = _basis(corners, normal)
    covered = [*corners, *(p for p in also if abs(dot(minus(p, origin), normal)) <= margin / 20)]
    flat = [_flat(minus(c, origin), u, v) for c in covered]
    return tuple(_plus(origin, u, x, v, y) for x, y in rounded(flat, margin, step=0.4))


def stretched(ends: Sequence[XYZ], extra: float, also: Sequence[XYZ] = ()) -> tuple[XYZ, XYZ]:
    """A segment made longer at both ends, and up to those of the further points that lie on its line (within a
    twentieth of that length).
    """
    a, b = ends
    u = _scaled(minus(b, a), 1 / (dist(a, b) or 1.0))
    reach = [0.0, dist(a, b)]
    for p in also:
        along = dot(minus(p, a), u)
        if dist(p, _plus(a, u, along, u, 0.0)) <= extra / 20:
            reach.append(along)
    return _plus(a, u, min(reach) - extra, u, 0.0), _plus(a, u, max(reach) + extra, u, 0.0)


def through_ball(a: XYZ, b: XYZ, middle: XYZ, radius: float) -> tuple[XYZ, XYZ] | None:
    """The part of the line through two points inside a ball; None if it misses the ball or the points coincide."""
    length = dist(a, b)
    if length <= 1e-12 * radius:
        return None
    u = _scaled(minus(b, a), 1 / length)
    foot = dot(minus(middle, a), u)
    nearest = _plus(a, u, foot, u, 0.0)
    square = radius * radius - dist(nearest, middle) ** 2
    if square <= (0.1 * radius) ** 2:
        return None
    half = square**0.5
    return _plus(nearest, u, -half, u, 0.0), _plus(nearest, u, half, u, 0.0)


def _basis(corners: Sequence[XYZ], normal: XYZ) -> tuple[XYZ, XYZ]:
    """Two unit vectors along a plane; the corners are not all in one place, seen along its normal."""
    a = corners[0]
    size = max(dist(c, a) for c in corners)
    far = max(corners, key=lambda c: round(dot(minus(c, a), minus(c, a)) / size**2, 9))
    along = _within(minus(far, a), normal)
    if dot(along, along) <= 1e-6 * size**2:  # the farthest corner lies along the normal
        along = max((_within(minus(c, a), normal) for c in corners), key=lambda w: dot(w, w))
    u = _scaled(along, 1 / (dot(along, along) ** 0.5))
    return u, cross(normal, u)


def _within(v: XYZ, normal: XYZ) -> XYZ:
    """The part of a vector along the plane of this unit normal."""
    return minus(v, _scaled(normal, dot(v, normal)))


def _flat(p: XYZ, u: XYZ, v: XYZ) -> tuple[float, float]:
    """Coordinates along two vectors, rounded so that what is equal but for rounding is equal."""
    return round(dot(p, u), 9), round(dot(p, v), 9)


def _scaled(v: XYZ, factor: float) -> XYZ:
    return v[0] * factor, v[1] * factor, v[2] * factor


def _plus(p: XYZ, u: XYZ, s: float, v: XYZ, t: float) -> XYZ:
    return p[0] + s * u[0] + t * v[0], p[1] + s * u[1] + t * v[1], p[2] + s * u[2] + t * v[2]
