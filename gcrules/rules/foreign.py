r"""Code that is not gcrules' own: every call of it goes through here, and what it does wrong is its own fault.

It may not end the program, nor write to standard output, which belongs to the answer, nor leave threads behind, nor
take longer than `SECONDS`, or wait longer than `WAITING`; what it gives is checked. This keeps mistakes apart from
answers, it does not keep out malice: plugins are code that the user trusts.
"""

from __future__ import annotations

import io
import os
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from contextvars import ContextVar
from pathlib import Path
from time import monotonic
from typing import Any

from gcrules.core import files, interrupts
from gcrules.core.alarm import ringing
from gcrules.core.budget import seconds_left, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, LimitReached

__all__ = ["SECONDS", "WAITING", "Guarded", "Misfit", "PluginFault", "foreign", "is_foreign", "place_of"]

SECONDS = 20.0
"""Seconds that one call may compute: its own, not those in which a busy machine runs something else. On the main thread
and where the system has timers.
"""
WAITING = 120.0
"""Seconds of real time that one call may take with all that it waits for. Off the main thread only what calls the
engine is stopped.
"""

_computed = getattr(time, "thread_time", time.process_time)  # browsers have one thread, and no clock for it
_AGAIN = 0.2  # seconds after which code that swallows the exception is stopped again
_LAST = 25  # times that it is; then the program ends
_PACKAGE = f"{Path(__file__).parent.parent}{os.sep}"
_LIBRARY = f"{Path(os.__file__).parent}{os.sep}"
_NAMED = 500  # characters of an error that are shown


class PluginFault(FileError):
    """What a plugin did wrong, with the plugin's own file and line."""


class Misfit(Exception):
    """What a plugin gave or left behind is not what it should be; the words say it."""


class _TooLong(BaseException):
    """So many seconds are up. No Exception, so that a plugin that catches those does not catch it."""


_inside: ContextVar[bool] = ContextVar("gcrules foreign code", default=False)


@contextmanager
def foreign(what: str, place: str) -> Iterator[None]:
    """Code of a plugin runs inside. `what` names what runs, `place` where it comes from.

    Raises PluginFault for all that it raises, KeyboardInterrupt and SystemExit too, unless it is the user who
    interrupts, or a limit of the caller's own that is reached.
    """
    if _inside.get():
        with _blamed(what, place):
            yield
        return
    token = _inside.set(True)
    try:
        with interrupts.hearing(), _blamed(what, place), ExitStack() as around:
            around.enter_context(_without_threads())
            around.enter_context(_stdout_elsewhere())
            around.enter_context(_timed(what, place))
            around.enter_context(within(WAITING))
            yield
    finally:
        _inside.reset(token)


@contextmanager
def _blamed(what: str, place: str) -> Iterator[None]:
    try:
        yield
    except PluginFault:
        raise
    except BaseException as fault:
        if isinstance(fault, KeyboardInterrupt) and interrupts.pending() is not None:
            raise
        if isinstance(fault, LimitReached) and seconds_left() <= 0:
            raise
        raise _fault(fault, what, place) from fault


def _fault(fault: BaseException, what: str, place: str) -> PluginFault:
    """The fault with the last line of the plugin's own that it passed through; `place` where there is none."""
    if isinstance(fault, SyntaxError) and fault.filename and _outside(fault.filename):
        return PluginFault(f"{what}: {fault.msg}", filename=f"{fault.filename}:{fault.lineno}")
    frames = [f for f in traceback.extract_tb(fault.__traceback__, limit=-200) if _outside(f.filename)]
    where = f"{frames[-1].filename}:{frames[-1].lineno}" if frames else place
    return PluginFault(f"{what}: {_words(fault)}", filename=where)


