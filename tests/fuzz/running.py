"""Running one command line in this process, as `gcrules` itself runs it, and what came of it."""

from __future__ import annotations

import io
import resource
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from time import process_time
from types import FrameType
from typing import Any

from .case import Case
from .jail import Jail

__all__ = ["GRACE", "Hang", "Outcome", "last_frame", "limit_memory", "run_command", "timed"]

GRACE = 20.0
"""Seconds that an input may use beyond those that it was given."""

MEMORY = 4 * 2**30


class Hang(BaseException):
    """The input used more time than it was given."""


@dataclass(frozen=True)
class Outcome:
    """`code` is the exit code, or None for what is no command; `trace` the traceback of a fault of gcrules itself.

    `left` are files that were made or changed, `noise` what else must not be: warnings, threads, writing elsewhere;
    `wrong` are words of an oracle of the family's own.
    """

    code: int | None = None
    stdout: str = ""
    stderr: str = ""
    trace: str = ""
    frame: str = ""
    left: tuple[str, ...] = ()
    noise: tuple[str, ...] = ()
    wrong: tuple[str, ...] = ()
    seconds: float = 0.0


def limit_memory(size: int = MEMORY) -> None:
    """Let this process have no more than so many bytes of addresses."""
    resource.setrlimit(resource.RLIMIT_AS, (size, size))


def last_frame(fault: BaseException) -> str:
    """Type of a fault, and the last place in gcrules where it was: `ValueError at gcrules/legs.py:read_legs`."""
    frames = [f for f in traceback.extract_tb(fault.__traceback__) if "/gcrules/" in f.filename]
    if not frames:
        return type(fault).__name__
    last = frames[-1]
    return f"{type(fault).__name__} at gcrules/{last.filename.split('/gcrules/')[-1]}:{last.name}"


@contextmanager
def timed(seconds: float) -> Iterator[None]:
    """Raise Hang after so many seconds of the processor: the load of the machine does not count."""

    def over(number: int, frame: FrameType | None) -> None:
        raise Hang

    before = signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, seconds, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def run_command(case: Case, jail: Jail, *, around: Callable[[], Any] | None = None) -> Outcome:
    """Run `gcrules ARGV` by its entry point, with standard streams of its own.

    `around` is called with the entry point's own frame about to begin (to arrange for an interrupt).
    """
    from gcrules import cli

    jail.fill(case.files)
    streams, argv, handlers = (sys.stdin, sys.stdout, sys.stderr), sys.argv, _handlers()
    data = io.BytesIO(case.stdin.encode("utf-8", "surrogateescape"))
    out, err = io.BytesIO(), io.BytesIO()
    ours = tuple(io.TextIOWrapper(b, encoding="utf-8", write_through=True) for b in (data, out, err))
    sys.stdin, sys.stdout, sys.stderr = ours  # held here too, for they close what they write to when they go
    sys.argv = ["gcrules", *case.argv]
    code: int | None = None
    noise: list[str] = []
    trace = frame = ""
    began = process_time()
    internal, print_exc = [], traceback.print_exc

    def seen(*args: Any, **kwargs: Any) -> None:
        internal.append(last_frame(sys.exception()))  # type: ignore[arg-type]
        print_exc(*args, **kwargs)

    with warnings.catch_warnings(record=True) as caught, jail.closed() as tried:
        warnings.simplefilter("always", RuntimeWarning)
        warnings.simplefilter("ignore", DeprecationWarning)
        warnings.simplefilter("ignore", PendingDeprecationWarning)
        traceback.print_exc = seen
        try:
            with timed(case.seconds + GRACE):
                if around:
                    around()
                cli.main()
        except SystemExit as end:
            code = end.code if isinstance(end.code, int) else 0 if end.code is None else 1
        except Hang as fault:
            trace, frame = "hang", f"hang in {last_frame(fault).removeprefix('Hang at ')}"
        except BaseException as fault:
            trace, frame = traceback.format_exc(), last_frame(fault)
        finally:
            traceback.print_exc = print_exc
            sys.stdin, sys.stdout, sys.stderr = streams
            sys.argv = argv
            for number, handler in handlers.items():
                signal.signal(number, handler)
    if internal:
        frame = internal[0]
        trace = err.getvalue().decode("utf-8", "replace")
    noise += [f"{w.category.__name__}: {w.message} at {w.filename.split('/gcrules/')[-1]}" for w in caught]
    noise += [f"{t} outside the folder" for t in tried]
    noise += [f"a thread goes on: {t.name}" for t in threading.enumerate() if t is not threading.main_thread()]
    return Outcome(
        code,
        out.getvalue().decode("utf-8", "replace"),
        err.getvalue().decode("utf-8", "replace"),
        trace,
        frame,
        tuple(jail.changes()),
        tuple(noise),
        (),
        process_time() - began,
    )


def _handlers() -> dict[int, Any]:
    return {n: signal.getsignal(n) for n in (signal.SIGINT, signal.SIGTERM)}
