"""Who may speak with the studio: pages of its own address that know its token; everything else is turned away.

The server listens on 127.0.0.1 only. A page of another site can still make a browser send requests here, also by a name
of its own that it lets point to 127.0.0.1 (DNS rebinding), so the names in Host and Origin are checked; and other users
of the same machine can connect, so a token is asked for. It comes once, in the address that `gcrules studio` prints,
and is then kept in a cookie that scripts cannot read and other sites cannot use. The browser that `gcrules studio`
opens, and a link in a notebook, get a ticket instead, which is good for one time: other users can see what a program
was started with, and a notebook is kept.
"""

from __future__ import annotations

import hmac
from collections.abc import Iterable
from http.cookies import CookieError, SimpleCookie

from starlette.datastructures import Headers, QueryParams
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

__all__ = ["COOKIE", "GUIDE", "Guard"]

COOKIE = "gcrules-studio"
GUIDE = "/guide/"
"""Where the guide lies."""
_YEAR = 365 * 24 * 3600
_UNSAID = 80  # browsers leave this port out of Host and Origin

_NO_TOKEN = (
    "This address needs the token of the studio.\n"
    "Open the address that `gcrules studio` has printed; this browser then remembers it.\n"
)


class Guard:
    """Wraps the application; `port` is the one that is listened on, `tickets` stand for the token once each: those
    that are put into the set later as well.
    """

    def __init__(self, app: ASGIApp, port: int, token: str, tickets: set[str]) -> None:
        self.app = app
        self.token = token
        self.tickets = tickets
        self.hosts = {name if port == _UNSAID else f"{name}:{port}" for name in ("127.0.0.1", "localhost")}
        self.headers, self.of_guide = headers(port), headers(port, engine=True)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        asked = Headers(scope=scope)
        refused = self._refusal(scope, asked)
        if scope["type"] == "websocket":
            if refused is None and not self._known(asked):
                refused = PlainTextResponse(_NO_TOKEN, 403)
            if refused is not None:
                await _rejected(receive, send)
                return
            await self.app(scope, receive, send)
            return

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                beside = self.of_guide if scope["path"].startswith(GUIDE) else self.headers
                message["headers"] = [*message["headers"], *beside]
            await send(message)

        answer = refused or self._entrance(scope, asked) or self.app
        await answer(scope, receive, with_headers)

    def _refusal(self, scope: Scope, asked: Headers) -> Response | None:
        """The answer to a request that comes by another name, or from a page of another origin."""
        hosts, origins = asked.getlist("host"), asked.getlist("origin")
        if len(hosts) != 1 or hosts[0].lower() not in self.hosts:
            return PlainTextResponse("This host is not served here.\n", 421)
        own = [f"http://{hosts[0].lower()}"]
        if (origins or scope["type"] == "websocket") and origins != own:
            return PlainTextResponse("Pages of other origins are not served.\n", 403)
        return None

    def _entrance(self, scope: Scope, asked: Headers) -> Response | None:
        """A right token or ticket in the address becomes a cookie, and goes out of the address; else there is no page.

        The stylesheet, the scripts and fonts of the page are the same for everyone, and hold nothing secret; the guide
        may be one of somebody's own.
        """
        if scope["path"].startswith(GUIDE):
            return None if self._known(asked) else PlainTextResponse(_NO_TOKEN, 403)
        if scope["path"] != "/":
            return None
        given = QueryParams(scope["query_string"])
        if self._right(given.get("token", "")) or self._spent(given.get("ticket", "")):
            answer = RedirectResponse("/", 303, headers={"cache-control": "no-store"})
            answer.set_cookie(COOKIE, self.token, max_age=_YEAR, httponly=True, samesite="strict", path="/")
            return answer
        return None if self._known(asked) else PlainTextResponse(_NO_TOKEN, 403)

    def _known(self, asked: Headers) -> bool:
        """Whether a cookie holds the token."""
        for line in asked.getlist("cookie"):
            try:
                found = SimpleCookie(line).get(COOKIE)
            except CookieError:
                continue
            if found is not None and self._right(found.value):
                return True
        return False

    def _spent(self, ticket: str) -> bool:
        """Whether the ticket was good; it is not any more."""
        good = ticket in self.tickets
        self.tickets.discard(ticket)
        return good

    def _right(self, token: str) -> bool:
        return hmac.compare_digest(token.encode(), self.token.encode())


async def _rejected(receive: Receive, send: Send) -> None:
    """Turn a websocket away before it is open; the browser sees 403."""
    await receive()
    await send({"type": "websocket.close", "code": 1008})


def headers(port: int, *, engine: bool = False) -> list[tuple[bytes, bytes]]:
    """What every answer says: nothing is loaded from elsewhere, no other page holds or reads this one. With `engine`
    pages may run WebAssembly, as the guide's do.
    """
    sockets = " ".join(f"ws://{name}:{port}" for name in ("127.0.0.1", "localhost"))
    policy = {
        "default-src": "'self'",
        "script-src": "'self' 'wasm-unsafe-eval'" if engine else "'self'",
        "style-src": "'self' 'unsafe-inline'",  # KaTeX and the editor set styles of single elements
        "img-src": "'self' data: blob:",
        "font-src": "'self' data:",
        "connect-src": f"'self' {sockets}",
        "object-src": "'none'",
        "base-uri": "'none'",
        "form-action": "'none'",
        "frame-ancestors": "'none'",
    }
    said = {
        "content-security-policy": _joined(f"{name} {value}" for name, value in policy.items()),
        "x-content-type-options": "nosniff",
        "referrer-policy": "no-referrer",
        "cross-origin-opener-policy": "same-origin",
        "cross-origin-resource-policy": "same-origin",
        "permissions-policy": "camera=(), microphone=(), geolocation=()",
    }
    return [(name.encode(), value.encode()) for name, value in said.items()]


def _joined(parts: Iterable[str]) -> str:
    return "; ".join(parts)
