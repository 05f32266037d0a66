"""Dimensions in place, and another robot beside the one on show."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import pytest

import gcrules as gc
from gcrules.apps.studio.resizing import resized
from gcrules.apps.studio.shape_view import shape_view
from gcrules.apps.studio.sources import source_of
from gcrules.apps.studio.subject import read_subject
from gcrules.core.errors import InputError

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from apps.studio_client import Page
    from studio_page import Desk


# --- the answer ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["octahedral", "3-3.3", "ab af cb cd ed ef"])
def test_a_platform_with_other_dimensions_is_one_with_the_same_condition(name: str) -> None:
    before = read_subject(source_of("octahedral-singular" if name == "octahedral" else name))
    after = read_subject(resized(before, {"b": ("123.5", "", "1/3")}, None)["source"])
    assert after.legs is not None
    assert before.legs is not None
    assert after.analysis is not None
    assert before.analysis is not None
    assert not after.invented
    assert after.structure == before.structure
    assert after.analysis.condition.expression == before.analysis.condition.expression
    moved = {n: p for n, p in after.legs.platform.points.items() if p != before.legs.platform.points[n]}
    assert list(moved) == ["b"]
    assert float(moved["b"][0]) == 123.5


@pytest.mark.parametrize("name", ["delta", "3-rps", "4-upu", "agile-eye", "gough-stewart", "5r", "8-cables"])
def test_a_robot_with_other_places_at_home_is_one_of_its_family(name: str) -> None:
    before = read_subject(source_of(name))
    first = next(row for group in shape_view(before)["groups"] for row in group["rows"] if row["at"])
    x = f"{first['at'][0] + 0.125:.6f}"
    after = read_subject(resized(before, {first["name"]: (x, "", "")}, None)["source"])
    assert before.robot is not None
    assert after.robot is not None
    assert after.robot.statement == before.robot.statement
    assert after.robot.robot.family == before.robot.robot.family
    assert after.home[first["name"]][0] == float(x)
    dimensions = {row["name"] for group in shape_view(after)["groups"] for row in group["rows"] if row["at"]}
    assert {n for n in after.home if after.home[n] != before.home[n]} & dimensions


def test_what_violates_a_relation_goes_to_the_nearest_place_that_does_not() -> None:
    """The direction v1 of a 4-UPU robot is perpendicular to its leg."""
    before = read_subject(source_of("4-upu"))
    text = resized(before, {"A1": ("2.5", "", "")}, "actuators -0.5..0.5")["source"]["text"]
    found = gc.load(text)
    assert found.limits == "actuators -0.5..0.5"
    assert found.values_at()["A1"][0] == 2.5
    leg = [b - a for a, b in zip(found.values_at()["A1"], found.values_at()["B1"], strict=True)]
    assert abs(sum(float(a * b) for a, b in zip(leg, found.values_at()["v1"], strict=True))) < 1e-6


def test_faults_of_a_robot_of_joints() -> None:
    with pytest.raises(InputError, match="'Q' has no place of its own at home"):
        resized(read_subject(source_of("delta")), {"Q": ("1", "", "")}, None)
    with pytest.raises(InputError, match="assembly mode"):
        resized(read_subject({"kind": "robot", "id": "delta", "mode": "+++"}), {}, None)


def test_a_message_with_a_fault(page: Page) -> None:
    octahedral = {"kind": "example", "name": "octahedral"}
    found = page.answer(page.send("resize", source=octahedral, points={"b": ["1", "cat", ""]}))
    assert not found["ok"]
    assert found["error"]["place"]["line"] == 12
    good = page.ask("resize", source=octahedral, points={"b": ["1", "", ""]}, limits="100..900 mm")
    assert good["source"]["text"].count("100..900 mm") == 1


# --- the page ------------------------------------------------------------------------------------------------------

B = "() => window.gcrules.study.peek().points.b"
MARGIN = "m => Math.abs((window.gcrules.posing.numbers.value?.margin ?? 9) - m) < 1e-12"


PLANS = [("example", "octahedral"), ("robot", "delta"), ("robot", "gough-stewart")]


def shape(desk: Desk, name: str = "octahedral", kind: str = "example") -> Desk:
    desk.open(kind, name)
    desk.one("panel-dimensions").click()
    desk.one("plan").wait_for()
    return desk


@pytest.mark.browser
def test_a_joint_is_dragged_and_the_numbers_follow(desk: Desk) -> None:
    shape(desk)
    margin, condition = desk.numbers["margin"], desk.study["condition"]
    box = desk.one("plan-b").locator("circle.dot").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    for i in range(1, 9):
        desk.page.mouse.move(x + 5 * i, y - 3 * i)
        desk.page.wait_for_timeout(20)
    desk.page.mouse.up()
    desk.page.wait_for_function("() => Object.keys(window.gcrules.resizing.wanted.value).length === 0")
    moved = desk.run(B)
    assert moved[0] > 160
    assert moved[1] > -90
    assert moved[2] == 350
    text = desk.run("gcrules.doc.value.source.text")
    assert text.startswith("# The 3-3 platform")  # its comments stay
    there: Any = gc.pose(gc.load(text), nearest=False)
    assert there.margin != margin
    desk.page.wait_for_function(MARGIN, arg=there.margin)
    assert desk.study["condition"] == condition
    desk.one("undo").click()  # a drag is one step
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.b[0] === 150")
    desk.page.wait_for_function(MARGIN, arg=margin)


@pytest.mark.browser
def test_coordinates_are_typed_and_kept_in_the_pose(desk: Desk) -> None:
    shape(desk)
    desk.run("gcrules.edit({pose: {translation: [10, 0, 0], quaternion: [1, 0, 0, 0]}})")
    field = desk.one("dimension-x-b")
    field.fill("175,5")
    field.press("Enter")
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.b[0] === 175.5")
    assert desk.pose["translation"] == [10, 0, 0]
    field.press("ArrowUp")
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.b[0] > 175.5")
    desk.one("plan-front").click()
    desk.one("plan-d").focus()
    desk.page.keyboard.press("ArrowUp")
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.d[2] > 400")
    assert desk.run("gcrules.study.value.points.d")[1] == 150


@pytest.mark.browser
def test_limits_are_typed_and_a_fault_has_its_place(desk: Desk) -> None:
    shape(desk)
    field = desk.one("dimension-limits")
    field.fill("from here to there")
    field.press("Enter")
    desk.one("fault").wait_for()
    assert desk.run("gcrules.study.value.limits") == ""
    field.fill("300..450 mm")
    field.press("Enter")
    desk.page.wait_for_function("() => window.gcrules.study.value?.limits === '300..450 mm'")
    desk.one("fault").wait_for(state="detached")
    desk.one("tab-actuators").click()
    desk.page.wait_for_function(
        "() => document.querySelector('[data-testid=reach]').innerText.startsWith('Beyond the limits')"
    )


@pytest.mark.browser
def test_two_robots_side_by_side(desk: Desk) -> None:
    shape(desk)
    before = desk.numbers["margin"]
    desk.one("beside-keep").click()
    desk.one("beside").wait_for()
    field = desk.one("dimension-x-b")
    field.fill("220")
    field.press("Enter")
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.b[0] === 220")
    there: Any = gc.pose(gc.load(desk.run("gcrules.doc.value.source.text")), nearest=False)
    desk.page.wait_for_function(MARGIN, arg=there.margin)
    row = desk.one("beside").locator("tr", has_text="margin").locator("td")
    desk.page.wait_for_function("b => Math.abs(window.gcrules.comparing.numbers.value?.margin - b) < 1e-12", arg=before)
    assert row.all_inner_texts() == [f"{desk.numbers['margin']:.4g}", f"{before:.4g}"]
    desk.run("gcrules.edit({pose: {translation: [0, 0, 20], quaternion: [1, 0, 0, 0]}})")  # both move
    desk.page.wait_for_function("b => Math.abs(window.gcrules.comparing.numbers.value?.margin - b) > 1e-6", arg=before)
    desk.one("beside-swap").click()
    desk.page.wait_for_function("() => window.gcrules.study.value?.points.b[0] === 150")
    assert desk.run("gcrules.comparing.other.value.study.points.b")[0] == 220
    assert desk.pose["translation"] == [0, 0, 20]
    desk.one("beside-close").click()
    desk.one("beside").wait_for(state="detached")


@pytest.mark.browser
def test_a_robot_of_another_kind_stands_at_its_home(desk: Desk) -> None:
    desk.open("robot", "3-rps")
    desk.one("panel-dimensions").click()
    desk.run("gcrules.comparing.choose('Delta', {kind: 'robot', id: 'delta'})")
    desk.one("beside").wait_for()
    desk.page.wait_for_function("() => window.gcrules.comparing.numbers.value !== null")
    assert "at its home" in desk.one("beside-picture").get_attribute("aria-label")
    heads = desk.one("beside").locator("tbody th")
    assert "actuators, from home" in heads.all_inner_texts()  # lengths, and angles
    assert not any("length" in head for head in heads.all_inner_texts() if "characteristic" not in head)
    desk.run("gcrules.comparing.choose('Octahedral', {kind: 'example', name: 'octahedral'})")
    desk.page.wait_for_function(
        "() => window.gcrules.comparing.other.value?.name === 'Octahedral' && window.gcrules.comparing.numbers.value"
    )
    assert {"leg lengths", "actuators, from home"} <= set(heads.all_inner_texts())
    assert "at its home" in desk.one("beside-picture").get_attribute("aria-label")


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 320])
def test_it_fits_a_phone(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 760}).visit()
    shape(desk)
    desk.one("beside-keep").click()
    desk.one("beside").wait_for()
    assert desk.run("document.documentElement.scrollWidth") <= width
    rail = [b.bounding_box() for b in desk.page.locator(".rail button").all()]
    assert all(b["x"] >= 0 and b["x"] + b["width"] <= width for b in rail)


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 1280])
def test_names_in_the_plan_stand_apart(sit_down: Callable[..., Desk], width: int) -> None:
    """Also where joints lie one behind another."""
    from browsing import SIDES, touching

    desk = sit_down(viewport={"width": width, "height": 800}).visit()
    for kind, name in PLANS:
        shape(desk, name, kind)
        for view in ("top", "front", "side"):
            desk.one(f"plan-{view}").click()
            desk.painted()
            sheet, texts = desk.one("plan"), desk.one("plan").locator("text")
            boxes = [one.bounding_box() for one in texts.all()]
            assert len(boxes) >= 6, (name, view)
            assert touching(boxes) == [], (name, view)
            frame = sheet.bounding_box()
            for at, size in SIDES:
                assert all(b[at] >= frame[at] and b[at] + b[size] <= frame[at] + frame[size] for b in boxes)


@pytest.mark.browser
def test_joints_of_a_robot_of_joints_are_typed_and_moved_in_the_plan(desk: Desk) -> None:
    desk.open("robot", "3-rps")
    desk.one("panel-dimensions").click()
    condition, margin = desk.study["condition"], desk.numbers["margin"]
    field = desk.one("dimension-x-A1")
    field.fill("2.5")
    field.press("Enter")
    desk.page.wait_for_function("() => gcrules.study.value?.points.A1[0] === 2.5")
    desk.one("plan-front").click()
    desk.one("plan-S1").focus()
    desk.page.keyboard.press("ArrowUp")
    desk.page.wait_for_function("() => gcrules.study.value?.points.S1[2] > 2")
    assert desk.study["condition"] == condition
    there: Any = gc.pose(gc.load(desk.run("gcrules.doc.value.source.text")), nearest=False)
    assert there.margin != margin
    desk.page.wait_for_function(MARGIN, arg=there.margin)
    desk.slide("0", 0.1)
    desk.answered()
    desk.one("shape-home").click()
    desk.one("shape-home").wait_for(state="detached")
    assert desk.faults == []
