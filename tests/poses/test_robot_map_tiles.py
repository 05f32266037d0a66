"""Maps of robots of joints in tiles: each by itself, in any order, by anybody, killed and resumed: the same bytes."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from poses.tile_tasks import beside, contents

import gcrules as gc
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs import lattice
from gcrules.poses.maps import spreading
from gcrules.poses.maps.cells import OUTSIDE
from gcrules.poses.maps.limb_task import LimbsTask, limbs_task
from gcrules.poses.maps.patches import Patches
from gcrules.poses.maps.planned import planned
from gcrules.poses.maps.tiled import GridTiles
from gcrules.poses.tiles.how import HERE, Running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import STAGE, TileStore
from gcrules.screws.threshold import DEFAULT

pytest.importorskip("zarr")

OVER = ["x -0.4:0.4:33", "yaw -20:60:65 deg"]


def tiles() -> GridTiles:
    plan = planned(mechanism("3-rpr"), OVER, None, None, DEFAULT.text, "margin")
    return GridTiles(plan.task, plan.sentence, plan.recipe)


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    store = TileStore.open(tmp_path_factory.mktemp("undisturbed") / "map.zarr", tiles())
    run(tiles(), store)
    assert beside(store) == []
    return contents(store.path)


def test_there_are_several_tiles() -> None:
    assert tiles().grid == (5,)  # the last one has one layer, and no cells


def test_a_tile_knows_nothing_of_the_others() -> None:
    """In another order, each by a task of its own, and from the branch as it was kept."""
    first = tiles()
    every = [first.compute(k) for k in range(5)]
    kept = first.task.stage
    assert kept is not None
    data = kept.staged()
    for k in (4, 2):
        for taken in (False, True):
            alone = tiles()
            if taken:
                assert alone.stage is not None
                alone.stage.take(data)
                assert alone.stage.known
            found = alone.compute(k)
            assert all(found[name].tobytes() == every[k][name].tobytes() for name in found)


def test_cells_between_tiles_are_there_once() -> None:
    found = [tiles().compute(k)["cell_status"].shape for k in (0, 3, 4)]
    assert found == [(8, 64), (8, 64), (0, 64)]


def test_workers_and_parts_make_the_same_store(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    gc.singular_map("3-rpr", OVER, work=tmp_path / "a.zarr", workers=2)
    assert contents(tmp_path / "a.zarr") == undisturbed
    for k in (2, 3, 1):
        found = gc.singular_map("3-rpr", OVER, work=tmp_path / "b.zarr", part=(k, 3))
    assert found.complete
    assert contents(tmp_path / "b.zarr") == undisturbed
    assert not list(tmp_path.glob("*.tiles"))
    assert gc.verify_map(tmp_path / "b.zarr", "all").sound


def test_a_local_cluster_makes_the_same_store(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    pytest.importorskip("distributed")
    gc.singular_map("3-rpr", OVER, work=tmp_path / "a.zarr", workers=2, scheduler="local")
    assert contents(tmp_path / "a.zarr") == undisturbed


RUN = """
import sys
from poses.test_robot_map_tiles import tiles
from poses.tile_tasks import Waiting
from gcrules.poses.tiles.how import Running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import TileStore

if __name__ == "__main__":
    path, signals, workers = sys.argv[1:]
    task = Waiting(tiles(), signals)
    run(task, TileStore.open(path, task), Running(workers=int(workers)))
