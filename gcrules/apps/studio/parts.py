"""The parts of an answer that takes long: given one after the other, to whoever waits for the whole.

>>> heard = []
>>> with given_to(heard.append), shaped(str.upper):
...     give("a part")
>>> heard
['A PART']
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

__all__ = ["give", "given_to", "shaped"]

_hears: ContextVar[Callable[[Any], None] | None] = ContextVar("who hears of parts", default=None)


def give(part: Any) -> None:
    """Give a part to who hears of it, if anybody does."""
    hears = _hears.get()
    if hears is not None:
        hears(part)


@contextmanager
def given_to(hears: Callable[[Any], None]) -> Iterator[None]:
    """What is given inside is heard."""
    token = _hears.set(hears)
    try:
        yield
    finally:
        _hears.reset(token)


@contextmanager
def shaped(shape: Callable[[Any], Any]) -> Iterator[None]:
    """What is given inside is heard in another shape."""
    outer = _hears.get()
    if outer is None:
        yield
        return
    with given_to(lambda part: outer(shape(part))):
        yield
