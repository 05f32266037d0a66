r"""Reading what is typed: where one input ends, whether it is finished, what `%` stands for, where faults stand.

>>> [p.text for p in pieces(["let p = [ab", "cd]", ":context", "p**2"])]
['let p = [ab\ncd]', ':context', 'p**2']
>>> unfinished("ab /\\"), unfinished("[abcd] =="), unfinished("ab /\\ cd")
(True, True, False)
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.parse_tree import read, span_of
from gcrules.algebra.language.relation_words import RELATION_NAMES
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import text as text_of
from gcrules.apps.repl.tables import COMMANDS, RULE_WORDS, STATEMENTS, meant
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span

__all__ = [
    "InputPiece",
    "Source",
    "as_typed",
    "bare_command",
    "first_word",
    "is_blank",
    "is_claim",
    "pieces",
    "split_command",
    "spoken_command",
    "statements",
    "unfinished",
    "without_quotes",
    "without_results",
]

_FIRST_WORD = re.compile(r"(?:\s|#[^\n]*(?:\n|$))*([A-Za-z][A-Za-z0-9_']*)?")
_COMMAND = re.compile(r"\s*:([A-Za-z?]*)[ \t]*")
_MEANINGS = {"help": "help", "?": "help", "undo": "undo", "quit": "quit", "exit": "quit", "bye": "quit"}
_BARE = re.compile(r"\s*(help|\?|undo|quit|exit|bye)\s*(?:\(\s*\))?\s*;?\s*", re.IGNORECASE)
_SPOKEN = re.compile(r"\s*([A-Za-z]+)(?=\s|$)\s*")
_BLANK = re.compile(r"(?:\s|#[^\n]*(?:\n|$))*")
_RESULT = re.compile(r'"[^"\n]*"|#[^\n]*|(%+)')
_QUOTED = re.compile(r"""\s*(["'])((?:(?!\1).)+)\1\s*""", re.DOTALL)
_NAME = "last__"  # the results, as names that cannot be points side by side
_BOUND_NAME = re.compile(rf"{_NAME}([0-9]+)")
_BRACKETS = re.compile(r'"[^"\n]*"|#[^\n]*|[][()]')
_OPERATOR_LAST = re.compile(r"[-+*=,>^∧∨·×−]\s*$|/\\\s*$|\\/\s*$")
_EXPRESSIONS = {"expression": "expression", "latex": "expression", "equation": "equation"}


@dataclass(frozen=True, slots=True)
class InputPiece:
    """One input, and the line on which it begins."""

    text: str
    line: int = 1


# --- where an input ends -------------------------------------------------------------------------------------------


def is_blank(text: str) -> bool:
    """Whether there is nothing but blanks and comments."""
    return _BLANK.fullmatch(text) is not None


def first_word(text: str) -> str:
    """The first word, comments left out; empty where the text begins with anything else."""
    found = _FIRST_WORD.match(text)
    return (found[1] if found else None) or ""


def is_claim(text: str) -> bool:
    """Whether a text that is no statement claims something: an equation, a relation, or the dual of one."""
    inner = re.sub(r"^\s*dual\(", "", text)
    return "==" in text or first_word(inner) in RELATION_NAMES


def split_command(text: str) -> tuple[str, int] | None:
    """The name of a command and where its argument begins, or None for anything else."""
    found = _COMMAND.match(text)
    return (found[1], found.end()) if found else None


def bare_command(text: str) -> str:
    """The name of the command that words without a colon stand for at most prompts: help, undo, quit, exit, ?; else
    empty.
    """
    found = _BARE.fullmatch(text)
    return _MEANINGS[found[1].lower()] if found else ""


def spoken_command(text: str) -> tuple[str, int] | None:
    """The command whose name begins a text without its colon, "prove ab == -ba", and where its argument begins."""
    found = _SPOKEN.match(text)
    name = found[1].lower() if found else ""
    return (name, found.end()) if found and name in COMMANDS else None


def without_quotes(text: str, at: int) -> str:
    """The text with blanks in place of quotes around all that stands from a place on, where a shell would need them.

    >>> without_quotes('analyze "ab cd"', 8)
    'analyze  ab cd '
    """
    found = _QUOTED.fullmatch(text, at)
    return f"{text[: found.start(1)]} {found[2]} {text[found.end(2) + 1 :]}" if found else text


def unfinished(text: str) -> bool:
    """Whether the grammar wants more: an open bracket, an operator without its right side, half a statement."""
    start, body = "expression", text
    found = split_command(text)
    if found:
        names = meant(found[0])
        start = _EXPRESSIONS.get(COMMANDS[names[0]].takes, "") if len(names) == 1 else ""
        body = text[found[1] :]
        if not start or is_blank(body):
            return False
    elif first_word(text) in STATEMENTS:
        start = "script"
    if is_blank(body):
        return False
    if start == "expression" and "==" in body:
        start = "equation"
    body = _RESULT.sub(lambda m: " a " if m[1] else m[0], body)
    try:
        read(body, start, "<input>", lambda tree: None)
    except GcrulesError as fault:
        # The grammar puts an end that comes too early behind the last character.
        return fault.span is not None and fault.span.start == fault.span.end
    return False


def pieces(lines: Iterable[str], first: int = 1, *, ahead: bool = True) -> Iterator[InputPiece]:
    """The inputs that lines of text make, each as soon as it is complete.

    An unfinished input goes on with the next line; so does, with `ahead`, any input before an indented line, and a rule
    before one of its clauses. A blank line ends an input.
    """
    held: list[str] = []
    depth, begun = 0, first
    for number, line in enumerate(lines, first):
        if held and not _goes_on(held, depth, line, ahead):
            yield InputPiece("\n".join(held), begun)
            held = []
        if not held:
            depth, begun = 0, number
        if held or not is_blank(line):
            held.append(line)
            depth += sum(1 if m in "([" else -1 for m in _BRACKETS.findall(line) if len(m) == 1)
        if held and not ahead and not _open(held, depth):
            yield InputPiece("\n".join(held), begun)
            held = []
    if held:
        yield InputPiece("\n".join(held), begun)


def _goes_on(held: list[str], depth: int, line: str, ahead: bool) -> bool:
    """Whether a line belongs to the input before it."""
    if not line.strip() or (_COMMAND.match(line) and not line[:1].isspace()):
        return False
    if ahead and line[:1].isspace() and not _COMMAND.match(held[0]):
        return True
    clause = ahead and first_word(line) in RULE_WORDS and first_word("\n".join(held)) == "rule"
    return clause or _open(held, depth)


def _open(held: list[str], depth: int) -> bool:
    """`unfinished`, told from brackets and the last sign where possible: long inputs are not read line after line."""
    quick = depth > 0 or _OPERATOR_LAST.search(held[-1]) is not None
    return (quick and not _COMMAND.match(held[0])) or unfinished("\n".join(held))


# --- what was typed, and what the parser reads ---------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Mark:
    """A run of `number` signs % in the text, and the name in its place for the parser."""

    number: int
    place: Span
    parsed: Span


@dataclass(frozen=True, slots=True)
class Source:
    """A text as it was typed, and as the parser reads it: the results that `%` stands for have names there.

    `parsed` may be a part of what is parsed in all: `offset` leads from its positions to those of the whole, in which
    `marks` stand.
    """

    text: str
    parsed: str
    filename: str = "<input>"
    marks: tuple[_Mark, ...] = ()
    offset: int = 0

    @classmethod
    def of(cls, text: str, filename: str = "<input>", line: int = 1, skip: int = 0) -> Source:
        """The text that begins on this line of its file; `skip` characters of it (a command) are not parsed."""
        above = "\n" * (line - 1)
        parts = [above, " " * skip]
        marks: list[_Mark] = []
        at, length = skip, len(above) + skip
        for found in _RESULT.finditer(text, skip):
            if not found[1]:
                continue
            length += found.start() - at
            name = f" {_NAME}{len(found[1])} "
            parts += [text[at : found.start()], name]
            place = Span(len(above) + found.start(), len(above) + found.end())
            marks.append(_Mark(len(found[1]), place, Span(length, length + len(name))))
            at, length = found.end(), length + len(name)
        return cls(above + text, "".join([*parts, text[at:]]), filename, tuple(marks))

    def only(self, span: Span) -> Source:
        """The same place with nothing but this span of `parsed` to read."""
        line, column = span.line_column(self.parsed)
        before = "\n" * (line - 1) + " " * (column - 1)
        body = self.parsed[span.start : span.end]
        return replace(self, parsed=before + body, offset=self.offset + span.start - len(before))

    @property
    def line(self) -> int:
        """The line on which the part to read begins."""
        return len(self.parsed) - len(self.parsed.lstrip("\n")) + 1

    def used(self) -> list[_Mark]:
        """The marks in the part to read."""
        start = self.offset + len(self.parsed) - len(self.parsed.lstrip())
        end = self.offset + len(self.parsed)
        return [m for m in self.marks if start <= m.parsed.end - 1 and m.parsed.start < end]

    def context(self, context: Context, results: tuple[Expr, ...]) -> Context:
        """The context with the results that are referred to. Raises InputError where there is none."""
        found = {}
        for mark in self.used():
            if mark.number > len(results):
                what = f"no result {mark.number} back" if results else "no result yet"
                hint = "% is the last result, %% the one before it"
                raise InputError(
                    f"there is {what}", span=mark.place, source=self.text, filename=self.filename, hint=hint
                )
            result = results[mark.number - 1]
            for name in points_of(result):
                if name in context.bound:
                    what = f"the result holds the point {name}, and {name} now names something else"
                    raise InputError(what, span=mark.place, source=self.text, filename=self.filename)
            found[f"{_NAME}{mark.number}"] = result
        return replace(context, bound={**context.bound, **found}) if found else context

    def written_out(self, results: tuple[Expr, ...], names: tuple[str, ...]) -> str:
        """What is read, as text that needs no results."""

        def shown(found: re.Match[str]) -> str:
            return f"({text_of(results[int(found[1]) - 1], names=names)})"

        return re.sub(rf" {_BOUND_NAME.pattern} ?", shown, self.parsed.strip()) if self.used() else self.parsed.strip()

    @contextmanager
    def placed(self) -> Iterator[None]:
        """Faults are given their place in the text as it was typed."""
        try:
            yield
        except GcrulesError as fault:
            if fault.source == self.parsed:
                fault.source = self.text
                if fault.span is not None:
                    fault.span = Span(self._back(fault.span.start), self._back(fault.span.end, end=True))
            fault.message = as_typed(fault.message)
            raise

    def _back(self, at: int, end: bool = False) -> int:
        """From a position in `parsed` to one in `text`."""
        at += self.offset
        moved = 0
        for mark in self.marks:
            if at <= mark.parsed.start:
                break
            if at < mark.parsed.end:
                return mark.place.end if end else mark.place.start
            moved = mark.place.end - mark.parsed.end
        return at + moved


def as_typed(text: str) -> str:
    """With results written as % again."""
    return _BOUND_NAME.sub(lambda m: "%" * int(m[1]) if len(m[1]) < 3 else m[0], text)


def without_results(context: Context) -> Context:
    """Without the names that results had while a text was read."""
    bound = {n: e for n, e in context.bound.items() if not _BOUND_NAME.fullmatch(n)}
    return context if len(bound) == len(context.bound) else replace(context, bound=bound)


def statements(source: Source) -> list[Source]:
    """Each statement of a script by itself, in its place. Raises SyntaxFault."""
    spans = read(source.parsed, "script", source.filename, lambda tree: [span_of(item) for item in tree.children])
    return [source.only(span) for span in spans]
