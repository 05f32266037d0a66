"""Tiles while processes are killed: workers, a whole run, workers of a Dask cluster; nothing waits but for files."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from poses.tile_tasks import Sines, beside, contents

import gcrules as gc
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.tiles.how import HERE, Running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import TileStore

pytest.importorskip("zarr")

GRID = (20, 9)  # several shards


def made(path: Path, task: Sines, how: Running = HERE) -> TileStore:
    store = TileStore.open(path, task)
    run(task, store, how)
    return store


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The files of the store of an undisturbed run in one process."""
    return contents(made(tmp_path_factory.mktemp("undisturbed") / "map.zarr", Sines(GRID)).path)


class Signals:
    """What tiles say of themselves, and where they wait."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir()
        self.task = Sines(GRID, signals=str(folder))

    def hold(self, tile: int) -> None:
        (self.folder / f"hold-{tile}").touch()

    def release(self, tile: int) -> None:
        (self.folder / f"hold-{tile}").unlink()

    def begun(self, tile: int, besides: int = 0) -> int:
        """The process that computes a tile, as soon as it does, other than `besides`."""
        while True:
            for path in self.folder.glob(f"begun-{tile}-*"):
                pid = int(path.name.rsplit("-", 1)[1])
                if pid != besides:
                    return pid
            time.sleep(0.01)

    def times(self, tile: int) -> int:
        """By how many processes a tile was begun."""
        return len(list(self.folder.glob(f"begun-{tile}-*")))


@pytest.fixture
def signals(tmp_path: Path) -> Iterator[Signals]:
    found = Signals(tmp_path / "signals")
    yield found
    for path in found.folder.glob("hold-*"):  # whoever still waits ends
        path.unlink()


@contextmanager
def beside_it(work: Callable[[], Any]) -> Iterator[None]:
    """Run `work` in a thread, to its end; its fault is raised here."""
    faults: list[BaseException] = []

    def guarded() -> None:
        try:
            work()
        except BaseException as fault:
            faults.append(fault)

    thread = threading.Thread(target=guarded)
    thread.start()
    try:
        yield
    finally:
        thread.join()
    if faults:
        raise faults[0]


def gone(pid: int) -> None:
    """Wait until a process has ended."""
    while True:
        try:
            if Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z":
                return
        except FileNotFoundError:
            return
        time.sleep(0.01)


needs_proc = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs /proc")


# --- workers --------------------------------------------------------------------------------------------------------


def test_workers_make_the_same_store(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    store = made(tmp_path / "map.zarr", Sines(GRID), Running(workers=2))
    assert contents(store.path) == undisturbed
    assert beside(store) == []


def test_killed_workers_are_replaced(tmp_path: Path, undisturbed: dict[str, bytes], signals: Signals) -> None:
    for tile in (3, 90):
        signals.hold(tile)
    store = TileStore.open(tmp_path / "map.zarr", signals.task)
    with beside_it(lambda: run(signals.task, store, Running(workers=2))):
        for tile in (3, 90):
            first = signals.begun(tile)
            os.kill(first, signal.SIGKILL)
            second = signals.begun(tile, besides=first)  # another one has taken it
            assert second != first
            signals.release(tile)
    assert contents(store.path) == undisturbed
    assert beside(store) == []


def test_a_tile_that_kills_its_workers_is_given_up(tmp_path: Path, signals: Signals) -> None:
    signals.hold(3)
    store = TileStore.open(tmp_path / "map.zarr", signals.task)
    pids: list[int] = []

    def killing() -> None:
        with beside_it(lambda: run(signals.task, store, Running(workers=1))):
            for _ in range(3):
                while not (new := {int(p.name.split("-")[2]) for p in signals.folder.glob("begun-3-*")} - {*pids}):
                    time.sleep(0.01)
                pids.append(new.pop())
                os.kill(pids[-1], signal.SIGKILL)

    with pytest.raises(LimitReached, match="3 workers ended while they computed tile 3") as fault:
        killing()
    assert "__main__" in fault.value.render()
    assert store.done() == {0, 1, 2}


def test_a_fault_of_a_tile_comes_back(tmp_path: Path) -> None:
    task = Sines(GRID, fault=7)
    store = TileStore.open(tmp_path / "map.zarr", task)
    with pytest.raises(ZeroDivisionError, match="one over nothing"):
        run(task, store, Running(workers=2))
    assert 7 not in store.done()


# --- the whole run --------------------------------------------------------------------------------------------------

RUN = """
import sys
from poses.tile_tasks import Sines
from gcrules.poses.tiles.how import Running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import TileStore

if __name__ == "__main__":
    path, signals, workers = sys.argv[1:]
    task = Sines((20, 9), signals=signals)
    run(task, TileStore.open(path, task), Running(workers=int(workers)))
