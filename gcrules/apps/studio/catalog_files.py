r"""Catalogs of the user's own that a page has opened: read, each class proved, and what of them is used.

A class whose identity is wrong is left out; one whose identity is not proved takes part, and its answers say so.

>>> text = '''classes:
...   - id: mine
...     legs: ab af cb cd ed ef
...     condition: {kind: four-planes, expression: ace /\\ abf /\\ cbd /\\ edf}
... '''
>>> (read,) = catalogs_read([{"name": "mine.yaml", "text": text, "off": []}])
>>> [(c.entry.id, c.verdict, c.used) for c in read.checks]
[('mine', 'proved', True)]
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Literal

from gcrules.algebra.language.legs_text import legs_text
from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.protocol.requests import RuleFile
from gcrules.apps.studio.protocol.rule_views import CheckedRule, CheckedRuleFile
from gcrules.core.budget import checkpoint, stage, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, InputError, LimitReached
from gcrules.core.seeds import remembered
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load, read_text
from gcrules.rules.catalog.proof_status import proof_status

__all__ = ["CLASS", "CatalogRead", "ClassCheck", "catalog_view", "catalogs_read", "is_catalog", "used_catalogs"]

_SECONDS = 20.0
"""For one class: what takes longer is not decided here."""
CLASS = ", class "
"""Between the name of a catalog and the id of its class, where an analysis names what it takes from one."""
_ENDINGS = (".yaml", ".yml")

Verdict = Literal["proved", "refuted", "undecided", "refused"]


@dataclass(frozen=True)
class ClassCheck:
    """A class of a catalog, and what is known of its identities; `fault` says why it is not used."""

    entry: Entry
    verdict: Verdict
    reason: str
    fault: GcrulesError | None = None

    @property
    def used(self) -> bool:
        return self.fault is None

    @property
    def claim(self) -> str:
        """What analyses call it where they take its words."""
        return f"{self.entry.owner}{CLASS}{self.entry.id}"

    @property
    def line(self) -> int:
        """Where it stands in its file."""
        return int(self.entry.place.removeprefix(f"{self.entry.owner}:").partition(":")[0])


@dataclass(frozen=True)
class CatalogRead:
    """A catalog with the checks of its classes, or the fault that keeps it from being read."""

    catalog: Catalog | None
    checks: tuple[ClassCheck, ...] = ()
    fault: GcrulesError | None = None


def is_catalog(file: RuleFile) -> bool:
    """Whether a file is a catalog and none of rules, by its name."""
    return file["name"].lower().endswith(_ENDINGS)


def used_catalogs(files: Iterable[RuleFile]) -> tuple[Catalog, ...]:
    """The classes of the catalogs among these files that are used: none that are wrong, and none that are off."""
    own = [file for file in files if is_catalog(file)]
    found = []
    for file, read in zip(own, catalogs_read(own), strict=True):
        used = tuple(check.entry for check in read.checks if check.used and check.entry.id not in file["off"])
        if read.catalog is not None and used:
            found.append(replace(read.catalog, entries=used))
    return tuple(found)


def catalogs_read(files: Sequence[RuleFile]) -> list[CatalogRead]:
    """Catalogs one after the other; ids that one before has taken, or the shipped one, are faults."""
    known = {entry.id: entry.owner for entry in load().entries}
    found = []
    for file in files:
        with stage(f"classes of {file['name']}"):
            read = _read(file["name"], file["text"])
        checks = tuple(_clashing(check, known) for check in read.checks)
        known |= {c.entry.id: c.entry.owner for c in checks if c.used and c.entry.id not in file["off"]}
        found.append(CatalogRead(read.catalog, checks, read.fault))
    return found


def _clashing(check: ClassCheck, known: dict[str, str]) -> ClassCheck:
    entry = check.entry
    if not check.used or entry.id not in known:
        return check
    words = f"two classes are called {entry.id}: one of {known[entry.id]}, one of {entry.owner}"
    return ClassCheck(entry, "refused", "", InputError(words, hint="rename one of them, or open only one"))


def _is_decided(read: CatalogRead) -> bool:
    return not any(isinstance(check.fault, LimitReached) for check in read.checks)


@remembered(32, keep=_is_decided)
def _read(name: str, text: str) -> CatalogRead:
    """The catalog with its checks."""
    try:
        catalog = read_text(text, name)
    except GcrulesError as fault:
        return CatalogRead(None, fault=fault)
    if not catalog.entries:
        hint = "classes are a list under `classes:`, each with id, legs and condition"
        return CatalogRead(catalog, fault=InputError("the catalog holds no classes", hint=hint))
    return CatalogRead(catalog, tuple(_checks(catalog)))


def _checks(catalog: Catalog) -> Iterator[ClassCheck]:
    for number, entry in enumerate(catalog.entries, 1):
        with stage(f"{number} of {len(catalog.entries)}, {entry.id}"):
            yield _check(entry)


def _check(entry: Entry) -> ClassCheck:
    identities = (entry.condition, *entry.readings)
    try:
        with within(_SECONDS):
            stand = [proof_status(entry, one) for one in identities]
    except FileError as fault:  # its hint names the command that tells all, of which the page has the answer
        return ClassCheck(entry, "refuted", "", InputError(fault.message))
    except LimitReached as limited:
        checkpoint()  # it may be that of all together
        return ClassCheck(entry, "undecided", "", LimitReached(f"class {entry.id} is not decided: {limited.message}"))
    open_ = [one.detail for one in stand if one.verdict == "unproved"]
    if open_:
        return ClassCheck(entry, "undecided", f"unproved, and its answers say so: {open_[0]}")
    count = "its identity is" if len(stand) == 1 else f"its {len(stand)} identities are"
    return ClassCheck(entry, "proved", f"{count} proved: both sides have the same normal form")


# --- as the page is told -------------------------------------------------------------------------------------------


def catalog_view(file: RuleFile, read: CatalogRead) -> CheckedRuleFile:
    """What a catalog holds, and what is wrong with it."""
    return {
        "name": file["name"],
        "kind": "catalog",
        "rules": [_class_view(check) for check in read.checks],
        "fault": fault_view(read.fault) if read.fault else None,
    }


def _class_view(check: ClassCheck) -> CheckedRule:
    entry = check.entry
    return {
        "id": entry.id,
        "sentence": f"{entry.name or 'the legs'}: {legs_text(entry.legs)}",
        "text": entry.condition.expression_text,
        "line": check.line,
        "verdict": check.verdict,
        "reason": check.reason,
        "fault": fault_view(check.fault) if check.fault else None,
    }
