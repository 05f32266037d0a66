"""A worker process: takes one job after the other from its standard input, and can be ended at any time."""

from __future__ import annotations

import os
import re
import sys
import threading
import traceback
from collections.abc import Callable, Iterator
from importlib import import_module
from itertools import islice
from queue import SimpleQueue
from time import monotonic, sleep
from typing import Any, BinaryIO

from gcrules.apps.studio.answers import answer, loading
from gcrules.apps.studio.faults import fault_view, limit, own_fault
from gcrules.apps.studio.parts import given_to
from gcrules.apps.studio.protocol.messages import Part, Told
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.subject import Subject, read_subject
from gcrules.apps.studio.wire import GIVE_UP, Job, Tell, framed, key_of, read
from gcrules.core.alarm import limited
from gcrules.core.budget import Budget, report, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, absent

__all__ = ["done", "serve"]

_KEPT = 8
_PACE = 0.05  # seconds between two words of progress, of which a search has thousands
_NUMBERS = re.compile(r"[\d.,]+")
_LOOK = 1.0  # seconds between two looks whether the server is there


def done(
    job: Job, known: dict[str, Subject], tell: Tell, begun: Callable[[Budget], None] = lambda _: None
) -> tuple[str, Any, Subject | None]:
    """What came of a job: ("done", result, subject) or ("fault", fault, None). `known` are subjects of earlier ones,
    `tell` hears how far it is and the parts of the result, `begun` is given the budget by which it can be given up.
    """
    name, args, subject = job
    try:
        seconds = METHODS["open" if name == "subject" else name].seconds
        with within(progress=tell) as budget, limited(seconds), given_to(lambda part: tell(Part(part))):
            begun(budget)
            source = args.get("source")
            if source is not None:
                subject = _subject(source, subject, known)
            result = None if name == "subject" else answer(name, subject, args)
            return "done", result, subject
    except GcrulesError as fault:
        return "fault", fault_view(fault), None
    except MemoryError:
        return "fault", limit("there is not enough memory for this", "try something smaller"), None
    except RecursionError:
        return "fault", limit("this is nested too deeply", "try something smaller"), None
    except ModuleNotFoundError as fault:
        return "fault", fault_view(absent(fault)), None
    except Exception as fault:
        traceback.print_exc()
        return "fault", own_fault(f"{type(fault).__name__}: {fault}"), None


def _subject(source: Any, given: Subject | None, known: dict[str, Subject]) -> Subject:
    """A subject that was used before has more of itself worked out than one that was just sent."""
    key = key_of(source)
    found = known.pop(key, None) or given
    if found is None:
        report("analysing")
        found = read_subject(source)
    known[key] = found
    while len(known) > _KEPT:
        known.pop(next(iter(known)))
    return found


def _watch(server: int) -> None:
    """End in the middle of work too when the server has gone without a word."""
    while os.getppid() == server:
        sleep(_LOOK)
    os._exit(0)


@dataclass(eq=False)
class _Task:
    """A job that was sent, which may be given up before it begins and after it ended, too."""

    job: Job
    budget: Budget | None = None
    given_up: bool = False

    def begin(self, budget: Budget) -> None:
        self.budget = budget
        if self.given_up:
            budget.cancel()

    def give_up(self) -> None:
        self.given_up = True
        if self.budget is not None:
            self.budget.cancel()


def _receive(pipe: BinaryIO, tasks: SimpleQueue[_Task | None]) -> None:
    """Take in what the server sends, also amid work; None at the end."""
    last: _Task | None = None
    while True:
        try:
            frame = read(pipe)
        except (EOFError, OSError):
            tasks.put(None)
            return
        if frame is not GIVE_UP:
            tasks.put(last := _Task(frame))
        elif last is not None:
            last.give_up()


def _next(tasks: SimpleQueue[_Task | None], loads: Iterator[None]) -> _Task | None:
    """The next task. While there is none, what will answer is loaded."""
    while tasks.empty() and any(True for _ in islice(loads, 1)):
        pass
    return tasks.get()


def _loads() -> Iterator[None]:
    """All that answers, and then what the first map of a robot would wait for half a second."""
    yield from loading()
    import_module("sympy")
    yield


def serve() -> None:
    """Work until the server is gone."""
    threading.Thread(target=_watch, args=(os.getppid(),), daemon=True).start()
    inward, outward = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # nothing but frames goes to the server
    sys.stdout = sys.stderr
    known: dict[str, Subject] = {}

    def put(frame: Any) -> None:
        outward.write(framed(frame))
        outward.flush()

    told, stage = 0.0, ""

    def tell(what: Told) -> None:
        """Parts, and what is new, at once; how far it is now and then."""
        nonlocal told, stage
        if isinstance(what, str):
            now = _NUMBERS.sub("", what)
            if now == stage and monotonic() - told < _PACE:
                return
            told, stage = monotonic(), now
        put(("told", what, None))

    tasks: SimpleQueue[_Task | None] = SimpleQueue()
    threading.Thread(target=_receive, args=(inward, tasks), daemon=True).start()
    loads = _loads()
    while (task := _next(tasks, loads)) is not None:
        put(done(task.job, known, tell, task.begin))


if __name__ == "__main__":
    try:
        serve()
    except (KeyboardInterrupt, BrokenPipeError):
        sys.exit(0)
