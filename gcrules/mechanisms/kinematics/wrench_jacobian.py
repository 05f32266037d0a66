"""The Jacobian of actuations and constraints of a linkage: at a configuration, or at a pose."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.actuations import amplified, drives
from gcrules.mechanisms.kinematics.chains import geometry_of
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Actuator, Configuration, Linkage
from gcrules.mechanisms.kinematics.margin import LimbMargin, margin
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import coordinates_target, pose_target, read_pose
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.screws import JOINTS, Joint, Limb, jacobian
from gcrules.screws.floats import Floats as FloatField
from gcrules.screws.pose import Pose

__all__ = ["wrench_jacobian", "wrenches_at"]


def wrenches_at(m: Linkage, at: Pose | str | Mapping[str, Any] | None) -> WrenchJacobian:
    """Actuations and constraints of all limbs, with moments about the moved centre; at home without a pose."""
    if at is None:
        here = m.home
    elif isinstance(at, str):
        here = solve(m, read_pose(m, at)).configuration
    else:
        here = solve(m, pose_target(m, at) if isinstance(at, Pose) else coordinates_target(m, at)).configuration
    return wrench_jacobian(m, here, margin(m, here))


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
