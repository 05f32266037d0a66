"""Whether two tiles are the same, but for rounding."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.poses.tiles.task import Tile

__all__ = ["alike"]

_MOSTLY = 0.999


def alike(one: Tile, other: Tile) -> bool:
    """Whether tiles agree but for rounding, which may decide differently on another machine, though seldom."""
    return set(one) == set(other) and all(_alike(one[name], other[name]) for name in one)


def _alike(a: NDArray[Any], b: NDArray[Any]) -> bool:
    if a.shape != b.shape or not a.size:  # the last tile may have poses, and no cells
        return bool(a.shape == b.shape)
    if a.dtype.kind == "f":
        return bool(np.isclose(a, b, rtol=1e-4, atol=1e-6, equal_nan=True).mean() > _MOSTLY)
    return bool((a == b).mean() > _MOSTLY)
