"""What can be done to a sheet, one table: each a function of the sheet and of the change that is asked for."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.editing.copies import around, duplicate, recounted, single
from gcrules.mechanisms.editing.name_edits import defined, made_from, put_home, renamed
from gcrules.mechanisms.editing.naming import forms_of, without_unused
from gcrules.mechanisms.editing.new_joints import add_joint, add_limb, joint_kind, made_parts, part_forms, wanted_parts
from gcrules.mechanisms.editing.sheet import ChainRow, JointRow, LimbRow, Sheet, words_of
from gcrules.screws import JOINTS
from gcrules.screws.pose import UNITS

__all__ = ["EDITS", "Edit", "edited"]

_PART = re.compile(r"[\w' %./-]*")
_LIMB_NAME = re.compile(r"[\w %()/.,-]+")
_STARS = ("", "*", "*1", "*2")


@dataclass(frozen=True)
class Edit:
    """A change, with what it needs: places count from 0; `text` and `texts` are as they are written."""

    do: str
    limb: int = 0
    chain: int = 0
    joint: int = 0
    part: int = 0
    to: int = 0
    name: str = ""
    text: str = ""
    texts: Sequence[str] = ()
    degrees: float = 0.0
    follow: bool = False


def edited(sheet: Sheet, edit: Edit) -> Sheet:
    """The sheet after a change. Raises InputError for one that cannot be."""
    found = EDITS[edit.do](sheet, edit)
    if set(words_of(sheet.platform)) == set(_ends(sheet)):  # it goes with the ends of the limbs
        found = replace(found, platform=" ".join(_ends(found)))
    return without_unused(sheet, found)


def _ends(sheet: Sheet) -> list[str]:
    """Points of the last joints of limbs, on the platform; a pair of bars has its ends elsewhere."""
    last = [c.joints[-1] for limb in sheet.limbs for c in limb.chains if c.joints and _reaches_platform(c)]
    points = [
        part
        for j in last
        if j.kind != "4S"
        for form, part in zip(forms_of(j.kind), j.parts, strict=False)
        if form == "point"
    ]
    cables = [end for limb in sheet.limbs for end in limb.cable.split()[1:]]
    return list(dict.fromkeys([*points, *cables]))


def _reaches_platform(chain: ChainRow) -> bool:
    return not chain.head or chain.head.endswith(" platform")


# --- limbs ---------------------------------------------------------------------------------------------------------


def _limb(sheet: Sheet, edit: Edit) -> LimbRow:
    if not 0 <= edit.limb < len(sheet.limbs):
        raise InputError(f"there is no limb {edit.limb + 1}")
    return sheet.limbs[edit.limb]


def _title(sheet: Sheet, edit: Edit) -> Sheet:
    title = " ".join(edit.text.split())
    if not title or len(title) > 200:
        raise InputError("a robot has a title", hint="up to 200 characters")
    return replace(sheet, title=title)


def _remove_limb(sheet: Sheet, edit: Edit) -> Sheet:
    own = _limb(sheet, edit)
    rest = replace(sheet, limbs=tuple(limb for limb in sheet.limbs if limb is not own))
    left = without_unused(sheet, replace(rest, platform=" ".join(_ends(rest))))
    texts = [*(row.name for row in left.names), *(row.name + row.text for row in left.limbs)]
    return rest if any("%" in text for text in texts) else replace(left, copies=0)


def _move_limb(sheet: Sheet, edit: Edit) -> Sheet:
    own, rows = _limb(sheet, edit), list(sheet.limbs)
    rows.pop(edit.limb)
    rows.insert(min(max(edit.to, 0), len(rows)), own)
    return replace(sheet, limbs=tuple(rows))


def _rename_limb(sheet: Sheet, edit: Edit) -> Sheet:
    limb, name = _limb(sheet, edit), " ".join(edit.text.split())
    if not name or len(name) > 60 or not _LIMB_NAME.fullmatch(name):
        raise InputError(f"{name[:30]!r} is not a name for a limb", hint="letters, digits and spaces: leg 1")
    if limb.numbered and "%" not in name:
        name = f"{name} %"
    return sheet.with_limb(edit.limb, replace(limb, name=name if limb.numbered else name.replace("%", "")))


def _change_cable(sheet: Sheet, edit: Edit) -> Sheet:
    limb, name = _limb(sheet, edit), edit.text.strip()
    ends = limb.cable.split()
    if edit.part >= len(ends) or not _PART.fullmatch(name) or len(name.split()) != 1:
        raise InputError(f"{name[:30]!r} is not an end of a cable", hint="the name of a point: A1")
    ends[edit.part] = name
    return sheet.with_limb(edit.limb, replace(limb, cable=" ".join(ends)))


def _duplicate(sheet: Sheet, edit: Edit) -> Sheet:
    _limb(sheet, edit)
    return duplicate(sheet, edit.limb, edit.degrees)


def _around(sheet: Sheet, edit: Edit) -> Sheet:
    _limb(sheet, edit)
    return around(sheet, edit.limb, edit.to)


def _single(sheet: Sheet, edit: Edit) -> Sheet:
    _limb(sheet, edit)
    return single(sheet, edit.limb)


# --- joints --------------------------------------------------------------------------------------------------------


def _chain(sheet: Sheet, edit: Edit) -> list[JointRow]:
    limb = _limb(sheet, edit)
    if not 0 <= edit.chain < len(limb.chains):
        raise InputError(f"{limb.name} has no chain {edit.chain + 1}")
    return list(limb.chains[edit.chain].joints)


def _joint(sheet: Sheet, edit: Edit) -> tuple[list[JointRow], JointRow]:
    joints = _chain(sheet, edit)
    if not 0 <= edit.joint < len(joints):
        raise InputError(f"{_limb(sheet, edit).name} has no joint {edit.joint + 1}")
    return joints, joints[edit.joint]


def _put(sheet: Sheet, edit: Edit, joints: Sequence[JointRow]) -> Sheet:
    return sheet.with_limb(edit.limb, _limb(sheet, edit).changed(edit.chain, tuple(joints)))


def _unit(sheet: Sheet, edit: Edit) -> Sheet:
    """With another unit of all lengths, whose numbers stay."""
    if edit.text and edit.text not in UNITS:
        raise InputError(f"{edit.text[:20]!r} is not a unit of length", hint=f"one of {', '.join(UNITS)}")
    others = {key: value for key, value in sheet.others.items() if key != "units"}
    return replace(sheet, others=FrozenMap({**others, "units": edit.text} if edit.text else others))


def _add_joint(sheet: Sheet, edit: Edit) -> Sheet:
    _chain(sheet, edit)
    return add_joint(sheet, edit.limb, edit.chain, edit.joint, edit.text)


def _remove_joint(sheet: Sheet, edit: Edit) -> Sheet:
    joints, _ = _joint(sheet, edit)
    if len(joints) == 1:
        raise InputError("a limb has at least one joint", hint="remove the limb")
    return _put(sheet, edit, [*joints[: edit.joint], *joints[edit.joint + 1 :]])


def _move_joint(sheet: Sheet, edit: Edit) -> Sheet:
    joints, own = _joint(sheet, edit)
    joints.pop(edit.joint)
    joints.insert(min(max(edit.to, 0), len(joints)), own)
    return _put(sheet, edit, joints)


def _change_kind(sheet: Sheet, edit: Edit) -> Sheet:
    """Another kind of joint; points and directions that it needs are taken over as far as there are such."""
    joints, own = _joint(sheet, edit)
    kind = joint_kind(edit.text)
    left = list(zip(part_forms(own.kind), own.parts, strict=False))
    wanted: list[tuple[str, str]] = []
    for form, known in wanted_parts(sheet, kind):
        there = next((entry for entry in left if entry[0] == form and not known), None)
        if there is not None:
            left.remove(there)
        wanted.append((form, there[1] if there else known))
    beside = [n for part in own.parts for n in part.split()]
    sheet, parts = made_parts(sheet, edit.limb, wanted, beside)
    drives = JOINTS[kind].drives
    star = own.star if len(drives) > 1 else "*" if own.star and drives else ""
    joints[edit.joint] = JointRow(kind, tuple(parts), star, own.name)
    return _put(sheet, edit, joints)


def _drive(sheet: Sheet, edit: Edit) -> Sheet:
    joints, own = _joint(sheet, edit)
    if edit.text not in _STARS:
        raise InputError(f"{edit.text[:20]!r} drives no joint", hint="*, or *1 and *2 for one of two freedoms")
    joints[edit.joint] = replace(own, star=edit.text)
    return _put(sheet, edit, joints)


def _change_part(sheet: Sheet, edit: Edit) -> Sheet:
    joints, own = _joint(sheet, edit)
    text = " ".join(edit.text.split())
    if not 0 <= edit.part < len(own.parts) or not text or len(text) > 40 or not _PART.fullmatch(text):
        hint = "a name, A1, or two points for a direction, A1 B1"
        raise InputError(f"{text[:30]!r} is not a part of a joint", hint=hint)
    parts = list(own.parts)
    parts[edit.part] = text
    joints[edit.joint] = replace(own, parts=tuple(parts))
    return _put(sheet, edit, joints)


EDITS: Mapping[str, Callable[[Sheet, Edit], Sheet]] = FrozenMap(
    {
        "title": _title,
        "limb add": lambda sheet, e: add_limb(sheet, e.text),
        "limb remove": _remove_limb,
        "limb move": _move_limb,
        "limb name": _rename_limb,
        "limb cable": _change_cable,
        "limb duplicate": _duplicate,
        "limb around": _around,
        "limb single": _single,
        "copies": lambda sheet, e: recounted(sheet, e.to),
        "joint add": _add_joint,
        "joint remove": _remove_joint,
        "joint move": _move_joint,
        "joint kind": _change_kind,
        "joint drive": _drive,
        "joint part": _change_part,
        "name add": lambda sheet, e: defined(sheet, e.name, e.text),
        "name rename": lambda sheet, e: renamed(sheet, e.name, e.text),
        "name relation": lambda sheet, e: made_from(sheet, e.name, e.text),
        "home": lambda sheet, e: put_home(sheet, e.name, e.texts, follow=e.follow),
        "unit": _unit,
        "mobility": lambda sheet, e: replace(sheet, mobility=str(e.to)),
    }
)
"""Every change by its name."""
