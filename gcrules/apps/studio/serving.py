"""Running the studio: a free port of 127.0.0.1, the token, the browser; until Ctrl-C."""

from __future__ import annotations

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
from gcrules.apps.studio.token_file import token
from gcrules.core import interrupts
from gcrules.core.errors import InputError

__all__ = ["PORT", "free_socket", "serve"]

PORT = 8747
_TRIES = 20
_MOST = 16_000_000  # bytes of a message that are taken in, to be answered that it is too long


def free_socket(port: int) -> socket.socket:
    """A socket that listens on this port of 127.0.0.1, on one of the next ones if it is taken, else on any.

    Raises InputError where this machine lets nobody listen.
    """
    wanted = [p for p in range(port, port + _TRIES) if p < 65536] if port else []
    for one in [*wanted, 0]:
        found = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
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


def serve(
    opened: SourceJson | None = None, *, port: int = PORT, browser: bool = True, say: Callable[[str], None] = print
) -> None:
    """Serve until Ctrl-C; `say` hears the address."""
    secret = token()
    listening = free_socket(port)
    own = listening.getsockname()[1]
    address, ticket = f"http://127.0.0.1:{own}/", secrets.token_urlsafe(32)
    config = uvicorn.Config(
        make_app(own, secret, opened, [ticket] if browser else ()),
        log_level="critical",  # what pages send wrong is told to them; the studio logs its own faults
        lifespan="on",
        ws="websockets-sansio",
        ws_max_size=_MOST,
        ws_per_message_deflate=False,
        server_header=False,
        timeout_graceful_shutdown=1,
    )

    def ready() -> None:
        say(f"The studio is open at {address}?token={secret}")
        if port and own != port:
            say(f"(port {port} is taken)")
        say("Ctrl-C closes it.")
        if browser:
            threading.Thread(target=webbrowser.open, args=(f"{address}?ticket={ticket}",), daemon=True).start()

    try:
        with interrupts.deferred():  # the server hears them itself, once it has begun
            _Server(config, ready).run(sockets=[listening])
    except KeyboardInterrupt:
        interrupts.go_on()
    finally:
        listening.close()
