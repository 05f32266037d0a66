r"""What a computation may use: seconds and memory. Every long loop calls `checkpoint`, so that no limit is only said.

A budget surrounds the code that it limits; one inside another ends no later than the outer one. How many terms may be
held is counted by each stage for itself (by `Count`), for terms of different stages are not the same thing.

    >>> with within(seconds=60) as budget:
    ...     checkpoint()
    >>> 0 < budget.left <= 60
    True
    >>> with within(seconds=0):
    ...     checkpoint()
    Traceback (most recent call last):
    gcrules.core.errors.LimitReached: this takes more than 0 seconds
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from math import inf, isnan
from numbers import Real
from time import monotonic
from typing import Any, TypeVar

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.memory import GIGABYTE, memory_in_use

__all__ = [
    "MORE_MEMORY",
    "MORE_SECONDS",
    "MORE_TERMS",
    "Budget",
    "Count",
    "as_float",
    "checkpoint",
    "punctual",
    "report",
    "seconds_left",
    "stage",
    "waiting",
    "watched",
    "within",
]

MORE_SECONDS = "give it more time with --seconds (in Python within(seconds=...))"
MORE_MEMORY = "GCRULES_MEMORY sets the gigabytes, --memory those of factor and factors (in Python within(memory=...))"
MORE_TERMS = "raise the limit with --limit (in Python limit=...)"

_T = TypeVar("_T")
_LOOK = 0.1  # seconds between two looks at the memory that is in use, and at the budgets around


@dataclass(eq=False)
class Budget:
    """At most `seconds` from `started` on, and at most `memory` bytes of this process; no limit where None.

    `grace` is what may be taken beyond the seconds, for work that has a limit of its own, or to finish.

    `progress` is told, in words, what is being done, by those who call `report`.
    """

    seconds: float | None
    memory: int | None
    progress: Callable[[str], None] | None
    started: float
    outer: Budget | None
    grace: float = 0.0

    def __post_init__(self) -> None:
        own = inf if self.seconds is None else self.started + self.seconds + self.grace
        self.until: float = own if self.outer is None else min(own, self.outer.until)
        """The moment at which this budget or one around it ends, on the monotonic clock."""
        self.look = self.started
        """Checkpoints compare the clock with this moment, and do nothing else before it."""
        self.cancelled = False
        self.waiting = 0

    @property
    def left(self) -> float:
        """Seconds that are left, negative where the time is over."""
        return self.until - monotonic()

    def check(self) -> None:
        """Raises LimitReached where the seconds or the memory are used up, here or in a budget around this one."""
        now = monotonic()
        one: Budget | None = self
        while one is not None:
            one._check(now)
            one = one.outer
        self.look = min(self.until, now + _LOOK)

    def _check(self, now: float) -> None:
        if self.cancelled:
            raise LimitReached("this was cancelled")
        if self.seconds is not None and not self.waiting and now >= self.started + self.seconds + self.grace:
            what = "1 second" if self.seconds == 1 else f"{self.seconds:,.10g} seconds"
            raise LimitReached(f"this takes more than {what}", hint=MORE_SECONDS)
        self.check_memory()

    def check_memory(self) -> None:
        """Raises LimitReached where this budget's memory is used up."""
        if self.memory is not None and memory_in_use() > self.memory:
            raise LimitReached(f"this takes more than {self.memory / GIGABYTE:.3g} GB of memory", hint=MORE_MEMORY)

    def cancel(self) -> None:
        """Let the next checkpoint raise LimitReached; may be called from any thread."""
        self.cancelled = True
        self.look = -inf

    def report(self, words: str) -> None:
        """Tell the progress, here or around."""
        if self.progress is not None:
            self.progress(words)
        elif self.outer is not None:
            self.outer.report(words)


_current: ContextVar[Budget | None] = ContextVar("gcrules budget", default=None)


