"""YAML files as trees of nodes that know their place, read so that all faults of a file come out at once.

    >>> document = Document.parse("title: Stand\\nlegs: [ab, cd]\\n")
    >>> top = document.root.mapping(required={"title"}, optional={"legs"})
    >>> top["title"].string(), [leg.string() for leg in top["legs"].sequence()]
    ('Stand', ['ab', 'cd'])
    >>> document.check()

Accessors record a fault and return None or nothing instead of raising; `Document.check` raises them together. Only
mappings, sequences and scalars are read: tags, anchors and aliases are faults. A scalar is text as it was written
(`no` is the word no); `integer`, `rational` and `boolean` read it as something else.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import field
from fractions import Fraction
from os import PathLike, fspath
from typing import Any, Literal

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, Span, join_faults
from gcrules.core.hints import files_like, near, number_with_unit

__all__ = ["MAX_BYTES", "Document", "Node", "read_text"]

MAX_BYTES = 1_000_000
MAX_DEPTH = 20
MAX_FAULTS = 30
MAX_NUMBER = 60
MAX_EXPONENT = 30

Kind = Literal["mapping", "sequence", "scalar"]

_KINDS = {"mapping": "a mapping (key: value)", "sequence": "a list", "scalar": "a single value"}
_NOTHING = frozenset({"", "~", "null", "Null", "NULL"})
_UNPRINTABLE = re.compile("[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_INTEGER = re.compile(r"[+-]?[0-9]+")
_RATIONAL = re.compile(r"[+-]?[0-9]+/[0-9]+|[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]{1,9}))?")
_NOT_FINITE = re.compile(r"[+-]?\.?(?:inf|infinity|nan)", re.IGNORECASE)


def read_text(path: str | PathLike[str], *, limit: int = MAX_BYTES) -> str:
    """The text of a UTF-8 file of at most `limit` bytes, without a byte order mark.

    Raises FileError for a file that is missing, a directory, unreadable, too large or not text.
    """
    name = fspath(path)
    try:
        with open(name, "rb") as file:
            data = file.read(limit + 1)
    except FileNotFoundError:
        raise FileError("there is no such file", filename=name, hint=files_like(name)) from None
    except IsADirectoryError:
        raise FileError("this is a directory, expected a file", filename=name) from None
    except (OSError, ValueError) as fault:
        raise FileError(f"cannot be read: {getattr(fault, 'strerror', None) or fault}", filename=name) from None
    if len(data) > limit:
        raise FileError(f"the file is larger than {limit:,} bytes", filename=name)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        line = data.count(b"\n", 0, fault.start) + 1
        what = f"this is not a text file in UTF-8 (byte {fault.start + 1}, line {line})"
        raise FileError(what, filename=name) from None


@dataclass(frozen=True, slots=True, eq=False)
class Document:
    """One YAML document: its root node, and the faults that were found while it was read."""

    source: str
    filename: str
    faults: list[GcrulesError] = field(default_factory=list)
    nodes: list[Node] = field(default_factory=list, repr=False)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Document:
        """Read a file. Raises FileError for one that cannot be read or is not YAML."""
        return cls.parse(read_text(path), fspath(path))

    @classmethod
    def parse(cls, source: str, filename: str = "<input>") -> Document:
        """Read a text. Raises FileError (with line and column) for one that is not YAML."""
        document = cls(source, filename)
        bad = _UNPRINTABLE.search(source)
        if bad:
            code = f"U+{ord(bad[0]):04X}"
            raise document.error(Span(*bad.span()), f"the character {code} may not stand in a text file")
        document.nodes.extend(_build(document))
        return document

    @property
    def root(self) -> Node:
        return self.nodes[0]

    def error(self, span: Span, message: str, hint: str | None = None) -> FileError:
        """A fault of this file at a place, as an exception to raise."""
        return FileError(message, span=span, source=self.source, filename=self.filename, hint=hint)

    def check(self) -> None:
        """Raise all recorded faults together, in the order of the file; do nothing if there are none."""
        if not self.faults:
            return
        found = sorted(self.faults, key=lambda f: f.span.start if f.span else 0)
        if len(found) > MAX_FAULTS:
            rest = FileError(f"and {len(found) - MAX_FAULTS} more faults", filename=self.filename)
            found = [*found[:MAX_FAULTS], rest]
        raise join_faults(found)


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """A mapping (children are keys and values in turn), a sequence or a scalar, with its place in the source."""

    document: Document = field(repr=False)
    kind: Kind
    span: Span
    text: str = ""
    quoted: bool = False
    children: tuple[Node, ...] = ()

    @property
    def is_nothing(self) -> bool:
        """Whether this is an empty value or `null`."""
        return self.kind == "scalar" and not self.quoted and self.text in _NOTHING

    @property
    def place(self) -> str:
        """`file:line:column`."""
        line, column = self.span.line_column(self.document.source)
        return f"{self.document.filename}:{line}:{column}"

    def fault(self, message: str, hint: str | None = None) -> None:
        """Record a fault at this node."""
        self.document.faults.append(self.document.error(self.span, message, hint))

    def fault_inside(self, text: str, fault: GcrulesError) -> None:
        """Record a fault of the text of this scalar at its place inside, where the scalar stands in the file as it
        reads; else at this node.
        """
        start = self.span.start + int(self.quoted)
        as_written = self.document.source[start : start + len(self.text)] == self.text
        if fault.span and self.kind == "scalar" and as_written and len(self.text) == len(text):
            span = Span(start + fault.span.start, start + fault.span.end)
            self.document.faults.append(self.document.error(span, fault.message, fault.hint))
        else:
            self.fault(fault.message, fault.hint)

    def mapping(
        self,
        required: Collection[str] = (),
        optional: Collection[str] = (),
        reserved: Mapping[str, str] | None = None,
    ) -> dict[str, Node]:
        """The values of a mapping with known keys, in the order of the file.

        Faults: not a mapping, a key twice, a missing required key, an unknown key. `reserved` names keys that are not
        read yet, with the reason.
        """
        if not self._is("mapping"):
            return {}
        known = {*required, *optional}
        found = {}
        for key, value in self._pairs():
            if reserved and key.text in reserved:
                key.fault(f"the key {key.text!r} is reserved: {reserved[key.text]}")
            elif key.text not in known:
                hint = near(key.text, known) or f"known keys: {', '.join(sorted(known))}"
                key.fault(f"unknown key {_short(key.text)}", hint)
            else:
                found[key.text] = value
        for name in sorted(required):
            if name not in found:
                self.fault(f"the key {name!r} is missing")
        return found

    def entries(self) -> list[tuple[Node, Node]]:
        """The (key, value) pairs of a mapping whose keys are free; a key that occurs twice is a fault."""
        return list(self._pairs()) if self._is("mapping") else []

    def sequence(self, length: int | None = None) -> tuple[Node, ...]:
        """The items of a list; nothing (and a fault) for anything else or another length."""
        if not self._is("sequence"):
            return ()
        if length is not None and len(self.children) != length:
            self.fault(f"a list of {len(self.children)}, expected {length}")
            return ()
        return self.children

    def string(self) -> str | None:
        """The text of a scalar as it was written; an empty value is a fault."""
        if not self._is("scalar"):
            return None
        if self.is_nothing or not self.text.strip():
            self.fault("expected text, found nothing")
            return None
        return self.text

    def choice(self, words: Collection[str]) -> str | None:
        """One of the given words."""
        text = self.string()
        if text is not None and text not in words:
            self.fault(f"{_short(text)} is not one of {', '.join(sorted(words))}", near(text, words))
            return None
        return text

    def integer(self) -> int | None:
        """A whole number."""
        text = self.string()
        if text is None:
            return None
        if self.quoted or len(text) > MAX_NUMBER or not _INTEGER.fullmatch(text):
            self.fault(f"expected a whole number, found {_short(text)}")
            return None
        return int(text)

    def rational(self, units: str = "numbers are written without a unit") -> Fraction | None:
        """A finite number, exact as written: `3`, `-0.25`, `1e-3` or `1/3` (quoted or not); `units` is the advice for
        one with a unit behind it.
        """
        text = self.string()
        if text is None:
            return None
        match = _RATIONAL.fullmatch(text.strip())
        if match is None:
            hint = "numbers are written 3, -0.25, 1e-3 or 1/3"
            if _NOT_FINITE.fullmatch(text.strip()):
                self.fault(f"expected a finite number, found {_short(text)}")
            else:
                quantity = number_with_unit(text)
                hint = f"write {quantity[0]}; {units.format(quantity[1])}" if quantity else hint
                self.fault(f"expected a number, found {_short(text)}", hint)
            return None
        if len(text) > MAX_NUMBER or abs(int(match[1] or 0)) > MAX_EXPONENT:
            self.fault(f"this number is too long (at most {MAX_NUMBER} signs, exponents up to {MAX_EXPONENT})")
            return None
        try:
            return Fraction(text.strip())
        except ZeroDivisionError:
            self.fault("division by zero")
            return None

    def _is(self, kind: Kind) -> bool:
        if self.kind != kind:
            found = "nothing" if self.is_nothing else _short(self.text) if self.kind == "scalar" else _KINDS[self.kind]
            self.fault(f"expected {_KINDS[kind]}, found {found}")
        return self.kind == kind

    def _pairs(self) -> Iterator[tuple[Node, Node]]:
        seen: dict[str, Node] = {}
        for key, value in zip(self.children[::2], self.children[1::2], strict=True):
            if key.kind != "scalar" or key.is_nothing:
                key.fault("a key must be a word")
            elif key.text in seen:
                line, _ = seen[key.text].span.line_column(self.document.source)
                key.fault(f"the key {_short(key.text)} occurs twice (first in line {line})")
            else:
                seen[key.text] = key
                yield key, value


def _short(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:40] + "…")


def _build(document: Document) -> list[Node]:
    """The root node, made from the parser's events without recursion; forbidden constructs are recorded as faults."""
    import yaml

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    builder = _Builder(document, yaml)
    try:
        for event in yaml.parse(document.source, Loader=loader):
            builder.take(event)
    except yaml.MarkedYAMLError as fault:
        mark: Any = fault.problem_mark or fault.context_mark
        at = min(mark.index, len(document.source)) if mark else 0
        what = ", ".join(str(p) for p in (fault.problem, fault.context) if p)
        raise document.error(Span(at, at + 1), f"this is not YAML: {what}") from None
    except yaml.YAMLError as fault:
        raise FileError(f"this is not YAML: {fault}", filename=document.filename) from None
    if not builder.open[0].children:
        raise FileError("the file is empty", filename=document.filename)
    return builder.open[0].children


