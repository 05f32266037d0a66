"""The tour: each stop leads to its place and points at a part of the page that is there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from studio_page import Desk

pytestmark = pytest.mark.browser


def count(desk: Desk) -> int:
    return int(desk.page.locator("[data-testid=tour] .count").inner_text().split(" of ")[1])


def test_every_stop_points_at_something(desk: Desk) -> None:
    desk.one("start-tour").click()
    stops = count(desk)
    assert stops >= 8
    for k in range(1, stops):
        before = desk.page.locator("[data-toured]").evaluate_all("all => all.map(one => one.dataset.testid)")
        desk.one("tour-next").click()
        desk.page.wait_for_function(
            """([k, before]) => { const marked = [...document.querySelectorAll("[data-toured]")];
            return document.querySelector("[data-testid=tour] .count").innerText.startsWith(`${k} of`)
                && marked.length === 1 && marked[0].dataset.testid !== before }""",
            arg=[k + 1, before[0] if before else None],
        )
        assert desk.page.evaluate("() => document.activeElement.dataset.testid") == "tour-next"
    assert desk.run("gcrules.source$.value") == {"kind": "example", "name": "octahedral"}
    desk.one("tour-next").click()
    desk.one("tour").wait_for(state="detached")
    assert desk.page.locator("[data-toured]").count() == 0
    assert desk.run("gcrules.panel$.value") == "start"


def test_the_way_down_crosses_singular_poses(desk: Desk) -> None:
    """What the tour says of its robot is so."""
    desk.one("start-tour").click()
    for _ in range(4):
        desk.one("tour-next").click()
    desk.one("crossed").wait_for()
    desk.one("tour-next").click()
    desk.page.wait_for_function("() => window.gcrules.timeline.proof.value !== null")
    found = desk.run("gcrules.timeline.proof.value")
    assert len(found["places"]) >= 2


def test_it_ends_at_any_time_and_the_robot_before_comes_back(desk: Desk) -> None:
    desk.open("robot", "3-rps")
    desk.run("gcrules.front.tour.value = 2")
    desk.page.locator("[data-toured]").wait_for()
    desk.page.keyboard.press("Escape")
    desk.one("tour").wait_for(state="detached")
    desk.one("undo").click()
    desk.page.wait_for_function("() => window.gcrules.source$.value.id === '3-rps'")


@pytest.mark.parametrize("width", [390, 320])
def test_it_fits_a_phone(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 700}).visit()
    desk.one("start-tour").click()
    for _ in range(count(desk) - 1):
        box = desk.one("tour").bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        assert box["y"] >= 0
        desk.one("tour-next").click()
    assert desk.run("document.documentElement.scrollWidth") <= width
