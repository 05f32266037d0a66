r"""The slice of poses that a map shows: the axes, and the pose that says what the other coordinates are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.maps.axes import TILT, TRANSLATION, TURNS, VECTOR, GridAxis
from gcrules.poses.maps.nodes import Nodes, in_words, others
from gcrules.poses.numbers.arrays import from_poses, read_arrays
from gcrules.poses.numbers.pose_arguments import one_pose
from gcrules.screws.pose import FAR, Pose, too_far
from gcrules.screws.pose_text import Amount, written_turn
from gcrules.screws.rotations import Vector, from_euler, from_vector

__all__ = ["MAX_FLAT", "MAX_POSES", "Grid", "grid"]

Floats = NDArray[np.float64]

MAX_POSES = 1_000_000_000
"""Nodes of a map over three coordinates."""
_SMALL = 1e-24  # poses may be `FAR` away, and a 32-bit float goes to 3e38
MAX_FLAT = 16_000_000
"""Nodes of a map over two coordinates, and of a layer of three."""


@dataclass(frozen=True)
class Grid(Nodes):
    """Poses over `axes` around the pose `at`. The three angles of the axes' kind are `angles` (in the axes' unit), each
    replaced where an axis stands for it; without axes that turn the orientation is that of `at`, exactly.
    """

    rig: MovingPlatform
    at: Pose
    angles: Vector = (Fraction(0), Fraction(0), Fraction(0))
    notes: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        return self.rig.title

    @property
    def unit(self) -> str:
        return self.rig.unit

    @property
    def actuators(self) -> tuple[str, ...]:
        return self.rig.names

    @property
    def angles_driven(self) -> tuple[bool, ...]:
        """Of each leg whether it turns: none does."""
        return (False,) * len(self.actuators)

    @property
    def rest(self) -> str:
        """The given pose, in words."""
        return f'"{self.at.text()}"'

    @property
    def fixed(self) -> str:
        """The coordinates for which no axis stands, one by one; the orientation as one where no axis turns."""
        shift = others(self.axes, TRANSLATION, [float(c) for c in self.at.translation])
        turning = self.rotation_axis
        if turning is not None:
            names = _names(turning)
            turned = in_words(others(self.axes, names, [float(a) * turning.scale for a in self.angles]), "", names)
        elif self.at.angle:
            size = float(self.at.angle)
            axis = ", ".join(f"{float(c) / size:.4g}" for c in self.at.rotation_vector)
            turned = f"turned by {math.degrees(size):.4g}° about ({axis})"
        else:
            turned = "no rotation"
        return ", ".join(part for part in (in_words(shift, self.unit), turned) if part)

    @property
    def moved(self) -> bool:
        """Whether the given pose is not that of the file."""
        return any(self.at.translation) or self.at.angle != 0

    @property
    def rotation_axis(self) -> GridAxis | None:
        """An axis that turns, if there is one."""
        return next((a for a in self.axes if a.kind != "translation"), None)

    @property
    def home(self) -> tuple[float, ...]:
        """The coordinates of the pose `at`, in the order of the axes."""
        shift = self.at.translation
        return tuple(float(shift[a.place] if a.kind == "translation" else self.angles[a.place]) for a in self.axes)

    def arrays(self, coordinates: Floats) -> tuple[Floats, Floats]:
        """Poses at coordinates (N, axes), as translations (N, 3) and rotations (N, 3, 3), or (1, 3, 3) for all."""
        shift = np.repeat(np.array([[float(c) for c in self.at.translation]]), len(coordinates), axis=0)
        for k, axis in enumerate(self.axes):
            if axis.kind == "translation":
                shift[:, axis.place] = coordinates[:, k]
        turning = self.rotation_axis
        if turning is None:
            return shift, self._orientation
        angles = np.repeat(np.array([[float(c) for c in self.angles]]), len(coordinates), axis=0)
        for k, axis in enumerate(self.axes):
            if axis.kind != "translation":
                angles[:, axis.place] = coordinates[:, k]
        degrees = turning.unit == "deg"
        if turning.kind == "vector":
            return shift, read_arrays(rotation_vectors=angles, degrees=degrees)[1]
        if turning.kind == "tilt":
            angles[:, 2] -= angles[:, 0]
        return shift, read_arrays(euler=(_sequence(turning.kind), angles), degrees=degrees)[1]

    def pose(self, coordinates: Sequence[Fraction]) -> Pose:
        """The exact pose at exact coordinates."""
        shift, angles = list(self.at.translation), list(self.angles)
        for axis, value in zip(self.axes, coordinates, strict=True):
            (shift if axis.kind == "translation" else angles)[axis.place] = value
        x, y, z = shift
        turning = self.rotation_axis
        if turning is None:
            return Pose((x, y, z), self.at.quaternion)
        degrees = turning.unit == "deg"
        if turning.kind == "vector":
            return Pose((x, y, z), from_vector(angles, degrees=degrees))
        if turning.kind == "tilt":
            angles[2] -= angles[0]
        return Pose((x, y, z), from_euler(_sequence(turning.kind), angles, degrees=degrees))

    def ends(self, coordinates: Floats) -> Floats:
        """The platform ends of the legs at coordinates (N, axes): (N, 6, 3). Legs may have no length there."""
        turn = self.arrays(coordinates)[1]
        found: Floats = np.swapaxes(np.matmul(turn, self.rig.arms.T), 1, 2) + self.centres(coordinates)[:, None, :]
        return found

    def centres(self, coordinates: Floats) -> Floats:
        """Where the centre of turns is at coordinates (N, axes): (N, 3)."""
        return np.asarray(self.rig.centre_of_turns + self.arrays(coordinates)[0])

    @cached_property
    def _orientation(self) -> Floats:
        return from_poses([self.at])[1]

    def to_json(self) -> dict[str, Any]:
        return {"axes": [a.to_json() for a in self.axes], "at": self.at.to_json()}


def _names(axis: GridAxis) -> tuple[str, ...]:
    """The three coordinates of turns of the kind of an axis."""
    for names in (VECTOR, TILT, TURNS):
        if axis.name in names:
            return names
    return tuple(f"{axis.kind}{n}" for n in (1, 2, 3))


def _sequence(kind: str) -> str:
    """R = Rz(azimuth) Ry(tilt) Rz(torsion − azimuth)."""
    return "ZYZ" if kind == "tilt" else kind


def grid(rig: MovingPlatform, axes: tuple[GridAxis, ...], at: Any = None) -> Grid:
    """The slice around a pose (text as for --at, a translation or a `Pose`; the file's own by default).

    Raises InputError for what is no single pose and for slices that are too far away, LimitReached for too many nodes.
    """
    pose = one_pose(at, {}, False, rig.unit)
    if pose is None:
        raise InputError("a map is around one pose", hint='at="0 0 5; euler zyx 10 0 0 deg"')
    number = math.prod(a.number for a in axes)
    layer = number if len(axes) == 2 else number // axes[0].number
    if number > MAX_POSES or layer > MAX_FLAT:
        most = MAX_FLAT if layer > MAX_FLAT else MAX_POSES
        raise LimitReached(
            f"{number:,} poses: more than {most:,} in one map", hint="use a coarser grid, or make two maps"
        )
    turning = next((a for a in axes if a.kind != "translation"), None)
    rest: tuple[Fraction, ...] = (Fraction(0),) * 3
    notes = pose.notes
    if turning is not None:
        rest, more = _rest(pose, at, turning, rig.unit)
        notes += more
    else:
        notes = pose.exact_notes
    found = Grid(axes, rig, pose, (rest[0], rest[1], rest[2]), notes)
    corners = np.array(np.meshgrid(*[[float(a.start), float(a.stop)] for a in axes])).reshape(len(axes), -1).T
    if np.abs(found.ends(corners) - rig.base).max() > FAR * rig.size:
        raise too_far("a pose is")
    if not _SMALL < rig.size < 1 / _SMALL:
        raise InputError(
            f"the robot is too {'small' if rig.size < 1 else 'large'} for the 32-bit floats of a map: its size is"
            f" {rig.size:.3g}, expected one between {_SMALL:g} and {1 / _SMALL:g}",
            hint="choose another unit",
        )
    return found


def _rest(pose: Pose, given: Any, axis: GridAxis, unit: str) -> tuple[tuple[Fraction, ...], tuple[str, ...]]:
    """The three angles of the pose, in the axis' unit: as they were typed, if they were, else computed."""
    degrees = axis.unit == "deg"
    written = written_turn(given, unit) if isinstance(given, str) else None
    if written is not None and (typed := written.in_kind(axis.kind)):
        return tuple(a.number if a.degrees == degrees else _converted(a, degrees) for a in typed), ()
    if pose.angle == 0:
        return (Fraction(0),) * 3, ()
    notes: tuple[str, ...] = ()
    if axis.kind == "vector":
        angles = list(pose.rotation_vector)
    else:
        angles, unique = _euler(np.array(pose.rotation, dtype=np.float64), _sequence(axis.kind))
        if axis.kind == "tilt":
            upside_down = not unique and angles[1] > 1
            torsion = -angles[0] if upside_down else angles[0] + angles[2]
            angles = [angles[0] if unique else 0.0, angles[1], torsion]
        if not unique and axis.kind != "tilt":
            last = 1 if axis.kind.islower() else 3
            named = ("roll, pitch and yaw", "roll") if axis.name in TURNS else (axis.kind, f"{axis.kind}{last}")
            notes = (f"the pose has no unique angles {named[0]}; {named[1]} is taken as 0",)
    return tuple(Fraction(math.degrees(a) if degrees else a) for a in angles), notes


def _converted(angle: Amount, degrees: bool) -> Fraction:
    """The number of an angle in the other unit: in `degrees`, or in radians."""
    return Fraction(math.degrees(angle.number) if degrees else math.radians(angle.number))


def _euler(R: Floats, sequence: str) -> tuple[list[float], bool]:
    """Euler angles (rad) of a rotation matrix, and whether they are unique; else the last turn is 0."""
    letters = sequence.lower() if sequence.isupper() else sequence[::-1]  # about the axes that turn along
    i, j, k = ("xyz".index(c) for c in letters)
    m = 3 - i - j
    e = 1.0 if (j - i) % 3 == 1 else -1.0
    if i == k:
        middle = math.acos(min(1.0, max(-1.0, R[i, i])))
        unique = math.hypot(R[i, j], R[i, m]) > 1e-12
        first, last = math.atan2(R[j, i], -e * R[m, i]), math.atan2(R[i, j], e * R[i, m])
    else:
        middle = math.asin(min(1.0, max(-1.0, e * R[i, k])))
        unique = math.hypot(R[i, i], R[i, j]) > 1e-12
        first, last = math.atan2(-e * R[j, k], R[k, k]), math.atan2(-e * R[i, j], R[i, i])
    if not unique:
        first, last = math.atan2(e * R[m, j], R[j, j]), 0.0
    angles = [a + 0.0 if abs(a) > 1e-15 else 0.0 for a in (first, middle, last)]
    return (angles if sequence.isupper() else angles[::-1]), unique
