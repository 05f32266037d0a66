"""Running one command line, or one call, in this process, and what came of it."""

from __future__ import annotations

import io
import os
import resource
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, replace
from time import monotonic, process_time, sleep
from types import FrameType
from typing import Any

from .case import Case
from .jail import Jail

__all__ = ["GRACE", "Hang", "Outcome", "last_frame", "limit_memory", "run_call", "run_command", "timed"]

GRACE = 20.0
"""Seconds that an input may use beyond those that it was given."""

MEMORY = 4 * 2**30

Around = Callable[[], AbstractContextManager[Any]]


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


def last_frame(fault: BaseException | None) -> str:
    """Type of a fault, and the last place in gcrules where it was: `ValueError at gcrules/…/legs_text.py:read_legs`."""
    if fault is None:
        return ""
    frames = [f for f in traceback.extract_tb(fault.__traceback__) if "/gcrules/" in f.filename]
    if not frames:
        frames = traceback.extract_tb(fault.__traceback__)[-1:]
        return f"{type(fault).__name__} at {os.path.basename(frames[0].filename)}:{frames[0].name}"
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


def run_command(case: Case, jail: Jail, *, around: Around = nullcontext) -> Outcome:
    """Run `gcrules ARGV` with standard streams of its own, as the entry point does, but the process goes on after it;
    `around` surrounds it.
    """
    from gcrules.apps import cli
    from gcrules.core import files, interrupts, streams

    def program() -> int:
        streams.prepare()
        return cli.answered()

    def body() -> tuple[str, ...]:
        with around():
            code = interrupts.run(program)
        interrupts.ignore()
        files.remove_unfinished()
        streams.flush()
        raise SystemExit(code)

    internal: list[str] = []
    print_exception = traceback.print_exception

    def seen(*args: Any, **kwargs: Any) -> None:
        internal.append(last_frame(sys.exception()))
        print_exception(*args, **kwargs)

    argv, sys.argv = sys.argv, ["gcrules", *case.argv]
    silence, streams.silence = streams.silence, lambda: None  # standard output is no file here
    hook = sys.unraisablehook
    traceback.print_exception = seen  # the entry point shows its own faults so
    try:
        return _with_fault(_watched(case, jail, body), internal)
    finally:
        traceback.print_exception = print_exception
        sys.unraisablehook = hook
        streams.silence = silence
        sys.argv = argv


def _with_fault(found: Outcome, internal: list[str]) -> Outcome:
    return replace(found, frame=internal[0], trace=found.stderr) if internal else found


def _forget_signals() -> None:
    """Let the next program hear signals as the first one did, when nothing reminds of this one's any more."""
    from gcrules.core import interrupts

    until = monotonic() + 5
    while interrupts._heard.reminding and monotonic() < until:
        sleep(0.001)
    interrupts._heard = interrupts._Signals()
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, 0)  # one that a process would take with it to its end


def run_call(case: Case, jail: Jail, call: Callable[[], Sequence[str]]) -> Outcome:
    """Call Python: gcrules' own errors are answers; anything that is printed is not. `call` returns what is wrong."""
    from gcrules.core.errors import GcrulesError

    def body() -> tuple[str, ...]:
        try:
            return tuple(call())
        except GcrulesError as fault:
            fault.render(), str(fault)
            raise SystemExit(fault.exit_code) from None

    found = _watched(case, jail, body)
    printed = tuple(f"something is printed: {text[:80]}" for text in (found.stdout, found.stderr) if text)
    return replace(found, stdout="", stderr="", noise=(*found.noise, *printed))


def _watched(case: Case, jail: Jail, body: Callable[[], tuple[str, ...]]) -> Outcome:
    """Run something with the files and standard input of a case, in its time, and see what it does."""
    jail.fill(case.files)
    out, err = io.BytesIO(), io.BytesIO()
    streams = (sys.stdin, sys.stdout, sys.stderr)
    given = io.BytesIO(case.stdin.encode("utf-8", "surrogateescape"))
    ours = tuple(io.TextIOWrapper(b, encoding="utf-8", write_through=True) for b in (given, out, err))
    handlers = {n: signal.getsignal(n) for n in (signal.SIGINT, signal.SIGTERM)}
    code: int | None = None
    wrong: tuple[str, ...] = ()
    trace = frame = ""
    threads = set(threading.enumerate())
    began = process_time()
    with warnings.catch_warnings(record=True) as caught, jail.closed() as tried:
        warnings.simplefilter("always", RuntimeWarning)
        warnings.simplefilter("ignore", DeprecationWarning)
        warnings.simplefilter("ignore", PendingDeprecationWarning)
        sys.stdin, sys.stdout, sys.stderr = ours  # held here too: they close what they write to when they go
        try:
            with timed(case.seconds + GRACE):
                wrong = body()
        except SystemExit as end:
            code = end.code if isinstance(end.code, int) else 0 if end.code is None else 1
        except Hang as fault:
            trace, frame = traceback.format_exc(), f"hang in {last_frame(fault).removeprefix('Hang at ')}"
        except BaseException as fault:
            trace, frame = traceback.format_exc(), last_frame(fault)
        finally:
            sys.stdin, sys.stdout, sys.stderr = streams
            _forget_signals()
            for number, handler in handlers.items():
                signal.signal(number, handler)
    noise = [f"{w.category.__name__}: {w.message} at {w.filename.split('/gcrules/')[-1]}" for w in caught]
    noise += [f"{t} outside the folder" for t in tried]
    noise += [f"a thread goes on: {t.name}" for t in threading.enumerate() if t not in threads]
    stdout, stderr = (b.getvalue().decode("utf-8", "replace") for b in (out, err))
    left, seconds = tuple(jail.changes()), process_time() - began
    return Outcome(code, stdout, stderr, trace, frame, left, tuple(noise), wrong, seconds)
