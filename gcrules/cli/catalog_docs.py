"""`gcrules catalog docs`: write the catalog's pages, or tell whether they are stale."""

from __future__ import annotations

import os
from pathlib import Path

import click

from gcrules.catalog_file import load
from gcrules.cli.base import catalog_option
from gcrules.cli.files import working, write_file
from gcrules.errors import FileError

__all__ = ["docs"]


@click.command()
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a page is stale.")
@click.option("--out", default="docs/catalog", show_default=True, metavar="DIR", help="The folder of the pages.")
@catalog_option
@click.pass_context
def docs(ctx: click.Context, check: bool, out: str, catalogs: tuple[str, ...]) -> None:
    """Write a page for each class of the catalog, with figures, and an index.

    \b
    gcrules catalog docs
    gcrules catalog docs --check
    gcrules catalog docs --out build/catalog --catalog mine.yaml
    """
    from gcrules.render.catalog_pages import bibliography, catalog_pages

    loaded = load(catalogs)
    with working("computing the pages"):
        pages = catalog_pages(loaded, bibliography())
    folder = Path(out)
    if check:
        stale = [f"{name} is {'stale' if (folder / name).exists() else 'missing'}" for name in _stale(folder, pages)]
        stale += [f"{name} is no longer generated" for name in _left_over(folder, pages)]
        click.echo("\n".join([*stale, f"{len(pages)} files, {len(stale)} to be renewed by `gcrules catalog docs`"]))
        ctx.exit(1 if stale else 0)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise FileError(f"cannot be made: {fault.strerror or fault}", filename=out) from None
    written = _stale(folder, pages)
    for name in written:
        write_file(str(folder / name), pages[name])
    gone = _left_over(folder, pages)
    for name in gone:
        os.unlink(folder / name)
    click.echo(f"{len(pages)} files in {out}: {len(written)} written, {len(gone)} removed")


def _stale(folder: Path, pages: dict[str, str]) -> list[str]:
    return [name for name, text in pages.items() if not _same(folder / name, text)]


def _same(path: Path, text: str) -> bool:
    try:
        return path.read_text(encoding="utf-8") == text
    except (OSError, UnicodeDecodeError):
        return False


def _left_over(folder: Path, pages: dict[str, str]) -> list[str]:
    """Pages that an earlier run wrote for classes that are gone, with their figures."""
    from gcrules.render.catalog_pages import HEAD

    gone = []
    for path in sorted(folder.glob("*.md")) if folder.is_dir() else []:
        if path.name not in pages and path.read_text(encoding="utf-8", errors="replace").startswith(HEAD):
            figures = [path.with_name(f"{path.stem}-{kind}.svg") for kind in ("graph", "robot")]
            gone += [p.name for p in (path, *figures) if p.exists()]
    return gone
