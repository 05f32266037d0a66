"""`gcrules catalog docs`: write the catalog's pages, or tell whether they are stale."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from gcrules.catalog_file import load
from gcrules.cli.base import Output, catalog_option
from gcrules.cli.files import working
from gcrules.cli.rules import plugins_option
from gcrules.errors import FileError
from gcrules.files import write_file
from gcrules.plugins import load_rules

__all__ = ["docs"]


@click.command()
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a page is stale.")
@click.option("--out", default="docs/catalog", show_default=True, metavar="DIR", help="The folder of the pages.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@catalog_option
@plugins_option
@click.pass_context
def docs(
    ctx: click.Context, check: bool, out: str, as_json: bool, catalogs: tuple[str, ...], folders: tuple[str, ...]
) -> None:
    """Write a page for each class of the catalog, with figures, and an index.

    \b
    gcrules catalog docs
    gcrules catalog docs --check
    gcrules catalog docs --out build/catalog --catalog mine.yaml
    """
    from gcrules.render.catalog_pages import bibliography, catalog_pages

    strategy = load_rules(folders=folders, identities=False).strategy()
    loaded = load(catalogs, (r.id for r in strategy.incidences))
    with working("computing the pages"):
        pages = catalog_pages(loaded, bibliography(), catalogs, strategy)
    folder = Path(out)
    gone = _left_over(folder, pages)
    stale = {name: "stale" if (folder / name).exists() else "missing" for name in _stale(folder, pages)}
    stale |= dict.fromkeys(gone, "no longer generated")
    if check:
        Output(json=as_json).show(_Summary(out, tuple(pages), stale, done=False))
        ctx.exit(1 if stale else 0)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name in (n for n in pages if n in stale):
            write_file(str(folder / name), pages[name])
        for name in gone:
            os.unlink(folder / name)
    except OSError as fault:
        raise FileError(f"cannot be written: {fault.strerror or fault}", filename=fault.filename or out) from None
    Output(json=as_json).show(_Summary(out, tuple(pages), stale, done=True))


@dataclass(frozen=True)
class _Summary:
    """The files that were generated, and those that were stale; if `done`, these have been written or removed."""

    folder: str
    files: tuple[str, ...]
    stale: dict[str, str]
    done: bool

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
        total = f"{len(self.files)} files, {len(lines)} to be renewed by `gcrules catalog docs`"
        return "\n".join([*lines, total])


def _stale(folder: Path, pages: dict[str, str]) -> list[str]:
    return [name for name, text in pages.items() if _read(folder / name) != text]


def _read(path: Path) -> str | None:
    """The text of a file; None where there is none."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None


def _left_over(folder: Path, pages: dict[str, str]) -> list[str]:
    """Pages that an earlier run wrote for classes that are gone, and figures that their pages no longer have."""
    from gcrules.render.catalog_pages import FIGURES, HEAD

    gone = []
    for path in sorted(folder.glob("*.md")):
        if path.name not in pages and not (_read(path) or "").startswith(HEAD):
            continue
        mine = [path, *(path.with_name(f"{path.stem}-{kind}.svg") for kind in FIGURES)]
        gone += [p.name for p in mine if p.name not in pages and p.is_file()]
    return gone
