"""Running the studio: a free port of 127.0.0.1, the token, the browser; until Ctrl-C, or beside what Python does."""

from __future__ import annotations

import atexit
import errno
import os
import secrets
import socket
import threading
import webbrowser
from collections.abc import Callable

import uvicorn

from gcrules.apps.studio.app import make_app
from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.apps.studio.shared_pose import SharedPose
from gcrules.apps.studio.token_file import token
from gcrules.core import interrupts
from gcrules.core.errors import EngineFault, InputError

__all__ = ["PORT", "Background", "free_socket", "serve"]

PORT = 8747
_TRIES = 20
_MOST = 16_000_000  # bytes of a message that are taken in, to be answered that it is too long


def free_socket(port: int) -> socket.socket:
    """A socket that listens on this port of 127.0.0.1, on one of the next ones if it is taken, else on any.

    Raises InputError where this machine lets nobody listen.
    """
    wanted = [p for p in range(port, port + _TRIES) if p < 65536] if port else []
    for one in [*wanted, 0]:
        found = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)  # so asyncio sends parts at once
        if os.name == "posix":  # a restarted server takes its port again at once; elsewhere this would share the port
            found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            found.bind(("127.0.0.1", one))
            found.listen(64)
            return found
        except OSError as fault:
            found.close()
            if fault.errno not in (errno.EADDRINUSE, errno.EACCES):
                raise InputError(f"cannot listen on 127.0.0.1: {fault.strerror}") from None
    raise InputError("there is no free port on 127.0.0.1")


class _Server(uvicorn.Server):
    """Says when it is ready: pages are answered from then on, and signals are heard."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self.ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if interrupts.pending() is not None:
            self.should_exit = True
        elif self.started:
            self.ready()


class _Place:
    """Where a studio is served, and who is let in."""

    def __init__(self, port: int) -> None:
        self.token = token()
        self.socket = free_socket(port)
        self.port: int = self.socket.getsockname()[1]
        self.address = f"http://127.0.0.1:{self.port}/"
        self.tickets: set[str] = set()

    def link(self) -> str:
        """An address that lets one browser in, once."""
        ticket = secrets.token_urlsafe(32)
        self.tickets.add(ticket)
        return f"{self.address}?ticket={ticket}"

    def server(
        self,
        opened: SourceJson | None,
        shared: SharedPose | None,
        ready: Callable[[], None],
        folders: tuple[str, ...] = (),
    ) -> _Server:
        config = uvicorn.Config(
            make_app(self.port, self.token, opened, self.tickets, shared, folders),
            log_level="critical",  # what pages send wrong is told to them; the studio logs its own faults
            lifespan="on",
            ws="websockets-sansio",
            ws_max_size=_MOST,
            ws_per_message_deflate=False,
            server_header=False,
            timeout_graceful_shutdown=1,
        )
        return _Server(config, ready)


def serve(
    opened: SourceJson | None = None,
    *,
    port: int = PORT,
    browser: bool = True,
    folders: tuple[str, ...] = (),
    say: Callable[[str], None] = print,
) -> None:
    """Serve until Ctrl-C, with the plugins of these folders; `say` hears the address."""
    place = _Place(port)

    def ready() -> None:
        say(f"The studio is open at {place.address}?token={place.token}")
        if port and place.port != port:
            say(f"(port {port} is taken)")
        say("Ctrl-C closes it.")
        if browser:
            _open(place)

    try:
        with interrupts.deferred():  # the server hears them itself, once it has begun
            place.server(opened, None, ready, folders).run(sockets=[place.socket])
    except KeyboardInterrupt:
        interrupts.go_on()
    finally:
        place.socket.close()


class Background:
    """A studio beside what Python does, in a thread of its own, until it is closed or Python ends."""

    def __init__(self, opened: SourceJson, shared: SharedPose, *, browser: bool) -> None:
        self._place = _Place(PORT)
        begun = threading.Event()
        self._server = self._place.server(opened, shared, begun.set)
        self._thread = threading.Thread(target=self._run, args=(begun,), name="gcrules-studio", daemon=True)
        self._thread.start()
        begun.wait()
        if not self.running:
            raise EngineFault("the studio did not start")
        atexit.register(self.close)
        if browser:
            _open(self._place)

    def _run(self, begun: threading.Event) -> None:
        try:
            self._server.run(sockets=[self._place.socket])
        finally:
            self._place.socket.close()
            begun.set()

    @property
    def running(self) -> bool:
        return self._server.started and not self._server.should_exit

    @property
    def address(self) -> str:
        return self._place.address

    def link(self) -> str:
        """An address that lets one browser in, once."""
        return self._place.link()

    def close(self) -> None:
        """Pages are told that the line is lost."""
        atexit.unregister(self.close)
        self._server.should_exit = True
        self._thread.join(10)


def _open(place: _Place) -> None:
    threading.Thread(target=webbrowser.open, args=(place.link(),), daemon=True).start()
