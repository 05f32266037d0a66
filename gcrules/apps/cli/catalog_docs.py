"""`gcrules catalog docs`: write the catalog's pages, or tell whether they are stale."""

from __future__ import annotations

import shlex
from collections.abc import Iterable

import click

from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.only import check_known, only_option, only_words
from gcrules.apps.cli.options import catalog_option
from gcrules.apps.cli.output import Output, json_option
from gcrules.apps.cli.page_files import renew
from gcrules.apps.cli.rule_options import plugins_option
from gcrules.conditions.catalog_check import false_identities
from gcrules.core.budget import report
from gcrules.core.errors import FileError, GcrulesError, join_faults
from gcrules.rules.catalog.entries import SHIPPED, Entry
from gcrules.rules.catalog.file import load
from gcrules.rules.plugin import packs
from gcrules.rules.plugins import load_rules
from gcrules.views.pages.catalog_pages import FIGURES, HEAD, bibliography, catalog_pages

__all__ = ["docs"]

OUT = "docs/catalog"


@click.command()
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a page is stale.")
@only_option("class")
@click.option("--out", default=OUT, show_default=True, metavar="DIR", help="The folder of the pages.")
@json_option
@time_limit(None)
@catalog_option
@plugins_option
@click.pass_context
def docs(
    ctx: click.Context,
    check: bool,
    only: tuple[str, ...],
    out: str,
    as_json: bool,
    catalogs: tuple[str, ...],
    folders: tuple[str, ...],
) -> None:
    """Write a page for each class of the catalog, with figures, and an index.

    \b
    gcrules catalog docs
    gcrules catalog docs --check
    gcrules catalog docs --only 6-5 --only 6-4.1
    gcrules catalog docs --out build/catalog --catalog mine.yaml
    """
    strategy = load_rules(folders=folders, identities=bool(folders)).strategy()
    loaded = load(catalogs, (r.id for r in strategy.incidences), packs(folders, "catalogs"))
    check_known(only, [e.id for e in loaded.entries], "class", "gcrules catalog list")
    own = [*(("catalog", path) for path in catalogs), *(("plugins", folder) for folder in folders)]
    options = "".join(f" --{word} {shlex.quote(path)}" for word, path in own)
    with working("proving the entries"):
        _prove((e for e in loaded.entries if not only or e.id in only), options)
    with working("computing the pages"):
        pages = catalog_pages(loaded, bibliography(), catalogs, strategy, folders, only)
    command = f"gcrules catalog docs{only_words(only)}{options}" + (f" --out {shlex.quote(out)}" if out != OUT else "")
    done = renew(pages, out, head=HEAD, figures=FIGURES, command=command, check=check, complete=not only)
    Output(json=as_json).show(done)
    ctx.exit(1 if check and done.stale else 0)


def _prove(entries: Iterable[Entry], options: str) -> None:
    """Prove what the user's own classes say, before the pages are computed.

    Raises FileError with all that is false; what is shipped is proved by its tests.
    """
    faults: list[GcrulesError] = []
    for entry in entries:
        if entry.owner != SHIPPED:
            report(entry.id)
            hint = f"`gcrules catalog check{options}` checks all that it says"
            faults += (FileError(words, filename=entry.place, hint=hint) for words in false_identities(entry))
    if faults:
        raise join_faults(faults)
