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
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.kinematics.closure import CableTensions, closure, closures
from gcrules.mechanisms.kinematics.transmission import Transmission, Transmissions

__all__ = [
    "INDICES",
    "Amplification",
    "Amplifications",
    "Drives",
    "Index",
    "amplification",
    "amplifications",
    "index_columns",
]

Floats = NDArray[np.float64]

_RANK = 1e-9
_ROUNDING = 1e-13


@dataclass(frozen=True)
class Drives:
    """What actuators drive: `angles` tells of each whether it turns, `pulls` whether it is a cable; the platform has so
    many `freedoms`. The limbs are `plain` if none has loops of its own; `constraints` is the number of all their
    constraints where none depends on the others, else 0.
    """

    angles: tuple[bool, ...]
    freedoms: int
    pulls: tuple[bool, ...]
    plain: bool
    constraints: int

    @property
    def redundant(self) -> bool:
        """Whether there are more actuators than freedoms, so that none moves alone."""
        return len(self.angles) > self.freedoms

    @property
    def mixed(self) -> bool:
        """Whether some actuators turn and others slide: their rates have no unit in common."""
        return any(self.angles) and not all(self.angles)

    @property
    def indices(self) -> tuple[str, ...]:
        """Those of `INDICES` that there are."""
        return tuple(name for name in INDICES if not self.missing(name))

    def missing(self, name: str) -> str:
        """Why there is no such index, "" if there is one."""
        return next((why for why, names, fails in _MISSING if name in names and fails(self)), "")


@dataclass(frozen=True, eq=False)
class Amplifications(HoldsArrays):
    """All numbers that an `Amplification` has, for each of N configurations: `speeds` and `turns` (N, actuators),
    `condition_numbers` (N,). `rates` (N, actuators, freedoms) are those for unit motions in the freedoms, `twists`
    (N, actuators, 6) those (v at the centre; ω) to which the actuators lead one by one.
    """

    drives: Drives
    length: float
    rates: Floats
    twists: Floats
    speeds: Floats
    turns: Floats
    condition_numbers: Floats
    transmissions: Transmissions | None = None

    @property
    def isotropy(self) -> Floats:
        """1 over the condition numbers (N,), 0 where they are infinite."""
        return 1 / self.condition_numbers

    @property
    def passing(self) -> Transmissions:
        """What the limbs pass on. Only of limbs without loops of their own."""
        assert self.transmissions is not None, "drives.missing tells where there are none"
        return self.transmissions

    @cached_property
    def closures(self) -> Floats:
        """The least tensions of the cables (N,) where the mean one is 1 and all balance each other."""
        return closures(self.rates, self.drives.pulls)

    @property
    def indices(self) -> Mapping[str, Floats]:
        """All of `INDICES` that these actuators have, (N,) each."""
        return {name: INDICES[name].of(self) for name in self.drives.indices}

    def to_json(self) -> dict[str, list[float | None]]:
        """Lists of the indices, null where they are infinite or do not exist."""
        return {n: [x if math.isfinite(x) else None for x in v.tolist()] for n, v in self.indices.items()}

    @classmethod
    def together(cls, parts: Sequence[Amplifications]) -> Amplifications:
        """Those of several stacks of one robot."""
        names = ("rates", "twists", "speeds", "turns", "condition_numbers")
        arrays: dict[str, Any] = {n: np.concatenate([getattr(p, n) for p in parts]) for n in names}
        passing = [p.transmissions for p in parts if p.transmissions is not None]
        together = Transmissions.together(passing) if passing else None
        return cls(parts[0].drives, parts[0].length, **arrays, transmissions=together)


@dataclass(frozen=True)
class Amplification:
    """For each actuator (`angles` says of each whether it turns) the `speeds` |v_i| of the platform's centre and the
    `turns` |ω_i| (rad) for a unit of its rate (1 rad, or the unit of length), all others locked; infinite where the
    robot is singular, not a number where an actuator applies no wrench, or where there are more actuators than
    freedoms, so that none moves alone. `condition_number` is that of the twists, turns weighed with `length` against
    shifts and the rates of angles likewise against those of lengths, where the robot has
    both kinds of actuators. The `transmission` is that of the limbs, none where one of them has loops of its own.
    """

    actuators: tuple[str, ...]
    angles: tuple[bool, ...]
    speeds: tuple[float, ...]
    turns: tuple[float, ...]
    condition_number: float
    length: float
    cables: CableTensions | None = None
    transmission: Transmission | None = None

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
            "transmission": self.transmission.to_json() if self.transmission else None,
        }


def amplification(
    actuations: Floats,
    constraints: Floats,
    names: Sequence[str],
    drives: Drives,
    length: float,
    transmission: Transmission | None = None,
) -> Amplification:
    """From the wrenches (f; m about the centre) of the actuators (n, 6), whose product with a twist is their rate, and
    of the constraints (k, 6), which elsewhere leave so many freedoms as there are.
    """
    held = np.reshape(constraints, (1, -1, 6))
    every = amplifications(np.asarray(actuations)[None], held, drives, length)
    speeds, turns = (tuple(map(float, a[0])) for a in (every.speeds, every.turns))
    condition = float(every.condition_numbers[0])
    cables = _tensions(every, held, names) if any(drives.pulls) and math.isfinite(condition) else None
    return Amplification(tuple(names), drives.angles, speeds, turns, condition, length, cables, transmission)


def _tensions(a: Amplifications, constraints: Floats, names: Sequence[str]) -> CableTensions:
    found = closure(a.rates[0], a.drives.pulls)
    if found.efforts is not None:
        return CableTensions(found.least, tuple(zip(names, found.efforts.tolist(), strict=True)))
    assert found.escape is not None
    twist = found.escape @ _free(constraints, a.length, a.drives.freedoms)[0][0] / _scale(a.length)
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