@contextmanager
def within(
    seconds: float | None = None,
    *,
    memory: int | None = None,
    progress: Callable[[str], None] | None = None,
    grace: float = 0.0,
) -> Iterator[Budget]:
    """Limit what runs inside: by `seconds` (and `grace`) from now, and to `memory` bytes of the process.

    Raises LimitReached, at the next `checkpoint`, when one of them is used up; InputError for what is no number.
    """
    limits: tuple[tuple[Any, str], ...] = ((seconds, "seconds"), (memory, "bytes of memory"))
    for given, what in limits:
        if given is not None and (not isinstance(given, Real) or isnan(as_float(given))):
            raise InputError(f"{given!r} is not a number of {what}", hint="None means no limit")
    budget = Budget(
        None if seconds is None else as_float(seconds), memory, progress, monotonic(), _current.get(), grace
    )
    token = _current.set(budget)
    try:
        yield budget
    finally:
        _current.reset(token)


@contextmanager
def punctual() -> Iterator[None]:
    """What runs inside has the seconds of the budget around it, and not its grace.

    >>> with within(seconds=0, grace=60):
    ...     checkpoint()
    ...     with punctual():
    ...         checkpoint()
    Traceback (most recent call last):
    gcrules.core.errors.LimitReached: this takes more than 0 seconds
    """
    around = _current.get()
    if around is None:
        yield
        return
    token = _current.set(Budget(around.seconds, None, None, around.started, around))
    try:
        yield
    finally:
        _current.reset(token)


def as_float(number: Any) -> float:
    """A real number of any kind as a float, infinity where it is too large for one."""
    try:
        return float(number)
    except OverflowError:
        return inf if number > 0 else -inf


def checkpoint() -> None:
    """To be called in every loop that may be long. Raises LimitReached where a budget around the caller is used up."""
    budget = _current.get()
    if budget is not None and monotonic() >= budget.look:
        budget.check()


def watched(items: Iterable[_T], every: int = 64) -> Iterator[_T]:
    """The items, with a checkpoint before the first and before each `every`-th after it: for loops of short turns."""
    for number, item in enumerate(items):
        if not number % every:
            checkpoint()
        yield item


@contextmanager
def waiting() -> Iterator[None]:
    """What is spent inside, on waiting for whoever writes the input or reads the output, does not count."""
    around: list[Budget] = []
    one = _current.get()
    while one is not None:
        around.append(one)
        one = one.outer
    began = monotonic()
    for one in around:
        one.waiting += 1
    try:
        yield
    finally:
        gone = monotonic() - began
        for one in around:
            one.waiting -= 1
            if not one.waiting:
                one.started += gone
                one.until += gone


def seconds_left() -> float:
    """What the budgets around the caller leave, infinity where there are none."""
    budget = _current.get()
    return inf if budget is None else budget.left


def report(words: str) -> None:
    """Tell the progress to the budget around the caller that listens, if one does."""
    budget = _current.get()
    if budget is not None:
        budget.report(words)


@contextmanager
def stage(words: str) -> Iterator[None]:
    """Tell what is being done; what is reported inside stands behind these words.

    >>> heard = []
    >>> with within(progress=heard.append), stage("line 3"):
    ...     report("7 of 9")
    >>> heard
    ['line 3', 'line 3: 7 of 9']
    """
    around = _current.get()
    if around is None:
        yield
        return
    around.report(words)
    with within(progress=lambda more: around.report(f"{words}: {more}")):
        yield


@dataclass
class Count:
    """Counts what one stage does or holds, beside the clock: beyond `most`, LimitReached says that it `takes` more
    than so many `things`.

    >>> Count(2, "matching a rule takes", "trials").spend(3)
    Traceback (most recent call last):
    gcrules.core.errors.LimitReached: matching a rule takes more than 2 trials
    """

    most: int
    takes: str
    things: str
    hint: str | None = None
    done: int = 0

    @property
    def left(self) -> int:
        return self.most - self.done

    def spend(self, number: int = 1) -> None:
        """So many more. Raises LimitReached beyond `most`, or where a budget around the caller is used up."""
        self.done += number
        self.check(self.done)

    def check(self, number: int) -> None:
        """The same for a number that is not counted up."""
        if number > self.most:
            raise LimitReached(f"{self.takes} more than {self.most:,} {self.things}", hint=self.hint)
        checkpoint()
