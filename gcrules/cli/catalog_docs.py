"""`gcrules catalog docs`: write the catalog's pages, or tell whether they are stale."""

from __future__ import annotations

import click

from gcrules.catalog_file import load
from gcrules.cli.base import Output, catalog_option
from gcrules.cli.files import working
from gcrules.cli.limits import time_limit
from gcrules.cli.page_files import renew
from gcrules.cli.rules import plugins_option
from gcrules.plugins import load_rules

__all__ = ["docs"]


@click.command()
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a page is stale.")
@click.option("--out", default="docs/catalog", show_default=True, metavar="DIR", help="The folder of the pages.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@time_limit(None)
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
    from gcrules.render.catalog_pages import FIGURES, HEAD, bibliography, catalog_pages

    strategy = load_rules(folders=folders, identities=bool(folders)).strategy()
    loaded = load(catalogs, (r.id for r in strategy.incidences))
    with working("computing the pages"):
        pages = catalog_pages(loaded, bibliography(), catalogs, strategy)
    done = renew(pages, out, head=HEAD, figures=FIGURES, command="gcrules catalog docs", check=check)
    Output(json=as_json).show(done)
    ctx.exit(1 if check and done.stale else 0)
