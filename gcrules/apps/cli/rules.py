"""The commands about rules: list, show, check."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import click

from gcrules.apps.cli.base import LazyGroup
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import completing
from gcrules.apps.cli.output import IDS, Output, output_options
from gcrules.apps.cli.rule_options import Choice, plugins_option
from gcrules.rules.check import check_rules
from gcrules.rules.rule import Rule

__all__ = ["check", "list_rules", "rules", "show"]


@click.group(
    cls=LazyGroup,
    table={
        "list": ("gcrules.apps.cli.rules:list_rules", "List the rules of the engine, of plugins and of files."),
        "show": ("gcrules.apps.cli.rules:show", "Show one rule: sentence, source, cases, and who brought it."),
        "check": ("gcrules.apps.cli.rules:check", "Prove the rules of a file, the rules named, or all that are known."),
    },
)
def rules() -> None:
    """List, show and check the rules that rewrite expressions and recognise incidences.

    \b
    gcrules rules list
    gcrules rules show four-planes
    gcrules rules check mine.gca
    """


_files = click.option("--rules", "words", multiple=True, metavar="FILE", help="Add the rules of a .gca file.")


@click.command(name="list")
@_files
@plugins_option
@time_limit()
@output_options(latex=False, brief=IDS, full="Show each rule as `rules show` does.")
def list_rules(words: tuple[str, ...], folders: tuple[str, ...], out: Output) -> None:
    """List the rules in the order in which a strategy runs them.

    \b
    gcrules rules list
    gcrules rules list --rules mine.gca --json
    """
    library = Choice(words, folders=folders).library
    if out.json:
        out.write(json.dumps([_json(r) for r in library], indent=2))
        return
    if out.brief:
        out.write("\n".join(r.id for r in library))
        return
    if out.full:
        out.write("\n\n".join("\n".join(_shown(r)) for r in library))
        return
    width = max(len(r.id) for r in library)
    lines: list[str] = []
    for family in dict.fromkeys(r.family for r in library):
        lines += ["", click.style(f"{family}", bold=True)]
        for r in library:
            if r.family == family:
                owner = "" if r.owner == "gcrules" else f"  ({r.owner})"
                lines.append(f"  {r.id:<{width}}  {r.sentence}{owner}")
    out.write("\n".join(lines[1:]))


@click.command()
@click.argument("rule_id", metavar="ID", shell_complete=completing("rule"))
@_files
@plugins_option
@time_limit()
@output_options(latex=False)
def show(rule_id: str, words: tuple[str, ...], folders: tuple[str, ...], out: Output) -> None:
    """Show one rule.

    \b
    gcrules rules show four-planes
    """
    rule = Choice(words, folders=folders).library[rule_id]
    if out.json:
        out.write(json.dumps(_json(rule), indent=2))
        return
    out.write(rule.sentence if out.brief else "\n".join(_shown(rule)))


def _shown(rule: Rule) -> Iterator[str]:
    """What is known of a rule, name by name."""
    for key, value in _json(rule).items():
        values = value if isinstance(value, list) else [value] * (value not in (None, ""))
        yield from (f"{'' if i else key:<10} {v}" for i, v in enumerate(values))


@click.command()
@click.argument("words", nargs=-1, metavar="[FILE.gca|ID]...", shell_complete=completing("rule"))
@plugins_option
@time_limit(None)
@output_options(latex=False)
@click.pass_context
def check(ctx: click.Context, words: tuple[str, ...], folders: tuple[str, ...], out: Output) -> None:
    """Prove every rule of a file, or the rules named, and try their cases; by default all rules of the engine and of
    plugins.

    \b
    gcrules rules check mine.gca
    gcrules rules check four-planes
    gcrules rules check

    Exit code 0: all hold. 1: a rule is no identity, loops, or a case fails; exact points that refute it are shown.
    """
    with working("proving"):
        chosen = Choice(words)
        found = list(check_rules(chosen.files, folders, chosen.ids))
    if out.json:
        out.write(json.dumps({"ok": all(f.ok for f in found), "rules": [f.to_json() for f in found]}, indent=2))
    else:
        for f in found:
            if f.fault is not None:
                click.echo(f.fault.render(), err=True)
        width = max((len(f.rule.id) for f in found), default=0)
        wrong = sum(not f.ok for f in found)
        shown = [f for f in found if not (out.brief and f.ok)]
        lines = [f"{'ok   ' if f.ok else 'wrong'} {f.rule.id:<{width}}  {f.reason}" for f in shown]
        count = "1 rule" if len(found) == 1 else f"{len(found)} rules"
        out.write("\n".join([*lines, f"{count}: {len(found) - wrong} hold, {wrong} wrong"]))
    if any(f.verdict == "undecided" for f in found):
        ctx.exit(3)
    ctx.exit(0 if all(f.ok for f in found) else 1)


def _json(rule: Rule) -> dict[str, Any]:
    return {
        "id": rule.id,
        "family": rule.family,
        "sentence": rule.sentence,
        "rule": getattr(rule, "text", None),
        "source": rule.source,
        "fires": list(rule.fires),
        "silent": list(rule.silent),
        "group": getattr(rule, "group", None),
        "owner": rule.owner,
    }
