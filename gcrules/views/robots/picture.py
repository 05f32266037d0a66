r"""The picture of the robot itself: base, platform, limbs with the signs of their joints, and their wrenches."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, dist, pi, sin

from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.limb_file import PLATFORM
from gcrules.mechanisms.lines.equivalent import FRAME
from gcrules.mechanisms.lines.wrenches import WrenchLine as Wrench
from gcrules.views.drawing.bsp import XYZ, CutPolygon, cross, dot, minus, painted
from gcrules.views.drawing.drawing import XY, Circle, Polygon, Shape, Stroke, extent, name_runs
from gcrules.views.drawing.frame import Frame
from gcrules.views.drawing.labels import Box, Label, place_labels
from gcrules.views.drawing.scene_pieces import Look
from gcrules.views.drawing.solids import center, outline
from gcrules.views.robots.drawn_limb import DrawnLimb, plus, unit_vector
from gcrules.views.robots.forces import REACH, force
from gcrules.views.robots.joint_chain import upright
from gcrules.views.robots.scene import HEIGHT, TOP, WIDTH, Scene, joint_names
from gcrules.views.robots.symbols import SIGN, arrow, basis, couple, sign

__all__ = ["CONSTRAINT_DASH", "body_pieces", "dot_at", "piece_shapes", "robot_shapes", "sign_box"]

CONSTRAINT_DASH = (4.0, 2.6)

_AXIS = 27.0  # points
_LINK = {"link": 4.4, "bar": 2.6, "rail": 2.2, "tube": 8.4}
_CABLE = 1.5
_RIM = 72  # corners of a circle


def body_pieces(s: Scene, fill: float = 0.2) -> list[CutPolygon[Look]]:
    """Base and platform as areas; two corners as a bar."""
    pieces = []
    for role, corners in (("base", s.base), ("platform", s.plate)):
        faces = outline(corners)
        solid = len(faces) > 1 and all(all(edges) for _, edges in faces)
        look = Look(role, fill=0.3 * fill if solid else fill, edge=0.9, width=1.4)
        pieces += [CutPolygon(polygon, look, edges) for polygon, edges in faces]
        if len(corners) == 2:
            pieces.append(CutPolygon((corners[0], corners[1]), Look(role, width=3.0)))
    return pieces


def piece_shapes(pieces: Sequence[CutPolygon[Look]], frame: Frame) -> list[Shape]:
    """Areas and strokes in the order in which to draw them."""
    shapes: list[Shape] = []
    for piece in painted(pieces, frame.view.eye, 1e-6):
        look, at = piece.tag, [frame.place(c) for c in piece.corners]
        if len(at) == 2:
            shapes.append(Stroke(at[0], at[1], look.role, look.width, dash=look.dash))
            continue
        edges = zip(at, [*at[1:], at[0]], piece.edges, strict=True)
        shapes.append(Polygon(tuple(at), look.role, fill_opacity=look.fill))
        shapes += [Stroke(p, q, look.role, look.width, look.edge) for p, q, original in edges if original]
    return shapes


def robot_shapes(s: Scene, over: Sequence[Shape] = (), *, words: bool = True) -> list[Shape]:
    """The robot with its wrenches; `over` is drawn above it. Without `words` neither labels nor wrenches."""
    pieces = body_pieces(s)
    frame = s.frame
    for c in s.chains:
        role = s.roles[c.limb.name]
        for stroke in c.strokes:
            if stroke.look == "axis":
                pieces.append(CutPolygon((stroke.start, stroke.end), Look("muted", width=0.9, dash=(5, 3))))
            elif dist(stroke.start, stroke.end) > 1e-9:
                width = _CABLE if c.limb.cable else _LINK[stroke.look]
                pieces.append(CutPolygon((stroke.start, stroke.end), Look(role, width=width)))
        if len(c.limb.joints) == 1 and len(s.base) > 2:  # a pivot: on a post, and held by the platform
            pieces.append(CutPolygon((center(s.base), c.foot), Look(role, width=4.4)))
            pieces.append(CutPolygon((c.head, s.heart), Look("platform", width=3.0)))
        elif c.end == PLATFORM and c.head not in s.plate and min(dist(c.head, p) for p in s.plate) > 1e-6:
            pieces.append(CutPolygon((c.head, s.heart), Look("platform", width=3.0)))
    shapes = [*_spheres(s), *piece_shapes(pieces, frame)]
    axes, tips = _axes(s) if words else ([], [])
    shapes += axes
    named = [s.points[n] for n in joint_names(s.a) if n in s.points]
    shapes += [Circle(frame.place(p), 2.6, "ink", "paper", 1.0) for p in named]
    jointed = [(k, c) for k, c in enumerate(s.chains) if not c.limb.cable]
    placed = [(frame.sight(p.at), k, p, s.roles[c.limb.name]) for k, c in jointed for p in c.places]
    signs = [sign(place, frame, role) for _, _, place, role in sorted(placed, key=lambda one: one[:2])]
    shapes += [shape for one in signs for shape in one]
    if not words:
        return shapes
    arrows = _arrows(s)
    strokes = [(frame.place(p.corners[0]), frame.place(p.corners[1])) for p in pieces if len(p.corners) == 2]
    strokes += [(one.start, one.end) for one in (*arrows, *axes, *over) if isinstance(one, Stroke)]
    texts = place_labels(
        [*_point_labels(s), *tips],
        strokes=strokes,
        taken=[sign_box(one) for one in signs],
        places=[*map(frame.place, named), *(frame.place(place.at) for _, _, place, _ in placed)],
        bounds=(4.0, TOP, WIDTH - 4, HEIGHT - 4),
    )
    return [*shapes, *arrows, *over, *texts]


def _spheres(s: Scene) -> list[Shape]:
    """The outlines of the spheres that links around a point move on, and of the largest its equator."""
    shapes: list[Shape] = []
    frame = s.frame
    u, v = basis(upright(s.chains))
    for o in dict.fromkeys(c.around for c in s.chains if c.around):
        radii = sorted({r for c in s.chains if c.around == o for r in c.spheres}, reverse=True)
        for r in radii:
            rim = _circle(o, frame.view.right, frame.view.up, r)
            shapes.append(
                Polygon(tuple(map(frame.place, rim)), "muted", "muted", fill_opacity=0.05, stroke_opacity=0.55)
            )
        equator = _circle(o, u, v, radii[0])
        for p, q in pairwise([*equator, equator[0]]):
            front = dot(minus(p, o), frame.view.eye) >= 0
            shapes.append(Stroke(frame.place(p), frame.place(q), "muted", 0.8, 0.5 if front else 0.2))
    return shapes


def _circle(o: XYZ, u: XYZ, v: XYZ, r: float) -> list[XYZ]:
    angles = [2 * pi * k / _RIM for k in range(_RIM)]
    return [plus(plus(o, u, r * cos(a)), v, r * sin(a)) for a in angles]


def sign_box(shapes: Sequence[Shape]) -> Box:
    """The area that the sign of a joint covers."""
    xs, ys = zip(*(p for one in shapes for p in extent(one)), strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _point_labels(s: Scene) -> list[Label]:
    at = {n: s.frame.place(s.points[n]) for n in joint_names(s.a) if n in s.points}
    if not at:
        return []
    x0, y0 = sum(x for x, _ in at.values()) / len(at), sum(y for _, y in at.values()) / len(at)
    signs = [s.frame.place(p.at) for c in s.chains for p in c.places]
    return [
        Label(name_runs(n), (x, y), (x - x0, y - y0), 9.0 if min(dist((x, y), q) for q in signs) < 4 else 3.0)
        for n, (x, y) in at.items()
    ]


def _axes(s: Scene) -> tuple[list[Shape], list[Label]]:
    """The axes whose directions are points of the lines, each drawn once, with its name at the tip."""
    shapes: list[Shape] = []
    labels = []
    named: set[str] = set()
    for c in s.chains:
        placed = iter(p for p in c.places if p.kind != "pin")
        by_kind = {(p.kind, tuple(round(x, 9) for x in p.at)): p for p in placed}
        for j in c.joints:
            for place in by_kind.values():
                if place.kind != j.kind:
                    continue
                for term, axis in zip(j.directions, place.axes, strict=False):
                    name = term[0][1]
                    if len(term) > 1 or name in named or name in "xyz":
                        continue
                    if name not in s.a.structure.ideal and not c.around:
                        continue
                    if abs(dot(axis, s.ideal[name])) < 0.999999:
                        continue
                    named.add(name)
                    if c.around:
                        labels.append(_beside_joint(s, name, place.at, c))
                        continue
                    u = axis if dot(axis, s.ideal[name]) > 0 else s.ideal[name]
                    start, tip = s.frame.place(place.at), s.frame.place(plus(place.at, u, _AXIS / s.frame.scale))
                    shapes.append(Stroke(start, tip, s.roles[c.limb.name], 1.2))
                    toward = (tip[0] - start[0], tip[1] - start[1])
                    labels.append(Label(name_runs(name), tip, toward, 1.0, fill=s.roles[c.limb.name]))
    return shapes, labels


def _beside_joint(s: Scene, name: str, at: XYZ, c: DrawnLimb) -> Label:
    """The name of an axis beside its joint, away from the point through which the axes pass."""
    (x, y), (x0, y0) = s.frame.place(at), s.frame.place(c.around or s.heart)
    return Label(name_runs(name), (x, y), (x - x0, y - y0), 9.0 * s.frame.size, fill=s.roles[c.limb.name])


def dot_at(at: XY, platform: bool) -> Circle:
    """A point of the equivalent structure: of the platform, or of the base."""
    return Circle(at, 4.6, "paper" if platform else "ink", "ink", 1.6)


# --- wrenches ------------------------------------------------------------------------------------------------------


def _wrenches(a: RobotAnalysis) -> dict[tuple[str, str], tuple[Wrench, list[str]]]:
    """Each line that a limb applies once, with the limbs that do."""
    found: dict[tuple[str, str], tuple[Wrench, list[str]]] = {}
    for limb in a.structure.limbs:
        for line in limb.lines or ():
            found.setdefault(line.ends, (line, []))[1].append(limb.limb.name)
    for line in a.structure.lines or ():
        if line.limb == FRAME:
            continue
        found.setdefault(line.ends, (line, [line.limb]))
    return found


def _arrows(s: Scene) -> list[Shape]:
    shapes: list[Shape] = []
    for line, limbs in _wrenches(s.a).values():
        role = s.role(limbs)
        dash = CONSTRAINT_DASH if line.role == "constraint" else None
        placed = force(line, s.points, s.ideal, s.plate)
        if placed:
            at, u = placed
            start, end = plus(at, u, SIGN / s.frame.scale), plus(at, u, REACH)
            shapes += arrow(s.frame.place(start), s.frame.place(end), role, 2.6, dash)
        else:
            moment = cross(s.ideal[line.ends[0]], s.ideal[line.ends[1]])
            shapes += couple(s.frame, _couple_place(s, limbs), unit_vector(moment), role, dash)
    return shapes


def _couple_place(s: Scene, limbs: Sequence[str]) -> XYZ:
    """Couples have no place; they are drawn on the last link of their limb, those of several limbs on the platform."""
    if len(limbs) > 1:
        out = minus(s.heart, center(s.base))
        return plus(s.heart, unit_vector(out), 0.42) if dot(out, out) > 1e-9 else s.heart
    chain = [c for c in s.chains if c.limb.name == limbs[0]][-1]
    links = [one for one in chain.strokes if one.look in ("link", "bar")]
    if not links:
        return chain.head
    last = max(links[-3:], key=lambda one: round(dist(one.start, one.end), 6))
    return plus(last.start, minus(last.end, last.start), 0.72)
