"""The studio's server: hostile messages and many requests do not bring it down."""

from __future__ import annotations

import asyncio
import json
import os
import random
import signal
import subprocess
import sys
import warnings
from contextlib import ExitStack
from typing import (
    Any,
)

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.core.errors import EngineFault, LimitReached

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

with warnings.catch_warnings():  # it says which client it will use one day
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient
from apps.studio_client import DRAWING, HOME, KNOWN, OCTAHEDRAL, TOKEN, Page
from starlette.websockets import WebSocketDisconnect

from gcrules.apps.studio import service as service_module
from gcrules.apps.studio.app import MOST_PAGES
from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.pool import Pool
from gcrules.apps.studio.protocol.methods import LONGEST
from gcrules.apps.studio.service import Service
from gcrules.apps.studio.wire import framed

# --- messages that are no requests ---------------------------------------------------------------------------------

POSE = {"source": OCTAHEDRAL, "pose": HOME}
LONG = POSE | {
    "over": [*(f"{n} -900:900" for n in "xyz"), *(f"{n} -80:80 deg" for n in ("roll", "pitch", "yaw"))],
    "margin": 0.05,
    "boxes": 2_000_000,
}
"""A map of whole boxes that takes minutes on any machine."""


def asked(do: str, args: Any, **more: Any) -> str:
    return json.dumps({"id": 1, "do": do, "args": args} | more)


HOSTILE: dict[str, str | bytes] = {
    "empty": "",
    "no JSON": "{",
    "no object": "[]",
    "number": "1",
    "null": "null",
    "nested lists": "[" * 100_000,
    "nested objects": '{"id":' * 50_000,
    "nested arguments": '{"id": 1, "do": "open", "args": ' + '{"a":' * 500 + "1" + "}" * 501,
    "binary": b"\x00\xff\xfe",
    "binary JSON": b'{"id": 1, "do": "hello", "args": {}}',
    "NaN": asked("pose", POSE).replace("[0, 0, 0]", "[NaN, 0, 0]"),
    "infinity": asked("pose", POSE).replace("[0, 0, 0]", "[1e999, 0, 0]"),
    "no arguments": '{"id": 1, "do": "hello"}',
    "no id": '{"do": "hello", "args": {}}',
    "id text": '{"id": "1", "do": "hello", "args": {}}',
    "id true": '{"id": true, "do": "hello", "args": {}}',
    "id negative": '{"id": -1, "do": "hello", "args": {}}',
    "id fraction": '{"id": 1.5, "do": "hello", "args": {}}',
    "id huge": '{"id": 1' + "0" * 400 + ', "do": "hello", "args": {}}',
    "id too long to read": '{"id": 1' + "0" * 5000 + ', "do": "hello", "args": {}}',
    "unknown method": asked("eval", {}),
    "method of a dict": asked("__class__", {}),
    "method no text": asked([], {}),
    "channel no text": asked("hello", {}, channel=7),
    "channel long": asked("hello", {}, channel="c" * 100),
    "more keys": asked("hello", {}, token=TOKEN),
    "more arguments": asked("hello", {"x": 1}),
    "arguments a list": asked("open", [OCTAHEDRAL]),
    "source missing": asked("open", {}),
    "source null": asked("open", {"source": None}),
    "source kind": asked("open", {"source": {"kind": "path", "id": "/etc/passwd"}}),
    "source keys": asked("open", {"source": {"kind": "class", "id": "3-3.3", "name": "x"}}),
    "class unknown": asked("open", {"source": {"kind": "class", "id": "9-9"}}),
    "class long": asked("open", {"source": {"kind": "class", "id": "x" * 10_000}}),
    "robot is a path": asked("open", {"source": {"kind": "robot", "id": "../../etc/passwd"}}),
    "robot is a file": asked("open", {"source": {"kind": "robot", "id": "plugins/3-rps/robot.yaml"}}),
    "example is a path": asked("open", {"source": {"kind": "example", "name": "../pyproject"}}),
    "legs wrong": asked("open", {"source": {"kind": "legs", "legs": "ab cd"}}),
    "legs nested": asked("open", {"source": {"kind": "legs", "legs": "(" * 3000}}),
    "file empty": asked("open", {"source": {"kind": "file", "text": " ", "name": "x"}}),
    "file with anchors": asked("open", {"source": {"kind": "file", "text": "a: &a [*a, *a]\nlegs: *a\n", "name": "x"}}),
    "file nested": asked("open", {"source": {"kind": "file", "text": "legs: " + "[" * 5000, "name": "x"}}),
    "file of tags": asked("open", {"source": {"kind": "file", "text": "!!python/object/apply:f []", "name": "x"}}),
    "lone surrogate": asked("open", {"source": {"kind": "legs", "legs": "\ud800"}}),
    "null character": asked("open", {"source": {"kind": "legs", "legs": "ab\0cd"}}),
    "pose short": asked("pose", POSE | {"pose": {"translation": [0, 0], "quaternion": [1, 0, 0, 0]}}),
    "pose of texts": asked("pose", POSE | {"pose": {"translation": ["0", "0", "0"], "quaternion": [1, 0, 0, 0]}}),
    "pose of truths": asked("pose", POSE | {"pose": {"translation": [True, 0, 0], "quaternion": [1, 0, 0, 0]}}),
    "pose far away": asked("pose", POSE | {"pose": {"translation": [1e300, 0, 0], "quaternion": [1, 0, 0, 0]}}),
    "no turn": asked("pose", POSE | {"pose": {"translation": [0, 0, 0], "quaternion": [0, 0, 0, 0]}}),
    "threshold": asked("pose", POSE | {"threshold": "2"}),
    "threshold of a unit": asked("pose", POSE | {"threshold": "2 parsec"}),
    "poses none": asked("along", {"source": OCTAHEDRAL, "poses": []}),
    "poses many": asked("along", {"source": OCTAHEDRAL, "poses": [HOME] * 3000}),
    "commands no list": asked("manual", {"source": OCTAHEDRAL, "commands": "auto"}),
    "commands many": asked("manual", {"source": OCTAHEDRAL, "commands": ["undo"] * 1000}),
    "bench long": asked("bench", {"text": "a" * 30_000}),
    "rules a path": asked("rules", {"files": ["/etc/passwd"]}),
    "rules a folder": asked("bench", {"text": "ab", "folders": ["/"]}),
    "plugins of a page": asked("plugins", {"folders": ["/"]}),
    "rules long": asked("rules", {"files": [{"name": "x", "text": "#" * 50_000, "off": []}]}),
    "rules nested": asked("bench", {"text": "(" * 9_000, "rules": [{"name": "x", "text": 1, "off": []}]}),
    "format": asked("save", POSE | {"what": "exe"}),
    "picture": asked("save", POSE | {"what": "png"}),
    "drawing": asked("compose", {"drawing": {}}),
    "drawing of legs": asked("compose", {"drawing": DRAWING | {"legs": [["A", "a", "b"]]}}),
    "cancel nothing": asked("cancel", {"target": "1"}),
    "too long": "x" * (LONGEST + 1),
    "ten megabytes": json.dumps({"id": 1, "do": "bench", "args": {"text": "x" * 10_000_000}}),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_messages_get_an_error(page: Page, name: str) -> None:
    message = HOSTILE[name]
    if isinstance(message, bytes):
        page.socket.send_bytes(message)
    else:
        page.socket.send_text(message)
    while "ok" not in (found := json.loads(page.socket.receive_text())):
        pass
    assert found["ok"] is False
    assert found["error"]["kind"] in ("input", "limit")
    assert found["error"]["message"]
    assert len(found["error"]["message"]) < 1000
    page.number = 10
    assert page.ask("hello")["version"] == gc.__version__


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=6), inner, max_size=4),
    max_leaves=12,
)
cheap = ["hello", "pose", "open", "manual", "bench", "compose", "along", "save", "cancel", "nearest"]


