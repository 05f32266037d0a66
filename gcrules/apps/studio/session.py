"""One page's connection: requests in, answers out; of each channel only the latest request counts."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Coroutine, Mapping
from typing import Any

from starlette.websockets import WebSocket, WebSocketDisconnect

from gcrules.apps.studio.faults import CANCELLED, SUPERSEDED, fault_view, limit, own_fault
from gcrules.apps.studio.pool import WorkerFault
from gcrules.apps.studio.protocol.messages import (
    Misread,
    Request,
    Told,
    fault_message,
    message_text,
    read_request,
    result_message,
    told_message,
)
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.service import Service
from gcrules.core.errors import GcrulesError

__all__ = ["PageSession"]

_MOST = 64  # requests of one page that wait for an answer
_GRACE = 0.3  # seconds that work on a channel has left when a later request has come
_LOG = logging.getLogger(__name__)


class PageSession:
    """Speaks with one page until it is gone."""

    def __init__(self, socket: WebSocket, service: Service) -> None:
        self.socket = socket
        self.service = service
        self.tasks: dict[int, asyncio.Task[None]] = {}
        self.running: dict[str, Request] = {}
        self.waiting: dict[str, Request] = {}
        self.why: dict[int, FaultView] = {}
        self.telling: set[asyncio.Task[None]] = set()
        self.sending = asyncio.Lock()

    async def run(self) -> None:
        """Take messages until the page closes the connection; then nothing goes on for it."""
        await self.socket.accept()
        try:
            while True:
                message = await self.socket.receive()
                if message["type"] == "websocket.disconnect":
                    return
                await self._take(message.get("text") if message.get("text") is not None else message.get("bytes", b""))
        except WebSocketDisconnect:
            return
        finally:
            for task in self.tasks.values():
                task.cancel()
            await asyncio.gather(*self.tasks.values(), return_exceptions=True)

    # --- requests --------------------------------------------------------------------------------------------------

    async def _take(self, data: str | bytes | None) -> None:
        try:
            request = read_request(data or b"")
        except Misread as misread:
            await self._fault(misread.id, fault_view(misread.fault))
            return
        if request.do == "cancel":
            await self._done(request, {"cancelled": await self._give_up(request.args["target"], CANCELLED)})
        elif request.id in self.tasks or any(r.id == request.id for r in self.waiting.values()):
            await self._fault(request.id, {"kind": "input", "message": f"request {request.id} is being answered"})
        elif len(self.tasks) + len(self.waiting) >= _MOST:
            await self._fault(request.id, limit(f"{_MOST} requests wait already", "wait for their answers"))
        elif request.channel in self.running:
            await self._in_turn(request, request.channel)
        else:
            self._start(request)

    async def _in_turn(self, request: Request, channel: str) -> None:
        """The latest request of a channel waits for the one that is being answered, for a little while."""
        older = self.waiting.get(channel)
        self.waiting[channel] = request
        if older is not None:
            await self._fault(older.id, SUPERSEDED)
        now = self.running[channel]
        asyncio.get_running_loop().call_later(_GRACE, self._end, now, SUPERSEDED)

    def _start(self, request: Request) -> None:
        if request.channel is not None:
            self.running[request.channel] = request
        task = asyncio.ensure_future(self._answer(request))
        self.tasks[request.id] = task
        task.add_done_callback(lambda done: self._ended(request, done))

    def _ended(self, request: Request, task: asyncio.Task[None]) -> None:
        self.tasks.pop(request.id, None)
        why = self.why.pop(request.id, None)
        if why is not None and task.cancelled():  # before its first step, so that it could not answer by itself
            self._tell(self._fault(request.id, why))
        if request.channel is not None and self.running.get(request.channel) is request:
            del self.running[request.channel]
            later = self.waiting.pop(request.channel, None)
            if later is not None:
                self._start(later)

    def _end(self, request: Request, why: FaultView) -> None:
        """Stop the work on a request, if it goes on."""
        task = self.tasks.get(request.id)
        if task is not None and not task.done() and request.id not in self.why:
            self.why[request.id] = why
            task.cancel()

    async def _give_up(self, target: int, why: FaultView) -> bool:
        """Cancel a request; False where there is none of this number."""
        for channel, request in list(self.waiting.items()):
            if request.id == target:
                del self.waiting[channel]
                await self._fault(target, why)
                return True
        task = self.tasks.get(target)
        if task is None or task.done():
            return False
        self.why[target] = why
        task.cancel()
        return True

    # --- answers ---------------------------------------------------------------------------------------------------

    async def _answer(self, request: Request) -> None:
        def tell(what: Told) -> None:
            self._tell(self._send(told_message(request.id, what)))

        try:
            found = await self.service.answer(request.do, request.args, tell)
            if self.telling:
                await asyncio.wait(self.telling)  # what was said before the answer comes before it
            await self._done(request, found)
        except asyncio.CancelledError:
            if request.id not in self.why:
                raise
            await self._fault(request.id, self.why[request.id])
        except WorkerFault as fault:
            await self._fault(request.id, fault.view)
        except GcrulesError as fault:
            await self._fault(request.id, fault_view(fault))
        except Exception as fault:
            _LOG.exception("a request failed")
            await self._fault(request.id, own_fault(f"{type(fault).__name__}: {fault}"))

    def _tell(self, sending: Coroutine[Any, Any, None]) -> None:
        """Send without waiting for it."""
        task = asyncio.ensure_future(sending)
        self.telling.add(task)
        task.add_done_callback(self.telling.discard)

    async def _done(self, request: Request, result: Any) -> None:
        await self._send(result_message(request, result))

    async def _fault(self, number: int, fault: FaultView) -> None:
        await self._send(fault_message(number, fault))

    async def _send(self, message: Mapping[str, Any]) -> None:
        data = message_text(message)
        async with self.sending:
            try:
                await self.socket.send_text(data)
            except (RuntimeError, WebSocketDisconnect):  # the page has gone meanwhile
                return
