"""The studio's panels as a person uses them: finding the condition by hand, the bench, drawing, taking away."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.mechanisms.description.platform_file import load_platform

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs Playwright")

from studio_page import Desk

pytestmark = pytest.mark.browser

FILE = str(EXAMPLES / "octahedral.yaml")
OCTAHEDRAL = "ab af cb cd ed ef"
FACES = {"abc", "bdf", "cde", "aef"}


def opened(desk: Desk, legs: str, panel: str) -> None:
    """Six legs are open, and one of the panels."""
    desk.run("legs => gcrules.open({kind: 'legs', legs})", legs)
    desk.answered()
    desk.one(f"panel-{panel}").click()


# --- by hand -------------------------------------------------------------------------------------------------------


def propose(desk: Desk, points: str, answer: str) -> str:
    """Pick points by their letters, propose what they make; the words of the answer."""
    for name in points:
        desk.one(f"pick-{name}").click()
    desk.one("manual-propose").click()
    desk.page.wait_for_selector(f"[data-testid=manual-answer][data-answer={answer}]:has-text('{points}')")
    return desk.text("manual-answer")


def found(desk: Desk) -> set[str]:
    """The entities on the board, without stars."""
    return {"".join(e["points"]) for e in desk.run("gcrules.space.overlay.value.entities")}


def test_proposals_are_refused_and_confirmed(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "manual")
    desk.one("manual-form").wait_for()
    words = propose(desk, "abd", "refused")
    assert "term 2" in words
    assert "has no bracket with a, b and d" in words
    assert desk.page.locator(".board .row.marked").inner_text().replace("\n", "").startswith("2")
    assert desk.text("manual-left").split() == list("aabbccddeeff")
    propose(desk, "abc", "confirmed")
    propose(desk, "bdf", "confirmed")
    desk.page.wait_for_function("() => gcrules.space.overlay.value.entities.length === 2")
    assert found(desk) == {"abc", "bdf"}
    desk.one("manual-hint").click()
    assert "plane" in desk.text("manual-hinted")
    desk.one("manual-auto").click()
    desk.one("manual-confirmed").wait_for()
    assert desk.text("manual-statement").replace("\n", "").endswith("meet in a point (possibly at infinity).")
    desk.page.wait_for_function("() => gcrules.space.overlay.value.entities.length === 4")
    assert {"".join(sorted(e)) for e in found(desk)} == FACES
    desk.one("manual-back").click()
    desk.one("propose-plane").wait_for()
    desk.one("manual-again").click()
    desk.one("manual-confirmed").wait_for()


def test_points_are_picked_in_space_and_kept_over_a_reload(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "manual")
    desk.one("propose-plane").wait_for()
    desk.painted()
    for name in "abc":
        desk.page.mouse.click(*desk.place(name))
    assert desk.text("manual-slots").split() == ["a", "b", "c"]
    desk.one("manual-propose").click()
    desk.page.wait_for_selector("[data-testid=manual-answer][data-answer=confirmed]")
    desk.page.wait_for_function("() => location.hash.length > 20")
    desk.page.wait_for_timeout(400)
    desk.page.reload()
    desk.page.wait_for_selector("[data-testid=manual-answer][data-answer=confirmed]")
    assert desk.text("manual-history").split("\n")[0] == "plane abc"


def test_a_counterexample_is_drawn_and_commands_are_typed(desk: Desk) -> None:
    opened(desk, "Aa Ab Ba Bb Cc Dd", "manual")
    line = desk.one("manual-command")
    line.fill("tetrahedron Zabc")
    line.press("Enter")
    desk.one("fault").wait_for()
    assert desk.run("gcrules.commands$.value") == []
    desk.one("manual-shortest").click()
    desk.page.wait_for_selector("[data-testid=manual-answer]:has-text('shortest')")
    line.fill("tetrahedron ABCD")
    line.press("Enter")
    desk.one("counterexample").wait_for()
    assert "does not divide the superbracket" in desk.text("manual-answer")
    rows = desk.page.locator("[data-testid=counterexample] tr").all_inner_texts()
    at = {r.split()[0]: [Fraction(c.replace("−", "-")) for c in r.split()[1:]] for r in rows}
    assert set(at) == set("ABCDabcd")
    edges = [[p - q for p, q in zip(at[n], at["A"], strict=True)] for n in "BCD"]
    assert determinant(edges) == 0


def determinant(m: list[list[Fraction]]) -> Fraction:
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


# --- the bench -----------------------------------------------------------------------------------------------------


def write(desk: Desk, text: str) -> None:
    desk.page.locator(".cm-content").click()
    desk.page.keyboard.press("Control+a")
    desk.page.keyboard.insert_text(text)
    desk.page.keyboard.press("Control+Enter")


def test_the_bench_answers_marks_faults_and_draws(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "bench")
    write(desk, "let W = ace\nlet m = abc /\\ bdf\n[abcd] == [abdc]\nab /\\ c")
    squiggle = desk.page.locator(".cm-lintRange-error")
    squiggle.first.wait_for()
    assert "".join(squiggle.all_inner_texts()) == "ab /\\ c"
    assert "too small to meet in rank 4" in desk.text("fault")
    results = desk.one("bench-result")
    assert [r.get_attribute("data-verdict") for r in results.all()] == ["value", "value", "refuted"]
    overlay = desk.run("gcrules.space.overlay.value")
    (line,) = overlay["constructed"]
    (plane,) = overlay["planes"]
    assert (line["label"], plane["label"]) == ("m", "W")
    points = desk.numbers["points"]
    assert math.dist(foot(points["b"], line), points["b"]) < 1e-9 * desk.study["size"]
    for name in "ace":
        assert sum(n * c for n, c in zip(plane["normal"], points[name], strict=True)) == pytest.approx(plane["offset"])
    picture = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    assert ">m<" in picture
    assert ">W<" in picture
    desk.page.get_by_label("m in 3D").click()
    desk.page.wait_for_function("() => gcrules.space.overlay.value.constructed.length === 0")


def foot(p: list[float], line: Any) -> list[float]:
    """The point of a line that is nearest to p."""
    at, d = line["at"], line["direction"]
    t = sum((x - a) * c for x, a, c in zip(p, at, d, strict=True))
    return [a + t * c for a, c in zip(at, d, strict=True)]


def test_what_the_bench_draws_follows_the_pose(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "bench")
    write(desk, "let W = bdf")
    desk.page.wait_for_function("() => gcrules.space.overlay.value?.planes?.length === 1")
    before = desk.run("gcrules.space.overlay.value.planes[0].offset")
    desk.run("gcrules.edit({pose: {translation: [0, 0, 0.25], quaternion: [1, 0, 0, 0]}})")
    desk.page.wait_for_function(
        "before => Math.abs(gcrules.space.overlay.value.planes[0].offset - before) > 0.1", arg=before
    )


def test_typing_keeps_every_letter_and_examples_are_proved(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "bench")
    desk.page.locator(".cm-content").click()
    text = "[abcd][efgh] == [efgh][abcd] # as it is typed"
    desk.page.keyboard.type(text)
    assert desk.run("gcrules.bench$.value") == text
    desk.page.wait_for_selector("[data-testid=bench-result][data-verdict=proved]")
    desk.one("bench-examples").select_option(label="This robot")
    desk.page.wait_for_selector("[data-testid=bench-result][data-name=m]")
    desk.page.wait_for_selector("[data-testid=bench-result][data-verdict=proved]")
    assert desk.page.locator(".cm-lintRange-error").count() == 0


# --- drawing -------------------------------------------------------------------------------------------------------


def drag(desk: Desk, start: tuple[float, float], end: tuple[float, float]) -> None:
    mouse = desk.page.mouse
    mouse.move(*start)
    mouse.down()
    mouse.move((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    mouse.move(*end)
    mouse.up()


def joint(desk: Desk, name: str) -> tuple[float, float]:
    box = desk.page.locator(f"[data-testid=sheet-{name}] .dot").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def ring(desk: Desk, far: float, *degrees: float) -> list[tuple[float, float]]:
    """Places on the sheet, around its middle."""
    box = desk.one("sheet").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    return [(x + far * math.cos(math.radians(a)), y - far * math.sin(math.radians(a))) for a in degrees]


def test_a_robot_is_drawn_from_scratch(desk: Desk) -> None:
    desk.one("start-draw").click()
    assert "Click on the sheet" in desk.text("draw-missing")
    for place in ring(desk, 220, 90, 210, 330, 20):
        desk.page.mouse.click(*place)
    desk.one("tool-platform").click()
    for place in ring(desk, 110, 30, 150, 270):
        desk.page.mouse.click(*place)
    desk.one("tool-leg").click()
    for leg in ("Aa", "Ab", "Bb", "Bc", "Cc"):
        drag(desk, joint(desk, leg[0]), joint(desk, leg[1]))
    assert desk.text("draw-missing") == "Five legs so far: one more to go."
    assert desk.page.locator("[data-testid=draw-schematic] line").count() == 5
    assert desk.one("draw-open").is_disabled()
    drag(desk, joint(desk, "D"), joint(desk, "a"))
    desk.one("draw-statement").wait_for()
    assert "Class 4-3" in desk.text("draw-statement")
    desk.one("tool-base").click()
    drag(desk, joint(desk, "D"), joint(desk, "C"))  # dropped on one another, joints are one
    assert desk.run("gcrules.sketch$.value.base") == ["A", "B", "C"]
    desk.page.wait_for_selector("[data-testid=draw-statement]:not(.old):has-text('four planes')")
    desk.one("undo").click()
    assert desk.run("gcrules.sketch$.value.base") == ["A", "B", "C", "D"]
    desk.one("redo").click()
    desk.one("draw-title").fill("Mine")
    desk.one("draw-open").click()
    desk.one("stage-structure").wait_for()
    assert "Mine" in desk.text("title")
    assert {"".join(leg) for leg in desk.study["legs"]} == {"Aa", "Ab", "Bb", "Bc", "Cc", "Ca"}
    assert desk.study["points"]["A"][2] == 0
    assert desk.study["points"]["a"][2] == 200


def test_drawing_with_the_keyboard_alone(desk: Desk) -> None:
    desk.one("start-draw").click()
    for body in ("base", "platform"):
        for _ in range(3):
            desk.one(f"add-{body}").press("Enter")
    name = desk.one("name-a")
    name.fill("P1")
    name.press("Enter")
    desk.one("name-b").fill("A")
    desk.one("name-b").press("Enter")
    assert desk.text("draw-said") == "There is a point A already."
    x = desk.run("gcrules.sketch$.value.points.B[0]")
    desk.one("sheet-B").focus()
    desk.page.keyboard.press("ArrowRight")
    assert desk.run("gcrules.sketch$.value.points.B[0]") == x + 20
    for leg in (("A", "P1"), ("A", "b"), ("B", "b"), ("B", "c"), ("C", "c")):
        desk.one("leg-from").select_option(leg[0])
        desk.one("leg-to").select_option(leg[1])
        desk.one("add-leg").press("Enter")
    for end in ("C", "P1"):
        desk.one(f"sheet-{end}").focus()
        desk.page.keyboard.press("Enter")
    assert len(desk.run("gcrules.sketch$.value.legs")) == 6
    desk.one("z-P1").fill("150")
    desk.one("z-P1").press("Enter")
    desk.one("draw-statement").wait_for()
    desk.one("sheet-C").focus()
    desk.page.keyboard.press("Delete")
    assert desk.text("draw-missing") == "Four legs so far: two more to go."


def test_drawing_starts_from_what_is_open(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "draw")
    desk.one("draw-from-study").click()
    assert desk.run("gcrules.sketch$.value.legs").__len__() == 6
    desk.page.wait_for_selector("[data-testid=draw-statement]:has-text('four planes')")


# --- taking away ---------------------------------------------------------------------------------------------------


@pytest.fixture
def taken(desk: Desk, tmp_path: Path) -> Callable[[str], Path]:
    def take(thing: str) -> Path:
        with desk.page.expect_download() as waiting:
            desk.one(f"take-{thing}").click()
        path = tmp_path / str(waiting.value.suggested_filename)
        waiting.value.save_as(path)
        return path

    return take


def test_files_are_taken_away(desk: Desk, taken: Callable[[str], Path]) -> None:
    desk.open("example", "octahedral")
    desk.one("panel-take-away").click()
    assert taken("latex").read_text(encoding="utf-8").count("\\documentclass") == 1
    assert json.loads(taken("json").read_text(encoding="utf-8"))["condition"]["kind"] == "four-planes"
    assert len(load_platform(taken("yaml")).legs) == 6
    assert len(json.loads(taken("proof").read_text(encoding="utf-8"))["theorems"]) == 2
    assert taken("coq").read_text(encoding="utf-8").count("\nPrint Assumptions ") == 2
    for thing in ("svg", "view-svg"):
        assert taken(thing).read_text(encoding="utf-8").lstrip().startswith("<svg")
    assert taken("view-png").read_bytes().startswith(b"\x89PNG")
    for thing in ("html", "latex", "svg", "view-png"):
        desk.one(f"look-{thing}").click()
        desk.one(f"preview-{thing}").wait_for()


def test_the_report_opens_as_a_file(desk: Desk, taken: Callable[[str], Path]) -> None:
    desk.open("example", "octahedral")
    desk.one("panel-take-away").click()
    path = taken("html")
    page = desk.page.context.new_page()
    requests: list[str] = []
    page.on("request", lambda request: requests.append(request.url))
    page.on("pageerror", lambda fault: desk.faults.append(str(fault)))
    page.goto(path.as_uri())
    page.wait_for_selector("canvas, svg")
    assert "meet in a point" in page.inner_text("body")
    assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []


def test_back_leads_to_the_last_panel_and_keeps_the_pose(desk: Desk) -> None:
    """Not out of the studio; to another structure it leads as well, and forward again."""
    desk.open("example", "octahedral", "statement")
    desk.run("gcrules.go({ panel: 'motion' })")
    desk.slide("z", -20)
    at = "() => gcrules.panel$.value === '{}' && gcrules.pose$.value.translation[2] === -20"
    desk.page.wait_for_function(at.format("motion"))
    desk.page.go_back()
    desk.page.wait_for_function(at.format("guided"))
    desk.page.go_forward()
    desk.page.wait_for_function(at.format("motion"))
    desk.page.go_back()
    desk.page.go_back()
    desk.page.wait_for_function("() => gcrules.panel$.value === 'start'")


def test_the_link_restores_the_state(desk: Desk) -> None:
    opened(desk, OCTAHEDRAL, "take-away")
    desk.run("gcrules.edit({pose: {translation: [0.1, 0, 0.2], quaternion: [1, 0, 0, 0]}, bench: 'ab /\\\\ cde'})")
    desk.page.wait_for_function("() => document.querySelector('[data-testid=link]').value.includes('#')")
    desk.page.wait_for_timeout(100)
    desk.one("link-copy").click()
    link = desk.run("navigator.clipboard.readText()")
    assert link == desk.one("link").input_value()
    assert "token" not in link
    desk.page.goto("about:blank")
    desk.page.goto(link)
    desk.answered()
    assert desk.pose["translation"] == [0.1, 0, 0.2]
    assert desk.run("gcrules.bench$.value") == "ab /\\ cde"


# --- paths and maps ------------------------------------------------------------------------------------------------


def motion(desk: Desk, kind: str, name: str) -> None:
    desk.open(kind, name)
    desk.one("panel-motion").click()


def test_a_path_leads_the_robot_to_its_singular_place(desk: Desk) -> None:
    motion(desk, "robot", "3-rps")
    assert desk.one("path-go").is_disabled(), "home to home is no path"
    desk.one("path-to").fill("z=0.1")
    desk.one("path-to").press("Enter")
    assert "too few coordinates" in desk.text("fault")
    desk.one("path-to").fill("z=0.1, roll=110deg, pitch=0deg")
    desk.one("path-go").click()
    desk.page.wait_for_selector("[data-testid=path-verdict][data-verdict=singular]")
    desk.one("path-place-go").click()
    desk.page.wait_for_function("() => gcrules.posing.numbers.value?.margin < 1e-5")
    assert "σ 0" in desk.text("path-readout")
    lead = desk.one("path-lead")
    lead.focus()
    for _ in range(3):
        lead.press("ArrowLeft")
    desk.answered()
    shown = float(desk.text("path-readout").split()[1])
    assert 0.3 < shown < 0.42
    assert desk.numbers["margin"] > 0.01
    desk.one("path-from-here").click()
    desk.page.wait_for_function("() => location.hash.length > 20")
    desk.page.wait_for_timeout(400)
    marked = desk.run("gcrules.tour$.value")
    desk.page.reload()
    desk.one("path-to").wait_for()
    assert desk.run("gcrules.tour$.value") == marked
    assert marked["start"]["coordinates"]
    assert desk.one("path-to").input_value() == "z=0.1, roll=110deg, pitch=0deg"


def test_a_way_around_leads_past_singular_poses(desk: Desk) -> None:
    motion(desk, "example", "octahedral")
    desk.one("path-to").fill("0 0 -490")
    desk.one("path-around").click()
    desk.page.wait_for_selector("[data-testid=path-detour][data-outcome=none]")
    assert "There is none, proved" in desk.text("path-detour")
    assert desk.one("path-verdict").get_attribute("data-verdict") == "singular"
    desk.one("path-to").fill("x=110.2, y=27.2, z=-654.7, roll=-130.4deg, pitch=46.3deg, yaw=-72.9deg")
    desk.one("path-around").click()
    desk.page.wait_for_selector("[data-testid=path-detour][data-outcome=way]")
    assert desk.one("path-verdict").get_attribute("data-verdict") != "singular"


def test_a_map_is_read_by_pointer_and_keys_and_leads_the_robot(desk: Desk) -> None:
    motion(desk, "example", "octahedral")
    desk.one("map-axis-1").select_option("x")
    assert [r["name"] for r in desk.run("gcrules.tour$.value.over")] == ["y", "x"], "they change places"
    low = desk.one("map-low-0")
    low.fill("500")
    low.press("Enter")
    desk.one("map-go").click()
    assert "reversed" in desk.text("fault")
    low.fill("-100")
    low.press("Enter")
    desk.one("map-nodes").select_option("11")
    desk.one("map-go").click()
    finest = "map.shown.value?.asked.over[0].includes(':11') && map.now.value.state !== 'busy'"
    desk.page.wait_for_function(f"() => {{ const map = gcrules.touring.map; return {finest}; }}")
    assert "cells" in desk.text("map-guarantee")
    plot = desk.one("map-plot")
    plot.scroll_into_view_if_needed()
    box = plot.bounding_box()
    plot.click(position={"x": box["width"] - 1, "y": box["height"] - 1})
    desk.page.wait_for_function("() => gcrules.pose$.value.translation[0] !== 0")
    desk.answered()
    over = desk.run("gcrules.tour$.value.over")
    assert desk.pose["translation"] == pytest.approx([over[1]["low"], over[0]["high"], 0], abs=5)
    keys = ["ArrowLeft", "ArrowUp", "Enter"]  # all at once: no step is lost where keys are quicker than pictures
    plot.evaluate(
        "(plot, keys) => keys.forEach(key => plot.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true})))",
        keys,
    )
    first, second = ((r["high"] - r["low"]) / 10 for r in over)
    wanted = [over[1]["low"] + second, over[0]["high"] - first, 0]
    desk.page.wait_for_function("x => Math.abs(gcrules.pose$.value.translation[0] - x) < 1e-6", arg=wanted[0])
    desk.answered()
    assert desk.pose["translation"] == pytest.approx(wanted)
    margin = desk.numbers["margin"]
    assert f"σ {margin:.3g}" in desk.text("map-readout")
    assert "proved free" in desk.text("map-readout")


def test_a_working_mode_is_taken_from_the_list(desk: Desk) -> None:
    """The list stays, the robot stands otherwise, a link keeps the mode, and undo brings home's back."""
    desk.run("() => gcrules.open({kind: 'robot', id: '3-rrr'})")
    desk.answered()
    before = desk.numbers["margin"]
    desk.one("modes-list").click()
    modes = desk.page.get_by_test_id("mode")
    modes.last.wait_for()
    assert modes.count() == 8
    assert modes.first.get_attribute("aria-pressed") == "true"
    modes.last.click()
    desk.page.wait_for_function("() => gcrules.study.value?.title.endsWith('working mode ---')")
    desk.answered()
    assert desk.numbers["margin"] != before
    assert modes.last.get_attribute("aria-pressed") == "true"
    desk.page.wait_for_timeout(400)  # until the address is written
    desk.page.reload()
    desk.page.wait_for_function("() => gcrules.study.value?.title.endsWith('working mode ---')")
    desk.run("() => gcrules.open({kind: 'robot', id: '3-rrr'})")
    desk.answered()
    assert desk.numbers["margin"] == pytest.approx(before)