@st.composite
def broken(draw: st.DrawFn) -> str:
    """A request of which one part is anything at all."""
    args: dict[str, Any] = {"source": OCTAHEDRAL, "pose": HOME}
    message: dict[str, Any] = {"id": 1, "do": draw(st.sampled_from(cheap)), "args": args}
    place = draw(st.sampled_from(["id", "args", "channel", "source", "pose", "translation", "quaternion", "id of"]))
    value = draw(json_values)
    if place in ("id", "args", "channel"):
        message[place] = value
    elif place in ("source", "pose"):
        args[place] = value
    elif place == "id of":
        args["source"] = {
            "kind": draw(st.sampled_from(["class", "legs", "robot", "example"])),
            "id": value,
            "legs": value,
        }
    else:
        args["pose"] = HOME | {place: value}
    return json.dumps(message)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.one_of(broken(), st.text(max_size=40), json_values.map(json.dumps), st.binary(max_size=20)))
def test_fuzzed_messages_leave_the_server_up(page: Page, message: str | bytes) -> None:
    if isinstance(message, bytes):
        page.socket.send_bytes(message)
    else:
        page.socket.send_text(message.encode("utf-8", "replace").decode())
    page.number += 1000
    probe = page.send("hello")
    while (found := json.loads(page.socket.receive_text())).get("id") != probe:
        if "error" in found:
            assert found["error"]["kind"] != "fault", found
    assert found["ok"]


# --- many requests -------------------------------------------------------------------------------------------------


