"""Interrupts that are not lost: one that Python had to ignore, as in a destructor, is delivered again."""

from __future__ import annotations

import _thread
import gc
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

__all__ = ["interruptible"]

_DELAY = 0.02  # seconds until the destructor is left


@contextmanager
def interruptible() -> Iterator[None]:
    """Within it, a KeyboardInterrupt reaches the computation even if it was raised in a destructor or callback.

    Python prints exceptions of destructors and goes on. What the prompt leaves behind (its event loop has a
    destructor) is collected before the computation, so that this is rare.
    """
    before = sys.unraisablehook
    main = _thread.get_ident()
    lost = False

    def again() -> None:
        nonlocal lost
        time.sleep(_DELAY)
        if lost:
            lost = False
            _interrupt(main)

    def hook(ignored: UnraisableHookArgs, /) -> None:
        nonlocal lost
        if not issubclass(ignored.exc_type, KeyboardInterrupt):
            before(ignored)
        elif not lost:
            lost = True
            _thread.start_new_thread(again, ())  # no lock of `threading`, which the main code may hold

    sys.unraisablehook = hook
    try:
        gc.collect()
        yield
    finally:
        lost = False
        sys.unraisablehook = before


def _interrupt(main: int) -> None:
    if sys.platform == "win32":
        _thread.interrupt_main()
    else:
        signal.pthread_kill(main, signal.SIGINT)  # ends system calls as well
