r"""The sign of the determinant of the undriven joints' screws, which closes the loops when the actuators are locked.

With the actuators locked the links can move where the screws of all other joints, as columns of the loops' equations,
depend on each other. Where there are as many of these joints as equations they are a square matrix. Its determinant is
a continuous function of the configuration, whatever the way to it and whichever branch it lies on, and is 0 exactly
where something can move. So between two configurations in which it has opposite signs every way is singular somewhere.

For that the axis of a joint is the one that its links carry along from home: the direction between two points would
turn round where these pass each other. The motions of ball joints, of planar joints and of pairs of rods are taken as
the names make them, since their amounts are not unique.

Robots with freedoms that are idle, such as rods that spin about themselves, with more actuators than freedoms, or
whose loops ask for less than six equations, have no such matrix. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.chains import Chain, shape_of
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import loop_rows, units_of
from gcrules.poses.limbs.many import Solved

__all__ = ["closing_signs"]

_PLANE = (2, 3, 4)
_ZERO = 1e-9  # of the determinant, in parts of the product of its columns' lengths
_SEVERAL_WAYS = ("S", "E", "4S")  # joints whose motions are not unique


def closing_signs(there: Solved) -> NDArray[np.int8] | None:
    """The sign (N,) in configurations, 0 where it is 0 within rounding; None for robots that have none."""
    m = there.m.linkage
    twists = [c.shared_twists for c in _chains(there)]
    rows = loop_rows(twists, there.here.platform, m) * units_of(m)
    if m.robot.family.plane:
        rows = rows.reshape(len(there), -1, 6, rows.shape[2])[:, :, _PLANE].reshape(len(there), -1, rows.shape[2])
    square = rows[:, :, _undriven(m)]
    if square.shape[1] != square.shape[2]:
        return None
    square = square / np.maximum(np.linalg.norm(square, axis=1, keepdims=True), 1e-300)
    found = np.linalg.det(square)
    return np.asarray(np.where(np.abs(found) > _ZERO, np.sign(found), 0), dtype=np.int8)


def _chains(there: Solved) -> Iterator[Chain]:
    """The limbs with axes as their links carry them, but for joints whose motions are not unique."""
    m = there.m.linkage
    for limb, home, named, links in zip(m.robot.limbs, m.home.chains, there.here.chains, there.links, strict=True):
        several = [j.kind in _SEVERAL_WAYS for j in limb.joints for _ in shape_of(j.kind).motions]
        carried = home.after(links).screws
        yield replace(home, screws=np.where(np.array(several)[:, None], named.screws, carried))


def _undriven(m: Linkage) -> list[int]:
    """The places of the coordinates that are not driven, among those of all limbs."""
    starts = np.cumsum([0, *(len(c.turns) for c in m.home.chains)])
    driven = {int(starts[a.place]) + a.coordinate for a in m.actuators}
    return [k for k in range(int(starts[-1])) if k not in driven]
