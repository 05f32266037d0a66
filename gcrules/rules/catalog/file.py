r"""Catalog files: the shipped one and the user's own. The shipped file's header describes the format."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.resources import files
from os import PathLike, fspath
from pathlib import Path
from string import Formatter
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.language.legs_text import Leg, Structure, read_legs
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.algebra.superbrackets.shortest import counts
from gcrules.core.errors import FileError, GcrulesError, join_faults
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.core.yaml_file import Document, Node
from gcrules.rules.catalog.catalog import FROM_CATALOG, LABELS, Catalog
from gcrules.rules.catalog.entries import SHIPPED, CatalogIdentity, Entry
from gcrules.rules.catalog.proof_status import is_shipped_sentence
from gcrules.rules.condition_rule import INCIDENCES
from gcrules.rules.plugin import Plugin

__all__ = ["KINDS", "STATUSES", "Own", "load", "load_file", "read_text"]


Own = str | PathLike[str] | Catalog
"""A catalog of the user's own: a file, or one that is read already."""


def load(own: Iterable[Own] = (), kinds: Iterable[str] = (), plugins: Iterable[Plugin] = ()) -> Catalog:
    """The shipped catalog with those of plugins and the user's own, in whose files `kinds` of condition that plugins
    bring may stand too; in the catalogs of a plugin those of its own rules anyway.

    Raises FileError for faults and for ids that clash.
    """
    shipped, kinds = _shipped(), tuple(kinds)
    entries, statements = list(shipped.entries), dict(shipped.statements)
    sources = {k: SHIPPED for k, sentence in statements.items() if not is_shipped_sentence(k, sentence)}
    for path, more in (*_brought(plugins, kinds), *(_own(one, kinds) for one in own)):
        clashes = [(e, other) for e in more.entries for other in entries if e.id == other.id]
        if clashes:
            raise join_faults(
                [FileError(f"class {e.id} is also defined in {other.place}", filename=e.place) for e, other in clashes]
            )
        entries = [*entries, *more.entries]
        statements |= more.statements
        sources |= dict.fromkeys(more.statements, fspath(path))
    return Catalog(tuple(entries), FrozenMap(statements), FrozenMap(sources))


def _own(one: Own, kinds: tuple[str, ...]) -> tuple[str | PathLike[str], Catalog]:
    """A catalog of the user's, and what it is called."""
    if isinstance(one, Catalog):
        return next((e.owner for e in one.entries), ""), one
    return one, load_file(one, kinds)


def _brought(plugins: Iterable[Plugin], kinds: tuple[str, ...]) -> Iterator[tuple[str | PathLike[str], Catalog]]:
    """The catalogs of plugins, each file once. Raises FileError that names the plugin."""
    files: set[Path] = set()
    for plugin in plugins:
        for path in plugin.catalogs:
            if (place := Path(path).resolve()) in files:
                continue
            files.add(place)
            try:
                yield path, load_file(path, (*kinds, *plugin.kinds))
            except FileError as fault:
                raise fault.of(plugin.owner) from None


@cache
def _shipped() -> Catalog:
    source = files("gcrules").joinpath("catalog.yaml").read_text(encoding="utf-8")
    return _read(Document.parse(source, SHIPPED), SHIPPED)


def load_file(path: str | PathLike[str], kinds: Iterable[str] = ()) -> Catalog:
    """A catalog file of its own. Raises FileError with line and column of every fault, all at once."""
    return _read(Document.load(path), fspath(path), tuple(kinds))


def read_text(text: str, name: str) -> Catalog:
    """A catalog that is given as text, under a name. Raises FileError as `load_file` does."""
    return _read(Document.parse(text, name), name)


