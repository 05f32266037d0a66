"""The studio as a workbench: commands and keys."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

KINDS = [("example", "octahedral"), ("robot", "delta")]
"""A platform on six legs, and a robot of joints."""


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def rows(desk: Desk) -> list[str]:
    """The titles in the list of commands."""
    return [str(title) for title in desk.page.locator(".palette .row .title").all_inner_texts()]


def command(desk: Desk, words: str) -> None:
    """Open the list, type, and do what stands first."""
    desk.page.keyboard.press("Control+k")
    desk.one("command").fill(words)
    desk.page.keyboard.press("Enter")
    desk.one("commands").wait_for(state="detached")


@pytest.mark.parametrize(("kind", "name"), KINDS)
def test_everything_is_done_by_commands(desk: Desk, kind: str, name: str) -> None:
    desk.page.keyboard.press("Control+k")
    before = rows(desk)
    assert "Start" in before
    assert "Steps" not in before, "nothing is open"
    desk.page.keyboard.press("Escape")
    desk.page.keyboard.press("Control+k")
    desk.one("command").fill(name)
    desk.one(f"command-open-{kind}-{name}").click()
    desk.page.wait_for_function("() => gcrules.study.value")
    desk.answered()
    source = desk.run("gcrules.source$.value")
    assert source["kind"] == kind
    assert name in str(source)
    command(desk, "take away")
    desk.page.wait_for_selector(".take-away")
    command(desk, "dark colours")
    assert desk.run("document.documentElement.dataset.theme") == "dark"
    command(desk, "layer grid")
    assert desk.run("gcrules.space.layers.value.grid") is False
    command(desk, "picture alone")
    assert desk.run("gcrules.space.large.value") is True
    desk.page.keyboard.press("Escape")
    assert desk.run("gcrules.space.large.value") is False
    for kind in ("png", "svg"):
        with desk.page.expect_download() as saving:
            command(desk, f"save picture {kind}")
        assert saving.value.suggested_filename.endswith(f"view.{kind}")
    desk.run("gcrules.edit({threshold: '1 deg'})")
    command(desk, "undo")
    assert desk.run("gcrules.threshold$.value") != "1 deg"
    command(desk, "redo")
    assert desk.run("gcrules.threshold$.value") == "1 deg"
    assert desk.faults == []


def test_the_list_of_commands_by_keyboard_mouse_and_touch(desk: Desk) -> None:
    field = desk.one("command")
    desk.one("palette").click()
    field.wait_for()
    assert field.evaluate("field => field === document.activeElement")
    desk.page.keyboard.press("ArrowDown")
    assert field.get_attribute("aria-activedescendant") == "command-1"
    field.fill("3rps")
    desk.one("commands").get_by_text("3-RPS").first.wait_for()  # when the gallery has come
    field.fill("no such thing")
    assert "Nothing matches" in str(desk.one("commands").inner_text())
    desk.page.keyboard.press("Enter")
    assert desk.one("commands").is_visible()
    field.fill("bench")
    desk.one("command-panel-bench").click()
    desk.one("commands").wait_for(state="detached")
    assert desk.run("gcrules.panel$.value") == "bench"
    desk.page.locator(".cm-content").click()
    desk.page.keyboard.press("Control+k")
    desk.one("commands").wait_for()
    desk.page.mouse.click(5, 5)
    desk.one("commands").wait_for(state="detached")
    desk.page.wait_for_function("() => document.activeElement.classList.contains('cm-content')")  # the focus goes back


def test_all_keys_are_listed_and_act(desk: Desk) -> None:
    desk.open("example", "octahedral")
    desk.page.keyboard.press("?")
    listed = desk.page.locator("[data-testid=key-list] [data-keys]").evaluate_all("all => all.map(e => e.dataset.keys)")
    for keys in ["1", "Mod z", "Mod Shift z, Mod y", "f", "Mod k", "?", "Escape", "Alt Arrows"]:
        assert keys in listed
    desk.one("key-list-close").click()
    press: Callable[[str], Any] = desk.page.keyboard.press
    press("n")
    assert desk.run("gcrules.stage$.value") == desk.study["stages"][1]["id"]
    press("b")
    assert desk.run("gcrules.stage$.value") == desk.study["stages"][0]["id"]
    press("3")
    assert desk.run("gcrules.panel$.value") == "manual"
    desk.slide("z", -100)
    desk.answered()
    desk.let_go("z")
    press("Control+z")
    assert desk.pose["translation"] == [0, 0, 0]
    press("Control+Shift+Z")
    assert desk.pose["translation"] == [0, 0, -100]
    press("h")
    desk.page.wait_for_function("() => gcrules.pose$.value.translation[2] === 0")
    press("t")
    assert desk.run("document.documentElement.dataset.theme") == "dark"


def test_single_keys_can_be_switched_off_and_do_nothing_where_one_writes(desk: Desk) -> None:
    desk.one("gallery-search").fill("")
    desk.one("gallery-search").press("7")
    assert desk.run("gcrules.panel$.value") == "start"
    desk.one("gallery-search").blur()
    desk.one("keys").click()
    desk.one("single-keys").uncheck()
    desk.page.keyboard.press("Escape")
    desk.page.keyboard.press("7")
    assert desk.run("gcrules.panel$.value") == "start"
    desk.page.reload()
    desk.page.wait_for_selector("[data-testid=line][data-line=open]", state="attached")
    desk.page.keyboard.press("7")
    assert desk.run("gcrules.panel$.value") == "start"
    desk.one("keys").click()
    desk.one("single-keys").check()
    desk.page.keyboard.press("Escape")
    desk.page.keyboard.press("7")
    assert desk.run("gcrules.panel$.value") == "bench"


def test_what_is_shown_is_repeated_by_lines(desk: Desk) -> None:
    desk.open("example", "octahedral")
    desk.slide("z", -100)
    desk.answered()
    desk.let_go("z")
    desk.page.wait_for_selector("[data-testid=way][data-proved=true]")
    desk.run("gcrules.edit({bench: '[abcd] == -[bacd]'})")
    desk.page.keyboard.press("r")
    name = desk.page.get_by_test_id("repeat-of-pose").locator("code").inner_text()
    lines = [str(line) for line in desk.page.locator(".repeat pre").all_inner_texts()]
    assert lines[1] == f'gcrules pose {name} --at "0 0 -100"'
    desk.page.wait_for_selector("[data-testid=repeat-of-bench] pre")
    lines = [str(line) for line in desk.page.locator(".repeat pre").all_inner_texts()]
    assert f'gcrules path {name} --at "0 0 0" --at "0 0 -100"' in lines
    with desk.page.expect_download() as saving:
        desk.one("repeat-file-pose").click()
    assert saving.value.suggested_filename == name
    desk.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    desk.one("repeat-python").click()
    desk.one("repeat-copy-pose").click()
    desk.page.wait_for_selector(".notice.told")
    copied = str(desk.run("navigator.clipboard.readText()"))
    assert copied.splitlines()[-1] == 'print(gc.pose(robot, at="0 0 -100"))'
    assert "prove" in desk.page.get_by_test_id("repeat-of-bench").locator("pre").inner_text()
    desk.one("repeat-close").click()
    desk.open("robot", "delta")
    desk.slide("0", 3)
    desk.answered()
    desk.one("repeat").click()
    desk.page.wait_for_selector("[data-testid=repeat-of-pose] pre")
    assert desk.page.locator("[data-testid=repeat-of-pose] pre").inner_text() == (
        'gcrules pose delta --actuators "q1=3deg, q2=0deg, q3=0deg"'
    )
    assert desk.faults == []
