"""The limb editor of the studio in a person's hands."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs Playwright")

from studio_page import Desk

pytestmark = pytest.mark.browser

FRESH = "[data-testid=limb-statement][data-fresh=true]"


def building(desk: Desk) -> Desk:
    desk.one("start-build").click()
    desk.one("limb-0").wait_for()
    return desk


def put(desk: Desk, testid: str, text: str) -> None:
    field = desk.one(testid)
    field.fill(text)
    field.press("Enter")


def test_a_robot_is_built_saved_and_opened(desk: Desk, tmp_path: Path) -> None:
    """From one limb to a 3-RPS robot with its sentence, which the library says too; undone and redone."""
    building(desk)
    assert desk.page.locator("[data-testid=mobility] .figure").inner_text() == "5"
    assert desk.one("limbs-open").is_disabled()
    desk.one("around-0").click()
    desk.page.wait_for_selector(FRESH)
    statement = desk.text("limb-sentence")
    assert desk.page.locator("[data-testid=mobility] .figure").inner_text() == "3"
    with desk.page.expect_download() as download:
        desk.one("limbs-save").click()
    assert download.value.suggested_filename == "my-robot.yaml"
    path = tmp_path / "my-robot.yaml"
    download.value.save_as(path)
    assert statement == gc.analyze(path).statement
    desk.page.get_by_role("button", name="Undo").click()
    desk.page.wait_for_function("() => gcrules.limbs$.value === null")
    desk.page.get_by_role("button", name="Redo").click()
    desk.page.wait_for_selector(FRESH)
    desk.one("limbs-open").click()
    desk.answered()
    assert desk.study["title"] == "My robot"
    assert desk.study["robot"]["mobility"] == 3


def test_a_fault_is_shown_at_its_joint_and_mended_there(desk: Desk) -> None:
    building(desk)
    put(desk, "part-0-0-0-1", "q1")
    row = desk.one("joint-0-0-0")
    row.get_by_test_id("row-faults").wait_for()
    assert "q1 is not defined" in row.inner_text()
    assert "did you mean r1" in row.inner_text()
    assert desk.page.get_by_test_id("row-faults").count() == 1
    desk.one("define-q1").click()
    desk.one("row-faults").wait_for(state="detached")
    desk.one("rename-q1").wait_for()


def test_table_and_text_are_one(desk: Desk) -> None:
    """A joint that is typed is in the table, a change of the table in the text; a text at fault says where."""
    building(desk)
    desk.one("limbs-start").select_option("3-rps")
    desk.page.wait_for_function("() => gcrules.limbs$.value?.includes('3-RPS')")
    put(desk, "home-A1-x", "3")
    desk.page.wait_for_function("() => gcrules.limbs$.value.includes('A1: [3, 0, 0]')")
    desk.one("limbs-text").click()
    editor = desk.page.locator("[data-testid=limb-text] .cm-content")
    assert "A1: [3, 0, 0]" in editor.inner_text()
    text = str(desk.run("gcrules.limbs$.value"))
    editor.fill(text.replace("R(A%, r%)", "X(A%, r%)"))
    desk.one("fault").wait_for()
    assert "is not a kind of joint" in desk.text("fault")
    editor.fill(text.replace("R(A%, r%)", "R*(A%, r%)"))
    desk.one("fault").wait_for(state="detached")
    desk.one("limbs-table").click()
    assert desk.one("drive-0-0-0").get_attribute("aria-pressed") == "true"
    assert "more than it needs" in desk.text("mobility")


def test_a_chain_is_typed_and_the_verdict_at_home_is_the_librarys(desk: Desk, tmp_path: Path) -> None:
    """Twice three limbs UPS in place of the first one; then only one kind of them, six around z, which is singular."""
    building(desk)
    desk.one("limb-remove-0").click()
    desk.one("limb-0").wait_for(state="detached")
    for limb in range(2):
        put(desk, "limb-add-chain", "UP*S")
        desk.one(f"around-{limb}").click()
        desk.one(f"copies-{limb}").wait_for()
    desk.page.wait_for_selector(f"{FRESH} [data-testid=limb-verdict]")
    path = tmp_path / "robot.yaml"
    path.write_text(str(desk.run("gcrules.limbs$.value")), encoding="utf-8")
    assert gc.pose(path).verdict == desk.one("limb-verdict").get_attribute("data-verdict") == "regular"
    desk.one("limb-remove-1").click()
    desk.one("copies-0").select_option("6")
    desk.page.wait_for_selector("[data-testid=limb-verdict][data-verdict=singular]")
    assert "Architecturally singular" in desk.text("limb-verdict")
    desk.one("limb-add-chain").fill("UPX")
    desk.one("limb-add").click()
    desk.one("fault").wait_for()
    assert "'X' is not a kind of joint" in desk.text("fault")


def test_the_limbs_of_an_open_robot_are_edited(desk: Desk) -> None:
    """From its page and back, by the browser's history too; what was built before is a step of undo away."""
    building(desk)
    put(desk, "part-0-0-0-1", "q1")
    desk.one("row-faults").wait_for()
    built = str(desk.run("gcrules.limbs$.value"))
    desk.open("robot", "delta", "limbs")
    desk.one("edit-limbs").click()
    desk.one("limb-0").wait_for()
    assert str(desk.run("gcrules.limbs$.value")).startswith("title: Delta")
    desk.page.wait_for_selector(FRESH)
    desk.page.get_by_role("button", name="Undo").click()
    desk.page.wait_for_function("text => gcrules.limbs$.value === text", arg=built)
    desk.one("row-faults").wait_for()
    desk.page.go_back()
    desk.one("stage-limbs").wait_for()
    desk.page.go_forward()
    desk.one("limb-0").wait_for()
    desk.one("making-legs").click()
    desk.one("making-legs").wait_for()
    desk.page.go_back()
    desk.one("limb-0").wait_for()


