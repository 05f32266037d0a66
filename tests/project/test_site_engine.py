"""The engine in the guide's pages: the command line that it asks, and, of a guide that was built with it, what a
browser shows (`make site-check`; GCRULES_SITE names the folder of the guide).
"""

from __future__ import annotations

import json
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
from places import ROOT, tool

from gcrules.apps.browser import Desk

site_runs = tool("site_runs")
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


def _session(desk: Desk, *examples: str) -> int:
    return desk.run_session(json.dumps(examples))


def test_examples_of_python_are_one_session(desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    first, second = ">>> x = 1\n>>> x\n1\n", ">>> for i in range(2):\n...     x += 1\n>>> x\n3\n"
    assert _session(desk, first, second) == 0
    assert capfd.readouterr().out == second
    assert _session(desk, first, second, ">>> x\n") == 0
    assert capfd.readouterr().out == ">>> x\n3\n"
    assert _session(desk, first, second) == 0  # once more, from the start
    assert capfd.readouterr().out == second
    assert _session(desk, ">>> x\n") == 2  # another page
    assert "NameError: name 'x' is not defined" in capfd.readouterr().err


def test_an_example_goes_on_from_what_runs(desk: Desk, capfd: pytest.CaptureFixture[str]) -> None:
    fails = ">>> x = 1\n>>> import a_package_that_is_not_there\n>>> x = 2\n"
    assert _session(desk, fails) == 2
    assert "error: this answer needs a_package_that_is_not_there, which is not installed" in capfd.readouterr().err
    assert _session(desk, fails, ">>> x\n") == 0
    assert capfd.readouterr() == (">>> x\n1\n", "")
    assert _session(desk, ">>> import gcrules.apps.nothing\n") == 2
    assert "ModuleNotFoundError: No module named 'gcrules.apps.nothing'" in capfd.readouterr().err


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
    ("line", "why"),
    {
        'gcrules prove "ab /\\ cd == [abcd]"': "",
        'gcrules factor "(abc /\\ def)|gh|"': "",
        "gcrules robot analyze 3-rps": "",
        "gcrules studio --help": "",
        "gcrules repl -e :help": "",
        "gcrules robot analyze 4-rpr": "Needs NumPy",
        "gcrules robot pose 3-rps": "Needs NumPy",
        "gcrules pose examples/octahedral.yaml": "Needs NumPy",
        "gcrules analyze - < legs.txt": "Needs a shell",
        "gcrules cite | head": "Needs a shell",
        "make demo": "Needs a shell",
        "gcrules factor [abcd] --cofactor": "Takes a minute here",
    }.items(),
)
def test_commands_that_run(line: str, why: str) -> None:
    assert site_runs.why_not(line) == (why and f"{why}: run it on your machine.")


@pytest.mark.parametrize(
    ("code", "printed", "why"),
    [
        (0, ">>> 1\n1\n", ""),
        (2, ">>> x\nerror: this answer needs networkx, which is not installed here\n", "Needs NetworkX"),
        (2, "ModuleNotFoundError: No module named 'gcrules.apps.notebook'\n", "Needs a notebook"),
        (2, "NameError: name 'x' is not defined\n", "Goes on from an example that does not run here"),
    ],
)
def test_examples_of_python_that_do_not_run(code: int, printed: str, why: str) -> None:
    assert site_runs.why_not_session(code, printed) == (why and f"{why}: run it on your machine.")


def test_an_example_of_python_that_should_run() -> None:
    with pytest.raises(ValueError, match=r"fails in the engine of the guide's pages:\nZeroDivisionError"):
        site_runs.why_not_session(2, "ZeroDivisionError: division by zero\n")


def test_examples_are_marked() -> None:
    console = '<div class="language-console highlight"><pre><code>$ gcrules cite\n@misc\n</code></pre></div>'
    script = '<div class="language-gca highlight"><pre><code>rank 3\nclaim <b>1</b> &lt; 2\n</code></pre></div>'
    other = console.replace("cite", "studio")
    python = '<div class="language-pycon highlight"><pre><code><b>&gt;&gt;&gt;</b> 1 + 1\n2\n</code></pre></div>'
    shell = '<div class="language-sh highlight"><pre><code>make demo\n</code></pre></div>'
    page = console + script + other + python + shell + python
    assert site_runs.sessions(page) == [">>> 1 + 1\n2"] * 2
    marked = site_runs.marked(page, ["", "Needs a notebook"])
    assert marked.count("data-run") == 1
    assert 'data-run="gcrules cite">' in marked
    assert 'data-script="rank 3&#10;claim 1 &lt; 2">' in marked
    assert marked.count('data-session="&gt;&gt;&gt; 1 + 1&#10;2"') == 2
    assert marked.count('2" data-why="Needs a notebook">') == 1
    assert '"language-sh highlight" data-why="Needs a shell: ' in marked
    assert marked.count("data-why") == 3


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


@pytest.mark.browser
@built
@pytest.mark.parametrize("name", ["lines", "screws"])
def test_examples_of_python_print_what_the_page_shows(page: Any, address: str, name: str) -> None:
    page.goto(f"{address}{name}.html")
    page.wait_for_selector(".gc-run")
    blocks = page.locator("[data-session]:not([data-why])")
    assert blocks.count() > 3
    for number in reversed(range(blocks.count())):  # each goes on from those above
        block = blocks.nth(number).element_handle()
        block.query_selector(".gc-run").click()
        page.wait_for_function("block => block.nextElementSibling.dataset.state === 'done'", arg=block)
        shown, answer = page.evaluate(
            "block => [block, block.nextElementSibling].map((one) => one.querySelector('code').innerText.trim())", block
        )
        assert answer == shown


@pytest.mark.browser
@built
def test_an_example_without_a_button_says_why(page: Any, address: str) -> None:
    page.goto(f"{address}robots.html")
    page.wait_for_selector(".gc-run")
    blocks = page.locator(".language-console, .language-pycon, .language-gca, .language-sh")
    silent = blocks.evaluate_all("all => all.filter((one) => !one.querySelector('.gc-run') && !one.dataset.why).length")
    assert silent == 0
    why = page.locator("[data-why] + .gc-why")
    assert why.count() == page.locator("[data-why]").count() > 3
    assert why.first.inner_text().endswith(": run it on your machine.")
