r"""The legend below the drawing of a robot: limbs, signs of joints, wrenches, planes, and what is marked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gcrules.poses.limbs.meeting import meeting
from gcrules.poses.limbs.singular_members import SingularPose
from gcrules.screws import JOINTS
from gcrules.views.drawing.bsp import XYZ
from gcrules.views.drawing.drawing import Circle, Polygon, Run, Shape, Stroke, Text, mapped, name_runs, text_width
from gcrules.views.drawing.frame import Frame
from gcrules.views.drawing.viewpoint import View
from gcrules.views.robots.drawn_limb import DrawnJoint
from gcrules.views.robots.entities import DrawnFlat
from gcrules.views.robots.lines import DrawnMotion, entity_role_of
from gcrules.views.robots.picture import CONSTRAINT_DASH
from gcrules.views.robots.scene import Scene
from gcrules.views.robots.symbols import arrow, couple, sign

__all__ = ["SAMPLE", "SIZE", "Entry", "entry_rows", "entry_width", "robot_legend"]

SAMPLE = 30.0
"""The room for a sample, in points."""
SIZE = 12.5
"""The size of the words, in points."""

_ITEM_GAP = 16.0

Entry = tuple[list[Shape], tuple[Run, ...]]
"""A sample around the origin, and its words."""


def entry_width(entry: Entry) -> float:
    return SAMPLE + 4 + text_width(Text((0, 0), entry[1], SIZE)) + _ITEM_GAP


def entry_rows(entries: Iterable[Entry], width: float) -> list[list[Entry]]:
    rows: list[list[Entry]] = [[]]
    for entry in entries:
        if rows[-1] and sum(map(entry_width, [*rows[-1], entry])) > width:
            rows.append([])
        rows[-1].append(entry)
    return [row for row in rows if row]


_FLAT = Frame(View.at(-62, 22), 1.0, (0.0, 0.0), 0.8)
_SMALL = Frame(View.at(-62, 22), 1.0, (0.0, 0.0), 0.58)
_X, _Z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def _sample(kind: str) -> DrawnJoint:
    """A joint by itself, its directions along x and z; a plate lies level."""
    directions = [form for form in JOINTS[kind].parts.values() if form == "direction"]
    return DrawnJoint(kind, (0.0, 0.0, 0.0), (_Z,) if kind == "E" else (_X, _Z)[: len(directions)])


def robot_legend(
    s: Scene,
    shown: Sequence[DrawnFlat],
    pose: SingularPose | None,
    marks: Sequence[tuple[str, XYZ]] = (),
    motion: DrawnMotion | None = None,
) -> list[Entry]:
    entries: list[Entry] = []
    cables = {limb.name for limb in s.a.robot.limbs if limb.cable}
    for limb, role in s.roles.items():
        entries.append(([Stroke((-12, 0), (12, 0), role, 1.5 if limb in cables else 4.4)], (Run(limb),)))
    if pose is None:
        rigid = [limb for limb in s.a.robot.limbs if not limb.cable]
        kinds = dict.fromkeys(j.kind for limb in rigid for j in limb.joints if not JOINTS[j.kind].has_bars)
        for kind in kinds:
            sample = sign(_sample(kind), _SMALL if kind in ("C", "H", "E") else _FLAT, "muted")
            entries.append((sample, (Run(JOINTS[kind].name),)))
        if rigid:
            driven = DrawnJoint("P", (0.0, 0.0, 0.0), ((1.0, 0.0, 0.0),), True)
            entries.append((sign(driven, _FLAT, "ink"), (Run("driven"),)))
    wrenches = [line for limb in s.a.structure.limbs for line in limb.lines or ()]
    if any(not w.couple for w in wrenches):
        entries.append((arrow((-13, 0), (13, 0), "ink", 2.6), (Run("force"),)))
    if any(w.couple for w in wrenches):
        entries.append(
            (
                [mapped(one, 0.8, (-8.0, 0.0)) for one in couple(_FLAT, (0, 0, 0), (1.0, 0.0, 0.0), "ink")],
                (Run("couple"),),
            )
        )
    if any(w.role == "constraint" for w in wrenches):
        entries.append((arrow((-13, 0), (13, 0), "ink", 2.6, CONSTRAINT_DASH), (Run("constraint"),)))
    for e in shown:
        role = "mark" if pose and e.kind == "tetrahedron" else entity_role_of(s, e)
        corners = ((-10.0, -6.0), (10.0, -6.0), (10.0, 6.0), (-10.0, 6.0))
        flat = [Run(", flat")] if pose and e.kind == "tetrahedron" else []
        entries.append(
            (
                [Polygon(corners, role, role, fill_opacity=0.3, width=1.3)],
                (Run(f"{e.kind} "), *name_runs(*e.points), *flat),
            )
        )
    for name, _ in marks:
        entries.append(([Circle((0, 0), 5.0, "mark", "paper", 1.4)], (Run("common point "), *name_runs(name))))
    met = meeting(s.a, pose.part, pose.values) if pose else None
    if met and met[1]:
        entries.append(([Circle((0, 0), 5.0, "mark", "paper", 1.4)], (Run("common point at infinity"),)))
    if motion:
        kind = "shift" if motion.pitch is None else "turn" if not motion.pitch else "screw motion"
        entries.append((arrow((-13, 0), (13, 0), "mark", 2.6), (Run(f"{kind} that the platform gains"),)))
    return entries
