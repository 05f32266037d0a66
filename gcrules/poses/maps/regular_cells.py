r"""Cells of any slice that are free of singular poses, proved by the bounds of `leg_bounds` around their middles.

The largest turn φ in a cell is at most the length of the change of a rotation vector, since the exponential map of
rotations shortens distances, or the sum of the changes of Euler angles. Turning the direction of a tilt θ by δ turns
the platform by at most 2δ sin(θ/2): the unit quaternion moves on a circle of radius sin(θ/2). One angle alone turns
about an axis that it does not change.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import rotation_vector
from gcrules.poses.maps.grid import Grid
from gcrules.poses.regions.leg_bounds import are_regular

__all__ = ["reach", "regular_cells"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

_DEPTH = {2: 4, 3: 2}  # halvings, by the number of axes
_BLOCK = 2_500  # cells at once


def regular_cells(g: Grid, cells: Integers) -> Booleans:
    """Which of the cells with these lower nodes (N, axes) are proved to be free of singular poses."""
    found = np.ones(len(cells), dtype=bool)
    axes = cells.shape[1]
    for start in range(0, len(cells), _BLOCK):
        checkpoint()
        owner = np.arange(start, min(start + _BLOCK, len(cells)))
        middle = cells[owner].astype(np.float64) + 0.5
        half = 0.5
        for depth in range(_DEPTH[axes] + 1):
            checkpoint()
            left = ~_free(g, middle, half)
            middle, owner = middle[left], owner[left]
            if not len(owner) or depth == _DEPTH[axes]:
                break
            half /= 2
            for axis in range(axes):
                step = np.zeros(axes)
                step[axis] = half
                middle = np.concatenate([middle - step, middle + step])
                owner = np.concatenate([owner, owner])
        found[owner] = False
    return found


def _free(g: Grid, middle: Floats, half: float) -> Booleans:
    shifts, turn = reach(g, half)
    coordinates = g.coordinates(middle)
    ends = g.ends(coordinates)
    rotations = np.broadcast_to(g.arrays(coordinates)[1], (len(ends), 3, 3))  # one for all where nothing turns
    return are_regular(g.rig, ends, rotations, shifts, _axes(g, coordinates, half), turn)


def _axes(g: Grid, coordinates: Floats, half: float) -> list[Floats]:
    """Directions (N, 3) such that the turns within ± so many nodes are sums of them, each at most the largest turn."""
    turning = [k for k, a in enumerate(g.axes) if a.kind != "translation"]
    if not turning:
        return []
    one = g.axes[turning[0]]
    others = [c for n, c in enumerate(g.angles) if n != one.place]
    if len(turning) > 1 or one.name == "azimuth" or (one.kind == "vector" and any(others)):
        return [np.broadcast_to(axis, (len(coordinates), 3)) for axis in np.eye(3)]
    there = coordinates.copy()
    there[:, turning[0]] += half * float(one.step)
    before, after = g.arrays(coordinates)[1], g.arrays(there)[1]
    turns = rotation_vector(after @ np.swapaxes(before, 1, 2))
    with np.errstate(invalid="ignore"):  # a whole turn has no axis, and proves nothing
        return [turns / np.linalg.norm(turns, axis=1, keepdims=True)]


def reach(g: Grid, half: float) -> tuple[list[tuple[Floats, float]], float]:
    """How far the platform shifts, and along which directions, and turns (rad), within ± so many nodes of each axis."""
    shift = [(np.eye(3)[a.place], half * float(a.step)) for a in g.axes if a.kind == "translation"]
    turn = {
        a.name: half * (np.radians(float(a.step)) if a.unit == "deg" else float(a.step))
        for a in g.axes
        if a.kind != "translation"
    }
    kind = g.rotation_axis.kind if g.rotation_axis is not None else ""
    if kind == "tilt" and "azimuth" in turn:
        turn["azimuth"] *= 2 * np.sin(min(_largest_tilt(g), np.pi) / 2)
    angle = np.linalg.norm(list(turn.values())) if kind == "vector" else sum(turn.values())
    return shift, float(angle)


def _largest_tilt(g: Grid) -> float:
    """Over the whole slice, in radians."""
    axis = next((a for a in g.axes if a.name == "tilt"), None)
    largest = max(abs(axis.start), abs(axis.stop)) if axis else abs(g.angles[1])
    assert g.rotation_axis is not None
    return float(np.radians(float(largest))) if g.rotation_axis.unit == "deg" else float(largest)
