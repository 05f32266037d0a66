"""The last net under a limit: what meets no checkpoint is ended by a signal, a little after its time.

Python delivers signals to the main thread only, between two of its instructions; so a single call into compiled code
is waited for, and in other threads the checkpoints are all there is.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from time import monotonic
from types import FrameType
from typing import Any, TypeVar

from gcrules.core.budget import Budget, within
from gcrules.core.interrupts import deferred
from gcrules.core.memory import memory_limit

__all__ = ["GRACE", "limited", "paced", "ringing"]

GRACE = 3.0  # seconds after its end in which a budget is waited for
_EVERY = 0.5  # seconds between two looks
_SOON = 0.001  # seconds until a timer rings whose moment has passed; 0 would be never
_PATIENCE = 5  # times that it does not ring since a block is just being left; longer than that it is no way out

_END = object()
_T = TypeVar("_T")


@contextmanager
def limited(seconds: float | None, grace: float = 0.0, gigabytes: float | None = None) -> Iterator[Budget]:
    """As `within`, with the memory that a command may use, or the `gigabytes` that are asked for, and the net.

    Raises LimitReached, InputError where GCRULES_MEMORY is no number.
    """
    with within(seconds, memory=memory_limit(gigabytes), grace=grace) as budget, _net(budget):
        yield budget


def paced(
    items: Iterator[_T], seconds: float | None, gigabytes: float | None = None, *, each: bool = False
) -> Iterator[_T]:
    """The items; all that is done for them together takes no more than `seconds`, or what is done for `each` of them;
    and no more than the `gigabytes`.

    What is done with them does not count.
    """
    left = seconds
    while True:
        started = monotonic()
        with limited(left, gigabytes=gigabytes):
            item = next(items, _END)
        if item is _END:
            return
        if left is not None and not each:
            left = max(0.0, left - (monotonic() - started))
        yield item  # type: ignore[misc]


@contextmanager
def _net(budget: Budget) -> Iterator[None]:
    def look(_: FrameType | None) -> None:
        budget.check_memory()
        if not budget.waiting and monotonic() > budget.until + GRACE:
            budget.check()

    with ringing(look, _EVERY, _EVERY):
        yield


_LEAVING = tuple(kind.__exit__.__code__ for kind in (type(deferred()), ExitStack))  # each block of `contextmanager`


def _leaves(frame: FrameType | None) -> bool:
    """Whether what runs is the end of a block of `with`."""
    while frame is not None:
        if frame.f_code in _LEAVING:
            return True
        frame = frame.f_back
    return False


@contextmanager
def ringing(ring: Callable[[FrameType | None], None], first: float, again: float) -> Iterator[None]:
    """Within it, `ring` is called `first` seconds of real time from now, then every `again` seconds, with what runs
    just then; what it raises is raised there. On the main thread only, and not where the system has no timers.

    A process has one such timer: one that ran before rests meanwhile, and goes on afterwards. Where a block is just
    being left it waits for the next time: what is raised there would leave undone what is done at the end of the block,
    this timer's own end too.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "setitimer"):
        yield
        return
    over, waited = False, 0

    def rings(number: int, frame: FrameType | None) -> None:
        nonlocal waited
        if over:
            return
        if waited < _PATIENCE and _leaves(frame):
            waited += 1
            return
        waited = 0
        ring(frame)

    handler: Any = None
    left = since = interval = 0.0
    try:
        with deferred():  # an interrupt amid this, or at the end, would leave a timer behind that rings later
            handler, since = signal.signal(signal.SIGALRM, rings), monotonic()
            left, interval = signal.setitimer(signal.ITIMER_REAL, first, again)
        yield
    finally:
        over = True
        with deferred():
            if since:
                signal.setitimer(signal.ITIMER_REAL, 0)
                signal.signal(signal.SIGALRM, handler)
            if left:
                signal.setitimer(signal.ITIMER_REAL, max(_SOON, left - (monotonic() - since)), interval)
