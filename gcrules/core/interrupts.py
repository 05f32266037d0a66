"""Signals that end the program: Ctrl-C, a request to terminate, a terminal that was closed.

Each is a KeyboardInterrupt where it arrives, and nothing can lose it: raised where Python only prints exceptions (in a
destructor, in a callback of a library), swallowed by code that catches everything, or turned into another error (by the
import of a library), it is raised again after a moment, until `run` or a prompt has seen it.
"""

from __future__ import annotations

import _thread
import gc
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from time import monotonic, sleep

TYPE_CHECKING = False  # typing takes ten milliseconds in which no signal is heard yet
if TYPE_CHECKING:
    from sys import UnraisableHookArgs
    from types import FrameType
    from typing import Any

__all__ = [
    "Terminated",
    "deferred",
    "go_on",
    "hearing",
    "ignore",
    "in_program",
    "interruptible",
    "pending",
    "run",
    "settle",
]


class Terminated(KeyboardInterrupt):
    """The program is asked to end; unlike Ctrl-C at a prompt nothing goes on after it."""


_KINDS = {
    getattr(signal, name): kind
    for name, kind in (("SIGINT", KeyboardInterrupt), ("SIGTERM", Terminated), ("SIGHUP", Terminated))
    if hasattr(signal, name)
}
_PAUSE = 0.5  # seconds for leaving what runs, before the exception is raised again
_LOOK = 0.02


class _Signals:
    """What this process has heard. Signals are the process's own, so there is one such value."""

    number: int | None = None
    """The signal that nobody has dealt with."""
    armed = False
    """Whether a signal raises; else it is noted."""
    deferred = 0
    """Within how many blocks it waits."""
    silent_until = 0.0
    """What was raised has so long to reach those who wait for it."""
    reminding = False
    program = False
    settled = False
    """Whether the program's answer is given, so that no signal changes it."""
    ended = False
    """Whether signals have no handlers any more."""


_heard = _Signals()


def pending() -> int | None:
    """The number of the signal that the program is to end for, None where there was none."""
    return _heard.number


def _hear(number: int, frame: FrameType | None) -> None:
    if _heard.settled:
        return
    if _heard.number in (None, signal.SIGINT):  # a request to end counts even where Ctrl-C would be forgiven
        _heard.number = number
    if not _heard.armed:
        return
    if not _heard.reminding:
        _heard.reminding = True
        _thread.start_new_thread(_remind, (_thread.get_ident(),))  # no lock of `threading`, which may be held here
    if not _heard.deferred and monotonic() >= _heard.silent_until:
        _raise()


def _raise() -> None:
    if _heard.number is not None:
        _heard.silent_until = monotonic() + _PAUSE
        raise _KINDS[signal.Signals(_heard.number)]


def _remind(main: int) -> None:
    """Send the signal again until it is dealt with."""
    while _heard.reminding:
        while _heard.armed and (number := _heard.number) is not None:
            if not _heard.deferred and monotonic() >= _heard.silent_until:
                _send(main, number)
            sleep(_LOOK)
        _heard.reminding = False
        _heard.reminding = _heard.armed and _heard.number is not None  # one that came just now


def _send(thread: int, number: int) -> None:
    if sys.platform == "win32":
        _thread.interrupt_main(number)
    else:
        signal.pthread_kill(thread, number)  # ends system calls as well


def _unraisable(ignored: UnraisableHookArgs, /) -> None:
    """An interrupt where Python only prints exceptions is raised again soon; what else is said there meanwhile are
    complaints of destructors about what the interrupt left half made.
    """
    if _heard.number is not None:
        if issubclass(ignored.exc_type, KeyboardInterrupt):
            _heard.silent_until = 0.0
    elif _heard.ended and ignored.exc_type is OSError and ignored.object is None:
        pass  # Python says that a signal came in the moment in which its handler was taken away
    else:
        sys.__unraisablehook__(ignored)


def _listen(numbers: Iterable[int]) -> dict[int, Any] | None:
    """Hear signals from now on, except those that are ignored, as under nohup; the handlers before, None where this is
    not the main thread.
    """
    before = {n: signal.getsignal(n) for n in numbers}
    own = {n: h for n, h in before.items() if h in (signal.SIG_DFL, signal.default_int_handler)}
    try:
        for number in own:
            signal.signal(number, _hear)
    except ValueError:
        return None
    return own


def run(program: Callable[[], int]) -> int:
    """The exit code of a whole program: what it returns, or 128 and the number of the signal that ended it.

    Whatever the program makes of a signal, it counts. What comes later is noted only: call `ignore`, and exit.
    """
    code = 128 + signal.SIGINT
    try:
        try:
            _listen(_KINDS)
            sys.unraisablehook = _unraisable
            _heard.armed = _heard.program = True
            _heard.settled = False
            _raise()  # what came since the handlers are there
            code = program()
        finally:
            _heard.armed = False
    except KeyboardInterrupt:
        _heard.armed = False
    return code if _heard.number is None else 128 + _heard.number


def settle() -> None:
    """From here on the program's answer stands: a signal that comes later is too late. Raises for one that came before.

    Without effect in the process of somebody who imports gcrules.
    """
    if _heard.program:
        _heard.settled = _heard.number is None
        _raise()


def ignore() -> None:
    """The answer is given and nothing can be interrupted any more, not the end of the interpreter either."""
    _heard.ended = True
    for number in _KINDS:
        signal.signal(number, signal.SIG_IGN)


@contextmanager
def interruptible() -> Iterator[None]:
    """Within it, a KeyboardInterrupt reaches the computation even if it was raised in a destructor or callback.

    What a prompt leaves behind (its event loop has a destructor) is collected before the computation, so that this is
    rare.
    """
    with hearing():
        gc.collect()
        yield


def go_on() -> None:
    """Go on after Ctrl-C, at a prompt. Raises Terminated where the program is asked to end."""
    if _heard.number not in (None, signal.SIGINT):
        raise Terminated
    _heard.number = None
    _heard.silent_until = 0.0


@contextmanager
def deferred() -> Iterator[None]:
    """Signals wait until the block is left. For moments only, and for what hears signals by itself."""
    _heard.deferred += 1
    try:
        yield
    finally:
        _heard.deferred -= 1
    if _heard.armed and not _heard.deferred:
        _raise()


def in_program() -> bool:
    """Whether `run` runs: the process is gcrules' own, not that of somebody who imports it."""
    return _heard.program


@contextmanager
def hearing() -> Iterator[None]:
    """Within it, `pending` tells an interrupt of the user's from a KeyboardInterrupt that some code raises."""
    before = None if _heard.armed else _listen([signal.SIGINT])
    if before is None:
        yield
        return
    hook = sys.unraisablehook
    sys.unraisablehook = lambda ignored: (_unraisable if _heard.number is not None else hook)(ignored)
    _heard.armed = True
    try:
        yield
    finally:
        _heard.armed, _heard.number, _heard.silent_until = False, None, 0.0
        sys.unraisablehook = hook
        for number, handler in before.items():
            signal.signal(number, handler)
