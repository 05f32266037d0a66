"""Writing files: which names will do, and how a file appears complete or not at all."""

from __future__ import annotations

import errno
import os
import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import field
from typing import Any

from gcrules.core import budget, interrupts, streams
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError

__all__ = [
    "after_writing",
    "check_name",
    "check_room",
    "check_target",
    "file_name",
    "held",
    "remove_unfinished",
    "replacing",
    "unwritable",
    "write_file",
]

FOLDERS = (".zarr",)
"""Endings of what is a folder of files."""
SUFFIXES = frozenset(
    (
        *(".csv", ".gca", ".glb", ".html", ".json", ".nc", ".pdf", ".ply", ".png", ".svg", ".tex", ".txt"),
        *(".urdf", ".xml", ".yaml", ".yml", *FOLDERS),
    )
)
"""Endings of files that gcrules writes; a name that is nothing else was meant to have more in front."""


# --- names ---------------------------------------------------------------------------------------------------------


def file_name(title: str, ending: str) -> str:
    """A name for a file, made of the letters of a title.

    >>> file_name("Reachy Mini head (6-RUS)", "json.gz")
    'reachy-mini-head-6-rus.json.gz'
    """
    return f"{re.sub(r'[^a-z0-9]+', '-', title.lower()).strip('-')[:60] or 'robot'}.{ending}"


def check_name(path: str) -> None:
    """Raises FileError for what cannot be the name of any file."""
    what = None
    if not path:
        what = "an empty text is not the name of a file"
    elif "\0" in path:
        what = "a name cannot hold the character NUL"
    else:
        try:
            os.fsencode(path)
        except UnicodeEncodeError as fault:
            what = f"a name cannot hold the character U+{ord(path[fault.start]):04X}"
    if what is not None:
        raise FileError(what, filename=ascii(path)[1:-1])


def check_target(path: str) -> None:
    """Raises FileError where no file of this name can be written; "-" is standard output."""
    if path == streams.STDOUT:
        return
    check_name(path)
    name = os.path.basename(path)
    if name.lower() in SUFFIXES:
        raise FileError("this is an ending without a name", filename=path, hint=f"for example figure{name}")
    target = os.path.realpath(path)
    folder_meant = name.lower().endswith(FOLDERS)
    if (os.path.isdir(target) and not folder_meant) or not name:
        raise FileError("this is a directory, expected the name of a file", filename=path)
    folder = os.path.dirname(target)
    try:
        os.lstat(target)
    except FileNotFoundError:
        if not os.path.isdir(folder):
            raise FileError("cannot be written: there is no such directory", filename=path) from None
    except OSError as fault:
        raise unwritable(fault, path) from None
    if folder_meant and os.path.isfile(target):
        raise FileError("this is a file, expected a folder or a new name", filename=path)
    if os.path.exists(target) and not os.access(target, os.W_OK):
        raise FileError("cannot be written: the file is write-protected", filename=path)
    if not _special(target) and not os.access(folder, os.W_OK | os.X_OK):
        raise FileError("cannot be written: the directory is write-protected", filename=path)


def _special(target: str) -> bool:
    """Whether it is a device or a pipe, which is written to and not replaced."""
    return os.path.exists(target) and not os.path.isfile(target)


def unwritable(fault: OSError, path: str, full: str = "free some space, and run the same command again") -> FileError:
    """The fault of a file that cannot be written, with advice where the disk is `full`."""
    hint = full if fault.errno in (errno.ENOSPC, errno.EDQUOT) else None
    return FileError(f"cannot be written: {fault.strerror or fault}", filename=path, hint=hint)


# --- writing -------------------------------------------------------------------------------------------------------


@dataclass
class _Held:
    """Files that wait: what is written to devices, then (temporary file, target, name), then what follows."""

    devices: list[Callable[[], None]] = field(default_factory=list)
    finished: list[tuple[str, str, str]] = field(default_factory=list)
    after: list[Callable[[], None]] = field(default_factory=list)


_held: ContextVar[_Held | None] = ContextVar("gcrules files", default=None)
_unfinished: set[str] = set()  # what this process has begun to write


@contextmanager
def held() -> Iterator[None]:
    """Files that are written within appear when the block ends, and none of them where an exception leaves it."""
    waiting = _Held()
    token = _held.set(waiting)
    try:
        try:
            yield
        finally:
            _held.reset(token)
        for write in waiting.devices:
            write()
        if waiting.finished:
            interrupts.settle()  # either the files appear and the answer is given, or neither
        with interrupts.deferred():
            for one in waiting.finished:
                _put(*one)
    finally:
        for temporary, _, _ in waiting.finished:
            _remove(temporary)
    for step in waiting.after:
        step()


def after_writing(step: Callable[[], None]) -> None:
    """Do it when the files that were written are there: at the end of `held`, else at once."""
    waiting = _held.get()
    if waiting is None:
        step()
    else:
        waiting.after.append(step)


@contextmanager
def replacing(path: str) -> Iterator[str]:
    """The name of a temporary file beside `path` that takes its place when the block ends, or when `held` does.

    Raises FileError where that is not possible; what goes wrong in the block is the caller's.
    """
    check_target(path)
    target = os.path.realpath(path)
    temporary = os.path.join(os.path.dirname(target), f".gcrules-{os.getpid()}-{os.urandom(4).hex()}")
    _unfinished.add(temporary)
    try:
        yield temporary
        waiting = _held.get()
        if waiting is None:
            _put(temporary, target, path)
            _unfinished.discard(temporary)
        else:
            waiting.finished.append((temporary, target, path))
    except BaseException:
        _remove(temporary)
        raise


def write_file(path: str, content: str | bytes, *, at_once: bool = False) -> None:
    """Write a file by way of a temporary one, so that it appears complete or not at all; "-" is standard output.

    With `at_once` it does not wait for the end of `held`. Raises FileError where that is not possible.
    """
    if isinstance(content, str) and streams.is_stdout(path):
        with budget.waiting():
            streams.write(content)
        return
    check_target(path)
    data = content.encode("utf-8", "replace") if isinstance(content, str) else content
    waiting = _held.get()
    if _special(os.path.realpath(path)):
        if waiting is None or at_once:
            _write(path, data, path)
        else:
            waiting.devices.append(lambda: _write(path, data, path))
        return
    token = _held.set(None if at_once else waiting)
    try:
        with replacing(path) as temporary:
            _write(temporary, data, path)
    finally:
        _held.reset(token)


def _write(target: str, data: bytes, path: str) -> None:
    try:
        with budget.waiting(), open(target, "wb") as file:
            file.write(data)
    except OSError as fault:
        raise unwritable(fault, path) from None


def _put(temporary: str, target: str, path: str) -> None:
    try:
        os.replace(temporary, target)
    except OSError as fault:
        raise unwritable(fault, path) from None


def _remove(temporary: str) -> None:
    with interrupts.deferred(), suppress(OSError):
        os.unlink(temporary)
    _unfinished.discard(temporary)


def remove_unfinished() -> None:
    """Remove what was begun and not finished, however the program comes to its end."""
    for temporary in tuple(_unfinished):
        _remove(temporary)


def check_room(path: str, needed: int, hint: str, free: Callable[[str], Any] = shutil.disk_usage) -> None:
    """Raises FileError, with a hint, where the disk has less than `needed` bytes left."""
    folder = os.path.dirname(os.path.abspath(path))
    if os.path.isdir(folder) and (left := free(folder).free) < needed:
        raise FileError(
            f"about {needed / 1e9:.1f} GB are needed, {left / 1e9:.1f} GB are free on this disk",
            filename=path,
            hint=hint,
        )
