"""The studio: from the command to the first answers and to a page that can be used, from a slider to its numbers, from
letting go to the proof of the way, to the first picture of a map, and what the page holds after an hour's worth of use.

The fixture `studio` is a running studio. Over the websocket a request is answered as the page asks it, one after the
other. In a browser (the system's Chromium, software rendering) times are taken by the page's own clock: from the event
of a slider to the new value in the document, and to the frame that shows it. Chromium itself is running already.
"""

from __future__ import annotations

import gzip
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

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

from studio_use import held, use  # noqa: E402

from gcrules.apps.studio.pages import STATIC  # noqa: E402

PLATFORMS = ["3-3.3", "6-4.2", "6-6", "5-5.1"]
ROBOTS = ["gallardo-4dof", "delta", "6-rus"]
REQUESTS = 200
MOVES = 120
SIX_LEGS = ["octahedral", "platform-6-6"]
OF_JOINTS = ["delta", "orthoglide", "3-rps", "3-rrr", "tricept", "capaman", "3-upu"]


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
                while "ok" not in (found := json.loads(socket.recv())):
                    pass  # how far it is, and parts of the answer
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


# --- in a browser --------------------------------------------------------------------------------------------------


@contextmanager
def new_page(browser: Any) -> Iterator[Any]:
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    try:
        yield context.new_page()
    finally:
        context.close()


def first_page(browser: Any, state: Path) -> tuple[float, float]:
    """Seconds from the command to a page with its gallery, and to the numbers of the first class that is opened."""
    with new_page(browser) as page:
        start = time.perf_counter()
        with running(state) as found:
            page.goto(found.address)
            page.wait_for_selector("[data-testid=gallery-search]")
            page.wait_for_selector(".card")
            usable = time.perf_counter() - start
            page.evaluate("gcrules.open({kind: 'class', id: '3-3.3'})")
            page.wait_for_function("() => gcrules.posing.numbers.value")
            return usable, time.perf_counter() - start


def test_start_to_usable_page(timed: Callable[..., Any], browser: Any, tmp_path: Path) -> None:
    usable, numbers = min(first_page(browser, tmp_path) for _ in range(3))
    timed(usable, {"a class opened, with numbers": numbers}, within=2)


SLIDE = """async moves => {
  const slider = document.querySelector("[data-testid=slider-z]") ??
    document.querySelector("[data-testid^=slider-][type=range]");
  const times = [];
  const value = document.querySelector("[data-testid=value]");
  const rest = Number(slider.value), step = Math.max(Number(slider.step), (slider.max - slider.min) / 1000);
  const later = ms => new Promise(done => setTimeout(done, ms));
  const frame = () => new Promise(done => requestAnimationFrame(() => {
    const channel = new MessageChannel();  // its message comes after the frame has been handed on
    channel.port1.onmessage = () => done(performance.now());
    channel.port2.postMessage(null);
  }));
  for (let k = 1; k <= moves; k++) {
    let asked = false, stop;
    const changed = new Promise(done => {
      const watch = new MutationObserver(() => { watch.disconnect(); done(performance.now()); });
      watch.observe(value, {characterData: true, childList: true, subtree: true});
      stop = gcrules.posing.awaited.subscribe(awaited => {  // so near a home that is symmetric, all digits may stay
        if (asked && !awaited) setTimeout(() => { watch.disconnect(); done(); }, 20);
      });
    });
    const start = performance.now();
    slider.value = String(rest - k * step);
    slider.dispatchEvent(new Event("input", {bubbles: true}));
    asked = true;
    const shown = await changed, painted = await frame();
    stop();
    if (shown) times.push([(shown - start) / 1000, (painted - start) / 1000]);
    await later(8);
  }
  return times; }"""
"""Seconds from each event of a slider to another value in the document, and until it is painted."""


@contextmanager
def opened(browser: Any, studio: Studio, name: str) -> Iterator[Any]:
    source = {"kind": "example", "name": name} if name in SIX_LEGS else {"kind": "robot", "id": name}
    with new_page(browser) as page:
        page.goto(studio.address)
        page.wait_for_function("() => window.gcrules")
        page.evaluate("source => gcrules.open(source)", source)
        page.wait_for_function("() => gcrules.posing.numbers.value")
        page.wait_for_timeout(800)
        yield page


