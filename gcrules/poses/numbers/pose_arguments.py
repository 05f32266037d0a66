r"""What a user asks for in Python: one pose or many, the accuracy; told apart and checked."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.pose import Pose, exact, exact_float, unit_note
from gcrules.screws.pose_text import parse_pose, pose_of
from gcrules.screws.rotations import IDENTITY, from_euler, from_vector
from gcrules.screws.threshold import parse_length

__all__ = ["is_many", "known_accuracy", "known_length", "one_pose", "read_one"]


_COARSE = 1e6


def known_accuracy(given: str | float | None, moving: MovingPlatform) -> float:
    """The length up to which the joints' places are known; that of the rounding of floats where none is given."""
    if given is None:
        return ROUNDING * moving.size
    length = parse_length(given, moving.unit) if isinstance(given, str) else exact_float(given, "the accuracy")
    if length < 0:
        raise InputError(f"the accuracy {length} is negative")
    if length > _COARSE * moving.size:
        raise InputError(
            f"the accuracy {length:.3g} is more than {_COARSE:g} times the robot's size", hint="check the unit"
        )
    return max(length, ROUNDING * moving.size)


def known_length(given: str | float, unit: str) -> float:
    """A characteristic length. Raises InputError for one that is not positive and finite."""
    length = parse_length(given, unit) if isinstance(given, str) else exact_float(given, "the characteristic length")
    if not 0 < length < math.inf:
        raise InputError(f"the characteristic length {length:.3g} is not positive")
    return length


def _three(numbers: Any, what: str) -> Sequence[Any]:
    """Three entries. Raises InputError for another number of them."""
    found = list(numbers) if np.iterable(numbers) else [numbers]
    if len(found) != 3:
        raise InputError(f"{what} has 3 numbers, found {len(found)}")
    return found


def one_pose(at: Any, turns: Mapping[str, Any], in_degrees: bool, unit: str) -> Pose | None:
    """The pose if it is a single one, else None."""
    given = {kind: t for kind, t in turns.items() if t is not None}
    if isinstance(at, (str, Pose, Mapping)):
        if given:
            raise InputError("a pose that contains its turn, and a turn as well")
        return read_one(at, unit, in_degrees)
    if is_many(at, given):
        return None
    if len(given) > 1:
        raise InputError("several kinds of turns", hint="give a quaternion, a rotation vector or Euler angles")
    shift = (0, 0, 0) if at is None else at
    x, y, z = (exact(c, "the translation") for c in _three(shift, "the translation"))
    turn, notes = _turn(given, in_degrees)
    return Pose((x, y, z), turn, notes)


def read_one(at: Any, unit: str, in_degrees: bool = False) -> Pose:
    """A pose that holds its turn: a `Pose`, text, coordinates by their names, or a translation of three numbers. Raises
    InputError for anything else.
    """
    if isinstance(at, Pose):
        return at
    if isinstance(at, str):
        return parse_pose(at, unit)
    if isinstance(at, Mapping):
        return pose_of(at, degrees=in_degrees)
    x, y, z = (exact(c, "the translation") for c in _three(at, "the translation"))
    return Pose((x, y, z))


def is_many(at: Any, turns: Mapping[str, Any]) -> bool:
    """Whether there are several poses, or several turns beside one. Raises InputError for Euler angles without their
    sequence.
    """
    euler = turns.get("euler", ("zyx", ()))
    if not (isinstance(euler, (tuple, list)) and len(euler) == 2 and isinstance(euler[0], str)):
        raise InputError("Euler angles are a sequence and three angles", hint='euler=("zyx", (10, 0, 0)), degrees=True')
    if at is None or isinstance(at, (str, Pose, Mapping)):
        values = []
    elif isinstance(at, (list, tuple)) and at and (at[0] is None or isinstance(at[0], (str, Pose, Mapping))):
        return True
    else:
        values = [at]
    values += [t[1] if kind == "euler" else t for kind, t in turns.items()]
    return any(_is_nested(v) for v in values)


def _is_nested(value: Any) -> bool:
    """Whether it is anything but one row of numbers."""
    try:
        return np.ndim(value) != 1
    except ValueError:  # rows of unequal length
        return True


def _turn(given: dict[str, Any], in_degrees: bool) -> tuple[Any, tuple[str, ...]]:
    if not given:
        return IDENTITY, ()
    ((kind, value),) = given.items()
    if kind == "quaternion":
        q = tuple(exact(c, "the quaternion") for c in value)
        if len(q) != 4:
            raise InputError(f"the quaternion has 4 numbers, found {len(q)}")
        note = unit_note(q)
        return q, (note,) if note else ()
    if kind == "rotation_vector":
        vector = [exact(c, "the rotation vector") for c in _three(value, "the rotation vector")]
        return from_vector(vector, degrees=in_degrees), ()
    sequence, angles = value
    listed = [exact(c, "an angle") for c in _three(angles, "a set of Euler angles")]
    return from_euler(sequence, listed, degrees=in_degrees), ()
