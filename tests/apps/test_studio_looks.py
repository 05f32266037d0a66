"""The studio's page at all sizes and on paper, with long names and with poses and links that are out of all bounds."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from browsing import ARGS, SIDES, touching
from conftest import find_browser
from studio_page import Desk, Server

pytestmark = pytest.mark.browser

SitDown = Callable[..., Desk]

LONG = """\
title: Long names
points:
  base_left_front: [0, 0, 0]
  base_right_front: [1, 0, 0]
  base_middle_back: [0.5, 0.9, 0]
  platform_joint_one: [0.2, 0.2, 1]
  platform_joint_two: [0.8, 0.25, 1.1]
  platform_joint_three: [0.5, 0.7, 0.9]
legs:
  - [base_left_front, platform_joint_one]
  - [base_left_front, platform_joint_two]
  - [base_right_front, platform_joint_two]
  - [base_right_front, platform_joint_three]
  - [base_middle_back, platform_joint_three]
  - [base_middle_back, platform_joint_one]
"""
PANELS = ("guided", "manual", "motion", "where", "bench", "draw", "take-away")

CUT_OFF = """() => { const width = document.documentElement.clientWidth;
  const rolls = e => e.closest(".formula, .monomials, .legend, .viewer, .wide");
  return [...document.querySelectorAll("body *")].filter(e => e.checkVisibility({visibilityProperty: true}) && !rolls(e)
    && e.getBoundingClientRect().width > 1 && (e.getBoundingClientRect().right > width + 1
      || e.getBoundingClientRect().left < -1)).slice(0, 5).map(e => e.outerHTML.slice(0, 120)); }"""
"""What leaves the page at its sides and cannot be scrolled to."""

FAINT = """() => { const rgb = c => c.match(/[\\d.]+/g).map(Number);
  const linear = c => c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4;
  const light = c => c.slice(0, 3).reduce((sum, part, i) => sum + linear(part) * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = e => { for (; e; e = e.parentElement) { const c = getComputedStyle(e).backgroundColor;
    if (c.startsWith("rgb") && (rgb(c)[3] ?? 1) > 0.9) return rgb(c); } return [255, 255, 255]; };
  const own = ".entity-word, .chip .math, .formula .whole, .letter.toned, .verdict .word, .threshold, .cm-line span";
  return [...document.querySelectorAll(own)].filter(e => e.checkVisibility()).map(e => {
    const [a, b] = [light(rgb(getComputedStyle(e).color)), light(behind(e))];
    return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.textContent];
  }).filter(([ratio]) => ratio < 4.5); }"""
"""Words in a colour of their own with less than 4.5 to 1 to what is behind them."""


def fragment(doc: dict[str, Any], deflated: bool = False) -> str:
    """A link's state, as a stranger might write it."""
    text = json.dumps(doc).encode()
    if deflated:
        squeezed = zlib.compressobj(9, zlib.DEFLATED, -15)
        text = squeezed.compress(text) + squeezed.flush()
    return f"#{'z' if deflated else 's'}=" + base64.urlsafe_b64encode(text).decode().rstrip("=")


def opened_long(desk: Desk) -> None:
    desk.run("text => gcrules.open({kind: 'file', text, name: 'long.yaml'})", LONG)
    desk.answered()


# --- out of all bounds ---------------------------------------------------------------------------------------------


def test_what_is_opened_while_the_platform_moves_stands_at_home(sit_down: SitDown) -> None:
    desk = sit_down(reduced_motion="no-preference").visit().open("example", "octahedral")
    desk.run("gcrules.moving.to({translation: [0, 0, -350], quaternion: [1, 0, 0, 0]})")
    desk.page.wait_for_function("() => gcrules.pose$.value.translation[2] < -1")
    assert desk.run("gcrules.moving.active.value")
    desk.open("robot", "3-rps")
    assert not desk.run("gcrules.moving.active.value")
    desk.page.wait_for_timeout(300)
    assert desk.pose["translation"] == [0, 0, 0]


