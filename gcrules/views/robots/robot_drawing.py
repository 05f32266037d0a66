r"""A robot and its equivalent structure side by side, at home or in a singular configuration, with a legend."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import dist

from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.poses.limbs.exact_values import Values
from gcrules.poses.limbs.meeting import meeting
from gcrules.poses.limbs.singular_members import SingularPose, live_parts
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.drawing.drawing import Drawing, Run, Shape, Stroke, Text, mapped, scaled, without_text
from gcrules.views.drawing.figures import free_name
from gcrules.views.drawing.solids import flat_normal
from gcrules.views.robots.drawn_limb import plus, unit_vector
from gcrules.views.robots.entities import DrawnFlat, common_normal, entities, far_directions
from gcrules.views.robots.infinity_view import SKY, infinity_shapes
from gcrules.views.robots.legend import SAMPLE, SIZE, Entry, entry_rows, entry_width, robot_legend
from gcrules.views.robots.lines import (
    DrawnMotion,
    far,
    motion_extent,
    motion_shapes,
    places_of,
    structure_extent,
    structure_shapes,
)
from gcrules.views.robots.picture import robot_shapes
from gcrules.views.robots.scene import HEIGHT, WIDTH, Scene, scene

__all__ = ["draw_parts", "draw_robot", "draw_singular", "motion_of", "robot_thumbnail"]

_ROW = 22.0
_REACH = 2.0  # how far from the middle of the robot something is drawn, in its radii
_NAMES = "MNXYZ"
_CHOSEN = ", in a configuration chosen for drawings"


def draw_robot(a: RobotAnalysis, values: Values | None = None) -> Drawing:
    """The robot with its wrenches, and beside it the lines that stand for them, in one configuration; by default in
    that of its file for drawings, or else at home.
    """
    chosen = a.robot.drawing is not None and values is None
    values = a.robot.values_at(a.robot.drawing) if values is None else values
    s, shown = _in_configuration(a, values)
    right = structure_shapes(s, shown) if a.structure.lines else []
    return _beside(
        robot_shapes(s),
        right,
        _sky(s, None) if right else [],
        robot_legend(s, shown, None),
        f"{a.robot.title} with its joints and wrenches, and its equivalent structure{_CHOSEN if chosen else ''}",
        f"the robot{_CHOSEN if chosen else ''}",
    )


def draw_parts(a: RobotAnalysis, values: Values) -> tuple[Drawing, ...]:
    """The same as figures of their own, each as narrow as a column: the robot, then the lines, if there are such, with
    what lies at infinity and the legend below them.
    """
    s, shown = _in_configuration(a, values)
    entries = robot_legend(s, shown, None)
    robot, title = robot_shapes(s), f"{a.robot.title} with its joints and wrenches"
    if not a.structure.lines:
        return (Drawing(WIDTH, HEIGHT + _legend_height(entries, WIDTH), (*robot, *_legend(entries, WIDTH)), title),)
    lines = structure_shapes(s, shown)
    sky = [mapped(one, 1.0, (-2 * WIDTH + (WIDTH - SKY) / 2, (HEIGHT + SKY) / 2)) for one in _sky(s, None)]
    legend = _legend(entries, WIDTH)
    below = SKY + 8 if sky else 0.0
    shapes = (*lines, *sky, *(mapped(one, 1.0, (0.0, below)) for one in legend))
    height = HEIGHT + below + _legend_height(entries, WIDTH)
    return Drawing(WIDTH, HEIGHT, tuple(robot), title), Drawing(WIDTH, height, shapes, "its equivalent structure")


def _in_configuration(a: RobotAnalysis, values: Values) -> tuple[Scene, Sequence[DrawnFlat]]:
    """The scene, and the flats of the condition."""
    shown = entities(a, live_parts(a)) if a.lines else ()
    s = scene(a, values, _normals(a, shown, values))
    return s.holding(structure_extent(s, shown)), shown


def draw_singular(a: RobotAnalysis, pose: SingularPose) -> Drawing:
    """The same in a singular configuration, with what makes it singular, and the motion that the platform gains."""
    values = _as_long(a, pose.values)
    shown = entities(a, (pose.part,))
    met = meeting(a, pose.part, values)
    inside = met is not None and not met[1]
    s = scene(a, values, _normals(a, shown, values))
    marks = []
    if met and inside and dist(s.unit.place(met[0]), (0, 0, 0)) <= _REACH:
        marks = [(free_name(_NAMES, s.points), s.unit.place(met[0]))]
    motion = motion_of(s, pose)
    moving = motion_extent(motion) if motion else []
    s = s.holding([*structure_extent(s, shown, marks), *(p for _, p in marks), *moving])
    over = motion_shapes(s.frame, motion, places_of(s)) if motion else []
    right = structure_shapes(s, shown, marks, motion)
    title = f"{a.robot.title} in a singular configuration"
    return _beside(robot_shapes(s, over), right, _sky(s, pose), robot_legend(s, shown, pose, marks, motion), title)


def _as_long(a: RobotAnalysis, values: Values) -> Values:
    """Directions about as long as at home: their lengths say nothing, but bars are drawn by them."""
    found = dict(values)
    for d in (d for d in a.robot.family.definitions if d.sort == "direction"):
        home = (a.robot.home or {}).get(d.name)
        if home is None or not any(home):
            continue
        long, now = (sum(float(c) ** 2 for c in v) ** 0.5 for v in (home, values[d.name]))
        factor = Fraction(long / now).limit_denominator(1000)
        x, y, z = (c * factor for c in values[d.name])
        found[d.name] = x, y, z
    return found


def robot_thumbnail(a: RobotAnalysis, values: Values | None = None) -> Drawing:
    """The robot alone, small and without words; by default in the configuration of its file for drawings, or else at
    home.
    """
    s = scene(a, a.robot.values_at(a.robot.drawing) if values is None else values)
    drawn = Drawing(WIDTH, HEIGHT, tuple(robot_shapes(s, words=False)), a.robot.title)
    return scaled(without_text(drawn), 0.42)


def motion_of(s: Scene, pose: SingularPose) -> DrawnMotion | None:
    """The motion that the platform gains, where it is drawn; a turn about a far axis as the shift of the platform."""
    if pose.motion is None:
        return None
    w, v = ((float(x), float(y), float(z)) for x, y, z in (pose.motion[:3], pose.motion[3:]))
    square = dot(w, w)
    heart = s.heart
    if square < 1e-18:
        return DrawnMotion(heart, v, None)
    foot = cross(w, v)
    at = s.unit.place((foot[0] / square, foot[1] / square, foot[2] / square))
    u = unit_vector(w)
    at = plus(at, u, dot(u, (heart[0] - at[0], heart[1] - at[1], heart[2] - at[2])))
    pitch = dot(w, v) / square / s.unit.radius
    if dist(at, (0, 0, 0)) > _REACH:
        away = (heart[0] - at[0], heart[1] - at[1], heart[2] - at[2])
        return DrawnMotion(heart, plus(cross(u, away), u, pitch), None)
    return DrawnMotion(at, w, round(pitch, 9))


def _normals(a: RobotAnalysis, shown: Sequence[DrawnFlat], values: Values) -> list[XYZ]:
    found = []
    for e in shown:
        finite = [values[n] for n in e.points if n in values and a.robot.family.sorts.get(n) == "point"]
        far_ends = [values[n] for n in e.points if n in values and a.robot.family.sorts.get(n) == "direction"]
        corners = [(float(x), float(y), float(z)) for x, y, z in finite]
        corners += [plus(corners[0], (float(x), float(y), float(z))) for x, y, z in far_ends if corners]
        normal = flat_normal(corners) if len(corners) == 3 else None
        found += [normal] if normal else []
    return found


def _sky(s: Scene, pose: SingularPose | None) -> list[Shape]:
    """The picture of what lies at infinity, in a column of its own; nothing where nothing does."""
    seen = far(s)
    if pose:
        named, circles = far_directions(s.a, pose.part, pose.values)
        marks: list[XYZ] = []
        met = meeting(s.a, pose.part, pose.values)
        if met and met[1]:
            marks.append(unit_vector(met[0]))
        elif seen.lines and not named and len(seen.lines) > 2:
            common = common_normal([cross(u, v) for u, v, _ in seen.lines])
            marks += [common] if common else []
        seen = replace(seen, points={**seen.points, **named}, circles=circles, marks=marks)
    if not (seen.points or seen.lines or seen.marks):
        return []
    return infinity_shapes(seen, s.frame.view, 2 * WIDTH, (HEIGHT - SKY) / 2)


# --- the page ------------------------------------------------------------------------------------------------------


def _beside(
    left: Sequence[Shape],
    right: Sequence[Shape],
    sky: Sequence[Shape],
    entries: Sequence[Entry],
    title: str,
    heading: str = "the robot",
) -> Drawing:
    halves = (heading, "its equivalent structure") if right else (heading,)
    width = len(halves) * WIDTH + (SKY + 8 if sky else 0)
    shapes: list[Shape] = [*left, *(mapped(one, 1.0, (WIDTH, 0.0)) for one in right), *sky]
    shapes += [Stroke((WIDTH, 30), (WIDTH, HEIGHT - 20), "muted", 0.8, opacity=0.5)] if right else []
    shapes += [Text(((k + 0.5) * WIDTH, 18), (Run(words),), 14, "middle", "muted") for k, words in enumerate(halves)]
    shapes += _legend(entries, width)
    return Drawing(width, HEIGHT + _legend_height(entries, width), tuple(shapes), title)


def _legend(entries: Sequence[Entry], width: float) -> list[Shape]:
    """The legend below a picture."""
    shapes: list[Shape] = []
    for k, row in enumerate(entry_rows(entries, width - 24)):
        x = 12.0
        for entry in row:
            y = HEIGHT + 8 + _ROW * k + _ROW / 2
            shapes += [mapped(one, 1.0, (x + SAMPLE / 2, y)) for one in entry[0]]
            shapes.append(Text((x + SAMPLE + 4, y + 4.2), entry[1], SIZE))
            x += entry_width(entry)
    return shapes


def _legend_height(entries: Sequence[Entry], width: float) -> float:
    return 16 + _ROW * len(entry_rows(entries, width - 24))
