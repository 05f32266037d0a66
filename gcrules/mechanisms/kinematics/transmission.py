r"""How well limbs pass on motion and force, and what clearances in their joints let the platform do.

A wrench (f; m) at a point P and a twist (v; ω) there have the power f · v + m · ω, at most |f| |v| + |m| |ω| for a
force and a couple of these sizes. What it is by the most that it can be is the transmission of the one to the other:
the cosine of the pressure angle, for a force through P; 1 where all that is pushed moves along, 0 where nothing is
passed on. An actuator's wrench is reciprocal to all other joints of its limb, and of those that differ by a constraint
of the limb only, which does no work, the least one at the limb's end: for limbs that end in a ball joint a force.

- input: from the actuator's own motion to its wrench, at the place of the joint that follows it (for a crank and a rod
  the sine of the angle between them);
- output: from the wrench to the motion of the platform with the other actuators locked, at the limb's end;
- constraint: from a constraint of a limb to the motion that the platform has when this one alone is taken away and all
  actuators are locked, at the limb's end, where no constraint depends on the others. Of a limb with several of them
  those count that lead to the largest motions, to the smallest, and to those between.

Sources: the transmission index of Sutherland and Roth, generalized by Chen and Angeles (Mechanism and Machine Theory
42, 2007); input and output by Wang, Wu and Liu (same journal 45, 2010); constraints by Liu, Chen and Xie (same journal
73, 2014). These measure against a wrench of the same pitch; for forces through the point, and for couples, it is the
same.

Clearances: the two bodies that a joint connects shift against each other by up to one unit, in any direction; they do
not tilt. A limb's wrenches, which are forces F at one of its joints, then see the shift F e there, and the platform
moves by the part W⁺ F of it, where W are the wrenches of all limbs. The norms of these maps add up to a bound, to first
order. A parallelogram of rods with ball joints passes on a force along each rod, so that it tilts too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.kinematics.rigid_motions import crossed, lengths

__all__ = ["Transmission", "Transmissions", "of_constraints", "shaken", "transmitted"]

Floats = NDArray[np.float64]

_RANK = 1e-9
_ROUNDING = 1e-12


@dataclass(frozen=True)
class Transmission:
    """Of each actuator the `inputs` and the `outputs`, not numbers where there are more actuators than freedoms; of
    each independent constraint that of the `constraints`, none where they depend on each other. For clearances of one
    unit of length in every joint, which shift it and do not tilt it, bounds of the `clearance_shift` of the platform's
    centre and of the `clearance_turn` of the platform in rad.
    """

    inputs: tuple[float, ...]
    outputs: tuple[float, ...]
    constraints: tuple[float, ...]
    clearance_shift: float
    clearance_turn: float

    def to_json(self) -> dict[str, Any]:
        """Lists and numbers; null where they are infinite or do not exist."""

        def number(x: float) -> float | None:
            return x if np.isfinite(x) else None

        return {
            "inputs": [number(x) for x in self.inputs],
            "outputs": [number(x) for x in self.outputs],
            "constraints": [number(x) for x in self.constraints],
            "clearance_shift": number(self.clearance_shift),
            "clearance_turn": number(self.clearance_turn),
        }


@dataclass(frozen=True, eq=False)
class Transmissions(HoldsArrays):
    """Of N configurations all that a `Transmission` has of one, with the axis of the configurations first."""

    inputs: Floats
    outputs: Floats
    constraints: Floats
    clearance_shifts: Floats
    clearance_turns: Floats

    def one(self, place: int) -> Transmission:
        """That of one configuration."""
        inputs, outputs, constraints, shift, turn = (getattr(self, f.name)[place].tolist() for f in fields(self))
        return Transmission(tuple(inputs), tuple(outputs), tuple(constraints), shift, turn)

    @classmethod
    def together(cls, parts: Sequence[Transmissions]) -> Transmissions:
        """Those of several stacks of one robot."""
        return cls(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(cls)))


def transmitted(wrenches: Floats, twists: Floats, arms: Floats) -> Floats:
    """From wrenches (..., 6) of (f; m) and twists (v; ω) about one centre, the power at the ends of the arms from there
    by the largest one, (...); 0 where the wrench or the twist is nothing, or no numbers.
    """
    f, v, turn = wrenches[..., :3], twists[..., :3], twists[..., 3:]
    own = wrenches[..., 3:] - crossed(arms, f)
    power = np.abs((wrenches * twists).sum(axis=-1))
    with np.errstate(invalid="ignore", over="ignore"):
        most = lengths(f) * lengths(v + crossed(turn, arms)) + lengths(own) * lengths(turn)
        found = power / np.where(most > 0, most, 1.0)
    return np.asarray(np.where((most > 0) & np.isfinite(found), np.minimum(found, 1.0), 0.0))


def of_constraints(driven: Floats, constraints: Sequence[Floats], arms: Sequence[Floats], length: float) -> Floats:
    """For wrenches of the actuators (N, n, 6) and those of each limb's constraints (N, k, 6), which are six together,
    about a centre from which the arms (N, 3) lead to the limbs' ends: the transmission of each constraint, (N, 6 − n).
    """
    scale = np.array([1.0, 1.0, 1.0, length, length, length])
    rows = np.concatenate([driven, *constraints], axis=1) / scale
    rows[..., :, :] = np.where(np.isfinite(rows).all(axis=(1, 2))[:, None, None], rows, 0.0)
    sizes = np.linalg.norm(rows, axis=2, keepdims=True)
    unit = rows / np.where(sizes > 0, sizes, 1.0)
    left, singular, right = np.linalg.svd(unit)
    lost = singular[:, -1] <= _RANK
    inverse = np.swapaxes(left / np.where(lost[:, None], 1.0, singular)[:, None] @ right, 1, 2) / scale[:, None]
    found, start = [], driven.shape[1]
    for own, arm in zip(constraints, arms, strict=True):
        if not own.shape[1]:
            continue
        columns = slice(start, start + own.shape[1])
        twists = inverse[:, :, columns]
        ends = np.concatenate([twists[:, :3] - crossed(arm[:, None], twists[:, 3:].swapaxes(1, 2)).swapaxes(1, 2)], 1)
        each = np.linalg.svd(np.concatenate([ends, length * twists[:, 3:]], axis=1))[2]
        wrenches = each @ (unit[:, columns] * scale)
        found.append(transmitted(wrenches, each @ np.swapaxes(twists, 1, 2), arm[:, None]))
        start = columns.stop
    return np.where(lost[:, None], 0.0, np.concatenate(found, axis=1))


def shaken(
    wrenches: Sequence[Floats],
    forces: Sequence[Sequence[tuple[int, Floats]]],
    keep: Sequence[int],
    length: float,
) -> tuple[Floats, Floats]:
    """Bounds (N,) of the shift and of the turn for clearances of one unit in all joints. The `wrenches` of each limb
    with locked actuators are (N, k, 6); they are `forces` (N, k, 3) at its joints, each at so many of these. The axes
    to `keep` are those in which the robot lives. Infinite where it is singular.
    """
    axes, scale = list(keep), np.array([1.0, 1.0, 1.0, length, length, length])[list(keep)]
    left, sizes, right = np.linalg.svd(np.concatenate(wrenches, axis=1)[..., axes] / scale, full_matrices=False)
    lost = sizes[:, -1] <= _RANK * sizes[:, 0]
    inverse = np.swapaxes(left / np.where(lost[:, None], 1.0, sizes)[:, None] @ right, 1, 2)
    parts = [[k for k, axis in enumerate(axes) if (axis >= 3) == turns] for turns in (False, True)]
    found, start = np.zeros((2, len(lost))), 0
    for own, at_joints in zip(wrenches, forces, strict=True):
        columns = slice(start, start + own.shape[1])
        for count, force in at_joints:
            moved = inverse[:, :, columns] @ force[..., [axis for axis in axes if axis < 3]]
            found += count * np.stack([_largest(moved[:, part]) for part in parts])
        start = columns.stop
    found[1, found[1] <= _ROUNDING * found[0]] = 0.0  # a platform that only shifts
    return np.where(lost, np.inf, found[0]), np.where(lost, np.inf, found[1] / length)


def _largest(matrices: Floats) -> Floats:
    """The largest singular value of each, which is the norm that they have as maps."""
    return np.asarray(np.linalg.svd(matrices, compute_uv=False).max(axis=-1))
