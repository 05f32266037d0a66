"""The engine in the guide's pages: the command line that it asks, and, of a guide that was built with it, what a
browser shows (`make site-check`; GCRULES_SITE names the folder of the guide).
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from browsing import chromium
from places import ROOT

sys.path.insert(0, str(ROOT / "tools"))
import site_runs  # type: ignore[import-not-found, unused-ignore]

sys.path.remove(str(ROOT / "tools"))

from gcrules.apps.browser import Desk

SITE = os.environ.get("GCRULES_SITE")
SECONDS = 180_000
built = pytest.mark.skipif(SITE is None, reason="needs a guide that was built with its engine: make site-check")


# --- the command line ------------------------------------------------------------------------------------------------


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    monkeypatch.chdir(tmp_path)
    return Desk(str(tmp_path / "home"))


@pytest.mark.parametrize("line", ["gcrules cite", "cite", "$ gcrules cite"])
def test_a_line_is_read_as_a_shell_reads_it(line: str, desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    assert desk.answer(line) == 0
    assert capfd.readouterr().out.startswith("@misc{gcrules")


def test_an_open_quotation_mark(desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    assert desk.answer('gcrules analyze "ab') == 2
    assert "error: the line is not complete: No closing quotation\nhint: close" in capfd.readouterr().err


def test_files_that_are_written_are_named_once(desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    assert desk.answer("gcrules cite") == 0
    assert desk.new_files() == []
    assert desk.answer('gcrules analyze "ab af cb cd ed ef" -o answer.txt') == 0
    assert desk.new_files() == ["answer.txt"]
    assert desk.new_files() == []


def test_a_script(desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    assert desk.run_script("claim [abcd] == -[bacd]\n") == 0
    assert "1 claim: 1 proved" in capfd.readouterr().out
    assert desk.new_files() == []


def test_a_package_that_is_missing(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    class Missing:
        def find_spec(self, name: str, *_: object) -> None:
            if name == "gcrules.apps.cli.factor":
                raise ModuleNotFoundError("No module named 'numpy'", name="numpy")

    monkeypatch.delitem(sys.modules, "gcrules.apps.cli.factor", raising=False)
    monkeypatch.setattr(sys, "meta_path", [Missing(), *sys.meta_path])
    assert desk.answer("gcrules factor [abcd]") == 2
    assert "error: this answer needs numpy, which is not installed here" in capfd.readouterr().err


# --- which examples run ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "runs"),
    {
        'gcrules prove "ab /\\ cd == [abcd]"': True,
        'gcrules factor "(abc /\\ def)|gh|"': True,
        "gcrules robot analyze 3-rps": True,
        "gcrules robot pose 3-rps": False,
        "gcrules pose examples/octahedral.yaml": False,
        "gcrules analyze - < legs.txt": False,
        "gcrules cite | head": False,
        "make demo": False,
    }.items(),
)
def test_commands_that_run(line: str, runs: bool) -> None:
    assert site_runs.runs(line) is runs


def test_examples_are_marked() -> None:
    console = '<div class="language-console highlight"><pre><code>$ gcrules cite\n@misc\n</code></pre></div>'
    script = '<div class="language-gca highlight"><pre><code>rank 3\nclaim <b>1</b> &lt; 2\n</code></pre></div>'
    other = console.replace("cite", "studio")
    marked = site_runs.marked(console + script + other)
    assert marked.count("data-run") == 1
    assert 'data-run="gcrules cite">' in marked
    assert 'data-script="rank 3&#10;claim 1 &lt; 2">' in marked


# --- in a browser ----------------------------------------------------------------------------------------------------


class _Silent(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Silent, directory=str(ROOT / str(SITE))))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    server.server_close()


@pytest.fixture(scope="module")
def window() -> Iterator[Any]:
    with chromium() as browsing:
        yield browsing.new_context(viewport={"width": 1280, "height": 900})


@pytest.fixture
def page(window: Any, address: str) -> Iterator[Any]:
    opened = window.new_page()
    opened.set_default_timeout(SECONDS)
    asked: list[str] = []
    window.on("request", lambda request: asked.append(request.url))
    yield opened
    assert [url for url in asked if not url.startswith((address, "blob:", "data:"))] == []
    opened.close()


def _state(page: Any, wanted: str) -> None:
    page.wait_for_function(f"() => document.querySelector('.gc-answer').dataset.state === '{wanted}'")


@pytest.mark.browser
@built
def test_the_page_answers(page: Any, address: str) -> None:
    page.goto(f"{address}try.html")
    page.click(".gc-try-run")
    _state(page, "done")
    shown = page.inner_text(".gc-answer code")
    assert "exactly when the four planes abc, aef, bdf and cde meet in a point" in shown
    assert "−" in shown
    page.fill(".gc-try-form textarea", "claim [abcd] == [bacd]")
    page.keyboard.press("Control+Enter")
    page.wait_for_function("() => document.querySelector('.gc-answer').dataset.code === '1'")
    assert "The answer is no." in page.inner_text(".gc-answer-status")
    page.fill(".gc-try-form textarea", 'gcrules expand "[[ab, cd"')
    page.click(".gc-try-run")
    page.wait_for_function("() => document.querySelector('.gc-answer').dataset.code === '2'")
    assert page.inner_text(".gc-answer .gc-err").startswith("error: ")


@pytest.mark.browser
@built
def test_stop_ends_a_computation_and_the_next_one_answers(page: Any, address: str) -> None:
    page.goto(f"{address}try.html")
    page.fill(".gc-try-form textarea", 'gcrules factor "[[Aa, Ab, Bc, Bd, Ca, Dc]]" --cofactor')
    page.click(".gc-try-run")
    page.wait_for_function("() => document.querySelector('.gc-answer-status').textContent.startsWith('Computing')")
    page.click(".gc-try-run")
    _state(page, "failed")
    assert page.inner_text(".gc-answer-status") == "Stopped."
    page.fill(".gc-try-form textarea", 'gcrules analyze "ab af cb cd ed ef" -o answer.txt')
    page.click(".gc-try-run")
    _state(page, "done")
    with page.expect_download() as saved:
        page.click(".gc-answer-files a")
    assert saved.value.suggested_filename == "answer.txt"


@pytest.mark.browser
@built
def test_the_studio_shows_its_steps_without_a_network(page: Any, window: Any, address: str) -> None:
    page.goto(f"{address}try.html")
    page.click(".gc-try-studio a")
    page.wait_for_selector(".cards")
    window.set_offline(True)
    try:
        page.fill("[data-testid=legs]", "ab af cb cd ed ef")
        page.wait_for_selector("[data-testid=legs-preview] svg.schematic")
        page.click("[data-testid=legs-open]")
        page.wait_for_selector("[data-testid=viewer] canvas, [data-testid=viewer] svg")
        steps = page.locator(".stepper [role=tab]")
        assert steps.count() == 10
        for i in range(10):
            steps.nth(i).click()
            page.wait_for_function(f"() => document.querySelector('#stage').innerText.includes('Step {i + 1} of 10')")
        assert page.locator("[data-testid=no-numbers]").inner_text().count("pip install") == 1
        assert page.eval_on_selector_all(".rail button", "all => all.map((one) => one.innerText)") == [
            "Start",
            "Steps",
            "Bench",
        ]
    finally:
        window.set_offline(False)


@pytest.mark.browser
@built
def test_an_example_of_the_guide_runs_where_it_stands(page: Any, address: str) -> None:
    page.goto(f"{address}factor.html")
    page.locator(".gc-run").first.click()
    _state(page, "done")
    shown = page.inner_text(".gc-answer code")
    assert shown.startswith("abc ∧ aef ∧ bdf ∧ cde\n")
    assert page.locator("[data-run] code").first.inner_text().endswith(shown)
