"""The argument of a command: text that knows its place, and what is read from it."""

from __future__ import annotations

import re
from collections.abc import Collection

from gcrules.algebra.expr import Expr, Join, Point, points_of
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.syntax import Context, parse
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near

__all__ = ["CommandWords", "counted", "relocated"]

_NUMBERS = {1: "one", 2: "two", 3: "three", 4: "four", 5: "five", 6: "six"}
_MOST = 8  # points in a list; the highest rank


def counted(number: int, noun: str) -> str:
    """ "two points", "one bracket"."""
    return f"{_NUMBERS.get(number, number)} {noun}{'s' * (number != 1)}"


def relocated(fault: GcrulesError, source: str, start: int, filename: str | None = None) -> GcrulesError:
    """A fault of a piece of text that begins at `start` of a source, with its place there."""
    span = fault.span or Span(0, max(1, len(fault.source or "")))
    fault.span = Span(min(start + span.start, len(source)), min(start + span.end, len(source)))
    fault.source = source
    fault.filename = filename or fault.filename
    return fault


@dataclass(frozen=True)
class CommandWords:
    """`text` begins at `start` of the command `source`."""

    text: str
    source: str
    start: int

    def fault(self, message: str, hint: str | None = None, span: Span | None = None) -> InputError:
        """A fault at a place in this text (all of it by default), to raise."""
        fault = InputError(message, span=span or Span(0, max(1, len(self.text))), hint=hint)
        relocated(fault, self.source, self.start)
        return fault

    def part(self, start: int, end: int) -> CommandWords:
        """A piece of the text without blanks around it."""
        piece = self.text[start:end]
        return CommandWords(piece.strip(), self.source, self.start + start + len(piece) - len(piece.lstrip()))

    def nothing(self, verb: str) -> None:
        """Raises InputError if there is anything."""
        if self.text:
            raise self.fault(f"{verb} takes no argument")

    def points(self, structure: Structure, number: int, noun: str, hint: str) -> tuple[str, ...]:
        """This many points of the structure; stars and commas are passed over. Raises InputError with place."""
        if not self.text:
            raise self.fault(f"{noun} needs {counted(number, 'point')}", hint)
        bare = re.sub(r"[*,]", " ", self.text)
        try:
            found = parse(bare, context=Context(_MOST, structure.points, structure.ideal))
        except GcrulesError as fault:
            if fault.span is None or "join has step" in fault.message:
                raise self.fault(f"{noun} has {counted(number, 'point')}, found more", hint) from None
            raise relocated(fault, self.source, self.start) from None
        args = found.args if isinstance(found, Join) else (found,)
        names = tuple(a.name for a in args if isinstance(a, Point))
        if len(names) != len(args):
            raise self.fault(f"expected points, found {self.text!r}", hint)
        self.known(found, structure.names)
        if len(names) != number:
            raise self.fault(f"{noun} has {counted(number, 'point')}, found {counted(len(names), 'point')}", hint)
        return names

    def different(self, names: tuple[str, ...], noun: str) -> None:
        """Raises InputError if a name occurs twice."""
        twice = next((n for i, n in enumerate(names) if n in names[:i]), None)
        if twice is not None:
            raise self.fault(f"{noun} has different points, but {twice} occurs twice")

    def expression(self, structure: Structure, what: str) -> Expr:
        """A scalar expression in points of the structure. Raises SyntaxFault, StepError or InputError with place."""
        if not self.text:
            raise self.fault(f"{what} is missing", "for example: condition abc /\\ aef /\\ bdf /\\ cde")
        try:
            found = parse(self.text, context=Context(4, structure.points, structure.ideal))
        except GcrulesError as fault:
            raise relocated(fault, self.source, self.start) from None
        self.known(found, structure.names)
        if not points_of(found) and what == "the expression":
            raise self.fault(f"{what} is a number, expected one with points in it")
        if found.step:
            raise self.fault(f"{what} has step {found.step}, expected a scalar (step 0)")
        return found

    def known(self, e: Expr, names: Collection[str]) -> None:
        """Raises InputError, with a suggestion, for a point that is none of these."""
        for name in points_of(e):
            if name not in names:
                at = max(self.text.find(name), 0)
                hint = near(name, names) or f"the points are {' '.join(names)}"
                raise self.fault(f"{name} is not a point of the legs", hint, Span(at, at + len(name)))
