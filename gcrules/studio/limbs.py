"""Robots with limbs: their joints and wrenches in space, and the two steps that lead to the equivalent lines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.expr import Expr
from gcrules.algebra.text import text
from gcrules.legs import leg_text
from gcrules.render.drawing import Drawing
from gcrules.render.latex import latex
from gcrules.render.robot_drawing import draw_robot
from gcrules.robots.equivalent import FRAME
from gcrules.robots.limbs import JointText
from gcrules.robots.parts import KINDS, Part
from gcrules.robots.relations import Term
from gcrules.robots.robot_analysis import RobotAnalysis
from gcrules.robots.wrenches import LimbWrenches, Line
from gcrules.screws import JOINTS
from gcrules.studio.items import fact, formula, said
from gcrules.studio.views import Item, JointView, LimbView, LineView, RobotView, Vec3

__all__ = [
    "Values",
    "all_places",
    "directions",
    "limb_stages",
    "limb_views",
    "part_items",
    "robot_drawing",
    "robot_view",
]

Floats = NDArray[np.float64]
Values = Mapping[str, Sequence[float] | Floats]
"""Coordinates of all points and directions of a robot."""


def robot_view(robot: RobotAnalysis, home: Values) -> RobotView:
    """What does not change with the configuration, with the limbs at home."""
    found: RobotView = {
        "mobility": robot.structure.mobility if robot.structure.limbs else robot.robot.mobility,
        "limbs": limb_views(robot, home),
        "parts": [
            {"text": _words(p.expression, robot), "tex": latex(p.expression), "kind": p.kind, "statement": _told(p)}
            for p in robot.parts
        ],
    }
    if robot.structure.limbs:
        found["figure"] = robot_drawing(robot, home).svg()
    return found


def robot_drawing(robot: RobotAnalysis, values: Values) -> Drawing:
    """The robot with its wrenches beside the lines that stand for them."""
    exact = {n: (Fraction(x), Fraction(y), Fraction(z)) for n, (x, y, z) in values.items()}
    return draw_robot(robot, exact)


def _words(e: Expr, robot: RobotAnalysis) -> str:
    return text(e, unicode=True, names=robot.lines.structure.names if robot.lines else ())


def _told(part: Part) -> str:
    return part.statement or part.reason or KINDS[part.kind]


# --- in space ------------------------------------------------------------------------------------------------------


def limb_views(robot: RobotAnalysis, values: Values) -> list[LimbView]:
    """The limbs in a configuration; lines that only all limbs together hold stand in one more, of the frame."""
    places, ideal = all_places(robot, values), directions(robot)
    lines = robot.structure.lines or ()
    views: list[LimbView] = [
        {
            "name": limb.limb.name,
            "colour": i,
            "wrenches": _wrenches(limb),
            "joints": [_joint(j, places) for j in limb.limb.joints],
            "lines": [_line(one, places, ideal) for one in lines if one.limb == limb.limb.name],
        }
        for i, limb in enumerate(robot.structure.limbs)
    ]
    own = {view["name"] for view in views}
    rest = [_line(one, places, ideal) for one in lines if one.limb not in own]
    if rest:
        words = [line["text"] for line in rest]
        views.append({"name": FRAME, "colour": len(views), "wrenches": words, "joints": [], "lines": rest})
    return views


def all_places(robot: RobotAnalysis, values: Values) -> dict[str, Floats]:
    """Coordinates of all points and directions, those that the equivalent lines derive among them."""
    places = {n: np.asarray(v, dtype=np.float64) for n, v in values.items()}
    for name, u, v in robot.structure.derived:
        places[name] = np.cross(_sum(u, places), _sum(v, places))
    return places


def directions(robot: RobotAnalysis) -> set[str]:
    """The names that are directions."""
    own = {n for n, sort in robot.robot.family.sorts.items() if sort == "direction"}
    return own | {n for n, _, _ in robot.structure.derived}


def _sum(term: Term, places: Mapping[str, Floats]) -> Floats:
    found: Floats = sum((float(c) * places[n] for c, n in term), np.zeros(3))
    return found


def _joint(joint: JointText, places: Mapping[str, Floats]) -> JointView:
    forms = JOINTS[joint.kind].parts.values()
    given = [(form, _sum(arg, places)) for form, arg in zip(forms, joint.args, strict=True) if isinstance(arg, tuple)]
    points = [v for form, v in given if form == "point"]
    if not points and len(joint.names) == 2 and joint.kind == "P":  # between two points, and drawn there
        points = [places[n] for n in joint.names]
    return {
        "kind": joint.kind,
        "actuated": bool(joint.actuated),
        "point": _vec(sum(points, np.zeros(3)) / len(points)) if points else None,
        "axes": [_vec(_unit(v)) for form, v in given if form == "direction"],
    }


def _line(line: Line, places: Mapping[str, Floats], ideal: set[str]) -> LineView:
    """A force with a point of its line, or a couple, whose direction is normal to the two directions of its line."""
    finite = [n for n in line.ends if n not in ideal]
    a, b = (places[n] for n in line.ends)
    wrench: Literal["force", "couple"] = "force" if finite else "couple"
    if len(finite) == 2:
        direction = b - a
    elif finite:
        direction = b if finite[0] == line.ends[0] else a
    else:
        direction = np.cross(a, b)
    return {
        "text": leg_text(line.ends),
        "wrench": wrench,
        "point": _vec(places[finite[0]]) if finite else None,
        "direction": _vec(_unit(direction)),
    }


def _unit(v: Floats) -> Floats:
    size = float(np.linalg.norm(v))
    found: Floats = v / size if size else v
    return found


def _vec(v: Floats) -> Vec3:
    return [float(c) for c in v]


# --- the first two steps -------------------------------------------------------------------------------------------


def limb_stages(robot: RobotAnalysis) -> Iterator[tuple[str, list[Item]]]:
    """The limbs with their wrenches, then the lines that stand for them."""
    s = robot.structure
    if not s.limbs:
        return
    numbers = [
        fact("limbs", robot.robot.chain),
        fact("mobility of the platform", str(s.mobility)),
        *([fact("overconstraints", str(s.over))] if s.over else []),
        *([fact("idle freedoms", str(s.idle))] if s.idle else []),
    ]
    words: list[Item] = [fact(f"{one.limb.name}, {one.limb.chain}", one.kind) for one in s.limbs]
    serial: list[Item] = [
        said(f"{one.limb} by itself is singular where {sentence}.")
        for one in robot.limbs
        for _, sentence in one.conditions
    ]
    yield "limbs", [*numbers, *words, *serial]
    yield "equivalent", list(_equivalent(robot))


def _wrenches(one: LimbWrenches) -> list[str]:
    if one.lines is None:
        return [f"{one.kind}; no lines through the robot's points span it"]
    return [_wrench(line) for line in one.lines]


def _wrench(line: Line) -> str:
    what = "couple" if line.couple else "force"
    return f"{what} {leg_text(line.ends)}{' (constraint)' if line.role == 'constraint' else ''}"


def _of(limb: str) -> str:
    return "all limbs together" if limb == FRAME else limb


def _equivalent(robot: RobotAnalysis) -> Iterator[Item]:
    s = robot.structure
    if s.lines is None:
        yield said(robot.statement)
        return
    for line in s.lines:
        role = "constraint " if line.role == "constraint" else ""
        yield fact(leg_text(line.ends), f"{role}{'couple' if line.couple else 'force'} of {_of(line.limb)}")
    if s.ideal:
        yield fact("at infinity", ", ".join(s.ideal))
    for name, what in s.named:
        yield fact(name, f"the direction {what}")
    if s.incidences:
        yield fact("known of the points", ", ".join(s.incidences))


def part_items(robot: RobotAnalysis) -> Iterator[Item]:
    """The factors of the condition, each with what it means for this robot."""
    if not robot.parts:
        return
    yield said("Its factors, told apart by the ranks of the joint screws at exact singular members of the family:")
    for part in robot.parts:
        yield formula(None, part.expression)
        yield fact(part.kind, _told(part))
