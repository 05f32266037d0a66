"""The fixtures ``ratio`` and ``peer``: a function timed beside its naive form and peers in one run; ``browser``."""

from __future__ import annotations

import importlib
import math
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))
from measurement import Measurement, show

STRICT = os.environ.get("GCRULES_BENCH_STRICT") == "1"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
SOFTWARE = (
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--no-first-run",
    "--disable-dev-shm-usage",
)
SHORTEST_SAMPLE = 0.002  # seconds; shorter calls are timed in a loop


MEASUREMENTS = pytest.StashKey[list[Measurement]]()
MISSING_PEERS = pytest.StashKey[set[str]]()


def pytest_configure(config: pytest.Config) -> None:
    config.stash[MEASUREMENTS] = []
    config.stash[MISSING_PEERS] = set()


def calls_per_sample(function: Callable[[], Any]) -> int:
    """How often to call the function so that one sample is long enough to be timed; calls it at least once."""
    calls = 1
    while (spent := sample(function, calls)) < SHORTEST_SAMPLE:
        calls = max(2 * calls, math.ceil(calls * SHORTEST_SAMPLE / max(spent, 1e-9)))
    return calls


def sample(function: Callable[[], Any], calls: int) -> float:
    """Seconds that this many calls take together."""
    start = time.perf_counter()
    for _ in range(calls):
        function()
    return time.perf_counter() - start


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """Chromium, headless, without a graphics card."""
    playwright = pytest.importorskip("playwright.sync_api")
    path = next(filter(None, map(shutil.which, (os.environ.get("GCRULES_BROWSER") or "", *BROWSERS))), None)
    if path is None:
        pytest.skip("needs chromium")
    with playwright.sync_playwright() as running:
        found = running.chromium.launch(executable_path=path, args=SOFTWARE)
        yield found
        found.close()


@pytest.fixture
def peer(request: pytest.FixtureRequest) -> Callable[[str], ModuleType | None]:
    """``peer("clifford")``: that module, or ``None`` (and a line at the end of the run) when it is not installed."""

    def find(name: str) -> ModuleType | None:
        try:
            return importlib.import_module(name)
        except ImportError:
            request.config.stash[MISSING_PEERS].add(name)
            return None

    return find


@pytest.fixture
def ratio(request: pytest.FixtureRequest, benchmark: Any) -> Callable[..., Measurement]:
    """``ratio(function, {"naive": slow, "clifford": None}, ...)``: time the function beside the others.

    All are called without arguments, in turn, ``rounds`` times; the best time of each counts, so that a disturbance
    hits all alike. One whose value is ``None`` (a peer that is not installed) is reported as missing.

    agree     called with the function's result and each other's result; the benchmark fails when it is false, since
              a faster wrong answer is no gain. Without it results are not compared.
    within    goal for the function, in seconds
    at_least  goals for the ratios, such as ``{"naive": 10}``
    rounds    rounds of the comparison, and of the statistics that pytest-benchmark prints
    others_rounds
              in how many of these rounds the other forms run, for forms that take long; all by default

    Goals that are missed are marked in the table at the end; with ``GCRULES_BENCH_STRICT=1`` they fail the run.
    The numbers go into ``extra_info`` too, hence into ``--benchmark-json``.
    """

    def measure(
        function: Callable[[], Any],
        others: Mapping[str, Callable[[], Any] | None],
        *,
        agree: Callable[[Any, Any], bool] | None = None,
        within: float | None = None,
        at_least: Mapping[str, float] | None = None,
        rounds: int = 5,
        others_rounds: int | None = None,
    ) -> Measurement:
        present = {name: other for name, other in others.items() if other is not None}
        if agree is not None:
            mine = function()
            for name, other in present.items():
                assert agree(mine, other()), f"the result differs from that of {name}"
        calls = {name: calls_per_sample(other) for name, other in present.items()}
        my_calls = calls_per_sample(function)
        best = math.inf
        best_others = dict.fromkeys(present, math.inf)
        for turn in range(rounds):
            best = min(best, sample(function, my_calls) / my_calls)
            if others_rounds is None or turn < others_rounds:
                for name, other in present.items():
                    best_others[name] = min(best_others[name], sample(other, calls[name]) / calls[name])
        benchmark.pedantic(function, rounds=rounds, iterations=my_calls)

        result = Measurement(request.node.name, best, dict.fromkeys(others) | best_others, within, at_least or {})
        benchmark.extra_info["best"] = best
        benchmark.extra_info["others"] = dict(result.others)
        benchmark.extra_info["ratio"] = {name: result.ratio(name) for name in others}
        request.config.stash[MEASUREMENTS].append(result)
        if STRICT:
            assert result.missed() == []
        return result

    return measure


@pytest.fixture
def timed(request: pytest.FixtureRequest) -> Callable[..., Measurement]:
    """``timed(seconds, {"Macaulay2": 0.7, "sympy": Over(60)}, ...)``: forms that timed themselves, or were stopped.

    For programs in processes of their own, whose start must not count; ``megabytes`` are the most that they had, by the
    same names ("" for the first). Goals as for ``ratio``.
    """

    def record(
        seconds: float,
        others: Mapping[str, float | None],
        *,
        within: float | None = None,
        at_least: Mapping[str, float] | None = None,
        megabytes: Mapping[str, float] | None = None,
    ) -> Measurement:
        result = Measurement(request.node.name, seconds, others, within, at_least or {}, megabytes or {})
        request.config.stash[MEASUREMENTS].append(result)
        if STRICT:
            assert result.missed() == []
        return result

    return record


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """The table: each benchmark beside its naive form and its peers, and the goals that were missed."""
    measurements = config.stash[MEASUREMENTS]
    if measurements:
        terminalreporter.section("beside other forms, best times")
        width = max(len(m.name) for m in measurements)
        for m in measurements:
            line = f"{m.name:<{width}}  {show(m.seconds):>9}{m.memory()}"
            if m.within is not None:
                line += f"  (goal {show(m.within)})"
            terminalreporter.line(line)
            for other, seconds in m.others.items():
                reached = m.ratio(other)
                times = "" if reached is None else f"  x {reached:.3g}"
                terminalreporter.line(f"{'':<{width}}  {show(seconds):>9}{times}{m.memory(other)}  {other}")
            for missed in m.missed():
                terminalreporter.line(f"{'':<{width}}  MISSED: {missed}")
    missing = config.stash[MISSING_PEERS]
    for name in sorted(missing):
        terminalreporter.line(f"the peer {name} is not installed; the comparisons with it were left out")
