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
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.kinematics.closure import closure, closures

__all__ = [
    "INDICES",
    "Amplification",
    "Amplifications",
    "CableTensions",
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
    `condition_numbers` (N,). The platform has so many `freedoms`; `rates` (N, actuators, freedoms) are those for unit
    motions in these, and `pulls` tells which actuators are cables.
    """

    angles: tuple[bool, ...]
    freedoms: int
    length: float
    pulls: tuple[bool, ...]
    rates: Floats
    speeds: Floats
    turns: Floats
    condition_numbers: Floats

    @property
    def isotropy(self) -> Floats:
        """1 over the condition numbers (N,), 0 where they are infinite."""
        return 1 / self.condition_numbers

    @cached_property
    def closures(self) -> Floats:
        """The least tensions of the cables (N,) where the mean one is 1 and all balance each other."""
        return closures(self.rates, self.pulls)

    @property
    def indices(self) -> Mapping[str, Floats]:
        """All of `INDICES` that these actuators have, (N,) each."""
        return {name: INDICES[name].of(self) for name in index_names(self.angles, self.freedoms, self.pulls)}

    def to_json(self) -> dict[str, list[float | None]]:
        """Lists of the indices, null where they are infinite or do not exist."""
        return {n: [x if math.isfinite(x) else None for x in v.tolist()] for n, v in self.indices.items()}

    @classmethod
    def together(cls, parts: Sequence[Amplifications]) -> Amplifications:
        """Those of several stacks of one robot."""
        names = ("rates", "speeds", "turns", "condition_numbers")
        arrays = (np.concatenate([getattr(p, n) for p in parts]) for n in names)
        return cls(parts[0].angles, parts[0].freedoms, parts[0].length, parts[0].pulls, *arrays)


@dataclass(frozen=True)
class CableTensions:
    """Whether cables, which only pull, hold the platform: the `least` tension, for a mean one of 1, where all efforts
    balance each other. Where it is positive these are the `efforts`, by actuator; else the platform can move along the
    twist `escape` (v at the centre; ω) without any cable getting longer.
    """

    least: float
    efforts: tuple[tuple[str, float], ...] = ()
    escape: tuple[float, ...] | None = None

    @property
    def held(self) -> bool:
        """Whether there is wrench closure."""
        return not self.escape

    def to_json(self) -> dict[str, Any]:
        return {
            "closure": self.held,
            "least_tension": self.least,
            "efforts": dict(self.efforts),
            "escape": None if self.escape is None else list(self.escape),
        }


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
    cables: CableTensions | None = None

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
            "cables": self.cables.to_json() if self.cables else None,
        }


def amplification(
    actuations: Floats,
    constraints: Floats,
    names: Sequence[str],
    angles: Sequence[bool],
    freedoms: int,
    length: float,
    pulls: Sequence[bool] = (),
) -> Amplification:
    """From the wrenches (f; m about the centre) of the actuators (n, 6), whose product with a twist is their rate, and
    of the constraints (k, 6), which elsewhere leave so many freedoms; `angles` tells of each actuator whether it turns.
    """
    held = np.reshape(constraints, (1, -1, 6))
    every = amplifications(np.asarray(actuations)[None], held, angles, freedoms, length, pulls)
    speeds, turns = (tuple(map(float, a[0])) for a in (every.speeds, every.turns))
    condition = float(every.condition_numbers[0])
    cables = _tensions(every, held, names) if any(pulls) and math.isfinite(condition) else None
    return Amplification(tuple(names), tuple(angles), speeds, turns, condition, length, cables)


def _tensions(a: Amplifications, constraints: Floats, names: Sequence[str]) -> CableTensions:
    found = closure(a.rates[0], a.pulls)
    if found.efforts is not None:
        return CableTensions(found.least, tuple(zip(names, found.efforts.tolist(), strict=True)))
    assert found.escape is not None
    twist = found.escape @ _free(constraints, a.length, a.freedoms)[0][0] / _scale(a.length)
    return CableTensions(found.least, (), tuple(twist.tolist()))


def _scale(length: float) -> Floats:
    return np.array([1.0, 1.0, 1.0, length, length, length])


def _free(constraints: Floats, length: float, freedoms: int) -> tuple[Floats, NDArray[np.intp]]:
    """Orthonormal motions (N, freedoms, 6) that the constraints (N, k, 6) allow, and the ranks of these (N,)."""
    held = np.zeros((len(constraints), max(6, constraints.shape[1]), 6))  # with rows of zeros there are six values
    held[:, : constraints.shape[1]] = constraints / _scale(length)
    _, sizes, right = np.linalg.svd(held, full_matrices=True)
    rank = (sizes > _RANK * np.where(sizes[:, :1] > 0, sizes[:, :1], 1.0)).sum(axis=1)
    return np.asarray(right[:, 6 - freedoms :]), rank


def amplifications(
    actuations: Floats,
    constraints: Floats,
    angles: Sequence[bool],
    freedoms: int,
    length: float,
    pulls: Sequence[bool] = (),
) -> Amplifications:
    """The same in N configurations: wrenches of the actuators (N, n, 6) and of the constraints (N, k, 6)."""
    scale, number = _scale(length), len(angles)
    free, rank = _free(constraints, length, freedoms)
    units = np.where(angles, length, 1.0) if mixed(angles) else np.ones(number)
    known: NDArray[np.bool_] = np.asarray(np.isfinite(actuations).all(axis=(1, 2)))
    own = np.where(known[:, None, None], actuations, 0.0) / scale
    rates = own @ np.swapaxes(free, 1, 2)
    left, sizes, right = np.linalg.svd(units[:, None] * rates, full_matrices=False)
    largest = np.abs(units[:, None] * own).max(axis=(1, 2), initial=0.0)[:, None]
    lost = np.asarray(sizes <= _RANK * largest)  # all of them are where no wrench does work on a free motion
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
    return Amplifications(tuple(angles), freedoms, length, tuple(pulls), rates, *found)


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
            "bound of the shift of the centre for errors of all actuators up to one unit",
            False,
            ("", "{}/rad"),
            lambda a: a.speeds.sum(axis=1),
        ),
        "turn_error": Index(
            "bound of the turn of the platform for errors of all actuators up to one unit",
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
        "closure": Index(
            "least tension of the cables by the mean one, where all balance each other; closure is lost below 0",
            True,
            ("", ""),
            lambda a: a.closures,
        ),
    }
)
"""What engineers ask for at many poses. Errors are bounds to first order: actuators whose effects do not point in one
direction cannot reach them all at once. All but isotropy and closure need actuators of one kind, and no more of them
than freedoms.
"""


def _inverse(a: Floats) -> Floats:
    with np.errstate(divide="ignore"):
        return np.asarray(1 / a)


def index_names(angles: Sequence[bool], freedoms: int, pulls: Sequence[bool] = ()) -> tuple[str, ...]:
    """Those of `INDICES` that actuators have, of which `angles` tells whether they turn and `pulls` whether they are
    cables, on so many freedoms.
    """
    rigid = tuple(n for n in INDICES if n != "closure")
    found = ("isotropy",) if mixed(angles) or len(angles) > freedoms else rigid
    return (*found, "closure") if any(pulls) else found


def index_columns(a: Amplifications, unit: str) -> tuple[str, ...]:
    """The heads of columns with the indices: "speed [mm/rad]"."""
    units = {name: INDICES[name].unit(unit, a.angles) for name in a.indices}
    return tuple(f"{name.replace('_', ' ')}{f' [{u}]' if u else ''}" for name, u in units.items())
