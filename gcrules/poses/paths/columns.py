r"""What the columns of a table of poses hold, by the words of its first line; faults have their place in the text."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.screws.pose import check_unit
from gcrules.screws.pose_text import ANGLES, COORDINATES, TURNS
from gcrules.screws.rotations import check_sequence

__all__ = ["FORMS", "Cell", "Columns", "placed", "read_columns", "read_coordinates"]

_HEADER = re.compile(r"([^\s\[\]]*)\s*(?:\[\s*([^\[\]]*?)\s*\])?")
_EULER = re.compile(r"([xyz]{3}|[XYZ]{3})([123])")
_ANGLES = {"deg": True, "°": True, "rad": False}
_SHIFT = ("x", "y", "z")
_QUATERNION = ("qw", "qx", "qy", "qz")
_VECTOR = ("rx", "ry", "rz")
_FIXED_AXES = "xyz"
"""The sequence of roll, pitch and yaw."""
FORMS = (
    "columns x, y, z, then qw, qx, qy, qz or rx [deg], ry [deg], rz [deg] or roll [deg], pitch [deg], yaw [deg] or"
    " zyx1 [deg], zyx2 [deg], zyx3 [deg]"
)


@dataclass(frozen=True)
class Cell:
    """A cell with its place in the text."""

    text: str
    span: Span


@dataclass(frozen=True)
class Columns:
    """Where the numbers of a pose stand: the turn is of one `kind` (none | quaternion | vector | a sequence)."""

    width: int
    shift: tuple[int, ...]
    kind: str
    turn: tuple[int, ...]
    degrees: bool


def read_columns(header: list[Cell], unit: str, line: Span) -> tuple[Columns, tuple[str, ...]]:
    """What the words of the first `line` name, lengths in `unit`, and notes on what is left out. Raises InputError."""
    names: dict[str, int] = {}
    units: dict[str, tuple[str | None, Span]] = {}
    for i, cell in enumerate(header):
        match = _HEADER.fullmatch(cell.text)
        name = match[1] if match else cell.text
        if name in names and name:
            raise InputError(f"a second column {name[:40]}", span=cell.span)
        names[name] = i
        units[name] = (match[2] if match else None, cell.span)
    if not set(names) & {*_SHIFT, *_QUATERNION, *_VECTOR, *TURNS} and not any(map(_EULER.fullmatch, names)):
        raise InputError("the first line names no columns of poses", span=line, hint=FORMS)
    sequences = dict.fromkeys(m[1] for n in names if (m := _EULER.fullmatch(n)))
    kinds: dict[str, tuple[str, ...]] = {"none": (), "quaternion": _QUATERNION, "vector": _VECTOR, "turns": TURNS}
    kinds |= {s: tuple(f"{s}{i}" for i in (1, 2, 3)) for s in sequences}
    for sequence in sequences:
        placed(units[_first(kinds[sequence], names)][1], check_sequence, sequence)
    given = [kind for kind, wanted in kinds.items() if set(wanted) & set(names)]
    if len(given) > 1:
        raise InputError("several kinds of turns", span=units[_first(kinds[given[1]], names)][1], hint=FORMS)
    kind = given[0] if given else "none"
    if not set(_SHIFT) & set(names):
        shift: tuple[int, ...] = ()
    else:
        shift = _indices(_SHIFT, names, line)
        for name in _SHIFT:
            word, span = units[name]
            if word is not None:
                placed(span, check_unit, word, unit)
    turn = _indices(kinds[kind], names, line)
    degrees = {_angle(*units[name]) for name in kinds[kind]} if kind not in ("none", "quaternion") else {False}
    if len(degrees) > 1:
        raise InputError("deg and rad in one set of angles", span=units[kinds[kind][0]][1])
    used = {*shift, *turn}
    for name, (_, span) in units.items():
        if names[name] not in used and (meant := _meant(name)):
            raise InputError(
                f"the column {name[:40]!r} is not recognised, and a pose would lack what it holds",
                span=span,
                hint=f"did you mean {meant}? A column of something else needs another name",
            )
    left = [c.text for i, c in enumerate(header) if i not in used and c.text]
    notes = (f"columns left out: {', '.join(left)[:200]}",) if left else ()
    return Columns(len(header), shift, _FIXED_AXES if kind == "turns" else kind, turn, degrees.pop()), notes


def _meant(name: str) -> str:
    """The column of a pose that a name resembles: one with capitals, or with its unit in it; "" for none."""
    plain = re.sub(r"(deg|rad|degrees|radians|mm|m)$", "", re.sub(r"[^a-z0-9]", "", name.lower()))
    if plain == name or not name:
        return ""
    if plain in _SHIFT or plain in _QUATERNION:
        return plain
    return f"{plain} [deg]" if plain in (*_VECTOR, *TURNS) or _EULER.fullmatch(plain) else ""


def read_coordinates(header: list[Cell], unit: str, line: Span) -> list[tuple[str, bool]] | None:
    """Of columns that are all coordinates of a robot's platform their names, and which are in degrees; None where they
    are none, or tell whole poses. Raises InputError.
    """
    found = []
    for cell in header:
        match = _HEADER.fullmatch(cell.text)
        if match is None or match[1] not in COORDINATES:
            return None
        angle = match[1] in ANGLES
        degrees = placed(cell.span, _angle, match[2], cell.span) if angle else False
        if not angle and match[2] is not None:
            placed(cell.span, check_unit, match[2], unit)
        found.append((match[1], degrees))
    names = [n for n, _ in found]
    twice = next((n for n in names if names.count(n) > 1), None)
    if twice is not None:
        raise InputError(f"a second column {twice}", span=line)
    whole = [{*_SHIFT}, {*_SHIFT, *_VECTOR}, {*_SHIFT, *TURNS}]
    return None if set(names) in whole else found


def _first(wanted: tuple[str, ...], names: Mapping[str, int]) -> str:
    return next(n for n in wanted if n in names)


def _indices(wanted: tuple[str, ...], names: Mapping[str, int], line: Span) -> tuple[int, ...]:
    missing = [n for n in wanted if n not in names]
    if missing:
        raise InputError(f"the column{'s' * (len(missing) > 1)} {', '.join(missing)} missing", span=line, hint=FORMS)
    return tuple(names[n] for n in wanted)


def _angle(word: str | None, span: Span) -> bool:
    if word not in _ANGLES:
        raise InputError("angles without a unit", span=span, hint="name it in the first line: rx [deg] or rx [rad]")
    return _ANGLES[word]


def placed(span: Span, read: Callable[..., Any], *arguments: Any) -> Any:
    """What `read` answers; its faults get a place."""
    try:
        return read(*arguments)
    except GcrulesError as fault:
        fault.span = fault.span or span
        raise
