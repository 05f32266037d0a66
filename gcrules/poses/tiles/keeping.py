"""Where the tiles of an answer are: in memory, or in a store, in which an interrupted run goes on."""

from __future__ import annotations

from dataclasses import field
from os import PathLike, fspath

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, FileError, InputError
from gcrules.core.frozen import HoldsArrays
from gcrules.core.seeds import drawn
from gcrules.poses.tiles.comparing import alike
from gcrules.poses.tiles.how import HERE, Running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.status import MapStatus, status_of
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import Tile, TileTask

__all__ = ["Memory", "Store", "computed_part", "copy_tiles", "store_of", "tile_of"]

Name = str | PathLike[str]


@dataclass(frozen=True, eq=False)
class Memory(HoldsArrays):
    """Tiles that are kept in memory."""

    tiles: dict[int, Tile] = field(default_factory=dict)

    def get(self, tile: int) -> Tile | None:
        return self.tiles.get(tile)

    def put(self, tile: int, arrays: Tile) -> None:
        self.tiles[tile] = arrays

    def remove(self) -> None:
        """Nothing is left behind."""


Store = Memory | TileStore


def store_of(task: TileTask, how: Running = HERE, work: Name | None = None, *, restart: bool = False) -> Store:
    """The store `work` with all tiles of a task, or an empty one in memory where none is named.

    One of the tiles that are found there, which nobody can foresee, is computed again: raises FileError where it
    differs. Raises InputError for workers without a store, and as `TileStore.open` and `run` do.
    """
    if work is None:
        if how != HERE:
            raise InputError("workers keep their tiles in a store", hint='name one: work="map.zarr", or -o map.zarr')
        return Memory()
    store = TileStore.open(work, task, restart=restart)
    kept = sorted(store.done())
    run(task, store, how)
    if kept:
        _check_kept(task, store, drawn("map", str(store.path), len(kept)).choice(kept))
    return store


def computed_part(task: TileTask, how: Running, work: Name | None, *, restart: bool = False) -> MapStatus:
    """A part of a task, computed and kept, and how much of the whole is there. Raises as `store_of`."""
    if work is None:
        raise InputError("a part of a job array keeps its tiles in a store", hint='name one: work="map.zarr"')
    if restart:
        raise InputError("a part cannot start over", hint="the other parts may be at work; remove the store first")
    store = TileStore.open(work, task)
    run(task, store, how)
    return status_of(store, fspath(work))


def tile_of(task: TileTask, store: Store, number: int) -> Tile:
    """A tile, which is computed where it is not there, or is damaged."""
    found = store.get(number)
    if found is not None:
        return found
    if isinstance(store, Memory):
        store.put(number, task.compute(number))
    else:
        store.unseal(number)
        run(task, store)
    found = store.get(number)
    if found is None:
        raise EngineFault(f"tile {number} is lost as it is written")
    return found


def copy_tiles(task: TileTask, store: Store, work: Name) -> None:
    """The tiles of a task in the store `work`, which this may be already. Raises as `TileStore.open`."""
    kept = TileStore.open(work, task)
    if kept != store:
        for number in range(kept.number):
            if not kept.there(number):
                kept.put(number, tile_of(task, store, number))
    kept.settle_all()


def _check_kept(task: TileTask, store: TileStore, number: int) -> None:
    """Compute a tile again that was found in a store."""
    there = store.get(number)
    if there is not None and not alike(there, task.compute(number)):
        raise FileError(
            f"tile {number} is not what is computed now; its files were changed",
            filename=str(store.path),
            hint="start over with --restart (in Python restart=True), or use another store",
        )
