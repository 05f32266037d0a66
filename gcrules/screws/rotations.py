r"""Turns as exact quaternions: every rational quaternion q ≠ 0 is an exactly orthogonal rational matrix.

The matrix of q = (w, x, y, z) is N(q) / |q|², with N(q) made of the products of two components, so no root is drawn and
the length of q does not matter. That keeps superbrackets exact in turned poses.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, TypeVar

from gcrules.core.errors import InputError

__all__ = [
    "IDENTITY",
    "MANY",
    "Matrix",
    "Quaternion",
    "about_axis",
    "check_sequence",
    "from_euler",
    "from_vector",
    "is_rounded",
    "product",
    "rotation",
    "short",
    "too_many_turns",
    "unscaled",
]

Quaternion = tuple[Fraction, Fraction, Fraction, Fraction]
Vector = tuple[Fraction, Fraction, Fraction]
Matrix = tuple[Vector, Vector, Vector]

IDENTITY: Quaternion = (Fraction(1), Fraction(0), Fraction(0), Fraction(0))

_N = TypeVar("_N", int, Fraction)

MANY = 10**9  # the largest angle, in degrees or radians: of more a float leaves no digits within one turn
_EXACT = 40  # bits of a denominator above which a number is taken for a rounded one
_LONG = 64  # bits of a denominator above which a quaternion is rounded to floats (error below 2⁻⁵² of its length)


def product(p: tuple[_N, _N, _N, _N], q: tuple[_N, _N, _N, _N]) -> tuple[_N, _N, _N, _N]:
    """The turn q followed by the turn p; their components are all fractions or all whole."""
    a, b, c, d = p
    w, x, y, z = q
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def rotation(q: Quaternion) -> Matrix:
    """The matrix of a quaternion (w, x, y, z) of any length other than 0, exactly orthogonal."""
    n = sum(c * c for c in q)
    first, second, third = ((a / n, b / n, c / n) for a, b, c in unscaled(q))
    return first, second, third


def unscaled(q: Sequence[Any]) -> tuple[tuple[Any, Any, Any], ...]:
    """|q|² times the matrix of a quaternion, whose components may be of any ring."""
    w, x, y, z = q
    return (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )


def about_axis(axis: int, angle: Fraction, *, degrees: bool) -> Quaternion:
    """The turn by an angle about a coordinate axis 0, 1 or 2; exact for multiples of 90 degrees."""
    cosine, sine, common = _half(angle, degrees)
    part = Fraction(sine, common)
    return (Fraction(cosine, common), *(part if i == axis else Fraction(0) for i in range(3)))  # type: ignore[return-value]


def _half(angle: Fraction, degrees: bool) -> tuple[int, int, int]:
    """The cosine and the sine of half an angle, and the number that both are to be divided by; whole."""
    if degrees and angle.denominator == 1 and not angle.numerator % 90:
        return *((1, 0), (1, 1), (0, 1), (-1, 1))[angle.numerator // 90 % 4], 1  # up to a common factor
    if abs(angle) > MANY:
        raise too_many_turns()
    number = float(angle)
    if degrees and abs(number) >= 360:
        number = float(angle - 720 * round(angle / 720))  # opposite angles stay so: their turns cancel exactly
    half = math.radians(number) / 2 if degrees else number / 2
    (cosine, below), (sine, beneath) = math.cos(half).as_integer_ratio(), math.sin(half).as_integer_ratio()
    common = max(below, beneath)  # powers of 2
    return cosine * (common // below), sine * (common // beneath), common


def too_many_turns() -> InputError:
    """The fault of an angle of which a float does not know where it ends."""
    return InputError(f"an angle is larger than {MANY:g}", hint="give the turn without whole revolutions")


def check_sequence(sequence: str) -> None:
    """Raises InputError for anything but three letters x, y, z of one case, neighbours different."""
    letters = sequence.lower()
    proper = len(letters) == 3 and set(letters) <= set("xyz") and letters[0] != letters[1] != letters[2]
    if not proper or sequence not in (letters, letters.upper()):
        raise InputError(
            f"{sequence[:20]!r} is not a sequence of Euler angles",
            hint="three axes, neighbours different: zyx about fixed axes, ZYX about the axes that turn along",
        )


def from_euler(sequence: str, angles: Sequence[Fraction], *, degrees: bool) -> Quaternion:
    """Three turns about coordinate axes. "xyz": about the fixed axes, x first; "XYZ": about the axes of the platform
    as they have turned, X first (so "XYZ" is "zyx" with the angles reversed). Exact where all angles are multiples of
    90 degrees, and where the second one makes them one turn by such an angle; otherwise rounded (see `is_rounded`).

    Raises InputError as `check_sequence` does.
    """
    check_sequence(sequence)
    if degrees and (together := _about_one_axis(sequence, angles)):
        return together
    common, turns = 1, []  # in whole numbers, which are several times as fast as fractions
    for letter, angle in zip(sequence.lower(), angles, strict=True):
        cosine, sine, divisor = _half(angle, degrees)
        x, y, z = (sine if letter == axis else 0 for axis in "xyz")
        turns.append((cosine, x, y, z))
        common *= divisor
    if sequence.isupper():
        turns.reverse()
    w, x, y, z = product(turns[2], product(turns[1], turns[0]))
    return short((Fraction(w, common), Fraction(x, common), Fraction(y, common), Fraction(z, common)))


def _about_one_axis(sequence: str, angles: Sequence[Fraction]) -> Quaternion | None:
    """The turn where the second angle, a multiple of 90 degrees, makes the first and the third axis parallel: these two
    are one turn by the sum or the difference of their angles, which may be exact where each of them is not.
    """
    first, second, third = angles
    if second.denominator != 1 or second.numerator % 90 or not (first and third):
        return None
    turns = sequence if sequence.islower() else sequence[::-1].lower()
    before, between, after = ("xyz".index(letter) for letter in turns)
    if sequence.isupper():
        first, third = third, first
    middle = about_axis(between, second, degrees=True)
    sign = rotation(middle)[after][before]
    if not sign:
        return None
    return short(product(about_axis(after, third + sign * first, degrees=True), middle))


def from_vector(vector: Sequence[Fraction], *, degrees: bool) -> Quaternion:
    """The turn about a vector by its length as the angle; exact about a coordinate axis by multiples of 90 degrees."""
    along = [i for i, c in enumerate(vector) if c]
    if not along:
        return IDENTITY
    if len(along) == 1:
        return short(about_axis(along[0], vector[along[0]], degrees=degrees))
    if max(map(abs, vector)) > MANY:
        raise too_many_turns()
    size = math.hypot(*map(float, vector))
    if not size:
        return IDENTITY  # too short for floats
    half = math.fmod(math.radians(size) if degrees else size, 4 * math.pi) / 2
    sine = math.sin(half) / size
    return Fraction(math.cos(half)), *(Fraction(float(c) * sine) for c in vector)  # type: ignore[return-value]


def is_rounded(turn: Iterable[Fraction]) -> bool:
    """Whether numbers of a turn are so long that they are the first digits of others, as those of most turns by angles
    are.
    """
    return any(c.denominator.bit_length() > _EXACT for c in turn)


def short(q: Quaternion) -> Quaternion:
    """The quaternion itself, or rounded to floats if its numbers are long (error below 2⁻⁵² of its length)."""
    if max(c.denominator.bit_length() for c in q) <= _LONG:
        return q
    w, x, y, z = (Fraction(*float(c).as_integer_ratio()) for c in q)
    return w, x, y, z
