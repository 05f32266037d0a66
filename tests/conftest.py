"""What all tests share: hypothesis profiles, the browser, and the list of what was left out."""

from __future__ import annotations

import gc
import os
import shutil
import signal
import subprocess
from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from choice import chosen, fast, processor_seconds, spread, table
from hypothesis import HealthCheck, settings
from places import ROOT

# "ci" draws the same examples every time, so that a red run is red again; "dev" goes on searching.
settings.register_profile("ci", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("dev", deadline=None)
settings.register_profile("fast", deadline=None, max_examples=10, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "ci" if os.environ.get("CI") else "dev"))

# Tests run side by side. That NumPy shares products of small matrices among threads takes several times as long then.
# It reads this when it is loaded: in the workers of xdist and in programs that are started, and here where no plugin
# of pytest has loaded it already.
for library in ("OPENBLAS", "OMP", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

# How fast the machine is decides no test; those of the limits say how many seconds they mean.
os.environ.setdefault("GCRULES_SECONDS", "1000")

# Under nohup, and in the background of a script, interrupts are ignored, by programs that are started from here too.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# What is proved in tests is not remembered between them, and nothing is left behind in the user's own cache.
os.environ["GCRULES_CACHE"] = "off"

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def find_browser() -> str | None:
    """The path of Chromium: ``$GCRULES_BROWSER``, else the first of the usual names on the path."""
    chosen = os.environ.get("GCRULES_BROWSER")
    names = (chosen,) if chosen else BROWSERS
    return next((path for name in names if (path := shutil.which(name))), None)


@cache
def is_there(name: str) -> bool:
    """Whether a program is there, or, of a name with an ending, TeX finds such a file."""
    if "." not in name:
        return shutil.which(name) is not None
    finder = shutil.which("kpsewhich")
    return finder is not None and subprocess.run([finder, name], capture_output=True, check=False).returncode == 0


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Leave out what needs a missing program or file of TeX; with ``GCRULES_REQUIRE_BROWSER=1`` fail it instead."""
    missing = [name for marker in item.iter_markers("needs") for name in marker.args if not is_there(name)]
    if item.get_closest_marker("browser") and find_browser() is None:
        missing.append("chromium")
    if not missing:
        return
    reason = f"needs {', '.join(missing)}, not found"
    if os.environ.get("GCRULES_REQUIRE_BROWSER") == "1":
        pytest.fail(f"{reason}, and GCRULES_REQUIRE_BROWSER=1", pytrace=False)
    pytest.skip(reason)


# Sixteen thousand tests are made, and all are kept: searches for garbage take a third of the time of collecting them.
@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Iterator[None]:
    """Collect tests without searches for garbage; later ones leave the tests out."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("choice", "tests/choice.py")
    group.addoption("--spread", action="store_true", help="of tests whose cases cost much, some that are spread evenly")
    group.addoption("--fast", action="store_true", help="the tests that find most in a second")
    group.addoption("--costs", metavar="FILE", type=Path, help="write what the tests cost")


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """With ``--spread`` or ``--fast`` some of the tests. What fails in a browser is tried once more."""
    for item in items:
        if item.get_closest_marker("browser"):
            item.add_marker(pytest.mark.flaky(reruns=1))
    everything = len(items)
    if config.getoption("--spread"):
        items[:] = chosen(items, spread)
    if config.getoption("--fast"):
        settings.load_profile("fast")
        items[:] = chosen(items, fast)
    config.stash[UNCHOSEN] = everything - len(items)


UNCHOSEN = pytest.StashKey[int]()
"""How many tests a choice leaves out."""
STARTED = pytest.StashKey[float]()
COST = "processor seconds"


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker tells the run how many it left out; all have chosen the same."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["unchosen"] = session.config.stash.get(UNCHOSEN, 0)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """Take it from a worker."""
    node.config.stash[UNCHOSEN] = getattr(node, "workeroutput", {}).get("unchosen", 0)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Note from where on a test costs processor time."""
    if item.config.getoption("--costs"):
        item.stash[STARTED] = processor_seconds()
    return (yield)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
    """Add what the test has cost to its last report."""
    if call.when == "teardown" and STARTED in item.stash:
        item.user_properties.append((COST, processor_seconds() - item.stash[STARTED]))
    return (yield)


def _costs(reporter: pytest.TerminalReporter) -> Iterator[tuple[str, float]]:
    for reports in reporter.stats.values():
        for report in reports:
            for name, seconds in getattr(report, "user_properties", ()):
                if name == COST:
                    yield report.nodeid, seconds


@pytest.fixture(scope="session")
def root() -> Path:
    """The root of the checkout."""
    return ROOT


@pytest.fixture
def browser() -> str:
    """The path of Chromium, for tests marked ``browser``."""
    path = find_browser()
    assert path is not None, "mark the test with pytest.mark.browser"
    return path


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    """Chromium driven by Playwright, which only tests in a browser load."""
    from browsing import chromium

    with chromium() as browser:
        yield browser


@pytest.fixture
def run_browser(browser: str, tmp_path: Path) -> Callable[..., str]:
    """``run_browser(page, *flags)``: open a page (a path or an address) headless; what Chromium prints.

    Without flags that is the document after its scripts ran (``--dump-dom``); ``f"--screenshot={png}"`` takes a
    picture. Chromium is given ten seconds of virtual time, so that scripts and timers come to rest.
    """

    def run(page: str | Path, *flags: str, timeout: float = 60) -> str:
        address = page.resolve().as_uri() if isinstance(page, Path) else page
        command = [
            browser,
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            "--virtual-time-budget=10000",
            f"--user-data-dir={tmp_path / 'chromium'}",
            *(flags or ("--dump-dom",)),
            address,
        ]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=timeout)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """List what this run left out, by reason, so that a green line is not taken for more than it is."""
    if path := terminalreporter.config.getoption("--costs"):
        path.write_text(table(_costs(terminalreporter)), encoding="utf-8")
    left_out = dict(_left_out(terminalreporter))
    terminalreporter.section("left out")
    for reason, tests in sorted(left_out.items()):
        terminalreporter.line(f"{len(tests)} x {reason}")
        for test in tests:
            terminalreporter.line(f"    {test}")
    if unchosen := terminalreporter.config.stash.get(UNCHOSEN, 0):
        terminalreporter.line(f"{unchosen} x more cases of tests that cost much: make test-all (tests/choice.py)")
    elif not left_out:
        terminalreporter.line("nothing")
    again = terminalreporter.getreports("rerun")
    if again:
        terminalreporter.section("run once more")
        for report in again:
            terminalreporter.line(report.nodeid)
            terminalreporter.line(str(report.longrepr).splitlines()[-1])


def _left_out(reporter: pytest.TerminalReporter) -> Iterator[tuple[str, list[str]]]:
    reasons: defaultdict[str, list[str]] = defaultdict(list)
    for report in reporter.getreports("skipped"):
        longrepr = report.longrepr
        text = longrepr[2] if isinstance(longrepr, tuple) else str(longrepr)
        reasons[text.removeprefix("Skipped: ")].append(report.nodeid)
    for report in reporter.getreports("xfailed"):
        reasons[f"expected to fail: {getattr(report, 'wasxfail', '')}"].append(report.nodeid)
    for item in reporter.stats.get("deselected", ()):
        reasons["deselected on the command line"].append(item.nodeid)
    yield from reasons.items()