@pytest.mark.parametrize(("away", "drawn"), [(1e3, True), (1e9, False)])
def test_a_pose_far_away_is_drawn_or_refused_and_left_again(sit_down: SitDown, away: float, drawn: bool) -> None:
    desk = sit_down().visit().open("class", "4-4.5")
    field = desk.one("slider-x-number")
    field.fill(f"{away:g}")
    field.press("Enter")
    if drawn:
        desk.answered()
    else:
        desk.page.wait_for_function("() => gcrules.posing.fault.value?.message.includes('times the robot')")
    desk.painted()
    assert desk.pose["translation"][0] == away
    desk.one("home").click()
    desk.page.wait_for_function("() => gcrules.pose$.value.translation[0] === 0")
    desk.answered()
    desk.painted()


@pytest.mark.parametrize("away", [1e9, 1e12])
def test_a_link_to_a_pose_far_away_opens(sit_down: SitDown, away: float) -> None:
    pose = {"translation": [away, 0, 0], "quaternion": [1, 0, 0, 0]}
    desk = sit_down().visit(fragment({"source": {"kind": "class", "id": "4-4.5"}, "panel": "guided", "pose": pose}))
    desk.page.wait_for_function("() => gcrules.posing.numbers.value || gcrules.posing.fault.value")
    desk.painted()
    assert desk.run("1 + 1") == 2


def test_a_link_that_inflates_to_megabytes_opens_nothing_and_that_is_said(sit_down: SitDown) -> None:
    source = {"kind": "class", "id": "3-3.3"}
    desk = sit_down().visit(fragment({"source": source}, deflated=True))
    assert desk.run("gcrules.source$.value") == source
    assert desk.one("unread").count() == 0
    desk = sit_down().visit(fragment({"source": source, "bench": "x" * 40_000_000}, deflated=True))
    assert desk.run("gcrules.source$.value") is None
    desk.one("unread").get_by_role("button").click()
    assert desk.one("unread").count() == 0


CLASS = {"kind": "class", "id": "3-3.3"}
HOSTILE = {
    "no base64": ("#s=%%%%", True),
    "no JSON": ("#s=e3t7", True),
    "nested": ("#s=" + base64.urlsafe_b64encode(b"[" * 200_000).decode(), True),
    "nothing deflated": ("#z=AAAA", True),
    "a source that is a list": (fragment({"source": [1]}), True),
    "an unknown kind": (fragment({"source": {"kind": "evil", "id": "x"}}), True),
    "a path": (fragment({"source": {"kind": "robot", "id": "../../etc/passwd"}}), False),
    "a script": (fragment({"source": {"kind": "file", "name": "<img src=x onerror=alert(1)>", "text": "<b>"}}), False),
    "no turn": (fragment({"source": CLASS, "pose": {"translation": [0, 0, 0], "quaternion": [0, 0, 0, 0]}}), False),
    "other types": (fragment({"source": CLASS, "panel": 7, "bench": {"x": 1}, "notes": 3, "threshold": []}), False),
}
"""Links of strangers, and whether the page says that they cannot be read."""


def test_hostile_links_are_refused_or_open_what_is_sound(sit_down: SitDown) -> None:
    desk = sit_down()
    asked: list[str] = []
    desk.page.on("dialog", lambda dialog: (asked.append(dialog.message), dialog.dismiss()))
    for what, (link, refused) in HOSTILE.items():
        desk.page.goto("about:blank")
        desk.visit(link)
        assert desk.one("unread").count() == refused, what
        desk.page.wait_for_function("() => ['none', 'ready', 'failed'].includes(gcrules.loaded.value.state)")
        assert desk.run("gcrules.loaded.value.state === 'ready'") == ("3-3.3" in str(desk.run("gcrules.source$.value")))
        assert desk.page.locator("img[src=x]").count() == 0
    assert asked == []


