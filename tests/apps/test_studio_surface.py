"""The singular surface in the studio's picture: coarse at first, then refined, grey once it holds no more."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")
pytest.importorskip("skimage", reason="needs the extra gcrules[maps]")

from studio_page import Desk

pytestmark = pytest.mark.browser

DRAWN = """async () => { const svg = await gcrules.space.viewer.value.snapshot("svg");
    return [...svg.matchAll(/shape-rendering="crispEdges"/g)].length }"""
"""How many triangles of a surface there are in a picture of the scene."""
LEVELS = """() => { const seen = (gcrules.levels = []); gcrules.touring.surface.shown.subscribe(found => {
    if (found) seen.push(found.result.nodes[0]); }); }"""
NAMED = "[role=application][aria-label*='singular surface']"


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def asked(desk: Desk, nodes: int) -> Any:
    """The surface with so many poses along each coordinate; the triangles in the picture."""
    desk.run("n => gcrules.touring.change({fineness: n})", nodes)
    desk.one("surface-go").click()
    desk.page.wait_for_function("n => gcrules.touring.surface.shown.value?.result.nodes[0] === n", arg=nodes)
    desk.painted()
    return desk.run(DRAWN)


def test_a_surface_is_drawn_refined_switched_off_and_left_behind(desk: Desk) -> None:
    desk.open("example", "octahedral").one("panel-motion").click()
    assert desk.run(DRAWN) == 0
    desk.run(LEVELS)
    triangles = asked(desk, 13)
    assert desk.run("gcrules.levels") == [5, 7, 13]
    assert triangles == desk.run("gcrules.touring.surface.shown.value.result.faces.length") / 3 > 100
    assert desk.page.locator(NAMED).count() == 1
    assert "cells are proved free" in desk.text("surface-guarantee")
    assert "of 1,728 cells (12 × 12 × 12) are proved free" in desk.text("surface-share")

    desk.one("surface-shown").press("Space")
    desk.painted()
    assert desk.run(DRAWN) == 0
    desk.one("layers").click()
    desk.one("layer-surface").check()
    desk.painted()
    assert desk.run(DRAWN) == triangles

    desk.slide("x", 30)
    desk.answered()
    assert desk.one("surface-stale").count() == 0, "it holds wherever the platform is shifted to"
    desk.slide("rx", 20)
    desk.let_go("rx")
    desk.one("surface-stale").wait_for()
    assert desk.one("surface-nearest").is_disabled()
    desk.one("surface-again").click()
    desk.one("surface-stale").wait_for(state="detached")
    desk.page.wait_for_function("() => gcrules.levels.length === 6")
    desk.one("surface-nearest").press("Enter")
    desk.page.wait_for_function("() => gcrules.posing.numbers.value?.margin < 1e-6")
    assert desk.pose["quaternion"][0] < 0.99

    desk.open("example", "platform-6-6")
    desk.painted()
    assert desk.run(DRAWN) == 0
    assert desk.page.locator(NAMED).count() == 0
    assert desk.faults == []


def test_the_surface_of_a_robot_of_joints(desk: Desk) -> None:
    desk.open("robot", "orthoglide").one("panel-motion").click()
    for name in "xyz":
        for end, value in (("low", "0"), ("high", "2")):
            desk.one(f"surface-{end}-{name}").fill(value)
            desk.one(f"surface-{end}-{name}").press("Enter")
    assert asked(desk, 3) == 7
    assert "drawn between the nodes" in desk.text("surface-share")
    assert desk.faults == []


def test_what_to_use_where_there_is_no_surface(desk: Desk) -> None:
    desk.open("robot", "3-rps").one("panel-motion").click()
    desk.one("surface-go").click()
    fault = desk.page.get_by_label("Singular surface", exact=True).get_by_test_id("fault")
    fault.wait_for()
    assert "not free in x, y and z" in fault.inner_text()
    assert "map two of its freedoms z, roll and pitch" in fault.inner_text()
    desk.open("robot", "3-rpr").one("panel-motion").click()
    assert "freedoms of this robot are x, y, yaw" in desk.text("surface-instead")
    assert desk.one("surface-go").count() == 0


def test_its_ranges_stand_in_the_link_and_in_the_project(desk: Desk) -> None:
    desk.open("example", "octahedral").one("panel-motion").click()
    low = desk.one("surface-low-x")
    low.fill("-123")
    low.press("Enter")
    desk.one("surface-nodes").select_option("13")
    kept = "tour => tour.box?.[0].low === -123 && tour.fineness === 13"
    desk.page.wait_for_function(f"() => ({kept})(gcrules.tour$.value)")
    desk.run("gcrules.projecting.keep()")
    assert desk.run(f"({kept})(JSON.parse(gcrules.projecting.text()).robots[0].state.tour)")
    desk.page.reload()
    desk.page.wait_for_function(f"() => window.gcrules && ({kept})(gcrules.tour$.value)")
    desk.page.wait_for_function("() => document.querySelector('[data-testid=surface-low-x]')?.value.includes('123')")
    desk.open("example", "platform-6-6")
    assert desk.run("gcrules.tour$.value.box") is None
