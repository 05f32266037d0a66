"""`gcrules catalog`: list, show, check, enumerate."""

from __future__ import annotations

import json
from typing import Any

import click

from gcrules.catalog import Catalog, Entry, load
from gcrules.cli.base import LazyGroup, Output, output_options
from gcrules.cli.files import working
from gcrules.errors import InputError
from gcrules.legs import Structure
from gcrules.yamlfile import near

__all__ = ["catalog", "check", "enumerate_", "list_", "show"]

COMMANDS = {
    "list": ("gcrules.cli.catalog:list_", "List the classes."),
    "show": ("gcrules.cli.catalog:show", "Show what is known about a class."),
    "check": ("gcrules.cli.catalog:check", "Prove everything the catalog says from scratch."),
    "docs": ("gcrules.cli.catalog_docs:docs", "Write the catalog's pages, or check that they are up to date."),
    "enumerate": ("gcrules.cli.catalog:enumerate_", "Derive the classes: all graphs of six legs."),
}

_catalogs = click.option("--catalog", "catalogs", multiple=True, metavar="FILE", help="Add a catalog of your own.")


@click.group(cls=LazyGroup, table=COMMANDS)
def catalog() -> None:
    """The classes of six-legged platforms and their singularity conditions."""


@click.command("list")
@_catalogs
@output_options(latex=False)
def list_(catalogs: tuple[str, ...], out: Output) -> None:
    """List the classes: legs, fewest terms of the 24- and 16-term forms, group of entities, condition.

    \b
    gcrules catalog list
    gcrules catalog list --json
    """
    entries = load(catalogs).entries
    if out.json:
        out.write(json.dumps({"classes": [e.to_json() for e in entries]}, indent=2))
        return
    rows = [("class", "legs", "24", "16", "group", "condition"), *map(_row, entries)]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]
    out.write("\n".join(lines))


@click.command()
@click.argument("class_id", metavar="ID")
@_catalogs
@output_options(latex=False)
def show(class_id: str, catalogs: tuple[str, ...], out: Output) -> None:
    """Show what is known about a class, in the class's own labels.

    \b
    gcrules catalog show 6-3.2
    """
    entry = _entry(load(catalogs), class_id)
    out.write(json.dumps(entry.to_json(), indent=2) if out.json else _described(entry))


@click.command()
@_catalogs
@output_options(latex=False)
@click.pass_context
def check(ctx: click.Context, catalogs: tuple[str, ...], out: Output) -> None:
    """Prove every identity from scratch and compute every number again. Exit code 1 if anything is wrong.

    \b
    gcrules catalog check
    gcrules catalog check --catalog mine.yaml
    """
    from gcrules.catalog_check import check_entry  # slower to load than the other commands need

    loaded = load(catalogs)
    checked = []
    with working("checking") as status:
        for i, entry in enumerate(loaded.entries, 1):
            status.text = f"checking {entry.id}, {i} of {len(loaded.entries)}"
            checked.append(check_entry(entry))
    faults = sum(not c.ok for c in checked)
    proved = sum(c.proved for c in checked)
    if out.json:
        classes = [c.to_json() for c in checked]
        out.write(json.dumps({"verdict": "refuted" if faults else "proved", "classes": classes}, indent=2))
    else:
        lines = []
        for c in checked:
            verdict = click.style("ok", fg="green") if c.ok else click.style("wrong", fg="red", bold=True)
            lines.append(f"{c.id:<6}  {verdict}  {c.proved} {'identity' if c.proved == 1 else 'identities'} proved")
            lines += [f"        {c.place}: {fault}" for fault in c.faults]
        out.write("\n".join([*lines, f"{len(checked)} classes, {proved} identities proved, {faults} with faults"]))
    ctx.exit(1 if faults else 0)


@click.command("enumerate")
@_catalogs
@output_options(latex=False)
def enumerate_(catalogs: tuple[str, ...], out: Output) -> None:
    """Derive all classes from nothing: bipartite graphs of six legs, no two alike, at most three at a joint.

    \b
    gcrules catalog enumerate
    """
    from gcrules.catalog_check import enumerate_classes  # slower to load than the other commands need

    loaded = load(catalogs)
    with working("enumerating"):
        found = [(legs, loaded.match(Structure(legs))) for legs in enumerate_classes()]
    if out.json:
        classes: list[dict[str, Any]] = [
            {"legs": ["".join(leg) for leg in legs], "class": m.entry.id if m else None} for legs, m in found
        ]
        out.write(json.dumps({"count": len(found), "classes": classes}, indent=2))
        return
    lines = [f"{m.entry.id if m else 'not in the catalog':<6}  {_legs(legs)}" for legs, m in found]
    out.write("\n".join([*lines, f"{len(found)} classes"]))


def _legs(legs: tuple[tuple[str, str], ...]) -> str:
    return " ".join("".join(leg) for leg in legs)


def _row(e: Entry) -> tuple[str, ...]:
    terms = (str(e.terms.get(form, "")) for form in (24, 16))
    return (e.id, _legs(e.legs), *terms, e.group or "-", e.condition.kind)


def _entry(loaded: Catalog, class_id: str) -> Entry:
    try:
        return loaded[class_id]
    except KeyError:
        hint = near(class_id, [e.id for e in loaded.entries]) or "`gcrules catalog list` lists the classes"
        raise InputError(f"there is no class {class_id!r}", hint=hint) from None


def _described(e: Entry) -> str:
    lines = [
        f"class      {e.id}" + (f", {e.name}" if e.name else ""),
        f"legs       {_legs(e.legs)}",
        f"degrees    base {_numbers(e.degrees[0])}; platform {_numbers(e.degrees[1])}",
        f"terms      {', '.join(f'{n} in the {form}-term form' for form, n in e.terms.items())}",
        f"factors    {' '.join('[' + ''.join(f) + ']' for f in e.factors) or 'none'}",
        f"group      {e.group or 'none'}",
        f"status     {e.status}",
        f"sources    {', '.join(e.sources)}",
    ]
    for i, reading in enumerate((e.condition, *e.readings)):
        cofactor = "" if reading.cofactor_text == "1" else f"{reading.cofactor_text} * "
        coefficient = {1: "", -1: "-"}.get(reading.coefficient, f"{reading.coefficient} * ")
        right = f"-({reading.expression_text})" if coefficient == "-" else coefficient + reading.expression_text
        lines.append(f"{'reading   ' if i else 'condition '} {reading.kind}: {cofactor}superbracket = {right}")
        if reading.statement:
            lines.append(f"           {reading.statement}")
    return "\n".join([*lines, *([f"note       {e.note}"] if e.note else [])])


def _numbers(values: tuple[int, ...]) -> str:
    return " ".join(map(str, values))
