"""What the tests of this room share."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import pytest
from commands import Run, invoke

from gcrules.apps.repl.interpreter import Interpreter

if TYPE_CHECKING:
    from apps.studio_client import Page
    from starlette.testclient import TestClient
    from studio_page import Desk, Server


@pytest.fixture
def run() -> Run:
    """`run(*arguments, input=…)`: the program in this process."""
    return invoke


@pytest.fixture
def repl() -> Interpreter:
    return Interpreter()


@pytest.fixture(scope="module")
def client() -> Iterator[TestClient]:
    pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
    with warnings.catch_warnings():  # it says which client it will use one day
        warnings.simplefilter("ignore")
        from starlette.testclient import TestClient

    from apps.studio_client import OPENED, OWN, PORT, TOKEN

    from gcrules.apps.studio.app import make_app

    with TestClient(make_app(PORT, TOKEN, OPENED), base_url=OWN) as client:
        yield client


@pytest.fixture
def page(client: TestClient) -> Iterator[Page]:
    from apps.studio_client import KNOWN, Page

    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        yield Page(socket)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A studio in a process of its own."""
    from studio_page import studio

    with studio(tmp_path_factory.mktemp("studio")) as running:
        yield running


@pytest.fixture
def desk(chromium: Any, server: Server) -> Iterator[Desk]:
    """The page as it opens for the first time; nothing may go wrong in it, and nothing may leave the machine."""
    from studio_page import Desk

    context = chromium.new_context(
        viewport={"width": 1100, "height": 720},
        reduced_motion="reduce",
        accept_downloads=True,
        permissions=["clipboard-read", "clipboard-write"],
    )
    made = Desk(context.new_page(), server)
    made.visit()
    yield made
    faults, away = made.faults, made.away()
    context.close()
    assert faults == []
    assert away == []


@pytest.fixture
def sit_down(chromium: Any, server: Server) -> Iterator[Callable[..., Desk]]:
    """A desk with a page of its own; at the end nothing has left the machine, and nothing was complained of."""
    from studio_page import CALM, WIDE, Desk

    contexts, desks = [], []

    def sat(browser: Any = chromium, own: Server = server, **options: Any) -> Desk:
        context = browser.new_context(**{"viewport": WIDE, **CALM, **options})
        contexts.append(context)
        desks.append(Desk(context.new_page(), own))
        return desks[-1]

    yield sat
    for context in contexts:
        context.close()
    for desk in desks:
        assert desk.away() == []
        assert desk.faults == []
