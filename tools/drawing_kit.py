"""A small kit for pictures of points, lines and planes in space, drawn with `gcrules.views`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import cos, dist, hypot, pi, sin

from gcrules.views.drawing.bsp import XYZ, CutPolygon, cross, dot, minus, painted
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Run, Shape, Stroke, Text, name_runs
from gcrules.views.drawing.labels import Label, place_labels
from gcrules.views.drawing.solids import center, flat_normal, patch, stretched, tetrahedron
from gcrules.views.drawing.viewpoint import View

__all__ = ["BLUE", "DOT", "GREEN", "ORANGE", "Look", "Space", "between", "caption", "side_by_side", "times"]

DOT = 4.6
BLUE, ORANGE, GREEN = "entity1", "entity2", "entity3"


@dataclass(frozen=True)
class Look:
    role: str
    fill: float = 0.0
    edge: float = 0.0
    width: float = 1.0
    dash: tuple[float, float] | None = None


@dataclass
class Space:
    """What there is to see in space; `draw` projects it orthographically, the z axis upright."""

    points: dict[str, tuple[XYZ, str]] = field(default_factory=dict)
    pieces: list[CutPolygon[Look]] = field(default_factory=list)
    heads: list[tuple[XYZ, XYZ, str]] = field(default_factory=list)
    names: list[tuple[str, XYZ, XY, str]] = field(default_factory=list)

    def at(self, name: str) -> XYZ:
        return self.points[name][0]

    def point(self, role: str = "ink", **places: XYZ) -> None:
        """Points with their names; the role `mark` is for points that were constructed."""
        self.points |= {name: (xyz, role) for name, xyz in places.items()}

    def line(
        self,
        a: str | XYZ,
        b: str | XYZ,
        role: str = BLUE,
        *,
        beyond: float = 0.0,
        width: float = 2.6,
        dashed: bool = False,
    ) -> None:
        ends = stretched([self._xyz(a), self._xyz(b)], beyond)
        self.pieces.append(CutPolygon(ends, Look(role, width=width, dash=(6, 4) if dashed else None)))

    def plane(self, *names: str | XYZ, role: str = BLUE, margin: float = 0.3, also: Sequence[XYZ] = ()) -> None:
        polygon = patch([self._xyz(n) for n in names], margin, also)
        if polygon:
            self.pieces.append(CutPolygon(polygon, Look(role, fill=0.22, edge=0.9, width=1.3)))

    def tetrahedron(self, *names: str, role: str = BLUE) -> None:
        for face in tetrahedron([self.at(n) for n in names]):
            self.pieces.append(CutPolygon(face, Look(role, fill=0.15, edge=0.9, width=1.6)))

    def turn(self, *names: str, role: str = BLUE, radius: float = 0.25) -> None:
        """A round arrow in the plane of three points, the way round that the points have."""
        corners = [self.at(n) for n in names]
        middle, normal = center(corners), flat_normal(corners)
        assert normal is not None
        u = minus(corners[0], middle)
        u = times(u, 1 / hypot(*u))
        v = cross(normal, u)
        if dot(v, minus(corners[1], middle)) < 0:
            v = times(v, -1)
        ring = [
            tuple(m + radius * (cos(t) * x + sin(t) * y) for m, x, y in zip(middle, u, v, strict=True))
            for t in (2 * pi * k / 40 for k in range(33))
        ]
        for a, b in pairwise(ring):
            self.pieces.append(CutPolygon((a, b), Look(role, width=2.0)))  # type: ignore[arg-type]
        self.heads.append((ring[-2], ring[-1], role))  # type: ignore[arg-type]

    def head(self, a: str | XYZ, b: str | XYZ, role: str = BLUE) -> None:
        """An arrow head at b, coming from a."""
        self.heads.append((self._xyz(a), self._xyz(b), role))

    def name(self, text: str, at: XYZ, toward: XY, role: str = "ink") -> None:
        self.names.append((text, at, toward, role))

    def draw(
        self,
        title: str,
        *,
        view: tuple[float, float],
        size: tuple[float, float] = (250.0, 210.0),
        caption: Sequence[Run] = (),
        scale: float | None = None,
    ) -> Drawing:
        width, height = size
        foot = 30.0 if caption else 0.0
        eye = View.at(*view)
        flat = [eye.flat(c) for p in self.pieces for c in p.corners] + [eye.flat(p) for p, _ in self.points.values()]
        (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*flat, strict=True))
        factor = scale or min((width - 56) / ((x1 - x0) or 1e-9), (height - 52) / ((y1 - y0) or 1e-9))
        shift = (width / 2 - factor * (x0 + x1) / 2, height / 2 - factor * (y0 + y1) / 2)

        def place(p: XYZ) -> XY:
            x, y = eye.flat(p)
            return factor * x + shift[0], factor * y + shift[1]

        shapes: list[Shape] = []
        for piece in painted(self.pieces, eye.eye, 1e-6):
            shapes += _shapes(piece, [place(c) for c in piece.corners])
        shapes += [arrow_head(place(a), place(b), role) for a, b, role in self.heads]
        discs = []
        for p, role in self.points.values():
            shapes.append(Circle(place(p), DOT, role, "paper", 1.4))
            discs.append((place(p), DOT))
        middle = center([(*place(p), 0.0) for p, _ in self.points.values()])
        labels = [
            Label(name_runs(n), place(p), _away(place(p), middle, len(self.points)), DOT, 16.0, role)
            for n, (p, role) in self.points.items()
        ]
        labels += [Label(name_runs(n), place(p), toward, 2.0, 16.0, role) for n, p, toward, role in self.names]
        strokes = [(place(p.corners[0]), place(p.corners[1])) for p in self.pieces if len(p.corners) == 2]
        strokes += [
            (place(a), place(b))
            for p in self.pieces
            if len(p.corners) > 2
            for a, b in zip(p.corners, (*p.corners[1:], p.corners[0]), strict=True)
        ]
        shapes += place_labels(labels, discs=discs, strokes=strokes, bounds=(2, 2, width - 2, height - 2))
        if caption:
            shapes.append(Text((width / 2, height + 16), tuple(caption), 14, "middle"))
        return Drawing(width, height + foot, tuple(shapes), title)

    def _xyz(self, p: str | XYZ) -> XYZ:
        return self.at(p) if isinstance(p, str) else p


def _away(at: XY, middle: XYZ, count: int) -> XY:
    """Where the name of a point had better stand: outwards; above for the points of a line."""
    return (0.0, -1.0) if count < 3 else (at[0] - middle[0], at[1] - middle[1] - 3)


def times(v: XYZ, factor: float) -> XYZ:
    return v[0] * factor, v[1] * factor, v[2] * factor


def between(a: XYZ, b: XYZ, t: float) -> XYZ:
    return tuple(x + t * (y - x) for x, y in zip(a, b, strict=True))  # type: ignore[return-value]


def _shapes(piece: CutPolygon[Look], at: list[XY]) -> list[Shape]:
    look = piece.tag
    if len(at) == 2:
        return [Stroke(at[0], at[1], look.role, look.width, dash=look.dash)]
    edges = zip(at, [*at[1:], at[0]], piece.edges, strict=True)
    return [
        Polygon(tuple(at), look.role, fill_opacity=look.fill),
        *(Stroke(a, b, look.role, look.width, look.edge) for a, b, original in edges if original),
    ]


def arrow_head(a: XY, b: XY, role: str, size: float = 9.0) -> Shape:
    length = dist(a, b) or 1.0
    u = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
    tip = (b[0] + 0.5 * size * u[0], b[1] + 0.5 * size * u[1])
    back = (b[0] - 0.6 * size * u[0], b[1] - 0.6 * size * u[1])
    side = (-0.42 * size * u[1], 0.42 * size * u[0])
    return Polygon((tip, (back[0] + side[0], back[1] + side[1]), (back[0] - side[0], back[1] - side[1])), fill=role)


def _moved(shape: Shape, dx: float, dy: float) -> Shape:
    match shape:
        case Polygon():
            return replace(shape, points=tuple((x + dx, y + dy) for x, y in shape.points))
        case Stroke():
            (a, b), (c, d) = shape.start, shape.end
            return replace(shape, start=(a + dx, b + dy), end=(c + dx, d + dy))
        case Circle():
            return replace(shape, center=(shape.center[0] + dx, shape.center[1] + dy))
        case Text():
            return replace(shape, at=(shape.at[0] + dx, shape.at[1] + dy))


def side_by_side(title: str, *drawings: Drawing, gap: float = 14.0) -> Drawing:
    """Drawings in one row, centred on each other's height."""
    height = max(d.height for d in drawings)
    shapes: list[Shape] = []
    x = 0.0
    for d in drawings:
        shapes += [_moved(s, x, (height - d.height) / 2) for s in d.shapes]
        x += d.width + gap
    return Drawing(x - gap, height, tuple(shapes), title)


def caption(formula: Sequence[str], words: str) -> tuple[Run, ...]:
    return (*name_runs(*formula), Run(f"  {words}"))
