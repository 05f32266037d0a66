"""Worker processes: started when they are needed, ended when nobody waits for their answer any more.

What they print is not shown; with GCRULES_STUDIO_DEBUG set it is.
"""

from __future__ import annotations

import asyncio
import os
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process
from time import monotonic
from typing import Any

from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.wire import Job, Tell, framed, read_frame
from gcrules.core.errors import EngineFault, GcrulesError, LimitReached
from gcrules.core.threads import with_one_thread

__all__ = ["Pool", "WorkerFault"]

_GONE = (asyncio.IncompleteReadError, ConnectionError)  # what is seen of a worker that has ended
_STILL = 1.0  # seconds after which it is said that work goes on, and for how long it has
_LATE = 5.0
_MOST = 16_000_000  # bytes of an answer that are taken in at once


class WorkerFault(GcrulesError):
    """A fault that a worker has put into words already."""

    def __init__(self, view: FaultView) -> None:
        super().__init__(view["message"])
        self.view = view


class Pool:
    """At most `size` workers; one is kept ready. They have `late` seconds to notice by themselves that time is over."""

    def __init__(self, size: int | None = None, *, late: float = _LATE) -> None:
        self.late = late
        self.free = asyncio.Semaphore(size or min(4, max(2, os.cpu_count() or 2)))
        self.idle: list[Process] = []
        self.all: set[Process] = set()
        self.starting: set[asyncio.Task[None]] = set()

    async def run(self, job: Job, seconds: float, tell: Tell) -> tuple[Any, Any]:
        """The result of a job, and its subject. Raises WorkerFault for faults, LimitReached after so many seconds (a
        little later where the worker does not notice it).

        Where the task is cancelled the worker is ended. A worker that something else has ended, waiting or at work, is
        no fault of the job: it is tried once more, in a fresh one. Raises EngineFault where that ends too.
        """
        async with self.free:
            try:
                async with asyncio.timeout(seconds + self.late):
                    try:
                        kind, value, subject = await self._done(job, tell)
                    except _GONE:
                        kind, value, subject = await self._done(job, tell, fresh=True)
            except TimeoutError:
                raise LimitReached(
                    f"no answer within {seconds:g} seconds", hint="the command line gives it more time with --seconds"
                ) from None
            except _GONE:
                raise EngineFault("the worker has ended by itself, twice") from None
        if kind == "fault":
            raise WorkerFault(value)
        return value, subject

    async def _done(self, job: Job, tell: Tell, *, fresh: bool = False) -> Any:
        """What a worker makes of a job; it is ended where that is nothing."""
        process = self.idle.pop() if self.idle and not fresh else await self._start()
        try:
            found = await _answer(process, job, tell)
        except BaseException:
            self._end(process)
            raise
        self.idle.append(process)
        return found

    def ready(self) -> None:
        """Have a worker ready before it is asked for."""
        task = asyncio.ensure_future(self._add())
        self.starting.add(task)
        task.add_done_callback(self.starting.discard)

    async def _add(self) -> None:
        if not self.idle:
            self.idle.append(await self._start())

    async def _start(self) -> Process:
        environment = dict(os.environ)
        with_one_thread(environment)
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-m", "gcrules.apps.studio.worker",
            stdin=PIPE, stdout=PIPE, stderr=None if _DEBUG else DEVNULL,
            env=environment, limit=_MOST, start_new_session=True,
        )  # fmt: skip
        self.all.add(process)
        return process

    def _end(self, process: Process) -> None:
        self.all.discard(process)
        if process.returncode is None:
            process.kill()
        self.ready()

    async def close(self) -> None:
        """End all workers."""
        for task in self.starting:
            task.cancel()
        for process in self.all:
            if process.returncode is None:
                process.kill()
        await asyncio.gather(*(p.wait() for p in self.all))
        self.all.clear()
        self.idle.clear()


_DEBUG = "GCRULES_STUDIO_DEBUG" in os.environ


async def _answer(process: Process, job: Job, tell: Tell) -> Any:
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(framed(job))
    await process.stdin.drain()
    start, words = monotonic(), "working"

    def told() -> str:
        gone = monotonic() - start
        return words if gone < _STILL else f"{words}, {gone:.0f} s"

    frame = asyncio.ensure_future(read_frame(process.stdout))
    try:
        while True:
            finished, _ = await asyncio.wait([frame], timeout=_STILL)
            if not finished:
                tell(told())
                continue
            found = frame.result()
            if found[0] != "progress":
                return found
            words = found[1]
            tell(told())
            frame = asyncio.ensure_future(read_frame(process.stdout))
    finally:
        frame.cancel()
