r"""A pose of the platform: a translation and a turn, both exact; numbers and units as they are written.

>>> Pose(quaternion=(Fraction(1), Fraction(0), Fraction(0), Fraction(1))).angle                         # radians
1.570796...
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.floats import as_float, exact, exact_float
from gcrules.screws.rotations import IDENTITY, Matrix, Quaternion, Vector, is_rounded, rotation

__all__ = [
    "AT_ROUNDED",
    "FAR",
    "METRES",
    "NOT_FINITE",
    "NUMBER",
    "ROUNDED",
    "SILENT",
    "UNITS",
    "UNIT_TOLERANCE",
    "Pose",
    "check_unit",
    "exact",
    "exact_float",
    "read_number",
    "too_far",
    "unit_note",
]

FAR = 1e4
"""What is farther away than this many times the robot's size is refused: margins there are smaller than rounding."""

METRES = {
    "m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "in": 0.0254, "ft": 0.3048,
}  # fmt: skip
"""The units of length, and what each is in metres."""
UNITS = tuple(METRES)
"""Units of length that a file may name."""

UNIT_TOLERANCE = 1e-3
"""How far the length of a quaternion may be from 1; it is then normalised, and the answer says so."""

SILENT = 1e-9  # a length that is 1 but for rounding

NUMBER = re.compile(r"[+-]?(?:\d+(?:/\d+)?|\d*\.?\d+(?:[eE]([+-]?\d+))?|\d+\.(?:[eE]([+-]?\d+))?)")
NOT_FINITE = re.compile(r"[+-]?\.?(?:nan|inf|infinity)", re.IGNORECASE)
_MAX_NUMBER, _MAX_EXPONENT = 60, 300
_ROUNDING = 1e-15

ROUNDED = (
    "the turn is taken with about 16 digits, as few turns by angles have cosines that are rational: what is exact or "
    "proved holds for the turn as rounded"
)
AT_ROUNDED = "with the turn as rounded below, "
"""What exact answers about a pose whose turn `is_rounded` begin with, and what they say of it."""


@dataclass(frozen=True)
class Pose:
    """Where the platform is: each of its points p goes to R(p − c) + c + t, with t the `translation` (in the unit of
    the file), R the turn of `quaternion` (w, x, y, z; any length but 0) and c the centre that the robot's file is
    turned about. The identity leaves the coordinates of the file as they are. `notes` say what was changed on reading.
    """

    translation: Vector = (Fraction(0), Fraction(0), Fraction(0))
    quaternion: Quaternion = IDENTITY
    notes: tuple[str, ...] = ()

    @cached_property
    def rotation(self) -> Matrix:
        """The 3×3 matrix R, exactly orthogonal."""
        return rotation(self.quaternion)

    @property
    def exact_notes(self) -> tuple[str, ...]:
        """The notes, with that on rounding for answers that are exact."""
        return (*self.notes, ROUNDED) if is_rounded(self.quaternion) else self.notes

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
    """The numbers as they are read back, 0 for those that are rounding beside the largest."""
    floats = [float(c) for c in numbers]
    least = _ROUNDING * max(map(abs, floats))
    return " ".join(repr(c if abs(c) > least else 0.0).removesuffix(".0") for c in floats)


def unit_note(quaternion: Sequence[Fraction]) -> str | None:
    """None for a quaternion of length 1, a note if it is nearly so. Raises InputError beyond `UNIT_TOLERANCE`."""
    size = math.sqrt(as_float(sum((c * c for c in quaternion), Fraction(0))))
    if abs(size - 1) > UNIT_TOLERANCE:
        raise InputError(
            f"the quaternion has length {size:.6g}, expected 1 (within {UNIT_TOLERANCE:g})",
            hint="divide by the length; the order is w x y z, w the cosine of half the angle",
        )
    return None if abs(size - 1) <= SILENT else f"the quaternion has length {size:.9g}; it has been normalised"


def too_far(what: str) -> InputError:
    """What to raise where `what` (with its verb) is farther away than `FAR`."""
    return InputError(f"{what} more than {FAR:,.0f} times the robot's size away", hint="check the unit")


def check_unit(word: str, unit: str) -> None:
    """Raises InputError unless a unit of length is that of the robot."""
    if word not in UNITS:
        raise InputError(f"{word[:20]!r} is not a unit of length", hint=f"units are {', '.join(UNITS)}")
    if word != unit:
        whose = f"the robot is given in {unit}" if unit else "the robot's file names no unit"
        raise InputError(f"mixed units: {word} here, but {whose}", hint=f"give lengths in {unit or 'its unit'}")


def read_number(word: str) -> Fraction:
    """A finite number, exact as written: 3, -0.25, 1e-3 or 1/3. Raises InputError for anything else."""
    shown = word if len(word) <= 40 else word[:40] + "…"
    match = NUMBER.fullmatch(word)
    if match is None:
        if NOT_FINITE.fullmatch(word):
            raise InputError(f"expected a finite number, found {shown}")
        raise InputError(f"expected a number, found {shown!r}", hint="numbers are written 3, -0.25, 1e-3 or 1/3")
    if len(word) > _MAX_NUMBER or abs(int(match[1] or match[2] or 0)) > _MAX_EXPONENT:
        raise InputError(f"this number is too long (at most {_MAX_NUMBER} signs, exponents up to {_MAX_EXPONENT})")
    whole, point, decimals = word.partition(".")
    if point and "e" not in word.lower():
        return Fraction(int(whole + decimals), 10 ** len(decimals))  # the same, several times as fast
    try:
        return Fraction(word)
    except ZeroDivisionError:
        raise InputError(f"division by zero in {shown}") from None
