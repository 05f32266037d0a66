"""The studio's token: made once, kept in a file that only the user can read, the same after a restart."""

from __future__ import annotations

import os
import re
import secrets
import stat
import sys
from pathlib import Path

from gcrules.core.errors import FileError

__all__ = ["state_folder", "token"]

_TOKEN = re.compile(r"[\w-]{43}")
_NAME = "studio-token"


def state_folder() -> Path:
    """Where the user's programs keep what they remember."""
    home = Path.home()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local") / "gcrules"
    given = os.environ.get("XDG_STATE_HOME", "")
    return (Path(given) if os.path.isabs(given) else home / ".local" / "state") / "gcrules"


def token(folder: Path | None = None) -> str:
    """The token of this user, 256 random bits; a file that others can read, or that holds no token, is made anew.

    Raises FileError where it cannot be kept.
    """
    folder = folder or state_folder()
    path = folder / _NAME
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        for _ in range(3):
            found = _kept(path)
            if found is not None:
                return found
            _make(path)
    except OSError as fault:
        raise FileError(
            f"the studio's token cannot be kept here: {fault.strerror or fault}",
            filename=str(path),
            hint="set XDG_STATE_HOME to a folder of your own",
        ) from None
    raise FileError("the studio's token keeps being replaced by someone else", filename=str(path))


def _kept(path: Path) -> str | None:
    """The token of the file, if the file is the user's alone."""
    try:
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    except (FileNotFoundError, PermissionError):
        return None
    except OSError:  # a symbolic link
        return None
    with os.fdopen(handle, encoding="ascii", errors="replace") as file:
        about = os.fstat(file.fileno())
        own = sys.platform == "win32" or (about.st_uid == os.getuid() and not about.st_mode & 0o077)
        text = file.read(100).strip() if own and stat.S_ISREG(about.st_mode) else ""
    return text if _TOKEN.fullmatch(text) else None


def _make(path: Path) -> None:
    """Write a new token beside the file and put it in its place at once: whoever comes second finds the first one's."""
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
    handle = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        with os.fdopen(handle, "w", encoding="ascii") as file:
            file.write(secrets.token_urlsafe(32) + "\n")
        try:
            os.link(temporary, path)
        except OSError:  # there is one, or links are not known here
            if _kept(path) is None:
                os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
