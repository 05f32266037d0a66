"""How much of an answer is written: its first words alone, as much as one reads, or everything."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import takewhile
from typing import TypeVar

__all__ = ["everything", "first", "is_everything", "naming_options", "opening", "without_options"]

_T = TypeVar("_T")
_EVERYTHING: ContextVar[bool] = ContextVar("everything", default=False)
_OPTIONS: ContextVar[bool] = ContextVar("options of the command line", default=True)
_FACT = re.compile(r" {2,}\S+(?: \S+)* {2,}\S")  # a name and, in a column of its own, what is said of it


@contextmanager
def everything(wanted: bool = True) -> Iterator[None]:
    """Answers that are written inside leave nothing out, however long they get, if that is `wanted`."""
    token = _EVERYTHING.set(wanted)
    try:
        yield
    finally:
        _EVERYTHING.reset(token)


def is_everything() -> bool:
    """Whether nothing is to be left out."""
    return _EVERYTHING.get()


@contextmanager
def without_options() -> Iterator[None]:
    """Answers that are written inside name no options of the command line, since their reader has none to give."""
    token = _OPTIONS.set(False)
    try:
        yield
    finally:
        _OPTIONS.reset(token)


def naming_options(words: str) -> str:
    """These words, which name options of the command line; nothing for a reader who has none.

    >>> naming_options(" (--full shows it)")
    ' (--full shows it)'
    >>> with without_options():
    ...     naming_options(" (--full shows it)")
    ''
    """
    return words if _OPTIONS.get() else ""


def first(items: Sequence[_T], most: int) -> Sequence[_T]:
    """The first few of them, or all where nothing is to be left out."""
    return items if is_everything() else items[:most]


def opening(text: str) -> str:
    """The answer alone: the first paragraph of a text, without the facts about it."""
    lines = text.strip("\n").splitlines()
    return "\n".join(takewhile(lambda line: line.strip() and not _FACT.match(line), lines)) or text
