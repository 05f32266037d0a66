"""Plain text in lines of one width: wrapped words, tables of two and three columns, and signs in ASCII."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar

__all__ = ["ASCII", "WIDTH", "columns", "line_width", "table", "unbroken", "wrapped"]

WIDTH = 100
_UNBROKEN = 1_000_000
_LINES: ContextVar[int] = ContextVar("lines", default=WIDTH)
ASCII = str.maketrans(
    {
        "σ": "sigma",
        "ρ": "rho",
        "²": "^2",
        "×": "x",
        "°": " deg",
        "∧": "/\\",
        "∨": "\\/",
        "·": "*",
        "−": "-",
        "≤": "<=",
        "≥": ">=",
        "⁹": "^9",
    }
)


@contextmanager
def unbroken() -> Iterator[None]:
    """Lines of answers that are written inside are as long as they come: what shows them breaks them."""
    token = _LINES.set(_UNBROKEN)
    try:
        yield
    finally:
        _LINES.reset(token)


def line_width() -> int:
    """The characters of a line."""
    return _LINES.get()


def table(rows: Sequence[tuple[str, str]]) -> Iterator[str]:
    """Two columns, the second one wrapped."""
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        yield from wrapped(value, f"{name:<{width}}  ", " " * (width + 2))


def columns(rows: Sequence[tuple[str, str, str]], indent: str) -> Iterator[str]:
    """Three columns, the third one wrapped."""
    first, second = (max(len(row[i]) for row in rows) for i in (0, 1))
    for a, b, c in rows:
        head = f"{indent}{a:<{first}}  {b:<{second}}  "
        yield from wrapped(c, head, " " * len(head))


def wrapped(text: str, first: str = "", rest: str | None = None) -> list[str]:
    """Words in lines; `rest` begins all lines but the first."""
    if not text:
        return [first.rstrip()]
    other = " " * len(first) if rest is None else rest
    found = textwrap.wrap(
        text,
        line_width(),
        initial_indent=first,
        subsequent_indent=other or "  ",
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.rstrip() for line in found]
