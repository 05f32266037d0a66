"""Firefox driven over WebDriver BiDi, which it speaks by itself."""

from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

WAIT = 60.0  # seconds
PREFERENCES = {
    "browser.aboutwelcome.enabled": False,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "ui.prefersReducedMotion": 1,
    "webgl.force-enabled": True,
}


@dataclass
class Tab:
    """One page; `faults` are the errors and warnings of its console."""

    socket: ClientConnection
    context: str = ""
    faults: list[str] = field(default_factory=list)
    _ids: Iterator[int] = field(default_factory=count)

    def send(self, method: str, **params: Any) -> Any:
        """A command and its result; events that come meanwhile are taken down."""
        own = next(self._ids)
        self.socket.send(json.dumps({"id": own, "method": method, "params": params}))
        while True:
            found = json.loads(self.socket.recv(WAIT))
            if found.get("method") == "log.entryAdded" and found["params"]["level"] in ("error", "warn"):
                self.faults.append(found["params"]["text"])
            if found.get("id") == own:
                assert found["type"] == "success", found
                return found["result"]

    def visit(self, address: str) -> None:
        self.send("browsingContext.navigate", context=self.context, url=address, wait="complete")

    def run(self, script: str) -> Any:
        """The value of an expression, or of the promise that it is."""
        expression = f"Promise.resolve({script}).then(found => JSON.stringify(found) ?? 'null')"
        target = {"context": self.context}
        found = self.send("script.evaluate", expression=expression, target=target, awaitPromise=True)
        assert found["type"] == "success", found["exceptionDetails"]["text"]
        return json.loads(found["result"]["value"])

    def wait(self, condition: str) -> Any:
        """Wait until an expression is true; its value."""
        late = f"setTimeout(() => reject(new Error('not in time: ' + {json.dumps(condition)})), {1000 * WAIT - 5000})"
        look = f"const look = () => {{ const now = {condition}; now ? done(now) : setTimeout(look, 30); }}; look();"
        return self.run(f"new Promise((done, reject) => {{ {late}; {look} }})")

    def click(self, testid: str) -> None:
        self.wait(f"!!document.querySelector('[data-testid={testid}]')")
        self.run(f"document.querySelector('[data-testid={testid}]').click()")

    def drag(self, start: tuple[float, float], right: int, down: int) -> None:
        """With the main button, in a few steps."""
        x, y = map(round, start)
        moves = [{"type": "pointerMove", "x": x + right * i // 4, "y": y + down * i // 4} for i in range(1, 5)]
        first = [{"type": "pointerMove", "x": x, "y": y}, {"type": "pointerDown", "button": 0}]
        steps = [*first, *moves, {"type": "pointerUp", "button": 0}]
        hand = {"type": "pointer", "id": "mouse", "actions": steps}
        self.send("input.performActions", context=self.context, actions=[hand])

    def picture(self, path: Path) -> None:
        data = self.send("browsingContext.captureScreenshot", context=self.context)["data"]
        path.write_bytes(base64.b64decode(data))


@contextmanager
def firefox(profile: Path) -> Iterator[Tab]:
    """The system's Firefox, headless, with a profile of its own and one page."""
    path = shutil.which("firefox-esr")
    assert path is not None, 'mark the test with pytest.mark.needs("firefox-esr")'
    profile.mkdir(parents=True, exist_ok=True)
    lines = (f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items())
    (profile / "user.js").write_text("".join(lines), encoding="utf-8")
    command = [path, "--headless", "--no-remote", "--profile", str(profile), "--remote-debugging-port", "0"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    try:
        assert process.stderr is not None
        address = next(m[1] for line in process.stderr if (m := re.search(r"BiDi listening on (ws://\S+)", line)))
        with connect(f"{address}/session", max_size=None, open_timeout=WAIT) as socket:
            tab = Tab(socket)
            tab.send("session.new", capabilities={})
            tab.send("session.subscribe", events=["log.entryAdded"])
            tab.context = tab.send("browsingContext.getTree")["contexts"][0]["context"]
            tab.send("browsingContext.setViewport", context=tab.context, viewport={"width": 1280, "height": 800})
            yield tab
    finally:
        process.terminate()
        process.wait(20)
        if process.stderr is not None:
            process.stderr.close()
