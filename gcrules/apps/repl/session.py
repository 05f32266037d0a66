"""What a command may ask of the interpreter that runs it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager
from typing import Protocol

from gcrules.algebra.expr import Expr
from gcrules.apps.repl.answers import Answer
from gcrules.apps.repl.reading import Source
from gcrules.apps.repl.state import PromptState, Settings

__all__ = ["PromptSession"]


class PromptSession(Protocol):
    """An interpreter, as its commands see it."""

    state: PromptState
    settings: Settings
    past: tuple[PromptState, ...]
    over: bool

    def expression(self, source: Source) -> Expr:
        """Read an expression. Raises SyntaxFault and StepError with place."""
        ...

    def equation(self, source: Source) -> Iterator[Answer]:
        """Decide an equation."""
        ...

    def shown(self, e: Expr, source: Source) -> Iterator[Answer]:
        """Expand an expression."""
        ...

    def remember(self, e: Expr | None) -> None:
        """Let % stand for an expression."""
        ...

    def script(self, name: str) -> Iterator[Answer]:
        """Run a script."""
        ...

    def step(self) -> AbstractContextManager[None]:
        """One step for `:undo`."""
        ...
