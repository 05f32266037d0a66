r"""A pose of the platform: a translation and a turn, both exact, and the text that says them.

>>> p = parse_pose("10, 0, -5 mm; euler zyx 90 0 0 deg", "mm")
>>> [str(c) for c in p.translation], [str(c) for c in p.quaternion]
(['10', '0', '-5'], ['1', '0', '0', '1'])
>>> p.angle                                                            # radians
1.570796...
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.floats import as_float, exact, exact_float
from gcrules.core.hints import near
from gcrules.screws.rotations import (
    IDENTITY,
    Matrix,
    Quaternion,
    Vector,
    check_sequence,
    from_euler,
    from_vector,
    rotation,
)

__all__ = [
    "SILENT",
    "UNITS",
    "UNIT_TOLERANCE",
    "Pose",
    "exact",
    "exact_float",
    "parse_pose",
    "read_number",
    "unit_note",
]

UNITS = ("m", "dm", "cm", "mm", "um", "in", "ft")
"""Of lengths, in files and behind numbers."""

UNIT_TOLERANCE = 1e-3
"""How far the length of a quaternion may be from 1; it is then normalised, and the answer says so."""

SILENT = 1e-9  # a length that is 1 but for rounding

_NUMBER = re.compile(r"[+-]?(?:\d+(?:/\d+)?|\d*\.?\d+(?:[eE]([+-]?\d+))?|\d+\.(?:[eE]([+-]?\d+))?)")
_NOT_FINITE = re.compile(r"[+-]?\.?(?:nan|inf|infinity)", re.IGNORECASE)
_MAX_NUMBER, _MAX_EXPONENT = 60, 300
_ANGLES = {"deg": True, "degree": True, "degrees": True, "°": True, "rad": False, "radian": False, "radians": False}
_TURNS = {"quaternion": 4, "rotation-vector": 3, "euler": 3}
_SHORT = {"quat": "quaternion", "rotvec": "rotation-vector", "t": "translation", "at": "translation"}
_FORMS = 'write "x y z", then if need be "; quaternion w x y z", "; rotation-vector x y z rad", "; euler zyx a b c deg"'


@dataclass(frozen=True)
class Pose:
    """Where the platform is: each of its points p goes to R(p − c) + c + t, with t the `translation` (in the unit of
    the file), R the turn of `quaternion` (w, x, y, z; any length but 0) and c the centre that the robot's file is
    turned about. The identity leaves the coordinates of the file as they are. `notes` say what was changed on reading.
    """

    translation: Vector = (Fraction(0), Fraction(0), Fraction(0))
    quaternion: Quaternion = IDENTITY
    notes: tuple[str, ...] = ()

    @property
    def rotation(self) -> Matrix:
        """The 3×3 matrix R, exactly orthogonal."""
        return rotation(self.quaternion)

    @property
    def unit_quaternion(self) -> tuple[float, ...]:
        """The quaternion (w, x, y, z) of length 1 with its first component other than 0 positive, in floats."""
        size = math.sqrt(sum(c * c for c in self.quaternion))
        sign = next(1 if c > 0 else -1 for c in self.quaternion if c)
        return tuple(sign * float(c) / size for c in self.quaternion)

    @property
    def angle(self) -> float:
        """How far R turns, in radians from 0 to π."""
        w, x, y, z = map(float, self.quaternion)
        return 2 * math.atan2(math.hypot(x, y, z), abs(w))

    @property
    def rotation_vector(self) -> tuple[float, float, float]:
        """The axis of R times its angle, in radians."""
        _, x, y, z = self.unit_quaternion
        size = math.hypot(x, y, z)
        factor = self.angle / size if size else 0.0
        return x * factor, y * factor, z * factor

    def to_json(self) -> dict[str, Any]:
        """Translation (in the file's unit), unit quaternion (w, x, y, z), rotation vector (rad), in floats."""
        return {
            "translation": [float(c) for c in self.translation],
            "quaternion": list(self.unit_quaternion),
            "rotation_vector": list(self.rotation_vector),
        }

    def text(self) -> str:
        """Text that `parse_pose` takes."""
        return f"{_plain(self.translation)}; quaternion {_plain(self.unit_quaternion)}"

    def __str__(self) -> str:
        return self.text()


def _plain(numbers: Sequence[Fraction | float]) -> str:
    return " ".join(repr(float(c) + 0.0).removesuffix(".0") for c in numbers)


def unit_note(quaternion: Sequence[Fraction]) -> str | None:
    """None for a quaternion of length 1, a note if it is nearly so. Raises InputError beyond `UNIT_TOLERANCE`."""
    size = math.sqrt(as_float(sum((c * c for c in quaternion), Fraction(0))))
    if abs(size - 1) > UNIT_TOLERANCE:
        raise InputError(
            f"the quaternion has length {size:.6g}, expected 1 (within {UNIT_TOLERANCE:g})",
            hint="divide by the length; the order is w x y z, w the cosine of half the angle",
        )
    return None if abs(size - 1) <= SILENT else f"the quaternion has length {size:.9g}; it was normalised"


def parse_pose(text: str, unit: str = "") -> Pose:
    """Read "x y z; quaternion w x y z" and the like; parts are separated by ";", numbers by blanks or commas.

    `unit` is the unit of length of the robot. A translation may name its unit, which must be that one; angles must say
    deg or rad. The turn is one of `quaternion w x y z` (or `quaternion xyzw x y z w`), `rotation-vector x y z rad` and
    `euler SEQUENCE a b c deg` (see `from_euler`). Raises InputError with the place.
    """
    found: dict[str, tuple[Any, ...]] = {}
    start = 0
    for part in text.split(";"):
        span = Span(start + len(part) - len(part.lstrip()), start + max(len(part.rstrip()), 1))
        start += len(part) + 1
        if not part.replace(",", " ").strip():
            continue
        try:
            key, value = _part(part.replace(",", " ").split(), unit)
            kind = "translation" if key == "translation" else "turn"
            if kind in found:
                raise InputError(f"a second {kind}", hint="a pose has one translation and one turn")
            found[kind] = value
        except GcrulesError as fault:
            raise fault.located(text, "--at", span) from None
    if not found:
        raise InputError("the pose is empty", hint=_FORMS)
    quaternion, *notes = found.get("turn", (IDENTITY,))
    return Pose(found.get("translation", (Fraction(0),) * 3), quaternion, tuple(notes))


def _part(words: list[str], unit: str) -> tuple[str, tuple[Any, ...]]:
    key = "translation"
    if not _NUMBER.fullmatch(words[0]) and not _NOT_FINITE.fullmatch(words[0]):
        key, words = _SHORT.get(words[0].lower(), words[0].lower()), words[1:]
    if key == "translation":
        if len(words) == 4:
            check_unit(words.pop(), unit)
        return key, tuple(_numbers(words, 3, "a translation"))
    if key == "quaternion":
        order = words.pop(0) if words and words[0] in ("wxyz", "xyzw") else "wxyz"
        q = _numbers(words, 4, "a quaternion")
        q = q if order == "wxyz" else [q[3], *q[:3]]
        note = unit_note(q)
        return key, (tuple(q), *([note] if note else []))
    if key == "rotation-vector":
        degrees = _angle_unit(words)
        return key, (from_vector(_numbers(words, 3, "a rotation vector"), degrees=degrees),)
    if key == "euler":
        if not words:
            raise InputError("Euler angles without their sequence", hint=_FORMS)
        sequence, words = words[0], words[1:]
        check_sequence(sequence)
        degrees = _angle_unit(words)
        return key, (from_euler(sequence, _numbers(words, 3, "a set of Euler angles"), degrees=degrees),)
    named = f"{_FORMS}; coordinates by their names are for robots that are described by their joints"
    hint = named if "=" in key else near(key, (*_TURNS, "translation")) or _FORMS
    raise InputError(f"{key[:40]!r} is no part of a pose", hint=hint)


def check_unit(word: str, unit: str) -> None:
    """Raises InputError unless a unit of length is that of the robot."""
    if word not in UNITS:
        raise InputError(f"{word[:20]!r} is no unit of length", hint=f"units are {', '.join(UNITS)}")
    if word != unit:
        whose = f"the robot is given in {unit}" if unit else "the robot's file names no unit"
        raise InputError(f"mixed units: {word} here, but {whose}", hint=f"give lengths in {unit or 'its unit'}")


def _angle_unit(words: list[str]) -> bool:
    """Takes the unit of angles off the end; True for degrees."""
    if words and words[-1].lower() in _ANGLES:
        return _ANGLES[words.pop().lower()]
    raise InputError("angles without a unit", hint="end with deg or rad: euler zyx 10 0 0 deg")


def _numbers(words: list[str], length: int, what: str) -> list[Fraction]:
    numbers = [read_number(word) for word in words]
    if len(numbers) != length:
        raise InputError(f"{what} has {length} numbers, found {len(numbers)}", hint=_FORMS)
    return numbers


def read_number(word: str) -> Fraction:
    """A finite number, exact as written: 3, -0.25, 1e-3 or 1/3. Raises InputError for anything else."""
    shown = word if len(word) <= 40 else word[:40] + "…"
    match = _NUMBER.fullmatch(word)
    if match is None:
        if _NOT_FINITE.fullmatch(word):
            raise InputError(f"expected a finite number, found {shown}")
        raise InputError(f"expected a number, found {shown!r}", hint="numbers are written 3, -0.25, 1e-3 or 1/3")
    if len(word) > _MAX_NUMBER or abs(int(match[1] or match[2] or 0)) > _MAX_EXPONENT:
        raise InputError(f"this number is too long (at most {_MAX_NUMBER} signs, exponents up to {_MAX_EXPONENT})")
    try:
        return Fraction(word)
    except ZeroDivisionError:
        raise InputError(f"division by zero in {shown}") from None
