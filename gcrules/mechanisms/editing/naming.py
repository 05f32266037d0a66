"""Names for new points and directions, and where they are put at home."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.editing.home import Vector, place_of, quarter, size_of, turned, vector_of
from gcrules.mechanisms.editing.sheet import NameRow, Sheet, words_of
from gcrules.screws import JOINTS

__all__ = ["forms_of", "free_name", "names_in", "new_part", "with_name", "without_unused"]

_LETTERS = {"point": "ABCDEFGHKLMNOPQSTVWXYZ", "direction": "uvwrsdenmabcfghkpqt"}
_NUMBER = re.compile(r"\d{1,2}$")
_WIDTH = 0.2  # of the robot's size, between two bars
_RISE = 0.35  # of the robot's size, between a joint and one that is put after it


def forms_of(kind: str) -> Sequence[str]:
    """What each part of a joint is: point, direction or number; none of an unknown kind."""
    return tuple(JOINTS[kind].parts.values()) if kind in JOINTS else ()


def free_name(sheet: Sheet, sort: str, ending: str, wish: str = "") -> str:
    """A name with this ending ("%" for one of copies) that nothing bears yet, with the letter of `wish` if possible."""
    taken = {*sheet.every_name, *AXES}
    letters = [*wish[:1], *_LETTERS[sort]]
    endings = [ending] if ending == "%" else [ending, *map(str, range(1, 100))]
    names = (letter + own for own in endings for letter in letters)
    return next((name for name in names if taken.isdisjoint(sheet.numbers(name))), f"{letters[0]}{ending}'")


def names_in(sheet: Sheet, text: str) -> list[str]:
    """The rows of names that a text mentions, each once."""
    rows = (sheet.row(word) for word in words_of(text))
    return list(dict.fromkeys(row.name for row in rows if row is not None))


def with_name(sheet: Sheet, name: str, sort: str, relation: str, places: Sequence[Vector] = ()) -> Sheet:
    """With a further row of names, at these places at home, one for each copy; where there is a home at all."""
    home = dict(sheet.home)
    if places and (home or not sheet.names):
        home |= {n: place_of(v) for n, v in zip(sheet.numbers(name), places, strict=True)}
    return replace(sheet, names=(*sheet.names, NameRow(name, sort, relation)), home=FrozenMap(home))


def without_unused(before: Sheet, after: Sheet) -> Sheet:
    """Without the names that were used before and are not now."""
    kept = after
    while gone := (before.uses() - kept.uses()) & {row.name for row in kept.names}:
        numbers = {n for name in gone for n in kept.numbers(name)}
        kept = replace(
            kept,
            names=tuple(row for row in kept.names if row.name not in gone),
            home=FrozenMap((n, at) for n, at in kept.home.items() if n not in numbers),
        )
    return kept


def new_part(
    sheet: Sheet, limb: int, form: str, beside: Sequence[str], after: Sequence[str] = (), first: str = ""
) -> tuple[Sheet, str]:
    """A part for a new joint: a number, or a new point, axis or rail of the limb. `beside` are the names of the joints
    before it, the nearest one first, `after` those behind, `first` the part of this form that the joint has already.
    """
    if form == "number":
        return sheet, "1/10"
    row, sort = sheet.limbs[limb], "point" if form == "point" else "direction"
    number = _NUMBER.search(row.name)
    ending = "%" if row.numbered and sheet.copies else number[0] if number else str(limb + 1)
    name = free_name(sheet, sort, ending)
    count = len(sheet.numbers(name))
    own = [n for chain in row.chains for j in chain.joints for part in j.parts for n in part.split()]
    known = [*beside, *own]
    places = {
        "point": lambda k: _place(sheet, k, count, beside, after, first),
        "direction": lambda k: _axis(sheet, k, count, known, first),
        "rail": lambda k: _rail(sheet, k, count, known),
    }
    return with_name(sheet, name, sort, "free", [places[form](k) for k in range(count)]), name


def _near(sheet: Sheet, names: Sequence[str], sort: str, copy: int) -> Vector | None:
    """Where the first of some names is at home, in a copy."""
    for name in names:
        row, numbers = sheet.row(name), sheet.numbers(name)
        own = numbers[min(copy, len(numbers) - 1)] if numbers else name
        if row is not None and row.sort == sort and own in sheet.home:
            return vector_of(sheet.home[own])
    return None


def _place(sheet: Sheet, copy: int, count: int, beside: Sequence[str], after: Sequence[str], own: str) -> Vector:
    size = size_of(sheet)
    if twin := _near(sheet, [own], "point", copy):  # the second of two bars begins beside the first
        x, y, _ = quarter(twin)
        return twin[0] + _WIDTH * size * x, twin[1] + _WIDTH * size * y, twin[2]
    first, second = _near(sheet, beside, "point", copy), _near(sheet, after, "point", copy)
    rise = 0.0 if sheet.plane else _RISE * size
    if first and second:  # beside the middle
        x, y, z = ((a + b) / 2 for a, b in zip(first, second, strict=True))
        across = quarter(first) if sheet.plane else (0.0, 0.0, 0.0)
        return 1.15 * x + rise * across[0] + 0.2 * size * (x == y == 0), 1.15 * y + rise * across[1], z
    if first:
        inward = quarter(first) if sheet.plane else (0.0, 0.0, 0.0)
        bent = len({n for n in beside if (r := sheet.row(n)) and r.sort == "point"}) > 1  # no links in a line
        x, y = ((0.5 if bent else 0.75) * first[i] + _RISE * size * inward[i] for i in (0, 1))
        return x + 0.2 * size * (x == y == 0), y, first[2] + (0.4 if bent else 1.0) * rise
    if second:
        return 1.25 * second[0] + 0.2 * size * (second[0] == second[1] == 0), 1.25 * second[1], second[2] - rise
    return turned((size, 0.0, 0.0), _angle(sheet, copy, count))


def _angle(sheet: Sheet, copy: int, count: int) -> float:
    """At which angle about z a limb is begun, in degrees."""
    return 360.0 * copy / count if count > 1 else 75.0 * (len(sheet.every_limb) - 1)


def _axis(sheet: Sheet, copy: int, count: int, known: Sequence[str], own: str) -> Vector:
    """Across the other axis of the joint; parallel to an axis before it; else across the way out from z."""
    if other := _near(sheet, [own], "direction", copy):
        x, y, _ = other
        return (-y, x, 0.0) if abs(x) + abs(y) > 0 else (1.0, 0.0, 0.0)
    if other := _near(sheet, known, "direction", copy):
        return other
    point = _near(sheet, known, "point", copy)
    return quarter(point) if point else turned((0.0, 1.0, 0.0), _angle(sheet, copy, count))


def _rail(sheet: Sheet, copy: int, count: int, known: Sequence[str]) -> Vector:
    """Inwards, and upwards in space."""
    x, y, _ = quarter(_near(sheet, known, "point", copy) or turned((1.0, 0.0, 0.0), _angle(sheet, copy, count)))
    return (-y, x, 0.0) if sheet.plane else (-0.5 * y, 0.5 * x, 1.0)
