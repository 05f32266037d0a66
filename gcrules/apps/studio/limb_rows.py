"""The rows of the limb editor's table, each with its faults and with what is known of it."""

from __future__ import annotations

from gcrules.algebra.language.legs_text import leg_text
from gcrules.apps.studio.protocol.limb_views import (
    ChainRow,
    DriveKind,
    JointKindView,
    JointRow,
    LimbRow,
    LimbSheet,
    NameRow,
    Undefined,
    WrenchRow,
)
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.editing.home import evenly_turned
from gcrules.mechanisms.editing.naming import forms_of
from gcrules.mechanisms.editing.reading import Path
from gcrules.mechanisms.editing.sheet import JointRow as WrittenJoint
from gcrules.mechanisms.editing.sheet import LimbRow as WrittenLimb
from gcrules.mechanisms.editing.sheet import Sheet
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.wrenches import LimbWrenches
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS

__all__ = ["KINDS", "sheet_view"]

Faults = dict[Path, list[FaultView]]


def sheet_view(sheet: Sheet, robot: Robot | None, structure: Equivalent | None, faults: Faults) -> LimbSheet:
    """The table; rows take their faults out of `faults`."""
    known = {one.limb.name: (k, one) for k, one in enumerate(structure.limbs)} if structure else {}
    return {
        "title": sheet.title,
        "copies": sheet.copies,
        "turned": evenly_turned(sheet),
        "plane": sheet.plane,
        "unit": str(sheet.others.get("units", "")),
        "platform": sheet.platform,
        "limbs": [_limb(sheet, place, known, faults) for place in range(len(sheet.limbs))],
        "names": _names(sheet, robot, faults),
    }


def _limb(sheet: Sheet, place: int, known: dict[str, tuple[int, LimbWrenches]], faults: Faults) -> LimbRow:
    limb = sheet.limbs[place]
    first = next(iter(sheet.numbers(limb.name)), limb.name)
    colour, found = known.get(first, (place, None))
    return {
        "name": limb.name,
        "copies": max(1, sheet.copies) if limb.numbered else 1,
        "numbered": limb.numbered,
        "chain": found.limb.chain if found else "".join(j.kind + j.star[:1] for c in limb.chains for j in c.joints),
        "cable": limb.cable.split(),
        "undefined": [{"name": n, "sort": "point"} for n in limb.cable.split() if sheet.row(n) is None],
        "chains": _chains(sheet, limb, place, faults),
        "couplings": limb.couplings,
        "system": found.kind if found else "",
        "freedoms": found.freedoms if found else 0,
        "constraints": found.constraints if found else 0,
        "wrenches": _wrenches(found) if found else [],
        "colour": colour,
        "faults": faults.pop(("limb", place), []),
    }


def _chains(sheet: Sheet, limb: WrittenLimb, place: int, faults: Faults) -> list[ChainRow]:
    return [
        {
            "head": chain.head,
            "joints": [_joint(sheet, j, faults.pop(("joint", place, c, k), [])) for k, j in enumerate(chain.joints)],
        }
        for c, chain in enumerate(limb.chains)
    ]


def _joint(sheet: Sheet, joint: WrittenJoint, faults: list[FaultView]) -> JointRow:
    missing: dict[str, Undefined] = {}
    for form, part in zip(forms_of(joint.kind), joint.parts, strict=False):
        words = part.split() if form != "number" else []
        sort = "point" if form == "point" or len(words) > 1 else "direction"
        missing |= {w: {"name": w, "sort": sort} for w in words if w not in AXES and sheet.row(w) is None}
    return {
        "kind": joint.kind,
        "star": joint.star,
        "name": joint.name,
        "parts": list(joint.parts),
        "undefined": list(missing.values()),
        "faults": faults,
    }


def _wrenches(found: LimbWrenches) -> list[WrenchRow]:
    return [
        {
            "text": f"{'couple' if line.couple else 'force'} {leg_text(line.ends)}",
            "couple": line.couple,
            "role": line.role,
        }
        for line in found.lines or ()
    ]


def _names(sheet: Sheet, robot: Robot | None, faults: Faults) -> list[NameRow]:
    determined = {d.name for d in robot.family.definitions if not d.parameters} if robot else set()
    unknown = ["", "", ""] if sheet.home else []
    return [
        {
            "name": row.name,
            "sort": row.sort,
            "relation": row.relation,
            "places": [
                {"name": n, "at": list(sheet.home.get(n, [] if n in determined else unknown))}
                for n in sheet.numbers(row.name)
            ],
            "faults": faults.pop(("name", row.name), []),
        }
        for row in sheet.names
    ]


def _drives(symbol: str) -> list[DriveKind]:
    kind = JOINTS[symbol]
    words: list[DriveKind] = [{"star": "", "words": "passive"}]
    if len(kind.drives) == 1:
        words.append({"star": "*", "words": "driven"})
    elif kind.drives:
        words.append({"star": "*", "words": "both driven"})
        words += [{"star": f"*{k + 1}", "words": f"driven: {kind.freedoms[k]}"} for k in kind.drives]
    return words


KINDS: list[JointKindView] = [
    {
        "symbol": symbol,
        "name": kind.name,
        "parts": [{"name": part, "form": form} for part, form in kind.parts.items()],
        "drives": _drives(symbol),
    }
    for symbol, kind in JOINTS.items()
]
"""All kinds of joints, with what they are written of and how they can be driven."""