@dataclass(slots=True)
class _Open:
    kind: Kind
    start: int
    flow: bool
    children: list[Node] = field(default_factory=list)


class _Builder:
    """Takes the events of the parser one by one; `open` holds the collections that are not closed yet."""

    def __init__(self, document: Document, events: Any) -> None:
        self.document = document
        self.events = events
        self.open = [_Open("sequence", 0, False)]

    def take(self, event: Any) -> None:
        kinds = self.events
        span = Span(event.start_mark.index, event.end_mark.index)
        self._forbid(event, span)
        if isinstance(event, kinds.ScalarEvent):
            self._add(Node(self.document, "scalar", span, event.value, event.style not in (None, "")))
        elif isinstance(event, kinds.AliasEvent):
            self._add(Node(self.document, "scalar", span, "?", True))
        elif isinstance(event, (kinds.MappingStartEvent, kinds.SequenceStartEvent)):
            if len(self.open) > MAX_DEPTH:
                raise self.document.error(span, f"nested more than {MAX_DEPTH} deep")
            kind: Kind = "mapping" if isinstance(event, kinds.MappingStartEvent) else "sequence"
            self.open.append(_Open(kind, span.start, bool(event.flow_style)))
        elif isinstance(event, (kinds.MappingEndEvent, kinds.SequenceEndEvent)):
            done = self.open.pop()
            inner = None if done.flow or not done.children else done.children[0].span
            self._add(
                Node(self.document, done.kind, inner or Span(done.start, span.end), children=tuple(done.children))
            )
        elif isinstance(event, kinds.DocumentStartEvent) and self.open[0].children:
            raise self.document.error(span, "a second document begins here; a file holds one")

    def _forbid(self, event: Any, span: Span) -> None:
        """Tags, anchors and aliases are faults."""
        if isinstance(event, self.events.AliasEvent):
            self._fault(span, f"aliases (*{event.anchor}) are not read", "write the value out")
            return
        if getattr(event, "anchor", None):
            self._fault(span, f"anchors (&{event.anchor}) are not read", "write the value out where it is needed")
        if getattr(event, "tag", None):
            self._fault(span, f"tags ({event.tag}) are not read", "write plain text, numbers, lists and mappings")

    def _fault(self, span: Span, message: str, hint: str) -> None:
        self.document.faults.append(self.document.error(span, message, hint))

    def _add(self, node: Node) -> None:
        self.open[-1].children.append(node)
