"""The engine in the guide's pages: from opening a page to its first answer, in a browser that has loaded nothing of it
before, beside Pyodide alone, the same answer of an engine that runs, and the command line.

It needs a guide that was built with its engine (`make site`), which is served from this machine: a network is not
timed. Chromium is running already.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent
SITE = Path(os.environ.get("GCRULES_SITE", ROOT / "build" / "site"))
ANSWERED = "() => document.querySelector('.gc-answer').dataset.state === 'done'"
PYTHON = (
    "async (folder) => (await (await import(`${folder}pyodide.mjs`)).loadPyodide({ indexURL: folder })).runPython('1')"
)
ROUNDS = 3


class Silent(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    if not (SITE / "assets" / "engine").is_dir():
        pytest.skip("needs a guide that was built with its engine: make site")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Silent, directory=str(SITE)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    server.server_close()


def answered(page: Any, button: str) -> float:
    """Seconds from the click on a button to its answer."""
    start = time.perf_counter()
    page.click(button)
    page.wait_for_function(ANSWERED)
    return time.perf_counter() - start


def cold(browser: Any, address: str, name: str, button: str) -> tuple[float, float]:
    """Seconds from opening a page, with empty caches, to its first answer; and for the same answer once more."""
    context = browser.new_context()
    try:
        page = context.new_page()
        page.set_default_timeout(120_000)
        start = time.perf_counter()
        page.goto(f"{address}{name}.html")
        answered(page, button)
        return time.perf_counter() - start, answered(page, button)
    finally:
        context.close()


def pyodide(browser: Any, address: str) -> float:
    """Seconds from opening a page, with empty caches, to a Python that answers."""
    context = browser.new_context()
    try:
        page = context.new_page()
        page.set_default_timeout(120_000)
        start = time.perf_counter()
        page.goto(f"{address}assets/engine/LICENSES.txt")
        page.evaluate(PYTHON, f"{address}assets/engine/")
        return time.perf_counter() - start
    finally:
        context.close()


def shell() -> float:
    """Seconds that a command takes."""
    start = time.perf_counter()
    subprocess.run([sys.executable, "-m", "gcrules", "analyze", "ab af cb cd ed ef"], check=True, capture_output=True)
    return time.perf_counter() - start


def test_first_answer(timed: Callable[..., Any], browser: Any, address: str) -> None:
    """That of the first example of the page "Try it here"."""
    times = [(*cold(browser, address, "try", ".gc-try-run"), pyodide(browser, address), shell()) for _ in range(ROUNDS)]
    first, again, alone, command = (min(column) for column in zip(*times, strict=True))
    timed(first, {"Pyodide alone": alone, "once more": again, "the command line": command}, within=10)


def test_first_example_of_python(timed: Callable[..., Any], browser: Any, address: str) -> None:
    times = [cold(browser, address, "lines", "[data-session] .gc-run") for _ in range(ROUNDS)]
    first, again = (min(column) for column in zip(*times, strict=True))
    timed(first, {"once more": again}, within=10)