def assemblies(desk: Desk, **subject: str) -> Any:
    """The assembly modes of a robot, as the page lists them."""
    desk.run(f"() => gcrules.open({json.dumps(subject)})")
    desk.answered()
    desk.one("panel-where").click()
    desk.one("assemblies-go").click()
    modes = desk.page.get_by_test_id("assembly")
    modes.last.wait_for()
    return modes


def test_assembly_modes_take_the_platform_along(desk: Desk) -> None:
    """Each picture leads to a pose with the same legs; the list says when it is about another pose."""
    modes = assemblies(desk, kind="example", name="octahedral")
    assert modes.count() == 8
    assert modes.first.get_attribute("aria-pressed") == "true"
    before = desk.numbers["margin"]
    modes.nth(2).click()
    desk.page.wait_for_function("() => !gcrules.moving.active.value")
    desk.answered()
    assert modes.nth(2).get_attribute("aria-pressed") == "true"
    assert desk.numbers["margin"] == pytest.approx(gc.assembly_modes(FILE)[2].margin, abs=1e-6)
    assert desk.numbers["margin"] < before
    tips = desk.page.locator(".assemblies .tip")
    assert tips.count() == 0
    desk.run("() => gcrules.edit({pose: {translation: [0, 0, -10], quaternion: [1, 0, 0, 0]}})")
    tips.wait_for()


