r"""Poses from a table of comma-separated values, the first line naming the columns; faults have line and column.

The translation is in columns x, y, z; the turn, if any, in qw, qx, qy, qz, or in rx, ry, rz (a rotation vector), or in
roll, pitch, yaw, or in three columns such as zyx1, zyx2, zyx3 (Euler angles in the sequence zyx). Units stand in
brackets: "x [mm]" and "rx [deg]". Columns are separated by commas, semicolons or tabs; empty lines and lines that begin
with # are left out.

>>> poses, notes = read_poses("x, y, z, zyx1 [deg], zyx2 [deg], zyx3 [deg]\n0, 0, 1/2, 90, 0, 0\n")
>>> print(poses[0])
0 0 0.5; quaternion 0.7071067811865475 0 0 0.7071067811865475
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import radians

from gcrules.core.budget import watched
from gcrules.core.errors import FileError, GcrulesError, InputError, LimitReached, Span
from gcrules.core.yaml_file import read_text
from gcrules.poses.paths.columns import FORMS, Cell, Columns, placed, read_columns, read_coordinates
from gcrules.screws.pose import Pose, read_number, unit_note
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.rotations import IDENTITY, Quaternion, from_euler, from_vector

__all__ = ["MAX_BYTES", "MAX_POSES", "load_poses", "load_targets", "read_poses", "read_targets", "table_text"]

MAX_BYTES = 20_000_000
MAX_POSES = 100_000
"""A path of so many takes some half a gigabyte and 20 seconds."""


def load_poses(path: str, unit: str = "") -> tuple[tuple[Pose, ...], tuple[str, ...]]:
    """Read a file, as `read_poses`. Raises FileError where it cannot be read."""
    return read_poses(read_text(path, limit=MAX_BYTES), unit, path)


def read_poses(text: str, unit: str = "", filename: str = "<input>") -> tuple[tuple[Pose, ...], tuple[str, ...]]:
    """The poses, and notes on what was changed or left out. Lengths are in `unit`.

    Raises InputError with line and column, LimitReached for more than `MAX_POSES` poses.
    """
    lines = _lines(text)
    if not lines:
        raise FileError("there are no poses: the file is empty", filename=filename, hint=FORMS)
    sep = next((c for c in (",", ";", "\t") if c in lines[0].text), ",")
    header = _cells(lines[0], sep)
    try:
        columns, notes = read_columns(header, unit, lines[0].span)
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


def load_targets(path: str, unit: str = "") -> Sequence[Pose | dict[str, float]]:
    """The poses of a file for a robot of joints: where its columns are coordinates of the platform ("z", "roll [deg]")
    these by name, angles in rad; else as `load_poses`. Raises InputError and FileError.
    """
    return read_targets(read_text(path, limit=MAX_BYTES), unit, path)


def read_targets(text: str, unit: str = "", filename: str = "<input>") -> Sequence[Pose | dict[str, float]]:
    """The same of a text."""
    found = _by_coordinates(text, unit, filename)
    return read_poses(text, unit, filename)[0] if found is None else found


def table_text(poses: Sequence[Pose | Mapping[str, float]], unit: str = "") -> str:
    """A table of poses of one kind, which is read back; lengths are in `unit`, angles by name in rad."""
    if not poses:
        return ""
    first, bracket = poses[0], f" [{unit}]" if unit else ""
    if isinstance(first, Pose):
        header = [*(f"{n}{bracket}" for n in "xyz"), "qw", "qx", "qy", "qz"]
        rows = [[*map(float, p.translation), *p.unit_quaternion] for p in poses if isinstance(p, Pose)]
    else:
        header = [f"{n} [rad]" if n in ANGLES else f"{n}{bracket}" for n in first]
        rows = [list(p.values()) for p in poses if not isinstance(p, Pose)]
    lines = [header, *([repr(x + 0.0).removesuffix(".0") for x in row] for row in rows)]
    return "".join(f"{','.join(line)}\n" for line in lines)


def _by_coordinates(text: str, unit: str, path: str) -> list[dict[str, float]] | None:
    """None where the columns are others, or tell whole poses."""
    lines = _lines(text)
    sep = next((c for c in (",", ";", "\t") if lines and c in lines[0].text), ",")
    try:
        names = read_coordinates(_cells(lines[0], sep), unit, lines[0].span) if lines else None
        if names is None:
            return None
        if len(lines) - 1 > MAX_POSES:
            raise LimitReached(f"{len(lines) - 1:,} poses are more than {MAX_POSES:,}", hint="split the file")
        return [_coordinates(line, sep, names) for line in watched(lines[1:])]
    except GcrulesError as fault:
        raise fault.located(text, path) from None


def _coordinates(line: Cell, sep: str, names: Sequence[tuple[str, bool]]) -> dict[str, float]:
    cells = _cells(line, sep)
    if len(cells) != len(names):
        found = f"{len(cells)} values in this line, but {len(names)} columns are named"
        raise InputError(found, span=line.span)
    values = [float(placed(cell.span, _number, cell.text)) for cell in cells]
    return {n: radians(v) if degrees else v for (n, degrees), v in zip(names, values, strict=True)}


def _lines(text: str) -> list[Cell]:
    found, start = [], 0
    for line in text.split("\n"):
        if line.strip() and not line.lstrip().startswith("#"):
            found.append(Cell(line, Span(start, start + max(len(line.rstrip()), 1))))
        start += len(line) + 1
    return found


def _words(line: Cell, sep: str) -> list[str]:
    return [part.strip().strip('"').strip() for part in line.text.split(sep)]


def _cells(line: Cell, sep: str) -> list[Cell]:
    """The words with their places, which take much longer to find: for the first line, and for faults."""
    found, start = [], line.span.start
    for part, word in zip(line.text.split(sep), _words(line, sep), strict=True):
        begin = start + len(part) - len(part.lstrip())
        found.append(Cell(word, Span(begin, begin + max(len(part.strip()), 1))))
        start += len(part) + 1
    return found


def _pose(line: Cell, sep: str, columns: Columns) -> Pose:
    words = _words(line, sep)
    if len(words) != columns.width:
        found = f"{len(words)} values in this line, but {columns.width} columns are named"
        raise InputError(found, span=line.span)
    try:
        x, y, z = [_number(words[i]) for i in columns.shift] or [Fraction(0)] * 3
        numbers = [_number(words[i]) for i in columns.turn]
    except GcrulesError:
        for cell in map(_cells(line, sep).__getitem__, (*columns.shift, *columns.turn)):
            placed(cell.span, _number, cell.text)
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


def _noted(line: Cell, sep: str, columns: Columns, numbers: list[Fraction]) -> str | None:
    try:
        return unit_note(numbers)
    except GcrulesError as fault:
        fault.span = Span(_cells(line, sep)[columns.turn[0]].span.start, line.span.end)
        raise


def _number(word: str) -> Fraction:
    if not word:
        raise InputError("a value is missing")
    return read_number(word)
