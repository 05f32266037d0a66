"""What is wanted of a robot: a whole pose, some of its coordinates, or amounts of its actuators; read and checked."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Actuator, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, change_about
from gcrules.screws.pose import Pose, exact_float
from gcrules.screws.pose_text import (
    ANGLES,
    COORDINATES,
    SHIFTS,
    TURNS,
    VECTOR,
    Amount,
    check_known,
    check_one_turn,
    parse_pose,
    pose_of,
    read_named,
)

__all__ = [
    "Target",
    "actuators_target",
    "check_count",
    "check_turn",
    "coordinates_target",
    "pose_target",
    "read_actuators",
    "read_pose",
    "written",
]


@dataclass(frozen=True, eq=False)
class Target:
    """By how much the names grow, from home or from `start`: coordinates of the pose, or actuators where `driven`;
    angles in radians. For a whole pose `whole` is its motion from home, (4, 4), and the values are the shift of the
    centre and the rotation vector; `start` is a motion too, else it holds the values there.
    """

    names: tuple[str, ...]
    values: Floats
    driven: bool = False
    whole: Floats | None = None
    text: str = ""
    notes: tuple[str, ...] = ()
    start: Floats | None = None

    def value(self, part: float) -> Floats:
        """The values of the names after a part of the way; not for a whole pose."""
        return part * self.values if self.start is None else self.start + part * self.values

    def after(self, before: Target, centre: Floats) -> Target:
        """The same one, with a way that begins at another one and not at home; both of the same names."""
        if self.whole is None or before.whole is None:
            return replace(self, values=self.values - before.values, start=before.values)
        return replace(self, values=change_about(centre, before.whole, self.whole), start=before.whole)


def read_pose(m: Linkage, text: str, option: str = "--at") -> Target:
    """Read "z=0.2, roll=5deg" or a pose "x y z; euler zyx a b c deg". Raises InputError with the place."""
    if "=" not in text:
        return pose_target(m, parse_pose(text, m.robot.units, option), text.strip())
    found = read_named(text, {n: n in ANGLES for n in COORDINATES}, m.robot.units, option)
    return coordinates_target(m, found, text.strip())


def read_actuators(m: Linkage, text: str, option: str = "--actuators") -> Target:
    """Read "q1=0.1, q2=5deg". Raises InputError with the place."""
    return actuators_target(
        m, read_named(text, {a.name: a.angle for a in m.actuators}, m.robot.units, option, "actuator"), text.strip()
    )


def pose_target(m: Linkage, pose: Pose, text: str = "") -> Target:
    """A whole pose: the centre goes by the translation, the platform turns about it."""
    motion = np.eye(4)
    motion[:3, :3] = [[float(c) for c in row] for row in pose.rotation]
    shift = np.array([float(c) for c in pose.translation])
    motion[:3, 3] = shift + m.centre - motion[:3, :3] @ m.centre
    if m.robot.family.plane and (abs(shift[2]) > 0 or np.abs(motion[2, :2]).max() > 0 or motion[2, 2] < 0):
        raise InputError("the robot moves in the plane z = 0", hint="its coordinates are x, y and yaw")
    vector = np.array(pose.rotation_vector)
    return Target((*SHIFTS, *VECTOR), np.concatenate([shift, vector]), False, motion, text or str(pose), pose.notes)


def coordinates_target(m: Linkage, given: Mapping[str, Any], text: str = "") -> Target:
    """Values of some coordinates; whether they determine the pose is seen in solving. A platform with six freedoms
    stays at home in those that are not named. Raises InputError.
    """
    check_known(given, COORDINATES, "coordinate of a pose")
    check_one_turn(given)
    if m.robot.mobility == len(SHIFTS) + len(TURNS):
        return pose_target(m, pose_of(given), text or _shown(given))
    flat = [n for n in given if m.robot.family.plane and n not in ("x", "y", "yaw", "rz")]
    if flat:
        raise InputError(f"{flat[0]} is fixed: the robot moves in the plane z = 0", hint="take x, y and yaw")
    values = _numbers(given)
    check_turn(dict(zip(given, values, strict=True)))
    return Target(tuple(given), values, False, None, text or _shown(given))


def check_turn(values: Mapping[str, float]) -> None:
    """Raises InputError for angles that no pose has, since another name of the same turn is the one that is used."""
    hint = 'name the same turn in another way, or as a whole pose: "x y z; euler zyx a b c deg"'
    if abs(values.get("pitch", 0.0)) >= math.pi / 2:
        raise InputError("pitch has to lie between -90deg and 90deg", hint=hint)
    if math.hypot(*(values.get(n, 0.0) for n in VECTOR)) >= math.pi:
        raise InputError("the rotation vector rx, ry, rz has to be shorter than half a turn", hint=hint)


def actuators_target(m: Linkage, given: Mapping[str, Any] | Sequence[Any], text: str = "") -> Target:
    """Amounts of the actuators from home, by name or all in their order. Those that are not named stay at home; of more
    actuators than freedoms the `leading` ones are given, and the others follow.
    """
    leads = leading(m)
    follows = [a for a in m.actuators if a not in leads and isinstance(given, Mapping) and a.name in given]
    if follows:
        raise InputError(
            f"{follows[0].name} follows from the other actuators: there are more of them than freedoms",
            hint=f"give {_listed(leads)}",
        )
    if not isinstance(given, Mapping):
        values = list(given)
        check_count(values, len(leads), "actuator", f"they are {_listed(leads)}")
        given = {a.name: v for a, v in zip(leads, values, strict=True)}
    names = [a.name for a in leads]
    check_known(given, names, "actuator", _listed(leads))
    every = {n: given.get(n, 0.0) for n in names}
    angles = frozenset(a.name for a in leads if a.angle)
    return Target(tuple(every), _numbers(every), True, None, text or _shown(every, angles))


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
    return np.array([float(v) if isinstance(v, Amount) else exact_float(v, name) for name, v in given.items()])


def _shown(given: Mapping[str, Any], angles: frozenset[str] = ANGLES) -> str:
    return ", ".join(f"{n}={float(v):.6g}{' rad' if n in angles else ''}" for n, v in given.items())


def _listed(actuators: Sequence[Actuator]) -> str:
    return ", ".join(map(str, actuators))
