"""Computing tiles that are to be kept; what comes before all of them is computed once, and read by who comes later."""

from __future__ import annotations

import hashlib
from contextlib import suppress

from gcrules.poses.tiles.layout import DIGEST
from gcrules.poses.tiles.store import STAGE, TileStore, replace, written
from gcrules.poses.tiles.task import TileTask

__all__ = ["begin", "keep"]

_TRIES = 100  # the folder may be removed between making it and writing to it, but not for ever


def keep(task: TileTask, store: TileStore, tile: int) -> None:
    """Compute a tile and keep it, unless another run was quicker."""
    if not store.done([tile]):
        begin(task, store)
        store.put(tile, task.compute(tile))


def begin(task: TileTask, store: TileStore) -> None:
    """Make a task ready for its tiles: the outcome of its stage is read from a file beside the store, which begins with
    the digest of the problem and of what follows, else computed and kept there. Raises FileError where it cannot be.
    """
    stage = task.stage
    if stage is None or stage.known:
        return
    path, seal = store.beside / STAGE, store.layout.problem.encode()
    with suppress(OSError, ValueError, KeyError):
        data = path.read_bytes()
        if hashlib.sha256(seal + data[DIGEST:]).digest() == data[:DIGEST]:
            stage.take(data[DIGEST:])
            return
    found = stage.staged()
    try:
        for _ in range(_TRIES):
            with suppress(FileNotFoundError):  # the folder was removed by who finished the store
                store.beside.mkdir(parents=True, exist_ok=True)
                replace(path, hashlib.sha256(seal + found).digest() + found)
                return
    except OSError as fault:
        raise written(fault, str(store.path)) from None
