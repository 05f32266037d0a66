"""The studio's server: from the command to the first answers, and from a slider's request to its numbers.

The fixture `studio` is the address of a running studio, its token in it; what a browser shows and when is measured from
there (`studio.address`). Over the websocket a request is answered as the page asks it, one after the other.
"""

from __future__ import annotations

import json
import os
import re
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

connect = pytest.importorskip("websockets.sync.client").connect

PLATFORMS = ["3-3.3", "6-4.2", "6-6", "5-5.1"]
ROBOTS = ["gallardo-4dof", "delta", "6-rus"]
REQUESTS = 200


@dataclass(frozen=True)
class Studio:
    """A running studio; `address` opens its page."""

    address: str

    @property
    def host(self) -> str:
        return self.address.split("/")[2]

    @property
    def token(self) -> str:
        return self.address.partition("token=")[2]

    @contextmanager
    def page(self) -> Iterator[Callable[..., Any]]:
        """``ask("pose", source=…, pose=…)`` over one connection."""
        headers = {"Cookie": f"gcrules-studio={self.token}"}
        with connect(
            f"ws://{self.host}/ws", origin=f"http://{self.host}", additional_headers=headers, max_size=None
        ) as socket:
            number = 0

            def ask(do: str, **args: Any) -> Any:
                nonlocal number
                number += 1
                socket.send(json.dumps({"id": number, "do": do, "args": args}))
                while "progress" in (found := json.loads(socket.recv())):
                    pass
                assert found["ok"], found
                return found["result"]

            yield ask


@contextmanager
def running(state: Path) -> Iterator[Studio]:
    command = [sys.executable, "-m", "gcrules", "studio", "--no-browser", "--port", "0"]
    settings = {"XDG_STATE_HOME": str(state), "LOCALAPPDATA": str(state), "PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=os.environ | settings) as process:
        try:
            assert process.stdout is not None
            found = re.search(r"http://\S+", process.stdout.readline())
            assert found
            yield Studio(found[0])
        finally:
            process.terminate()


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    with running(tmp_path_factory.mktemp("state")) as found:
        yield found


def first_answers(state: Path) -> float:
    """Seconds from the command to the gallery and the octahedral platform with its numbers."""
    start = time.perf_counter()
    with running(state) as found:
        while True:
            try:
                with found.page() as ask:
                    ask("hello")
                    ask("gallery")
                    ask("open", source={"kind": "class", "id": "3-3.3"})
                    return time.perf_counter() - start
            except OSError:
                time.sleep(0.01)


def test_start_to_first_answers(timed: Callable[..., Any], tmp_path: Path) -> None:
    timed(min(first_answers(tmp_path) for _ in range(3)), {}, within=2)


def poses() -> Iterator[dict[str, Any]]:
    """What a slider sends that is drawn along."""
    for n in range(REQUESTS):
        yield {"translation": [n / 1000, 0, -n / 2000], "quaternion": [1, n / 5000, 0, 0]}


def answer_times(studio: Studio, source: dict[str, str], asked: Iterator[dict[str, Any]]) -> list[float]:
    times = []
    with studio.page() as ask:
        ask("open", source=source)
        for pose in asked:
            start = time.perf_counter()
            ask("pose", source=source, pose=pose)
            times.append(time.perf_counter() - start)
    return times


@pytest.mark.parametrize("name", PLATFORMS)
def test_pose(timed: Callable[..., Any], studio: Studio, name: str) -> None:
    times = answer_times(studio, {"kind": "class", "id": name}, poses())
    percentile = statistics.quantiles(times, n=20)[-1]
    timed(statistics.median(times), {"95th percentile": percentile}, within=0.01)


@pytest.mark.parametrize("name", ROBOTS)
def test_pose_of_a_robot_with_limbs(timed: Callable[..., Any], studio: Studio, name: str) -> None:
    source = {"kind": "robot", "id": name}
    with studio.page() as ask:
        number = len(ask("open", source=source)["axes"])
    home = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}
    asked = (home | {"coordinates": [n / 2000] + [0] * (number - 1)} for n in range(REQUESTS // 4))
    times = answer_times(studio, source, asked)
    timed(statistics.median(times), {"95th percentile": statistics.quantiles(times, n=20)[-1]}, within=0.025)


@pytest.mark.parametrize("name", ["3-3.3", "6-6"])
def test_open(timed: Callable[..., Any], studio: Studio, name: str) -> None:
    with studio.page() as ask:
        ask("hello")
        start = time.perf_counter()
        ask("open", source={"kind": "legs", "legs": {"3-3.3": "ab af cb cd ed ef", "6-6": "ag bh ci dj ek fl"}[name]})
        timed(time.perf_counter() - start, {}, within=0.5)
