"""Worker processes: started when they are needed, ended when nobody waits for their answer any more.

What they print is not shown; with GCRULES_STUDIO_DEBUG set it is.
"""

from __future__ import annotations

import asyncio
import os
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process
from collections.abc import Coroutine
from time import monotonic
from typing import Any, TypeVar

from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.wire import GIVE_UP, Job, Tell, framed, read_frame
from gcrules.core.budget import MORE_SECONDS
from gcrules.core.errors import EngineFault, GcrulesError, LimitReached
from gcrules.core.threads import with_one_thread

__all__ = ["Pool", "WorkerFault"]

T = TypeVar("T")

_GONE = (asyncio.IncompleteReadError, ConnectionError)  # what is seen of a worker that has ended
_STILL = 1.0  # seconds after which it is said that work goes on, and for how long it has
_LATE = 5.0
_GRACE = 0.4  # seconds in which a worker gives up what nobody waits for: to start another one takes longer
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
        self.starting: set[asyncio.Task[Any]] = set()
        self.leaving: set[asyncio.Task[None]] = set()
        self.closed = False

    async def run(self, job: Job, seconds: float, tell: Tell) -> tuple[Any, Any]:
        """The result of a job, and its subject. Raises WorkerFault for faults, LimitReached after so many seconds (a
        little later where the worker does not notice it).

        Where the task is cancelled the worker gives up, and is ended if it does not within `_GRACE` seconds. A worker
        that something else has ended, waiting or at work, is no fault of the job: it is tried once more, in a fresh
        one. Raises EngineFault where that ends too.
        """
        async with self.free:
            try:
                async with asyncio.timeout(seconds + self.late):
                    try:
                        kind, value, subject = await self._done(job, tell)
                    except _GONE:
                        kind, value, subject = await self._done(job, tell, fresh=True)
            except TimeoutError:
                raise LimitReached(f"no answer within {seconds:g} seconds", hint=MORE_SECONDS) from None
            except _GONE:
                raise EngineFault("the worker has ended by itself, twice") from None
        if kind == "fault":
            raise WorkerFault(value)
        return value, subject

    async def _done(self, job: Job, tell: Tell, *, fresh: bool = False) -> Any:
        """What a worker makes of a job; it is ended where that is nothing."""
        if not self.idle and self.leaving:
            await asyncio.wait(self.leaving, return_when=asyncio.FIRST_COMPLETED)
        process = self.idle.pop() if self.idle and not fresh else await self._begun(self._start())
        answer = _Answer(process, job)
        try:
            found = await answer.get(tell)
        except asyncio.CancelledError:
            self._leave(answer)
            raise
        except BaseException:
            self._end(process)
            raise
        self.idle.append(process)
        return found

    def _leave(self, answer: _Answer) -> None:
        """Nobody waits for an answer any more: the worker goes on with something else, if it is free soon."""

        async def wait() -> None:
            if await answer.given_up():
                self.idle.append(answer.process)
            else:
                self._end(answer.process)

        task = asyncio.ensure_future(wait())
        self.leaving.add(task)
        task.add_done_callback(self.leaving.discard)

    def ready(self) -> None:
        """Have a worker ready before it is asked for."""
        self._begun(self._add())

    def _begun(self, starting: Coroutine[Any, Any, T]) -> asyncio.Task[T]:
        """Some start of a worker, which closing awaits."""
        task = asyncio.ensure_future(starting)
        self.starting.add(task)
        task.add_done_callback(self.starting.discard)
        return task

    async def _add(self) -> None:
        if not self.idle and not self.closed:
            self.idle.append(await self._start())

    async def _start(self) -> Process:
        if self.closed:
            raise EngineFault("the studio is closing")
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
        """End all workers, those too that are being started; no other one starts."""
        self.closed = True
        for task in self.leaving:
            task.cancel()
        while self.starting or self.leaving:
            await asyncio.gather(*self.starting, *self.leaving, return_exceptions=True)
        for process in self.all:
            if process.returncode is None:
                process.kill()
        await asyncio.gather(*(p.wait() for p in self.all))
        self.all.clear()
        self.idle.clear()


_DEBUG = "GCRULES_STUDIO_DEBUG" in os.environ


class _Answer:
    """What a worker makes of a job, which is sent to it."""

    def __init__(self, process: Process, job: Job) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        self.process, self.inward, self.outward = process, process.stdin, process.stdout
        self.known = job[2] is not None
        self.inward.write(framed(job))
        self.frame = self._next()

    def _next(self) -> asyncio.Future[Any]:
        return asyncio.ensure_future(read_frame(self.outward))

    async def get(self, tell: Tell) -> Any:
        """The last frame; `tell` hears those before it. Where this is cancelled, frames are still awaited."""
        try:
            await self.inward.drain()
            start, words = monotonic(), "working"

            def told() -> str:
                gone = monotonic() - start
                return words if gone < _STILL else f"{words}, {gone:.0f} s"

            while True:
                finished, _ = await asyncio.wait([self.frame], timeout=_STILL)
                if not finished:
                    tell(told())
                    continue
                found = self.frame.result()
                if found[0] != "told":
                    return found
                if isinstance(found[1], str):
                    words = found[1]
                    tell(told())
                else:
                    tell(found[1])
                self.frame = self._next()
        except asyncio.CancelledError:
            raise
        except BaseException:
            self.frame.cancel()
            raise

    async def given_up(self) -> bool:
        """Whether the worker has given up soon. One that was still reading its subject is not asked: what it knows of
        it then may be half of it.
        """
        try:
            if not self.known:
                return False
            self.inward.write(framed(GIVE_UP))
            async with asyncio.timeout(_GRACE):
                while (await asyncio.shield(self.frame))[0] == "told":
                    self.frame = self._next()
        except (TimeoutError, *_GONE):
            return False
        finally:
            self.frame.cancel()
        return True
