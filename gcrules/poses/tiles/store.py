r"""Where tiles are kept: one Zarr v3 store, and beside it, while it grows, a folder of the tiles that are done.

A tile that is done is a file `NAME.tiles/shard-…/tile-N`, written under another name first and then renamed, which
begins with the digest of what follows. When all tiles of a shard are there, whoever notices puts them together: the
files of the arrays are written and renamed into the store, then the file of the shard's digests, and then the tiles
are removed. So, whatever is killed at whatever moment,

* what has a digest in the store is there, for its arrays were renamed before;
* a tile is nowhere only before it is done: its file goes when the digests are there;
* two that put one shard together write the same bytes, and one of them may find that the files have gone: then the
  digests are there, which it looks at again;
* a tile that comes late, to a shard that has its digests already, is removed by who wrote it, who looks after writing.

Any number of processes may work on one store; they need not know of each other, and nothing is locked. Nothing in the
store tells the time or the machine, so that it has the same bytes however it came about.
"""

from __future__ import annotations

import json
import math
import os
import shutil
from collections.abc import Iterable, Mapping
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, FileError, InputError
from gcrules.core.files import check_name, unwritable
from gcrules.poses.tiles.layout import DIGEST, Layout, layout_of
from gcrules.poses.tiles.task import Tile, TileTask, tile_at
from gcrules.poses.tiles.zarr_files import arrays_in, attributes, digests_file, make, opened, written_shard

__all__ = ["STAGE", "TileStore", "differing", "replace", "written"]

STAGE = "stage"
"""The file beside a store that holds the outcome of its task's stage."""
_NEW = ".new-"
_TRIES = 100  # a folder may be removed between making it and writing to it, but not for ever


