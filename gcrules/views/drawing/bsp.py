"""Back-to-front order of polygons and strokes in space, by a tree of half-spaces; what crosses a polygon is split.

A piece is a tuple of corners: three or more (a plane convex polygon), or two (a stroke). Only polygons split.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Generic, TypeVar

from gcrules.core.dataclass import dataclass

__all__ = ["XYZ", "CutPolygon", "cross", "crossing", "dot", "minus", "painted"]

XYZ = tuple[float, float, float]
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class CutPolygon(Generic[T]):
    """Corners in space and whatever the caller wants to know when it is drawn.

    `edges[i]` says whether the edge from corner i to the next is one of the original polygon, not a cut.
    """

    corners: tuple[XYZ, ...]
    tag: T
    edges: tuple[bool, ...] = ()


def minus(a: XYZ, b: XYZ) -> XYZ:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a: XYZ, b: XYZ) -> XYZ:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a: XYZ, b: XYZ) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def painted(pieces: Sequence[CutPolygon[T]], eye: XYZ, tolerance: float) -> list[CutPolygon[T]]:
    """The pieces in the order in which to draw them, seen from infinitely far in the direction `eye`.

    `tolerance` is the distance below which a corner counts as lying in a plane; polygons without area are left out.
    Pieces in one plane keep their order, polygons before strokes; of two strokes that cross in the picture the farther
    one comes first.
    """
    polygons = [
        (replace(p, edges=p.edges or (True,) * len(p.corners)), plane)
        for p in pieces
        if len(p.corners) > 2 and (plane := _plane(p.corners))
    ]
    return _ordered(polygons, [p for p in pieces if len(p.corners) == 2], eye, tolerance)


_Plane = tuple[XYZ, float]


def _ordered(
    polygons: list[tuple[CutPolygon[T], _Plane]], strokes: list[CutPolygon[T]], eye: XYZ, tolerance: float
) -> list[CutPolygon[T]]:
    """The first polygon's plane divides the rest; each piece keeps the plane of the polygon that it was cut from."""
    if not polygons:
        return _ordered_strokes(strokes, eye, tolerance)
    first, plane = polygons[0]
    sides: dict[int, tuple[list[tuple[CutPolygon[T], _Plane]], list[CutPolygon[T]]]] = {s: ([], []) for s in (-1, 0, 1)}
    for polygon, own in polygons[1:]:
        for side, part in _split(polygon, plane, tolerance):
            sides[side][0].append((part, own))
    for stroke in strokes:
        for side, part in _split(stroke, plane, tolerance):
            sides[side][1].append(part)
    near = 1 if dot(plane[0], eye) > 0 else -1
    return [
        *_ordered(*sides[-near], eye, tolerance),
        first,
        *(polygon for polygon, _ in sides[0][0]),
        *_ordered_strokes(sides[0][1], eye, tolerance),
        *_ordered(*sides[near], eye, tolerance),
    ]


def _ordered_strokes(strokes: list[CutPolygon[T]], eye: XYZ, tolerance: float) -> list[CutPolygon[T]]:
    """The farthest first: always one with no crossing stroke behind it, the one with the farthest ends among these."""
    left = sorted(strokes, key=lambda s: round(sum(dot(c, eye) for c in s.corners), 6))
    out = []
    while left:
        free = (s for s in left if not any(_behind(o, s, eye, tolerance) for o in left if o is not s))
        first = next(free, left[0])
        left = [s for s in left if s is not first]
        out.append(first)
    return out


def _behind(a: CutPolygon[T], b: CutPolygon[T], eye: XYZ, tolerance: float) -> bool:
    found = crossing(a.corners, b.corners, eye)
    return found is not None and found[2] > tolerance


def crossing(a: Sequence[XYZ], b: Sequence[XYZ], eye: XYZ) -> tuple[float, float, float] | None:
    """Where the pictures of two strokes cross: the places along a and b (0 to 1) and how much b is nearer to the eye.

    None if they do not cross between their ends.
    """
    u, v, r = minus(a[1], a[0]), minus(b[0], b[1]), minus(b[0], a[0])
    volume = dot(u, cross(v, eye))
    if abs(volume) < 1e-12:
        return None
    s, t, k = dot(r, cross(v, eye)) / volume, dot(u, cross(r, eye)) / volume, dot(u, cross(v, r)) / volume
    return (s, t, k) if 1e-6 < s < 1 - 1e-6 and 1e-6 < t < 1 - 1e-6 else None


def _plane(corners: Sequence[XYZ]) -> _Plane | None:
    """Unit normal (Newell's sum over all corners) and offset; None for corners on one line."""
    x = y = z = 0.0
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        n = cross(minus(a, corners[0]), minus(b, corners[0]))
        x, y, z = x + n[0], y + n[1], z + n[2]
    length = (x * x + y * y + z * z) ** 0.5
    size = max(abs(c) for corner in corners for c in minus(corner, corners[0]))
    if length <= 1e-9 * size * size:
        return None
    normal = (x / length, y / length, z / length)
    return normal, sum(dot(normal, c) for c in corners) / len(corners)


def _split(piece: CutPolygon[T], plane: _Plane, tolerance: float) -> list[tuple[int, CutPolygon[T]]]:
    normal, offset = plane
    heights = [dot(normal, c) - offset for c in piece.corners]
    # A corner in the plane is exactly there: else the last bit, not the same everywhere, would cut off a sliver.
    heights = [0.0 if abs(h) <= tolerance else h for h in heights]
    if not any(heights):
        return [(0, piece)]
    found = []
    for side in (1, -1):
        if not any(side * h > 0 for h in heights):
            continue
        if all(side * h >= 0 for h in heights):
            return [(side, piece)]
        part = _half(piece, [side * h for h in heights])
        if len(part.corners) >= min(len(piece.corners), 3):
            found.append((side, part))
    return found


def _half(piece: CutPolygon[T], heights: Sequence[float]) -> CutPolygon[T]:
    """The part of a piece where the height is not negative."""
    corners: list[XYZ] = []
    edges: list[bool] = []
    closed = len(piece.corners) > 2
    count = len(piece.corners)
    for i in range(count):
        j = (i + 1) % count
        original = piece.edges[i] if closed else True
        if heights[i] >= 0:
            corners.append(piece.corners[i])
            edges.append(original and (heights[i] > 0 or heights[j] >= 0))
        if heights[i] * heights[j] < 0 and (closed or i == 0):
            t = heights[i] / (heights[i] - heights[j])
            a, b = piece.corners[i], piece.corners[j]
            corners.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])))
            edges.append(heights[i] < 0 and original)
    return replace(piece, corners=tuple(corners), edges=tuple(edges) if closed else ())
