"""The application: the page's files and its websocket, behind the guard."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket

from gcrules.apps.studio.guard import GUIDE, Guard
from gcrules.apps.studio.pages import Pages, guide_folder
from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.apps.studio.service import Service
from gcrules.apps.studio.session import PageSession
from gcrules.apps.studio.shared_pose import SharedPose

__all__ = ["MOST_PAGES", "make_app"]

MOST_PAGES = 32
"""Connections at a time; one more is turned away."""


def make_app(
    port: int,
    token: str,
    opened: SourceJson | None = None,
    tickets: set[str] | None = None,
    shared: SharedPose | None = None,
    folders: tuple[str, ...] = (),
) -> Starlette:
    """The application that is served at http://127.0.0.1:port to whom the token, or one of the tickets, is known;
    `folders` are those of plugins.
    """
    guide = guide_folder()
    service = Service(opened, shared, folders, guide=guide is not None)
    pages = Pages()
    of_guide = [] if guide is None else [Route(f"{GUIDE}{{name:path}}", Pages(guide).answer)]

    sessions: set[PageSession] = set()

    async def talk(socket: WebSocket) -> None:
        if len(sessions) >= MOST_PAGES:
            await socket.close(1013, "too many pages are open")
            return
        session = PageSession(socket, service)
        sessions.add(session)
        try:
            await session.run()
        finally:
            sessions.discard(session)

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        await service.start()
        yield
        await service.close()

    return Starlette(
        routes=[
            WebSocketRoute("/ws", talk),
            *of_guide,
            Route("/", pages.answer),
            Route("/{name:path}", pages.answer),
        ],
        middleware=[Middleware(Guard, port=port, token=token, tickets=set() if tickets is None else tickets)],
        lifespan=lifespan,
    )
