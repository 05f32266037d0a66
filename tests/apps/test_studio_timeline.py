"""The timeline of the studio: no singular pose of a way is crossed unnoticed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

FILE = str(EXAMPLES / "octahedral.yaml")
PROVED = "[data-testid=way][data-proved=true]"


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit().open("example", "octahedral")


def drive(desk: Desk, *heights: float) -> None:
    """The slider of z dragged through these and let go."""
    for z in heights:
        desk.slide("z", z)
        desk.answered()
    desk.let_go("z")


def stops(desk: Desk) -> list[Any]:
    return list(desk.run("gcrules.timeline.stops.value"))


def test_crossings_of_a_drag_are_told_at_once_then_all_of_them_proved(desk: Desk) -> None:
    """From regular to regular: the verdict says nothing, the way has three singular poses."""
    desk.slide("z", -340)
    desk.answered()
    assert desk.page.get_by_test_id("crossed").count() == 0
    desk.run("gcrules.timeline.stop")
    desk.slide("z", -352)
    desk.answered()
    desk.page.wait_for_selector("[data-testid=crossed]")
    assert "meet in a point" in desk.text("crossed")
    drive(desk, -360, -400, -490)
    desk.verdict("regular")
    desk.page.wait_for_selector(PROVED)
    same = gc.path(FILE, ["home", "0 0 -490"])
    shown = desk.page.locator("[data-testid=way-place] b").all_inner_texts()
    assert shown == [f"z = \N{MINUS SIGN}{-float(z.pose.translation[2]):.5g} mm" for z in same.zeros]
    assert desk.page.get_by_test_id("way-mark").count() == 3
    assert f"through 3 singular poses, proved; the last at {shown[-1]}." in desk.text("crossed")
    assert "3 places" in desk.text("way-verdict")
    assert len(stops(desk)) == 2
    desk.one("crossed-close").click()
    assert desk.page.get_by_test_id("crossed").count() == 0
    assert desk.page.get_by_test_id("way-mark").count() == 3


def test_what_an_alert_names_is_drawn_at_its_pose_in_every_step(desk: Desk) -> None:
    desk.step("structure")
    drive(desk, -352)
    desk.page.wait_for_selector("[data-testid=crossed][data-proved=true]")
    assert drawn(desk) == []
    assert "proved at z = \N{MINUS SIGN}350 mm." in desk.text("crossed")
    desk.one("crossed-go").click()
    desk.answered()
    desk.verdict("singular")
    desk.page.wait_for_function("() => gcrules.space.viewer.value.scene.constructed.length > 0")
    assert drawn(desk) == [entity["id"] for entity in desk.study["entities"]]
    assert "abc" in desk.page.get_by_label("Entities").inner_text()
    desk.slide("z", -200)
    desk.answered()
    assert drawn(desk) == [], "the step shows no more than it has come to"


def drawn(desk: Desk) -> list[Any]:
    return list(desk.run("gcrules.space.viewer.value.scene.entities.map(e => e.id)"))


def test_two_crossings_between_two_moves_are_found_by_the_proof(desk: Desk) -> None:
    """Where the sign is the same again, only the proof tells."""
    drive(desk, -340, -380)
    desk.page.wait_for_selector("[data-testid=crossed][data-proved=true]")
    assert desk.page.get_by_test_id("way-mark").count() == 2


def test_the_way_is_led_along_and_played(desk: Desk) -> None:
    drive(desk, -200, -490)
    desk.page.wait_for_selector(PROVED)
    desk.one("way-place-go").first.click()
    desk.answered()
    assert desk.pose["translation"][2] == pytest.approx(-350, abs=1e-6)
    desk.verdict("singular")
    desk.one("way-lead").evaluate("e => { e.value = '0.5'; e.dispatchEvent(new Event('input', {bubbles: true})); }")
    desk.answered()
    assert desk.pose["translation"][2] == pytest.approx(-245)
    chart = desk.one("way-chart").bounding_box()
    desk.page.mouse.click(chart["x"] + chart["width"] / 4, chart["y"] + 20)
    desk.page.wait_for_function("() => Math.abs(gcrules.pose$.value.translation[2] + 122.5) < 3")
    assert len(stops(desk)) == 2, "leading is no driving"
    assert desk.page.get_by_test_id("way-mark").count() == 3
    desk.one("way-speed").select_option("4")
    desk.one("way-play").click()
    desk.page.wait_for_function("() => gcrules.timeline.at.value === 1 && !gcrules.timeline.playing.value")
    assert desk.pose["translation"][2] == pytest.approx(-490)
    desk.one("way-loop").check()
    desk.one("way-play").click()
    desk.page.wait_for_function("() => gcrules.timeline.at.value > 0.8")
    desk.page.wait_for_function("() => gcrules.timeline.at.value < 0.5")
    desk.one("way-play").click()
    assert not desk.run("gcrules.timeline.playing.value")
    desk.one("undo").click()
    desk.answered()


def test_driving_on_from_the_middle_begins_a_way_there(desk: Desk) -> None:
    drive(desk, -490)
    desk.page.wait_for_selector(PROVED)
    desk.one("way-lead").evaluate("e => { e.value = '0.2'; e.dispatchEvent(new Event('input', {bubbles: true})); }")
    desk.answered()
    drive(desk, -120)
    desk.page.wait_for_selector(PROVED)
    assert stops(desk)[-1]["translation"] == [0, 0, -120]
    assert desk.page.get_by_test_id("way-mark").count() == 0
    assert desk.text("way-verdict").startswith("No pose of the path is singular")


def test_waypoints_are_added_moved_put_and_taken_out(desk: Desk) -> None:
    drive(desk, -100)
    desk.one("way-add").click()
    desk.slide("x", 60)
    desk.answered()
    desk.one("way-add").click()
    assert [s["translation"] for s in stops(desk)] == [[0, 0, 0], [0, 0, -100], [0, 0, -100], [60, 0, -100]]
    desk.one("way-remove").nth(2).click()
    rows = desk.page.get_by_test_id("way-stop")
    assert rows.count() == 3
    desk.page.wait_for_selector(PROVED)
    desk.one("way-grip").nth(2).drag_to(rows.nth(0))
    assert [s["translation"] for s in stops(desk)] == [[60, 0, -100], [0, 0, 0], [0, 0, -100]]
    rows.nth(0).locator("button").first.focus()
    desk.page.keyboard.press("Alt+ArrowDown")
    assert [s["translation"][0] for s in stops(desk)] == [0, 60, 0]
    desk.slide("y", 30)
    desk.answered()
    assert len(stops(desk)) == 3, "a way that is given is not drawn on"
    desk.one("way-put").nth(0).click()
    assert stops(desk)[0]["translation"] == [60, 30, -100]
    desk.page.wait_for_selector(PROVED)
    desk.one("way-clear").click()
    assert stops(desk) == [desk.pose]


def test_a_table_goes_out_and_comes_in(desk: Desk, tmp_path: Path) -> None:
    drive(desk, -490)
    with desk.page.expect_download() as waiting:
        desk.one("way-save").click()
    path = tmp_path / waiting.value.suggested_filename
    waiting.value.save_as(path)
    assert path.name == "octahedral-platform-3-3-way.csv"
    assert len(gc.path(FILE, path).zeros) == 3
    desk.one("way-clear").click()
    desk.one("way-file").set_input_files(EXAMPLES / "path.csv")
    desk.page.wait_for_function("() => gcrules.timeline.given.value")
    desk.page.wait_for_selector(PROVED)
    same = gc.path(FILE, EXAMPLES / "path.csv")
    assert desk.page.get_by_test_id("way-mark").count() == len(same.zeros)


TABLES = {
    "a word for a number": ("x, y, z\n0, 0, 0\n1, 2, three\n", "found 'three'", "line 3"),
    "a row too short": ("x, y, z\n0, 0\n0, 0, 1\n", "2 values", "line 2"),
    "another table": ("a, b\n1, 2\n", "names no columns of poses", "line 1"),
    "an empty file": ("", "there are no poses: the file is empty", None),
    "a single pose": ("x, y, z\n0, 0, 0\n", "two poses or more, found 1", None),
}


def test_a_table_at_fault_is_told_with_its_line_and_changes_nothing(desk: Desk, tmp_path: Path) -> None:
    drive(desk, -100)
    before = stops(desk)
    table = tmp_path / "way.csv"
    for name, (text, words, line) in TABLES.items():
        table.write_text(text, encoding="utf-8")
        desk.one("way-file").set_input_files(table)
        fault = desk.page.locator("[data-testid=fault]", has_text=words)
        fault.wait_for()
        places = [place.get_attribute("aria-label") for place in fault.locator("pre").all()]
        assert places == ([line] if line else []), name
        assert stops(desk) == before, name
    table.write_text("x, y, z, speed\n0, 0, 0, 3\n0, 0, -100, 3\n", encoding="utf-8")
    desk.one("way-file").set_input_files(table)
    desk.page.wait_for_function("() => gcrules.timeline.given.value")
    assert desk.text("way-note") == "columns left out: speed"
    assert desk.page.get_by_test_id("fault").count() == 0


def test_each_crossing_of_a_given_way_is_told_and_again_where_it_is_led_past(desk: Desk, tmp_path: Path) -> None:
    """Of a table, as of a way that was driven; by keys and when it is played."""
    table = tmp_path / "down.csv"
    table.write_text("x, y, z\n0, 0, 0\n0, 0, -200\n0, 0, -490\n", encoding="utf-8")
    desk.one("way-file").set_input_files(table)
    desk.page.wait_for_selector("[data-testid=crossed][data-proved=true]")
    assert "through 3 singular poses, proved; the last at z = \N{MINUS SIGN}408.99 mm." in desk.text("crossed")
    desk.one("crossed-close").click()
    assert desk.page.get_by_test_id("crossed").count() == 0
    desk.one("way-lead").press("Home")
    for _ in range(16):  # a tenth of the way each time
        desk.page.keyboard.press("PageUp")
        if desk.page.get_by_test_id("crossed").count():
            break
    at = desk.pose["translation"][2]
    assert -409 < at < -350
    last = "353.76" if at < -353.8 else "350"
    assert f"through a singular pose, proved at z = \N{MINUS SIGN}{last} mm." in desk.text("crossed")
    assert "The planes abc, aef, bdf and cde meet in a point" in desk.text("crossed")
    desk.one("crossed-close").click()
    desk.one("way-speed").select_option("4")
    desk.one("way-play").click()
    desk.page.wait_for_function("() => gcrules.timeline.at.value === 2 && !gcrules.timeline.playing.value")
    assert "\N{MINUS SIGN}408.99 mm." in desk.text("crossed")


def test_on_a_phone_a_crossing_is_told_where_the_slider_is_seen(sit_down: Callable[..., Desk]) -> None:
    """The picture is far above it there."""
    desk = sit_down(viewport={"width": 390, "height": 844}).visit().open("example", "octahedral")
    slider = desk.one("slider-z")
    slider.evaluate("e => e.scrollIntoView({block: 'center'})")
    drive(desk, -340, -352)
    told = desk.page.wait_for_selector("[data-testid=crossed]").bounding_box()
    at = slider.bounding_box()
    assert at["y"] + at["height"] <= told["y"]
    assert told["x"] >= 0
    assert told["x"] + told["width"] <= 390
    assert told["y"] + told["height"] <= 844


def test_a_robot_of_joints_has_a_way_too(desk: Desk) -> None:
    desk.open("robot", "3-rps")
    assert len(stops(desk)) == 1, "another robot, another way"
    for slider, value in (("0", 0.2), ("1", 0.1)):
        desk.slide(slider, value)
        desk.answered()
    desk.page.wait_for_selector(PROVED)
    assert len(stops(desk)) == 3
    assert "proved" in desk.text("way-verdict")
    desk.one("way-lead").evaluate("e => { e.value = '1'; e.dispatchEvent(new Event('input', {bubbles: true})); }")
    desk.answered()
    assert desk.pose["coordinates"] == pytest.approx([0.2, 0, 0], abs=1e-6)


def test_a_way_around_is_taken_over(desk: Desk) -> None:
    desk.one("panel-motion").click()
    desk.one("path-to").fill("x=110.2, y=27.2, z=-654.7, roll=-130.4deg, pitch=46.3deg, yaw=-72.9deg")
    desk.one("path-around").click()
    desk.page.wait_for_selector("[data-testid=path-detour][data-outcome=way]")
    desk.one("path-keep").click()
    desk.page.wait_for_selector(PROVED)
    assert desk.one("way-verdict").get_attribute("data-verdict") != "singular"
    assert stops(desk)[0]["translation"] == [0, 0, 0]
    assert stops(desk)[-1]["translation"] == pytest.approx([110.2, 27.2, -654.7])
