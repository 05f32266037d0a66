"""Reading what a command is given, writing what it makes, and saying that it still works."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import click

from gcrules.errors import FileError

__all__ = ["Status", "read_stdin", "working", "write_file"]

MAX_STDIN = 4_000_000
_PATIENCE = 1.0  # seconds before progress is shown


def read_stdin() -> str:
    """All of standard input as UTF-8 text. Raises FileError where it is too long or no text."""
    data: bytes = sys.stdin.buffer.read(MAX_STDIN + 1)
    if len(data) > MAX_STDIN:
        raise FileError(f"the input is larger than {MAX_STDIN:,} bytes", filename="<stdin>")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise FileError(f"this is not text in UTF-8 (byte {fault.start + 1})", filename="<stdin>") from None


def write_file(path: str, text: str) -> None:
    """Write a file by way of a temporary one, so that it appears complete or not at all; "-" is standard output.

    Raises FileError where that is not possible.
    """
    if path == "-":
        click.echo(text, nl=False)
        return
    target = os.path.realpath(path)
    if os.path.isdir(target):
        raise FileError("this is a directory, expected the name of a file", filename=path)
    folder, name = os.path.split(target)
    if not os.path.isdir(folder):
        raise FileError("cannot be written: there is no such directory", filename=path)
    try:
        if os.path.exists(target) and not os.path.isfile(target):  # a device or pipe
            with open(target, "w", encoding="utf-8") as file:
                file.write(text)
            return
        if os.path.exists(target) and not os.access(target, os.W_OK):
            raise FileError("cannot be written: the file is write-protected", filename=path)
        _replace(target, os.path.join(folder, f".{name}.{os.getpid()}"), text)
    except OSError as fault:
        raise FileError(f"cannot be written: {fault.strerror or fault}", filename=path) from None


def _replace(target: str, temporary: str, text: str) -> None:
    try:
        with open(temporary, "x", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.replace(temporary, target)
    except BaseException:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise


class Status:
    """What a long command is doing just now; set `text` as often as you like."""

    def __init__(self, text: str) -> None:
        self.text = text


@contextmanager
def working(text: str) -> Iterator[Status]:
    """Show on a terminal's standard error what goes on, from the first second on; leaves no trace when done."""
    status = Status(text)
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
