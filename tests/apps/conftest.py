"""What the tests of this room share."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from commands import Run, invoke

from gcrules.apps.repl.interpreter import Interpreter

if TYPE_CHECKING:
    from apps.studio_client import Page
    from starlette.testclient import TestClient


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