def amplifications(actuations: Floats, constraints: Floats, drives: Drives, length: float) -> Amplifications:
    """The same in N configurations: wrenches of the actuators (N, n, 6) and of the constraints (N, k, 6)."""
    scale, freedoms = _scale(length), drives.freedoms
    free, rank = _free(constraints, length, freedoms)
    units = np.where(drives.angles, length, 1.0) if drives.mixed else np.ones(len(drives.angles))
    known: NDArray[np.bool_] = np.asarray(np.isfinite(actuations).all(axis=(1, 2)))
    own = np.where(known[:, None, None], actuations, 0.0) / scale
    rates = own @ np.swapaxes(free, 1, 2)
    left, sizes, right = np.linalg.svd(units[:, None] * rates, full_matrices=False)
    largest = np.abs(units[:, None] * own).max(axis=(1, 2), initial=0.0)[:, None]
    lost = np.asarray(sizes <= _RANK * largest)  # all of them are where no wrench does work on a free motion
    twists = units[:, None] * (left / np.where(lost, 1.0, sizes)[:, None] @ right @ free) / scale
    endless = ((np.abs(left) > _RANK) & lost[:, None]).any(axis=2)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratio = sizes[:, 0] / sizes[:, -1] if freedoms else np.full(len(sizes), np.nan)  # nothing that could be driven
        condition = np.where(lost.any(axis=1), np.inf, ratio)
    parts = np.stack([np.linalg.norm(twists[..., k : k + 3], axis=2) for k in (0, 3)]) * [[[1.0]], [[length]]]
    parts[parts <= _ROUNDING * parts.max(axis=(0, 2), keepdims=True)] = 0.0  # a platform that only shifts, or turns
    found = [np.where(endless, np.inf, part) for part in (parts[0], parts[1] / length)]
    found.append(condition)
    others = rank != 6 - freedoms  # the platform has other freedoms here than elsewhere
    for array in found:
        array[~known] = np.nan  # an actuator applies no wrench
        array[others] = np.inf
    twists[endless | (~known | others)[:, None]] = np.nan
    if drives.redundant:
        found[:2] = (np.full_like(part, np.nan) for part in found[:2])
    speeds, turns, conditions = found
    return Amplifications(drives, length, rates, twists, speeds, turns, conditions)


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
            "bound on the shift of the centre for errors of all actuators up to one unit",
            False,
            ("", "{}/rad"),
            lambda a: a.speeds.sum(axis=1),
        ),
        "turn_error": Index(
            "bound on the turn of the platform for errors of all actuators up to one unit",
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
        "input_transmission": Index(
            "least transmission from an actuator to its wrench",
            True,
            ("", ""),
            lambda a: a.passing.inputs.min(axis=1),
        ),
        "output_transmission": Index(
            "least transmission from the wrench of an actuator to the platform",
            True,
            ("", ""),
            lambda a: a.passing.outputs.min(axis=1),
        ),
        "transmission": Index(
            "least transmission of an actuator, input or output",
            True,
            ("", ""),
            lambda a: np.minimum(a.passing.inputs, a.passing.outputs).min(axis=1),
        ),
        "constraint_transmission": Index(
            "least transmission from a constraint to the platform that lacks it",
            True,
            ("", ""),
            lambda a: a.passing.constraints.min(axis=1),
        ),
        "clearance_shift": Index(
            "bound on the shift of the centre for joints with clearances of one unit, and no tilts",
            False,
            ("", ""),
            lambda a: a.passing.clearance_shifts,
        ),
        "clearance_turn": Index(
            "bound on the turn of the platform for joints with clearances of one unit, and no tilts",
            False,
            ("rad/{}", "rad/{}"),
            lambda a: a.passing.clearance_turns,
        ),
        "closure": Index(
            "least tension of the cables by the mean one, where all balance each other; closure is lost below 0",
            True,
            ("", ""),
            lambda a: a.closures,
        ),
    }
)
"""What engineers ask for at many poses. Errors and clearances are bounds to first order: what does not point in one
direction cannot reach them all at once.
"""

_OF_ONE = ("speed", "turn", "shift_error", "turn_error", "force", "couple")  # actuator that moves alone
_OF_LIMBS = ("input_transmission", "output_transmission", "transmission", "constraint_transmission")
_MISSING: tuple[tuple[str, tuple[str, ...], Callable[[Drives], bool]], ...] = (
    ("the robot has no cables", ("closure",), lambda d: not any(d.pulls)),
    (
        "there are more actuators than freedoms, so that none moves alone",
        (*_OF_ONE, *_OF_LIMBS[1:]),
        lambda d: d.redundant,
    ),
    ("some actuators turn and others slide", _OF_ONE, lambda d: d.mixed),
    (
        "a limb has loops of its own",
        (*_OF_LIMBS, "clearance_shift", "clearance_turn"),
        lambda d: not d.plain,
    ),
    (
        "there are no constraints, or some depend on the others",
        ("constraint_transmission",),
        lambda d: not d.constraints,
    ),
)
"""Why there is no index: the reason, of which indices, and when."""


def _inverse(a: Floats) -> Floats:
    with np.errstate(divide="ignore"):
        return np.asarray(1 / a)


def index_columns(a: Amplifications, unit: str) -> tuple[str, ...]:
    """The heads of columns with the indices: "speed [mm/rad]"."""
    units = {name: INDICES[name].unit(unit, a.drives.angles) for name in a.indices}
    return tuple(f"{name.replace('_', ' ')}{f' [{u}]' if u else ''}" for name, u in units.items())
