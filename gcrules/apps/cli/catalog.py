"""`gcrules catalog`: list, show, check, enumerate."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from gcrules.algebra.certificate import Certificate
from gcrules.algebra.language.legs_text import Leg, Structure, legs_text
from gcrules.apps.cli.base import LazyGroup
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import completing
from gcrules.apps.cli.options import catalog_option
from gcrules.apps.cli.output import IDS, Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.apps.cli.rule_options import plugins_option
from gcrules.conditions.analysis import analyze
from gcrules.core.budget import report
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.rules.catalog.catalog import Catalog, Match
from gcrules.rules.catalog.entries import SHIPPED, CatalogIdentity, Entry
from gcrules.rules.catalog.file import load
from gcrules.rules.catalog.proof_status import is_shipped
from gcrules.rules.condition import Condition
from gcrules.rules.plugin import packs
from gcrules.rules.plugins import load_rules
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.sentences import sentence
from gcrules.rules.statement import Statement
from gcrules.views.pages.catalog_index import degrees_text

if TYPE_CHECKING:
    from gcrules.conditions.catalog_check import CheckResult

__all__ = ["catalog", "check", "enumerate_", "list_", "show"]

check_digests = deferred("gcrules.conditions.catalog_check:check_digests")
check_entry = deferred("gcrules.conditions.catalog_check:check_entry")
write_digests = deferred("gcrules.conditions.catalog_check:write_digests")
enumerate_classes = deferred("gcrules.conditions.catalog_check:enumerate_classes")
draft = deferred("gcrules.conditions.catalog_draft:draft")

COMMANDS = {
    "list": ("gcrules.apps.cli.catalog:list_", "List the classes."),
    "show": ("gcrules.apps.cli.catalog:show", "Show what is known about a class."),
    "check": ("gcrules.apps.cli.catalog:check", "Prove everything the catalog says from scratch."),
    "docs": ("gcrules.apps.cli.catalog_docs:docs", "Write the catalog's pages, or check that they are up to date."),
    "enumerate": ("gcrules.apps.cli.catalog:enumerate_", "Derive the classes: all graphs of six legs."),
}


@click.group(cls=LazyGroup, table=COMMANDS)
def catalog() -> None:
    """The classes of six-legged platforms and their singularity conditions."""


@click.command("list")
@catalog_option
@plugins_option
@time_limit()
@output_options(latex=False, brief=IDS, full="Show each class as `catalog show` does.")
def list_(catalogs: tuple[str, ...], folders: tuple[str, ...], out: Output) -> None:
    """List the classes: legs, fewest terms of the 24- and 16-term forms, group of entities, condition.

    \b
    gcrules catalog list
    gcrules catalog list --json
    """
    classes = tuple(map(_Class, _loaded(catalogs, folders).entries))
    whole = "\n\n".join(c.text(unicode=out.unicode) for c in classes) if out.full and not out.json else None
    out.show(_List(classes), whole, brief="\n".join(c.entry.id for c in classes))


def _loaded(catalogs: tuple[str, ...], folders: tuple[str, ...]) -> Catalog:
    """The catalog with those of plugins and the user's files; rules of plugins may bring kinds of condition."""
    rules = load_rules(folders=folders, identities=bool(folders)).strategy()
    return load(catalogs, (r.id for r in rules.incidences), packs(folders, "catalogs"))


@click.command()
@click.argument("class_id", metavar="ID", shell_complete=completing("class"))
@catalog_option
@plugins_option
@time_limit()
@output_options(latex=False)
def show(class_id: str, catalogs: tuple[str, ...], folders: tuple[str, ...], out: Output) -> None:
    """Show what is known about a class, in the class's own labels.

    \b
    gcrules catalog show 6-3.2
    """
    found = _Class(_entry(_loaded(catalogs, folders), class_id))
    out.show(found, brief=found.brief(unicode=out.unicode) if out.brief else None)