"""


def begun(folder: Path, what: int | str, besides: int = 0) -> int:
    """The process that computes a tile or the stage, as soon as it does, other than `besides`."""
    while True:
        for path in folder.glob(f"begun-{what}-*"):
            if (pid := int(path.name.rsplit("-", 1)[1])) != besides:
                return pid
        time.sleep(0.01)


def started(tmp_path: Path, workers: int) -> subprocess.Popen[str]:
    script = tmp_path / "run.py"
    script.write_text(RUN, encoding="utf-8")
    words = [sys.executable, str(script), str(tmp_path / "map.zarr"), str(tmp_path), str(workers)]
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    return subprocess.Popen(words, env=env, text=True, stderr=subprocess.PIPE)


@pytest.mark.skipif(os.name != "posix", reason="kills")
@pytest.mark.parametrize(("what", "workers"), [("stage", 0), (0, 0), (3, 0), (2, 2)])
def test_a_killed_run_goes_on(tmp_path: Path, undisturbed: dict[str, bytes], what: int | str, workers: int) -> None:
    hold = tmp_path / f"hold-{what}"
    hold.touch()
    with started(tmp_path, workers) as first:
        begun(tmp_path, what)
        first.kill()
    hold.unlink()
    store = TileStore.existing(tmp_path / "map.zarr")
    assert what not in store.done()
    assert (store.beside / STAGE).exists() == (what != "stage")
    run(tiles(), store, Running(workers=workers))
    assert contents(store.path) == undisturbed
    assert beside(store) == []


@pytest.mark.skipif(os.name != "posix", reason="kills")
def test_a_killed_worker_is_replaced(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    hold = tmp_path / "hold-1"
    hold.touch()
    with started(tmp_path, 2) as whole:
        first = begun(tmp_path, 1)
        os.kill(first, signal.SIGKILL)
        assert begun(tmp_path, 1, besides=first) != first
        hold.unlink()
        assert whole.wait() == 0, whole.stderr.read() if whole.stderr else ""
    assert contents(tmp_path / "map.zarr") == undisturbed
    assert len(list(tmp_path.glob("begun-stage-*"))) == 1  # the workers have read it


@pytest.mark.parametrize("damage", [b"", b"0" * 200, None])
def test_a_damaged_branch_is_computed_again(
    tmp_path: Path, undisturbed: dict[str, bytes], damage: bytes | None
) -> None:
    task = tiles()
    store = TileStore.open(tmp_path / "map.zarr", task)
    run(task, store, Running(part=(1, 3)))
    path = store.beside / STAGE
    data = path.read_bytes()
    path.write_bytes(data[:-1] + bytes([data[-1] ^ 1]) if damage is None else damage)
    run(tiles(), store, HERE)
    assert contents(store.path) == undisturbed


def test_the_branch_of_another_grid_is_refused() -> None:
    task = tiles().task
    other = limbs_task(task.mechanism, ["x -0.4:0.4:17", "yaw -20:60:65 deg"])  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match="another grid"):
        other.take(task.stage.staged())


# --- what is reached ------------------------------------------------------------------------------------------------


def flooded(open_: Any, first: tuple[int, int]) -> Any:
    """The nodes that edges between open nodes join to the first one."""
    found = np.zeros(open_.shape, dtype=bool)
    found[first] = True
    while True:
        grown = found.copy()
        grown[1:] |= found[:-1]
        grown[:-1] |= found[1:]
        grown[:, 1:] |= found[:, :-1]
        grown[:, :-1] |= found[:, 1:]
        grown &= open_
        if (grown == found).all():
            return found
        found = grown


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_walls_are_gone_around(monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    """Where walls cut off what tiles have of the branch, it is reached by whatever way leads around them."""
    task = limbs_task(mechanism("3-rpr"), ["x -0.2:0.2:33", "yaw 0:12:41 deg"])
    shape = task.grid.shape
    free = np.ones(shape, dtype=bool)
    for k, row in enumerate((4, 9, 20, 23, 30)):  # walls along tiles, each with one gap
        free[row] = False
        free[row, 38 if (k + seed) % 2 else 2] = True
    free[10:20, 17] = False
    free[26:29, 5:9] = False  # a block of them
    free &= np.random.default_rng(seed).uniform(size=shape) > 0.05
    solved, tried = lattice.Lattice.solved, spreading._Blocks._try

    def walled(self: Any, amounts: Any, before: Any, places: Any, **more: Any) -> Any:
        found = solved(self, amounts, before, places, **more)
        if self.shape == shape:
            found[~free[tuple(np.rint(places).astype(int).T)]] = np.nan
        return found

    def take(self: Any, numbers: Any, owner: Any) -> Any:
        low = self._low(numbers)
        clear = [free[i : i + self.size + 1, j : j + self.size + 1].all() for i, j in low.tolist()]
        good = np.array(clear, dtype=bool)
        return tried(self, numbers[good], owner[good])

    monkeypatch.setattr(lattice.Lattice, "solved", walled)
    monkeypatch.setattr(spreading._Blocks, "_try", take)
    first = task._start[1]
    free.ravel()[first] = True
    branch: Patches = task._branch
    reached = (branch.owner >= 0).reshape(shape)
    assert (reached == flooded(free, tuple(np.unravel_index(first, shape)))).all()
    assert 0.2 < reached.mean() < 1
    assert len(branch.amounts) < reached.sum()  # some are in blocks
    outside = np.concatenate([task.compute(k)["cell_status"] for k in range(task.number)]) == OUTSIDE
    corners = reached[:-1, :-1] & reached[1:, :-1] & reached[:-1, 1:] & reached[1:, 1:]
    assert (outside == ~corners).all()


def test_blocks_hold_what_is_reached_node_by_node(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same map without blocks: everything along edges."""
    for name, over in (("3-rrr", ["x -0.6:0.6:25", "y -0.6:0.6:25"]), ("3-rpr", OVER)):
        one, other = (limbs_task(mechanism(name), over) for _ in range(2))
        found = everything(one)
        with monkeypatch.context() as m:
            m.setattr(spreading, "_SIZES", ())
            alone = everything(other)
        for array in ("sign", "cell_status", "allowed"):
            assert (found[array] == alone[array]).all()
        assert found["margin"] == pytest.approx(alone["margin"], abs=1e-6, nan_ok=True)
        assert found["actuator"] == pytest.approx(alone["actuator"], abs=1e-6, nan_ok=True)


def everything(task: LimbsTask) -> dict[str, Any]:
    found = [task.compute(k) for k in range(task.number)]
    return {name: np.concatenate([f[name] for f in found]) for name in found[0]}