def _read(document: Document, owner: str, kinds: tuple[str, ...] = ()) -> Catalog:
    top = document.root.mapping(required={"classes"}, optional={"statements"})
    statements = {}
    if "statements" in top:
        for key, value in top["statements"].entries():
            statements[key.string() or ""] = value.string() or ""
            if owner != SHIPPED:
                _check_template(key, value)
    entries: list[Entry] = []
    if "classes" in top:
        for node in top["classes"].sequence():
            entry = _Reader(node, owner, kinds).entry()
            if entry and any(e.id == entry.id for e in entries):
                node.fault(f"class {entry.id} is defined here a second time")
            elif entry:
                entries.append(entry)
    document.check()
    return Catalog(tuple(entries), FrozenMap(statements))


def _check_template(key: Node, value: Node) -> None:
    """Record a fault unless a sentence of the user's own fills in no more than the shipped one for its kind."""
    kind, known = key.string() or "", _shipped().statements
    if kind not in known:
        key.fault(f"{kind!r} is not a kind of condition that has a sentence", near(kind, known))
        return
    names = _fields(known[kind])
    try:
        unknown = _fields(value.string() or "") - names
    except ValueError as fault:
        value.fault(f"not a sentence to fill in: {fault}")
        return
    if unknown:
        allowed = ", ".join(sorted(f"{{{n}}}" for n in names)) or "nothing"
        value.fault(f"{{{min(unknown)}}} cannot be filled in here", f"this sentence is filled with {allowed}")


def _fields(template: str) -> set[str]:
    """What stands in braces in a template, as written."""
    found = set()
    for _, name, form, conversion in Formatter().parse(template):
        if name is not None:
            found.add(name + (f"!{conversion}" if conversion else "") + (f":{form}" if form else ""))
    return found


_REQUIRED = {"id", "legs", "condition"}
_COMPUTED = {"degrees", "terms", "shortest", "factors", "group"}
_OPTIONAL = {"name", "note", "readings", "status", "sources", *_COMPUTED}
STATUSES = ("inferred", "added", "always-singular")
KINDS = (*(rule.id for rule in INCIDENCES), *FROM_CATALOG, "linear-complex", "always-singular")


def _fewest(legs: tuple[Leg, ...]) -> dict[int, int]:
    """The fewest terms of both forms, for an entry that leaves them out."""
    return {form: min(n) for form, n in counts(legs).items()}


