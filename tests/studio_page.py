"""A running studio, and its page in a person's hands, for tests marked ``browser``."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from console import is_fault

TIMEOUT = 60_000  # milliseconds: what takes half a second takes many on a loaded machine
WIDE = {"width": 1280, "height": 800}
CALM = {"reduced_motion": "reduce"}
"""Nothing is under way when a test looks."""


@dataclass
class Server:
    """``gcrules studio`` in a process of its own; `address` opens its page."""

    state: Path
    port: int = 0
    address: str = ""
    process: subprocess.Popen[str] | None = None

    def start(self) -> None:
        """Start it, after a stop at the same port again."""
        command = [sys.executable, "-m", "gcrules", "studio", "--no-browser", "--port", str(self.port)]
        settings = {"XDG_STATE_HOME": str(self.state), "LOCALAPPDATA": str(self.state), "PYTHONUNBUFFERED": "1"}
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=os.environ | settings)
        assert self.process.stdout is not None
        found = re.search(r"http://\S+", self.process.stdout.readline())
        assert found, "the studio did not start"
        self.address = found[0]
        self.port = urlsplit(self.address).port or 0

    def stop(self) -> None:
        if self.process is not None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(20)
            if self.process.stdout is not None:
                self.process.stdout.close()
            self.process = None

    @property
    def host(self) -> str:
        return f"127.0.0.1:{self.port}"


@contextmanager
def studio(state: Path) -> Iterator[Server]:
    """A studio whose token lies in this folder."""
    server = Server(state)
    try:
        server.start()
        yield server
    finally:
        server.stop()


@dataclass
class Desk:
    """One page of the studio; `requests` are all that left it, `faults` what it complained of."""

    page: Any
    server: Server
    requests: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.page.set_default_timeout(TIMEOUT)
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("websocket", lambda socket: self.requests.append(socket.url))
        self.page.on("pageerror", lambda fault: self.faults.append(str(fault)))
        self.page.on("console", self._heard)

    def _heard(self, said: Any) -> None:
        if is_fault(said):
            self.faults.append(said.text)

    def visit(self, fragment: str = "") -> Desk:
        self.page.goto(self.server.address + fragment)
        self.page.wait_for_selector("[data-testid=line][data-line=open]", state="attached")
        return self

    def one(self, testid: str) -> Any:
        return self.page.get_by_test_id(testid)

    def stop(self, start: str, stop: str) -> None:
        """Start what takes long, and stop it: it can be started again, and nothing is at fault."""
        self.one(start).click()
        self.one(stop).click()
        self.one(stop).wait_for(state="detached")
        assert self.one(start).is_enabled()
        assert self.page.get_by_test_id("fault").count() == 0

    def run(self, script: str, argument: Any = None) -> Any:
        return self.page.evaluate(script, argument)

    def text(self, testid: str) -> str:
        return str(self.one(testid).inner_text())

    # --- what is studied -------------------------------------------------------------------------------------------

    def open(self, kind: str, name: str, stage: str | None = None) -> Desk:
        """Open a class, a robot or an example as its card does, and wait for its numbers."""
        key = "name" if kind == "example" else "id"
        self.run("source => gcrules.open(source)", {"kind": kind, key: name})
        state = self.page.wait_for_function(
            "() => ['ready', 'failed'].find(s => s === gcrules.loaded.value.state)"
        ).json_value()
        assert state == "ready", self.run("gcrules.loaded.value.fault")
        self.answered()
        if stage:
            self.step(stage)
        return self

    def answered(self, timeout: int = TIMEOUT) -> None:
        """Wait until the numbers of the present pose are there."""
        self.page.wait_for_function(
            """() => { const {study, posing, pose$} = gcrules, found = posing.numbers.value?.pose, pose = pose$.value;
            const flat = p => JSON.stringify([p.translation, p.quaternion, p.coordinates ?? []]);
            return study.value && found && flat(found) === flat(pose) }""",
            timeout=timeout,
        )

    def painted(self) -> None:
        """Wait for two frames and for the picture."""
        from browsing import two_frames

        two_frames(self.page)
        self.page.wait_for_timeout(60)

    @property
    def study(self) -> dict[str, Any]:
        return dict(self.run("gcrules.study.value"))

    @property
    def numbers(self) -> dict[str, Any]:
        return dict(self.run("gcrules.posing.numbers.value"))

    @property
    def pose(self) -> dict[str, Any]:
        return dict(self.run("gcrules.pose$.value"))

    def step(self, stage: str) -> Any:
        """Go to a guided step by its tab; its panel."""
        self.one(f"step-{stage}").click()
        panel = self.one(f"stage-{stage}")
        panel.wait_for()
        return panel

    # --- hands -----------------------------------------------------------------------------------------------------

    def slide(self, name: str, value: float) -> None:
        """A slider set as a hand does it: the event that the browser sends while it is dragged."""
        self.one(f"slider-{name}").evaluate(
            """(slider, value) => { slider.value = String(value);
            slider.dispatchEvent(new Event("input", {bubbles: true})); }""",
            value,
        )

    def let_go(self, name: str) -> None:
        self.one(f"slider-{name}").dispatch_event("pointerup")

    def verdict(self, wanted: str, timeout: int = TIMEOUT) -> None:
        """Wait for a verdict in the document."""
        self.page.wait_for_selector(f"[data-testid=verdict][data-verdict={wanted}]", timeout=timeout)

    def place(self, point: str) -> tuple[float, float]:
        """Where a point is seen, in CSS pixels of the page."""
        box = self.one("viewer").bounding_box()
        x, y = self.run(f"gcrules.space.viewer.value.toScreen('{point}')")
        return box["x"] + x, box["y"] + y

    def away(self) -> list[str]:
        """The requests that went to another host."""
        own = {self.server.host}
        return [
            url
            for url in self.requests
            if urlsplit(url).scheme not in ("data", "blob") and urlsplit(url).netloc not in own
        ]
