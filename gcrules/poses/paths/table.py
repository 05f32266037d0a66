r"""Poses from a table of comma-separated values, the first line naming the columns; faults have line and column.

The translation is in columns x, y, z; the turn, if any, in qw, qx, qy, qz, or in rx, ry, rz (a rotation vector), or in
three columns such as zyx1, zyx2, zyx3 (Euler angles in the sequence zyx). Units stand in brackets: "x [mm]" and
"rx [deg]". Columns are separated by commas, semicolons or tabs; empty lines and lines that begin with # are left out.

>>> poses, notes = read_poses("x, y, z, zyx1 [deg], zyx2 [deg], zyx3 [deg]\n0, 0, 1/2, 90, 0, 0\n")
>>> print(poses[0])
0 0 0.5; quaternion 0.7071067811865475 0 0 0.7071067811865475
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gcrules.core.budget import watched
from gcrules.core.errors import FileError, GcrulesError, InputError, LimitReached, Span
from gcrules.core.yaml_file import read_text
from gcrules.screws.pose import Pose, check_unit, read_number, unit_note
from gcrules.screws.rotations import IDENTITY, Quaternion, check_sequence, from_euler, from_vector

__all__ = ["MAX_BYTES", "MAX_POSES", "load_poses", "read_poses"]

MAX_BYTES = 20_000_000
MAX_POSES = 100_000
"""A path of so many takes some half a gigabyte and 20 seconds."""

_HEADER = re.compile(r"([^\s\[\]]*)\s*(?:\[\s*([^\[\]]*?)\s*\])?")
_EULER = re.compile(r"([xyz]{3}|[XYZ]{3})([123])")
_ANGLES = {"deg": True, "°": True, "rad": False}
_SHIFT = ("x", "y", "z")
_QUATERNION = ("qw", "qx", "qy", "qz")
_VECTOR = ("rx", "ry", "rz")
_FORMS = "columns x, y, z, then qw, qx, qy, qz or rx [deg], ry [deg], rz [deg] or zyx1 [deg], zyx2 [deg], zyx3 [deg]"


@dataclass(frozen=True)
class _Cell:
    """A cell with its place in the text."""

    text: str
    span: Span


@dataclass(frozen=True)
class _Columns:
    """Where the numbers of a pose stand: the turn is of one `kind` (none | quaternion | vector | a sequence)."""

    width: int
    shift: tuple[int, ...]
    kind: str
    turn: tuple[int, ...]
    degrees: bool


def load_poses(path: str, unit: str = "") -> tuple[tuple[Pose, ...], tuple[str, ...]]:
    """Read a file, as `read_poses`. Raises FileError where it cannot be read."""
    return read_poses(read_text(path, limit=MAX_BYTES), unit, path)


def read_poses(text: str, unit: str = "", filename: str = "<input>") -> tuple[tuple[Pose, ...], tuple[str, ...]]:
    """The poses, and notes on what was changed or left out. Lengths are in `unit`.

    Raises InputError with line and column, LimitReached for more than `MAX_POSES` poses.
    """
    lines = _lines(text)
    if not lines:
        raise FileError("there are no poses: the file is empty", filename=filename, hint=_FORMS)
    sep = next((c for c in (",", ";", "\t") if c in lines[0].text), ",")
    header = _cells(lines[0], sep)
    try:
        columns, notes = _columns(header, unit, lines[0].span)
        if len(lines) - 1 > MAX_POSES:
            raise LimitReached(
                f"{len(lines) - 1:,} poses are more than {MAX_POSES:,}", hint="split the file; each part is a path"
            )
        poses = tuple(_pose(line, sep, columns) for line in watched(lines[1:]))
    except GcrulesError as fault:
        raise fault.located(text, filename) from None
    if not poses:
        raise FileError("there are no poses below the line that names the columns", filename=filename)
    changed = sum(bool(p.notes) for p in poses)
    if changed:
        notes = (*notes, f"quaternions normalised: {changed}")
    return poses, notes


def _lines(text: str) -> list[_Cell]:
    found, start = [], 0
    for line in text.split("\n"):
        if line.strip() and not line.lstrip().startswith("#"):
            found.append(_Cell(line, Span(start, start + max(len(line.rstrip()), 1))))
        start += len(line) + 1
    return found


def _words(line: _Cell, sep: str) -> list[str]:
    return [part.strip().strip('"').strip() for part in line.text.split(sep)]


def _cells(line: _Cell, sep: str) -> list[_Cell]:
    """The words with their places, which take much longer to find: for the first line, and for faults."""
    found, start = [], line.span.start
    for part, word in zip(line.text.split(sep), _words(line, sep), strict=True):
        begin = start + len(part) - len(part.lstrip())
        found.append(_Cell(word, Span(begin, begin + max(len(part.strip()), 1))))
        start += len(part) + 1
    return found


def _columns(header: list[_Cell], unit: str, line: Span) -> tuple[_Columns, tuple[str, ...]]:
    names: dict[str, int] = {}
    units: dict[str, tuple[str | None, Span]] = {}
    for i, cell in enumerate(header):
        match = _HEADER.fullmatch(cell.text)
        name = match[1] if match else cell.text
        if name in names and name:
            raise InputError(f"a second column {name[:40]}", span=cell.span)
        names[name] = i
        units[name] = (match[2] if match else None, cell.span)
    if not set(names) & {*_SHIFT, *_QUATERNION, *_VECTOR} and not any(map(_EULER.fullmatch, names)):
        raise InputError("the first line names no columns of poses", span=line, hint=_FORMS)
    sequences = dict.fromkeys(m[1] for n in names if (m := _EULER.fullmatch(n)))
    kinds: dict[str, tuple[str, ...]] = {"none": (), "quaternion": _QUATERNION, "vector": _VECTOR}
    kinds |= {s: tuple(f"{s}{i}" for i in (1, 2, 3)) for s in sequences}
    for sequence in sequences:
        _at(units[_first(kinds[sequence], names)][1], check_sequence, sequence)
    given = [kind for kind, wanted in kinds.items() if set(wanted) & set(names)]
    if len(given) > 1:
        raise InputError("several kinds of turns", span=units[_first(kinds[given[1]], names)][1], hint=_FORMS)
    kind = given[0] if given else "none"
    if not set(_SHIFT) & set(names):
        shift: tuple[int, ...] = ()
    else:
        shift = _indices(_SHIFT, names, line)
        for name in _SHIFT:
            word, span = units[name]
            if word is not None:
                _at(span, check_unit, word, unit)
    turn = _indices(kinds[kind], names, line)
    degrees = {_angle(*units[name]) for name in kinds[kind]} if kind not in ("none", "quaternion") else {False}
    if len(degrees) > 1:
        raise InputError("deg and rad in one set of angles", span=units[kinds[kind][0]][1])
    used = {*shift, *turn}
    left = [c.text for i, c in enumerate(header) if i not in used and c.text]
    notes = (f"columns left out: {', '.join(left)[:200]}",) if left else ()
    return _Columns(len(header), shift, kind, turn, degrees.pop()), notes


def _first(wanted: tuple[str, ...], names: Mapping[str, int]) -> str:
    return next(n for n in wanted if n in names)


def _indices(wanted: tuple[str, ...], names: Mapping[str, int], line: Span) -> tuple[int, ...]:
    missing = [n for n in wanted if n not in names]
    if missing:
        raise InputError(f"the column{'s' * (len(missing) > 1)} {', '.join(missing)} missing", span=line, hint=_FORMS)
    return tuple(names[n] for n in wanted)


def _angle(word: str | None, span: Span) -> bool:
    if word not in _ANGLES:
        raise InputError("angles without a unit", span=span, hint="name it in the first line: rx [deg] or rx [rad]")
    return _ANGLES[word]


def _pose(line: _Cell, sep: str, columns: _Columns) -> Pose:
    words = _words(line, sep)
    if len(words) != columns.width:
        found = f"{len(words)} values in this line, but {columns.width} columns are named"
        raise InputError(found, span=line.span)
    try:
        x, y, z = [_number(words[i]) for i in columns.shift] or [Fraction(0)] * 3
        numbers = [_number(words[i]) for i in columns.turn]
    except GcrulesError:
        for cell in map(_cells(line, sep).__getitem__, (*columns.shift, *columns.turn)):
            _at(cell.span, _number, cell.text)
        raise
    turn: Quaternion = IDENTITY
    note = None
    if columns.kind == "quaternion":
        w, a, b, c = numbers
        turn = w, a, b, c
        note = _noted(line, sep, columns, numbers)
    elif columns.kind == "vector":
        turn = from_vector(numbers, degrees=columns.degrees)
    elif columns.kind != "none":
        turn = from_euler(columns.kind, numbers, degrees=columns.degrees)
    return Pose((x, y, z), turn, (note,) if note else ())


def _noted(line: _Cell, sep: str, columns: _Columns, numbers: list[Fraction]) -> str | None:
    try:
        return unit_note(numbers)
    except GcrulesError as fault:
        fault.span = Span(_cells(line, sep)[columns.turn[0]].span.start, line.span.end)
        raise


def _number(word: str) -> Fraction:
    if not word:
        raise InputError("a value is missing")
    return read_number(word)


def _at(span: Span, read: Callable[..., Any], *arguments: Any) -> Any:
    """What `read` answers; its faults get a place."""
    try:
        return read(*arguments)
    except GcrulesError as fault:
        fault.span = fault.span or span
        raise
