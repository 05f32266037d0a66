"""The picture of the studio: waypoints and joints dragged in it, and the point in which planes meet."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

PROVED = "[data-testid=way][data-proved=true]"
RESTS = "() => Object.keys(gcrules.resizing.wanted.value).length === 0"
STOPS = "gcrules.timeline.stops.value"
PLANE = re.compile(r'<polygon points="([^"]+)" fill="(#\w+)" fill-opacity="0.24"')


def shift(x: float, y: float, z: float) -> dict[str, Any]:
    return {"translation": [x, y, z], "quaternion": [1, 0, 0, 0]}


WAY = [shift(0, 0, 0), shift(120, 0, -60), shift(120, 130, 60)]


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit().open("example", "octahedral", "statement")


def give(desk: Desk, way: list[dict[str, Any]] = WAY) -> None:
    desk.run("way => gcrules.edit({way, pose: way.at(-1)})", way)
    desk.page.wait_for_selector(PROVED)
    desk.one("view-fit").click()  # else the platform, which has left the picture, is brought back half a second later
    desk.painted()


def grip(desk: Desk, name: str) -> tuple[float, float]:
    """Where something that can be dragged is seen."""
    box = desk.one("viewer").bounding_box()
    x, y = desk.run("id => gcrules.space.viewer.value.gripAt(id)", name)
    return box["x"] + x, box["y"] + y


def drag(desk: Desk, start: tuple[float, float], right: float, down: float) -> tuple[float, float]:
    x, y = start
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    for i in range(1, 7):
        desk.page.mouse.move(x + right * i / 6, y + down * i / 6)
    desk.painted()
    desk.page.mouse.up()
    return x + right, y + down


def stops(desk: Desk) -> list[Any]:
    return [s["translation"] for s in desk.run(STOPS)]


def press(desk: Desk, *keys: str) -> None:
    desk.one("viewer").locator("[role=application]").focus()
    for key in keys:
        desk.page.keyboard.press(key)


# --- waypoints -----------------------------------------------------------------------------------------------------


def test_waypoints_are_dragged_put_in_and_taken_out_in_the_picture(desk: Desk) -> None:
    give(desk)
    wanted = drag(desk, grip(desk, "stop 1"), 30, -24)
    assert grip(desk, "stop 1") == pytest.approx(wanted, abs=0.5)
    moved = stops(desk)[1]
    assert moved != WAY[1]["translation"]
    assert desk.pose == WAY[2], "the robot stays"
    desk.page.wait_for_selector(PROVED)  # the check follows
    assert desk.text("waypoint").startswith("Waypoint 2 of 3")
    wanted = drag(desk, grip(desk, "between 0"), -20, -30)
    assert len(stops(desk)) == 4
    assert grip(desk, "stop 1") == pytest.approx(wanted, abs=0.5)
    desk.page.wait_for_selector(PROVED)
    press(desk, "Delete")
    assert stops(desk) == [[0, 0, 0], moved, WAY[2]["translation"]]
    desk.one("undo").click()
    assert len(stops(desk)) == 4
    desk.one("undo").click()  # putting it in and dragging it was one step
    assert stops(desk)[1] == moved
    desk.one("undo").click()
    assert stops(desk) == [s["translation"] for s in WAY]


def test_a_waypoint_dragged_into_a_singular_pose_is_found(desk: Desk) -> None:
    give(desk, [shift(0, 0, 0), shift(0, 0, -300)])
    assert desk.text("way-verdict").startswith("No pose of the path is singular")
    desk.one("view-front").click()
    desk.painted()
    scale = (desk.place("c")[1] - desk.place("d")[1]) / 100  # about so many pixels for a millimetre of height
    drag(desk, grip(desk, "stop 1"), 0, 190 * scale)
    desk.page.wait_for_function("() => gcrules.timeline.proof.value?.places.length > 0")
    there = gc.path(str(EXAMPLES / "octahedral.yaml"), ["home", " ".join(map(repr, stops(desk)[1]))])
    assert desk.page.get_by_test_id("way-mark").count() == len(there.zeros)


def test_keys_choose_and_move_waypoints(desk: Desk) -> None:
    give(desk)
    press(desk, ".", ".")
    assert desk.run("gcrules.timeline.chosen.value") == 1
    step = desk.study["size"] / 100
    press(desk, "PageUp", "ArrowRight")
    assert stops(desk)[1] == pytest.approx([120 + step, 0, -60 + step])
    press(desk, "Shift+PageUp")  # turns it
    assert desk.run(f"{STOPS}[1].quaternion[0]") < 1
    desk.page.wait_for_timeout(400)  # the keys rest
    desk.page.wait_for_selector(PROVED)
    press(desk, "Insert")
    assert len(stops(desk)) == 4
    assert desk.run("gcrules.timeline.chosen.value") == 2
    press(desk, "Escape")
    assert desk.one("waypoint").count() == 0
    press(desk, ",")
    assert desk.run("gcrules.timeline.chosen.value") == 3
    desk.one("undo").click()
    desk.one("undo").click()  # moves without a rest between them are one step
    assert stops(desk) == [s["translation"] for s in WAY]


def test_the_handles_take_the_waypoint_that_is_chosen(desk: Desk) -> None:
    give(desk)
    x, y = grip(desk, "stop 1")
    desk.page.mouse.click(x, y)
    desk.one("view-front").click()
    desk.one("mode-translate").click()
    desk.painted()
    x, y = grip(desk, "stop 1")
    drag(desk, (x, y - 41), 0, -30)
    at = stops(desk)[1]
    assert at[:2] == pytest.approx([120, 0], abs=1e-6)
    assert at[2] > -50
    assert desk.pose == WAY[2]


def test_waypoints_of_a_robot_of_joints_go_as_far_as_its_freedoms(sit_down: Callable[..., Desk]) -> None:
    desk = sit_down().visit().open("robot", "3-rps")
    home = {**shift(0, 0, 0), "coordinates": [0, 0, 0]}
    give(desk, [home, {**home, "coordinates": [0.3, 0.2, 0.3]}])
    x, y = grip(desk, "stop 1")
    drag(desk, (x, y), 0, -20)
    desk.page.wait_for_function(f"() => {STOPS}[1].coordinates[0] > 0.35 && gcrules.timeline.proof.value")
    assert grip(desk, "stop 1")[1] == pytest.approx(y - 20, abs=4)
    assert grip(desk, "stop 1")[0] == pytest.approx(x, abs=4)
    assert desk.text("waypoint-note") == "goes in z, roll and pitch only"


def test_a_waypoint_that_cannot_follow_says_why(sit_down: Callable[..., Desk]) -> None:
    desk = sit_down().visit().open("robot", "delta")
    home = {**shift(0, 0, 0), "coordinates": [0, 0, 0]}
    give(desk, [home, {**home, "coordinates": [10, 10, 10]}])
    drag(desk, grip(desk, "stop 1"), 0, 400)
    desk.page.wait_for_function("() => gcrules.timeline.fault.value")
    assert desk.text("waypoint-note").startswith("It stays: ")
    drag(desk, grip(desk, "stop 1"), 0, 8)
    desk.page.wait_for_function("() => !gcrules.timeline.fault.value")
    assert desk.text("waypoint-note") == "goes in x, y and z only"


def test_a_way_is_kept_in_the_link(desk: Desk, sit_down: Callable[..., Desk]) -> None:
    give(desk)
    desk.one("panel-take-away").click()
    desk.page.wait_for_function("() => document.querySelector('[data-testid=link]').value.includes('#')")
    desk.page.wait_for_timeout(400)  # the address is written at rest
    link = desk.one("link").input_value()
    assert desk.one("link-long").count() == 0
    other = sit_down().visit("#" + link.split("#")[1])
    other.page.wait_for_selector(PROVED)
    assert stops(other) == [s["translation"] for s in WAY]
    desk.page.reload()
    desk.page.wait_for_selector(PROVED)
    assert stops(desk) == [s["translation"] for s in WAY]
    noise = "".join(str((i * i * 7919) % 10_007) for i in range(40_000))
    desk.run("text => gcrules.edit({bench: text})", noise)
    desk.one("link-long").wait_for()
    assert "The way is not in the link" in desk.text("link-long")


def test_a_way_that_was_driven_outlives_a_reload(desk: Desk) -> None:
    for z in (-100, -200):
        desk.slide("z", z)
        desk.answered()
    desk.let_go("z")
    desk.page.wait_for_function(f"() => {STOPS}.at(-1).translation[2] === -200")
    desk.page.wait_for_selector(PROVED)
    desk.page.reload()
    desk.page.wait_for_selector(PROVED)
    assert stops(desk) == [[0, 0, 0], [0, 0, -200]]
    assert not desk.run("gcrules.timeline.given.value")


def test_where_one_looks_from_outlives_a_reload(desk: Desk) -> None:
    desk.one("view-top").click()
    desk.one("viewer").hover()
    desk.page.mouse.wheel(0, -300)
    desk.painted()
    seen = desk.place("a"), desk.place("d")
    desk.page.reload()
    desk.page.wait_for_function("() => window.gcrules?.space.viewer.value && gcrules.study.value")
    desk.answered()
    desk.painted()
    assert desk.place("a") == pytest.approx(seen[0], abs=0.5)
    assert desk.place("d") == pytest.approx(seen[1], abs=0.5)
    desk.open("robot", "3-rps")
    desk.painted()
    fitted = desk.place("S1")
    desk.run("gcrules.space.viewer.value.setView('iso')")
    desk.painted()
    assert desk.place("S1") == pytest.approx(fitted, abs=0.5), "another robot is seen as ever"


# --- joints --------------------------------------------------------------------------------------------------------


def test_joints_are_dragged_in_the_picture_as_if_typed(desk: Desk) -> None:
    desk.one("panel-dimensions").click()
    desk.one("plan").wait_for()
    desk.run("gcrules.edit({pose: {translation: [20, 0, 30], quaternion: [0.8, 0.6, 0, 0]}})")
    desk.answered()
    desk.painted()
    desk.one("view-fit").click()  # all joints are in sight, so that the view rests
    desk.painted()
    for name in ("b", "a"):
        wanted = drag(desk, grip(desk, f"joint {name}"), 18, -12)  # no singularity is near, whose warning takes room
        desk.page.wait_for_function(RESTS)
        desk.answered()
        desk.painted()
        assert grip(desk, f"joint {name}") == pytest.approx(wanted, abs=3), "as near as steps of 5 mm are"
    points = desk.study["points"]
    assert not [c for c in (*points["a"], *points["b"]) if c % 2 and c % 5], "steps of 2 mm or 5, by the robot's size"
    text = desk.run("gcrules.doc.value.source.text")
    there: Any = gc.load(text)
    assert [float(c) for c in there.points["b"]] == points["b"]
    desk.page.wait_for_function("() => gcrules.posing.numbers.value.points.a[0] === gcrules.study.value.points.a[0]")
    margin = desk.numbers["margin"]
    # the same numbers, typed: the same file, the same answer
    desk.one("undo").click()
    desk.one("undo").click()  # each drag is one step
    back = "() => gcrules.study.value?.points.a[1] === -300 && gcrules.study.value.points.b[0] === 150"
    desk.page.wait_for_function(back)
    for name in ("b", "a"):
        for axis, value in zip("xyz", points[name], strict=True):
            field = desk.one(f"dimension-{axis}-{name}")
            field.fill(str(value))
            field.press("Enter")
    desk.page.wait_for_function("m => Math.abs((gcrules.posing.numbers.value?.margin ?? 9) - m) < 1e-12", arg=margin)
    assert desk.study["points"] == points


def test_joints_of_a_robot_of_joints_are_dragged_at_home(desk: Desk) -> None:
    desk.open("robot", "3-rps")
    desk.one("panel-dimensions").click()
    desk.one("plan").wait_for()
    desk.painted()
    before = desk.study["points"]
    drag(desk, grip(desk, "joint S1"), 20, -30)
    desk.page.wait_for_function(RESTS)
    desk.answered()
    after = desk.study["points"]
    assert {n for n in after if after[n] != before[n]} == {"S1"}
    assert after["S1"][2] > before["S1"][2]
    assert after["S1"][1] == before["S1"][1], "it stays in the plane of its leg"
    desk.slide("0", 0.1)
    desk.answered()
    desk.one("shape-home").wait_for()
    assert desk.run("gcrules.space.viewer.value.gripAt('joint S1')") is None


@pytest.mark.parametrize("key", ["Escape", "Control+z"])
def test_a_drag_is_taken_back_while_the_button_is_down(desk: Desk, key: str) -> None:
    give(desk)
    x, y = grip(desk, "stop 1")
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    desk.page.mouse.move(x + 20, y - 30, steps=4)
    desk.painted()
    desk.page.keyboard.press(key)
    desk.page.mouse.move(x + 60, y - 60, steps=4)
    desk.page.mouse.up()
    way = [s["translation"] for s in WAY]
    near = f"way => {STOPS}.every(({{translation}}, i) => translation.every((c, k) => Math.abs(c - way[i][k]) < 1e-9))"
    desk.page.wait_for_function(near, arg=way)
    assert len(stops(desk)) == len(way)


def test_keys_move_a_joint_in_the_picture(desk: Desk) -> None:
    desk.one("panel-dimensions").click()
    desk.one("plan").wait_for()
    press(desk, ".", "ArrowRight", "Shift+PageUp")
    desk.page.wait_for_function("() => gcrules.study.value?.points.a[2] === 50")
    assert desk.study["points"]["a"] == [5, -300, 50]
    press(desk, "Escape")
    assert desk.run("gcrules.resizing.selected.value") is None
    desk.one("panel-guided").click()
    desk.painted()
    assert desk.run("gcrules.space.viewer.value.gripAt('joint a')") is None, "elsewhere joints stay"


# --- the point in which planes meet --------------------------------------------------------------------------------

NEAREST = """async () => { const {source, pose, threshold} = gcrules.doc.peek();
    const {found} = await gcrules.client.ask("nearest", {source, pose, threshold});
    return found.map(({pose}) => pose) }"""
COVERED = """() => { const bar = document.querySelector("[data-testid=warning]").getBoundingClientRect();
    const {left, top} = document.querySelector("[data-testid=viewer]").getBoundingClientRect();
    return gcrules.space.marks.value.filter(([a, b, c, d]) =>
        a + left < bar.right && c + left > bar.left && b + top < bar.bottom && d + top > bar.top) }"""


@pytest.mark.parametrize("width", [1280, 390])
def test_the_warning_covers_no_point_in_which_planes_meet(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 800}).visit().open("example", "octahedral", "statement")
    places = set()
    for pose in desk.run(NEAREST):
        desk.run("pose => gcrules.edit({pose})", pose)
        desk.answered()
        desk.verdict("singular")
        desk.page.wait_for_function("() => gcrules.space.marks.value.length > 0")
        for opened in (False, True):
            if opened:
                desk.one("warning-more").click()
            desk.painted()
            assert desk.run(COVERED) == []
            assert desk.one("warning").bounding_box()["width"] > 150, "it can be read in each place"
            places.add(desk.one("warning").get_attribute("data-place"))
        desk.one("warning-more").click()
        assert desk.run("document.documentElement.scrollWidth") <= width
    assert len(places) > 1, "it has given way"


def test_an_arrow_points_to_what_is_out_of_the_picture_and_says_how_far(desk: Desk) -> None:
    pose = desk.run(NEAREST)[1]
    desk.run("pose => gcrules.edit({pose})", pose)
    desk.answered()
    desk.one("viewer").hover()
    for _ in range(8):
        desk.page.mouse.wheel(0, -300)
        desk.painted()
    arrows = desk.one("viewer").locator("svg[data-marks] polygon")
    assert arrows.count() == 1
    assert "mm away" in desk.one("viewer").inner_text()
    svg = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    assert "mm away" in svg
    for _ in range(24):
        desk.page.mouse.wheel(0, 300)
        desk.painted()
    assert arrows.count() == 0, "now it is seen"
    assert "mm away" not in desk.one("viewer").inner_text()


TOUCHING = """() => { const pane = document.querySelector("[data-testid=viewer]");
    const words = [...pane.querySelectorAll("[aria-hidden] > span:not([hidden])")];
    const arrows = [...pane.querySelectorAll("svg[data-marks] polygon")];
    const told = words.filter(e => e.textContent.includes(" away"));
    const touch = (a, b) => { const [p, q] = [a, b].map(e => e.getBoundingClientRect());
        return p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1; };
    return [told.length, [...told, ...arrows].flatMap(a =>
        words.filter(b => b !== a && touch(a, b)).map(b => `${a.textContent} ${b.textContent}`))]; }"""
"""How many labels say how far a point is, and what touches them or their arrows."""


def test_labels_keep_clear_of_arrows_and_their_words(desk: Desk) -> None:
    told = 0
    for pose in desk.run(NEAREST):
        desk.run("pose => gcrules.edit({pose})", pose)
        desk.answered()
        desk.run("view => gcrules.space.viewer.value.setView('fit')")
        for view in ("iso", "front", "side", "top"):
            desk.one(f"view-{view}").click()
            desk.one("viewer").hover()
            for _ in range(3):
                desk.page.mouse.wheel(0, -300)
                desk.painted()
                there, touching = desk.run(TOUCHING)
                assert touching == []
                told += there
    assert told > 0


def test_planes_swing_with_the_platform(desk: Desk) -> None:
    desk.run("pose => gcrules.edit({pose})", desk.run(NEAREST)[1])
    desk.answered()
    desk.painted()
    before = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    desk.one("play-motion").click()
    desk.painted()
    after = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    assert ">M" in before
    assert ">M" not in after, "where the planes do not meet nothing says so"
    desk.one("play-motion").click()
    desk.painted()
    assert desk.run("gcrules.space.viewer.value.snapshot('svg')") == before


def test_planes_are_seen_to_part_where_they_met(desk: Desk) -> None:
    """While the gained motion swings they still reach to that place."""
    desk.open("example", "octahedral-singular", "statement")
    desk.painted()
    met = re.search(r'<text x="([\d.]+)" y="([\d.]+)"[^>]*><tspan[^>]*>M', desk.run("gcrules.space.viewer.value.svg()"))
    assert met
    desk.one("play-motion").click()
    desk.painted()
    nearest: dict[str, float] = {}
    for corners, colour in PLANE.findall(desk.run("gcrules.space.viewer.value.svg()")):
        away = min(math.dist(map(float, met.groups()), map(float, corner.split(","))) for corner in corners.split())
        nearest[colour] = min(away, nearest.get(colour, math.inf))
    assert len(nearest) == 4
    assert max(nearest.values()) < 60, "pixels"