@dataclass(frozen=True)
class TileStore:
    """Tiles that lie in the store `path` as `layout` says."""

    path: Path
    layout: Layout

    def __reduce__(self) -> tuple[Any, ...]:
        return TileStore, (self.path, self.layout)

    # --- opening

    @staticmethod
    def open(path: str | os.PathLike[str], task: TileTask, *, restart: bool = False) -> TileStore:
        """The store of a task, made where there is none; what is there of it is kept.

        Raises FileError where the folder holds something else, unless `restart` says to begin anew and it is a store,
        and where it cannot be written; InputError without the extra that Zarr needs.
        """
        folder, layout = _folder(path), layout_of(task)
        store = TileStore(folder, layout)
        if folder.exists() and not folder.is_dir():
            raise FileError("a file is in the way, expected a store of tiles", filename=str(path))
        filled = folder.is_dir() and any(folder.iterdir())  # looked at first: another may put the store there meanwhile
        found = attributes(folder)
        if found is None and filled:
            raise FileError("this folder holds other files; it is not touched", filename=str(path))
        try:
            if restart:
                store.remove()
                found = None
            if found is None:
                found = store._made(task)
        except OSError as fault:
            raise written(fault, str(path)) from None
        _check_problem(found, task, layout, str(path))
        return store

    @staticmethod
    def existing(path: str | os.PathLike[str]) -> TileStore:
        """The store that is there. Raises FileError where there is none."""
        folder = _folder(path)
        try:
            found = attributes(folder)
            if found is not None:
                return TileStore(folder, arrays_in(found))
        except (KeyError, TypeError, IndexError, EngineFault):
            pass
        raise FileError("not a store of a map in tiles", filename=str(path), hint="gcrules map … -o map.zarr makes one")

    def _made(self, task: TileTask) -> Mapping[str, Any]:
        """The metadata of a new store, which appears complete or not at all; of another's where one was quicker."""
        new = self.beside / f"{_NEW}{_own()}"
        self.beside.mkdir(exist_ok=True)
        try:
            make(new, self.layout, task)
            with suppress(OSError):
                os.rename(new, self.path)
        finally:
            shutil.rmtree(new, ignore_errors=True)
        found = attributes(self.path)
        if found is None:
            raise FileError("cannot be written: something else is there", filename=str(self.path))
        return found

    def copied(self, path: str | os.PathLike[str]) -> TileStore:
        """A new store for the same problem, without tiles. Raises FileError where something is there already."""
        folder = _folder(path)
        if folder.exists():
            raise FileError("this is there already", filename=str(path), hint="give the new store another name")
        tiled = {str(self.path / name) for name in (*(a.name for a in self.layout.arrays), "digest")}
        try:
            shutil.copytree(self.path, folder, ignore=lambda at, names: ["c"] if at in tiled and "c" in names else [])
        except (OSError, shutil.Error) as fault:
            raise written(OSError(*fault.args), str(path)) from None
        return TileStore(folder, self.layout)

    @property
    def about(self) -> Mapping[str, Any]:
        """What the store is of: its attributes."""
        found = attributes(self.path)
        if found is None:
            raise FileError("the store is gone", filename=str(self.path))
        known: Mapping[str, Any] = found["attributes"]
        return known

    @property
    def manifest(self) -> dict[str, Any]:
        """Everything that the tiles depend on."""
        return dict(json.loads(self.about["manifest"]))

    @property
    def recipe(self) -> dict[str, Any]:
        """From what the task is made anew."""
        return dict(json.loads(self.about["recipe"]))

    # --- tiles

    @property
    def number(self) -> int:
        """How many tiles there are."""
        return self.layout.number

    def get(self, tile: int) -> Tile | None:
        """The arrays of a tile; None where it is not done, or damaged."""
        for _ in range(2):  # between two looks it may have moved from its file into the shard
            if self._digest(tile) is not None:
                return self._in_shard(tile)
            if (found := self._in_file(tile)) is not None:
                return found
        return None

    def there(self, tile: int) -> bool:
        """Whether a tile is done, damaged or not."""
        return self._digest(tile) is not None or self._file(tile).exists() or self._digest(tile) is not None

    def done(self, among: Iterable[int] | None = None) -> set[int]:
        """The tiles, of all or of those `among` which one looks, that are done; files beside the store are read, for
        damaged ones are not.
        """
        asked = set(range(self.number) if among is None else among)
        found: set[int] = set()
        for shard in sorted({self.layout.shard_of(t) for t in asked}):
            digests = self.digests(shard)
            if digests is not None:
                found |= {t for t in self.layout.tiles(shard) if digests[self.layout.inside(t)].any()}
            else:
                found |= {t for t in self.files(shard) if t in asked and self._in_file(t) is not None}
        return found & asked

    def put(self, tile: int, arrays: Tile) -> None:
        """Keep a tile; what it completes is put together. Raises FileError where that is not possible."""
        data = self.layout.packed(tile, arrays)
        shard = self.layout.shard_of(tile)
        try:
            for _ in range(_TRIES):
                if self.digests(shard) is not None:
                    break
                with suppress(FileNotFoundError):  # the folder was removed by who put the shard together
                    self._folder(shard).mkdir(parents=True, exist_ok=True)
                    replace(self._file(tile), data)
                    break
            self.settle(shard)
        except OSError as fault:
            raise written(fault, str(self.path)) from None

    def settle(self, shard: int) -> None:
        """Put a shard together if all its tiles are there; remove the files of one that is."""
        if self.digests(shard) is None and len(self.files(shard)) == len(self.layout.tiles(shard)):
            self._assemble(shard)
        if self.digests(shard) is not None:
            shutil.rmtree(self._folder(shard), ignore_errors=True)
            with suppress(OSError):
                self.beside.rmdir()  # where no other shard has files

    def settle_all(self) -> bool:
        """The same for all shards. Whether the store is complete, as `finish` says."""
        for shard in self.shards:
            self.settle(shard)
        return self.finish()

    def finish(self) -> bool:
        """Whether the store is complete; then nothing is left beside it."""
        complete = all(self.digests(shard) is not None for shard in self.shards)
        if complete:
            self._tidy()
        return complete

    def unseal(self, tile: int) -> None:
        """Take a shard apart of which a tile is damaged: its good tiles are files again, the others not done."""
        shard = self.layout.shard_of(tile)
        try:
            self._folder(shard).mkdir(parents=True, exist_ok=True)
            for one in self.layout.tiles(shard):
                if one != tile and (found := self.get(one)) is not None:
                    replace(self._file(one), self.layout.packed(one, found))
            digests_file(self.path, self.layout, shard).unlink(missing_ok=True)
        except OSError as fault:
            raise written(fault, str(self.path)) from None

    def remove(self) -> None:
        """Remove the store and what lies beside it."""
        if attributes(self.path) is not None:
            shutil.rmtree(self.path, ignore_errors=True)
        self._tidy()

    def _tidy(self) -> None:
        """Nothing of ours is left beside the store."""
        for pattern in ("shard-*", f"{_NEW}*"):
            for left in self.beside.glob(pattern):
                shutil.rmtree(left, ignore_errors=True)
        with suppress(OSError):
            (self.beside / STAGE).unlink(missing_ok=True)
            self.beside.rmdir()

    # --- what lies where

    def digests(self, shard: int) -> NDArray[np.uint8] | None:
        """The digests of the tiles of a shard, an array of its shape and 32; None where the shard is not there."""
        shape = (*self.layout.shard, DIGEST)
        try:
            data = digests_file(self.path, self.layout, shard).read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            return None
        found = np.frombuffer(data, np.uint8)
        return found.reshape(shape) if found.size == np.prod(shape) else np.zeros(shape, np.uint8)

    def files(self, shard: int) -> list[int]:
        """The tiles of a shard that lie beside the store."""
        try:
            names = os.listdir(self._folder(shard))
        except OSError:
            return []
        return sorted(int(n[5:]) for n in names if n.startswith("tile-"))

    def times(self) -> list[tuple[float, int]]:
        """When so many tiles were done, as the file system says."""
        found: list[tuple[float, int]] = []
        for shard in self.shards:
            with suppress(OSError):
                when = digests_file(self.path, self.layout, shard).stat().st_mtime
                found.append((when, len(self.layout.tiles(shard))))
                continue
            for tile in self.files(shard):
                with suppress(OSError):
                    found.append((self._file(tile).stat().st_mtime, 1))
        return sorted(found)

    @property
    def beside(self) -> Path:
        """The folder in which files are while the store grows."""
        return self.path.with_name(f"{self.path.name}.tiles")

    def _folder(self, shard: int) -> Path:
        return self.beside / f"shard-{'-'.join(map(str, tile_at(self.layout.shards, shard)))}"

    def _file(self, tile: int) -> Path:
        return self._folder(self.layout.shard_of(tile)) / f"tile-{tile}"

    @property
    def shards(self) -> range:
        """The numbers of the shards."""
        return range(math.prod(self.layout.shards))

    def _digest(self, tile: int) -> bytes | None:
        digests = self.digests(self.layout.shard_of(tile))
        return None if digests is None else digests[self.layout.inside(tile)].tobytes()

    @cached_property
    def _group(self) -> Any:
        return opened(self.path)

    @cached_property
    def _arrays(self) -> dict[str, Any]:
        return {a.name: self._group[a.name] for a in self.layout.arrays}

    def _in_shard(self, tile: int) -> Tile | None:
        digest = self._digest(tile)
        try:
            found = {
                a.name: np.asarray(self._arrays[a.name][a.region(self.layout.grid, tile)], a.dtype)
                for a in self.layout.arrays
            }
        except Exception:  # a damaged file raises whatever the readers stumble over
            return None
        return found if self.layout.packed(tile, found)[:DIGEST] == digest else None

    def _in_file(self, tile: int) -> Tile | None:
        try:
            return self.layout.unpacked(tile, self._file(tile).read_bytes())
        except OSError:
            return None

    def _assemble(self, shard: int) -> None:
        tiles = self.layout.tiles(shard)
        digests = np.zeros((*self.layout.shard, DIGEST), np.uint8)
        found = {}
        for tile in tiles:
            arrays = self._in_file(tile)
            if arrays is None:
                return  # another one was quicker, or it is damaged, and will be computed again
            found[tile] = arrays
            digest = self.layout.packed(tile, arrays)[:DIGEST]
            digests[self.layout.inside(tile)] = np.frombuffer(digest, np.uint8)
        scratch = self.beside / f"{_NEW}{_own()}"
        try:
            written_shard(self.path, scratch, self.layout, shard, found)
            note = digests_file(self.path, self.layout, shard)
            note.parent.mkdir(parents=True, exist_ok=True)
            replace(note, digests.tobytes(), scratch)
        except Exception:
            if self.digests(shard) is None:
                raise
            # another one was quicker, and has tidied up
        finally:
            shutil.rmtree(scratch, ignore_errors=True)


