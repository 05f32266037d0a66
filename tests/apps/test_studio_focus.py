"""What has the focus may be taken away by its own press: the focus then goes to what stands beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytestmark = pytest.mark.browser

if TYPE_CHECKING:
    from studio_page import Desk

FOCUSED = (
    "document.activeElement === document.body ? '' : document.activeElement.dataset.testid ?? document.activeElement.id"
)
LONG = "\n".join(
    f":shorten [[{', '.join(f'{a}{b}' for a, b in zip('ABCDEF', 'abcdef'[i:] + 'abcdef'[:i], strict=True))}]]"
    for i in range(6)
)
RULES = [
    {"name": name, "text": f"rule {rule}: ab /\\ cde => [acde] b - [bcde] a", "off": []}
    for name, rule in (("one.gca", "one"), ("two.gca", "two"))
]


def press(desk: Desk, testid: str, place: int = 0) -> None:
    """With the keyboard, without which nobody misses the focus."""
    desk.one(testid).nth(place).focus()
    desk.page.keyboard.press("Enter")


def goes_to(desk: Desk, testid: str) -> None:
    desk.page.wait_for_function(f"testid => ({FOCUSED}) === testid", arg=testid)


def test_from_a_waypoint_that_is_taken_out_to_the_next_and_then_to_what_is_left(desk: Desk) -> None:
    desk.open("example", "octahedral", "condition")
    desk.run("gcrules.edit({way: [10, 20, 30].map(z => ({...gcrules.pose$.value, translation: [0, 0, z]}))})")
    desk.one("way-remove").nth(2).wait_for()
    for index, left in ((2, 2), (1, 0)):  # one alone is no list
        press(desk, "way-remove", index)
        desk.page.wait_for_function(f"() => document.querySelectorAll('[data-testid=way-remove]').length === {left}")
        desk.page.wait_for_function("() => document.activeElement.closest('.stops') !== null")


def test_from_stop_into_the_bench(desk: Desk) -> None:
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", LONG)
    desk.one("bench-stop").wait_for()
    desk.one("bench-run").focus()
    press(desk, "bench-stop")
    desk.one("bench-stop").wait_for(state="detached")
    goes_to(desk, "bench-run")  # where it came from


def test_from_a_file_that_is_closed_to_the_next_and_then_to_open(desk: Desk) -> None:
    desk.one("panel-bench").click()
    desk.run("rules => gcrules.edit({rules})", RULES)
    desk.one("bench-rules-open").click()
    desk.one("rule-one").wait_for()
    press(desk, "rules-close-0")
    goes_to(desk, "rules-close-0")
    press(desk, "rules-close-0")
    desk.page.wait_for_function(f"() => ({FOCUSED}) !== ''")
    assert desk.run("document.activeElement.closest('[data-testid=bench-rules]') !== null")


def test_from_a_panel_that_is_left_to_the_next_one(desk: Desk) -> None:
    press(desk, "start-draw")
    goes_to(desk, "content")


def test_from_a_button_that_is_switched_off_to_the_next_one(desk: Desk) -> None:
    desk.one("panel-bench").click()
    desk.run("gcrules.edit({bench: 'ab'})")
    press(desk, "undo")
    goes_to(desk, "redo")


def test_what_is_left_with_the_mouse_stays_left(desk: Desk) -> None:
    desk.one("panel-bench").click()
    desk.one("bench-help").focus()
    desk.page.mouse.click(700, 680)
    desk.run("gcrules.edit({panel: 'start'})")
    desk.one("legs").wait_for()
    desk.painted()
    assert desk.run(FOCUSED) in ("", "content")
