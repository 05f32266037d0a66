"""The robot in its pose, with the tetrahedra, planes and lines that decide whether it is singular."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import dist, isfinite

from gcrules.algebra.language.legs_text import leg_text, legs_text
from gcrules.core.errors import InputError
from gcrules.views.drawing.bsp import XYZ, CutPolygon, cross, dot, minus, painted
from gcrules.views.drawing.drawing import Circle, Drawing, Run, Shape, Text, name_runs
from gcrules.views.drawing.frame import Frame, Unit, framed
from gcrules.views.drawing.labels import Label, place_labels
from gcrules.views.drawing.legend import ROW, EntityLike, LegendEntry, entity_entries, legend, legend_width
from gcrules.views.drawing.palette import entity_role
from gcrules.views.drawing.sample import Legs, sample_coordinates
from gcrules.views.drawing.scene_pieces import SAME, Look, crossings, piece_shapes
from gcrules.views.drawing.solids import direction, flat_normal, outline, patch, stretched, tetrahedron, through_ball
from gcrules.views.drawing.viewpoint import choose_view

__all__ = ["draw_platform", "sample_coordinates"]

Coordinates = Mapping[str, Sequence[float | Fraction]]
NamedLine = tuple[Sequence[float | Fraction], Sequence[float | Fraction], str]

NamedPoint = tuple[Sequence[float | Fraction], str]

_WIDTH, _HEIGHT = 470.0, 400.0
_MARGIN = 34.0
_JOINT = 5.0
_KEY_WIDTH = 118.0
_REACH = 2.2  # how far from the middle of the joints a constructed point is drawn, in radii
_BALL = 1.15


def draw_platform(
    legs: Legs,
    coordinates: Coordinates,
    base: Sequence[str] = (),
    platform: Sequence[str] = (),
    entities: Sequence[EntityLike] = (),
    lines: Sequence[NamedLine] = (),
    marks: Sequence[NamedPoint] = (),
    *,
    key: bool = True,
) -> Drawing:
    """The robot seen orthographically, the z axis upright, from a viewpoint chosen so that little is hidden.

    `coordinates` gives (x, y, z) for each point in any one unit of length; `base` and `platform` name the points of the
    two bodies, which are drawn as areas. Entities have a kind (tetrahedron, plane, line or point) and names of points.
    `lines` are constructed lines, two points in space and a label such as p; `marks` are constructed points, for
    example where planes meet. Before the name a label may say what it is in the legend ("common point M"); a line that
    does so is drawn as a mark. What is far outside the robot is not drawn; the legend (`key`) says so.
    A flat tetrahedron is drawn as the area that it covers. What lies behind is drawn first, areas that intersect are
    split. Raises InputError for no legs, a point without three finite coordinates and a leg of length zero.
    """
    if not legs:
        raise InputError("there are no legs to draw")
    given = _checked(legs, coordinates, entities)
    unit = Unit.of([given[name] for leg in legs for name in leg])
    points = {name: unit.place(p) for name, p in given.items()}
    joints = {name: points[name] for leg in legs for name in leg}
    near = {
        _last_word(label): xyz
        for p, label in marks
        if dist(xyz := unit.place(_xyz(p, f"point {label}")), _ORIGIN) <= _REACH
    }
    ends = [(unit.place(_xyz(p, f"line {n}")), unit.place(_xyz(q, f"line {n}"))) for p, q, n in lines]
    roles = [_line_role(n, len(entities) + i) for i, (_, _, n) in enumerate(lines)]
    flat = {i for i, e in enumerate(entities) if e.kind == "tetrahedron" and _is_flat([points[n] for n in e.points])}
    pieces = [
        *_bodies(joints, base, platform),
        *_entities(points, entities, list(near.values()), flat),
        *_constructed(ends, roles),
    ]
    drawn = {frozenset(e.points): i for i, e in enumerate(entities) if e.kind == "line"}
    for i, (a, b) in enumerate(legs):
        role = entity_role(drawn[frozenset((a, b))]) if frozenset((a, b)) in drawn else "leg"
        pieces.append(CutPolygon((points[a], points[b]), Look(role, width=3.2, leg=i)))
    normals = [n for p in pieces if len(p.corners) > 2 and (n := flat_normal(p.corners))]
    along = [u for p in pieces if p.tag.line is not None and (u := direction(*p.corners))]
    view, _ = choose_view(joints, legs, normals, along)
    entries = [*entity_entries(entities, flat), *_constructed_entries(lines, roles, marks, pieces, near)]
    frame = framed(view, [*(c for p in pieces for c in p.corners), *near.values()], _WIDTH, _HEIGHT, _MARGIN)
    shapes: list[Shape] = []
    over = crossings(legs, points, view.eye)
    for piece in painted(pieces, view.eye, SAME):
        shapes += piece_shapes(piece, frame, over)
    shapes += _rings(points, entities, frame)
    shapes += [
        Circle(frame.place(p), _JOINT, "paper" if name in platform else "ink", "ink", 1.6)
        for name, p in sorted(joints.items(), key=lambda item: round(dot(item[1], view.eye), 6))
    ]
    strokes = [(frame.place(p.corners[0]), frame.place(p.corners[1])) for p in pieces if len(p.corners) == 2]
    shapes += [Circle(frame.place(p), 5.0, "mark", "paper", 1.4) for p in near.values()]
    labels = [*_joint_labels(joints, platform, frame), *_line_labels(pieces, lines, roles, frame)]
    labels += [Label(name_runs(name), frame.place(p), (1.0, -1.0), 5.0, fill="mark") for name, p in near.items()]
    shapes += place_labels(
        labels,
        discs=[(frame.place(p), _JOINT) for p in (*joints.values(), *near.values())],
        strokes=strokes,
        bounds=(4, 4, _WIDTH - 2, _HEIGHT - 4),
    )
    title = f"Robot with legs {legs_text(legs)}"
    if not key:
        return Drawing(_WIDTH, _HEIGHT, tuple(shapes), title)
    keyed = bool(base and platform)
    side = max(legend_width(entries), _KEY_WIDTH if keyed else 0.0)
    shapes += legend(entries, _WIDTH + 6, 14)
    if keyed:
        shapes += _key(_WIDTH + 6, max(14 + ROW * len(entries) + 10, _HEIGHT - 56))
    height = max(_HEIGHT, ROW * len(entries) + 90)
    width = _WIDTH + (side + 20 if side else 0)
    return Drawing(width, height, tuple(shapes), title)


def _checked(legs: Legs, coordinates: Coordinates, entities: Sequence[EntityLike]) -> dict[str, XYZ]:
    needed = dict.fromkeys([*(n for leg in legs for n in leg), *(n for e in entities for n in e.points)])
    missing = [name for name in needed if name not in coordinates]
    if missing:
        raise InputError(f"no coordinates given for {', '.join(missing)}")
    points = {name: _xyz(coordinates[name], f"point {name}") for name in needed}
    for leg in legs:
        if points[leg[0]] == points[leg[1]]:
            raise InputError(f"the leg {leg_text(leg)} has length zero")
    return points


_ORIGIN = (0.0, 0.0, 0.0)


def _is_flat(corners: Sequence[XYZ]) -> bool:
    """Whether four points lie in one plane (in the unit of the ball's radius)."""
    if len(corners) != 4:
        return False
    a, b, c, d = corners
    return abs(dot(minus(b, a), cross(minus(c, a), minus(d, a)))) <= 1e-9


def _xyz(values: Sequence[float | Fraction], what: str) -> XYZ:
    numbers = tuple(float(v) for v in values)
    if len(numbers) != 3 or not all(map(isfinite, numbers)):
        raise InputError(f"{what} needs three finite coordinates")
    return numbers[0], numbers[1], numbers[2]


# --- what there is to draw -----------------------------------------------------------------------------------------


def _bodies(joints: Mapping[str, XYZ], base: Sequence[str], platform: Sequence[str]) -> list[CutPolygon[Look]]:
    pieces = []
    for role, names in (("base", base), ("platform", platform)):
        corners = [joints[name] for name in dict.fromkeys(names) if name in joints]
        look = Look(role, fill=0.16, edge=0.9, width=1.3)
        pieces += [CutPolygon(polygon, look, edges) for polygon, edges in outline(corners)]
        if len(corners) == 2:
            pieces.append(CutPolygon((corners[0], corners[1]), Look(role, width=1.3)))
    return pieces


def _entities(
    points: Mapping[str, XYZ], entities: Sequence[EntityLike], marks: Sequence[XYZ], flat: Collection[int]
) -> list[CutPolygon[Look]]:
    """A plane or line reaches to the constructed points that lie in it, so that entities are seen to meet there."""
    pieces: list[CutPolygon[Look]] = []
    for i, e in enumerate(entities):
        corners = [points[name] for name in e.points]
        role = entity_role(i)
        if i in flat:
            pieces += [
                CutPolygon(hull, Look(role, fill=0.3, edge=0.9, width=1.6), edges) for hull, edges in outline(corners)
            ]
            pieces += [CutPolygon(pair, Look(role, width=1.2)) for pair in combinations(corners, 2)]
        elif e.kind == "tetrahedron" and len(corners) == 4:
            pieces += [CutPolygon(face, Look(role, fill=0.14, edge=0.75, width=1.2)) for face in tetrahedron(corners)]
        elif e.kind == "plane" and len(corners) == 3:
            polygon = patch(corners, 0.14, also=marks)
            pieces += [CutPolygon(polygon, Look(role, fill=0.2, edge=0.85, width=1.4))] if polygon else []
        elif e.kind == "line" and len(corners) == 2:
            pieces.append(CutPolygon(stretched(corners, 0.35, also=marks), Look(role, width=2.2, dash=(6, 4))))
    return pieces


def _constructed(lines: Sequence[tuple[XYZ, XYZ]], roles: Sequence[str]) -> list[CutPolygon[Look]]:
    """The parts of constructed lines inside a ball around the robot; a line that misses it is left out."""
    pieces = []
    for i, (start, end) in enumerate(lines):
        ends = through_ball(start, end, _ORIGIN, _BALL)
        if ends:
            pieces.append(CutPolygon(ends, Look(roles[i], width=2.8, dash=(10, 3), line=i)))
    return pieces


def _line_role(label: str, index: int) -> str:
    """What is marked in a pose, and so says what it is, has one colour; other lines continue those of the entities."""
    return "mark" if " " in label else entity_role(index)


def _constructed_entries(
    lines: Sequence[NamedLine],
    roles: Sequence[str],
    marks: Sequence[NamedPoint],
    pieces: Sequence[CutPolygon[Look]],
    near: Collection[str],
) -> list[LegendEntry]:
    """Legend entries, which say so where something lies outside the picture."""
    drawn = {p.tag.line for p in pieces}
    return [
        *((roles[i], _entry("line", label, i in drawn), "dashed") for i, (_, _, label) in enumerate(lines)),
        *(("mark", _entry("point", label, _last_word(label) in near), "dot") for _, label in marks),
    ]


def _entry(kind: str, label: str, drawn: bool) -> tuple[Run, ...]:
    words, _, name = label.rpartition(" ")
    return (Run(f"{words or kind} "), *name_runs(name), *([] if drawn else [Run(", outside")]))


def _last_word(label: str) -> str:
    return label.rpartition(" ")[2]


# --- onto the page -------------------------------------------------------------------------------------------------


def _rings(points: Mapping[str, XYZ], entities: Sequence[EntityLike], frame: Frame) -> list[Shape]:
    return [
        Circle(frame.place(points[name]), _JOINT + 5, "paper", entity_role(i), 2.0)
        for i, e in enumerate(entities)
        if e.kind == "point"
        for name in e.points
    ]


def _joint_labels(joints: Mapping[str, XYZ], platform: Sequence[str], frame: Frame) -> list[Label]:
    """Names of joints, rather outwards; those of the platform rather above, the others below."""
    at = {name: frame.place(p) for name, p in joints.items()}
    x0, y0 = sum(x for x, _ in at.values()) / len(at), sum(y for _, y in at.values()) / len(at)
    return [
        Label(name_runs(name), (x, y), (x - x0, y - y0 + (-40 if name in platform else 40)), _JOINT)
        for name, (x, y) in at.items()
    ]


def _line_labels(
    pieces: Sequence[CutPolygon[Look]], lines: Sequence[NamedLine], roles: Sequence[str], frame: Frame
) -> list[Label]:
    """Names of constructed lines, at their upper ends."""
    drawn = {p.tag.line: p.corners for p in pieces if p.tag.line is not None}
    labels = []
    for i, corners in drawn.items():
        a, b = sorted((frame.place(c) for c in corners), key=lambda p: p[1])
        labels.append(Label(name_runs(_last_word(lines[i][2])), a, (a[0] - b[0], a[1] - b[1]), 1.0, fill=roles[i]))
    return labels


def _key(left: float, top: float) -> list[Shape]:
    rows = (("platform joint", "paper"), ("base joint", "ink"))
    shapes: list[Shape] = []
    for i, (word, fill) in enumerate(rows):
        y = top + ROW * i + ROW / 2
        shapes.append(Circle((left + 9, y), _JOINT, fill, "ink", 1.6))
        shapes.append(Text((left + 26, y + 4.5), (Run(word),), 12, fill="muted"))
    return shapes
