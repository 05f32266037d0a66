r"""What is computed in tiles: arrays over a grid of tiles, each a pure function of the problem and its number.

>>> from gcrules.core.frozen import FrozenMap
>>> array = TiledArray("margin", ("x", "z"), (100, 41), (30, 41), "float32", FrozenMap({"units": "1"}))
>>> [array.region((4,), tile) for tile in (0, 3)]
[(slice(0, 30, None), slice(0, 41, None)), (slice(90, 100, None), slice(0, 41, None))]
>>> tile_at((4, 3), 7)
(2, 1)
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap, HoldsArrays

__all__ = ["Coordinate", "Stage", "Tile", "TileTask", "TiledArray", "number_of", "problem", "tile_at"]

Tile = Mapping[str, NDArray[Any]]
"""What one tile holds: each array of its task by name."""


@dataclass(frozen=True)
class TiledArray:
    """An array that is computed in tiles: `dims` name its dimensions, of which the first ones, as many as the grid of
    tiles has, are tiled; a tile holds `chunk` of `shape` (the last one along a dimension less, or nothing).

    `attrs` are units, long_name, flag_values, flag_meanings … as JSON has them.
    """

    name: str
    dims: tuple[str, ...]
    shape: tuple[int, ...]
    chunk: tuple[int, ...]
    dtype: str
    attrs: FrozenMap[str, Any] = field(default=FrozenMap(), compare=False)

    def region(self, grid: tuple[int, ...], tile: int) -> tuple[slice, ...]:
        """Where a tile lies in the array."""
        at = (*tile_at(grid, tile), *(0,) * (len(self.shape) - len(grid)))
        return tuple(
            slice(min(k * c, n), min((k + 1) * c, n)) for k, c, n in zip(at, self.chunk, self.shape, strict=True)
        )


@dataclass(frozen=True, eq=False)
class Coordinate(HoldsArrays):
    """A coordinate of the arrays: numbers or text along one dimension."""

    name: str
    dims: tuple[str, ...]
    values: NDArray[Any]
    attrs: FrozenMap[str, Any] = field(default=FrozenMap())


class Stage(Protocol):
    """What all tiles of a task begin with: it depends on the task only. Whoever is first computes it, and the others
    may read it. `known` tells that it was.
    """

    @property
    def known(self) -> bool: ...

    def staged(self) -> bytes:
        """The outcome of the stage, computed where it is not known."""
        ...

    def take(self, data: bytes) -> None:
        """Go on from the outcome. Raises ValueError and KeyError for what is none."""
        ...


class TileTask(Protocol):
    """What is computed in tiles; values of it can be pickled.

    `manifest` is everything that the tiles depend on, as JSON. `grid` is how many tiles there are along each tiled
    dimension; tiles are numbered from 0 in C order. `attrs` say what the store is of (units, version, where it comes
    from), as JSON, without times and names of machines. `recipe` is from what the task is made anew, as JSON: its
    `kind` is a row of `gcrules/poses/stored_maps/kinds.py`. `stage` is what comes before all tiles, None for
    nothing.
    """

    @property
    def manifest(self) -> dict[str, Any]: ...
    @property
    def grid(self) -> tuple[int, ...]: ...
    @property
    def arrays(self) -> tuple[TiledArray, ...]: ...
    @property
    def coordinates(self) -> tuple[Coordinate, ...]: ...
    @property
    def attrs(self) -> dict[str, Any]: ...
    @property
    def recipe(self) -> Mapping[str, Any]: ...
    @property
    def stage(self) -> Stage | None: ...

    def compute(self, tile: int) -> Tile:
        """All arrays of a tile, which depend on the manifest and the number only."""
        ...


def number_of(task: TileTask) -> int:
    """How many tiles there are."""
    return math.prod(task.grid)


def problem(task: TileTask) -> str:
    """The hash of the problem: SHA-256 of the manifest."""
    return hashlib.sha256(json.dumps(task.manifest, sort_keys=True).encode()).hexdigest()


def tile_at(grid: tuple[int, ...], tile: int) -> tuple[int, ...]:
    """Where a tile is in the grid of tiles."""
    return tuple(int(k) for k in np.unravel_index(tile, grid))
