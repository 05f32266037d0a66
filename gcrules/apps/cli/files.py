"""What a command reads and writes, and saying that it still works."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from typing import Any

import click

from gcrules.core import streams
from gcrules.core.budget import waiting, within
from gcrules.core.errors import FileError, InputError
from gcrules.core.files import check_name, check_target, held

__all__ = [
    "ANSWERED",
    "OutputCommand",
    "OutputFile",
    "Status",
    "certificate_option",
    "files_option",
    "printed",
    "read_stdin",
    "working",
]

_Command = Callable[..., Any]

MAX_STDIN = 4_000_000
_PATIENCE = 1.0  # seconds before progress is shown
ANSWERED = (0, 1)
"""Exit codes with which output files are written."""


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
    """Show on a terminal's standard error what is reported, from the first second on; leaves no trace when
    done.
    """
    status = Status(task)
    with within(progress=status.tell), _shown(status) if sys.stderr.isatty() else nullcontext():
        yield status


@contextmanager
def _shown(status: Status) -> Iterator[None]:
    """On the line where the cursor stands, and gone in the end."""
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
        yield
    finally:
        done.set()
        thread.join()


# --- output files --------------------------------------------------------------------------------------------------


class OutputFile(click.types.StringParamType):
    """The name of a file that a command writes; "-" is standard output.

    `suffixes` are the endings that files of this `noun` may have, all where there are none. With `alone` it may be
    printed instead of the answer.
    """

    name = "file"

    def __init__(self, *suffixes: str, alone: bool = False, noun: str = "figure") -> None:
        self.suffixes = suffixes
        self.alone = alone
        self.noun = noun

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Raises FileError where no such file can be written, InputError for another suffix."""
        suffix = os.path.splitext(value)[1].lower()
        check_name(value)
        if self.suffixes and suffix not in self.suffixes and os.path.basename(value).lower() not in self.suffixes:
            found = f"the suffix {suffix!r}" if suffix else "a name without suffix"
            endings = " or ".join(self.suffixes)
            raise InputError(
                f"{value}: {found} is not a {self.noun} format", hint=f"{self.noun}s are written as {endings}"
            )
        check_target(value)
        return value


def files_option(words: str) -> Callable[[_Command], _Command]:
    """-o FILE, as often as one likes; the command receives `outputs`."""
    return click.option("-o", "--output", "outputs", type=OutputFile(), multiple=True, metavar="FILE", help=words)


figure_option = click.option(
    "--figure",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE",
    help="Draw the robot, or the graph of legs without coordinates: .svg or .pdf.",
)


def certificate_option(words: str) -> Callable[[_Command], _Command]:
    """--certificate FILE.json, for what another program recomputes."""
    kind = OutputFile(".json", ".gz", noun="certificate")
    return click.option("--certificate", type=kind, metavar="FILE.json", help=words)


class OutputCommand(click.Command):
    """A command whose output files appear together, when its answer is printed, and only with exit code 0 or 1."""

    def invoke(self, ctx: click.Context) -> Any:
        _check_outputs(ctx)
        end: click.exceptions.Exit | None = None
        result: Any = None
        with held():
            try:
                with printed():
                    result = super().invoke(ctx)
            except click.exceptions.Exit as exit:
                if exit.exit_code not in ANSWERED:
                    raise
                end = exit
        if end is not None:
            raise end
        return result


@contextmanager
def printed() -> Iterator[None]:
    """What is printed within has reached standard output when the block ends, with an exit code too."""
    try:
        yield
    except click.exceptions.Exit:
        sys.stdout.flush()
        raise
    sys.stdout.flush()


def _check_outputs(ctx: click.Context) -> None:
    """Raises UsageError for two outputs of one name or on standard output, and where an input would be lost."""
    outputs: dict[object, tuple[str, str]] = {}
    answer = ctx.params.get("path")
    form = next((f"--{f}" for f in ("json", "latex") if ctx.params.get(f"as_{f}")), None)
    for param in ctx.command.params:
        if not isinstance(param.type, OutputFile):
            continue
        for name in _names(ctx.params.get(param.name or "")):
            option = param.opts[-1]
            if streams.is_stdout(name) and param.name != "path" and answer is None:
                if not param.type.alone:
                    raise click.UsageError(f"{option} {name} goes to standard output, and so does the answer.")
                if form:
                    raise click.UsageError(f"{option} {name} and {form} cannot both go to standard output.")
            if (key := _identity(name)) in outputs:
                other, first = outputs[key]
                raise click.UsageError(f"{other} {first} and {option} {name} are one file.")
            outputs[key] = option, name
    for param in ctx.command.params:
        if param.name and not isinstance(param.type, OutputFile):
            for name in filter(os.path.isfile, _names(ctx.params.get(param.name))):
                if found := outputs.get(_identity(name)):
                    raise click.UsageError(f"{found[0]} {found[1]} would overwrite what is read.")


def _names(value: object) -> tuple[str, ...]:
    """The texts among what a parameter was given."""
    values = value if isinstance(value, tuple) else (value,)
    return tuple(v for v in values if isinstance(v, str))


def _identity(path: str) -> object:
    """The same for all names of one file; nothing is lost in the null device."""
    if path == os.devnull:
        return object()
    if streams.is_stdout(path):
        return streams.STDOUT
    with suppress(OSError):
        found = os.stat(path)
        return found.st_dev, found.st_ino
    return os.path.realpath(path)
