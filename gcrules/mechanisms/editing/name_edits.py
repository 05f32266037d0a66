"""Changes of a sheet's points and directions: new ones, other names, other relations, other places at home."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.editing.home import place_of, turned, vector_of
from gcrules.mechanisms.editing.naming import with_name
from gcrules.mechanisms.editing.sheet import NameRow, Place, Sheet, renamed_text

__all__ = ["defined", "made_from", "put_home", "renamed"]

_RELATION = re.compile(r"[\w' %./+*(),-]*")
_NUMBER = re.compile(r"-?(\d{1,9}(/[1-9]\d{0,8})?|\d{0,9}\.\d{1,15})")


def defined(sheet: Sheet, name: str, sort: str) -> Sheet:
    """With a further point or direction, that is free; home gets a place for it where it can."""
    if sort not in ("point", "direction"):
        raise InputError(f"{sort[:20]!r} is not a kind of name", hint="a point or a direction")
    _check(sheet, name)
    return with_name(sheet, name, sort, "free")


def renamed(sheet: Sheet, name: str, to: str) -> Sheet:
    """With another name wherever it stands, copies along with it."""
    row, to = _row(sheet, name), to.strip()
    if to == row.name:
        return sheet
    if ("%" in row.name) != ("%" in to):
        raise InputError(f"{to[:20]!r} is not a name for {row.name}", hint="% stands for the numbers of copies")
    _check(replace(sheet, names=tuple(n for n in sheet.names if n != row)), to)
    names = {row.name: to, **dict(zip(sheet.numbers(row.name), sheet.numbers(to), strict=True))}
    others = {
        key: renamed_text(value, names)
        if isinstance(value, str) and key == "condition"
        else tuple(renamed_text(v, names) for v in value)
        if isinstance(value, tuple)
        else value
        for key, value in sheet.others.items()
    }
    return replace(
        sheet,
        names=tuple(NameRow(names.get(n.name, n.name), n.sort, renamed_text(n.relation, names)) for n in sheet.names),
        limbs=tuple(limb.renamed(names) for limb in sheet.limbs),
        platform=renamed_text(sheet.platform, names),
        home=FrozenMap((names.get(n, n), at) for n, at in sheet.home.items()),
        drawing=FrozenMap((names.get(n, n), at) for n, at in sheet.drawing.items()),
        others=FrozenMap(others),
    )


def made_from(sheet: Sheet, name: str, relation: str) -> Sheet:
    """With another relation that makes a name."""
    row, text = _row(sheet, name), " ".join(relation.split())
    if not text or len(text) > 200 or not _RELATION.fullmatch(text):
        raise InputError(f"{text[:30]!r} is not a relation", hint="free, on line A B, in plane A perpendicular to u …")
    return replace(sheet, names=tuple(replace(n, relation=text) if n == row else n for n in sheet.names))


def put_home(sheet: Sheet, name: str, texts: Sequence[str], *, follow: bool) -> Sheet:
    """With other coordinates at home of one name; with `follow` its copies are turned on from it."""
    place, row = _coordinates(texts), _row(sheet, name)
    numbers = sheet.numbers(row.name)
    if name not in numbers:
        raise InputError(f"{name} stands for several names", hint=f"one of {', '.join(numbers)}")
    if place[2] == "0" and name in sheet.home and not sheet.home[name][2]:  # as it was written, in the plane
        place = (*place[:2], "")
    home = {**sheet.home, name: place}
    if follow and len(numbers) > 1:
        first = numbers.index(name)
        for k, own in enumerate(numbers):
            if k != first:
                home[own] = place_of(turned(vector_of(place), 360.0 / len(numbers) * (k - first)))
    return replace(sheet, home=FrozenMap(home))


def _row(sheet: Sheet, name: str) -> NameRow:
    row = sheet.row(name)
    if row is None:
        raise InputError(f"{name[:20]} is not defined", hint=near(name, sheet.every_name))
    return row


def _check(sheet: Sheet, name: str) -> None:
    plain = name.replace("%", "1")
    if not SHORT_NAME.fullmatch(plain) or len(name) > 12 or name.count("%") > 1 or ("%" in name and not sheet.copies):
        raise InputError(f"{name[:20]!r} is not a name", hint="a letter, then digits or primes: A1, S', r12")
    if name in AXES:
        raise InputError(f"{name} is a direction of the frame in every robot", hint="choose another name")
    if twice := set(sheet.numbers(name)) & sheet.every_name:
        raise InputError(f"there is a name {min(twice)} already", hint="choose another name")


def _coordinates(texts: Sequence[str]) -> Place:
    words = [text.strip().replace("\N{MINUS SIGN}", "-") for text in texts]
    if len(words) != 3:
        raise InputError("a place has three coordinates")
    for word in words:
        if not _NUMBER.fullmatch(word):
            raise InputError(f"{word[:20]!r} is not a number", hint="numbers are written 3, -0.25 or 1/3")
    x, y, z = (str(Fraction(w)) if "/" in w else w for w in words)
    return x, y, z