def test_an_assembly_mode_of_a_robot_is_opened(desk: Desk) -> None:
    modes = assemblies(desk, kind="robot", id="3-rpr")
    modes.last.click()
    desk.page.wait_for_function("() => gcrules.study.value?.title.endsWith('assembly mode 2')")
    desk.answered()
    assert modes.last.get_attribute("aria-pressed") == "true"
    assert desk.text("panel-where") == "Where to"


def test_aspects_and_a_free_box_are_told(desk: Desk) -> None:
    desk.run("() => gcrules.open({kind: 'example', name: 'octahedral'})")
    desk.answered()
    desk.one("panel-where").click()
    desk.one("aspects-go").click()
    sets = desk.page.get_by_test_id("aspect")
    sets.last.wait_for()
    assert desk.text("aspects-verdict").endswith("lie in exactly 2 aspects.")
    assert "without a singularity, proved." in desk.page.get_by_test_id("aspect-change").first.inner_text()
    desk.page.get_by_test_id("aspect-go").last.click()
    desk.page.wait_for_function("() => !gcrules.moving.active.value")
    desk.answered()
    assert desk.pose["translation"][2] == pytest.approx(-733.333, abs=1e-2)
    desk.stop("free-box", "free-stop")


def test_a_long_map_is_stopped(desk: Desk) -> None:
    motion(desk, "robot", "delta")
    desk.one("map-nodes").select_option("81")
    desk.stop("map-go", "map-stop")
