r"""What the actuators make of their rates: velocity and force amplification, condition number, isotropy.

With all actuators but one locked, a unit rate of that one moves the platform along a twist T_i = (ω_i; v_i at the
centre). These twists are the columns of the inverse of the actuations' part of the Jacobian, on the twists that the
constraints allow. They are the amplification of forces too: by the virtual work of T_i a force f through the centre
needs the effort f · v_i of actuator i, and a couple m the effort m · ω_i. So a unit force through the centre needs at
worst |v_i|, a unit couple at worst |ω_i|; and errors δ_i of the actuators move the centre by at most Σ |v_i| |δ_i|, to
first order.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["Amplification", "amplification"]

Floats = NDArray[np.float64]

_RANK = 1e-9


@dataclass(frozen=True)
class Amplification:
    """For each actuator (`angles` tells of each whether it turns) the `speeds` |v_i| of the platform's centre and the
    `turns` |ω_i| (rad) for a unit of its rate (1 rad, or the unit of length), all others locked; infinite where the
    robot is singular, not a number where an actuator applies no wrench. `condition_number` is that of the twists, turns
    weighed with `length` against shifts and the rates of angles likewise against those of lengths, where the robot has
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
    actuations: Floats, constraints: Floats, names: Sequence[str], angles: Sequence[bool], length: float
) -> Amplification:
    """From the wrenches (f; m about the centre) of the actuators (n, 6), whose product with a twist is their rate, and
    of the constraints (k, 6); `angles` tells of each actuator whether it turns.
    """
    known, scale = (tuple(names), tuple(angles)), np.array([1.0, 1.0, 1.0, length, length, length])
    free = np.eye(6)
    if len(constraints):
        _, sizes, right = np.linalg.svd(constraints / scale)
        free = right[int((sizes > _RANK * sizes[0]).sum()) :]
    if not np.isfinite(actuations).all() or len(free) != len(names):
        number = math.nan if len(free) == len(names) else math.inf
        nowhere = (number,) * len(names)
        return Amplification(*known, nowhere, nowhere, number, length)
    units = np.where(angles, length, 1.0) if any(angles) and not all(angles) else np.ones(len(names))
    left, sizes, right = np.linalg.svd(units[:, None] * (actuations / scale) @ free.T)
    lost = sizes <= _RANK * sizes[0]
    twists = units[:, None] * (left / np.where(lost, 1.0, sizes) @ right @ free) / scale
    endless = (np.abs(left[:, lost]) > _RANK).any(axis=1)
    speeds, turns = (np.where(endless, np.inf, np.linalg.norm(twists[:, k : k + 3], axis=1)) for k in (0, 3))
    condition = math.inf if lost.any() else float(sizes[0] / sizes[-1])
    return Amplification(*known, tuple(speeds.tolist()), tuple(turns.tolist()), condition, length)
