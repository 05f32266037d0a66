r"""The sign of the determinant of the undriven joints' screws, which closes the loops when the actuators are locked.

With the actuators locked the links can move where the screws of all other joints, as columns of the loops' equations,
depend on each other. Where there are as many of these joints as equations they are a square matrix. Its determinant is
a continuous function of the configuration, whatever the way to it and whichever branch it lies on, and is 0 exactly
where something can move. So between two configurations in which it has opposite signs every way is singular somewhere.

Robots with freedoms that are idle, such as rods that spin about themselves, with more actuators than freedoms, or
whose loops ask for less than six equations, have no such matrix. Derived here.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import loop_rows, units_of

__all__ = ["closing_signs"]

_PLANE = (2, 3, 4)
_ZERO = 1e-9  # of the determinant, in parts of the product of its columns' lengths


def closing_signs(m: Linkage, here: Configurations) -> NDArray[np.int8] | None:
    """The sign (N,) in configurations, 0 where it is 0 within rounding; None for robots that have none."""
    rows = loop_rows([c.shared_twists for c in here.chains], here.platform, m) * units_of(m)
    if m.robot.family.plane:
        rows = rows.reshape(len(here), -1, 6, rows.shape[2])[:, :, _PLANE].reshape(len(here), -1, rows.shape[2])
    square = rows[:, :, _undriven(m)]
    if square.shape[1] != square.shape[2]:
        return None
    square = square / np.maximum(np.linalg.norm(square, axis=1, keepdims=True), 1e-300)
    found = np.linalg.det(square)
    return np.asarray(np.where(np.abs(found) > _ZERO, np.sign(found), 0), dtype=np.int8)


def _undriven(m: Linkage) -> list[int]:
    """The places of the coordinates that are not driven, among those of all limbs."""
    starts = np.cumsum([0, *(len(c.turns) for c in m.home.chains)])
    driven = {int(starts[a.place]) + a.coordinate for a in m.actuators}
    return [k for k in range(int(starts[-1])) if k not in driven]
