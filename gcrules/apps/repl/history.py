"""Where the inputs of earlier sessions are kept: a file that its owner alone can read."""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from pathlib import Path

__all__ = ["history_path", "private_file"]


def history_path(environment: Mapping[str, str], platform: str) -> Path | None:
    """GCRULES_HISTORY (none where it is empty), else a file in the folder for such things on this platform.

    >>> history_path({"XDG_STATE_HOME": "/x"}, "linux").as_posix(), history_path({"GCRULES_HISTORY": ""}, "linux")
    ('/x/gcrules/history', None)
    """
    chosen = environment.get("GCRULES_HISTORY")
    if chosen is not None:
        return Path(chosen).expanduser() if chosen else None
    try:
        home = Path(environment["HOME"]) if environment.get("HOME") else Path.home()
    except RuntimeError:
        return None
    if platform == "win32":
        return Path(environment.get("LOCALAPPDATA") or home / "AppData" / "Local") / "gcrules" / "history"
    state = environment.get("XDG_STATE_HOME", "")
    if platform == "darwin" and not state:
        return home / "Library" / "Application Support" / "gcrules" / "history"
    # A relative path is to be ignored, says the specification of XDG_STATE_HOME.
    return Path(state if os.path.isabs(state) else home / ".local" / "state") / "gcrules" / "history"


def private_file(path: Path) -> bool:
    """Make sure that there is such a file, and that nobody else can read it; False where that is not possible."""
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | getattr(os, "O_NONBLOCK", 0), 0o600)
        try:
            found = os.fstat(handle)
            if not stat.S_ISREG(found.st_mode):
                return False
            if hasattr(os, "fchmod") and found.st_mode & 0o077:
                os.fchmod(handle, 0o600)
        finally:
            os.close(handle)
    except (OSError, ValueError):
        return False
    return True
