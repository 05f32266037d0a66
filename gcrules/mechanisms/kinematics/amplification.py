r"""What the actuators make of their rates: velocity and force amplification, condition number, isotropy.

With all actuators but one locked, a unit rate of that one moves the platform along a twist T_i = (ω_i; v_i at the
centre). These twists are the columns of the inverse of the actuations' part of the Jacobian, on the twists that the
constraints allow. They are the amplification of forces too: by the virtual work of T_i a force f through the centre
needs the effort f · v_i of actuator i, and a couple m the effort m · ω_i. So a unit force through the centre needs at
worst |v_i|, a unit couple at worst |ω_i|; and errors δ_i of the actuators move the centre by at most Σ |v_i| |δ_i|, to
first order. Where there are more actuators than freedoms none of them moves alone: then only the condition number of
their rates is told.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.frozen import HoldsArrays

__all__ = [
    "INDICES",
    "Amplification",
    "Amplifications",
    "Index",
    "amplification",
    "amplifications",
    "index_columns",
    "index_names",
    "mixed",
]

Floats = NDArray[np.float64]

_RANK = 1e-9
_ROUNDING = 1e-13


@dataclass(frozen=True, eq=False)
class Amplifications(HoldsArrays):
    """Of N configurations all numbers that an `Amplification` has of one: `speeds` and `turns` (N, actuators),
    `condition_numbers` (N,). The platform has so many `freedoms`.
    """

    angles: tuple[bool, ...]
    freedoms: int
    length: float
    speeds: Floats
    turns: Floats
    condition_numbers: Floats

    @property
    def isotropy(self) -> Floats:
        """1 over the condition numbers (N,), 0 where they are infinite."""
        return 1 / self.condition_numbers

    @property
    def indices(self) -> Mapping[str, Floats]:
        """All of `INDICES` that these actuators have, (N,) each."""
        return {name: INDICES[name].of(self) for name in index_names(self.angles, self.freedoms)}

    def to_json(self) -> dict[str, list[float | None]]:
        """Lists of the indices, null where they are infinite or do not exist."""
        return {n: [x if math.isfinite(x) else None for x in v.tolist()] for n, v in self.indices.items()}

    @classmethod
    def together(cls, parts: Sequence[Amplifications]) -> Amplifications:
        """Those of several stacks of one robot."""
        arrays = (np.concatenate([getattr(p, n) for p in parts]) for n in ("speeds", "turns", "condition_numbers"))
        return cls(parts[0].angles, parts[0].freedoms, parts[0].length, *arrays)


@dataclass(frozen=True)
class Amplification:
    """For each actuator (`angles` tells of each whether it turns) the `speeds` |v_i| of the platform's centre and the
    `turns` |ω_i| (rad) for a unit of its rate (1 rad, or the unit of length), all others locked; infinite where the
    robot is singular, not a number where an actuator applies no wrench, or where there are more actuators than
    freedoms, so that none moves alone. `condition_number` is that of the twists, turns weighed with `length` against
    shifts and the rates of angles likewise against those of lengths, where the robot has
    both kinds of actuators.
    """

    actuators: tuple[str, ...]
    angles: tuple[bool, ...]
    speeds: tuple[float, ...]
    turns: tuple[float, ...]
    condition_number: float
    length: float

    @property
    def isotropy(self) -> float:
        """1 over the condition number: 1 where all directions are alike, 0 where the robot is singular."""
        return 0.0 if math.isinf(self.condition_number) else 1 / self.condition_number

    def to_json(self) -> dict[str, Any]:
        """One JSON object; numbers that are infinite or do not exist are null."""

        def number(x: float) -> float | None:
            return x if math.isfinite(x) else None

        return {
            "actuators": [
                {"name": name, "unit": "rad" if angle else "length", "speed": number(speed), "turn": number(turn)}
                for name, angle, speed, turn in zip(self.actuators, self.angles, self.speeds, self.turns, strict=True)
            ],
            "condition_number": number(self.condition_number),
            "isotropy": number(self.isotropy),
            "length": self.length,
        }


def amplification(
    actuations: Floats,
    constraints: Floats,
    names: Sequence[str],
    angles: Sequence[bool],
    freedoms: int,
    length: float,
) -> Amplification:
    """From the wrenches (f; m about the centre) of the actuators (n, 6), whose product with a twist is their rate, and
    of the constraints (k, 6), which elsewhere leave so many freedoms; `angles` tells of each actuator whether it turns.
    """
    held = np.reshape(constraints, (1, -1, 6))
    every = amplifications(np.asarray(actuations)[None], held, angles, freedoms, length)
    speeds, turns = (tuple(map(float, a[0])) for a in (every.speeds, every.turns))
    return Amplification(tuple(names), tuple(angles), speeds, turns, float(every.condition_numbers[0]), length)


def amplifications(
    actuations: Floats, constraints: Floats, angles: Sequence[bool], freedoms: int, length: float
) -> Amplifications:
    """The same in N configurations: wrenches of the actuators (N, n, 6) and of the constraints (N, k, 6)."""
    scale, number = np.array([1.0, 1.0, 1.0, length, length, length]), len(angles)
    held = np.zeros((len(actuations), max(6, constraints.shape[1]), 6))  # with rows of zeros there are six values
    held[:, : constraints.shape[1]] = constraints / scale
    _, sizes, right = np.linalg.svd(held, full_matrices=True)
    rank = (sizes > _RANK * np.where(sizes[:, :1] > 0, sizes[:, :1], 1.0)).sum(axis=1)
    free = right[:, 6 - freedoms :]
    units = np.where(angles, length, 1.0) if mixed(angles) else np.ones(number)
    known: NDArray[np.bool_] = np.asarray(np.isfinite(actuations).all(axis=(1, 2)))
    own = np.where(known[:, None, None], actuations, 0.0) / scale
    left, sizes, right = np.linalg.svd(units[:, None] * own @ np.swapaxes(free, 1, 2), full_matrices=False)
    lost = np.asarray(sizes <= _RANK * sizes[:, :1])
    twists = units[:, None] * (left / np.where(lost, 1.0, sizes)[:, None] @ right @ free) / scale
    endless = ((np.abs(left) > _RANK) & lost[:, None]).any(axis=2)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        condition = np.where(lost.any(axis=1), np.inf, sizes[:, 0] / sizes[:, -1])
    parts = np.stack([np.linalg.norm(twists[..., k : k + 3], axis=2) for k in (0, 3)]) * [[[1.0]], [[length]]]
    parts[parts <= _ROUNDING * parts.max(axis=(0, 2), keepdims=True)] = 0.0  # a platform that only shifts, or turns
    found = [np.where(endless, np.inf, part) for part in (parts[0], parts[1] / length)]
    found.append(condition)
    for array in found:
        array[~known] = np.nan  # an actuator applies no wrench
        array[rank != 6 - freedoms] = np.inf  # the platform has other freedoms here than elsewhere
    if number > freedoms:
        found[:2] = (np.full_like(part, np.nan) for part in found[:2])
    return Amplifications(tuple(angles), freedoms, length, *found)


def mixed(angles: Sequence[bool]) -> bool:
    """Whether some actuators turn and others slide: their rates have no unit in common."""
    return any(angles) and not all(angles)


@dataclass(frozen=True)
class Index:
    """One number for all actuators together: its `meaning`, whether a `small` one is bad, its units for actuators that
    slide and for those that turn, and how it is made.
    """

    meaning: str
    small: bool
    units: tuple[str, str]
    of: Callable[[Amplifications], Floats]

    def unit(self, length: str, angles: Sequence[bool]) -> str:
        """Its unit where lengths have this one, "" for a number without a unit."""
        return self.units[all(angles)].format(length or "length")


INDICES: Mapping[str, Index] = MappingProxyType(
    {
        "isotropy": Index("isotropy of the actuators", True, ("", ""), lambda a: a.isotropy),
        "speed": Index(
            "largest speed of the centre for the unit rate of one actuator",
            False,
            ("", "{}/rad"),
            lambda a: a.speeds.max(axis=1),
        ),
        "turn": Index(
            "largest turn of the platform for the unit rate of one actuator",
            False,
            ("rad/{}", ""),
            lambda a: a.turns.max(axis=1),
        ),
        "shift_error": Index(
            "largest shift of the centre for errors of all actuators up to one unit",
            False,
            ("", "{}/rad"),
            lambda a: a.speeds.sum(axis=1),
        ),
        "turn_error": Index(
            "largest turn of the platform for errors of all actuators up to one unit",
            False,
            ("rad/{}", ""),
            lambda a: a.turns.sum(axis=1),
        ),
        "force": Index(
            "largest force through the centre that is borne in every direction by actuators of unit effort",
            True,
            ("", "1/{}"),
            lambda a: _inverse(a.speeds.max(axis=1)),
        ),
        "couple": Index(
            "largest couple that is borne about every axis by actuators of unit effort",
            True,
            ("{}", ""),
            lambda a: _inverse(a.turns.max(axis=1)),
        ),
    }
)
"""What engineers ask for at many poses. Errors are bounds to first order: actuators whose effects do not point in one
direction cannot reach them all at once. All but the isotropy need actuators of one kind.
"""


def _inverse(a: Floats) -> Floats:
    with np.errstate(divide="ignore"):
        return np.asarray(1 / a)


def index_names(angles: Sequence[bool], freedoms: int) -> tuple[str, ...]:
    """Those of `INDICES` that actuators have, of which `angles` tells whether they turn, on so many freedoms."""
    return ("isotropy",) if mixed(angles) or len(angles) > freedoms else tuple(INDICES)


def index_columns(a: Amplifications, unit: str) -> tuple[str, ...]:
    """The heads of columns with the indices: "speed [mm/rad]"."""
    units = {name: INDICES[name].unit(unit, a.angles) for name in a.indices}
    return tuple(f"{name.replace('_', ' ')}{f' [{u}]' if u else ''}" for name, u in units.items())