# --- names, sizes, colours -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("width", [1280, 390])
def test_long_names_are_coloured_set_apart_and_inside(sit_down: SitDown, width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 800}).visit()
    opened_long(desk)
    planes = desk.step("planes")
    first = planes.locator(".bracket").first.locator(".letter").all()
    boxes = [letter.bounding_box() for letter in first]
    assert all(b["x"] - (a["x"] + a["width"]) > 2 for a, b in pairwise(boxes))
    assert all(box["height"] < 40 for box in boxes)
    statement = desk.step("statement").locator(".sentence")
    words = statement.locator(".entity-word").all()
    assert len(words) == 4
    assert len({word.evaluate("e => getComputedStyle(e).color") for word in words}) == 4
    assert all(" " in word.inner_text().strip() for word in words)
    right = statement.evaluate("e => e.getBoundingClientRect().right")
    assert all(word.evaluate("e => e.getBoundingClientRect().right") <= right + 1 for word in words)
    assert desk.run(CUT_OFF) == []


NAMES = {
    "two letters": [*("pa", "pb", "pc"), *("qa", "qb", "qc")],
    "many digits": [*("A12", "A13", "A14"), *("B1001", "B1002", "B1003")],
    "below the line": [*("A_1", "A_2", "A_3"), *("B_1'", "B_2'", "B_3'")],
    "words": [*("base_left", "base_right", "base_middle_back"), *("platform_one", "platform_two", "platform_three")],
}


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_names_of_all_kinds_are_coloured_and_stand_apart(sit_down: SitDown, names: list[str]) -> None:
    """In the sentence, and in the drawing of the legs, where no name touches another one or the edge."""
    old = [line.split(":")[0].strip() for line in LONG.splitlines() if line.startswith("  ") and ": " in line]
    text = LONG
    for before, after in zip(old, names, strict=True):
        text = text.replace(before, f'"{after}"')
    desk = sit_down(viewport={"width": 320, "height": 800}).visit()
    desk.run("text => gcrules.open({kind: 'file', text, name: 'names.yaml'})", text)
    desk.answered()
    drawing = desk.step("structure").locator("svg.schematic")
    desk.painted()
    frame, boxes = drawing.bounding_box(), [one.bounding_box() for one in drawing.locator("text").all()]
    assert len(boxes) == 6
    for start, size in SIDES:
        end = frame[start] + frame[size]
        assert all(frame[start] <= box[start] and box[start] + box[size] <= end for box in boxes)
    assert touching(boxes) == []
    words = desk.step("statement").locator(".sentence .entity-word").all()
    assert len({word.evaluate("e => getComputedStyle(e).color") for word in words}) == len(words) == 4
    assert all(word.locator(".pt").count() == 3 for word in words)


@pytest.mark.parametrize(("width", "scheme"), [(390, "light"), (320, "dark")])
def test_on_a_phone_the_panel_comes_first_and_nothing_is_cut_off(sit_down: SitDown, width: int, scheme: str) -> None:
    desk = sit_down(viewport={"width": width, "height": 740}, color_scheme=scheme).visit()
    desk.open("example", "octahedral")
    for panel in PANELS:
        desk.one(f"panel-{panel}").click()
        desk.painted()
        assert desk.run(CUT_OFF) == [], panel
        top = desk.page.locator("#content").evaluate("e => e.getBoundingClientRect().top")
        assert 0 < top < 170, panel
        if panel != "draw":
            assert desk.page.locator(".side").evaluate("e => e.getBoundingClientRect().top") > top


def test_a_wide_window_gives_its_width_to_the_picture(sit_down: SitDown) -> None:
    desk = sit_down(viewport={"width": 2560, "height": 1300}).visit().open("example", "octahedral")
    assert desk.page.locator(".side").bounding_box()["width"] > 1500
    left, right = (desk.page.locator(f".pose-panel > {part}").bounding_box() for part in (".verdict", ".tabbed"))
    assert right["x"] > left["x"] + left["width"]


