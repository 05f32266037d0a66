"""The folder in which inputs run: what they may write, and what they left behind.

The names of files are drawn at random, so nothing may be written anywhere else: an audit hook refuses it.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

__all__ = ["Jail", "jailed"]

_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_PATHS = {"os.mkdir": 1, "os.rename": 2, "os.remove": 1, "os.rmdir": 1, "os.symlink": 2, "os.link": 2, "os.truncate": 1}
_PROGRAMS = ("subprocess.Popen", "os.system", "os.posix_spawn", "os.exec", "webbrowser.open", "socket.bind")


class _Hook:
    """One for the process: audit hooks cannot be taken away."""

    installed = False
    within: str | None = None
    refused: tuple[str, ...] = ()

    def __call__(self, event: str, args: Any) -> None:
        if self.within is None:
            return
        if event == "open":
            path, mode, flags = args
            if (flags & _WRITING if isinstance(flags, int) else any(c in (mode or "r") for c in "wxa+")) and not (
                isinstance(path, int)
            ):
                self._look(event, path)
        elif event in _PATHS:
            for path in args[: _PATHS[event]]:
                self._look(event, path)
        elif event in _PROGRAMS:
            self._refuse(f"{event} {str(args)[:80]}")

    def _look(self, event: str, path: Any) -> None:
        full = os.path.abspath(os.fsdecode(path))
        if self.within and not full.startswith(self.within) and not full.startswith("/dev/"):
            self._refuse(f"{event} {full}")

    def _refuse(self, what: str) -> None:
        self.refused = (*self.refused, what)
        raise PermissionError(13, "Permission denied")


_HOOK = _Hook()


class Jail:
    """`here` is the working folder of inputs, empty before each; beside it stands a home."""

    def __init__(self, base: str) -> None:
        self.base = os.path.realpath(base)
        self.here = os.path.join(self.base, "here")
        self.home = os.path.join(self.base, "home")
        for folder in (self.here, self.home):
            os.makedirs(folder, exist_ok=True)
        self.before: dict[str, bytes | None] = {}

    def fill(self, files: Mapping[str, str]) -> None:
        """Empty the folder and put the files of an input there."""
        self._empty()
        for name, text in files.items():
            path = os.path.join(self.here, name)
            if os.path.dirname(name):
                os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(text.encode("utf-8", "surrogateescape"))
        self.before = dict(self._contents())

    def changes(self) -> list[str]:
        """Names of files that were made, changed or taken away since `fill`."""
        now = dict(self._contents())
        return sorted(n for n in now.keys() | self.before.keys() if now.get(n, b"-") != self.before.get(n, b"-"))

    def _contents(self) -> Iterator[tuple[str, bytes | None]]:
        folders = [""]
        while folders:
            folder = folders.pop()
            with os.scandir(os.path.join(self.here, folder)) as entries:
                for entry in entries:
                    name = os.path.join(folder, entry.name)
                    if entry.is_dir(follow_symlinks=False):
                        folders.append(name)
                        yield f"{name}/", None
                    else:
                        with open(entry.path, "rb") as file:
                            yield name, file.read()

    def _empty(self) -> None:
        with os.scandir(self.here) as entries:
            for entry in entries:
                if entry.is_dir(follow_symlinks=False):
                    shutil.rmtree(entry.path)
                else:
                    os.unlink(entry.path)

    @contextmanager
    def closed(self) -> Iterator[list[str]]:
        """Nothing outside is written by what runs inside; what was tried stands in the list afterwards."""
        if not _HOOK.installed:
            _HOOK.installed = True
            sys.addaudithook(_HOOK)
        tried: list[str] = []
        _HOOK.within, _HOOK.refused = self.base + os.sep, ()
        try:
            yield tried
        finally:
            _HOOK.within = None
            tried += _HOOK.refused


@contextmanager
def jailed() -> Iterator[Jail]:
    """A jail in a folder of its own, which is the working folder and the home meanwhile."""
    keys = ("HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR", "XDG_STATE_HOME")
    kept, folder = {k: os.environ.get(k) for k in keys}, os.getcwd()
    with tempfile.TemporaryDirectory(prefix="gcrules-fuzz-") as base:
        jail = Jail(base)
        os.environ.update(dict.fromkeys(keys, jail.home))
        os.chdir(jail.here)
        try:
            yield jail
        finally:
            os.chdir(folder)
            for k, v in kept.items():
                if v is None:
                    os.environ.pop(k, None)
                else:
                    os.environ[k] = v
