r"""The equivalent structure: the lines that stand for all wrenches of a robot, through labelled points, with the planes
and tetrahedra that decide whether the robot is singular.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import dist

from gcrules.algebra.evaluate import evaluate
from gcrules.conditions.pose_value import line_points
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.lines.wrenches import WrenchLine as Wrench
from gcrules.views.drawing.bsp import XYZ, CutPolygon, cross, dot, minus
from gcrules.views.drawing.drawing import Circle, Shape, Stroke, name_runs
from gcrules.views.drawing.frame import Frame
from gcrules.views.drawing.labels import Label, place_labels
from gcrules.views.drawing.scene_pieces import Look
from gcrules.views.drawing.solids import center, outline, patch, stretched, tetrahedron, through_ball
from gcrules.views.robots.drawn_limb import plus, unit_vector
from gcrules.views.robots.entities import DrawnFlat
from gcrules.views.robots.infinity_view import Far
from gcrules.views.robots.picture import body_pieces, dot_at, piece_shapes
from gcrules.views.robots.scene import HEIGHT, TOP, WIDTH, Scene
from gcrules.views.robots.symbols import arrow, turn_arrow

__all__ = [
    "DrawnMotion",
    "entity_role_of",
    "far",
    "motion_extent",
    "motion_shapes",
    "places_of",
    "structure_extent",
    "structure_shapes",
]

_BEYOND = 0.16  # how far a line reaches beyond its points
_RAY = 0.6  # the length of a line to a point at infinity
_LEAST = 0.12
_AXIS = 0.62  # half the length of the axis of a motion
_TURNS = (0.4, -0.4, 0.5, -0.5, 0.28, -0.28, 0.14, -0.14, 0.0)  # where on the axis the turn is drawn


@dataclass(frozen=True)
class DrawnMotion:
    """A motion of the platform, in units of the robot's size: about the line through `at` along `axis` with `pitch`, or
    (pitch None) a shift along `axis`, drawn at `at`.
    """

    at: XYZ
    axis: XYZ
    pitch: float | None


def structure_shapes(
    s: Scene, shown: Sequence[DrawnFlat], marks: Sequence[tuple[str, XYZ]] = (), motion: DrawnMotion | None = None
) -> list[Shape]:
    """The lines, their points, planes and tetrahedra; `marks` are named common points."""
    frame = s.frame
    near = [p for _, p in marks]
    pieces = _pieces(s, shown, near)
    _, rays = _lines(s)
    shapes = piece_shapes(pieces, frame)
    over: list[Shape] = []
    labels = []
    for ends, name, role in rays:
        start, end = (frame.place(p) for p in ends)
        over += arrow(start, end, role, 2.8)
        labels.append(Label(name_runs(name), end, (end[0] - start[0], end[1] - start[1]), 3.0, fill="muted"))
    for name, ends, role in _constructed(s):
        start, end = sorted((frame.place(p) for p in ends), key=lambda p: p[1])
        labels.append(Label(name_runs(name), start, (start[0] - end[0], start[1] - end[1]), 2.0, fill=role))
    if motion:
        over += motion_shapes(frame, motion, places_of(s))
    names = dict.fromkeys(n for line in s.a.structure.drawn for n in line.ends if n in s.points)
    dots = {n: frame.place(s.points[n]) for n in [*names, *(n for e in shown for n in e.points if n in s.points)]}
    over += [dot_at(at, _distance(s.points[n], s.plate) < _LEAST) for n, at in dots.items()]
    over += [Circle(frame.place(p), 5.4, "mark", "paper", 1.6) for p in near]
    x0, y0 = (sum(c[i] for c in dots.values()) / (len(dots) or 1) for i in range(2))
    labels += [Label(name_runs(n), at, (at[0] - x0, at[1] - y0), 5.0) for n, at in dots.items()]
    labels += [Label(name_runs(n), frame.place(p), (1.0, -1.0), 5.0, fill="mark") for n, p in marks]
    strokes = [(frame.place(p.corners[0]), frame.place(p.corners[1])) for p in pieces if len(p.corners) == 2]
    strokes += [(one.start, one.end) for one in over if isinstance(one, Stroke)]
    discs = [(at, 5.0) for at in (*dots.values(), *(frame.place(p) for p in near))]
    bounds = (4.0, TOP, WIDTH - 4, HEIGHT - 4)
    return [*shapes, *over, *place_labels(labels, discs=discs, strokes=strokes, bounds=bounds)]


def structure_extent(s: Scene, shown: Sequence[DrawnFlat], marks: Sequence[tuple[str, XYZ]] = ()) -> list[XYZ]:
    """Places between which the structure lies."""
    pieces = _pieces(s, shown, [p for _, p in marks])
    return [*(c for p in pieces for c in p.corners), *(p for ends, _, _ in _lines(s)[1] for p in ends)]


def _pieces(s: Scene, shown: Sequence[DrawnFlat], near: Sequence[XYZ]) -> list[CutPolygon[Look]]:
    drawn = [piece for e in shown for piece in _entity(s, e, _corners(s, e), near)]
    pieces = drawn or body_pieces(s, fill=0.12)
    solid, _ = _lines(s)
    pieces += [CutPolygon(ends, Look(role, width=3.2)) for ends, role in solid]
    pieces += [CutPolygon(stretched(ends, _BEYOND, also=near), Look(role, width=1.1)) for ends, role in solid]
    return [*pieces, *(CutPolygon(ends, Look(role, width=3.0, dash=(9, 3))) for _, ends, role in _constructed(s))]


def places_of(s: Scene) -> list[XYZ]:
    return [*(p.at for c in s.chains for p in c.places), *s.points.values()]


def _distance(p: XYZ, plate: Sequence[XYZ]) -> float:
    return min(dist(p, q) for q in plate)


_Segment = tuple[XYZ, XYZ]


def _lines(s: Scene) -> tuple[list[tuple[_Segment, str]], list[tuple[_Segment, str, str]]]:
    """Lines between two points, and those to a point at infinity with its name; each with its colour."""
    solid, rays = [], []
    middle = center([*s.points.values()])
    for line in s.a.structure.drawn:
        role = _line_role(s, line)
        near = [n for n in line.ends if n in s.points]
        if len(near) == 2:
            solid.append(((s.points[line.ends[0]], s.points[line.ends[1]]), role))
        elif near:
            name = next(n for n in line.ends if n not in s.points)
            at, u = s.points[near[0]], s.ideal[name]
            outwards = round(dot(u, minus(at, middle)), 6)
            if outwards < 0:
                u = (-u[0], -u[1], -u[2])
            rays.append(((plus(at, u, -0.5 * _RAY), plus(at, u, _RAY)), name, role))
    return solid, rays


def _line_role(s: Scene, line: Wrench) -> str:
    """That of the limb that applies it, if it is one."""
    limbs = s.a.structure.limbs
    return s.role([limb.limb.name for limb in limbs if any(w.ends == line.ends for w in limb.lines or ())])


def far(s: Scene) -> Far:
    """The lines at infinity among them, with their points."""
    lines = [line for line in s.a.structure.drawn if all(n in s.ideal for n in line.ends)]
    named = dict.fromkeys(n for line in lines for n in line.ends)
    drawn = []
    for line in lines:
        drawn.append((s.ideal[line.ends[0]], s.ideal[line.ends[1]], _line_role(s, line)))
    return Far({(n,): s.ideal[n] for n in named}, drawn)


# --- entities ------------------------------------------------------------------------------------------------------


def entity_role_of(s: Scene, e: DrawnFlat) -> str:
    """A plane of a limb's lines has the limb's colour, one of platform or base points theirs."""
    names = set(e.points)
    for line in s.a.structure.drawn:
        if names.issuperset(line.ends) and line.limb in s.roles:
            return s.roles[line.limb]
    owners = [limb for limb, own in _own(s) if names <= own]
    return s.roles[owners[0]] if owners else "platform"


def _own(s: Scene) -> list[tuple[str, set[str]]]:
    return [(limb.limb.name, {n for line in limb.lines or () for n in line.ends}) for limb in s.a.structure.limbs]


def _corners(s: Scene, e: DrawnFlat) -> list[XYZ]:
    """Points of an entity; a direction gives two places beside each of its finite points."""
    finite = [s.points[n] for n in e.points if n in s.points]
    directions = [s.ideal[n] for n in e.points if n in s.ideal]
    if e.kind == "tetrahedron" and directions:
        return finite if len(finite) == 3 else []
    found = list(finite)
    for u in directions:
        reach = 0.3 if len(finite) > 1 else 0.8
        found += [plus(p, u, r) for p in finite for r in (-reach, reach)]
    return found


def _entity(s: Scene, e: DrawnFlat, corners: Sequence[XYZ], marks: Sequence[XYZ]) -> list[CutPolygon[Look]]:
    role = entity_role_of(s, e)
    if e.kind == "tetrahedron" and len(corners) == 4:
        a, b, c, d = corners
        if abs(dot(minus(b, a), cross(minus(c, a), minus(d, a)))) > 1e-9:
            return [CutPolygon(face, Look(role, fill=0.12, edge=0.7, width=1.1)) for face in tetrahedron(corners)]
        hulls = outline(corners)
        return [CutPolygon(hull, Look("mark", fill=0.22, edge=0.9, width=1.5), edges) for hull, edges in hulls]
    polygon = patch(corners, 0.1, also=marks) if len(corners) > 2 else None
    return [CutPolygon(polygon, Look(role, fill=0.2, edge=0.8, width=1.3))] if polygon else []


def _constructed(s: Scene) -> list[tuple[str, _Segment, str]]:
    """The lines that the condition constructs (p and q), as far as they pass through the picture."""
    if s.a.condition is None:
        return []
    points = {n: (*p, 1.0) for n, p in s.points.items()} | {n: (*u, 0.0) for n, u in s.ideal.items()}
    found = []
    for name, e in s.a.condition.lines:
        ends = line_points(evaluate(e, points), (0.0, 0.0, 0.0), 1.0)
        drawn = through_ball(*ends, (0.0, 0.0, 0.0), 1.1) if ends else None
        if drawn:
            found.append((name or "p", drawn, "muted"))
    return found


# --- motions -------------------------------------------------------------------------------------------------------


def motion_shapes(frame: Frame, m: DrawnMotion, apart: Sequence[XYZ] = ()) -> list[Shape]:
    """The axis with a turn about it, drawn where it is `apart` from these places; or the arrow of a shift."""
    u = unit_vector(m.axis)
    if m.pitch is None:
        start, end = (frame.place(plus(m.at, u, r)) for r in (0.0, 0.5))
        return arrow(start, end, "mark", 4.2)
    start, end = (frame.place(plus(m.at, u, r)) for r in (-_AXIS, _AXIS))
    if dist(start, end) < 14:  # seen along the axis
        return [Circle(start, 3.4, "mark", "paper", 1.2), *turn_arrow(frame, m.at, u, "mark", 19.0, 2.4)]
    shapes: list[Shape] = [Stroke(start, end, "mark", 1.8, dash=(7.0, 3.0))]
    if m.pitch:
        shapes += arrow(end, frame.place(plus(m.at, u, _AXIS + 0.16)), "mark", 2.0)
    others = [frame.place(p) for p in apart]

    def room(r: float) -> float:
        return round(min((dist(frame.place(plus(m.at, u, r)), q) for q in others), default=99.0), 3)

    best = max(_TURNS, key=lambda r: min(room(r), 34.0))
    return [*shapes, *turn_arrow(frame, plus(m.at, u, best), u, "mark", 19.0, 2.4)]


def motion_extent(m: DrawnMotion) -> list[XYZ]:
    """Places between which a motion is drawn."""
    u = unit_vector(m.axis)
    return [plus(m.at, u, r) for r in ((0.0, 0.5) if m.pitch is None else (-_AXIS, _AXIS + 0.1))]
