"""What is wanted of a robot: a whole pose, some of its coordinates, or amounts of its actuators; read and checked."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.mechanisms.kinematics.coordinates import ANGLES, COORDINATES, SHIFTS, TURNS, VECTOR
from gcrules.mechanisms.kinematics.mechanism import Actuator, Mechanism
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.screws.pose import Pose, check_unit, exact_float, parse_pose, read_number

__all__ = [
    "Wanted",
    "check_count",
    "read_actuators",
    "read_pose",
    "wanted_actuators",
    "wanted_coordinates",
    "wanted_pose",
    "written",
]

_PART = re.compile(r"\s*([A-Za-z]\w*)\s*=\s*(.*?)\s*")
_LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ°"
_NOT_FINITE = ("nan", "inf", "infinity")
_ANGLES = {"deg": math.pi / 180, "°": math.pi / 180, "rad": 1.0}


@dataclass(frozen=True, eq=False)
class Wanted:
    """Values of the names: coordinates of the pose, or actuators where `driven`; angles in radians. For a whole pose
    `whole` is its motion from home, (4, 4), about the centre.
    """

    names: tuple[str, ...]
    values: Floats
    driven: bool = False
    whole: Floats | None = None
    text: str = ""
    notes: tuple[str, ...] = ()


def read_pose(m: Mechanism, text: str, option: str = "--at") -> Wanted:
    """Read "z=0.2, roll=5deg" or a pose "x y z; euler zyx a b c deg". Raises InputError with the place."""
    if "=" not in text:
        return wanted_pose(m, parse_pose(text), text.strip())
    found = _named(text, option, {n: n in ANGLES for n in COORDINATES}, "coordinate of a pose")
    return wanted_coordinates(m, found, text.strip())


def read_actuators(m: Mechanism, text: str, option: str = "--actuators") -> Wanted:
    """Read "q1=0.1, q2=5deg". Raises InputError with the place."""
    return wanted_actuators(m, _named(text, option, {a.name: a.angle for a in m.actuators}, "actuator"), text.strip())


def wanted_pose(m: Mechanism, pose: Pose, text: str = "") -> Wanted:
    """A whole pose: the centre goes by the translation, the platform turns about it."""
    motion = np.eye(4)
    motion[:3, :3] = [[float(c) for c in row] for row in pose.rotation]
    shift = np.array([float(c) for c in pose.translation])
    motion[:3, 3] = shift + m.centre - motion[:3, :3] @ m.centre
    if m.robot.family.plane and (abs(shift[2]) > 0 or np.abs(motion[2, :2]).max() > 0 or motion[2, 2] < 0):
        raise InputError("the robot moves in the plane z = 0", hint="its coordinates are x, y and yaw")
    vector = np.array(pose.rotation_vector)
    return Wanted((*SHIFTS, *VECTOR), np.concatenate([shift, vector]), False, motion, text or str(pose), pose.notes)


def wanted_coordinates(m: Mechanism, given: Mapping[str, Any], text: str = "") -> Wanted:
    """Values of some coordinates; whether they determine the pose is seen in solving. Raises InputError."""
    _known(given, COORDINATES, "coordinate of a pose")
    if any(n in TURNS for n in given) and any(n in VECTOR for n in given):
        raise InputError("roll, pitch, yaw and rx, ry, rz are two ways to say one turn", hint="take one of them")
    flat = [n for n in given if m.robot.family.plane and n not in ("x", "y", "yaw", "rz")]
    if flat:
        raise InputError(f"{flat[0]} is fixed: the robot moves in the plane z = 0", hint="take x, y and yaw")
    values = _numbers(given)
    _check_turn(dict(zip(given, values, strict=True)))
    return Wanted(tuple(given), values, False, None, text or _shown(given))


def _check_turn(values: Mapping[str, float]) -> None:
    """Raises InputError for angles that no pose has, since another name of the same turn is the one that is used."""
    hint = 'name the same turn in another way, or as a whole pose: "x y z; euler zyx a b c deg"'
    if abs(values.get("pitch", 0.0)) >= math.pi / 2:
        raise InputError("pitch has to lie between -90deg and 90deg", hint=hint)
    if math.hypot(*(values.get(n, 0.0) for n in VECTOR)) >= math.pi:
        raise InputError("the rotation vector rx, ry, rz has to be shorter than half a turn", hint=hint)


def wanted_actuators(m: Mechanism, given: Mapping[str, Any] | Sequence[Any], text: str = "") -> Wanted:
    """Amounts of the actuators from home, by name or all in their order. Those that are not named stay at home."""
    if not isinstance(given, Mapping):
        values = list(given)
        check_count(values, len(m.actuators), "actuator", f"they are {_listed(m.actuators)}")
        given = {a.name: v for a, v in zip(m.actuators, values, strict=True)}
    names = [a.name for a in m.actuators]
    _known(given, names, "actuator", _listed(m.actuators))
    every = {n: given.get(n, 0.0) for n in names}
    angles = frozenset(a.name for a in m.actuators if a.angle)
    return Wanted(tuple(every), _numbers(every), True, None, text or _shown(every, angles))


def _known(given: Mapping[str, Any], names: Sequence[str], what: str, listed: str = "") -> None:
    for name in given:
        if name not in names:
            hint = near(str(name), names) or f"there are {listed or ', '.join(names)}"
            raise InputError(f"{str(name)[:40]!r} is no {what}", hint=hint)


def check_count(given: Any, needed: int, what: str, hint: str) -> None:
    """Raises InputError where there are too few or too many of them."""
    if len(given) != needed:
        word = "few" if len(given) < needed else "many"
        beside = "the robot has" if what == "actuator" else "the platform has mobility"
        raise InputError(f"too {word} {what}s: {len(given)}, and {beside} {needed}", hint=f"give {needed}; {hint}")


def written(values: Mapping[str, float]) -> str:
    """Coordinates as a user would write them: "z=0.2, roll=5deg"."""
    words = (f"{n}={math.degrees(v):.6g}deg" if n in ANGLES else f"{n}={v:.6g}" for n, v in values.items())
    return f'"{", ".join(words)}"'


def _numbers(given: Mapping[str, Any]) -> Floats:
    return np.array([exact_float(v, name) for name, v in given.items()])


def _shown(given: Mapping[str, Any], angles: frozenset[str] = ANGLES) -> str:
    return ", ".join(f"{n}={float(v):.6g}{' rad' if n in angles else ''}" for n, v in given.items())


def _listed(actuators: Sequence[Actuator]) -> str:
    return ", ".join(map(str, actuators))


def _named(text: str, option: str, angles: Mapping[str, bool], what: str) -> dict[str, float]:
    """Names with their values, angles in radians."""
    found: dict[str, float] = {}
    start = 0
    for part in re.split(r"[,;]", text):
        span = Span(start + len(part) - len(part.lstrip()), start + max(len(part.rstrip()), 1))
        start += len(part) + 1
        if not part.strip():
            continue
        try:
            match = _PART.fullmatch(part)
            if match is None:
                raise InputError(f"{part.strip()[:40]!r} gives no value to a name", hint="write z=0.2, roll=5deg")
            name, value = match.groups()
            if "=" in value:
                raise InputError("two values without a comma between them", hint="write z=0.2, roll=5deg")
            _known({name: value}, tuple(angles), what)
            if name in found:
                raise InputError(f"{name} is given twice")
            found[name] = _value(value, name, angles[name])
        except GcrulesError as fault:
            raise fault.located(text, option, span) from None
    if not found:
        raise InputError("no values are given", hint="write z=0.2, roll=5deg")
    return found


def _value(text: str, name: str, angle: bool) -> float:
    word = text[len(text.rstrip(_LETTERS)) :]
    word = "" if word.lower() in _NOT_FINITE else word
    number = text.removesuffix(word).strip()
    value = float(read_number(number))
    if angle and word not in _ANGLES:
        if word:
            raise InputError(f"{word[:20]!r} is no unit of an angle", hint=f"write {name}={number}deg or rad")
        raise InputError(f"{name} is an angle without a unit", hint=f"write {name}={number}deg or {name}={number}rad")
    if not angle and word in _ANGLES:
        raise InputError(f"{name} is a length, and {word} is a unit of angles", hint=f"write {name}={number}")
    if not angle and word:
        check_unit(word, "")
    return value * _ANGLES[word] if angle else value
