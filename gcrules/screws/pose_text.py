r"""Poses as they are written, for every mechanism alike: coordinates by their names, or a whole pose.

>>> p = parse_pose("10, 0, -5 mm; euler zyx 90 0 0 deg", "mm")
>>> [str(c) for c in p.translation], [str(c) for c in p.quaternion]
(['10', '0', '-5'], ['1', '0', '0', '1'])
>>> parse_pose("x=10, z=-5 mm, yaw=90deg", "mm") == p
True
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.english import with_article
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.screws.pose import NOT_FINITE, NUMBER, Pose, check_unit, exact, read_number, unit_note
from gcrules.screws.rotations import IDENTITY, MANY, Vector, check_sequence, from_euler, from_vector, too_many_turns

__all__ = [
    "ANGLES",
    "COORDINATES",
    "HOME",
    "SHIFTS",
    "TURNS",
    "VECTOR",
    "Amount",
    "WrittenTurn",
    "check_known",
    "check_one_turn",
    "parse_pose",
    "pose_of",
    "read_centre",
    "read_named",
    "written_turn",
]

HOME = "home"
"""The pose in which the file has the robot."""

SHIFTS = ("x", "y", "z")
TURNS = ("roll", "pitch", "yaw")
VECTOR = ("rx", "ry", "rz")
ANGLES = frozenset((*TURNS, *VECTOR))
COORDINATES = (*SHIFTS, *TURNS, *VECTOR)
"""`x`, `y`, `z` shift the centre of the platform; `roll`, `pitch`, `yaw` turn it about the fixed axes x, then y, then
z; `rx`, `ry`, `rz` are the rotation vector. All are from the pose of the file, where they are 0."""

_ANGLES = {"deg": True, "degree": True, "degrees": True, "°": True, "rad": False, "radian": False, "radians": False}
_KINDS = ("quaternion", "rotation-vector", "euler")
_SHORT = {"quat": "quaternion", "rotvec": "rotation-vector", "t": "translation", "at": "translation"}
_FORMS = (
    'write "z=5, roll=10deg"; or "x y z", then if need be "; quaternion w x y z", "; rotation-vector x y z rad",'
    ' "; euler zyx a b c deg"'
)
_PART = re.compile(r"\s*([A-Za-z]\w*)\s*=\s*(.*?)\s*")
_LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ°"
_NAMED = "write z=0.2, roll=5deg"


@dataclass(frozen=True)
class Amount:
    """A number as it was written: of a length, of degrees or of radians."""

    number: Fraction
    degrees: bool = False

    def __float__(self) -> float:
        """The length, or the angle in radians."""
        return float(self.number) * (math.pi / 180 if self.degrees else 1.0)


def parse_pose(text: str, unit: str = "", option: str = "--at") -> Pose:
    """Read coordinates by their names, "z=5, roll=10deg", those that are not named being 0; or a whole pose,
    "x y z; quaternion w x y z" and the like, its parts separated by ";", numbers by blanks or commas.

    "home" is the pose of the file. `unit` is the unit of length of the robot. Lengths may name their unit, which must
    be that one; angles must say deg or rad. The turn of a whole pose is one of `quaternion w x y z` (or `quaternion
    xyzw x y z w`), `rotation-vector x y z rad` and `euler SEQUENCE a b c deg` (see `from_euler`). Raises InputError
    with the place, in `option`.
    """
    if text.strip().lower() == HOME:
        return Pose()
    if "=" in text:
        return pose_of(read_named(text, dict.fromkeys(COORDINATES, False) | dict.fromkeys(ANGLES, True), unit, option))
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
            raise fault.located(text, option, span) from None
    if not found:
        raise InputError("the pose is empty", hint=_FORMS)
    quaternion, *notes = found.get("turn", (IDENTITY,))
    return Pose(found.get("translation", (Fraction(0),) * 3), quaternion, tuple(notes))


def _part(words: list[str], unit: str) -> tuple[str, tuple[Any, ...]]:
    key = "translation"
    if not NUMBER.fullmatch(words[0]) and not NOT_FINITE.fullmatch(words[0]):
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
    raise InputError(f"{key[:40]!r} is not a part of a pose", hint=near(key, (*_KINDS, "translation")) or _FORMS)


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


@dataclass(frozen=True)
class WrittenTurn:
    """A turn by `angles`, as it is written, "euler zyx 30 20 10 deg". Its `kind` is a sequence of Euler angles, or
    "vector", of the rotation vector.
    """

    words: str
    kind: str
    angles: tuple[Amount, Amount, Amount]

    def in_kind(self, kind: str) -> tuple[Amount, ...]:
        """The angles of this kind: its own, or backwards those of the sequence about the other axes, fixed or turned
        along, which is the same turn; else none.
        """
        if self.kind == kind:
            return self.angles
        return self.angles[::-1] if self.kind == kind.swapcase()[::-1] else ()


def written_turn(text: str, unit: str = "") -> WrittenTurn | None:
    """The angles by which a pose that `parse_pose` takes says its turn; None where it says it otherwise, or not."""
    if "=" in text:
        given = read_named(text, dict.fromkeys(COORDINATES, False) | dict.fromkeys(ANGLES, True), unit)
        parts = [part.strip() for part in re.split(r"[,;]", text)]
        words = ", ".join(part for part in parts if part.partition("=")[0].strip() in ANGLES)
        kind, names = ("vector", VECTOR) if any(n in VECTOR for n in given) else ("xyz", TURNS)
        x, y, z = (given.get(n, Amount(Fraction(0))) for n in names)
        return WrittenTurn(words, kind, (x, y, z)) if words else None
    for part in text.split(";"):
        key, *words_of_it = part.replace(",", " ").split() or [""]
        key = _SHORT.get(key.lower(), key.lower())
        if key in ("euler", "rotation-vector"):
            kind = words_of_it.pop(0) if key == "euler" else "vector"
            degrees = _angle_unit(words_of_it)
            x, y, z = (Amount(read_number(n), degrees) for n in words_of_it)
            return WrittenTurn(" ".join(part.split()), kind, (x, y, z))
    return None


# --- coordinates by their names ------------------------------------------------------------------------------------


def read_named(
    text: str, angles: Mapping[str, bool], unit: str = "", option: str = "--at", what: str = "coordinate of a pose"
) -> dict[str, Amount]:
    """The amounts that a text gives to names, "z=0.2, roll=5deg"; `angles` tells of each name that may stand there
    whether it is an angle. Raises InputError with the place.
    """
    found: dict[str, Amount] = {}
    start = 0
    for part in re.split(r"[,;]", text):
        span = Span(start + len(part) - len(part.lstrip()), start + max(len(part.rstrip()), 1))
        start += len(part) + 1
        if not part.strip():
            continue
        try:
            match = _PART.fullmatch(part)
            if match is None:
                raise InputError(f"{part.strip()[:40]!r} gives no value to a name", hint=_NAMED)
            name, value = match.groups()
            if "=" in value:
                raise InputError("two values without a comma between them", hint=_NAMED)
            check_known((name,), tuple(angles), what)
            if name in found:
                raise InputError(f"{name} is given twice")
            found[name] = _amount(value, name, angles[name], unit)
        except GcrulesError as fault:
            raise fault.located(text, option, span) from None
    if not found:
        raise InputError("no values are given", hint=_NAMED)
    return found


def _amount(text: str, name: str, angle: bool, unit: str) -> Amount:
    word = text[len(text.rstrip(_LETTERS)) :]
    word = "" if NOT_FINITE.fullmatch(word) else word
    number = text.removesuffix(word).strip()
    value = read_number(number)
    if not angle:
        if word.lower() in _ANGLES:
            raise InputError(f"{name} is a length, and {word} is a unit of angles", hint=f"write {name}={number}")
        if word:
            check_unit(word, unit)
        return Amount(value)
    if not word:
        raise InputError(f"{name} is an angle without a unit", hint=f"write {name}={number}deg or {name}={number}rad")
    if word.lower() not in _ANGLES:
        raise InputError(f"{word[:20]!r} is not a unit of angle", hint=f"write {name}={number}deg or rad")
    return Amount(value, _ANGLES[word.lower()])


def check_known(given: Collection[Any], names: Sequence[str], what: str, listed: str = "") -> None:
    """Raises InputError for the first that is not among the names."""
    for name in given:
        if name not in names:
            hint = near(str(name), names) or f"there are {listed or ', '.join(names)}"
            raise InputError(f"{str(name)[:40]!r} is not {with_article(what)}", hint=hint)


def check_one_turn(names: Collection[str]) -> None:
    """Raises InputError for coordinates of both kinds of turns."""
    if any(n in TURNS for n in names) and any(n in VECTOR for n in names):
        raise InputError("roll, pitch, yaw and rx, ry, rz are two ways to say one turn", hint="take one of them")


def pose_of(given: Mapping[str, Any], *, degrees: bool = False) -> Pose:
    """The whole pose with these coordinates, 0 where none is given: `Amount`s, or numbers, of angles in radians unless
    `degrees`. Raises InputError for other names, and for turns said in two ways.
    """
    check_known(given, COORDINATES, "coordinate of a pose")
    check_one_turn(given)
    amounts = {
        n: v if isinstance(v, Amount) else Amount(exact(v, n), degrees and n in ANGLES) for n, v in given.items()
    }
    x, y, z = (amounts.get(n, Amount(Fraction(0))).number for n in SHIFTS)
    kind = VECTOR if any(n in VECTOR for n in given) else TURNS
    angles = [amounts.get(n, Amount(Fraction(0))) for n in kind]
    if any(abs(a.number) > MANY for a in angles):
        raise too_many_turns()
    in_degrees = all(a.degrees or not a.number for a in angles)  # of degrees beside radians radians are made
    numbers = [a.number if in_degrees else Fraction(float(a)) for a in angles]
    turn = (
        from_vector(numbers, degrees=in_degrees) if kind is VECTOR else from_euler("xyz", numbers, degrees=in_degrees)
    )
    return Pose((x, y, z), turn)


def read_centre(about: str | Sequence[Any], centroid: Vector, unit: str = "") -> Vector:
    """What poses turn about: the "centroid" of the platform's joints, which is known, the "origin", or a point "x, y,
    z". Raises InputError for anything else.
    """
    if not isinstance(about, str):
        words = [exact(c, "the centre") for c in about]
    else:
        word = about.strip().lower()
        if word in ("origin", "centroid"):
            return centroid if word == "centroid" else (Fraction(0), Fraction(0), Fraction(0))
        parts = about.replace(",", " ").split()
        if len(parts) == 4:
            check_unit(parts.pop(), unit)
        if len(parts) != 3:
            raise InputError(f"{about[:40]!r} is not a centre", hint="write origin, centroid, or a point x,y,z")
        words = [read_number(w) for w in parts]
    if len(words) != 3:
        raise InputError(f"the centre has 3 numbers, found {len(words)}")
    x, y, z = words
    return x, y, z
