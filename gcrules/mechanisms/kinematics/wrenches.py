r"""The Jacobian of actuations and constraints as numbers, with the characteristic length."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.floats import without_noise
from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.kinematics.amplification import Amplification, Drives, amplification
from gcrules.mechanisms.kinematics.transmission import Transmission

__all__ = ["WrenchJacobian"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class WrenchJacobian(HoldsArrays):
    """`rows` (f; m), moments about `centre`, with their `labels`: first the actuations, each with product 1 with its
    own joint's twist, then the constraints of all limbs, orthonormal with moments divided by `length`. The product of
    an actuation with a twist (ω; v at the centre) of the platform is the rate of its actuator, that of a constraint 0.
    Where a limb is singular an actuation may not exist: nan there. `actuators` are the names of the first rows'
    actuators, `drives` tells what they drive, `transmission` how well; a `chosen_length` counts in their
    `amplification` only.

    `smallest_singular_value` and `condition_number` are those of the same wrenches as `LimbMargin.rows` has them, with
    `length` as the characteristic length.
    """

    labels: tuple[str, ...]
    rows: Floats
    centre: Floats
    length: float
    smallest_singular_value: float
    condition_number: float
    actuators: tuple[str, ...]
    drives: Drives
    transmission: Transmission | None = None
    chosen_length: float | None = None

    @cached_property
    def amplification(self) -> Amplification:
        """What the actuators make of their rates, with the chosen length if there is one."""
        n, length = len(self.actuators), self.chosen_length or self.length
        return amplification(self.rows[:n], self.rows[n:], self.actuators, self.drives, length, self.transmission)

    def to_json(self) -> dict[str, Any]:
        number = _finite
        return {
            "labels": list(self.labels),
            "rows": [[number(c) for c in row] for row in self.rows],
            "about": [without_noise(c, self.length) for c in self.centre],
            "characteristic_length": self.length,
            "smallest_singular_value": number(self.smallest_singular_value),
            "condition_number": number(self.condition_number),
            "amplification": self.amplification.to_json(),
        }


def _finite(x: float) -> float | None:
    return without_noise(x) if np.isfinite(x) else None
