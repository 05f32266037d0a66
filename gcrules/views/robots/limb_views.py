r"""Limbs of a robot as plain data for a 3D view: joints and wrenches in space, in any configuration."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.language.legs_text import leg_text
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.limb_file import JointSpec, LimbSpec, Subchain
from gcrules.mechanisms.description.relations import Term
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.mechanisms.lines.equivalent import FRAME
from gcrules.mechanisms.lines.wrenches import LimbWrenches, WrenchLine
from gcrules.screws import FLOATS, JOINTS
from gcrules.views.scene_data import JointView, LimbView, LineView, Vec3

__all__ = [
    "Values",
    "all_places",
    "derived_points",
    "directions",
    "drawn_parts",
    "limb_views",
    "unit_directions",
    "wrench_words",
]

Floats = NDArray[np.float64]
Values = Mapping[str, Sequence[float] | Floats]
"""Coordinates of all points and directions of a robot."""

ROUNDING = 1e-12
"""A point whose last coordinate is so small beside the others is at infinity."""


def limb_views(robot: RobotAnalysis, values: Values) -> list[LimbView]:
    """The limbs in a configuration; lines that only all limbs together hold stand in one more, of the frame."""
    places, ideal = all_places(robot, values), directions(robot)
    lines = robot.structure.drawn
    views: list[LimbView] = [
        {
            "name": limb.limb.name,
            "colour": i,
            "wrenches": wrench_words(limb) if last else [],
            "joints": [_joint(j, places) for j in joints],
            "lines": [_line(one, places, ideal) for one in lines if last and one.limb == limb.limb.name],
        }
        for i, limb in enumerate(robot.structure.limbs)
        for _, _, joints, last in drawn_parts([limb.limb])
    ]
    own = {view["name"] for view in views}
    rest = [_line(one, places, ideal) for one in lines if one.limb not in own]
    if rest:
        words = [line["text"] for line in rest]
        views.append({"name": FRAME, "colour": len(views), "wrenches": words, "joints": [], "lines": rest})
    return views


def drawn_parts(
    limbs: Sequence[LimbSpec],
) -> Iterator[tuple[LimbSpec, Subchain, tuple[JointSpec, ...], bool]]:
    """What is drawn one by one: each limb or, of one that has bodies of its own, each of its chains, with its joints;
    and whether it is the last one of its limb, with which the limb's wrenches are drawn.
    """
    for limb in limbs:
        for n, (part, joints) in enumerate(limb.parts, 1):
            yield limb, part, joints, n == len(limb.parts)


def all_places(robot: RobotAnalysis, values: Values) -> dict[str, Floats]:
    """Coordinates of all points and directions, those that the equivalent lines derive among them."""
    places = {n: np.asarray(v, dtype=np.float64) for n, v in values.items()}
    rows = with_derived(robot.structure.derived, {n: FLOATS.vector(v) for n, v in places.items()}, FLOATS)
    return places | {n: np.array(row[:3]) / (row[3] or 1.0) for n, row in rows.items()}


def directions(robot: RobotAnalysis) -> set[str]:
    """The names that are directions."""
    own = {n for n, sort in robot.robot.family.sorts.items() if sort == "direction"}
    return own | {d.name for d in robot.structure.derived if not d.is_point}


def unit_directions(robot: RobotAnalysis, values: Values) -> dict[str, Vec3]:
    """Unit vectors of all directions in a configuration; those that are no direction there are left out."""
    places = all_places(robot, values)
    sizes = {n: float(np.linalg.norm(places[n])) for n in sorted(directions(robot)) if n in places}
    return {n: [float(c) / size for c in places[n]] for n, size in sizes.items() if size > 0}


def derived_points(robot: RobotAnalysis, values: Values) -> dict[str, Vec3]:
    """The finite points that the equivalent lines derive, through which entities may go, in a configuration."""
    own = {n: FLOATS.vector(v) for n, v in values.items()}
    rows = {n: np.asarray(row, float) for n, row in with_derived(robot.structure.derived, own, FLOATS).items()}
    points = {d.name: rows[d.name] for d in robot.structure.derived if d.is_point}
    return {n: _vec(p[:3] / p[3]) for n, p in points.items() if abs(p[3]) > ROUNDING * float(np.linalg.norm(p))}


def _sum(term: Term, places: Mapping[str, Floats]) -> Floats:
    found: Floats = sum((float(c) * places[n] for c, n in term), np.zeros(3))
    return found


def _joint(joint: JointSpec, places: Mapping[str, Floats]) -> JointView:
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


def _line(line: WrenchLine, places: Mapping[str, Floats], ideal: set[str]) -> LineView:
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


def wrench_words(one: LimbWrenches) -> list[str]:
    """What the limb applies with its actuators locked."""
    if one.lines is None:
        return [f"{one.kind}; no lines that can be named span it"]
    return [_wrench(line) for line in one.lines]


def _wrench(line: WrenchLine) -> str:
    what = "couple" if line.couple else "force"
    return f"{what} {leg_text(line.ends)}{' (constraint)' if line.role == 'constraint' else ''}"
