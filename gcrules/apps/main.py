"""The entry point: whenever a signal comes, the program ends in order, without a traceback."""

from __future__ import annotations

import atexit
import gc
import os
import sys

from gcrules.core import interrupts  # what else is needed is imported when signals are heard
from gcrules.core.deferred import deferred
from gcrules.core.threads import with_one_thread

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

__all__ = ["main"]

answered = deferred("gcrules.apps.cli:answered")  # loads click
prepare = deferred("gcrules.core.streams:prepare")
remove_unfinished = deferred("gcrules.core.files:remove_unfinished")
flush = deferred("gcrules.core.streams:flush")
silence = deferred("gcrules.core.streams:silence")

_INTERRUPTED = 130
_NEW_VALUES = 200_000  # between two searches for garbage: what is made at the start, most of it stays to the end


def main() -> NoReturn:
    """Answer the command line. A fault of gcrules itself shows its traceback and ends with code 70."""
    try:
        gc.set_threshold(_NEW_VALUES)
        with_one_thread(os.environ)
        code = interrupts.run(_answered)
    except KeyboardInterrupt:  # it came before signals were heard
        code = _INTERRUPTED
    interrupts.ignore()
    _tidy()
    if interrupts.pending() is None and not _waits():
        sys.exit(code)
    # Python would wait for a thread that a plugin has left behind, and kill itself where it remembers an interrupt.
    atexit._run_exitfuncs()
    os._exit(code)


def _answered() -> int:
    prepare()
    code: int = answered()
    return code


def _tidy() -> None:
    """Leave no unfinished file; what is printed from now on, by a plugin that is called at the end, is no answer."""
    remove_unfinished()
    flush()
    silence()


def _waits() -> bool:
    """Whether the interpreter would not end before somebody else does."""
    import threading

    return any(not t.daemon for t in threading.enumerate() if t is not threading.main_thread())
