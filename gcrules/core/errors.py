"""The errors a user can cause, each with its place in the input and advice on what to do.

Every fault is a `GcrulesError`; the command line prints `render()` and exits with `exit_code`
(2: the input is at fault, 3: a stated limit was reached before an answer was found).
"""

from __future__ import annotations

from typing import Any

from gcrules.core.dataclass import dataclass

__all__ = [
    "EngineFault",
    "FileError",
    "GcrulesError",
    "InputError",
    "LimitReached",
    "Span",
    "StepError",
    "SyntaxFault",
    "absent",
    "join_faults",
    "printable",
]


@dataclass(frozen=True, slots=True)
class Span:
    """A half-open range of characters `[start, end)` of a source text (offsets count code points from 0)."""

    start: int
    end: int

    def line_column(self, source: str) -> tuple[int, int]:
        """Line and column of the start, both counted from 1."""
        before = source[: self.start]
        line = before.count("\n") + 1
        return line, self.start - (before.rfind("\n") + 1) + 1


class GcrulesError(Exception):
    """Base of all faults that gcrules reports.

    `message` says what is wrong, `hint` what to do about it; `span` is the place in `source`,
    `filename` names the file the source came from ("<input>" for text from the command line).
    """

    exit_code = 2

    def __init__(
        self,
        message: str,
        *,
        span: Span | None = None,
        source: str | None = None,
        filename: str = "<input>",
        hint: str | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.span = span
        self.source = source
        self.filename = filename
        self.hint = hint

    def located(self, source: str, filename: str | None = None, span: Span | None = None) -> GcrulesError:
        """Fill in the source text (and place, if missing) and return the error itself, for `raise e.located(...)`."""
        if self.source is None:
            self.source = source
            self.filename = filename or self.filename
            self.span = self.span or span
        return self

    def of(self, owner: str) -> GcrulesError:
        """Say whose fault it is, where that is known, and return the error itself, for `raise e.of(...)`."""
        self.message = f"{owner}: {self.message}" if owner else self.message
        return self

    @property
    def place(self) -> str | None:
        """`file:line:column`, or None where no place is known."""
        if self.span is None or self.source is None:
            return None if self.filename == "<input>" else self.filename
        line, column = self.span.line_column(self.source)
        return f"{self.filename}:{line}:{column}"

    def render(self) -> str:
        """The message with its place, the line of source with a caret, and the hint; nothing that moves a cursor."""
        head = f"{self.place}: " if self.place else ""
        lines = [f"error: {head}{self.message}"]
        if self.span is not None and self.source is not None:
            lines += _caret(self.source, self.span)
        if self.hint:
            lines.append(f"hint: {self.hint}")
        return printable("\n".join(lines))

    def __str__(self) -> str:
        return f"{self.place}: {self.message}" if self.place else self.message


class EngineFault(RuntimeError):
    """The symbolic and the numeric road disagree: a fault of gcrules, never of the input."""


class InputError(GcrulesError):
    """Input that is well-formed text but makes no sense (too few legs, unknown option value, …)."""


def absent(fault: ModuleNotFoundError) -> InputError:
    """What is said where a package is not installed. Raises the fault itself where a module of gcrules is missing."""
    package = (fault.name or "gcrules").partition(".")[0]
    if package == "gcrules":
        raise fault
    return InputError(f"this answer needs {package}, which is not installed here", hint="pip install gcrules brings it")


class SyntaxFault(InputError):
    """Text that the grammar does not accept."""


class StepError(InputError):
    """An operation on extensors whose steps do not allow it (beyond the rank, too small to meet, unlike steps)."""


class FileError(InputError):
    """A file that cannot be read, is not what its format asks for, or cannot be written."""


class LimitReached(GcrulesError):
    """No answer within the stated limit of terms, size or time; the hint says how to raise it."""

    exit_code = 3


class SingularEverywhere(GcrulesError):
    """The answer no to every question for a regular pose: the robot is singular in all of them, proved."""

    exit_code = 1


class _Many(FileError):
    """Several faults of one file, shown together."""

    def __init__(self, faults: list[GcrulesError]) -> None:
        super().__init__(f"{len(faults)} faults", filename=faults[0].filename)
        self.faults = tuple(faults)

    def of(self, owner: str) -> GcrulesError:
        for fault in self.faults:
            fault.of(owner)
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _Many, (list(self.faults),)

    def render(self) -> str:
        return "\n".join(fault.render() for fault in self.faults)

    def __str__(self) -> str:
        return "; ".join(str(fault) for fault in self.faults)


def join_faults(faults: list[GcrulesError]) -> GcrulesError:
    """One error that shows all the given faults (the fault itself if there is just one)."""
    return faults[0] if len(faults) == 1 else _Many(faults)


_WINDOW = 100


def printable(text: str) -> str:
    """Words of the input are quoted in messages: what is no character of a line of text is shown as one that is."""
    return "".join(c if c.isprintable() or c == "\n" else "�" for c in text)


def _caret(source: str, span: Span) -> list[str]:
    """The source line of a span and a caret line under it, cut to a window around the place if it is long."""
    start_of_line = source.rfind("\n", 0, span.start) + 1
    end_of_line = source.find("\n", span.start)
    line = source[start_of_line : end_of_line if end_of_line >= 0 else len(source)]
    column = span.start - start_of_line
    width = max(1, min(span.end, start_of_line + len(line)) - span.start)
    first = max(0, column - _WINDOW // 2)
    shown = line[first : first + _WINDOW]
    prefix = "…" if first else ""
    suffix = "…" if first + _WINDOW < len(line) else ""
    shown = printable(shown)
    marks = "^" * max(1, min(width, _WINDOW - (column - first)))
    return [f"  {prefix}{shown}{suffix}", "  " + " " * (len(prefix) + column - first) + marks]
