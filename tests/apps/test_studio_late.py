"""While an answer is late the page says that it computes, and the verdict before is pale."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

VERDICT = "section.verdict"
FADED = f"() => getComputedStyle(document.querySelector('{VERDICT} .word')).opacity"


class Line:
    """The line to the server, whose answers can be held back."""

    def __init__(self, page: Any) -> None:
        self.held: list[Any] = []
        self.open = True
        page.route_web_socket(re.compile("/ws$"), self._connect)

    def _connect(self, route: Any) -> None:
        self._route, server = route, route.connect_to_server()
        server.on_message(self._heard)

    def _heard(self, message: Any) -> None:
        if self.open:
            self._route.send(message)
        else:
            self.held.append(message)

    def release(self) -> None:
        self.open = True
        while self.held:
            self._route.send(self.held.pop(0))


@pytest.mark.parametrize(("lead", "slider"), [("actuators", "0"), ("platform", "z")])
def test_a_late_answer_is_said_to_be_under_way(sit_down: Callable[..., Desk], lead: str, slider: str) -> None:
    desk = sit_down()
    line = Line(desk.page)
    desk.visit().open("robot", "3-rps")
    desk.one("led").select_option(lead)
    mark = desk.page.get_by_test_id("computing")
    assert mark.count() == 0
    before = desk.text("verdict"), desk.text("margin")
    line.open = False
    desk.slide(slider, 0.2)
    mark.wait_for()
    assert mark.inner_text().strip() == "computing …"
    assert mark.locator(".spinner").evaluate("e => getComputedStyle(e).animationName") == "none", "nothing moves"
    assert desk.page.locator(VERDICT).get_attribute("aria-busy") == "true"
    assert float(desk.run(FADED)) < 0.6
    assert (desk.text("verdict"), desk.text("margin")) == before
    line.release()
    mark.wait_for(state="detached")
    desk.answered()
    assert desk.page.locator(VERDICT).get_attribute("aria-busy") == "false"
    assert float(desk.run(FADED)) == 1
    assert desk.text("margin") != before[1]


def test_nobody_waits_for_the_proof_of_a_way_that_goes_on(sit_down: Callable[..., Desk]) -> None:
    """It would be computed beside the numbers of the moves that follow."""
    desk = sit_down()
    line = Line(desk.page)
    desk.visit().open("example", "octahedral")
    desk.slide("z", -20)
    desk.answered()
    desk.run("gcrules.timeline.stop")
    line.open = False
    desk.let_go("z")
    desk.page.wait_for_function("() => gcrules.timeline.check.value.state === 'busy'")
    desk.slide("z", -30)
    desk.page.wait_for_function("() => gcrules.timeline.check.value.state === 'idle'")
    line.release()
    desk.answered()
    desk.let_go("z")
    desk.page.wait_for_selector("[data-testid=way][data-proved=true]")
    assert desk.run("gcrules.timeline.proof.value.places.length") == 0
