"""The limb editor: the text of a robot file as a table, changed row by row, with all that can be told of it at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.limb_rows import KINDS, sheet_view
from gcrules.apps.studio.limb_scene import home_scene, outline
from gcrules.apps.studio.protocol.limb_requests import SheetEdit
from gcrules.apps.studio.protocol.limb_views import LimbsAnswer, LimbSheet, MobilityView
from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.subject import robot_of
from gcrules.core.english import counted
from gcrules.core.errors import FileError, GcrulesError
from gcrules.mechanisms.description.robot_file import parse_draft
from gcrules.mechanisms.editing.edits import Edit, edited
from gcrules.mechanisms.editing.reading import Path, PlacedSheet, read_sheet
from gcrules.mechanisms.editing.robot_text import refitted
from gcrules.mechanisms.editing.sheet import FIRST
from gcrules.mechanisms.editing.writing import rewritten
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.screws.pose import UNITS

__all__ = ["limbs_answer"]

_FILE = "robot.yaml"


def limbs_answer(
    text: str | None, start: SourceJson | None = None, edit: SheetEdit | None = None, *, plane: bool = False
) -> LimbsAnswer:
    """What a text says as a table, after a change. Raises GcrulesError for a change that cannot be."""
    if text is None:
        text = robot_of(start).text if start is not None else FIRST[plane]
    if edit is not None:
        text = _changed(text, edit)
    draft = parse_draft(text, _FILE)
    structure = outline(draft.robot)
    sheet: LimbSheet | None = None
    others: list[FaultView] = []
    of_mobility: list[FaultView] = []
    faults: Sequence[GcrulesError] = draft.faults
    try:
        placed = read_sheet(text, _FILE)
    except FileError as fault:
        faults = faults or (fault,)
    else:
        rows = _by_row(placed, faults)
        sheet = sheet_view(placed.sheet, draft.robot, structure, rows)
        of_mobility = rows.pop(("mobility",), [])
        others = [view for views in rows.values() for view in views]  # of rows that the table has not
    views = [fault_view(fault) for fault in faults]
    return {
        "text": text,
        "sheet": sheet,
        "faults": others,
        "every": {**views[0], "more": views[1:]} if views else None,
        "mobility": {**_mobility(draft.robot, structure), "faults": of_mobility},
        "scene": home_scene(draft.robot, structure),
        "kinds": KINDS,
        "units": list(UNITS),
    }


def _changed(text: str, edit: SheetEdit) -> str:
    """The text after a change: with home where the relations allow it, and the mobility that the joints give."""
    placed = read_sheet(text, _FILE)
    sheet = edited(placed.sheet, Edit(**edit))
    sheet, robot = refitted(text, placed, sheet)
    structure = outline(robot)
    if structure is not None and edit["do"] != "mobility":
        sheet = replace(sheet, mobility=str(structure.mobility))
    return rewritten(text, placed, sheet)


def _by_row(placed: PlacedSheet, faults: Sequence[GcrulesError]) -> dict[Path, list[FaultView]]:
    """The faults of each row; those of home and of the drawing are of the row of the name."""
    rows: dict[Path, list[FaultView]] = {}
    for fault in faults:
        path = placed.row_at(fault) or ()
        row = placed.sheet.row(str(path[1])) if len(path) == 2 and path[0] in ("home", "drawing", "name") else None
        rows.setdefault(("name", row.name) if row else path, []).append(fault_view(fault))
    return rows


# --- mobility ------------------------------------------------------------------------------------------------------


def _mobility(robot: Robot | None, structure: Equivalent | None) -> MobilityView:
    drives = sum(limb.actuators for limb in robot.limbs) if robot else 0
    written = str(robot.mobility) if robot else ""
    if structure is None or robot is None:
        return {"number": None, "written": written, "drives": drives, "sentence": "", "faults": []}
    n = structure.mobility
    words = [_of_drives(n, drives)]
    if drives >= n and structure.rank < (3 if robot.family.plane else 6):
        words.append("With all of them locked it can still move, in every configuration.")
    if structure.overconstraints:
        words.append(f"Over-constrained: {counted(structure.overconstraints, 'constraint')} more than needed.")
    if structure.idle:
        words.append(f"{counted(structure.idle, 'freedom')} inside the limbs leave the platform at rest.")
    return {"number": n, "written": written, "drives": drives, "sentence": " ".join(words), "faults": []}


def _of_drives(freedoms: int, drives: int) -> str:
    if not freedoms:
        return f"The limbs hold the platform{', and nothing is driven' * (not drives)}."
    head = f"The platform has {counted(freedoms, 'freedom')}"
    driven = f"{counted(drives, 'joint freedom')} {'is' if drives == 1 else 'are'} driven"
    if drives == freedoms:
        return f"{head}, and as many joint freedoms are driven."
    if drives < freedoms:  # what a fault of the file says
        return f"{head}."
    return f"{head}, and {driven}: more than it needs."
