"""The slice of coordinates or actuators of a robot of joints over which a map goes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.poses.maps.axes import TRANSLATION, TURNS, GridAxis
from gcrules.poses.maps.nodes import Nodes, in_words, others
from gcrules.screws.pose import exact_float
from gcrules.screws.pose_text import ANGLES, COORDINATES, Amount, check_known, read_named

__all__ = ["LimbsGrid", "coordinates_of"]


@dataclass(frozen=True)
class LimbsGrid(Nodes):
    """Poses over `axes`: `names` are the coordinates that determine a pose, or all actuators where `driven`, `values`
    what they are (from home, in radians and the file's unit) where no axis stands for them.
    """

    names: tuple[str, ...]
    values: tuple[float, ...]
    driven: bool
    title: str
    actuators: tuple[str, ...]
    angles_driven: tuple[bool, ...]
    unit: str = ""
    notes: tuple[str, ...] = ()

    @property
    def moved(self) -> bool:
        """Whether home is not in the slice."""
        return any(self.values)

    @property
    def home(self) -> tuple[float, ...]:
        """Home in the axes' coordinates, not a number where it is not in the slice."""
        return tuple(math.nan if self.moved else 0.0 for _ in self.axes)

    @property
    def rest(self) -> str:
        """What the other coordinates are, in words."""
        return self.fixed or "none: the axes are all that the robot has"

    @property
    def fixed(self) -> str:
        """The same, empty where there are none."""
        driven = [n for n, angle in zip(self.actuators, self.angles_driven, strict=True) if angle]
        return in_words(self._others, self.unit, driven if self.driven else TURNS)

    @property
    def _others(self) -> dict[str, float]:
        return others(self.axes, self.names, self.values)

    @cached_property
    def linear(self) -> tuple[Floats, Floats]:
        """The coordinates `names` at the first node, and by how much they grow from node to node, (axes, names)."""
        origin, steps = np.array(self.values), np.zeros((len(self.axes), len(self.names)))
        for k, axis in enumerate(self.axes):
            n = self.names.index(axis.name)
            origin[n], steps[k, n] = float(axis.start) * axis.scale, float(axis.step) * axis.scale
        return origin, steps

    def to_json(self) -> dict[str, Any]:
        return {"axes": [a.to_json() for a in self.axes], "at": self._others}


def coordinates_of(
    m: Linkage, axes: Sequence[GridAxis], at: Any, driven: bool
) -> tuple[tuple[str, ...], tuple[float, ...]]:
    """All coordinates by which poses are told, and what they are where no axis stands for them. Raises InputError."""
    over = [a.name for a in axes]
    given = {} if at is None else _given(m, at, driven)
    twice = [n for n in given if n in over]
    if twice:
        raise InputError(f"{twice[0]} is an axis of the map, and is given as well", hint="leave it out of --at")
    if driven:
        names = tuple(a.name for a in leading(m))
        return names, tuple(given.get(n, 0.0) for n in names)
    foreign = next((n for n in (*over, *given) if n not in (*TRANSLATION, *TURNS)), None)
    if foreign is not None:
        raise InputError(
            f"a robot of joints is not mapped by {foreign}",
            hint="its coordinates are x, y, z, roll, pitch, yaw, or its actuators "
            + ", ".join(a.name for a in leading(m)),
        )
    named = [*over, *(n for n in given if n not in over)]
    if len(named) > m.robot.mobility:
        raise InputError(
            f"{len(named)} coordinates are named, and the platform has mobility {m.robot.mobility}",
            hint=f"name {m.robot.mobility} at most: the others follow",
        )
    names = tuple(named) if len(named) == m.robot.mobility else free_coordinates(m, named)
    missing = [n for n in named if n not in names]
    if missing:
        known = listed([n for n in named if n != missing[0]])
        beside = f" beside {known}" if known else ""
        raise InputError(
            f"{missing[0]} says nothing about the pose of {m.robot.id} near home{beside}",
            hint=f"independent there are, for example, {', '.join(free_coordinates(m))}",
        )
    return names, tuple(given.get(n, 0.0) for n in names)


def _given(m: Linkage, at: Any, driven: bool) -> dict[str, float]:
    """The values of those coordinates, or of actuators, that are named: text or a mapping, angles in radians."""
    if isinstance(at, str):
        known = {a.name: a.angle for a in leading(m)} if driven else {n: n in ANGLES for n in COORDINATES}
        return {n: float(v) for n, v in read_named(at, known, m.robot.units).items()}
    if isinstance(at, Mapping):
        known = {a.name: a.angle for a in leading(m)} if driven else {n: n in ANGLES for n in COORDINATES}
        check_known(at, tuple(known), "actuator" if driven else "coordinate of a pose")
        return {n: float(v) if isinstance(v, Amount) else exact_float(v, n) for n, v in at.items()}
    raise InputError(
        f"{str(at)[:60]!r} names no coordinates", hint='write what the other ones are: "z=0.1, yaw=5deg" or "q3=0.1"'
    )