@pytest.mark.parametrize("name", [*SIX_LEGS, *OF_JOINTS, "6-rus"])
def test_slider_to_value(timed: Callable[..., Any], browser: Any, studio: Studio, name: str) -> None:
    with opened(browser, studio, name) as page:
        page.evaluate(SLIDE, 10)
        times = page.evaluate(SLIDE, MOVES)
    shown, painted = (sorted(column) for column in zip(*times, strict=True))
    almost = int(0.95 * len(shown))
    timed(statistics.median(shown), {"painted, median": statistics.median(painted)}, within=0.025)
    timed(shown[almost], {"longest": shown[-1]}, within=0.05)
    timed(painted[almost], {"longest": painted[-1]}, within=0.09)


LET_GO = """async part => {
  const slider = document.querySelector("[data-testid^=slider-][type=range]"), {timeline} = gcrules;
  const until = async ready => { while (!ready()) await new Promise(done => setTimeout(done, 2)); };
  const low = Number(slider.min), high = Number(slider.max);
  for (const share of [0.5, 1]) {
    slider.value = String(share * part * (part < 0 ? -low : high));
    slider.dispatchEvent(new Event("input", {bubbles: true}));
    await new Promise(done => setTimeout(done, 30));
  }
  const start = performance.now();
  slider.dispatchEvent(new PointerEvent("pointerup", {bubbles: true}));
  await until(() => timeline.proof.value || timeline.check.value.state === "failed");
  return [(performance.now() - start) / 1000, Boolean(timeline.proof.value)]; }"""
"""Seconds from letting a slider go, at a part of its range, to the proof of the way that was driven."""

FIRST_PICTURE = """async () => {
  const {study, pose$, source$, touring: {map}} = gcrules;
  const range = ({name, low, high, unit}, n) => `${name} ${low}:${high}:${n}${unit === "deg" ? " deg" : ""}`;
  const over = n => study.value.ranges.slice(0, 2).map(axis => range(axis, n));
  const start = performance.now();
  const whole = map.start(n => ({source: source$.value, pose: pose$.value, over: over(n)}), 13);
  while (!map.shown.value && map.now.value.state !== "failed") await new Promise(done => setTimeout(done, 2));
  const first = (performance.now() - start) / 1000;
  await whole;
  return [first, (performance.now() - start) / 1000]; }"""
"""Seconds from asking for a map to its first picture, and to the finest one."""


@pytest.mark.parametrize("name", [*SIX_LEGS, *(name for name in OF_JOINTS if name != "3-rrr")])  # stuck after 3 degrees
def test_letting_go_to_the_proof(timed: Callable[..., Any], browser: Any, studio: Studio, name: str) -> None:
    with opened(browser, studio, name) as page:
        found = [page.evaluate(LET_GO, part) for part in (0.1, 0.2, -0.1, 0.25, -0.2, 0.15)]
    assert all(proved for _, proved in found)
    times = sorted(seconds for seconds, _ in found[1:])
    timed(statistics.median(times), {"first": found[0][0], "longest": times[-1]}, within=0.3)


@pytest.mark.parametrize("name", [*SIX_LEGS, *OF_JOINTS])
def test_first_picture_of_a_map(timed: Callable[..., Any], browser: Any, studio: Studio, name: str) -> None:
    with opened(browser, studio, name) as page:
        first, whole = page.evaluate(FIRST_PICTURE)
    timed(first, {"the finest picture": whole}, within=0.5)


def test_an_hour_of_use(record_property: Callable[[str, object], None], browser: Any, studio: Studio) -> None:
    """Four rounds, some thousands of actions: what the page holds after each of them."""
    with new_page(browser) as page:
        page.goto(studio.address)
        page.wait_for_selector(".card")
        actions, rounds = 0, [held(page)]
        for _ in range(4):
            actions += use(page, 250)
            rounds.append(held(page))
    sizes = ", ".join(f"{now.heap / 1e6:.1f}" for now in rounds)
    record_property("heap", [now.heap for now in rounds])
    print(f"heap after {actions:,} actions in four rounds: {sizes} MB; nodes {[now.nodes for now in rounds]}")
    assert rounds[-1].heap <= 1.5 * rounds[1].heap
    assert min(now.nodes for now in rounds[3:]) <= 1.2 * rounds[1].nodes  # some rounds end with more on show


def test_bundle(record_property: Callable[[str, object], None]) -> None:
    """All that a page may load, compressed as the server sends it; fonts are compressed already."""
    sizes = [
        path.stat().st_size if path.suffix == ".woff2" else len(gzip.compress(path.read_bytes(), 9))
        for folder in STATIC
        for path in folder.rglob("*")
        if path.is_file()
    ]
    record_property("bytes", sum(sizes))
    print(f"bundle: {sum(sizes) / 1e6:.2f} MB compressed")
    assert sum(sizes) <= 1_500_000
