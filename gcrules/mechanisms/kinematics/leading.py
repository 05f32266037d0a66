"""Of more actuators than freedoms those that are chosen when the robot is driven; the others follow from them."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from gcrules.mechanisms.kinematics.actuations import actuations
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Actuator, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["leading"]

_DEPENDENT = 1e-7  # of wrenches with moments in parts of the robot's size, modulo the constraints


@lru_cache(maxsize=64)
def leading(m: Linkage) -> tuple[Actuator, ...]:
    """All actuators, as a rule; where there are more of them than freedoms the first ones, in the order of the file,
    whose wrenches at home are independent of each other and of the constraints, as many as there are freedoms.
    """
    return _independent(m) if m.robot.redundant else m.actuators


def _independent(m: Linkage) -> tuple[Actuator, ...]:
    scale = np.array([1.0, 1.0, 1.0, m.size, m.size, m.size])
    own = actuations(m, Configurations.of([m.home]))
    chosen: list[Actuator] = []
    rows = np.concatenate(own.held, axis=1)[0] / scale
    for actuator, row in zip(m.actuators, own.driven[0] / scale, strict=True):
        more = np.vstack([rows, row / np.linalg.norm(row)])
        if len(chosen) < m.robot.mobility and _rank(more) > _rank(rows):
            chosen.append(actuator)
            rows = more
    return tuple(chosen)


def _rank(rows: Floats) -> int:
    return int((np.linalg.svd(rows, compute_uv=False) > _DEPENDENT).sum()) if len(rows) else 0
