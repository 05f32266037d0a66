"""The Jacobian of actuations and constraints at a configuration, and its numbers with the characteristic length."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcrules.core.floats import without_noise
from gcrules.core.frozen import HoldsArrays
from gcrules.mechanisms.kinematics.actuations import amplified, drives
from gcrules.mechanisms.kinematics.amplification import Amplification, Drives, amplification
from gcrules.mechanisms.kinematics.chains import geometry_of
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Actuator, Configuration, Linkage
from gcrules.mechanisms.kinematics.margin import LimbMargin
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.transmission import Transmission
from gcrules.screws import JOINTS, Joint, Limb, jacobian
from gcrules.screws.floats import Floats as FloatField

__all__ = ["WrenchJacobian", "wrench_jacobian"]


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

    @property
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


def wrench_jacobian(m: Linkage, here: Configuration, near: LimbMargin) -> WrenchJacobian:
    """The Jacobian at a configuration, whose margin is known, about the centroid of the limbs' ends."""
    platform = here.platform
    centre = platform[:3, :3] @ m.centre + platform[:3, 3]
    points = {d.name for d in m.robot.family.definitions if d.sort == "point"}
    shifted = {n: v - centre if n in points else v for n, v in here.values.items()}
    field = FloatField(length=m.size)
    found = jacobian((_limb(m, place, shifted) for place in range(len(here.chains))), field)
    rows = np.asarray(found.matrix)
    passing = amplified(m, Configurations.of([here])).transmissions
    labels: list[str] = []
    actuators: list[Actuator] = []
    for label in found.labels:
        own = [a for a in m.actuators if m.robot.limbs[a.place].name == label.limb]
        if label.kind == "actuation":
            actuators.append(own[label.place])
            labels.append(f"{label.limb}: {own[label.place].name}")
        else:
            labels.append(str(label))
    return WrenchJacobian(
        tuple(labels),
        rows,
        centre,
        m.size,
        near.smallest_singular_value,
        near.condition_number,
        tuple(a.name for a in actuators),
        drives(m),
        passing.one(0) if passing else None,
    )


def _limb(m: Linkage, place: int, values: Mapping[str, Floats]) -> Limb:
    """The limb with directions of length 1, so that rates are in radians and lengths for each second."""
    text = m.robot.limbs[place]
    joints = []
    for j in text.joints:
        geometry = geometry_of(j, values)
        kind = JOINTS[j.kind]
        parts = {
            p: tuple(map(float, geometry[p])) if form != "number" else geometry[p] for p, form in kind.parts.items()
        }
        joints.append(Joint(kind, parts, j.actuated))
    return Limb(tuple(joints), text.name, text.shares, text.coupled)
