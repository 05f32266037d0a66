"""Folders of generated pages: written, or compared with what they would be."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError
from gcrules.core.files import write_file

__all__ = ["PageSummary", "renew"]


@dataclass(frozen=True)
class PageSummary:
    """The files that were generated, and those that were stale; if `done`, these have been written or removed.

    `command` is what renews them.
    """

    folder: str
    files: tuple[str, ...]
    stale: Mapping[str, str]
    done: bool
    command: str

    def to_json(self) -> dict[str, Any]:
        changed = [name for name in self.files if name in self.stale] if self.done else []
        removed = [name for name in self.stale if name not in self.files] if self.done else []
        left = {} if self.done else self.stale
        return {
            "folder": self.folder,
            "files": list(self.files),
            "written": changed,
            "removed": removed,
            "stale": [{"file": name, "state": state} for name, state in left.items()],
        }

    def text(self, *, unicode: bool = False) -> str:
        found = self.to_json()
        if self.done:
            counts = f"{len(found['written'])} written, {len(found['removed'])} removed"
            return f"{len(self.files)} files in {self.folder}: {counts}"
        lines = [f"{name} is {state}" for name, state in self.stale.items()]
        total = f"{len(self.files)} files, {len(lines)} to be renewed by `{self.command}`"
        return "\n".join([*lines, total])


def renew(
    pages: Mapping[str, str],
    out: str,
    *,
    head: str,
    figures: Sequence[str],
    command: str,
    check: bool,
    complete: bool = True,
) -> PageSummary:
    """Write pages and figures (names and contents) into the folder `out`, and remove those of earlier runs; where the
    pages are not `complete`, only figures that these pages no longer have.

    Pages of earlier runs begin with `head`; their figures bear the page's name, a hyphen and one of `figures`. With
    `check` nothing is written. Raises FileError for what cannot be written.
    """
    folder = Path(out)
    gone = _left_over(folder, pages, head if complete else None, figures)
    stale = {name: "stale" if (folder / name).exists() else "missing" for name in _stale(folder, pages)}
    stale |= dict.fromkeys(gone, "no longer generated")
    if not check:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            for name in (n for n in pages if n in stale):
                write_file(str(folder / name), pages[name])
            for name in gone:
                os.unlink(folder / name)
        except OSError as fault:
            raise FileError(f"cannot be written: {fault.strerror or fault}", filename=fault.filename or out) from None
    return PageSummary(out, tuple(pages), stale, not check, command)


def _stale(folder: Path, pages: Mapping[str, str]) -> list[str]:
    return [name for name, text in pages.items() if _read(folder / name) != text]


def _read(path: Path) -> str | None:
    """The text of a file; None where there is none."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None


def _left_over(folder: Path, pages: Mapping[str, str], head: str | None, figures: Sequence[str]) -> list[str]:
    """Pages that an earlier run wrote for what is gone (none of them without `head`), and figures that their pages no
    longer have.
    """
    gone = []
    for path in sorted(folder.glob("*.md")):
        if path.name not in pages and (head is None or not (_read(path) or "").startswith(head)):
            continue
        mine = [path, *(path.with_name(f"{path.stem}-{kind}.svg") for kind in figures)]
        gone += [p.name for p in mine if p.name not in pages and p.is_file()]
    return gone
