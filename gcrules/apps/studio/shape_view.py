"""The dimensions of a robot as the page changes them: joints of base and platform, or what has a place at home."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Literal

from gcrules.apps.studio.protocol.study_views import ShapeGroup, ShapeRow, ShapeView
from gcrules.apps.studio.subject import Subject
from gcrules.mechanisms.robot import Robot

__all__ = ["shape_view"]

_SORTS: tuple[tuple[str, Literal["point", "direction"]], ...] = (("Points", "point"), ("Directions", "direction"))


def shape_view(subject: Subject) -> ShapeView:
    """Of six legs all joints; of a robot of joints its points and directions, without a place where relations determine
    it or the file has none.
    """
    if subject.robot is not None:
        return _of_joints(subject, subject.robot.robot)
    bodies, structure = subject.mechanism.bodies, subject.structure
    groups: list[ShapeGroup] = [
        {
            "title": title,
            "sort": "point",
            "axes": ["x", "y", "z"],
            "rows": [{"name": n, "at": [float(c) for c in subject.points[n]]} for n in bodies[body]],
        }
        for title, body in (("Base", "base"), ("Platform", "platform"))
    ]
    legs = structure.joined if structure else ()
    return {"groups": groups, "bars": [list(leg) for leg in legs if set(leg) <= set(subject.points)]}


def _of_joints(subject: Subject, robot: Robot) -> ShapeView:
    placed = robot.home is not None and robot.limbs
    free = {d.name for d in robot.family.definitions if d.parameters and placed}
    axes = ["x", "y"] if robot.family.plane else ["x", "y", "z"]
    groups: list[ShapeGroup] = []
    for title, sort in _SORTS:
        names = [d.name for d in robot.family.definitions if d.sort == sort]
        rows: list[ShapeRow] = [{"name": n, "at": subject.home[n] if n in free else None} for n in names]
        if rows:
            groups.append({"title": title, "sort": sort, "axes": axes, "rows": rows})
    return {"groups": groups, "bars": [list(bar) for bar in dict.fromkeys(_bars(robot))]}


def _bars(robot: Robot) -> Iterator[tuple[str, str]]:
    """From each joint of a limb to the next one."""
    for limb in robot.limbs:
        for way in limb.ways():
            yield from pairwise(dict.fromkeys(n for joint in way for n in joint.points))
