"""Where the chunks of a map are kept: in memory, or as tiles in a store, so that a long run can be resumed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from dataclasses import field
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError
from gcrules.core.frozen import HoldsArrays
from gcrules.poses.maps.task import Chunk
from gcrules.poses.tiles.store import TileStore

__all__ = ["Memory", "Store", "check_room"]


@dataclass(frozen=True, eq=False)
class Memory(HoldsArrays):
    """Chunks that are kept in memory."""

    chunks: dict[int, Chunk] = field(default_factory=dict)

    def get(self, chunk: int) -> Chunk | None:
        return self.chunks.get(chunk)

    def put(self, chunk: int, arrays: Chunk) -> None:
        self.chunks[chunk] = arrays

    def close(self) -> None:
        """Nothing is left behind."""


Store = Memory | TileStore


def check_room(path: str, needed: int, free: Callable[[str], Any] = shutil.disk_usage) -> None:
    """Raises FileError where the disk has less than `needed` bytes left."""
    folder = os.path.dirname(os.path.abspath(path))
    if os.path.isdir(folder) and (left := free(folder).free) < needed:
        raise FileError(
            f"about {needed / 1e9:.1f} GB are needed, {left / 1e9:.1f} GB are free on this disk",
            filename=path,
            hint="take a coarser grid, or --measure value, which needs less",
        )
