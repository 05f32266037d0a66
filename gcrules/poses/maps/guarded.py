r"""Cells of any slice that are free of singular poses, proved by the margin σ at their middles.

Within a cell the platform shifts by at most d and turns by at most φ from the pose in the middle; then the end of leg i
moves by at most x = d + 2 r_i sin(φ/2), r_i its distance from the centre, and the leg turns by at most asin(x/l_i) + φ
relative to the platform. No pose is singular before some leg has turned by asin σ (docs/pose.md).

φ is at most the length of the change of a rotation vector, since the exponential map of rotations shortens distances,
or the sum of the changes of Euler angles. Turning the direction of a tilt θ by δ turns the platform by at most
2δ sin(θ/2): the unit quaternion moves on a circle of radius sin(θ/2).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.poses.maps.grid import Grid
from gcrules.screws.guarantees import guarantees
from gcrules.screws.margin import jacobian

__all__ = ["guarded"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

_DEPTH = {2: 3, 3: 1}  # halvings, by the number of axes
_BLOCK = 2_500  # cells at once


def guarded(g: Grid, cells: Integers) -> Booleans:
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
    shift, turn = reach(g, half)
    ends = g.ends(g.coordinates(middle))
    lengths = np.linalg.norm(ends - g.rig.base, axis=2)
    moved = shift + 2 * np.linalg.norm(g.rig.arms, axis=1) * np.sin(min(turn, np.pi) / 2)
    possible = (lengths > moved).all(axis=1)
    found = np.zeros(len(middle), dtype=bool)
    if possible.any():
        bound = guarantees(jacobian(g.rig.base, ends[possible])).turn
        turned = np.arcsin(np.minimum(moved / lengths[possible], 1.0)).max(axis=1) + turn
        found[possible] = turned * (1 + 1e-12) < bound
    return found


def reach(g: Grid, half: float) -> tuple[float, float]:
    """How far the platform shifts (a length) and turns (rad) at most within ± so many nodes of each axis."""
    shift = [half * float(a.step) for a in g.axes if a.kind == "translation"]
    turn = {
        a.name: half * (np.radians(float(a.step)) if a.unit == "deg" else float(a.step))
        for a in g.axes
        if a.kind != "translation"
    }
    kind = g.rotation_axis.kind if g.rotation_axis is not None else ""
    if kind == "tilt" and "azimuth" in turn:
        turn["azimuth"] *= 2 * np.sin(min(_largest_tilt(g), np.pi) / 2)
    angle = np.linalg.norm(list(turn.values())) if kind == "vector" else sum(turn.values())
    return float(np.linalg.norm(shift)), float(angle)


def _largest_tilt(g: Grid) -> float:
    """Over the whole slice, in radians."""
    axis = next((a for a in g.axes if a.name == "tilt"), None)
    largest = max(abs(axis.start), abs(axis.stop)) if axis else abs(g.angles[1])
    assert g.rotation_axis is not None
    return float(np.radians(float(largest))) if g.rotation_axis.unit == "deg" else float(largest)