@pytest.mark.parametrize("width", [320, 1280])
def test_numbers_at_plots_stand_apart(sit_down: SitDown, width: int) -> None:
    """Also where a path ends far away, so that its axes have long numbers."""
    desk = sit_down(viewport={"width": width, "height": 800}).visit().open("example", "octahedral")
    desk.one("panel-motion").click()
    desk.one("path-to").fill("x=123456, z=-0.0004")
    desk.one("path-go").click()
    numbers = desk.page.locator(".plot svg text")
    numbers.first.wait_for()
    assert numbers.count() > 4
    assert touching([one.bounding_box() for one in numbers.all()]) == []


def test_nothing_moves_when_the_gallery_is_searched(chromium: Any, server: Server) -> None:
    """Few cards need no scroll bar, and its place stays."""
    barred = chromium.browser_type.launch(
        executable_path=find_browser(), args=list(ARGS), ignore_default_args=["--hide-scrollbars"]
    )
    desk = Desk(barred.new_page(viewport={"width": 1920, "height": 1080}), server).visit()
    search = desk.one("gallery-search")
    desk.page.locator(".card").first.wait_for()
    before = search.bounding_box()
    for words in ("o", "octahedral", "nothing of this name"):
        search.fill(words)
        desk.painted()
        assert search.bounding_box() == before, words
    barred.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_words_in_colours_can_be_read(sit_down: SitDown, scheme: str) -> None:
    desk = sit_down(color_scheme=scheme).visit().open("example", "octahedral")
    for stage in ("planes", "left-over", "statement"):
        desk.step(stage)
        assert desk.run(FAINT) == []


BENCH = 'let p = ab /\\ cde  # a word\n[abcd] == -2[bacd]\nclaim "halves": p == p\n:expand [ab'


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_language_of_the_bench_can_be_read(sit_down: SitDown, scheme: str) -> None:
    desk = sit_down(color_scheme=scheme).visit()
    desk.run("text => gcrules.edit({panel: 'bench', bench: text})", BENCH)
    desk.one("bench-result").first.wait_for()
    colours = "es => new Set(es.map(e => getComputedStyle(e).color)).size"
    assert desk.page.locator(".cm-line span").evaluate_all(colours) > 4
    assert desk.run(FAINT) == []


def test_every_panel_has_one_heading_and_no_empty_ones(sit_down: SitDown) -> None:
    desk = sit_down().visit()
    assert desk.page.locator("h1").count() == 1
    desk.open("example", "octahedral")
    for panel in PANELS:
        desk.one(f"panel-{panel}").click()
        desk.painted()
        assert desk.page.locator("h1:visible").count() == 1, panel
        headers = desk.page.locator("th:not(:has(*))").all_inner_texts()
        assert all(words.strip() for words in headers), panel


def test_the_menu_of_layers_closes_by_escape_and_outside(sit_down: SitDown) -> None:
    desk = sit_down().visit().open("example", "octahedral")
    shown = desk.page.locator("details.layers fieldset")
    desk.one("layers").click()
    assert shown.is_visible()
    desk.page.keyboard.press("Escape")
    assert not shown.is_visible()
    assert desk.run("document.activeElement.dataset.testid") == "layers"
    desk.one("layers").click()
    desk.one("layer-grid").click()
    assert shown.is_visible()
    desk.page.mouse.click(300, 600)
    assert not shown.is_visible()


def test_what_the_numbers_are_is_told_without_pointing(sit_down: SitDown) -> None:
    desk = sit_down().visit().open("example", "octahedral")
    desk.one("meanings").locator("summary").click()
    assert "superbracket over ρ³" in desk.text("meanings")
    assert "singularity margin" in desk.text("meanings")


def test_on_paper_the_step_is_unfolded_and_whole(sit_down: SitDown) -> None:
    desk = sit_down().visit().open("example", "octahedral")
    desk.step("check")
    more = desk.page.locator("details.more p").first
    assert not more.is_visible()
    desk.page.emulate_media(media="print")
    assert more.bounding_box()["height"] > 10
    assert desk.page.locator(".rail").is_hidden()
    scroller = desk.page.locator(".guided .scroller")
    assert scroller.evaluate("e => e.scrollHeight - e.clientHeight") <= 1
    assert desk.page.locator(".side").evaluate("e => e.getBoundingClientRect().top") < more.bounding_box()["y"]


