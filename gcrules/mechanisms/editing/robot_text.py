r"""Robot files with other dimensions: a text changes where points and directions are at home, and nowhere else.

>>> from gcrules.mechanisms.editing.sheet import FIRST
>>> file = FIRST[True].replace("mobility: 3", "mobility: 3 # as one limb has")
>>> [line for line in home_changed(file, "robot.yaml", {"B1": ("1", "", "")}).splitlines() if "B1: [" in line]
['  B1: [1, 1]']
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.description.robot_file import parse_draft
from gcrules.mechanisms.editing.home import fitted, size_of
from gcrules.mechanisms.editing.name_edits import put_home
from gcrules.mechanisms.editing.reading import PlacedSheet, read_sheet
from gcrules.mechanisms.editing.sheet import Sheet
from gcrules.mechanisms.editing.writing import rewritten
from gcrules.mechanisms.robot import Robot

__all__ = ["home_changed", "refitted"]


def home_changed(text: str, filename: str, places: Mapping[str, Sequence[str]], limits: str | None = None) -> str:
    """The text of a robot file in which points and directions have other coordinates at home, as they are written (""
    keeps one), and actuators other `limits` ("" for none, None keeps them). What no longer satisfies its relation is
    moved to the nearest place that does.

    Raises InputError for a name that has no place of its own, FileError for a file without limbs.
    """
    placed = read_sheet(text, filename)
    sheet = placed.sheet
    for name, written in places.items():
        if name not in sheet.home:
            raise InputError(f"{name[:20]!r} has no place of its own at home", hint=near(name, sheet.home))
        old = sheet.home[name]
        sheet = put_home(
            sheet, name, [new or kept or "0" for new, kept in zip(written, old, strict=True)], follow=False
        )
    if limits is not None:
        others = {key: value for key, value in sheet.others.items() if key != "limits"}
        sheet = replace(sheet, others=FrozenMap({**others, "limits": limits} if limits else others))
    return rewritten(text, placed, refitted(text, placed, sheet)[0])


def refitted(text: str, placed: PlacedSheet, sheet: Sheet) -> tuple[Sheet, Robot | None]:
    """A sheet that was changed from the `placed` one of this text, with home, and its configuration for drawings, where
    the relations allow them, and its robot if there is one yet. Where names of a drawing are gone, or the number of
    copies is another one, there is no drawing any more.
    """
    if not sheet.drawing.keys() <= sheet.every_name or sheet.copies not in (0, placed.sheet.copies):
        sheet = replace(sheet, drawing=FrozenMap())
    robot = parse_draft(rewritten(text, placed, sheet)).robot
    if robot is not None and sheet.home:
        sheet = replace(sheet, home=fitted(robot, sheet.home, size_of(sheet)))
        found = fitted(robot, {**sheet.home, **sheet.drawing}, size_of(sheet)) if sheet.drawing else {}
        sheet = replace(sheet, drawing=FrozenMap((n, at) for n, at in found.items() if n in sheet.drawing))
    return sheet, robot