def test_latest_wins(page: Page) -> None:
    page.ask("pose", **POSE)
    poses = [HOME | {"translation": [n / 1000, 0, 0]} for n in range(40)]
    sent = [page.send("pose", channel="pose", source=OCTAHEDRAL, pose=pose) for pose in poses]
    last = page.answer(sent[-1])
    assert last["ok"]
    assert last["result"]["pose"]["translation"][0] == 0.039
    others = [page.answer(n) for n in sent[:-1]]
    assert all(a["ok"] or a["error"]["kind"] == "superseded" for a in others)
    assert sum(a["ok"] for a in others) < len(others)


def test_slow_work_on_a_channel_gives_way(page: Page) -> None:
    slow = [page.send("boxes", channel="n", **LONG) for _ in range(3)]
    last = page.send("bench", channel="n", text="[abcd]")
    assert page.answer(last)["ok"]
    assert [page.answer(n)["error"]["kind"] for n in slow] == ["superseded"] * 3


def test_cancel_ends_the_work(page: Page) -> None:
    slow = page.send("boxes", **LONG)
    assert page.ask("cancel", target=slow) == {"cancelled": True}
    assert page.answer(slow)["error"]["kind"] == "cancelled"
    assert page.ask("cancel", target=slow) == {"cancelled": False}
    assert page.ask("bench", text="[abcd]")["fault"] is None


def test_floods_are_bounded(page: Page) -> None:
    sent = [page.send("bench", text=f"[[ab, cd, ef, gh, ij, k{n}]]") for n in range(200)]
    answers = [page.answer(n) for n in sent]
    limits = [a for a in answers if not a["ok"]]
    assert 0 < len(limits) <= 200 - 64
    assert {a["error"]["kind"] for a in limits} == {"limit"}


def test_same_number_twice(page: Page) -> None:
    legs = {"kind": "legs", "legs": "ab ac bd be cf cg"}
    message = json.dumps({"id": 5, "do": "manual", "args": {"source": legs, "commands": ["auto"]}})
    page.socket.send_text(message)
    page.socket.send_text(message)
    page.number = 5
    assert "is being answered" in page.answer(5)["error"]["message"]
    assert page.answer(5)["ok"]


def test_two_pages_do_not_hear_each_other(client: TestClient) -> None:
    with client.websocket_connect("/ws", headers=KNOWN) as one, client.websocket_connect("/ws", headers=KNOWN) as two:
        first, second = Page(one), Page(two)
        second.ask("pose", **POSE)
        first.number = second.number
        slow = first.send("open", source={"kind": "legs", "legs": "ac ad bc be cf cg"})
        assert second.send("pose", **POSE) == slow
        assert second.answer(slow)["result"]["verdict"] == "regular"
        assert second.ask("cancel", target=slow) == {"cancelled": False}
        assert first.answer(slow)["ok"]


def test_pages_are_bounded(client: TestClient) -> None:
    with ExitStack() as stack:
        for _ in range(MOST_PAGES):
            stack.enter_context(client.websocket_connect("/ws", headers=KNOWN))
        with pytest.raises(WebSocketDisconnect), client.websocket_connect("/ws", headers=KNOWN):
            pass
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        assert Page(socket).ask("hello")["version"] == gc.__version__


def test_a_page_that_leaves_ends_its_work(client: TestClient) -> None:
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        for _ in range(6):
            Page(socket).send("boxes", **LONG)
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        assert Page(socket).ask("bench", text="[abcd]")["fault"] is None


def test_time_limit_ends_a_worker() -> None:
    async def run() -> None:
        pool = Pool(1, late=0.0)
        try:
            with pytest.raises(LimitReached, match=r"within 0\.01 seconds") as late:
                await pool.run(("open", {"source": OCTAHEDRAL}, None), 0.01, lambda _: None)
            hint = fault_view(late.value)["hint"]
            assert hint == "the command line can give it more time", "in words of the page, without options"
            result, subject = await pool.run(("open", {"source": OCTAHEDRAL}, None), 60, lambda _: None)
            assert result["kind"] == "platform"
            assert subject is not None
        finally:
            await pool.close()

    asyncio.run(run())


OPEN = ("open", {"source": OCTAHEDRAL}, None)