def test_another_robot_begins_with_its_verdict(sit_down: SitDown) -> None:
    desk = sit_down(viewport={"width": 1280, "height": 600}).visit().open("robot", "3-rps")
    below = desk.page.locator(".side .lower")
    below.evaluate("e => e.scrollTo(0, e.scrollHeight)")
    assert below.evaluate("e => e.scrollTop") > 100
    desk.slide("0", 0.1)
    desk.answered()
    assert below.evaluate("e => e.scrollTop") > 100, "the same robot stays where it was"
    desk.open("robot", "delta")
    desk.page.wait_for_function("() => document.querySelector('.side .lower').scrollTop === 0")


# --- in space ------------------------------------------------------------------------------------------------------


def test_a_point_too_far_to_be_seen_is_pointed_to(sit_down: SitDown) -> None:
    """At z = −350 the four planes meet 1.6 m beside a robot of 0.3 m."""
    desk = sit_down().visit().open("example", "octahedral", "condition")
    desk.slide("z", -350)
    desk.verdict("singular")
    desk.page.wait_for_function("() => document.querySelector('[data-testid=viewer]').innerText.includes('mm away')")
    desk.one("home").click()
    desk.verdict("regular")
    desk.painted()
    assert "mm away" not in desk.text("viewer")


def test_a_robot_with_rods_has_them_in_space(sit_down: SitDown) -> None:
    """The picture has a link from each arm to the platform: bars that are there no more when the layer is put away."""
    desk = sit_down().visit().open("robot", "delta")
    desk.page.wait_for_function("() => gcrules.posing.numbers.value.skeleton.strokes.length === 15")
    desk.painted()
    drawn = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    desk.one("layers").click()
    desk.one("layer-wrenches").click()
    desk.painted()
    bare = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    assert drawn.count("<") > bare.count("<") + 15


def test_the_driven_slides_of_a_robot_are_drawn(sit_down: SitDown) -> None:
    """Those that come first in their limbs are carriages on rails; the plane at infinity is said not to be drawn."""
    desk = sit_down().visit().open("robot", "orthoglide", "statement")
    desk.page.wait_for_function("() => gcrules.posing.numbers.value.skeleton.signs.length > 0")
    desk.painted()
    driven = desk.run("gcrules.space.viewer.value.snapshot('svg')").upper().count("#F5B400")
    desk.one("layers").click()
    desk.one("layer-wrenches").click()
    assert desk.run("gcrules.space.viewer.value.snapshot('svg')").upper().count("#F5B400") == 0 < driven
    assert desk.page.locator(".legend .chip.far").get_attribute("aria-label") == "plane xyz, at infinity, not drawn"


def test_entities_through_derived_points_are_drawn(sit_down: SitDown) -> None:
    """Planes of H4 go through points in which its lines meet the platform, which no joint has."""
    desk = sit_down().visit().open("robot", "h4", "statement")
    desk.page.wait_for_function("() => document.querySelectorAll('.legend .chip').length === 4")
    desk.page.wait_for_function("() => document.querySelectorAll('.legend .chip.far').length === 0")
    for entity, name in (("e1", "d1d2p2"), ("e2", "zp1p2")):
        desk.page.locator(f".legend [data-entity={entity}]").click()  # what is chosen has its name
        desk.painted()
        assert name in "".join(desk.text("viewer").split())


def test_planes_with_directions_are_drawn(sit_down: SitDown) -> None:
    """Three planes of the 3-RPS robot go through the direction of a hinge each: their names stand in the picture."""
    desk = sit_down().visit().open("robot", "3-rps", "statement")
    desk.painted()
    shown = "".join(desk.text("viewer").split())
    assert all(name in shown for name in ("r1A1S1", "r2A2S2", "r3A3S3"))
