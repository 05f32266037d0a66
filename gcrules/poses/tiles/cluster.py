"""Tiles on a Dask cluster: its workers keep the tiles themselves, in the folder of the store, which they have to share.

So nothing but numbers of tiles goes through the scheduler, and a worker that is killed loses the tile on which it was.
"""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache
from itertools import islice
from typing import Any

from gcrules.core.budget import checkpoint, within
from gcrules.core.errors import EngineFault, FileError, InputError, LimitReached
from gcrules.poses.tiles.beginning import keep
from gcrules.poses.tiles.how import Progress, Running
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import TileTask
from gcrules.poses.tiles.zarr_files import attributes

__all__ = ["by_cluster"]

_AHEAD = 3
"""Tiles that are given out for each thread of the cluster."""
_LOOK = "200 ms"
_PATIENCE = "30 s"  # for the scheduler to answer


def by_cluster(task: TileTask, store: TileStore, tiles: list[int], progress: Progress, how: Running) -> None:
    """Compute tiles on the cluster. Raises InputError where it is not reached or its workers do not share the disk,
    what tiles raise, and LimitReached where one kills its workers, or where the cluster goes away.
    """
    try:
        import distributed  # an extra of the installation
    except ImportError:
        raise InputError("a cluster needs Dask's distributed", hint='pip install "gcrules[cluster]"') from None
    job = pickle.dumps((task, store))
    with _client(distributed, how) as client:
        waiting = iter(tiles)
        running: set[Any] = set()
        try:
            while True:
                checkpoint()
                ahead = _AHEAD * max(sum(client.nthreads().values()), 1) - len(running)
                running |= {client.submit(_kept, job, tile, pure=False) for tile in islice(waiting, max(ahead, 0))}
                if not running:
                    return
                try:
                    ended = _wait(distributed, running)
                except distributed.TimeoutError:
                    continue
                for future in ended:
                    running.discard(future)
                    _check(distributed, future)
                    progress.add()
        except (OSError, distributed.CancelledError) as fault:
            raise LimitReached(f"the cluster is gone: {fault}", hint="finished tiles are kept; run it again") from None
        finally:
            with suppress(OSError, distributed.CancelledError):
                client.cancel(list(running), force=True)


def _check(distributed: Any, future: Any) -> None:
    """Raises what a tile has raised."""
    if future.status == "cancelled":
        raise distributed.CancelledError(future.key)
    fault = future.exception()
    if isinstance(fault, distributed.KilledWorker):
        raise LimitReached(
            "several workers of the cluster ended while they computed one tile",
            hint="their memory may not be enough; finished tiles are kept",
        )
    if fault is not None:
        raise EngineFault(f"a tile was not computed: {fault!r}") if isinstance(fault, OSError) else fault


def _wait(distributed: Any, running: set[Any]) -> set[Any]:
    """Those that have ended, as soon as there is one."""
    found: set[Any] = distributed.wait(running, timeout=_LOOK, return_when="FIRST_COMPLETED").done
    return found


@contextmanager
def _client(distributed: Any, how: Running) -> Iterator[Any]:
    """A connection to the cluster, a new one where it is local."""
    if how.scheduler == "local":
        options = {"threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
        with (
            distributed.LocalCluster(n_workers=how.workers or None, **options) as cluster,
            distributed.Client(cluster) as client,
        ):
            yield client
        return
    try:
        client = distributed.Client(how.scheduler, timeout=_PATIENCE)
    except (OSError, ValueError) as fault:
        raise InputError(
            f"the scheduler {str(how.scheduler)[:80]} is not reached: {str(fault)[:200]}",
            hint='an address is "tcp://host:8786", as dask scheduler prints it; "local" starts a cluster here',
        ) from None
    with client:
        yield client


@lru_cache(maxsize=4)
def _job(data: bytes) -> tuple[TileTask, TileStore]:
    task, store = pickle.loads(data)
    return task, store


def _kept(job: bytes, tile: int) -> int:
    """What a worker of the cluster does."""
    task, store = _job(job)
    found = attributes(store.path)
    if found is None or found["attributes"]["problem"] != store.layout.problem:
        raise FileError(
            "a worker of the cluster does not find the store there",
            filename=str(store.path),
            hint="the workers keep the tiles themselves, so they have to share the disk; without one, compute parts "
            "(--part K/N) and put them together with gcrules map merge",
        )
    with within():
        keep(task, store, tile)
    return tile
