r"""Many poses at once: the numbers of `pose` as arrays, without loops over poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.amplification import Amplifications
from gcrules.mechanisms.kinematics.leg_amplification import amplified_by_legs
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.incidence_measures import IncidenceMeasure, readings
from gcrules.rules.condition import Condition
from gcrules.screws.guarantees import ROUNDING, guarantees, noise
from gcrules.screws.margin import LegJacobians, jacobian
from gcrules.screws.threshold import Threshold, margin_of
from gcrules.screws.verdict import VERDICTS, rank

__all__ = ["PoseNumbers", "homogeneous", "numbers", "scaled_superbracket"]

Floats = NDArray[np.float64]

_BEYOND = "the superbracket is too large or too small for floats in some poses: inf or 0 there; choose another unit"

CHUNK = 20_000
"""Poses that are computed at once; the memory that is used grows with it."""


@dataclass(frozen=True, eq=False)
class PoseNumbers(HoldsArrays, Shown):
    """Arrays over N poses, shape (N,); the names and units are those of `PoseReport`. `readings` hold arrays
    too, and `amplifications` what the legs make of their rates; `notes` say what was changed on reading.

    These are floats: a pose is called singular where `margin` is 0 within their rounding.
    """

    value: Floats
    margin: Floats
    turn: Floats
    shift: Floats
    rotation: Floats
    combined: Floats
    noise: Floats
    smallest_singular_value: Floats
    condition_number: Floats
    verdict: NDArray[np.str_]
    amplifications: Amplifications
    readings: tuple[IncidenceMeasure, ...]
    radius: float
    unit: str
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.value)

    def to_json(self) -> dict[str, Any]:
        """Lists of numbers, null for those that are infinite or not valid."""
        names = ["value", "margin", "turn", "shift", "rotation", "combined", "noise"]
        names += ["smallest_singular_value", "condition_number"]
        return {
            "unit": self.unit,
            "characteristic_length": self.radius,
            **{name: _finite(getattr(self, name)) for name in names},
            "verdict": self.verdict.tolist(),
            **self.amplifications.to_json(),
            "readings": [
                {"part": r.part, "name": r.name, "values": _finite(np.where(r.valid, r.values, np.nan))}
                for r in self.readings
            ],
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        counts = ", ".join(f"{(self.verdict == v).sum()} {v}" for v in ("regular", "close", "singular"))
        return f"<PoseNumbers of {len(self)} poses: {counts}>"


def _finite(values: Floats) -> list[float | None]:
    return [float(v) if np.isfinite(v) else None for v in values]


def homogeneous(rig: MovingPlatform, translations: Floats, rotations: Floats) -> dict[str, Floats]:
    """Coordinates (N, 4) of every joint at N poses."""
    ends = rig.ends(translations, rotations)
    one = np.ones((len(ends), 1))
    found = {}
    for k, (a, b) in enumerate(rig.legs):
        found[a] = np.concatenate([np.broadcast_to(rig.base[k], (len(ends), 3)), one], axis=1)
        found[b] = np.concatenate([ends[:, k], one], axis=1)
    return found


def numbers(
    rig: MovingPlatform,
    conditions: Sequence[Condition],
    poses: tuple[Floats, Floats],
    threshold: Threshold,
    accuracy: float,
) -> PoseNumbers:
    """All numbers at the poses (translations, rotations). Raises InputError for a leg of no length."""
    if threshold.angle is None:
        raise InputError(
            "a threshold of length needs the nearest singular pose, which is not sought for many poses",
            hint="give an angle: 2deg",
        )
    count = len(poses[0])
    parts = [
        _numbers(rig, conditions, (poses[0][i : i + CHUNK], poses[1][i : i + CHUNK]), threshold.angle, accuracy, i)
        for i in range(0, count, CHUNK)
    ]
    return parts[0] if len(parts) == 1 else _joined(parts)


def _joined(parts: Sequence[PoseNumbers]) -> PoseNumbers:
    first = parts[0]
    arrays: dict[str, Any] = {
        f.name: np.concatenate([getattr(p, f.name) for p in parts])
        for f in fields(first)
        if isinstance(getattr(first, f.name), np.ndarray)
    }
    joined = tuple(
        replace(
            same[0],
            values=np.concatenate([r.values for r in same]),
            valid=np.concatenate([r.valid for r in same]),
            why=next((r.why for r in same if r.why), ""),
        )
        for same in zip(*(p.readings for p in parts), strict=True)
    )
    notes = tuple(dict.fromkeys(note for p in parts for note in p.notes))
    every = Amplifications.together([p.amplifications for p in parts])
    return replace(first, amplifications=every, readings=joined, notes=notes, **arrays)


def scaled_superbracket(moving: MovingPlatform, j: LegJacobians) -> Floats:
    """The superbracket over ρ³ Π lengths in N poses, shape (N,), with its sign; ρ is the characteristic length."""
    found: Floats = -moving.structure.orientation * np.linalg.det(j.rows)
    return found


def _numbers(
    rig: MovingPlatform,
    conditions: Sequence[Condition],
    poses: tuple[Floats, Floats],
    angle: float,
    accuracy: float,
    first: int,
) -> PoseNumbers:
    """The numbers of one chunk, that begins with pose `first`."""
    ends = rig.ends(*poses, first)
    j = jacobian(rig.base, ends)
    bounds = guarantees(j)
    spread, floor = noise(j, accuracy), noise(j, ROUNDING * rig.size)
    with np.errstate(over="ignore", under="ignore"):
        value = scaled_superbracket(rig, j) * j.radius**3 * j.lengths.prod(axis=1)
    return PoseNumbers(
        value=value,
        margin=j.sigma,
        turn=bounds.turn,
        shift=bounds.shift,
        rotation=bounds.rotation,
        combined=bounds.combined,
        noise=spread,
        smallest_singular_value=j.singular_values[:, 5],
        condition_number=j.condition_number,
        verdict=np.array(VERDICTS)[rank(j.sigma, floor, spread, margin_of(angle))],
        amplifications=amplified_by_legs(rig.base, ends, poses[0] + rig.centre_of_turns),
        readings=readings(conditions, homogeneous(rig, *poses)),
        radius=j.radius,
        unit=rig.unit,
        notes=(_BEYOND,) if (np.isinf(value) | ((value == 0) & (j.sigma > floor))).any() else (),
    )
