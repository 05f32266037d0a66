"""The map of the studio in a browser: coarse at first, then refined, stopped when nobody looks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

LEVELS = """() => { const seen = (gcrules.levels = []); gcrules.touring.map.shown.subscribe(found => {
    if (found) seen.push(found.result.margin.length); }); }"""

CROSSED: dict[str, Any] = {
    "octahedral": [{"name": "x", "low": -490, "high": 490}, {"name": "z", "low": -490, "high": 490}],
    "3-rps": [{"name": "z", "low": -0.2, "high": 0.2}, {"name": "roll", "low": -80, "high": 80}],
}
"""Ranges with singular poses in them."""


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def opened(desk: Desk, kind: str, name: str, nodes: int) -> Desk:
    desk.open(kind, name)
    desk.one("panel-motion").click()
    desk.one("map-nodes").select_option(str(nodes))
    desk.run(LEVELS)
    return desk


def refined(desk: Desk, nodes: int) -> Any:
    """Wait for the finest level; the levels that were shown before it."""
    desk.page.wait_for_function("n => gcrules.levels.at(-1) === n", arg=nodes)
    return desk.run("gcrules.levels")


@pytest.mark.parametrize(
    ("kind", "name", "nodes", "levels"),
    [("example", "octahedral", 41, [7, 21, 41]), ("robot", "3-rps", 11, [7, 11])],
    ids=["platform", "robot"],
)
def test_a_map_comes_coarse_and_is_refined(desk: Desk, kind: str, name: str, nodes: int, levels: list[int]) -> None:
    opened(desk, kind, name, nodes)
    desk.run("over => gcrules.touring.change({over})", CROSSED[name])
    desk.one("map-go").click()
    assert refined(desk, nodes) == levels
    canvas = desk.one("map-picture").locator("canvas")
    assert canvas.get_attribute("width") == str(nodes - 1)
    found = desk.run("gcrules.touring.map.shown.value.result")
    assert desk.one("map-picture").locator("path").count() == len(found["curves"]) > 0
    field = desk.one("map-picture").locator("svg").bounding_box()
    assert field == desk.one("map-picture").locator("canvas").bounding_box(), "curves lie on their cells"
    legend = desk.text("map-legend")
    kinds = {kind for row in found["status"] for kind in row}
    for kind, words in {"free": "proved free", "crossed": "crossed", "undecided": "not decided"}.items():
        assert (words in legend) == (kind in kinds)
    assert desk.faults == []


def test_a_map_follows_its_ranges(desk: Desk) -> None:
    opened(desk, "example", "octahedral", 11).one("map-go").click()
    refined(desk, 11)
    desk.one("map-high-0").fill("250")
    desk.one("map-high-0").press("Enter")
    desk.page.wait_for_function("() => gcrules.touring.map.shown.value?.result.axes[0].high === 250")
    desk.one("map-axis-0").select_option("z")
    desk.page.wait_for_function("() => gcrules.touring.map.shown.value?.result.axes[0].name === 'z'")


def test_a_map_is_stopped_when_nobody_looks(desk: Desk) -> None:
    """What is there is kept; another robot has none."""
    opened(desk, "robot", "delta", 81).one("map-go").click()
    desk.page.wait_for_function("() => gcrules.levels.length > 0")
    desk.one("panel-guided").click()
    desk.page.wait_for_function("() => gcrules.touring.map.now.value.state === 'idle'")
    desk.one("panel-motion").click()
    assert desk.one("map-go").is_enabled()
    assert desk.one("map-picture").is_visible()
    desk.open("example", "octahedral")
    assert desk.run("gcrules.touring.map.shown.value") is None