def test_a_worker_that_gives_up_goes_on_with_something_else() -> None:
    """It was at a map of what it knows; to end it and to start another one would take longer."""

    async def run() -> None:
        pool = Pool(1)
        asked: dict[str, Any] = {"over": ["x -300:300:141", "y -300:300:141"], "pose": HOME, "source": OCTAHEDRAL}
        try:
            _, subject = await pool.run(OPEN, 60, lambda _: None)
            (worker,) = pool.all
            begun = asyncio.Event()
            work = asyncio.ensure_future(pool.run(("map", asked, subject), 60, lambda _: begun.set()))
            await asyncio.wait_for(begun.wait(), 60)
            work.cancel()
            assert (await pool.run(OPEN, 60, lambda _: None))[0]["kind"] == "platform"
            assert work.cancelled()
            assert worker.returncode is None or worker not in pool.all  # given up, or ended where it was too late
            assert len(pool.all) <= (1 if worker in pool.all else 2)  # in place of one that ended another is kept ready
        finally:
            await pool.close()

    asyncio.run(run())


def test_the_gallery_is_made_once_for_all_pages_and_again_after_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """A page that leaves while it is being made does not end the work that others wait for."""
    jobs: list[str] = []

    async def run() -> None:
        service, go_on = Service(), asyncio.Event()

        async def made(job: Any, seconds: float, tell: Any) -> tuple[Any, Any]:
            jobs.append(job[0])
            await go_on.wait()
            if len(jobs) == 1:
                raise EngineFault("no disk")
            return {"classes": []}, None

        monkeypatch.setattr(service.pool, "run", made)
        monkeypatch.setattr(service_module, "_load", lambda alone: jobs.append("load"))

        def asked() -> asyncio.Task[Any]:
            return asyncio.ensure_future(service.answer("gallery", {}, lambda _: None))

        await service.start()
        first = asked()
        await asyncio.sleep(0)  # it waits for the one that the start began
        go_on.set()
        with pytest.raises(EngineFault, match="no disk"):
            await first
        go_on.clear()
        leaves, stays = asked(), asked()
        while len([job for job in jobs if job == "gallery"]) < 2:
            await asyncio.sleep(0)
        leaves.cancel()
        go_on.set()
        assert await stays == {"classes": []}
        assert await asked() == {"classes": []}
        await service.close()

    asyncio.run(run())
    assert sorted(jobs) == ["gallery", "gallery", "load"]


def test_closing_ends_workers_that_are_starting(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[asyncio.subprocess.Process] = []

    async def run() -> None:
        begun, go_on = asyncio.Event(), asyncio.Event()
        start = asyncio.create_subprocess_exec

        async def slowly(*args: Any, **options: Any) -> asyncio.subprocess.Process:
            started.append(await start(*args, **options))
            begun.set()
            await go_on.wait()
            return started[-1]

        monkeypatch.setattr(asyncio, "create_subprocess_exec", slowly)
        pool = Pool(1)
        pool.ready()
        await begun.wait()
        closing = asyncio.ensure_future(pool.close())
        await asyncio.sleep(0)
        pool.ready()  # as what ends another worker does
        go_on.set()
        await closing
        with pytest.raises(EngineFault, match="closing"):
            await pool.run(OPEN, 60, lambda _: None)

    asyncio.run(run())
    (process,) = started
    assert process.returncode is not None


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_worker_that_is_killed_costs_nobody_an_answer() -> None:
    """While it waits, while it starts, and in the middle of work."""
    chance = random.Random(1)

    async def run() -> None:
        pool = Pool(2)

        async def kill(after: float) -> None:
            await asyncio.sleep(after)
            for process in list(pool.all):
                if process.returncode is None:
                    os.kill(process.pid, signal.SIGKILL)

        try:
            for _ in range(6):
                killing = asyncio.ensure_future(kill(chance.uniform(0, 0.6)))
                result, _ = await pool.run(OPEN, 60, lambda _: None)
                assert result["kind"] == "platform"
                await killing
                assert (await pool.run(OPEN, 60, lambda _: None))[0]["kind"] == "platform"
        finally:
            await pool.close()

    asyncio.run(run())


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_job_that_ends_every_worker_is_a_fault_and_the_next_is_none() -> None:
    async def run() -> None:
        pool = Pool(1)

        def kill(_: str) -> None:
            for process in list(pool.all):
                if process.returncode is None:
                    os.kill(process.pid, signal.SIGKILL)

        try:
            with pytest.raises(EngineFault, match="twice"):
                await pool.run(OPEN, 60, kill)  # as soon as it says what it does
            assert (await pool.run(OPEN, 60, lambda _: None))[0]["kind"] == "platform"
        finally:
            await pool.close()

    asyncio.run(run())


def test_what_a_worker_prints_is_no_frame() -> None:
    script = (
        "import os, sys, gcrules.apps.studio.worker as w\n"
        "w.done = lambda *given: (os.write(1, b'loud'), print('loud'), ('done', 1, None))[2]\n"
        "w.serve()\n"
    )
    sent = framed(("bench", {}, None))
    done = subprocess.run([sys.executable, "-c", script], input=sent, capture_output=True, timeout=60)
    assert done.stdout == framed(("done", 1, None))
