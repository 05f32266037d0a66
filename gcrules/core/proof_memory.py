r"""What was proved once, remembered between runs by a digest, so that a proof costs once.

A proof is remembered for the engine that found it: the digest is of what was proved and of the sources of the algebra.
The memory is a folder of the user's own, one small file for each proof, and as much to be trusted as the installation
itself: who can write there can write into gcrules too. `GCRULES_CACHE` names another folder; "off" does without.
"""

from __future__ import annotations

import os
from functools import cache
from hashlib import sha256
from pathlib import Path

from gcrules.core.errors import FileError
from gcrules.core.files import write_file
from gcrules.core.version import __version__

__all__ = ["digest_of", "engine", "folder", "remember", "remembered"]

_OFF = ("", "off", "0", "no")
_LINE = "proved by gcrules\n"


def digest_of(*parts: str) -> str:
    """A digest (SHA-256) of texts, in order."""
    found = sha256()
    for part in parts:
        data = part.encode(errors="replace")
        found.update(f"{len(data)}:".encode() + data)
    return found.hexdigest()


def folder() -> Path | None:
    """Where proofs are remembered: $GCRULES_CACHE, $XDG_CACHE_HOME/gcrules or ~/.cache/gcrules; None for nowhere."""
    chosen = os.environ.get("GCRULES_CACHE")
    if chosen is not None:
        return None if chosen.strip().lower() in _OFF else Path(chosen)
    base = os.environ.get("XDG_CACHE_HOME")
    try:
        return (Path(base) if base else Path.home() / ".cache") / "gcrules"
    except RuntimeError:  # no home
        return None


@cache
def engine() -> str | None:
    """The digest of the version and of the sources on which a proof rests; None where these cannot be read."""
    root = Path(__file__).parent.parent
    try:
        sources = [*sorted((root / "algebra").glob("*.py")), root / "grammar.lark"]
        texts = [p.name + "\n" + p.read_text(encoding="utf-8") for p in sources]
        return digest_of(__version__, *texts)
    except OSError:
        return None


def remembered(digest: str) -> bool:
    """Whether this engine has proved it before. A file that is no memory of this proof counts for nothing."""
    path = _path(digest)
    if path is None:
        return False
    try:
        return path.read_text(encoding="utf-8") == _text(path)
    except (OSError, ValueError):
        return False


def remember(digest: str) -> None:
    """Remember a proof, if there is a place for it; the next run may read it or prove again."""
    path = _path(digest)
    if path is None:
        return
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_file(str(path), _text(path))
    except (OSError, FileError):
        return


def _path(digest: str) -> Path | None:
    place, own = folder(), engine()
    return place / "proofs" / digest_of(digest, own) if place is not None and own is not None else None


def _text(path: Path) -> str:
    return _LINE + path.name + "\n"
