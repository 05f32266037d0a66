r"""What a computation may use: seconds and memory. Every long loop calls `checkpoint`, so that no limit is only said.

A budget surrounds the code that it limits; one inside another ends no later than the outer one. How many terms may be
held is counted by each stage for itself, for terms of different stages are not the same thing.

    >>> with within(seconds=60) as budget:
    ...     checkpoint()
    >>> budget.left > 0
    True
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from math import inf
from time import monotonic

from gcrules.errors import LimitReached

__all__ = ["Budget", "checkpoint", "seconds_left", "within"]

_MEMORY_EVERY = 0.1  # seconds between two looks at the memory that is in use
_PAGE = os.sysconf("SC_PAGE_SIZE") if hasattr(os, "sysconf") else 4096


@dataclass(eq=False)
class Budget:
    """At most `seconds` from `started` on, and at most `memory` bytes of this process; no limit where None.

    `progress` is told, in words, what is being done, by those who call `report`.
    """

    seconds: float | None
    memory: int | None
    progress: Callable[[str], None] | None
    started: float
    outer: Budget | None
    _memory_at: float = 0.0

    @property
    def until(self) -> float:
        """The moment at which this budget or one around it ends, on the monotonic clock."""
        own = inf if self.seconds is None else self.started + self.seconds
        return min(own, self.outer.until) if self.outer is not None else own

    @property
    def left(self) -> float:
        """Seconds that are left, negative where the time is over."""
        return self.until - monotonic()

    def check(self) -> None:
        """Raises LimitReached where the seconds or the memory are used up, here or in a budget around this one."""
        now = monotonic()
        if self.seconds is not None and now > self.started + self.seconds:
            raise LimitReached(
                f"this takes more than {self.seconds:g} seconds",
                hint="give it more time with --seconds (in Python seconds=...)",
            )
        if self.memory is not None and now > self._memory_at:
            self._memory_at = now + _MEMORY_EVERY
            used = _memory_in_use()
            if used > self.memory:
                raise LimitReached(
                    f"this takes more than {self.memory / 2**30:.3g} GB of memory",
                    hint="a smaller --limit ends sooner; GCRULES_MEMORY sets the gigabytes that may be used",
                )
        if self.outer is not None:
            self.outer.check()

    def report(self, words: str) -> None:
        """Tell the progress, here or around."""
        if self.progress is not None:
            self.progress(words)
        elif self.outer is not None:
            self.outer.report(words)


_current: ContextVar[Budget | None] = ContextVar("gcrules budget", default=None)


@contextmanager
def within(
    seconds: float | None = None, *, memory: int | None = None, progress: Callable[[str], None] | None = None
) -> Iterator[Budget]:
    """Limit what runs inside: by `seconds` from now, and to `memory` bytes of the process.

    Raises LimitReached, at the next `checkpoint`, when one of them is used up.
    """
    budget = Budget(seconds, memory, progress, monotonic(), _current.get())
    token = _current.set(budget)
    try:
        yield budget
    finally:
        _current.reset(token)


def checkpoint() -> None:
    """To be called in every loop that may be long. Raises LimitReached where a budget around the caller is used up."""
    budget = _current.get()
    if budget is not None:
        budget.check()


def seconds_left() -> float:
    """What the budgets around the caller leave, infinity where there are none."""
    budget = _current.get()
    return inf if budget is None else budget.left


def _memory_in_use() -> int:
    """Bytes of this process that are in memory; 0 where the system does not tell."""
    try:
        with open("/proc/self/statm", "rb") as file:
            return int(file.read().split()[1]) * _PAGE
    except (OSError, ValueError, IndexError):
        return 0
