"""The entry point: from its first moment on a signal ends the program in order, and never with a traceback."""

from __future__ import annotations

import atexit
import os
import sys
import threading
from typing import NoReturn

from gcrules import files, interrupts, streams

__all__ = ["main"]


def main() -> NoReturn:
    """Answer the command line. A fault of gcrules itself shows its traceback and ends with code 70."""
    code = interrupts.run(_answered)
    interrupts.ignore()
    files.remove_unfinished()
    streams.flush()
    streams.silence()  # what is printed from now on, by a plugin that has asked to be called at the end, is no answer
    if any(not t.daemon for t in threading.enumerate() if t is not threading.main_thread()):
        atexit._run_exitfuncs()  # the interpreter would wait for a thread that a plugin has left behind
        os._exit(code)
    sys.exit(code)


def _answered() -> int:
    streams.prepare()
    from gcrules.cli import answered  # loads click; interrupts are heard already

    return answered()