@click.command()
@catalog_option
@plugins_option
@click.option("--write", is_flag=True, help="Write the digests of what is shipped, once all of it is proved.")
@time_limit(None)
@proof_options
@output_options(latex=False)
@click.pass_context
def check(
    ctx: click.Context,
    catalogs: tuple[str, ...],
    folders: tuple[str, ...],
    write: bool,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Prove every identity from scratch and compute every number again. Exit code 1 if anything is wrong.

    Of the shipped catalog the digests are compared too, by which an analysis knows what was proved here.

    \b
    gcrules catalog check
    gcrules catalog check --catalog mine.yaml
    """
    loaded = _loaded(catalogs, folders)
    checked = []
    with working("checking"):
        for i, entry in enumerate(loaded.entries, 1):
            report(f"{entry.id}, {i} of {len(loaded.entries)}")
            checked.append(check_entry(entry))
    if write and all(c.ok for c in checked):
        write_digests(load())
    checked += check_digests(load())
    answer = _Checked(tuple(checked))
    out.show(answer, brief="\n".join([*answer.lines(faulty=True), answer.total]))
    proofs.write(loaded, "refuted" if answer.faults else "proved")
    ctx.exit(1 if answer.faults else 0)


@click.command("enumerate")
@catalog_option
@plugins_option
@time_limit(None)
@click.option("--yaml", "as_yaml", is_flag=True, help="Write entries for a catalog, with all that can be computed.")
@output_options(latex=False)
def enumerate_(catalogs: tuple[str, ...], folders: tuple[str, ...], as_yaml: bool, out: Output) -> None:
    """Derive all classes from nothing: bipartite graphs of six legs, no two alike, at most three at a joint.

    \b
    gcrules catalog enumerate
    gcrules catalog enumerate --yaml > draft.yaml
    """
    loaded = _loaded(catalogs, folders)
    with working("enumerating"):
        found = tuple((legs, loaded.match(Structure(legs))) for legs in enumerate_classes())
        if as_yaml:
            entries = [
                draft(m.entry.id, m.entry.legs) if m else draft(f"new-{i}", legs) for i, (legs, m) in enumerate(found)
            ]
            out.write("\n".join(["classes:", *entries]))
            return
    answer = _Enumeration(found)
    out.show(answer, brief=answer.total)


def _entry(loaded: Catalog, class_id: str) -> Entry:
    try:
        return loaded[class_id]
    except KeyError:
        hint = near(class_id, [e.id for e in loaded.entries]) or "`gcrules catalog list` lists the classes"
        raise InputError(f"there is no class {class_id!r}", hint=hint) from None


# --- answers -------------------------------------------------------------------------------------------------------

_STATED = Certificate("none", "as the catalog says")


@dataclass(frozen=True)
class _Class:
    """An entry in its own labels, every identity with its sentence."""

    entry: Entry

    def conditions(self) -> tuple[Condition, ...]:
        """The condition and the other readings with their sentences."""
        return tuple(
            Condition(
                r.kind,
                r.expression,
                _meaning(self.entry, r),
                _STATED,
                r.cofactor,
                r.coefficient,
                statement_source="" if is_shipped(self.entry, r) else f"{self.entry.owner}, class {self.entry.id}",
            )
            for r in (self.entry.condition, *self.entry.readings)
        )

    def to_json(self) -> dict[str, Any]:
        """The entry; its legs are pairs and every statement is spelt out."""
        found = self.entry.to_json()
        for reading, c in zip((found["condition"], *found["readings"]), self.conditions(), strict=True):
            reading |= c.wording()
        return found

    def text(self, *, unicode: bool = False) -> str:
        e = self.entry
        lines = [
            f"class      {e.title}",
            f"legs       {legs_text(e.legs)}",
            f"degrees    {degrees_text(e, 'base {}; platform {}')}",
            f"terms      {', '.join(f'{n} in the {form}-term form' for form, n in e.terms.items())}",
            f"factors    {' '.join('[' + ''.join(f) + ']' for f in e.factors) or 'none'}",
            f"group      {e.group or 'none'}",
            f"status     {e.status}",
            f"sources    {', '.join(e.sources) or ('derived here' if e.owner == SHIPPED else 'none given')}",
        ]
        for i, c in enumerate(self.conditions()):
            shown = c.text(unicode=unicode).rstrip().replace("\n", f"\n{' ':11}")
            lines.append(f"{'reading' if i else 'condition':<11}{shown}")
        if e.note:
            lines.append(f"note       {e.note}")
        lines += [f"proof      {words}" for words in self.unproved()]
        return "\n".join(lines)

    def unproved(self) -> Iterator[str]:
        """That what others say is not proved here."""
        if self.entry.owner != SHIPPED:
            yield f"none: this is what {self.entry.owner} says; `gcrules catalog check` proves or refutes it"

    def brief(self, *, unicode: bool = False) -> str:
        """The condition alone."""
        return "\n".join(
            [self.conditions()[0].text(unicode=unicode).rstrip(), *(f"proof: {words}" for words in self.unproved())]
        )


def _meaning(entry: Entry, reading: CatalogIdentity) -> Statement:
    """What it says; a statement that is left to its kind is filled in by the analysis."""
    if reading.statement is not None:
        return reading.meaning
    a = analyze(entry.structure)
    found = next((c.meaning for c in (a.condition, *a.readings) if c.kind == reading.kind), None)
    return found or sentence(reading.expression, entry.structure, RandomWitness(entry.structure), reading.cofactor)


@dataclass(frozen=True)
class _List:
    classes: tuple[_Class, ...]

    def to_json(self) -> dict[str, Any]:
        return {"classes": [c.to_json() for c in self.classes]}

    def text(self, *, unicode: bool = False) -> str:
        rows = [("class", "legs", "24", "16", "group", "condition"), *(_row(c.entry) for c in self.classes)]
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        return "\n".join("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)


def _row(e: Entry) -> tuple[str, ...]:
    terms = (str(e.terms.get(form, "")) for form in (24, 16))
    return (e.id, legs_text(e.legs), *terms, e.group or "-", e.condition.kind)


@dataclass(frozen=True)
class _Checked:
    classes: tuple[CheckResult, ...]

    @property
    def faults(self) -> int:
        """How many classes have faults."""
        return sum(not c.ok for c in self.classes)

    def to_json(self) -> dict[str, Any]:
        return {"verdict": "refuted" if self.faults else "proved", "classes": [c.to_json() for c in self.classes]}

    @property
    def total(self) -> str:
        """How many, in words."""
        proved = sum(c.proved for c in self.classes)
        return f"{len(self.classes)} classes, {proved} identities proved, {self.faults} with faults"

    def text(self, *, unicode: bool = False) -> str:
        return "\n".join([*self.lines(), self.total])

    def lines(self, *, faulty: bool = False) -> Iterator[str]:
        """What was found of each class, or of those that are `faulty` alone."""
        for c in self.classes:
            if faulty and c.ok:
                continue
            verdict = click.style("ok", fg="green") if c.ok else click.style("wrong", fg="red", bold=True)
            done = f"{c.proved} {'identity' if c.proved == 1 else 'identities'} proved" if c.ok or c.proved else ""
            yield f"{c.id:<6}  {verdict}  {done}".rstrip()
            yield from (f"        {c.place}: {fault}" for fault in c.faults)


@dataclass(frozen=True)
class _Enumeration:
    """All classes, with the entry of the catalog for each."""

    found: tuple[tuple[tuple[Leg, ...], Match | None], ...]

    def to_json(self) -> dict[str, Any]:
        classes = [{"legs": [list(g) for g in legs], "class": m.entry.id if m else None} for legs, m in self.found]
        return {"count": len(self.found), "classes": classes}

    def text(self, *, unicode: bool = False) -> str:
        lines = [f"{m.entry.id if m else 'not in the catalog':<6}  {legs_text(legs)}" for legs, m in self.found]
        return "\n".join([*lines, self.total])

    @property
    def total(self) -> str:
        """How many, in words."""
        known = sum(m is not None for _, m in self.found)
        return f"{len(self.found)} classes, {known} of them in the catalog"
