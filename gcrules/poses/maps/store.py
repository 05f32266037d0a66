r"""Where the chunks of a map are kept: in memory, or in a folder beside the output, so that a long run can be resumed.

The folder holds `manifest.json`, which says of what the chunks are, and `chunk-N.npz` for each chunk that is done,
written under another name first and then renamed. A chunk that cannot be read is computed again. `lock` is locked while
a process works on the folder, and is free again when the process ends, however it does.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Mapping
from dataclasses import field
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, InputError
from gcrules.core.files import unwritable
from gcrules.core.frozen import HoldsArrays
from gcrules.poses.maps.task import Chunk

__all__ = ["Folder", "Memory", "Store", "check_room", "written"]

_PREFIX = ".new-"
_LOCK = "lock"


@dataclass(frozen=True, eq=False)
class Memory(HoldsArrays):
    """Chunks that are kept in memory."""

    chunks: dict[int, Chunk] = field(default_factory=dict)

    def get(self, chunk: int) -> Chunk | None:
        return self.chunks.get(chunk)

    def put(self, chunk: int, arrays: Chunk) -> None:
        self.chunks[chunk] = arrays

    def close(self) -> None:
        """Nothing is left behind."""


@dataclass(frozen=True)
class Folder:
    """Chunks that are kept in the folder `path`; `names` are the arrays of each."""

    path: Path
    names: tuple[str, ...]
    lock: _Lock | None = field(default=None, repr=False, compare=False)

    def __reduce__(self) -> tuple[Any, ...]:
        return Folder, (self.path, self.names)  # a lock is of one process

    @staticmethod
    def open(path: str, names: tuple[str, ...], manifest: Mapping[str, Any], *, restart: bool = False) -> Folder:
        """A folder for the work that `manifest` (with its `fingerprint`) describes; what is there of it is kept.

        Raises FileError where the folder holds something else, unless `restart` says to begin anew, where another
        process works on it, or where it cannot be written.
        """
        folder = Path(path)
        note = folder / "manifest.json"
        if folder.exists() and not folder.is_dir():
            raise FileError("a file is in the way, expected a folder of finished chunks", filename=path)
        if folder.is_dir() and _manifest(note) is None and not all(_ours(p) for p in folder.iterdir()):
            raise FileError("this folder holds other files; it is not touched", filename=path)
        try:
            folder.mkdir(exist_ok=True)
            lock = _Lock(folder / _LOCK)
        except OSError as fault:
            raise written(fault, path) from None
        if not lock.acquired():
            lock.close()
            raise FileError(
                "another run is at work on this map", filename=path, hint="wait for it, or give the map another name"
            )
        found = _manifest(note)
        if restart or found is None:
            _clear(folder)
        elif found.get("fingerprint") != manifest["fingerprint"]:
            lock.close()
            changed = [k for k in manifest if k != "fingerprint" and found.get(k) != manifest[k]]
            raise FileError(
                f"the finished chunks are of another map: {', '.join(changed) or 'something'} differs",
                filename=path,
                hint="--restart begins anew; or give the map another name",
            )
        try:
            _replace(note, lambda file: file.write(json.dumps(dict(manifest), indent=1).encode()))
        except OSError as fault:
            raise written(fault, path) from None
        return Folder(folder, names, lock)

    def get(self, chunk: int) -> Chunk | None:
        try:
            with self._file(chunk).open("rb") as file, np.load(file, allow_pickle=False) as arrays:
                return {name: arrays[name] for name in self.names}
        except Exception:  # a damaged file raises whatever the readers of archives and arrays stumble over
            return None

    def put(self, chunk: int, arrays: Chunk) -> None:
        try:
            _replace(self._file(chunk), lambda file: np.savez(file, **dict[str, Any](arrays)))
        except OSError as fault:
            raise written(fault, str(self.path)) from None

    def close(self) -> None:
        """Remove the folder; the map is done."""
        _clear(self.path)
        (self.path / _LOCK).unlink(missing_ok=True)
        self.path.rmdir()
        if self.lock is not None:
            self.lock.close()

    def _file(self, chunk: int) -> Path:
        return self.path / f"chunk-{chunk:06d}.npz"


Store = Memory | Folder


def written(fault: OSError, path: str) -> InputError:
    """The fault of a file that cannot be written, with advice where the disk is full."""
    return unwritable(fault, path, "make room; finished chunks are kept, and the same command goes on from there")


def check_room(path: str, needed: int, free: Callable[[str], Any] = shutil.disk_usage) -> None:
    """Raises FileError where the disk has less than `needed` bytes left."""
    folder = os.path.dirname(os.path.abspath(path))
    if os.path.isdir(folder) and (left := free(folder).free) < needed:
        raise FileError(
            f"about {needed / 1e9:.1f} GB are needed, {left / 1e9:.1f} GB are free on this disk",
            filename=path,
            hint="take a coarser grid, or --measure value, which needs less",
        )


def _ours(path: Path) -> bool:
    return path.name in ("manifest.json", _LOCK) or path.name.startswith((_PREFIX, "chunk-"))


def _manifest(note: Path) -> dict[str, Any] | None:
    try:
        found = json.loads(note.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return found if isinstance(found, dict) else None


def _clear(folder: Path) -> None:
    for path in folder.iterdir():
        if _ours(path) and path.name != _LOCK:
            path.unlink()


class _Lock:
    """A file that is locked for this process, until this value is gone or closed."""

    def __init__(self, path: Path) -> None:
        self.file = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)

    def acquired(self) -> bool:
        """Whether no other process has it. Always true where the system or the disk knows no such locks."""
        try:
            import fcntl  # not on Windows

            fcntl.lockf(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except (ImportError, OSError):
            return True
        return True

    def close(self) -> None:
        if self.file >= 0:
            os.close(self.file)
        self.file = -1

    __del__ = close


def _replace(target: Path, write: Callable[[BinaryIO], object]) -> None:
    """A file that appears complete or not at all."""
    temporary = target.with_name(f"{_PREFIX}{os.getpid()}-{target.name}")
    try:
        with temporary.open("wb") as file:
            write(file)
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)
