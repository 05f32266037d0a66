"""Tiles in worker processes of this machine: each asks for one tile at a time, and keeps it itself.

Workers are started anew and know nothing of this process (spawn), so that they work on every system; a script that
starts them has to stand behind `if __name__ == "__main__":`. A worker that is killed is replaced, and the tile on which
it was is given to another one. Where this process ends, however it does, the workers end with their tiles.
"""

from __future__ import annotations

import pickle
import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from multiprocessing import connection, get_context
from multiprocessing.connection import Connection
from typing import Any

from gcrules.core.budget import checkpoint, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, LimitReached
from gcrules.core.threads import one_thread
from gcrules.poses.tiles.beginning import keep
from gcrules.poses.tiles.how import Progress, Running
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import TileTask

__all__ = ["by_workers"]

_DEATHS = 3
"""So many workers may be killed at one tile before it is given up."""
_LOOK = 0.2  # seconds between two looks at the budgets


@dataclass
class _Worker:
    process: Any
    ours: Connection
    tile: int | None = None


def by_workers(task: TileTask, store: TileStore, tiles: list[int], progress: Progress, how: Running) -> None:
    """Compute tiles in worker processes. Raises what they raise, and LimitReached where a tile kills its workers."""
    job = pickle.dumps((task, store))
    waiting, deaths = list(reversed(tiles)), dict.fromkeys(tiles, 0)
    team: list[_Worker] = []
    try:
        while waiting or any(w.tile is not None for w in team):
            checkpoint()
            while len(team) < min(how.workers, len(waiting) + sum(w.tile is not None for w in team)):
                team.append(_started(job))
            for worker in team:
                if worker.tile is None and waiting:
                    worker.tile = waiting.pop()
                    _tell(worker, worker.tile)
            ready = set(connection.wait([w.ours for w in team], _LOOK))
            for worker in [w for w in team if w.ours in ready]:
                try:
                    fault = worker.ours.recv()
                except (EOFError, OSError):  # it was killed
                    team.remove(worker)
                    _end(worker)
                    lost = worker.tile
                    if lost is not None and not store.done([lost]):
                        deaths[lost] += 1
                        _check_deaths(lost, deaths[lost], worker)
                        waiting.append(lost)
                    elif lost is not None:
                        progress.add()
                    continue
                if fault is not None:
                    raise fault
                worker.tile = None
                progress.add()
    finally:
        for worker in team:
            _end(worker)


def _check_deaths(tile: int, number: int, worker: _Worker) -> None:
    if number >= _DEATHS:
        raise LimitReached(
            f"{number} workers ended while they computed tile {tile} (the last one with exit code "
            f"{worker.process.exitcode})",
            hint="the memory may not be enough for so many workers; a script that starts workers has to be guarded by "
            'if __name__ == "__main__":',
        )


def _started(job: bytes) -> _Worker:
    context = get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_work, args=(theirs, job), daemon=True)
    with _quiet(), one_thread():
        process.start()
    theirs.close()  # so that its end is seen here
    return _Worker(process, ours)


def _tell(worker: _Worker, tile: int) -> None:
    with suppress(OSError):  # it was killed, which is seen when it should answer
        worker.ours.send(tile)


def _end(worker: _Worker) -> None:
    worker.ours.close()
    worker.process.terminate()
    worker.process.join()


@contextmanager
def _quiet() -> Iterator[None]:
    """Ctrl-C is for this process: those that are started within do not hear it. It comes here afterwards."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(theirs: Connection, job: bytes) -> None:
    """What a worker does until nobody asks any more."""
    task, store = pickle.loads(job)
    while True:
        try:
            tile = theirs.recv()
        except (EOFError, OSError):
            return
        fault: BaseException | None = None
        try:
            with within():
                keep(task, store, tile)
        except BaseException as found:
            fault = found if _travels(found) else EngineFault(f"tile {tile}: {found!r}")
        try:
            theirs.send(fault)
        except OSError:
            return


def _travels(fault: BaseException) -> bool:
    try:
        return isinstance(pickle.loads(pickle.dumps(fault)), type(fault))
    except Exception:
        return False
