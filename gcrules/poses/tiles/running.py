"""Running tiles: here, in worker processes, as a part of a job array, or on a Dask cluster; the tiles are the same."""

from __future__ import annotations

from collections.abc import Callable

from gcrules.core.budget import checkpoint
from gcrules.core.deferred import deferred
from gcrules.core.errors import EngineFault
from gcrules.poses.tiles.beginning import begin, keep
from gcrules.poses.tiles.how import HERE, Progress, Running
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import TileTask

__all__ = ["run"]

by_workers = deferred("gcrules.poses.tiles.workers:by_workers")  # multiprocessing
by_cluster = deferred("gcrules.poses.tiles.cluster:by_cluster")

_ROUNDS = 3


def run(task: TileTask, store: TileStore, how: Running = HERE) -> None:
    """Compute what is missing of the store, or of this part of it; the store is finished by whoever computes last.

    Raises what `task.compute` raises, FileError where tiles cannot be kept; what is done then is kept.
    """
    road: Callable[[TileTask, TileStore, list[int], Progress, Running], None] = here
    if how.scheduler is not None:
        road = by_cluster
    elif how.workers:
        road = by_workers
    own = how.tiles(store)
    for _ in range(_ROUNDS):  # tiles may be damaged, or a shard taken apart, while the others are computed
        done = store.done(own)
        missing = [t for t in own if t not in done]
        if missing:
            begin(task, store)
            progress = Progress(len(own), len(done))
            progress.tell()
            road(task, store, missing, progress, how)
        for shard in store.shards if how.part is None else sorted({store.layout.shard_of(t) for t in own}):
            checkpoint()
            store.settle(shard)
        if not missing:
            break
    if how.part is not None:
        store.finish()
    elif not store.settle_all():
        raise EngineFault(f"tiles of {store.path} are lost as they are written")


def here(task: TileTask, store: TileStore, tiles: list[int], progress: Progress, how: Running) -> None:
    """In this process."""
    for tile in tiles:
        checkpoint()
        keep(task, store, tile)
        progress.add()