"""


def started(tmp_path: Path, signals: Signals, workers: int = 0, name: str = "map.zarr") -> subprocess.Popen[str]:
    script = tmp_path / "run.py"
    script.write_text(RUN, encoding="utf-8")
    words = [sys.executable, str(script), str(tmp_path / name), str(signals.folder), str(workers)]
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    return subprocess.Popen(words, env=env, text=True, stderr=subprocess.PIPE)


@needs_proc
@pytest.mark.parametrize("workers", [0, 2], ids=["here", "two workers"])
@pytest.mark.parametrize("tile", [0, 70, 179])
def test_a_whole_run_is_killed(
    tmp_path: Path, undisturbed: dict[str, bytes], signals: Signals, workers: int, tile: int
) -> None:
    signals.hold(tile)
    with started(tmp_path, signals, workers) as first:
        worker = signals.begun(tile)
        first.kill()
    signals.release(tile)
    gone(worker)  # the workers end by themselves
    store = TileStore.existing(tmp_path / "map.zarr")
    done = store.done()
    assert len(done) < store.number or workers
    run(Sines(GRID), store)
    assert contents(store.path) == undisturbed
    assert beside(store) == []


@needs_proc
def test_workers_end_with_an_interrupted_run(tmp_path: Path, signals: Signals) -> None:
    signals.hold(5)
    with started(tmp_path, signals, 2) as first:
        worker = signals.begun(5)
        first.send_signal(signal.SIGINT)
        assert first.wait() != 0
    gone(worker)
    store = TileStore.existing(tmp_path / "map.zarr")
    assert 5 not in store.done()


def test_runs_that_know_nothing_of_each_other(tmp_path: Path, undisturbed: dict[str, bytes], signals: Signals) -> None:
    """Three runs of the same tiles, in the same order, at the same time."""
    signals.hold(0)
    runs = [started(tmp_path, signals) for _ in range(3)]
    while signals.times(0) < 3 and not any(one.poll() for one in runs):
        time.sleep(0.01)
    signals.release(0)
    for one in runs:
        with one:
            assert one.wait() == 0, one.stderr.read() if one.stderr else ""
    store = TileStore.existing(tmp_path / "map.zarr")
    assert contents(store.path) == undisturbed
    run(Sines(GRID), store)
    assert beside(store) == []


def test_parts_at_the_same_time(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    task = Sines(GRID)
    store = TileStore.open(tmp_path / "map.zarr", task)
    parts = [threading.Thread(target=run, args=(task, store, Running(part=(k, 4)))) for k in range(1, 5)]
    for part in parts:
        part.start()
    for part in parts:
        part.join()
    assert gc.map_status(store.path).complete  # whoever was last has finished it
    assert contents(store.path) == undisturbed


# --- Dask -----------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster:
        yield cluster


def test_killed_workers_of_a_cluster(
    tmp_path: Path, undisturbed: dict[str, bytes], signals: Signals, cluster: Any
) -> None:
    signals.hold(3)
    store = TileStore.open(tmp_path / "map.zarr", signals.task)
    with beside_it(lambda: run(signals.task, store, Running(scheduler=cluster.scheduler_address))):
        first = signals.begun(3)
        os.kill(first, signal.SIGKILL)
        assert signals.begun(3, besides=first) != first
        signals.release(3)
    assert contents(store.path) == undisturbed
    assert beside(store) == []


def test_a_local_cluster_starts_by_itself(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    pytest.importorskip("distributed")
    store = made(tmp_path / "map.zarr", Sines(GRID), Running(workers=2, scheduler="local"))
    assert contents(store.path) == undisturbed


def test_workers_that_do_not_share_the_disk(tmp_path: Path, cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    task = Sines(GRID)
    store = TileStore.open(tmp_path / "map.zarr", task)
    elsewhere = TileStore(tmp_path / "elsewhere.zarr", store.layout)
    job = pickle.dumps((task, elsewhere))
    monkeypatch.setattr("gcrules.poses.tiles.cluster.pickle", SimpleNamespace(dumps=lambda _: job))
    with pytest.raises(InputError, match="does not find the store"):
        run(task, store, Running(scheduler=cluster.scheduler_address))


def test_a_fault_of_a_tile_comes_back_from_the_cluster(tmp_path: Path, cluster: Any) -> None:
    task = Sines(GRID, fault=7)
    with pytest.raises(ZeroDivisionError, match="one over nothing"):
        made(tmp_path / "map.zarr", task, Running(scheduler=cluster.scheduler_address))


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nowhere", "http:/x"])
def test_a_scheduler_that_is_not_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, address: str) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("gcrules.poses.tiles.cluster._PATIENCE", "100 ms")
    with pytest.raises(InputError, match="is not reached"):
        made(tmp_path / "map.zarr", Sines(GRID), Running(scheduler=address))


def test_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError) as fault:
        made(tmp_path / "map.zarr", Sines(GRID), Running(scheduler="local"))
    assert 'pip install "gcrules[cluster]"' in fault.value.render()
