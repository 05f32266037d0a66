r"""How tiles lie in a store: several to a shard, which is one file of each array; and what the bytes of a tile are.

>>> from gcrules.poses.tiles.task import TiledArray
>>> line = Layout("", (130,), (TiledArray("a", ("x",), (1300,), (10,), "float32"),))
>>> line.shard, line.shards, line.tiles(2), line.shard_of(65)
((64,), (3,), (128, 129), 1)
>>> Layout("", (3, 200), ()).shard, Layout("", (9,) * 6, ()).shard
((1, 64), (2, 2, 2, 2, 2, 2))
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault
from gcrules.poses.tiles.task import Tile, TiledArray, TileTask, problem, tile_at

__all__ = ["DIGEST", "Layout", "layout_of"]

TILES_OF_SHARD = 64
"""Tiles of a shard, at most."""
DIGEST = 32
"""Bytes of the digest of a tile, SHA-256."""


@dataclass(frozen=True)
class Layout:
    """The hash of the problem, the grid of tiles, and the arrays in the order of their names."""

    problem: str
    grid: tuple[int, ...]
    arrays: tuple[TiledArray, ...]

    def __post_init__(self) -> None:
        k = len(self.grid)
        object.__setattr__(self, "arrays", tuple(sorted(self.arrays, key=lambda a: a.name)))
        for a in self.arrays:
            whole = a.chunk[k:] == a.shape[k:] and all(
                -(-n // c) <= g for n, c, g in zip(a.shape[:k], a.chunk[:k], self.grid, strict=True)
            )
            if not whole or len(a.shape) != len(a.dims) or not all(a.shape):
                raise EngineFault(f"the array {a.name} does not lie in {self.grid} tiles")

    def __reduce__(self) -> tuple[Any, ...]:
        return Layout, (self.problem, self.grid, self.arrays)

    @property
    def number(self) -> int:
        """How many tiles there are."""
        return math.prod(self.grid)

    @cached_property
    def shard(self) -> tuple[int, ...]:
        """How many tiles a shard has along each dimension: doubled where most shards are left, up to 64 in all."""
        size = [1] * len(self.grid)
        while True:
            left = [-(-g // s) for g, s in zip(self.grid, size, strict=True)]
            k = left.index(max(left))
            grown = [*size[:k], min(2 * size[k], self.grid[k]), *size[k + 1 :]]
            if left[k] == 1 or math.prod(grown) > TILES_OF_SHARD:
                return tuple(size)
            size = grown

    @property
    def shards(self) -> tuple[int, ...]:
        """The grid of shards."""
        return tuple(-(-g // s) for g, s in zip(self.grid, self.shard, strict=True))

    def shard_of(self, tile: int) -> int:
        """The number of the shard in which a tile lies."""
        at = tuple(k // s for k, s in zip(tile_at(self.grid, tile), self.shard, strict=True))
        return int(np.ravel_multi_index(at, self.shards))

    def tiles(self, shard: int) -> tuple[int, ...]:
        """The tiles of a shard."""
        ranges = [
            range(k * s, min((k + 1) * s, g))
            for k, s, g in zip(tile_at(self.shards, shard), self.shard, self.grid, strict=True)
        ]
        places = np.meshgrid(*ranges, indexing="ij")
        return tuple(np.ravel_multi_index([p.ravel() for p in places], self.grid).tolist())

    def inside(self, tile: int) -> tuple[int, ...]:
        """Where a tile is in its shard."""
        return tuple(k % s for k, s in zip(tile_at(self.grid, tile), self.shard, strict=True))

    def region(self, array: TiledArray, shard: int) -> tuple[slice, ...]:
        """Where a shard lies in an array; empty where it lies beyond it."""
        at = (*tile_at(self.shards, shard), *(0,) * (len(array.shape) - len(self.grid)))
        return tuple(
            slice(min(k * c, n), min((k + 1) * c, n))
            for k, c, n in zip(at, self.shard_chunk(array), array.shape, strict=True)
        )

    def shard_chunk(self, array: TiledArray) -> tuple[int, ...]:
        """What a shard holds of an array."""
        sides = (*self.shard, *(1,) * (len(array.shape) - len(self.grid)))
        return tuple(c * s for c, s in zip(array.chunk, sides, strict=True))

    # --- the bytes of a tile

    def shape(self, array: TiledArray, tile: int) -> tuple[int, ...]:
        """What a tile has of an array."""
        return tuple(s.stop - s.start for s in array.region(self.grid, tile))

    def packed(self, tile: int, arrays: Mapping[str, NDArray[Any]]) -> bytes:
        """A tile as bytes: the digest of what follows (with the hash of the problem and the number of the tile), then
        each array in the order of the names, little-endian.
        """
        parts = []
        for a in self.arrays:
            values = np.asarray(arrays[a.name])
            if values.shape != self.shape(a, tile) or values.dtype != np.dtype(a.dtype):
                raise EngineFault(f"tile {tile}: {a.name} is {values.dtype} {values.shape}, not as its task says")
            parts.append(np.ascontiguousarray(values, values.dtype.newbyteorder("<")).tobytes())
        data = b"".join(parts)
        return self._digest(tile, data) + data

    def unpacked(self, tile: int, data: bytes) -> Tile | None:
        """The arrays of a tile; None where the digest says that these are not its bytes."""
        view = memoryview(data)[DIGEST:]
        if data[:DIGEST] != self._digest(tile, view):
            return None
        found, start = {}, 0
        for a in self.arrays:
            shape, kind = self.shape(a, tile), np.dtype(a.dtype).newbyteorder("<")
            count = math.prod(shape)
            values = np.frombuffer(view, kind, count, start) if count else np.zeros(0, kind)
            found[a.name] = values.reshape(shape).astype(a.dtype, copy=False)
            start += count * kind.itemsize
        return found

    def _digest(self, tile: int, data: bytes | memoryview) -> bytes:
        made = hashlib.sha256(f"{self.problem} {tile}\n".encode())
        made.update(data)
        return made.digest()


def layout_of(task: TileTask) -> Layout:
    """How the tiles of a task lie in a store."""
    return Layout(problem(task), tuple(task.grid), tuple(task.arrays))
