"""Reading what a command is given, and saying that it still works."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import click

from gcrules.core.budget import waiting
from gcrules.errors import FileError

__all__ = ["Status", "read_stdin", "working"]

MAX_STDIN = 4_000_000
_PATIENCE = 1.0  # seconds before progress is shown


def read_stdin() -> str:
    """All of standard input as UTF-8 text. Raises FileError where it is too long or no text."""
    with waiting():
        data: bytes = sys.stdin.buffer.read(MAX_STDIN + 1)
    if len(data) > MAX_STDIN:
        raise FileError(f"the input is larger than {MAX_STDIN:,} bytes", filename="<stdin>")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise FileError(f"this is not text in UTF-8 (byte {fault.start + 1})", filename="<stdin>") from None


class Status:
    """What a long command is doing just now."""

    def __init__(self, task: str) -> None:
        self.task = self.text = task

    def tell(self, done: str) -> None:
        """How far it is; as often as you like."""
        self.text = f"{self.task}: {done}"


@contextmanager
def working(task: str) -> Iterator[Status]:
    """Show on a terminal's standard error what goes on, from the first second on; leaves no trace when done."""
    status = Status(task)
    if not sys.stderr.isatty():
        yield status
        return
    done = threading.Event()

    def show() -> None:
        seconds = _PATIENCE
        while not done.wait(_PATIENCE):
            click.echo(f"\r\x1b[K{status.text} … {seconds:.0f} s", err=True, nl=False, color=True)
            seconds += _PATIENCE
        if seconds > _PATIENCE:
            click.echo("\r\x1b[K", err=True, nl=False, color=True)

    thread = threading.Thread(target=show, daemon=True)
    thread.start()
    try:
        yield status
    finally:
        done.set()
        thread.join()