def test_it_is_built_by_the_keyboard(desk: Desk) -> None:
    """The list of commands leads there; a joint is driven, moved and taken away with Enter and the space bar alone."""
    desk.page.keyboard.press("Control+k")
    desk.one("command").fill("limb by limb")
    desk.page.keyboard.press("Enter")
    desk.one("limb-0").wait_for()
    desk.one("drive-0-0-0").press("Enter")
    desk.page.wait_for_function("() => gcrules.limbs$.value?.includes('R*(A1, r1)')")
    desk.one("joint-remove-0-0-1").press("Space")
    desk.page.wait_for_function("() => !gcrules.limbs$.value.includes('P*')")
    assert "4 joint freedoms" in desk.text("limb-wrenches")
    desk.page.locator("body").press("Control+z")
    desk.page.wait_for_function("() => gcrules.limbs$.value.includes('P*')")
    for x in ("2.1", "2.2"):
        desk.one("home-A1-x").press("ArrowUp")
        desk.page.wait_for_function("x => gcrules.limbs$.value.includes(`A1: [${x}, 0, 0]`)", arg=x)
    desk.one("home-A1-x").press("Shift+ArrowDown")
    desk.page.wait_for_function("() => gcrules.limbs$.value.includes('A1: [1.2, 0, 0]')")
    desk.one("home-A1-x").press("Control+z")  # all steps of one coordinate
    desk.page.wait_for_function("() => gcrules.limbs$.value.includes('A1: [2, 0, 0]')")


def test_axe_finds_nothing_and_nothing_is_cut_off(desk: Desk) -> None:
    pytest.importorskip("axe_playwright_python", reason="needs axe-playwright-python")
    from axe_playwright_python.sync_playwright import Axe

    building(desk)
    put(desk, "part-0-0-0-1", "q1")
    desk.one("row-faults").wait_for()
    for width in (1100, 390, 320):
        desk.page.set_viewport_size({"width": width, "height": 800})
        desk.painted()
        assert desk.run("document.querySelector('#content').scrollWidth <= innerWidth"), width
        for theme in ("light", "dark"):
            desk.run("theme => void (gcrules.taste.chosen.value = theme)", theme)
            desk.painted()
            found = Axe().run(desk.page).response["violations"]
            assert [(v["id"], [n["target"] for n in v["nodes"]][:3]) for v in found] == [], (width, theme)


@pytest.mark.parametrize("width", [1280, 900, 390])
def test_long_coordinates_are_shown_whole(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 800}).visit().open("robot", "reachy-mini-head", "limbs")
    desk.one("edit-limbs").click()
    fields = desk.page.locator("[data-testid=names] input.coordinate")
    fields.first.wait_for()
    clipped = fields.evaluate_all("all => all.filter(e => e.scrollWidth > e.clientWidth).map(e => e.value)")
    assert clipped == []
    assert max(fields.evaluate_all("all => all.map(e => e.value.length)")) > 8
    assert desk.run("document.documentElement.scrollWidth") <= width
