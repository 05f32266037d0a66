"""The map of the studio in a browser: coarse at first, then refined, stopped when nobody looks; and the locus."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

FILE = str(EXAMPLES / "octahedral.yaml")
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
    [("example", "octahedral", 41, [5, 21, 41]), ("robot", "3-rps", 11, [5, 11])],
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
    others = {"octahedral": "y = 0, no rotation", "3-rps": "pitch = 0°"}[name]
    assert desk.text("map-fixed") == f"Everywhere in this map: {others}."
    legend = desk.text("map-legend")
    kinds = {kind for row in found["status"] for kind in row}
    for kind, words in {"free": "proved free", "crossed": "crossed", "undecided": "not decided"}.items():
        assert (words in legend) == (kind in kinds)
    assert desk.faults == []


def test_the_map_shows_where_the_robot_is(desk: Desk) -> None:
    opened(desk, "example", "octahedral", 11).one("map-go").click()
    refined(desk, 11)
    outside = "The robot is outside this map"
    for at, words, turn in (
        ([80, -60, 0], "The robot", "0deg"),
        ([900, 0, 0], outside, "0deg"),
        ([-900, 0, 0], outside, "180deg"),
        ([0, 900, 0], outside, "-90deg"),
        ([900, -900, 0], outside, "45deg"),
    ):
        desk.run("at => gcrules.edit({pose: {translation: at, quaternion: [1, 0, 0, 0]}})", at)
        desk.page.wait_for_function("at => gcrules.touring.here.value?.at.every((c, i) => c === at[i])", arg=at)
        mark = desk.one("map-robot")
        assert mark.get_attribute("aria-label") == words
        assert mark.evaluate("mark => mark.style.getPropertyValue('--turn')") == turn
        field, dot = desk.one("map-picture").locator("canvas").bounding_box(), mark.bounding_box()
        part = (dot["x"] + dot["width"] / 2 - field["x"]) / field["width"]
        low, high = (desk.run("gcrules.touring.map.shown.value.result.axes[0]")[end] for end in ("low", "high"))
        assert part == pytest.approx(min(max((at[0] - low) / (high - low), 0), 1), abs=0.01)
    assert desk.one("map-elsewhere").count() == 0
    desk.run("gcrules.edit({pose: {translation: [80, 0, 30], quaternion: [1, 0, 0, 0]}})")
    assert desk.text("map-elsewhere").startswith(
        "The robot is not in this map, as it stands at another place: z = 30 mm, no rotation."
    )
    desk.one("map-again").click()
    desk.one("map-elsewhere").wait_for(state="detached")
    assert desk.text("map-fixed") == "Everywhere in this map: z = 30 mm, no rotation."
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


# --- the locus -----------------------------------------------------------------------------------------------------


def test_the_locus_is_a_function_that_vanishes_where_the_path_crosses(desk: Desk) -> None:
    """What is copied for Python is 0 at the singular poses that `gc.path` finds, and nowhere between them."""
    desk.open("example", "octahedral").one("panel-motion").click()
    desk.one("locus-position").click()
    desk.one("locus-python").first.click()
    scope: dict[str, Any] = {}
    exec(desk.one("locus-text").first.inner_text(), scope)
    heights = [z.parameter * -490 for z in gc.path(FILE, ["home", "0 0 -490"]).zeros]
    assert len(heights) == 3
    size = abs(scope["P"](0, 0, 0))
    assert [scope["P"](0, 0, z) / size for z in heights] == pytest.approx([0] * 3, abs=1e-9)
    signs = [scope["P"](0, 0, z) > 0 for z in (0, -352, -380, -490)]
    assert signs == [signs[0], not signs[0], signs[0], not signs[0]]
    desk.one("locus-latex").first.click()
    assert "z^{3}" in desk.one("locus-text").first.inner_text()
    named = desk.one("locus-factor").all_inner_texts()
    assert [words.split("\n")[0] for words in named] == [
        "Factor 1: a plane with the normal (0, 0, 1)",
        "Factor 2: a hyperbolic paraboloid",
    ]
    assert desk.faults == []


def test_the_locus_of_a_robot_of_joints_is_that_of_the_slice(desk: Desk) -> None:
    desk.open("robot", "3-rps").one("panel-motion").click()
    desk.run("over => gcrules.touring.change({over})", CROSSED["3-rps"])
    desk.one("locus-slice").click()
    same = gc.locus("3-rps", "z, roll", at="pitch=0deg")
    desk.one("locus-text").first.wait_for()
    assert desk.run("gcrules.touring.locus.now.value.result.variables") == ["z", "t_roll"]
    parts = desk.run("gcrules.touring.locus.now.value.result.parts")
    assert [p["polynomial"]["plain"] for p in parts] == [str(p.form) for p in same.parts]
    assert [len(p["factors"]) for p in parts] == [len(p.factors) for p in same.parts]
    assert desk.one("locus-factor").count() == sum(len(p.factors) for p in same.parts if len(p.factors) > 1)


def test_the_turn_of_a_locus_has_short_numbers_and_says_so(desk: Desk) -> None:
    desk.open("example", "octahedral").one("panel-motion").click()
    desk.slide("rz", 20)
    desk.answered()
    desk.one("locus-position").click()
    desk.one("locus-text").first.wait_for()
    (note,) = desk.run("gcrules.touring.locus.now.value.result.notes")
    assert "quaternion 1, 0, 0, " in note
    assert "° from that of the pose" in note


def test_a_function_with_roots_vanishes_at_the_nearest_singular_configuration(desk: Desk) -> None:
    """Of Delta over its position the roots stay in, and the function takes the working mode."""
    desk.open("robot", "delta").one("panel-motion").click()
    desk.one("locus-position").click()
    desk.one("locus-python").first.click()
    assert desk.page.get_by_test_id("locus-root").count() == 3
    scope: dict[str, Any] = {}
    exec(desk.one("locus-text").first.inner_text(), scope)
    nearest = gc.pose("delta").nearest
    assert nearest is not None
    at = [nearest.coordinates[n] for n in "xyz"]
    value = scope["P1"]
    assert abs(value(*at) / value(0, 0, 0)) < 1e-6
    assert abs(value(*at, 1, -1, 1) / value(0, 0, 0)) > 1e-3
    assert desk.faults == []


@pytest.mark.parametrize(
    ("name", "over", "offered"),
    [
        ("gough-stewart", ("x", "y"), True),
        ("gough-stewart", ("x", "rx"), False),  # the turn of six legs has no angles among its variables
        ("delta", ("x", "z"), True),
        ("delta", ("roll", "pitch"), False),  # they follow from x, y and z
        ("delta", ("q1", "q2"), False),
        ("4-rpr", ("x", "y"), False),
    ],
)
def test_a_formula_is_offered_over_coordinates_that_it_may_have(
    desk: Desk, name: str, over: tuple[str, str], offered: bool
) -> None:
    desk.open("robot", name).one("panel-motion").click()
    desk.run("over => gcrules.touring.change({over})", [{"name": n, "low": -0.1, "high": 0.1} for n in over])
    desk.one("map-go").wait_for()
    desk.painted()
    assert desk.one("locus-slice").is_visible() == offered
    assert desk.one("locus-position").is_visible() == (name != "4-rpr")
    assert desk.one("locus-none").count() == (name == "4-rpr")
