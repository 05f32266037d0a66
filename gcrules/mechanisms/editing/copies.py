"""Limbs alike: one more, turned about z; as many around z as one likes; and each of them for itself."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.description.robot_file import MAX_COPIES, MAX_LIMBS
from gcrules.mechanisms.editing.home import on_axis, place_of, size_of, turned, vector_of
from gcrules.mechanisms.editing.naming import free_name, names_in
from gcrules.mechanisms.editing.sheet import ChainRow, JointRow, LimbRow, NameRow, Place, Sheet, renamed_text, words_of

__all__ = ["around", "check_room", "duplicate", "recounted", "single"]

_SIDEWAYS = ("x", "y")  # directions of the frame that a turn about z changes
_NUMBER = re.compile(r"\d+$")


def duplicate(sheet: Sheet, place: int, degrees: float, after: int = 0) -> Sheet:
    """With one more limb like that at a place, turned about z by an angle, behind it and so many others. What lies on z
    is shared.
    """
    limb = sheet.limbs[place]
    check_room(sheet, sheet.copies if limb.numbered else 1)
    ending = "%" if limb.numbered else str(len(sheet.every_limb) + 1)
    made, home = sheet, dict(sheet.home)
    names: dict[str, str] = {}
    for row in _own(sheet, limb):
        names[row.name] = name = free_name(made, row.sort, ending, row.name)
        made = replace(made, names=(*made.names, replace(row, name=name)))
        for old, new in zip(sheet.numbers(row.name), made.numbers(name), strict=False):
            if old in sheet.home:
                home[new] = place_of(turned(vector_of(sheet.home[old]), degrees))
    made = replace(made, home=FrozenMap(home))
    made, every = _turned_axes(made, limb, ending, names, [degrees] * max(1, sheet.copies))
    copy = replace(limb.renamed(every), name=_free_limb(sheet, limb.name))
    end = place + 1 + after
    return replace(made, limbs=(*sheet.limbs[:end], copy, *sheet.limbs[end:]))


def around(sheet: Sheet, place: int, count: int) -> Sheet:
    """So many limbs around z in place of one; as `copies` of the file, where it has none of another number."""
    limb = sheet.limbs[place]
    if not 2 <= count <= MAX_COPIES:
        raise InputError(f"{count} limbs do not go around z", hint=f"from 2 to {MAX_COPIES} do")
    if limb.numbered:
        raise InputError(f"{limb.name} already stands for {sheet.copies} limbs", hint="make single limbs of it first")
    check_room(sheet, count - 1)
    if sheet.copies in (0, count):
        return _numbered(replace(sheet, copies=count), place, count)
    for k in range(1, count):
        sheet = duplicate(sheet, place, 360.0 / count * k, k - 1)
    return sheet


def recounted(sheet: Sheet, count: int) -> Sheet:
    """With another number of copies; the first stays, and the others are turned on from it."""
    if not 2 <= count <= MAX_COPIES:
        raise InputError(f"{count} limbs do not go around z", hint=f"from 2 to {MAX_COPIES} do")
    made = replace(sheet, copies=count)
    check_room(made, 0)
    home: dict[str, Place] = {}
    for name, at in sheet.home.items():
        row = sheet.row(name)
        if row is None or "%" not in row.name:
            home[name] = at
        elif name == sheet.numbers(row.name)[0]:
            for k, own in enumerate(made.numbers(row.name)):
                home[own] = place_of(turned(vector_of(at), 360.0 / count * k)) if k else at
    return replace(made, home=FrozenMap(home))


def single(sheet: Sheet, place: int) -> Sheet:
    """With the limbs of copies one by one, and the names that only they have too."""
    limb = sheet.limbs[place]
    if not limb.numbered or not sheet.copies:
        return sheet
    rest = [*sheet.limbs[:place], *sheet.limbs[place + 1 :]]
    texts = [*(row.text for row in rest), *map(str, sheet.others.values())]
    shared = {w for text in texts for w in words_of(text) if "%" in w}
    names: list[NameRow] = []
    for row in sheet.names:
        alone = "%" in row.name and row.name not in shared
        names += [_copy_of_name(row, k) for k in range(1, sheet.copies + 1)] if alone else [row]
    limbs = [_copy_of_limb(limb, k) for k in range(1, sheet.copies + 1)]
    found = replace(sheet, names=tuple(names), limbs=(*sheet.limbs[:place], *limbs, *sheet.limbs[place + 1 :]))
    others = {*map(str, sheet.others.values())}
    left = [*(row.name for row in names), *(row.name + row.text for row in found.limbs), *others]
    if any("%" in text for text in left):
        return found
    platform = dict.fromkeys(n for word in words_of(found.platform) for n in found.numbers(word))
    return replace(found, platform=" ".join(platform), copies=0)


def check_room(sheet: Sheet, more: int) -> None:
    """Whether there may be so many more limbs. Raises InputError."""
    if len(sheet.every_limb) + more > MAX_LIMBS:
        raise InputError(f"a robot has at most {MAX_LIMBS} limbs")


def _own(sheet: Sheet, limb: LimbRow) -> list[NameRow]:
    """The names that a limb uses, with those that these are made from; without what lies on z, or is along it."""
    size = size_of(sheet)
    found: set[str] = set()
    left = names_in(sheet, limb.text)
    while left:
        row = sheet.row(left.pop(0))
        if row is None or row.name in found:
            continue
        places = [vector_of(sheet.home[n]) for n in sheet.numbers(row.name) if n in sheet.home]
        if places and all(on_axis(v, size) for v in places):
            continue
        found.add(row.name)
        left += names_in(sheet, row.relation)
    return [row for row in sheet.names if row.name in found]


def _turned_axes(
    made: Sheet, limb: LimbRow, ending: str, names: Mapping[str, str], angles: Sequence[float]
) -> tuple[Sheet, Mapping[str, str]]:
    """With directions in place of x and y of the frame, turned by an angle in each copy; relations of the new names
    speak of new names.
    """
    fresh, home, found = set(names.values()), dict(made.home), dict(names)
    texts = [limb.text, *(row.relation for row in made.names if row.name in fresh)]
    for axis in _SIDEWAYS:
        if any(axis in words_of(text) for text in texts):
            found[axis] = name = free_name(made, "direction", ending, "d")
            made = replace(made, names=(*made.names, NameRow(name, "direction", "free")))
            for own, angle in zip(made.numbers(name), angles, strict=False):
                home[own] = place_of(turned(AXES[axis], angle))
    rows = (replace(r, relation=renamed_text(r.relation, found)) if r.name in fresh else r for r in made.names)
    return replace(made, names=tuple(rows), home=FrozenMap(home)), found


def _numbered(sheet: Sheet, place: int, count: int) -> Sheet:
    """The limb at a place as the first of copies."""
    limb = sheet.limbs[place]
    own = _own(sheet, limb)
    angles = [360.0 / count * k for k in range(count)]
    others = {n for k, row in enumerate(sheet.limbs) if k != place for n in names_in(sheet, row.text)}
    alone = {row.name for row in own} - others
    rows = [row for row in sheet.names if row.name not in alone]
    free, home, names = replace(sheet, names=tuple(rows)), dict(sheet.home), {}
    for row in own:
        names[row.name] = name = free_name(free, row.sort, "%", row.name)
        free = replace(free, names=(*free.names, replace(row, name=name)))
        at = home.pop(row.name, None) if row.name in alone else home.get(row.name)
        for number, angle in zip(free.numbers(name), angles, strict=True):
            if at is not None:
                home[number] = place_of(turned(vector_of(at), angle)) if angle else at
    made, all_names = _turned_axes(replace(free, home=FrozenMap(home)), limb, "%", names, angles)
    copy = limb.renamed(all_names)
    if "%" not in copy.text:
        raise InputError(f"all of {limb.name} lies on z", hint="put one of its points off the z axis")
    taken = {n for k, row in enumerate(sheet.limbs) if k != place for n in sheet.numbers(row.name)}
    own_label = _NUMBER.sub("%", limb.name)
    labels = (own_label if "%" in own_label else f"{own_label} %", "limb %", *(f"limb {c} %" for c in "bcdefghijkl"))
    copy = replace(copy, name=next(label for label in labels if taken.isdisjoint(sheet.numbers(label))))
    platform = " ".join(dict.fromkeys(all_names.get(w, w) for w in words_of(sheet.platform)))
    return replace(made.with_limb(place, copy), platform=platform)


def _free_limb(sheet: Sheet, name: str) -> str:
    """A name for a limb beside another one: the next number, or a letter behind it."""
    if "%" in name:
        return next(f"{name} {c}" for c in "bcdefghijkl" if f"{name} {c}" not in {row.name for row in sheet.limbs})
    stem = _NUMBER.sub("", name)
    return next(f"{stem}{k}" for k in range(2, 999) if f"{stem}{k}" not in sheet.every_limb)


def _copy_of_name(row: NameRow, k: int) -> NameRow:
    return NameRow(row.name.replace("%", str(k)), row.sort, row.relation.replace("%", str(k)))


def _copy_of_limb(limb: LimbRow, k: int) -> LimbRow:
    def own(text: str) -> str:
        return text.replace("%", str(k))

    chains = tuple(
        ChainRow(tuple(JointRow(j.kind, tuple(map(own, j.parts)), j.star, j.name) for j in c.joints), own(c.head))
        for c in limb.chains
    )
    return replace(limb, name=own(limb.name), chains=chains, cable=own(limb.cable), through=own(limb.through))
