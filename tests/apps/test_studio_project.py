"""The project of the studio: robots, poses, ways and notes in one file; and undo over a reload."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

LINE = "[data-testid=line][data-line=open]"


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def filled(desk: Desk) -> None:
    """A platform on six legs with a way and a pose, and a robot of joints with a pose."""
    desk.open("example", "octahedral")
    for z in (-60, -100):
        desk.slide("z", z)
        desk.answered()
    desk.let_go("z")
    desk.one("panel-project").click()
    desk.one("project-keep").click()
    desk.one("project-keep-pose").click()
    desk.open("robot", "delta")
    desk.slide("0", 3)
    desk.answered()
    desk.let_go("0")
    desk.page.keyboard.press("Control+s")
    desk.one("panel-project").click()
    desk.one("project-keep-pose").click()
    desk.one("project-title").fill("Two robots")
    desk.one("project-note").fill("to compare")
    desk.one("project-note-1").fill("the fast one")


def test_a_project_is_saved_and_opened(desk: Desk, sit_down: Callable[..., Desk], tmp_path: Path) -> None:
    filled(desk)
    with desk.page.expect_download() as saving:
        desk.one("project-save").click()
    assert saving.value.suggested_filename == "two-robots-project.json"
    path = tmp_path / "two.json"
    saving.value.save_as(path)
    data = json.loads(path.read_text(encoding="utf-8"))
    assert data["format"] == 1
    assert [len(robot["poses"]) for robot in data["robots"]] == [1, 1]
    assert [len(robot["way"]) for robot in data["robots"]] == [2, 2]

    other = sit_down().visit()
    other.one("file").set_input_files(path)
    other.one("project-robot-1").wait_for()
    assert other.one("project-title").input_value() == "Two robots"
    assert other.one("project-note-1").input_value() == "the fast one"
    other.one("project-show-0").click()
    other.answered()
    assert other.pose["translation"] == [0, 0, -100]
    other.page.wait_for_selector("[data-testid=way][data-proved=true]")
    assert len(other.run("gcrules.timeline.stops.value")) == 2
    other.one("panel-project").click()
    other.one("project-pose-1-0").click()
    other.answered()
    assert other.pose["coordinates"] == [3, 0, 0]
    other.one("panel-project").click()
    other.one("project-remove-0").click()
    assert other.page.get_by_test_id("project-robot-1").count() == 0
    assert desk.faults == other.faults == []


def test_a_file_with_a_fault_changes_nothing(desk: Desk, tmp_path: Path) -> None:
    filled(desk)
    data = json.loads(str(desk.run("gcrules.projecting.text()")))
    data["robots"][1]["state"]["source"]["kind"] = "robo"
    path = tmp_path / "broken.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    before = desk.run("gcrules.projecting.text()")
    desk.one("project-file").set_input_files(path)
    fault = desk.page.locator(".project .fault")
    fault.wait_for()
    assert "broken.json: robots[2].state.source is not understood" in fault.inner_text()
    assert desk.run("gcrules.projecting.text()") == before


def test_undo_and_the_project_survive_a_reload(desk: Desk) -> None:
    filled(desk)
    desk.page.reload()
    desk.page.wait_for_selector(LINE, state="attached")
    desk.answered()
    assert desk.one("project-title").input_value() == "Two robots"
    assert desk.pose["coordinates"] == [3, 0, 0]
    desk.one("undo").click()
    desk.answered()
    assert not any(desk.pose.get("coordinates", []))
    desk.one("undo").click()
    desk.page.wait_for_function("() => gcrules.study.value?.kind === 'platform'")
    assert desk.pose["translation"] == [0, 0, -100]
    desk.one("redo").click()
    desk.page.wait_for_function("() => gcrules.study.value?.kind === 'robot'")
    desk.page.evaluate("history.replaceState(null, '', location.pathname)")
    other = desk.page.context.new_page()
    other.goto(desk.page.url)
    other.wait_for_selector(LINE, state="attached")
    assert other.get_by_test_id("undo").is_disabled(), "another tab starts over"