def _words(fault: BaseException) -> str:
    if isinstance(fault, _TooLong):
        return f"it does not end within {fault.args[0]:g} seconds"
    if isinstance(fault, Misfit):
        return str(fault)
    try:
        said = fault.message if isinstance(fault, GcrulesError) else str(fault)
    except BaseException:  # the error is the plugin's own class
        said = "(an error without a message)"
    kind = type(fault).__name__
    return f"{kind}: {said[:_NAMED]}" if said else kind


def _outside(filename: str) -> bool:
    """Whether a file is neither of the package (but plugins that are shipped inside it are) nor of Python itself."""
    if filename.startswith("<"):
        return False
    if filename.startswith(_PACKAGE):
        return filename.startswith(f"{_PACKAGE}_plugins")
    return not filename.startswith(_LIBRARY) or "-packages" in filename


# --- what it may not do --------------------------------------------------------------------------------------------


@contextmanager
def _without_threads() -> Iterator[None]:
    """Threads that go on are a fault: they would print later, and keep the program from ending. In other programs than
    gcrules' own they may be the user's.
    """
    before = set(threading.enumerate())
    yield
    left = [t.name for t in threading.enumerate() if t not in before] if interrupts.in_program() else []
    if left:
        raise Misfit(f"it leaves a thread running: {', '.join(sorted(left))}")


class _ToStderr(io.TextIOBase):
    """Standard output, for a plugin: what is printed is shown, but not among the answers; closing it does nothing."""

    @property
    def buffer(self) -> Any:
        return sys.stderr.buffer

    def write(self, text: str) -> int:
        return sys.stderr.write(text)

    def flush(self) -> None:
        sys.stderr.flush()

    def writable(self) -> bool:
        return True

    def close(self) -> None:
        """It is not the plugin's."""


@contextmanager
def _stdout_elsewhere() -> Iterator[None]:
    out, own = sys.stdout, sys.__stdout__
    kept = os.dup(1) if interrupts.in_program() else None
    sys.stdout = sys.__stdout__ = _ToStderr()  # type: ignore[assignment,misc]
    if kept is not None:
        os.dup2(2, 1)
    try:
        yield
    finally:
        if kept is not None:
            os.dup2(kept, 1)
            os.close(kept)
        sys.stdout, sys.__stdout__ = out, own  # type: ignore[misc]


@contextmanager
def _timed(what: str, place: str) -> Iterator[None]:
    """Raise _TooLong inside when its time is up, and again until it is left."""
    rung = 0
    before, began = _computed(), monotonic()

    def ring(frame: Any) -> None:
        nonlocal rung
        late = monotonic() - began >= WAITING
        if not late and _computed() - before < SECONDS:
            return
        rung += 1
        over = _TooLong(WAITING if late else SECONDS)
        if rung > _LAST and interrupts.in_program():
            fault = _fault(over, what, f"{frame.f_code.co_filename}:{frame.f_lineno}")
            os.write(2, f"{fault.render()}\n".encode("utf-8", "replace"))
            files.remove_unfinished()
            os._exit(fault.exit_code)
        raise over

    with ringing(ring, min(SECONDS, WAITING), _AGAIN):
        yield


# --- functions of plugins ------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Guarded:
    """A function of a plugin's rule. It gives what `check` makes of its result, such as all that an iterator yields;
    `check` raises Misfit for what it should not give.
    """

    function: Callable[..., Any]
    check: Callable[[Any], Any]
    what: str
    place: str

    def __call__(self, *args: Any) -> Any:
        with foreign(self.what, self.place):
            return self.check(self.function(*args))


def place_of(function: Any, otherwise: str) -> str:
    """The file and line of a function that is not of the engine."""
    own = function.function if isinstance(function, Guarded) else function
    code = getattr(own, "__code__", None)
    return f"{code.co_filename}:{code.co_firstlineno}" if code is not None and _outside(code.co_filename) else otherwise


def is_foreign(function: Any) -> bool:
    """Whether a function, or a class, is not of the engine."""
    return not (getattr(function, "__module__", None) or "").startswith("gcrules.")
