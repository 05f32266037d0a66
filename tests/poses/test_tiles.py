"""Tiles and their store: the same bytes whatever happened, and faults told."""

from __future__ import annotations

import errno
import os
import pickle
import shutil
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from poses.tile_tasks import Sines, beside, contents, task_again

import gcrules as gc
from gcrules.core.errors import EngineFault, FileError, InputError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.stored_maps import kinds
from gcrules.poses.tiles.how import HERE, Running, parse_part, running
from gcrules.poses.tiles.layout import Layout, layout_of
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.status import rate_of
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import TiledArray, number_of
from gcrules.poses.tiles.zarr_files import attributes

pytest.importorskip("zarr")

TASK = Sines()
LARGE = Sines((20, 9))  # several shards


@pytest.fixture
def known(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tasks of tests are made anew from their stores, too."""
    monkeypatch.setattr(kinds, "KINDS", FrozenMap({**kinds.KINDS, "sines": task_again}))


def made(path: Path, task: Sines = TASK, how: Running = HERE) -> TileStore:
    store = TileStore.open(path, task)
    run(task, store, how)
    return store


@pytest.fixture
def undisturbed(tmp_path: Path) -> dict[str, bytes]:
    """The files of the store of an undisturbed run in one process."""
    (tmp_path / "undisturbed").mkdir()
    return contents(made(tmp_path / "undisturbed" / "map.zarr").path)


# --- what is in it --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("task", [TASK, LARGE, Sines((1, 2)), Sines((2, 70))], ids=lambda t: str(t.grid))
def test_tiles_are_read_back(tmp_path: Path, task: Sines) -> None:
    store = made(tmp_path / "map.zarr", task)
    assert beside(store) == []
    assert store.done() == set(range(number_of(task)))
    for tile in range(store.number):
        found, expected = store.get(tile), task.compute(tile)
        assert found is not None
        for name, values in expected.items():
            assert np.array_equal(found[name], values, equal_nan=values.dtype.kind == "f")
    again = TileStore.existing(store.path)
    assert again == store == pickle.loads(pickle.dumps(store))
    assert hash(again) == hash(store)
    assert again.manifest == task.manifest


def test_a_store_is_a_dataset_with_names_and_units(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    store = made(tmp_path / "map.zarr", LARGE)
    with xarray.open_zarr(store.path) as found:
        assert found.sine.dims == ("x", "y")
        assert found.sine.units == found.x.units == "mm"
        assert found.pair.sel(of="cosine").shape == LARGE.shape
        assert found.high.attrs["flag_meanings"] == "low high"
        assert found.digest.dims == ("x_tile", "y_tile", "byte")
        whole = np.sin(found.x.values[:, None] + 2 * found.y.values[None])
        assert np.array_equal(np.where(whole < -0.99, np.nan, whole), found.sine.values, equal_nan=True)
        assert found.attrs["title"] == "Sines"


def test_what_is_not_done_is_no_value_that_means_something(tmp_path: Path) -> None:
    zarr = pytest.importorskip("zarr")
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    group = zarr.open_group(store.path, mode="r")
    assert np.isnan(group["sine"][...]).all()
    assert (group["high"][...] == 255).all()
    assert not group["digest"][...].any()


def test_several_tiles_are_one_file_of_each_array(tmp_path: Path) -> None:
    store = made(tmp_path / "map.zarr", LARGE)
    shards = len(store.shards)
    assert 1 < shards < number_of(LARGE) / 8
    assert len([p for p in (store.path / "sine" / "c").rglob("*") if p.is_file()]) == shards


@pytest.mark.parametrize(
    ("grid", "most"), [((1,), 1), ((7,), 7), ((1000,), 64), ((30, 30), 64), ((5, 300), 64), ((3,) * 6, 64)], ids=str
)
def test_shards_part_the_tiles(grid: tuple[int, ...], most: int) -> None:
    layout = Layout("", grid, ())
    tiles = [t for shard in range(int(np.prod(layout.shards))) for t in layout.tiles(shard)]
    assert sorted(tiles) == list(range(layout.number))
    assert max(len(layout.tiles(s)) for s in range(int(np.prod(layout.shards)))) <= most
    for shard in range(int(np.prod(layout.shards))):
        assert {layout.shard_of(t) for t in layout.tiles(shard)} == {shard}


# --- whatever happens -----------------------------------------------------------------------------------------------


class Killed(BaseException):
    """In place of a signal that ends the process at once."""


class Doomed:
    """A process that is killed at the `last` file that it puts in its place, before or after it does; it tidies up
    nothing.
    """

    def __init__(self, last: int, patch: pytest.MonkeyPatch) -> None:
        self.left, self.before, self.dead = last, bool(last % 2), False
        owner: Any
        for owner, name in ((os, "replace"), (os, "rename")):
            patch.setattr(owner, name, self.counted(getattr(owner, name)))
        for owner, name in ((shutil, "rmtree"), (os, "unlink"), (os, "rmdir"), (Path, "unlink"), (Path, "rmdir")):
            patch.setattr(owner, name, self.alive(getattr(owner, name)))

    def counted(self, real: Any) -> Any:
        def step(*args: Any, **options: Any) -> Any:
            self.left -= 1
            self.dead |= self.left < 0
            if self.dead and self.before:
                raise Killed
            found = real(*args, **options)
            if self.dead:
                raise Killed
            return found

        return step

    def alive(self, real: Any) -> Any:
        return lambda *args, **options: None if self.dead else real(*args, **options)


def test_a_run_that_ends_at_any_file_goes_on(
    tmp_path: Path, undisturbed: dict[str, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    """From making the store to the last digest."""
    dead, last = True, 0
    while dead:
        (tmp_path / f"run-{last}").mkdir()
        path = tmp_path / f"run-{last}" / "map.zarr"
        with monkeypatch.context() as patch:
            doomed = Doomed(last, patch)
            with suppress(Killed):
                made(path)
        store = made(path)
        assert contents(store.path) == undisturbed
        assert beside(store) == []
        dead = doomed.dead
        last += 1
    assert last > number_of(TASK)


def test_an_interrupted_run_loses_nothing_that_is_done(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    computed: list[int] = []

    class Stopping(Sines):
        def compute(self, tile: int) -> Any:
            if tile == 7 and 7 not in computed:
                computed.append(tile)
                raise KeyboardInterrupt
            computed.append(tile)
            return super().compute(tile)

    with pytest.raises(KeyboardInterrupt):
        run(Stopping(), store)
    assert store.done() == set(range(7))
    run(Stopping(), store)
    assert computed == [*range(8), *range(7, 20)]
    assert contents(store.path) == undisturbed


@pytest.mark.parametrize("damage", ["cut", "changed", "empty", "of another tile"])
def test_a_damaged_tile_is_computed_again(tmp_path: Path, undisturbed: dict[str, bytes], damage: str) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    for tile in range(10):
        store.put(tile, TASK.compute(tile))
    (folder,) = (tmp_path / "map.zarr.tiles").glob("shard-*")
    path = folder / "tile-4"
    data = path.read_bytes()
    spoilt = {
        "cut": data[:-3],
        "changed": data[:50] + bytes([data[50] ^ 1]) + data[51:],
        "empty": b"",
        "of another tile": (folder / "tile-5").read_bytes(),
    }
    path.write_bytes(spoilt[damage])
    assert store.get(4) is None
    assert store.done() == set(range(10)) - {4}
    run(TASK, store)
    assert contents(store.path) == undisturbed


@pytest.mark.parametrize("array", ["sine", "pair", "high", "digest"])
@pytest.mark.parametrize("damage", ["cut", "changed", "gone"])
def test_a_damaged_shard_is_mended(
    tmp_path: Path, undisturbed: dict[str, bytes], array: str, damage: str, known: None
) -> None:
    store = made(tmp_path / "map.zarr")
    (path,) = (p for p in (store.path / array / "c").rglob("*") if p.is_file())
    data = path.read_bytes()
    if damage == "gone":
        path.unlink()
    else:
        path.write_bytes(data[: len(data) // 2] if damage == "cut" else data[:9] + bytes([data[9] ^ 8]) + data[10:])
    store = TileStore.open(store.path, TASK)
    bad = [t for t in range(store.number) if store.get(t) is None]
    assert bad
    if (array, damage) != ("digest", "gone"):
        found = gc.verify_map(store.path, 0)
        assert not found.sound
        assert {b.tile for b in found.bad} == set(bad)
    for tile in bad:
        if store.get(tile) is None:
            store.unseal(tile)
            run(TASK, store)
    assert contents(store.path) == undisturbed


def test_who_comes_late_leaves_nothing(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    store = made(tmp_path / "map.zarr")
    store.put(3, TASK.compute(3))
    assert beside(store) == []
    shard = tmp_path / "map.zarr.tiles" / "shard-0-0"  # of one that was killed before it looked
    shard.mkdir(parents=True)
    (shard / "tile-3").write_bytes(b"?")
    (tmp_path / "map.zarr.tiles" / ".new-7-ab").mkdir()
    run(TASK, TileStore.open(store.path, TASK))
    assert beside(store) == []
    assert contents(store.path) == undisturbed


def test_two_put_one_shard_together(
    tmp_path: Path, undisturbed: dict[str, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The other one is through, and has removed the tiles, wherever this one is in its work."""
    real, steps = os.replace, 0
    while True:
        store = TileStore.open(tmp_path / f"map-{steps}.zarr", TASK)
        for tile in range(19):
            store.put(tile, TASK.compute(tile))
        left, other = steps, True

        def replace(a: Any, b: Any, store: TileStore = store) -> None:
            nonlocal left, other
            left -= 1
            if left == -1 and other:
                other = False
                TileStore(store.path, store.layout).put(19, TASK.compute(19))
            real(a, b)

        monkeypatch.setattr(os, "replace", replace)
        store.put(19, TASK.compute(19))
        monkeypatch.setattr(os, "replace", real)
        assert contents(store.path) == undisturbed
        assert store.settle_all()
        assert beside(store) == []
        if other:
            break
        steps += 1
    assert steps >= 4


def test_a_reader_finds_a_tile_that_moves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    for tile in range(19):
        store.put(tile, TASK.compute(tile))
    real = Path.read_bytes

    def read(path: Path) -> bytes:
        if path.name == "tile-3":
            monkeypatch.setattr(Path, "read_bytes", real)
            store.put(19, TASK.compute(19))
        return real(path)

    monkeypatch.setattr(Path, "read_bytes", read)
    assert store.get(3) is not None
    assert not (tmp_path / "map.zarr.tiles").exists()


def test_parts_of_a_job_array(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    for k in (2, 3, 1):
        store = made(tmp_path / "map.zarr", how=running(part=(k, 3)))
        status = gc.map_status(store.path)
        assert status.complete is (k == 1)
    assert status.done == 20
    assert beside(store) == []
    assert contents(store.path) == undisturbed


@pytest.mark.parametrize("number", [1, 2, 5, 7, 40])
@pytest.mark.parametrize("task", [TASK, Sines((100, 60))], ids=lambda t: str(t.grid))
def test_parts_are_all_tiles(tmp_path: Path, number: int, task: Sines) -> None:
    store = TileStore(tmp_path, layout_of(task))
    parts = [Running(part=(k, number)).tiles(store) for k in range(1, number + 1)]
    assert sorted(t for p in parts for t in p) == list(range(store.number))
    sizes = [len(p) for p in parts]
    assert max(sizes) - min(sizes) <= 1


# --- faults ---------------------------------------------------------------------------------------------------------


def test_a_store_of_another_problem_is_refused(tmp_path: Path) -> None:
    store = made(tmp_path / "map.zarr")
    before = contents(store.path)
    other = Sines(scale=2.0)
    with pytest.raises(FileError, match=r"of another map: wave\.scale differs") as fault:
        TileStore.open(store.path, other)
    assert "--restart" in fault.value.render()
    assert contents(store.path) == before
    run(other, TileStore.open(store.path, other, restart=True))
    assert TileStore.existing(store.path).manifest == other.manifest


def test_a_store_that_another_makes_meanwhile_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another run's store appears between any two looks at the folder."""
    path = tmp_path / "map.zarr"
    looking = "gcrules.poses.tiles.store.attributes"

    def late(folder: Path) -> Any:
        found = attributes(folder)
        monkeypatch.setattr(looking, attributes)
        TileStore.open(path, TASK)
        return found

    monkeypatch.setattr(looking, late)
    store = TileStore.open(path, TASK)
    run(TASK, store)
    assert store.done() == set(range(number_of(TASK)))


def test_other_files_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    for restart in (False, True):
        with pytest.raises(FileError, match="holds other files"):
            TileStore.open(tmp_path, TASK, restart=restart)
    with pytest.raises(FileError, match="a file is in the way"):
        TileStore.open(tmp_path / "thesis.tex", TASK)
    with pytest.raises(FileError, match="cannot be written"):
        TileStore.open(tmp_path / "no" / "map.zarr", TASK)
    for path in (tmp_path, tmp_path / "nothing", tmp_path / "thesis.tex"):
        with pytest.raises(FileError, match="not a store"):
            gc.map_status(path)
    assert [p.name for p in tmp_path.iterdir()] == ["thesis.tex"]


@pytest.mark.parametrize("where", ["tile", "shard", "store"])
def test_a_full_disk(
    tmp_path: Path, undisturbed: dict[str, bytes], monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    def full(*_: Any, **__: Any) -> Any:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    target = {
        "tile": "pathlib.Path.write_bytes",
        "shard": "gcrules.poses.tiles.store.written_shard",
        "store": "gcrules.poses.tiles.store.make",
    }[where]
    with monkeypatch.context() as patch:
        patch.setattr(target, full)
        with pytest.raises(FileError, match="No space left on device") as fault:
            made(tmp_path / "map.zarr")
    assert "free some space" in fault.value.render()
    assert not list(tmp_path.rglob(".new-*"))
    assert contents(made(tmp_path / "map.zarr").path) == undisturbed


@pytest.mark.parametrize(
    "text", ["", "3", "0/3", "4/3", "1/0", "-1/3", "1/3/5", "1.0/3", "a/b", "１/３", "1/" + "9" * 40]
)
def test_parts_that_are_none(text: str) -> None:
    with pytest.raises(InputError, match="'K/N' is a part"):
        parse_part(text)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"workers": -1}, "-1 workers"),
        ({"workers": 10**6}, "1000000 workers"),
        ({"part": (0, 3)}, "is a part"),
        ({"part": "1/2", "scheduler": "local"}, "has no scheduler"),
        ({"workers": 2, "scheduler": "tcp://host:1"}, "are its own"),
    ],
    ids=str,
)
def test_what_does_not_go_together(options: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        running(**options)


def test_a_task_that_does_not_do_what_it_says(tmp_path: Path) -> None:
    class Wrong(Sines):
        def compute(self, tile: int) -> Any:
            return {n: a.astype("f4") for n, a in super().compute(tile).items()}

    with pytest.raises(EngineFault, match="not as its task says"):
        made(tmp_path / "map.zarr", Wrong())
    with pytest.raises(EngineFault, match="does not lie"):
        Layout("", (2,), (TiledArray("a", ("x",), (30,), (10,), "u1"),))


# --- status, verify, merge ------------------------------------------------------------------------------------------


def test_the_rate_is_taken_from_the_files(tmp_path: Path) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    status = gc.map_status(store.path)
    assert (status.done, status.tiles, status.rate, status.left, status.last) == (0, 20, None, None, None)
    for tile in range(5):
        store.put(tile, TASK.compute(tile))
        (path,) = (tmp_path / "map.zarr.tiles").rglob(f"tile-{tile}")
        os.utime(path, (1000.0 + 2 * tile, 1000.0 + 2 * tile))
    status = gc.map_status(store.path)
    assert (status.done, status.rate, status.left) == (5, 0.5, 30.0)
    assert status.last is not None
    assert "0.5 tiles a second" in str(status)
    run(TASK, store)
    assert gc.map_status(store.path).complete
    assert rate_of([(0.0, 500), (10.0, 500), (20.0, 600)]) == 60.0  # of the last thousand


def test_what_was_forged_is_noticed(tmp_path: Path, known: None) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    for tile in range(20):
        arrays = dict(TASK.compute(tile))
        if tile == 11:
            arrays["high"] = 1 - arrays["high"]
        store.put(tile, arrays)
    assert gc.verify_map(store.path, 0).sound  # the digests are right
    found = gc.verify_map(store.path, "all")
    assert found.again == tuple(range(20))
    assert [(b.tile, b.why) for b in found.bad] == [(11, "it is not what is computed now")]
    assert "tile 11" in str(found)
    chosen = {gc.verify_map(store.path, 2).again for _ in range(6)}
    assert all(len(c) == 2 for c in chosen)


def test_an_unfinished_store_is_verified_as_far_as_it_goes(tmp_path: Path, known: None) -> None:
    store = TileStore.open(tmp_path / "map.zarr", TASK)
    store.put(4, TASK.compute(4))
    found = gc.verify_map(store.path)
    assert (found.done, found.again, found.sound, found.complete) == (1, (4,), True, False)


def test_a_store_whose_task_is_not_known(tmp_path: Path) -> None:
    store = made(tmp_path / "map.zarr")
    with pytest.raises(FileError, match="of another kind: sines"):
        gc.verify_map(store.path)
    with pytest.raises(InputError, match="not a number of tiles"):
        gc.verify_map(store.path, "some")


def test_stores_are_merged(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    stores = []
    for k in (1, 2, 3):
        folder = tmp_path / f"disk-{k}"
        folder.mkdir()
        stores.append(made(folder / "map.zarr", how=running(part=(k, 3))).path)
    partial = gc.merge_maps(stores[:2], tmp_path / "partial.zarr")
    assert not partial.complete
    status = gc.merge_maps([tmp_path / "partial.zarr", stores[2], stores[0]], tmp_path / "map.zarr")
    assert status.complete
    assert contents(tmp_path / "map.zarr") == undisturbed
    assert not (tmp_path / "map.zarr.tiles").exists()
    with pytest.raises(FileError, match="there already"):
        gc.merge_maps(stores, tmp_path / "map.zarr")


def test_what_is_not_merged(tmp_path: Path) -> None:
    one, other = made(tmp_path / "one.zarr").path, made(tmp_path / "other.zarr", Sines(scale=3.0)).path
    with pytest.raises(FileError, match=r"of another map than .*one.zarr: wave\.scale differs"):
        gc.merge_maps([one, other], tmp_path / "map.zarr")
    forged = TileStore.open(tmp_path / "forged.zarr", TASK)
    forged.put(5, {**TASK.compute(5), "high": np.zeros((5, 4), np.uint8) + 7})
    with pytest.raises(FileError, match="tile 5 is not the same in"):
        gc.merge_maps([one, forged.path], tmp_path / "map.zarr")
    with pytest.raises(InputError, match="no store is given"):
        gc.merge_maps([], tmp_path / "map.zarr")
    assert not (tmp_path / "map.zarr").exists()
    assert not (tmp_path / "map.zarr.tiles").exists()
