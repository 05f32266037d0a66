"""XML files as trees of elements that know their place; nothing is loaded, expanded or followed while they are read.

    >>> root = parse_xml('<robot name="stand"><link name="base"/></robot>', "stand.urdf")
    >>> root.tag, root.needed("name"), [(e.tag, e.line, e.column) for e in root.children]
    ('robot', 'stand', [('link', 1, 21)])
    >>> print(root.children[0].error("too short", "name"))
    stand.urdf:1:33: too short

Document types, and with them entities of a file's own, are refused, as are files that are large, deep or not UTF-8.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import field
from functools import cached_property
from os import PathLike, fspath
from xml.parsers import expat

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, Span
from gcrules.core.hints import near
from gcrules.core.yaml_file import read_text

__all__ = ["MAX_BYTES", "Element", "XmlFile", "inside", "load_xml", "parse_xml", "quoted"]

MAX_BYTES = 20_000_000
MAX_DEPTH = 200
MAX_ELEMENTS = 200_000
MAX_NUMBER = 100  # signs
LARGEST = 1e9  # metres, radians, degrees: a number beyond is a mistake
NO_LIMIT = 1e15  # and one beyond this, or infinite, is how some files write that there is no limit

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_INFINITE = re.compile(r"([+-]?)inf(?:inity)?", re.IGNORECASE)
_ATTRIBUTE = re.compile(rb"\s+([^\s=<>\"'/]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")


@dataclass(frozen=True, eq=False)
class XmlFile:
    """The text of a file, and its name."""

    source: str
    filename: str

    @cached_property
    def data(self) -> bytes:
        return self.source.encode("utf-8", "surrogatepass")

    def span(self, start: int, end: int) -> Span:
        """The characters of a range of bytes."""
        first = len(self.data[:start].decode("utf-8", "replace"))
        return Span(first, first + max(1, len(self.data[start:end].decode("utf-8", "replace"))))

    def error(self, start: int, end: int, message: str, hint: str | None = None) -> FileError:
        """A fault of this file at a range of bytes, as an exception to raise."""
        span = self.span(start, end)
        return FileError(message, span=span, source=self.source, filename=self.filename, hint=hint)


@dataclass(eq=False)
class Element:
    """An element with its attributes, its text and the elements inside; `start` is the place of its tag in bytes."""

    file: XmlFile = field(repr=False)
    tag: str
    attributes: Mapping[str, str]
    start: int = 0
    children: list[Element] = field(default_factory=list, repr=False)
    text: str = ""

    # --- places ----------------------------------------------------------------------------------------------------

    @cached_property
    def place(self) -> tuple[int, int]:
        """Line and column, from 1."""
        line_start = self.file.data.rfind(b"\n", 0, self.start) + 1
        column = len(self.file.data[line_start : self.start].decode("utf-8", "replace")) + 1
        return self.file.data.count(b"\n", 0, self.start) + 1, column

    @property
    def line(self) -> int:
        return self.place[0]

    @property
    def column(self) -> int:
        return self.place[1]

    def error(self, message: str, attribute: str | None = None, hint: str | None = None) -> FileError:
        """A fault of this element, or of the value of one of its attributes, as an exception to raise."""
        start, end = self.start, self.start + 1 + len(self.tag.encode())
        at = end
        while attribute in self.attributes and (match := _ATTRIBUTE.match(self.file.data, at)):
            if match[1].decode("utf-8", "replace") == attribute:
                start, end = match.span(2 if match[2] is not None else 3)
                break
            at = match.end()
        return self.file.error(start, end, message, hint)

    # --- elements inside -------------------------------------------------------------------------------------------

    def each(self, *tags: str) -> Iterator[Element]:
        """The elements inside with one of these tags, in their order."""
        return (e for e in self.children if e.tag in tags)

    def one(self, tag: str) -> Element | None:
        """The element inside with this tag, None where there is none. Raises FileError for several."""
        found = list(self.each(tag))
        if len(found) > 1:
            raise found[1].error(f"a second <{tag}> in <{self.tag}>, which has one")
        return found[0] if found else None

    def need(self, tag: str) -> Element:
        """The same, where it must not be missing."""
        found = self.one(tag)
        if found is None:
            raise self.error(f"<{self.tag}{self._named}> has no <{tag}>")
        return found

    def below(self) -> Iterator[Element]:
        """All elements inside, and those inside them."""
        waiting = list(reversed(self.children))
        while waiting:
            one = waiting.pop()
            yield one
            waiting += reversed(one.children)

    @property
    def _named(self) -> str:
        name = self.attributes.get("name")
        return f" name={quoted(name)}" if name else ""

    # --- values ----------------------------------------------------------------------------------------------------

    def needed(self, attribute: str) -> str:
        """The text of an attribute that must be there, and say something."""
        text = self.attributes.get(attribute, "").strip()
        if not text:
            what = "is empty" if attribute in self.attributes else "is missing"
            raise self.error(f"the attribute {attribute} of <{self.tag}{self._named}> {what}", attribute)
        return text

    def choice(self, attribute: str, words: tuple[str, ...], default: str | None = None) -> str:
        """One of these words. Raises FileError for another."""
        if default is not None and attribute not in self.attributes:
            return default
        word = self.needed(attribute)
        if word not in words:
            hint = near(word, words) or f"known: {', '.join(words)}"
            raise self.error(f"{attribute}={quoted(word)} is not known for <{self.tag}>", attribute, hint)
        return word

    def number(self, attribute: str, default: float) -> float:
        """A finite number, `default` where the attribute is missing."""
        return self.numbers(attribute, (default,))[0]

    def numbers(self, attribute: str, default: tuple[float, ...]) -> tuple[float, ...]:
        """As many finite numbers as `default` has, which stands for a missing attribute."""
        if attribute not in self.attributes:
            return default
        return self.read_numbers(self.attributes[attribute], (len(default),), attribute)

    def read_numbers(
        self, text: str, counts: tuple[int, ...], attribute: str | None = None, *, unlimited: bool = False
    ) -> tuple[float, ...]:
        """The numbers of a text of this element, as many as one of the counts (any number for none).

        Raises FileError for others, and for numbers that are not finite or beyond any machine; with `unlimited` those
        are how a file says that there is no limit, and become infinite.
        """
        words = text.split()
        what = attribute or f"<{self.tag}>"
        if counts and len(words) not in counts:
            wanted = " or ".join(map(str, counts))
            raise self.error(f"{what} has {len(words)} numbers, expected {wanted}", attribute)
        return tuple(self._number(word, what, attribute, unlimited) for word in words)

    def _number(self, word: str, what: str, attribute: str | None, unlimited: bool) -> float:
        endless = _INFINITE.fullmatch(word)
        if endless and unlimited:
            return -math.inf if endless[1] == "-" else math.inf
        if len(word) > MAX_NUMBER or not _NUMBER.fullmatch(word):
            finite = "finite " if endless or word.lstrip("+-").lower() == "nan" else ""
            raise self.error(f"{what}: {quoted(word)} is not a {finite}number", attribute)
        value = float(word)
        if unlimited and abs(value) >= NO_LIMIT:
            return math.copysign(math.inf, value)
        if abs(value) > LARGEST:
            raise self.error(f"{what}: {quoted(word)} is beyond any machine", attribute, "lengths are in metres")
        return value


def quoted(word: str) -> str:
    """A word of the file in a message, cut where it is long."""
    return repr(word if len(word) <= 40 else word[:40] + "…")


# --- reading -------------------------------------------------------------------------------------------------------


def load_xml(path: str | PathLike[str]) -> Element:
    """The root element of a file. Raises FileError for one that cannot be read, or is not XML as it is read here."""
    return parse_xml(read_text(path, limit=MAX_BYTES), fspath(path))


def parse_xml(source: str, filename: str = "<input>") -> Element:
    """The root element of a text. Raises FileError likewise."""
    return _Reading(XmlFile(source, filename)).root()


class _Reading:
    def __init__(self, file: XmlFile) -> None:
        self.file = file
        self.parser = expat.ParserCreate("utf-8")
        self.parser.buffer_text = True
        self.open: list[Element] = []
        self.first: Element | None = None
        self.count = 0
        self.parser.StartElementHandler = self._begin
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._text
        self.parser.StartDoctypeDeclHandler = self._refuse

    def root(self) -> Element:
        if not self.file.source.strip():
            raise FileError("the file is empty", filename=self.file.filename)
        try:
            self.parser.Parse(self.file.data, True)
        except expat.ExpatError as fault:
            at = self.parser.ErrorByteIndex
            what = expat.ErrorString(fault.code)
            raise self.file.error(at, at + 1, f"this is not XML: {what}") from None
        assert self.first is not None
        return self.first

    def _begin(self, tag: str, attributes: dict[str, str]) -> None:
        at = self.parser.CurrentByteIndex
        self.count += 1
        if not self.count % 1000:
            checkpoint()
        if len(self.open) >= MAX_DEPTH:
            raise self.file.error(at, at + 1, f"elements nested more than {MAX_DEPTH} deep")
        if self.count > MAX_ELEMENTS:
            raise self.file.error(at, at + 1, f"more than {MAX_ELEMENTS:,} elements")
        element = Element(self.file, tag, attributes, at)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.first = element
        self.open.append(element)

    def _end(self, tag: str) -> None:
        self.open.pop()

    def _text(self, text: str) -> None:
        self.open[-1].text += text

    def _refuse(self, *_: object) -> None:
        at = self.parser.CurrentByteIndex
        raise self.file.error(
            at, at + 9, "document types (<!DOCTYPE …>) are not read", "leave it out, and write entities out"
        )


def inside(element: Element, attribute: str | None, name: str, folder: str) -> str:
    """The path of a file that an element names, which must lie in the model's folder, or in one inside it.

    Raises FileError where it does not, or is not there.
    """
    top = os.path.realpath(folder)
    path = os.path.realpath(os.path.join(top, name)) if "\0" not in name else ""
    if os.path.commonpath((top, path or "/")) != top:
        hint = "copy it into the folder of the model"
        raise element.error(f"{quoted(name)} lies outside the model's folder, and is not read", attribute, hint)
    if not os.path.exists(path):
        raise element.error(f"there is no file {quoted(name)} in the model's folder", attribute)
    return path
