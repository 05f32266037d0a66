"""What the certificate of a map has of a robot of joints: its slice, its geometry, and what its cells are."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.poses.compiling.closed_forms import run
from gcrules.poses.compiling.tape import Program
from gcrules.poses.maps.cells import OUTSIDE, UNDECIDED
from gcrules.poses.maps.limb_grid import LimbsGrid
from gcrules.poses.maps.nodes import others

__all__ = ["limb_question", "stated_cells"]

Statuses = NDArray[np.uint8]


def limb_question(grid: LimbsGrid, recipe: Mapping[str, Any]) -> dict[str, Any]:
    """The robot and the slice, as in certificates of ranges, with the number of nodes along each axis."""
    return {
        "robot": recipe["robot"],
        "about": recipe["about"],
        "over": [
            {"coordinate": a.name, "low": str(a.start), "high": str(a.stop), "number": a.number, "unit": a.unit}
            for a in grid.axes
        ],
        "rest": others(grid.axes, grid.names, grid.values),
        "limits": None,
        "cones": [],
        "tilt": None,
    }


def stated_cells(grid: LimbsGrid, status: Statuses, roots: Program | None) -> Statuses:
    """The status of each cell as a certificate states it: outside where a root does not exist at a corner; where a map
    calls a cell outside for another reason, undecided, as everywhere over actuators, for which there are no roots.
    """
    if roots is None:
        return np.where(status == OUTSIDE, UNDECIDED, status)
    origin, steps = grid.linear
    places = np.stack(np.meshgrid(*map(np.arange, grid.shape), indexing="ij"), axis=-1).reshape(-1, len(grid.axes))
    with np.errstate(invalid="ignore"):
        values = run(roots, "numpy", origin + places @ steps)
    beyond = np.asarray(np.isnan(values).any(axis=0)).reshape(grid.shape)
    cells = tuple(n - 1 for n in grid.shape)
    corners = [
        beyond[tuple(slice(k, k + n) for k, n in zip(corner, cells, strict=True))]
        for corner in product((0, 1), repeat=len(cells))
    ]
    found = status.copy()
    found[(status == OUTSIDE) & ~np.any(corners, axis=0)] = UNDECIDED
    return found
