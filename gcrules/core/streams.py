"""The standard streams of the program: closed ones, text they cannot encode, and writing that fails."""

from __future__ import annotations

import errno
import io
import os
import sys
from contextlib import suppress
from typing import Any

__all__ = ["STDOUT", "flush", "is_stdout", "prepare", "silence", "write"]

STDOUT = "-"
"""What stands for standard output among the names of files."""


class _Closed(io.TextIOBase):
    """Standard output that was closed before the program began: who writes to it hears so."""

    def write(self, text: str) -> int:
        raise OSError(errno.EBADF, "standard output is closed")

    def writable(self) -> bool:
        return True


def prepare() -> None:
    """Take the streams as they are: what they cannot encode is replaced, what a signal interrupts is written all the
    same, and the numbers of closed ones are taken, so that no file that is opened later becomes standard output.
    """
    while (number := os.open(os.devnull, os.O_RDWR)) < 3:
        pass
    os.close(number)
    if sys.stdin is None:
        sys.stdin = os.fdopen(0, encoding="utf-8")
    if sys.stdout is None:
        sys.stdout = _Closed()
    if sys.stderr is None:
        sys.stderr = os.fdopen(2, "w", encoding="utf-8")
    sys.stdout, sys.stderr = _buffered(sys.stdout), _buffered(sys.stderr)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _buffered(stream: Any) -> Any:
    """The stream with a buffer, if PYTHONUNBUFFERED took it: without one, Python loses the rest of a text when a signal
    interrupts its writing (limits ring a timer). Each line is still written at once.
    """
    if not (isinstance(stream, io.TextIOWrapper) and isinstance(stream.buffer, io.RawIOBase)):
        return stream
    encoding, raw = stream.encoding, stream.detach()
    return io.TextIOWrapper(io.BufferedWriter(raw), encoding=encoding, line_buffering=True)


def write(text: str) -> None:
    """Print a text as it is."""
    sys.stdout.write(text)


def flush() -> None:
    """Write what is buffered, as far as that is possible."""
    with suppress(OSError, ValueError):
        sys.stderr.flush()
    try:
        sys.stdout.flush()
    except (OSError, ValueError):
        silence()


def silence() -> None:
    """Let standard output go nowhere: what is still buffered has no reader, and the interpreter would complain of that
    when it closes the stream.
    """
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.close(nowhere)


def is_stdout(path: str) -> bool:
    """Whether a name means standard output: "-", or a file, pipe or terminal that standard output is too."""
    if path == STDOUT:
        return True
    with suppress(OSError, ValueError, AttributeError):
        return path != os.devnull and os.path.samestat(os.stat(path), os.fstat(sys.stdout.fileno()))
    return False
