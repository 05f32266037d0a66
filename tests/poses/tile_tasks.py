"""Tasks in tiles that are quick, and wait where a test wants them to: for files, not for time."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gcrules.core.frozen import FrozenMap
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import Coordinate, Tile, TiledArray, tile_at


@dataclass(frozen=True)
class Sines:
    """Sines over a plane of `grid` tiles of 5 by 4 nodes, and cells between them: the last column of tiles has fewer
    nodes, and no cells.

    Where `signals` names a folder, a tile says there that it begins (`begun-TILE-PID`), and waits while there is a file
    `hold-TILE`; `fault` is a tile that cannot be computed.
    """

    grid: tuple[int, int] = (4, 5)
    scale: float = 1.0
    signals: str = ""
    fault: int = -1
    stage = None

    @property
    def manifest(self) -> dict[str, Any]:
        return {"grid": list(self.grid), "wave": {"scale": self.scale, "name": "sine"}}

    @property
    def recipe(self) -> dict[str, Any]:
        return {"kind": "sines", **self.manifest}

    @property
    def attrs(self) -> dict[str, Any]:
        return {"title": "Sines", "source": "tests"}

    @property
    def shape(self) -> tuple[int, int]:
        return 5 * self.grid[0], 4 * (self.grid[1] - 1) + 1

    @property
    def arrays(self) -> tuple[TiledArray, ...]:
        n, m = self.shape
        flags = FrozenMap({"flag_values": (0, 1), "flag_meanings": "low high"})
        return (
            TiledArray("sine", ("x", "y"), (n, m), (5, 4), "float64", FrozenMap({"units": "mm"})),
            TiledArray("pair", ("x", "y", "of"), (n, m, 2), (5, 4, 2), "float32"),
            TiledArray("high", ("x_cell", "y_cell"), (n - 1, m - 1), (5, 4), "uint8", flags),
        )

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        n, m = self.shape
        return (
            Coordinate("x", ("x",), np.arange(n) * 0.1, FrozenMap({"units": "mm"})),
            Coordinate("y", ("y",), np.arange(m) * 0.1),
            Coordinate("of", ("of",), np.array(["sine", "cosine"])),
        )

    def compute(self, tile: int) -> Tile:
        if self.signals:
            wait(self.signals, tile)
        if tile == self.fault:
            raise ZeroDivisionError("one over nothing")
        n, m = self.shape
        i, j = tile_at(self.grid, tile)
        x = np.arange(5 * i, min(5 * i + 5, n))[:, None] * 0.1
        y = np.arange(4 * j, min(4 * j + 4, m))[None] * 0.1
        wave = np.sin(self.scale * x + 2 * y)
        wave[wave < -0.99] = np.nan
        cells = tuple(s.stop - s.start for s in self.arrays[2].region(self.grid, tile))
        return {
            "sine": wave,
            "pair": np.stack([wave, np.cos(x + y)], axis=-1).astype(np.float32),
            "high": (wave[: cells[0], : cells[1]] > 0).astype(np.uint8),
        }


def wait(signals: str, what: int | str) -> None:
    """Say in a folder that something begins, and wait while it is held there."""
    Path(signals, f"begun-{what}-{os.getpid()}").touch()
    while Path(signals, f"hold-{what}").exists():
        time.sleep(0.01)


@dataclass(frozen=True)
class Waiting:
    """A task, and its stage, that say when they begin, as `Sines` does; the stage is called so."""

    task: Any
    signals: str

    manifest = property(lambda self: self.task.manifest)
    recipe = property(lambda self: self.task.recipe)
    attrs = property(lambda self: self.task.attrs)
    coordinates = property(lambda self: self.task.coordinates)
    grid = property(lambda self: self.task.grid)
    arrays = property(lambda self: self.task.arrays)
    stage = property(lambda self: self)
    known = property(lambda self: self.task.stage.known)

    def compute(self, tile: int) -> Any:
        wait(self.signals, tile)
        return self.task.compute(tile)

    def staged(self) -> bytes:
        wait(self.signals, "stage")
        data: bytes = self.task.stage.staged()
        return data

    def take(self, data: bytes) -> None:
        self.task.stage.take(data)


def task_again(recipe: dict[str, Any]) -> Sines:
    return Sines(tuple(recipe["grid"]), recipe["wave"]["scale"])


def contents(path: Path) -> dict[str, bytes]:
    """The bytes of all files of a store."""
    return {str(p.relative_to(path)): p.read_bytes() for p in sorted(path.rglob("*")) if p.is_file()}


def beside(store: TileStore) -> list[str]:
    """What lies beside a store, in its folder."""
    return [p.name for p in store.path.parent.iterdir() if p.name.startswith(store.path.name) and p != store.path]