class _Reader:
    """Reads one entry; faults are recorded at their nodes."""

    def __init__(self, node: Node, owner: str, kinds: tuple[str, ...]) -> None:
        self.node = node
        self.owner = owner
        self.kinds = kinds

    def entry(self) -> Entry | None:
        top = self.node.mapping(required=_REQUIRED, optional=_OPTIONAL)
        if not top.keys() >= _REQUIRED:
            return None
        legs = self._legs(top["legs"])
        group = top["group"].choice(("b", "c", "d", "e", "g", "none")) if "group" in top else "none"
        names = {n for leg in legs or () for n in leg}
        condition = self._reading(top["condition"], names)
        readings = [self._reading(n, names, told=True) for n in top["readings"].sequence()] if "readings" in top else []
        factors = tuple(self._points(n) for n in top["factors"].sequence()) if "factors" in top else ()
        entry_id = top["id"].string()
        status = top["status"].choice(STATUSES) if "status" in top else "added"
        sources = tuple(n.string() or "" for n in top["sources"].sequence()) if "sources" in top else ()
        degrees = self._degrees(top["degrees"]) if "degrees" in top else None
        terms = self._terms(top["terms"]) if "terms" in top else None
        shortest = top["shortest"].integer() if "shortest" in top else None
        if not legs or not condition or entry_id is None or status is None or group is None:
            return None
        return Entry(
            id=entry_id,
            legs=legs,
            degrees=Structure(legs).degrees if degrees is None else degrees,
            terms=FrozenMap(_fewest(legs) if terms is None else terms),
            shortest=shortest,
            factors=factors,
            group=None if group == "none" else group,
            status=status,
            sources=sources,
            condition=condition,
            readings=tuple(r for r in readings if r),
            name=top["name"].string() if "name" in top else None,
            note=top["note"].string() if "note" in top else None,
            owner=self.owner,
            place=top["id"].place,
            left_out=frozenset(_COMPUTED - top.keys()),
        )

    def _degrees(self, node: Node) -> tuple[tuple[int, ...], tuple[int, ...]]:
        sides = [tuple(n.integer() or 0 for n in side.sequence()) for side in node.sequence(2)]
        return (sides[0], sides[1]) if sides else ((), ())

    def _terms(self, node: Node) -> dict[int, int]:
        return {int(form): n.integer() or 0 for form, n in node.mapping(required={"24", "16"}).items()}

    def _legs(self, node: Node) -> tuple[Leg, ...] | None:
        legs: tuple[Leg, ...] | None = self._parsed(node, lambda words: read_legs(words).legs)
        return legs

    def _points(self, node: Node) -> tuple[str, ...]:
        word = node.string() or ""
        names = tuple(SHORT_NAME.findall(word))
        if "".join(names) != word:
            node.fault(f"{word!r} is not made of points", "points are a letter with digits or primes: a, S1, A'")
        return names

    def _reading(self, node: Node, names: set[str], told: bool = False) -> CatalogIdentity | None:
        """One identity over the class's points; with `told`, or a kind that has no sentence, it needs a statement."""
        top = node.mapping(required={"kind", "expression"}, optional={"cofactor", "coefficient", "statement", "lines"})
        if "kind" not in top or "expression" not in top:
            return None
        kind = top["kind"].choice(dict.fromkeys((*KINDS, *self.kinds)))
        texts = {key: top[key].string() if key in top else "1" for key in ("expression", "cofactor")}
        coefficient = top["coefficient"].integer() if "coefficient" in top else 1
        if self.owner != SHIPPED:  # the shipped file is proved by its tests; its expressions are parsed when used
            for key in texts.keys() & top.keys():
                self._expression(top[key], 0, "a scalar", names)
        if kind == "always-singular" and texts["expression"] != "0":
            top["expression"].fault("what is always singular has the expression 0")
        expression, cofactor = texts["expression"], texts["cofactor"]
        if kind is None or expression is None or cofactor is None or coefficient is None:
            return None
        lines = [(k.string() or "", v) for k, v in top["lines"].entries()] if "lines" in top else []
        for _, line in lines if self.owner != SHIPPED else ():
            self._expression(line, 2, "a line", names)
        statement = top["statement"].string() if "statement" in top else None
        if statement is None and (told or kind in FROM_CATALOG or kind not in KINDS):
            node.fault("a reading needs a statement", "say in words when the expression vanishes")
        if re.search(r"[{}]", re.sub(LABELS, "", statement or "")):
            top["statement"].fault("a brace without its partner", "labels stand in braces: {Aab}")
        for word in re.findall(LABELS, statement or ""):
            if names and not names.issuperset(SHORT_NAME.findall(word)):
                top["statement"].fault(f"{{{word}}} is not made of points of the class")
        texts_of_lines = tuple((name, line.text) for name, line in lines)
        return CatalogIdentity(
            kind, expression, cofactor, coefficient, statement, texts_of_lines, top["expression"].place
        )

    def _expression(self, node: Node, step: int, what: str, names: set[str]) -> None:
        """Record a fault unless the text is an expression of this step over points of the class."""
        e = self._parsed(node, parse)
        if e is None:
            return
        strange = [n for n in ex.points_of(e) if n not in names]
        if e.step != step:
            node.fault(f"an expression of step {e.step}, expected {what} (step {step})")
        elif names and strange:
            node.fault(f"{', '.join(strange)} {'is' if len(strange) == 1 else 'are'} not among the points of the class")

    def _parsed(self, node: Node, read: Any) -> Any:
        word = node.string()
        if word is None:
            return None
        try:
            return read(word)
        except GcrulesError as fault:
            node.fault(fault.message, fault.hint)
            return None
