"""The command that starts the studio, its workers, and what they say."""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import (
    Any,
)

import pytest
from click.testing import CliRunner

from gcrules.apps.cli import cli
from gcrules.core.errors import InputError

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import FOUR_DOF, OCTAHEDRAL, TOKEN
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.typing import Origin

from gcrules.apps.studio import serving, theory
from gcrules.apps.studio.app import make_app
from gcrules.apps.studio.guard import COOKIE
from gcrules.apps.studio.stages import stage_views
from gcrules.apps.studio.subject import read_subject

# --- the command ---------------------------------------------------------------------------------------------------


def test_next_free_port() -> None:
    with serving.free_socket(0) as first:
        port = first.getsockname()[1]
        assert first.getsockname()[0] == "127.0.0.1"
        with serving.free_socket(port) as second:
            assert second.getsockname()[1] != port


def test_answers_in_parts_do_not_wait_for_each_other() -> None:
    """Small parts that follow each other are held back for 40 ms where the sockets do not say otherwise."""

    async def delayed() -> bool:
        seen: asyncio.Future[bool] = asyncio.get_running_loop().create_future()

        async def answer(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            found = writer.get_extra_info("socket")
            seen.set_result(not found.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
            writer.close()

        with serving.free_socket(0) as place:
            async with await asyncio.start_server(answer, sock=place):
                _, writer = await asyncio.open_connection(*place.getsockname())
                found = await seen
                writer.close()
        return found

    assert not asyncio.run(delayed())


def run_studio(state: Path, *arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "gcrules", "studio", "--no-browser", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"XDG_STATE_HOME": str(state), "LOCALAPPDATA": str(state), "PYTHONUNBUFFERED": "1"},
    )


def address_of(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    line = process.stdout.readline()
    found = re.search(r"http://127\.0\.0\.1:\d+/\?token=\S+", line)
    assert found, line + (process.stderr.read() if process.stderr and process.poll() is not None else "")
    return found[0]


def test_browser_is_not_started_with_the_token(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Other users of the machine see what a program was started with; a ticket is worth nothing once it was used."""
    asked: list[str] = []
    said: list[str] = []
    tickets: list[set[str]] = []
    monkeypatch.setattr(serving, "token", lambda: TOKEN)
    monkeypatch.setattr(serving, "make_app", lambda *given: tickets.append(given[3]) or make_app(*given))
    monkeypatch.setattr("webbrowser.open", asked.append)
    monkeypatch.setattr("uvicorn.Server.run", lambda server, sockets: server.ready())
    serving.serve(port=0, say=said.append)
    while not asked:
        time.sleep(0.01)
    assert TOKEN in said[0]
    assert TOKEN not in asked[0]
    assert [asked[0].split("/?ticket=")[1]] == list(tickets[0])


@pytest.mark.skipif(sys.platform == "win32", reason="needs the number of the process that started another")
def test_worker_ends_when_the_server_is_killed() -> None:
    """In the middle of work, which nobody waits for any more."""
    script = (
        "import subprocess, sys, time\n"
        "from gcrules.apps.studio.wire import framed\n"
        "worker = subprocess.Popen([sys.executable, '-m', 'gcrules.apps.studio.worker'], stdin=-1, stdout=1)\n"
        "worker.stdin.write(framed(('bench', {'text': '[abcd]' * 15_000}, None)))\n"
        "worker.stdin.flush()\n"
        "print('at work', flush=True)\n"
        "time.sleep(60)\n"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        assert server.stdout.readline() == b"at work\n"
        server.kill()
        assert b"done" not in server.stdout.read()  # no answer, and the worker has let the pipe go


BROKEN_FRAMES = {
    "invalid UTF-8": b"\x81\x84\0\0\0\0\xff\xfe\xfd\xfc",
    "no frame": b"\xff" * 40,
    "no mask": b"\x81\x02{}",
    "control frame too long": b"\x89\xfe\x02\0" + bytes(4 + 512),
    "a length of 2^63": b"\x81\xff\x80" + bytes(11),
}


def hello(address: str) -> Any:
    """One connection to a studio that runs, of a page that knows its token."""
    host, _, token = address.removeprefix("http://").partition("/?token=")
    return connect(
        f"ws://{host}/ws", origin=Origin(f"http://{host}"), additional_headers={"Cookie": f"{COOKIE}={token}"}
    )


def survives(address: str) -> None:
    """Frames that are none, and one that is far too long, end their own connection only."""
    for broken in BROKEN_FRAMES.values():
        with hello(address) as page:
            page.socket.sendall(broken)
            with pytest.raises(ConnectionClosed):
                page.recv()
    with hello(address) as page:
        page.socket.sendall(b"\x81\xff" + (20_000_000).to_bytes(8, "big") + bytes(4))
        with pytest.raises(ConnectionClosed):
            page.recv()
    with hello(address) as page:
        page.send(json.dumps({"id": 1, "do": "hello", "args": {}}))
        assert json.loads(page.recv())["result"]["opened"] == {"kind": "legs", "legs": "ab af cb cd ed ef"}


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_studio_runs_until_it_is_interrupted(tmp_path: Path) -> None:
    """Twice: the second one has the port and the token of the first, so that an open page goes on with it."""
    addresses: list[str] = []
    for turn in range(2):
        port = addresses[0].split("/")[2].partition(":")[2] if turn else "0"
        process = run_studio(tmp_path, "ab af cb cd ed ef", "--port", port)
        try:
            addresses.append(address_of(process))
            if not turn:
                survives(addresses[0])
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=20)
        finally:
            process.kill()
        assert process.returncode == 0, errors
        assert errors == ""
    assert addresses[0] == addresses[1]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["ab cd"], "expected six"),
        (["nowhere.yaml"], "there is no such file"),
        (["ab af cb cd ed ef", "--port", "99999"], "99999"),
        (["-"], "is not a leg"),
    ],
)
def test_studio_refuses(arguments: list[str], words: str) -> None:
    done = CliRunner().invoke(cli, ["studio", "--no-browser", *arguments], input="nothing")
    assert done.exit_code == 2
    assert words in done.stderr


def test_studio_refuses_what_a_page_could_not_send() -> None:
    text = "legs: [ab]\n#" + "x" * 400_000
    done = CliRunner().invoke(cli, ["studio", "--no-browser", "-"], input=text)
    assert done.exit_code == 2
    assert "more than 400,000 characters" in done.stderr


def test_without_the_extra_it_is_said_how_to_get_it() -> None:
    code = (
        "import sys; sys.modules['starlette'] = None; sys.modules['uvicorn'] = None\n"
        "from gcrules.apps.main import main; sys.argv = ['gcrules', 'studio', '--no-browser']; main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 2
    assert 'pip install "gcrules[studio]"' in done.stderr


def test_stages_are_told_in_words_of_the_table() -> None:
    for source in (OCTAHEDRAL, FOUR_DOF):
        assert {s["id"] for s in stage_views(read_subject(source))} <= set(theory.THEORY)


@pytest.mark.parametrize(
    ("kind", "key", "name"), [("class", "id", "3-3.33"), ("robot", "id", "3-rpx"), ("example", "name", "octahedra")]
)
def test_unknown_sources_are_told_what_is_near(kind: str, key: str, name: str) -> None:
    with pytest.raises(InputError) as fault:
        read_subject({"kind": kind, key: name})
    assert "did you mean" in (fault.value.hint or "")
