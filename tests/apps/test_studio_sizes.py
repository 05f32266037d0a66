"""The studio's page in narrow and in very wide windows, and with long names: nothing runs out of its place."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

import pytest
from places import ROOT

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

SitDown = Callable[..., Desk]

TITLE = "TheRobotOfTheLaboratoryForParallelKinematicsWithAVeryLongTitle, and more words"
CORNERS = [
    *("left_front_corner_of_the_base_frame_next", "right_front_corner_of_the_base_frame_too"),
    *("middle_of_the_back_of_the_base_frame_low", "first_joint_of_the_moving_platform_above"),
    *("second_joint_of_the_moving_platform_high", "third_joint_of_the_moving_platform_above"),
]
PLACES = ("[0, 0, 0]", "[1, 0, 0]", "[0.5, 0.9, 0]", "[0.2, 0.2, 1]", "[0.8, 0.25, 1.1]", "[0.5, 0.7, 0.9]")
LEGS = ((0, 3), (0, 4), (1, 4), (1, 5), (2, 5), (2, 3))
PLATFORM = "\n".join(
    [
        f"title: {TITLE}",
        "points:",
        *(f"  {name}: {at}" for name, at in zip(CORNERS, PLACES, strict=True)),
        "legs:",
        *(f"  - [{CORNERS[a]}, {CORNERS[b]}]" for a, b in LEGS),
    ]
)
"""Points with the longest names that a platform takes."""


def long_robot() -> str:
    """The 3-RPS robot, its joints with the longest names that a robot takes."""
    text = (ROOT / "plugins" / "3-rps" / "robot.yaml").read_text()
    text = re.sub(r"\b([ASr])(?=[%123])", r"\g<1>1234567890", text)
    text = text.replace("leg %", "the_leg_that_carries_most_of_the_weight_of_the_platform_%")
    return re.sub("title: .*", f"title: {TITLE}", text)


def opened(desk: Desk, what: str) -> Desk:
    kind, _, name = what.partition(" ")
    if kind != "file":
        return desk.open(kind, name)
    source = {"kind": "file", "text": PLATFORM if name == "platform" else long_robot(), "name": f"{'long_' * 12}.yaml"}
    desk.run("source => gcrules.open(source)", source)
    desk.answered()
    return desk


ROLLS = ".formula, .monomials, .legend, .viewer, svg, .scrolled, .katex, .cm-editor, .paper, .chart, .bars"
"""What is made to be scrolled sideways, or draws."""

RUNS_OUT = f"""() => [document.documentElement, ...document.querySelectorAll(".shell *")].filter(e =>
  e.clientWidth > 1 && !e.closest("{ROLLS}, .sr-only, .skip") && !e.matches("input, .sliders")
  && e.checkVisibility({{visibilityProperty: true}}) && e.scrollWidth > e.clientWidth + 2
  && getComputedStyle(e).textOverflow !== "ellipsis").map(e => `${{e.tagName}}.${{e.className}} ${{e.scrollWidth}} >
  ${{e.clientWidth}}: ${{e.textContent.slice(0, 60)}}`)"""
"""Elements whose contents are wider than they are."""

SQUEEZED = """() => [...document.querySelectorAll(".shell *")].filter(e => {
  const words = [...e.childNodes].filter(n => n.nodeType === 3 && n.data.trim().split(/\\s+/).length > 3);
  const box = e.getBoundingClientRect(), em = parseFloat(getComputedStyle(e).fontSize);
  return words.length > 0 && !e.closest("svg, .sr-only, .viewer, .katex") && e.checkVisibility()
    && box.width > 1 && box.width < 8 * 0.55 * em && box.height > 4 * em; }).map(e => e.outerHTML.slice(0, 120))"""
"""Text in lines of fewer than eight letters."""


def views(desk: Desk) -> Iterator[str]:
    """Each panel, each step and each tab of numbers, one after the other on show."""
    for panel in desk.run("[...document.querySelectorAll('.rail button')].map(b => b.dataset.testid)"):
        desk.one(panel).click()
        if panel == "panel-project":
            desk.one("project-keep").click()
        if panel == "panel-guided":
            for stage in desk.run("gcrules.study.value.stages.map(s => s.id)"):
                desk.step(stage)
                yield f"step {stage}"
            for tab in ("tab-readings", "tab-actuators", "tab-way"):
                desk.one(tab).click()
                yield tab
        yield panel


@pytest.mark.parametrize(
    ("width", "what"),
    [
        (320, "class 3-3.3"),
        (390, "class 3-3.3"),
        (320, "robot gallardo-4dof"),
        (320, "file platform"),
        (1280, "file platform"),
        (390, "file robot"),
        (1280, "file robot"),
    ],
)
def test_nothing_runs_out_of_its_place(sit_down: SitDown, width: int, what: str) -> None:
    desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), what)
    found: dict[str, Any] = {}
    for view in views(desk):
        desk.painted()
        found[view] = desk.run(RUNS_OUT) + desk.run(SQUEEZED)
    assert len(found) > 15
    assert {view: seen for view, seen in found.items() if seen} == {}


def test_the_limb_editor_holds_long_names(sit_down: SitDown) -> None:
    for width in (320, 1280):
        desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), "file robot")
        desk.one("panel-dimensions").click()
        desk.one("shape-limbs").click()
        desk.one("limbs-title").wait_for()
        desk.painted()
        assert desk.run(RUNS_OUT) + desk.run(SQUEEZED) == []


@pytest.mark.parametrize("width", [320, 390, 480])
def test_bar_and_rail_of_a_phone_have_all_buttons_apart(sit_down: SitDown, width: int) -> None:
    desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), "class 3-3.3")
    for where, least in ((".top-bar .tools button", 7), (".rail button span", 10)):
        boxes = [box for one in desk.page.locator(where).all() if (box := one.bounding_box())]
        assert len(boxes) >= least
        assert all(box["x"] >= 0 and box["x"] + box["width"] <= width for box in boxes)
        for a, b in combinations(boxes, 2):
            apart = max(b["x"] - a["x"] - a["width"], a["x"] - b["x"] - b["width"])
            assert apart >= (0 if "tools" in where else 2) or a["y"] != b["y"]


@pytest.mark.parametrize("width", [390, 1280])
def test_a_panel_and_a_step_begin_at_their_top(sit_down: SitDown, width: int) -> None:
    """However far down the one before was read."""
    desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), "class 3-3.3")

    def in_sight(title: str) -> bool:
        box = desk.page.get_by_role("heading", name=title).bounding_box()
        rail = desk.page.locator(".rail").bounding_box()
        top = rail["y"] + rail["height"] if width == 390 else rail["y"]
        return bool(top <= box["y"] < top + 120)

    for panel, title in (("where", "Where can it go"), ("motion", "Path and map"), ("take-away", "Take away")):
        desk.one(f"panel-{panel}").click()
        assert in_sight(title), panel
        desk.page.locator("#content section").last.scroll_into_view_if_needed()
        if width == 390:
            assert not in_sight(title), panel
    desk.one("panel-guided").click()
    for title in ("Structure", "Superbracket", "Shortest form"):
        assert in_sight(title)
        desk.page.keyboard.press("n")
        desk.painted()


@pytest.mark.parametrize("width", [320, 390])
def test_what_belongs_together_stays_in_one_line_on_a_phone(sit_down: SitDown, width: int) -> None:
    """The two ends of a range; a title and the cross that closes what it names."""
    desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), "class 3-3.3")
    desk.one("panel-motion").click()
    for axis in (0, 1):
        low, high = (desk.one(f"map-{end}-{axis}").bounding_box()["y"] for end in ("low", "high"))
        assert low == high
    desk.one("keys").click()
    desk.page.locator(".key-list h2").wait_for()
    title, cross = (one.bounding_box() for one in (desk.page.locator(".key-list h2"), desk.one("key-list-close")))
    assert cross["y"] <= title["y"] + title["height"] / 2 <= cross["y"] + cross["height"]
    desk.one("key-list-close").click()


@pytest.mark.parametrize("width", [320, 390, 430, 480, 1280])
def test_the_list_of_layers_is_wholly_in_sight(sit_down: SitDown, width: int) -> None:
    """Whatever row its button is in."""
    desk = opened(sit_down(viewport={"width": width, "height": 740}).visit(), "class 3-3.3")
    desk.one("layers").click()
    for one in desk.page.locator(".layers fieldset, .layers label").all():
        box = one.bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
    desk.one("layer-grid").uncheck()  # what is covered could not be clicked
    desk.page.wait_for_function("() => !gcrules.space.layers.value.grid")


@pytest.mark.parametrize("width", [2560, 3440, 3840])
def test_a_very_wide_window_is_used(sit_down: SitDown, width: int) -> None:
    """Sections, cards and numbers stand side by side; what is set grows with the window."""
    desk = opened(sit_down(viewport={"width": width, "height": 1440}).visit(), "class 3-3.3")
    size = float(desk.run("parseFloat(getComputedStyle(document.documentElement).fontSize)"))
    assert (size > 18) == (width > 2560)

    def lefts(selector: str) -> int:
        return len({round(box["x"]) for one in desk.page.locator(selector).all() if (box := one.bounding_box())})

    assert lefts(".pose-panel > *") == 3
    for panel, sections in (("motion", ".motion > section"), ("take-away", ".take-away > section")):
        desk.one(f"panel-{panel}").click()
        assert lefts(sections) == (1 if width == 2560 else 2), panel
    desk.one("panel-start").click()
    start = desk.page.locator(".start").bounding_box()
    assert start["width"] > 0.85 * width
    assert lefts(".start .group") > 1


@pytest.mark.parametrize("width", [390, 1280, 2560])
def test_answers_of_the_bench_are_broken_once(sit_down: SitDown, width: int) -> None:
    """No line ends before the width is used, and what is broken goes on farther in."""
    desk = opened(sit_down(viewport={"width": width, "height": 900}).visit(), "class 3-3.3")
    desk.one("panel-bench").click()
    desk.run("gcrules.edit({bench: ':analyze aA bB cC dD eE fF'})")
    desk.one("bench-run").click()
    desk.one("bench-more").click()
    desk.painted()
    lines = desk.page.locator(".said span").evaluate_all(
        """spans => spans.map(span => { const range = document.createRange(), rows = {}; range.selectNodeContents(span);
        for (const {top, left, right, width} of range.getClientRects()) if (width > 1) {
          const row = rows[Math.round(top)] ??= [left, right];
          rows[Math.round(top)] = [Math.min(row[0], left), Math.max(row[1], right)]; }
        return {rows: Object.values(rows), right: span.getBoundingClientRect().right}; })"""
    )
    broken = [line for line in lines if len(line["rows"]) > 1]
    assert broken
    for line in broken:
        (first, end), *others = line["rows"]
        assert all(left > first for left, _ in others)
        assert end > line["right"] - 160
    if width > 390:  # where there is room, what goes on stands below what is said
        facts = desk.page.locator(".said span").evaluate_all(
            """spans => spans.filter(span => /^ *\\S+(?: \\S+)*? {2,18}\\S/.test(span.textContent)).map(span => {
            const fact = /^ *\\S+(?: \\S+)*? {2,}/.exec(span.textContent)[0].length, range = document.createRange();
            if (fact > 18) return null;
            range.setStart(span.firstChild, fact); range.setEnd(span.firstChild, fact + 1);
            const goesOn = span.getBoundingClientRect().left + parseFloat(getComputedStyle(span).paddingLeft);
            return Math.abs(range.getBoundingClientRect().left - goesOn); }).filter(off => off !== null)"""
        )
        assert facts
        assert max(facts) < 1
    assert desk.run(RUNS_OUT) == []


@pytest.mark.parametrize("what", ["example octahedral", "robot 6-rus", "robot delta"])
def test_the_way_is_in_sight_while_the_robot_is_moved(sit_down: SitDown, what: str) -> None:
    """On a laptop, without scrolling: its plot with the marks of singular poses, and the button that plays it."""
    desk = opened(sit_down(viewport={"width": 1440, "height": 900}).visit(), what)
    for seen in ("[data-testid=way-chart]", "[data-testid=way-play]"):
        box = desk.page.locator(seen).first.bounding_box()
        assert box is not None
        assert box["y"] + box["height"] <= 900, seen


@pytest.mark.parametrize("size", [(1440, 900), (1280, 800)])
def test_a_map_comes_into_sight(sit_down: SitDown, size: tuple[int, int]) -> None:
    """With the question above it; whoever scrolls away is left there."""
    width, height = size
    desk = opened(sit_down(viewport={"width": width, "height": height}).visit(), "robot 3-rps")
    desk.run("gcrules.edit({panel: 'motion'})")
    desk.one("map-go").click()
    plot = desk.one("map-plot")
    plot.wait_for()
    desk.page.wait_for_function("() => !document.querySelector('[data-testid=map-stop]')")
    desk.painted()
    box = plot.bounding_box()
    assert box["y"] > 0
    assert box["y"] + box["height"] <= height
    desk.run("document.querySelector('.motion > header').scrollIntoView()")
    desk.one("map-nodes").select_option(index=1)
    desk.page.wait_for_function("() => gcrules.touring.map.now.value.state === 'busy'")
    desk.page.wait_for_function("() => gcrules.touring.map.now.value.state !== 'busy'")
    assert plot.bounding_box()["y"] > box["y"]