def _folder(path: str | os.PathLike[str]) -> Path:
    """The whole name of a folder. Raises FileError for what is none."""
    check_name(os.fspath(path))
    try:
        return Path(os.path.abspath(path))
    except OSError as fault:  # the working directory has gone
        raise FileError(f"cannot be found: {fault.strerror}", filename=os.fspath(path)) from None


def written(fault: OSError, path: str) -> InputError:
    """The fault of a file that cannot be written, with advice where the disk is full."""
    return unwritable(
        fault, path, "free some space; finished tiles are kept, and the same command continues from there"
    )


def _own() -> str:
    return f"{os.getpid()}-{os.urandom(4).hex()}"


def _check_problem(found: Mapping[str, Any], task: TileTask, layout: Layout, path: str) -> None:
    about = found["attributes"]
    if about["problem"] == layout.problem and arrays_in(found) == Layout(layout.problem, layout.grid, layout.arrays):
        return
    changed = differing(json.loads(about["manifest"]), json.loads(json.dumps(task.manifest)))
    raise FileError(
        f"the tiles there are of another map: {', '.join(changed) or 'something'} differs",
        filename=path,
        hint="--restart starts over (in Python restart=True); or give the map another name",
    )


def differing(one: Any, other: Any, name: str = "") -> list[str]:
    """The fields in which two manifests differ."""
    if not isinstance(one, dict) or not isinstance(other, dict):
        return [] if one == other else [name]
    found = []
    for key in dict.fromkeys((*one, *other)):
        found += differing(one.get(key), other.get(key), f"{name}.{key}" if name else key)
    return found


def replace(target: Path, data: bytes, scratch: Path | None = None) -> None:
    """A file that appears complete or not at all; it is written in `scratch`, or beside."""
    temporary = (scratch or target.parent) / f"{_NEW}{_own()}"
    try:
        temporary.write_bytes(data)
        os.replace(temporary, target)
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
