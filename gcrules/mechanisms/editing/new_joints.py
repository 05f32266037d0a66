"""New joints with points and directions of their own, and new limbs, which are written as chains: UP*S, R*RR, cable."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.editing.copies import check_room
from gcrules.mechanisms.editing.home import place_of, quarter, size_of, vector_of
from gcrules.mechanisms.editing.naming import new_part
from gcrules.mechanisms.editing.sheet import ChainRow, JointRow, LimbRow, Sheet
from gcrules.screws import JOINTS

__all__ = ["add_joint", "add_limb", "joint_kind", "made_parts", "part_forms", "wanted_parts"]

_LINK = re.compile(r"\s*(4S|Pa|[A-Za-z])(\*[12]?)?\s*")
_LONGEST = 12
_ASIDE = 0.3  # of the robot's size
_STARTING = {False: "RP*S", True: "R*RR"}  # in the plane


def add_joint(sheet: Sheet, limb: int, chain: int, at: int, text: str) -> Sheet:
    """With a further joint at a place of a chain. A slide between two joints leads from one to the other."""
    kind, joints = joint_kind(text), list(sheet.limbs[limb].chains[chain].joints)
    at = min(max(at, 0), len(joints))
    before = [n for j in reversed(joints[:at]) for part in j.parts for n in part.split()]
    after = [n for j in joints[at:] for part in j.parts for n in part.split() if n not in before]
    ends = [next((n for n in own if (row := sheet.row(n)) and row.sort == "point"), "") for own in (before, after)]
    if kind == "P" and all(ends):
        parts = [" ".join(ends)]
    else:
        sheet, parts = made_parts(sheet, limb, wanted_parts(sheet, kind), before, after)
    joints.insert(at, JointRow(kind, tuple(parts)))
    return sheet.with_limb(limb, sheet.limbs[limb].changed(chain, tuple(joints)))


def add_limb(sheet: Sheet, text: str = "") -> Sheet:
    """With a limb of these joints. A slide on a hinge, R P, is perpendicular to its axis."""
    if text.strip() == "cable":
        return _add_cable(sheet)
    kinds = _chain(text or _STARTING[sheet.plane])
    made, at = _with_row(sheet, "leg", (ChainRow(()),)), len(sheet.limbs)
    others = [kind for kind, _ in kinds if kind != "P"]
    for place, kind in enumerate(others):
        made = add_joint(made, at, 0, place, kind)
    for place, (kind, _) in enumerate(kinds):
        if kind == "P":
            made = add_joint(made, at, 0, place, kind)
    joints = made.limbs[at].chains[0].joints
    driven = tuple(replace(j, star=star) for j, (_, star) in zip(joints, kinds, strict=True))
    made = made.with_limb(at, made.limbs[at].changed(0, driven))
    free = kinds[-1][0] == "S" and sum(len(JOINTS[kind].freedoms) for kind, _ in kinds) == 6
    return _aside(made, joints[-1].parts[0], 1 - 2 * (at % 2)) if free else _across_hinges(made, driven)


def _add_cable(sheet: Sheet) -> Sheet:
    """With a cable between two points of its own."""
    made, at = _with_row(sheet, "cable"), len(sheet.limbs)
    made, base = new_part(made, at, "point", ())
    made, end = new_part(made, at, "point", (base,))
    return _aside(made.with_limb(at, replace(made.limbs[at], cable=f"{base} {end}")), end, 1 - 2 * (at % 2))


def _with_row(sheet: Sheet, stem: str, chains: tuple[ChainRow, ...] = ()) -> Sheet:
    """With an empty limb, which bears the next number."""
    check_room(sheet, 1)
    count = len(sheet.every_limb)
    name = next(f"{stem} {k}" for k in range(count + 1, 999) if f"{stem} {k}" not in sheet.every_limb)
    return replace(sheet, limbs=(*sheet.limbs, LimbRow(name, chains)))


def joint_kind(text: str) -> str:
    """The symbol of a kind of joints. Raises InputError for another."""
    if text not in JOINTS:
        raise InputError(
            f"{text[:20]!r} is not a kind of joint", hint=near(text, JOINTS) or f"one of {', '.join(JOINTS)}"
        )
    return text


def part_forms(kind: str) -> list[str]:
    """What each part of a joint is: point, number, or a direction, that of an axis or of a rail."""
    parts = JOINTS[kind].parts if kind in JOINTS else {}
    return ["rail" if name in ("direction", "bars") else form for name, form in parts.items()]


def wanted_parts(sheet: Sheet, kind: str) -> list[tuple[str, str]]:
    """The form of each part of a joint, with what it has to be: turns of the plane are about z."""
    return [(form, "z" if sheet.plane and form == "direction" else "") for form in part_forms(kind)]


def made_parts(
    sheet: Sheet, limb: int, wanted: Sequence[tuple[str, str]], before: Sequence[str], after: Sequence[str] = ()
) -> tuple[Sheet, list[str]]:
    """The parts of a joint, those that are not known made; `before` and `after` are names of the joints beside it."""
    parts: list[str] = []
    for form, known in wanted:
        if not known:
            first = next((p for (f, _), p in zip(wanted, parts, strict=False) if f == form), "")
            sheet, known = new_part(sheet, limb, form, before, after, first)
        parts.append(known)
    return sheet, parts


def _chain(text: str) -> list[tuple[str, str]]:
    """Kinds of joints with their stars."""
    found: list[tuple[str, str]] = []
    at = 0
    while at < len(text):
        match = _LINK.match(text, at)
        if match is None:
            raise InputError(
                f"{text[at:][:20]!r} is not a joint", hint="letters of joints, with a star where one is driven: UP*S"
            )
        found.append((joint_kind(match[1]), match[2] or ""))
        at = match.end()
    if not 0 < len(found) <= _LONGEST:
        raise InputError(f"a limb has 1 to {_LONGEST} joints", hint="UP*S")
    return found


def _aside(sheet: Sheet, end: str, side: int) -> Sheet:
    """With the last point of a limb to one side: forces that all meet z would never hold a platform."""
    if sheet.plane or end not in sheet.home:
        return sheet
    at = vector_of(sheet.home[end])
    width = _ASIDE * size_of(sheet) * side
    place = place_of([c + width * d for c, d in zip(at, quarter(at), strict=True)])
    return replace(sheet, home=FrozenMap({**sheet.home, end: place}))


def _across_hinges(sheet: Sheet, joints: Sequence[JointRow]) -> Sheet:
    names = list(sheet.names)
    for hinge, slide in pairwise(joints):
        ends = slide.parts[0].split()
        if (hinge.kind, slide.kind, len(ends)) == ("R", "P", 2) and not sheet.plane:
            point, axis = hinge.parts
            relation = f"in plane {point} perpendicular to {axis}"
            names = [replace(n, relation=relation) if n.name == ends[1] else n for n in names]
    return replace(sheet, names=tuple(names))
