"""Rounds of use of the studio's page, all alike, and what the page holds in memory after each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

__all__ = ["SOURCES", "Held", "held", "use"]

SOURCES = (
    {"kind": "example", "name": "octahedral"},
    {"kind": "robot", "id": "delta"},
    {"kind": "class", "id": "6-4.2"},
    {"kind": "robot", "id": "3-rps"},
)

ROUND = """async ([sources, moves]) => {
  const later = ms => new Promise(done => setTimeout(done, ms));
  const until = async ready => {
    for (let k = 0; k < 12000; k++) {
      if (ready()) return;
      await later(5);
    }
    throw new Error(`it never comes: ${ready}`);
  };
  const SLIDER = "[data-testid^=slider-][type=range]";
  const frame = () => new Promise(done => requestAnimationFrame(done));
  const idle = now => now.value.state !== "busy";
  let actions = 0;
  const act = async what => { what(); actions += 1; await later(0); };
  for (const source of sources) {
    const {posing, loaded, timeline, undo, redo} = gcrules;
    const settled = () => loaded.value.state === "ready" && posing.numbers.value && idle(timeline.check);
    await act(() => gcrules.open(source));
    await until(() => loaded.value.state === "ready" && posing.numbers.value);
    for (const tab of document.querySelectorAll("[data-testid^=panel-]")) await act(() => tab.click());
    await act(() => gcrules.go({panel: "guided"}));
    await until(() => document.querySelector(SLIDER));
    const slider = document.querySelector(SLIDER), far = 0.2 * slider.max;
    for (let k = 1; k <= moves; k++) {
      await act(() => {
        slider.value = String(far * Math.sin(k / 5));
        slider.dispatchEvent(new Event("input", {bubbles: true}));
      });
      if (k % 4 === 0) await frame();
    }
    await act(() => slider.dispatchEvent(new Event("pointerup", {bubbles: true})));
    await later(50);
    await until(() => idle(timeline.check));
    for (let k = 0; k < 5; k++) await act(undo);
    for (let k = 0; k < 5; k++) await act(redo);
    await until(settled); // what was undone may be that it was opened, and then it is opened again
    for (let k = 0; k < 2; k++) await frame();
  }
  return actions; }"""


@dataclass(frozen=True)
class Held:
    """After the garbage was collected: bytes of JavaScript, nodes of documents, detached ones among them, listeners."""

    heap: int
    nodes: int
    listeners: int


def use(page: Any, moves: int = 40, sources: Sequence[dict[str, str]] = SOURCES) -> int:
    """One round: each source is opened, all panels are looked at, a slider is moved so many times and let go, steps are
    undone and redone. How many actions these were.
    """
    return int(page.evaluate(ROUND, [list(sources), moves]))


def held(page: Any) -> Held:
    """What the page holds now."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")
    for _ in range(3):  # what only the first one freed may hold more
        session.send("HeapProfiler.collectGarbage")
    found = {m["name"]: int(m["value"]) for m in session.send("Performance.getMetrics")["metrics"]}
    session.detach()
    return Held(found["JSHeapUsedSize"], found["Nodes"], found["JSEventListeners"])
