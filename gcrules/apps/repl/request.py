"""A command of the prompt with what stands behind it, and the place of its faults."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from gcrules.apps.repl.reading import Source
from gcrules.apps.repl.tables import Command
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span

__all__ = ["Request"]


@dataclass(frozen=True, slots=True)
class Request:
    """A command with what stands behind it; `source` has the same for the parser."""

    command: Command
    argument: str
    source: Source

    @property
    def span(self) -> Span:
        """Where the argument stands, or the command where there is none."""
        whole = self.source.text
        begin = whole.rindex(self.argument) if self.argument else len(whole) - len(whole.lstrip())
        return Span(begin, begin + len(self.argument) if self.argument else len(whole.rstrip()))

    @contextmanager
    def placed(self) -> Iterator[None]:
        """Faults without a place are those of the argument."""
        try:
            yield
        except InputError as fault:
            raise (fault if fault.source is not None else self.fault(fault.message, fault.hint)) from None

    def fault(self, message: str, hint: str | None = None) -> GcrulesError:
        return InputError(message, hint=hint).located(self.source.text, self.source.filename, self.span)
