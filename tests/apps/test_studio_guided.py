"""The guided path of the studio as a person takes it, in a browser: the steps, the pose, the singularity, the state.

With GCRULES_STUDIO_PICTURES=1 a picture of each main view is written into build/studio-pictures, to be looked at.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import find_browser
from places import ROOT

import gcrules as gc
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.language.legs_text import legs_text
from gcrules.algebra.language.text import text
from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.load import read_robot
from gcrules.rules.catalog.file import load as load_catalog

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import WIDE, Desk, Server, studio

pytestmark = pytest.mark.browser

OCTAHEDRAL = load_platform(ROOT / "examples" / "octahedral.yaml")
TABLET = {"width": 1024, "height": 768}
STAGES = [
    "structure",
    "superbracket",
    "shortest",
    "tetrahedra",
    "planes",
    "lines",
    "left-over",
    "condition",
    "statement",
    "check",
]


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


# --- the guided path -----------------------------------------------------------------------------------------------


def rows(panel: Any) -> Counter[tuple[int, frozenset[str]]]:
    """The monomials of a table in the document: sign and brackets, with the letters in their sequence."""
    found = panel.locator("[data-testid=monomials] .row").evaluate_all(
        """rows => rows.map(row => [row.querySelector(".sign").textContent.trim(),
        [...row.querySelectorAll("[data-bracket]")].map(b => b.dataset.bracket)])"""
    )
    return Counter((int(sign.replace("−", "-") + "1"), tuple(sorted(brackets))) for sign, brackets in found)


def terms(polynomial: BracketPolynomial, sign: int = 1) -> Counter[tuple[int, tuple[str, ...]]]:
    """The same of a polynomial of the library, whose coefficients here are all ±1."""
    assert set(map(abs, polynomial.terms.values())) == {1}
    return Counter(
        (c * sign, tuple(sorted(" ".join(polynomial.points[i] for i in row) for row in brackets)))
        for brackets, c in polynomial.terms.items()
    )


def chips(panel: Any) -> set[tuple[str, str]]:
    """Kind and letters of the entities that a step shows."""
    found = panel.locator(".chip").evaluate_all("chips => chips.map(chip => chip.getAttribute('aria-label'))")
    return {(kind, letters.replace("*", "")) for kind, letters in (one.split(" ", 1) for one in found)}


def bare(formula: str) -> str:
    """A formula without spaces and without the signs of products."""
    return re.sub(r"[\s·*]", "", formula).replace("−", "-")


def formulas(panel: Any) -> list[str]:
    found = panel.locator(".formula").evaluate_all("all => all.map(one => one.getAttribute('aria-label'))")
    return [bare(one) for one in found]


def walk(desk: Desk) -> Iterator[tuple[str, Any]]:
    """From step to step by the button that leads on."""
    stage = desk.study["stages"][0]["id"]
    while True:
        panel = desk.one(f"stage-{stage}")
        panel.wait_for()
        assert desk.one(f"step-{stage}").get_attribute("aria-selected") == "true"
        yield stage, panel
        onward = desk.one("stage-next")
        if not onward.count():
            return
        onward.click()
        stage = desk.run("gcrules.stage$.value")


def entities(a: Analysis, kind: str) -> set[tuple[str, str]]:
    return {(kind, "".join(e.points)) for e in a.entities if e.kind == kind}


@pytest.mark.parametrize(("name", "kind"), [("3-3.3", "plane"), ("6-3.1", "tetrahedron"), ("4-4.4", "line")])
def test_guided_path(desk: Desk, name: str, kind: str) -> None:
    """From the gallery through all steps, each beside what the library says."""
    (entry,) = (e for e in load_catalog().entries if e.id == name)
    a = gc.analyze(legs_text(entry.legs))
    desk.one("gallery-search").fill(name)
    desk.one(f"card-class-{name}").click()
    desk.answered()
    seen = []
    for stage, panel in walk(desk):
        seen.append(stage)
        assert panel.locator(".why").inner_text().strip(), "each step says what is done and why"
        if stage == "structure":
            legs = panel.locator(".bodies [data-leg]").evaluate_all("all => all.map(one => one.dataset.leg)")
            assert [leg.split() for leg in legs] == [list(leg) for leg in a.structure.oriented]
            assert desk.one("schematic").locator("[data-leg]").count() == 6
            assert name in panel.inner_text()
        elif stage == "superbracket":
            assert rows(panel) == terms(a.typed.polynomial)
        elif stage == "shortest":
            assert rows(panel) == terms(a.shortest.polynomial, a.shortest.sign)
            assert desk.text("orders").startswith("720 orders tried, each in 2 forms")
            counts = desk.one("orders").locator("[role=cell]").all_inner_texts()
            assert sum(int(n.replace(",", "")) for n in counts) == 1440
            best = desk.one("orders").locator(".best .terms").inner_text()
            assert int(best.split()[0]) == len(a.shortest.polynomial)
            desk.one("more").click()
            assert panel.locator("details.more p").first.is_visible()
        elif stage in ("tetrahedra", "planes", "lines"):
            assert rows(panel) == terms(a.shortest.polynomial, a.shortest.sign)
            one = {"tetrahedra": "tetrahedron"}.get(stage, stage[:-1])
            assert chips(panel) <= entities(a, one)
            assert chips(panel) or one != kind or stage == "lines"
        elif stage == "condition":
            assert chips(panel) <= {(e.kind, "".join(e.points)) for e in a.entities}
            whole = f"{a.structure.superbracket}={text(a.condition.right_side, unicode=True, names=a.structure.names)}"
            assert bare(whole) in formulas(panel)
            assert a.condition.certificate.detail in panel.inner_text()
        elif stage == "statement":
            assert bare(desk.text("statement")) == bare(a.condition.statement)  # in parts where it is long
        elif stage == "check":
            steps = desk.one("derivation").locator("li")
            assert steps.locator("h3").all_inner_texts() == [s.rule for s in a.derivation]
            assert steps.locator("> p").all_inner_texts() == [s.why for s in a.derivation]
    assert seen == [s for s in STAGES if s in seen]
    assert len(seen) == (10 if name != "6-3.1" else 9)
    desk.one("stage-back").click()
    desk.one(f"stage-{seen[-2]}").wait_for()
    desk.step("structure")


def test_after_the_last_step_one_goes_on_and_the_picture_can_stand_alone(desk: Desk) -> None:
    desk.open("robot", "3-rps", "statement")
    desk.one("stage-next").click()
    assert [desk.one(f"go-{panel}").inner_text().strip() for panel in ("motion", "manual", "take-away")] == [
        "Move it",
        "Try by hand",
        "Take away",
    ]
    desk.page.keyboard.press("f")
    window = desk.page.viewport_size
    assert desk.page.locator(".viewer-pane").bounding_box() == {"x": 0, "y": 0, **window}
    desk.page.keyboard.press("Escape")
    assert desk.page.locator(".viewer-pane").bounding_box()["width"] < window["width"]
    desk.one("go-motion").click()
    desk.page.wait_for_function("() => gcrules.panel$.value === 'motion'")


def test_the_paper_s_robot_of_four_freedoms(desk: Desk) -> None:
    """Joints and wrenches, the equivalent structure beside the robot, and the three tetrahedra of the paper."""
    desk.one("gallery-robots").click()
    desk.one("card-robot-gallardo-4dof").click()
    desk.answered()
    for stage in ("limbs", "equivalent"):
        desk.step(stage)
        figure = desk.one("robot-figure")
        shown = set(figure.locator("svg text").all_text_contents())
        assert {"S2", "A2", "B3"} <= {re.sub(r"\W", "", name.translate(PLAIN)) for name in shown}
    desk.one("robot-figure").click()
    assert desk.page.locator("dialog.zoom[open] svg.gc-figure").is_visible()
    desk.page.keyboard.press("Escape")
    assert desk.page.locator("dialog.zoom[open]").count() == 0
    panel = desk.step("condition")
    found = {frozenset(re.findall(r"[A-Z]\d", letters)) for kind, letters in chips(panel) if kind == "tetrahedron"}
    assert found == {frozenset(t.split()) for t in ("S1 A1 B1 C1", "S1 S3 A3 B3", "S1 S3 S2 A2")}
    robot = analyze_robot(read_robot("gallardo-4dof"))
    desk.step("statement")
    assert desk.text("statement").replace("\n", "").replace("\u200b", "") == robot.statement
    desk.slide("1", 0.2)
    desk.answered()
    assert desk.one("verdict").get_attribute("data-verdict") == "regular"


PLAIN = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")


# --- to a singular pose and back -----------------------------------------------------------------------------------


@pytest.fixture
def without_webgl(chromium: Any) -> Iterator[Any]:
    browser = chromium.browser_type.launch(
        executable_path=find_browser(), args=["--no-sandbox", "--disable-3d-apis", "--disable-gpu", "--no-first-run"]
    )
    yield browser
    browser.close()


@pytest.mark.parametrize("renderer", ["webgl", "svg"])
def test_slider_to_a_singular_pose(
    sit_down: Callable[..., Desk], request: pytest.FixtureRequest, renderer: str
) -> None:
    """350 mm down the four planes meet in a point; the page says so, names the planes, and plays the gained motion."""
    options = {"browser": request.getfixturevalue("without_webgl")} if renderer == "svg" else {}
    desk = sit_down(**options).visit().open("example", "octahedral", "statement")
    assert desk.run("gcrules.space.viewer.value.renderer") == renderer
    assert desk.one("viewer").locator("svg" if renderer == "svg" else "canvas").count()
    desk.painted()
    before = desk.place("b")[1]
    values = []
    for z in (-100, -200, -300, -340):
        desk.slide("z", z)
        desk.answered()
        assert desk.one("verdict").get_attribute("data-verdict") == "regular"
        assert desk.one("warning").count() == 0
        values.append(desk.numbers["value"])
    there = gc.pose(OCTAHEDRAL, "0 0 -340", about="centroid", nearest=False)
    assert desk.numbers["margin"] == pytest.approx(there.margin)
    assert values == sorted(values, key=abs, reverse=True)
    desk.slide("z", -350)
    desk.verdict("singular")
    assert desk.place("b")[1] > before + 10
    assert desk.text("value").strip() == "0.00000"
    first = desk.one("causes").locator("li").first.inner_text().replace("\n", "")
    assert first.startswith("The planes abc, aef, bdf and cde meet in a point")
    desk.one("warning-more").click()
    assert desk.one("motion").inner_text().startswith("The platform can ")
    assert desk.one("play-motion").get_attribute("aria-pressed") == "false"
    desk.one("play-motion").click()
    assert desk.run("gcrules.space.playing.value") is True
    desk.slide("z", -400)
    desk.answered()
    desk.verdict("regular")
    assert desk.run("gcrules.space.playing.value") is False
    assert desk.one("warning").count() == 0


def test_gizmo_to_a_singular_pose(desk: Desk) -> None:
    """The vertical arrow is dragged down; close means 5 degrees here, 25 mm, for a pixel is some millimetres."""
    desk.open("example", "octahedral")
    desk.one("threshold").fill("5 deg")
    desk.one("threshold").press("Enter")
    desk.one("view-front").click()
    desk.one("mode-translate").click()
    desk.painted()
    x, y = handles(desk)
    y -= 41  # on the arrow, in a picture of less than 480 pixels
    scale = (desk.place("c")[1] - desk.place("d")[1]) / 400  # pixels for a millimetre of height, nearly
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    down = 0.0
    while desk.pose["translation"][2] > -335 and down < 600:
        down += 50 if down < 300 else 5
        desk.page.mouse.move(x, y + down * scale)
        desk.painted()
    desk.answered()
    assert desk.one("verdict").get_attribute("data-verdict") != "regular", "it warns while the hand holds the platform"
    desk.page.mouse.up()
    desk.answered()
    tx, ty, tz = desk.pose["translation"]
    assert abs(tx) + abs(ty) < 1e-6
    assert desk.pose["quaternion"] == [1, 0, 0, 0]
    assert -372 < tz < -328
    desk.page.wait_for_selector("[data-testid=verdict][data-verdict=close], [data-verdict=singular]")
    assert desk.one("warning").is_visible()
    there = gc.pose(OCTAHEDRAL, f"0 0 {tz!r}", about="centroid", nearest=False)
    assert desk.numbers["margin"] == pytest.approx(there.margin, rel=1e-6)
    desk.one("slider-z-number").fill("-350")
    desk.one("slider-z-number").press("Enter")
    desk.verdict("singular")
    desk.one("undo").click()
    desk.answered()
    assert desk.pose["translation"][2] == pytest.approx(tz)
    desk.one("undo").click()  # the drag is one step
    desk.answered()
    assert desk.pose["translation"] == [0, 0, 0]


def handles(desk: Desk) -> tuple[float, float]:
    """Where the gizmo is: at the centroid of the platform's joints."""
    at = [desk.place(n) for n in "bdf"]
    return sum(x for x, _ in at) / 3, sum(y for _, y in at) / 3


def test_nearest_singular_pose(desk: Desk) -> None:
    desk.open("example", "octahedral")
    assert desk.text("nearest-translation").split() == ["translation", "find"]
    desk.one("nearest-translation").click()
    desk.verdict("singular")
    assert desk.pose["translation"] == pytest.approx([0, 0, -350], abs=1e-6)
    assert desk.text("nearest-translation").split() == ["translation", "350", "mm"]
    desk.page.wait_for_selector("[data-testid=way][data-length^='6']")  # sixty poses on the way, and those before
    desk.one("play-motion").click()
    desk.one("home").click()
    desk.verdict("regular")
    desk.answered()
    assert desk.pose["translation"] == [0, 0, 0]
    desk.one("tab-readings").click()
    assert desk.one("readings").is_visible()


# --- nothing is lost -----------------------------------------------------------------------------------------------


def test_reload_keeps_the_state(desk: Desk) -> None:
    desk.open("class", "6-4.1", "condition")
    desk.slide("x", 0.1)
    desk.let_go("x")
    desk.answered()
    pose, value = desk.pose, desk.text("value")
    same = 0
    while same < 10:  # until the address has it: what a reload in that third of a second leaves is the browser's
        before = desk.page.url
        desk.page.wait_for_timeout(100)
        same = same + 1 if desk.page.url == before and "#" in before else 0
    desk.page.reload()
    desk.page.wait_for_function("() => window.gcrules")
    desk.answered()
    desk.one("stage-condition").wait_for()
    assert desk.pose == pose
    assert desk.text("value") == value
    assert "token" not in desk.page.url


def test_two_tabs(sit_down: Callable[..., Desk], server: Server) -> None:
    first = sit_down().visit().open("example", "octahedral", "planes")
    second = Desk(first.page.context.new_page(), server).visit().open("class", "6-3.1", "check")
    second.slide("y", 0.2)
    second.answered()
    first.page.bring_to_front()
    first.slide("z", -50)
    first.answered()
    assert first.study["title"] != second.study["title"]
    assert first.pose["translation"] == [0, 0, -50]
    assert second.pose["translation"] == [0, 0.2, 0]
    assert first.one("stage-planes").is_visible()
    assert second.away() == second.faults == []


def test_server_restarts(sit_down: Callable[..., Desk], tmp_path: Path) -> None:
    """The page says calmly that the server is away, keeps the pose, and goes on by itself."""
    with studio(tmp_path) as own:
        desk = sit_down(own=own).visit().open("example", "octahedral")
        desk.slide("z", -40)
        desk.answered()
        own.stop()
        desk.page.wait_for_selector("[data-testid=line][data-line=lost]")
        assert "Your work is safe" in desk.text("line")
        desk.slide("z", -120)
        own.start()
        desk.page.wait_for_selector("[data-testid=line][data-line=open]", state="attached")
        desk.answered()
        there = gc.pose(OCTAHEDRAL, "0 0 -120", about="centroid", nearest=False)
        assert desk.numbers["margin"] == pytest.approx(there.margin)
        desk.slide("z", -130)
        desk.answered()
        desk.page.close()
        desk.faults[:] = [fault for fault in desk.faults if "ws://" not in fault]  # attempts while it was away


def test_undo_and_redo(desk: Desk) -> None:
    desk.open("example", "octahedral")
    for name, amounts in (("x", (5, 10, 20)), ("rz", (10, 30))):
        for amount in amounts:
            desk.slide(name, amount)
        desk.let_go(name)
    desk.answered()
    moved = desk.pose
    desk.one("undo").click()
    assert desk.pose["translation"] == [20, 0, 0]
    assert desk.pose["quaternion"] == [1, 0, 0, 0]
    desk.page.keyboard.press("Control+z")
    assert desk.pose["translation"] == [0, 0, 0]
    desk.page.keyboard.press("Control+Shift+z")
    desk.one("redo").click()
    assert desk.pose == moved
    assert desk.one("redo").is_disabled()
    desk.answered()


# --- pointing, letters, keys ---------------------------------------------------------------------------------------


def test_pointing_lights_up_everywhere(desk: Desk) -> None:
    """A bracket, in the other monomials and in 3D; a plane, in the formulas; a joint, in the schematic."""
    desk.open("example", "octahedral", "planes")
    table = desk.one("monomials")
    dark = desk.run("gcrules.space.viewer.value.snapshot('svg')")
    a = gc.analyze(OCTAHEDRAL)
    desk.one("stage-planes").get_by_test_id("entity-e0").hover()
    points = set(desk.study["entities"][0]["points"])
    lit = table.locator(".bracket:has(.letter.lit)").evaluate_all("all => all.map(one => one.dataset.bracket)")
    assert len(lit) == len(a.shortest.polynomial), "the plane stands in every monomial"
    assert all(points <= set(bracket.split()) for bracket in lit)
    assert desk.run("gcrules.space.viewer.value.snapshot('svg')") != dark
    bracket = table.locator("[data-bracket]").first
    bracket.hover()
    names = bracket.get_attribute("data-bracket").split()
    assert desk.run("gcrules.lit.current.value.points") == names
    desk.page.mouse.move(2, 2)
    assert table.locator(".lit").count() == 0
    assert desk.run("gcrules.space.viewer.value.snapshot('svg')") == dark
    desk.step("structure")
    desk.page.locator(".bodies [data-point=b]").hover()
    assert "lit" in desk.one("schematic").locator("[data-point=b]").get_attribute("class")
    assert desk.run("gcrules.space.viewer.value.snapshot('svg')") != dark
    desk.page.mouse.move(*desk.place("a"))
    desk.page.wait_for_function("() => gcrules.lit.current.value?.points.join() === 'a'")
    assert "lit" in desk.one("schematic").locator("[data-point=a]").get_attribute("class")


def test_formulas_need_no_font_of_the_system(desk: Desk) -> None:
    """Each letter of a formula comes from a font of the bundle; what Chromium used for a node is asked of it."""
    desk.open("robot", "gallardo-4dof", "condition")
    desk.page.wait_for_function("() => document.fonts.status === 'loaded'")
    families = desk.run("[...document.fonts].filter(f => f.status === 'loaded').map(f => f.family)")
    assert {"KaTeX_Math", "KaTeX_Main"} <= set(families)
    tools = desk.page.context.new_cdp_session(desk.page)
    tools.send("DOM.enable")
    tools.send("CSS.enable")
    root = tools.send("DOM.getDocument", {"depth": 0})["root"]["nodeId"]
    letters = tools.send(
        "DOM.querySelectorAll", {"nodeId": root, "selector": ".katex .mord, .katex .mbin, .katex .mopen, i.pt"}
    )["nodeIds"]
    assert len(letters) > 30
    used = [f for n in letters for f in tools.send("CSS.getPlatformFontsForNode", {"nodeId": n})["fonts"]]
    assert used
    assert {f["familyName"] for f in used if not f["isCustomFont"]} == set()
    assert sum("/fonts/KaTeX_" in url for url in desk.requests) >= 2


def test_keys_are_enough(desk: Desk) -> None:
    """By the keyboard alone to a step, to a slider, and along it."""
    desk.open("example", "octahedral")
    desk.one("step-structure").focus()
    desk.page.keyboard.press("ArrowDown")
    desk.one("stage-superbracket").wait_for()
    desk.page.wait_for_function("() => document.activeElement?.dataset.testid === 'step-superbracket'")
    reached = []
    for _ in range(60):
        desk.page.keyboard.press("Tab")
        reached.append(desk.run("document.activeElement?.dataset.testid ?? document.activeElement?.className ?? ''"))
        if reached[-1] == "slider-z":
            break
    assert reached[-1] == "slider-z", reached
    assert {"stage-next", "mode-translate", "view-top", "epsilon", "slider-x"} <= set(reached)
    focused = desk.one("slider-z").screenshot()
    desk.one("slider-z").evaluate("slider => slider.blur()")
    assert desk.one("slider-z").screenshot() != focused, "the focus is seen"
    desk.one("slider-z-number").focus()
    desk.page.keyboard.press("Shift+Tab")
    before = desk.numbers["value"]
    for _ in range(3):
        desk.page.keyboard.press("ArrowLeft")
    desk.answered()
    assert desk.pose["translation"][2] == pytest.approx(-3 * desk.study["axes"][2]["step"])
    assert desk.numbers["value"] != before
    desk.page.keyboard.press("Tab")
    assert desk.run("document.activeElement.dataset.testid") == "slider-z-number"
    desk.page.keyboard.press("Control+a")
    desk.page.keyboard.type("-350")
    desk.page.keyboard.press("Enter")
    desk.verdict("singular")


NAMELESS = """() => {
  const shown = e => e.checkVisibility({visibilityProperty: true});
  const words = ids => ids.split(" ").map(id => document.getElementById(id)?.textContent ?? "").join(" ");
  const name = e => e.getAttribute("aria-label") || words(e.getAttribute("aria-labelledby") ?? "").trim()
    || [...(e.labels ?? [])].map(l => l.textContent).join(" ").trim() || e.textContent.trim() || e.title || "";
  const all = [...document.querySelectorAll(
    "button, input, select, textarea, a[href], summary, [role=button], [role=tab], [role=slider], [role=separator]")];
  const ids = [...document.querySelectorAll("[id]")].map(e => e.id);
  return [
    ...all.filter(e => shown(e) && !name(e)).map(e => "no name: " + e.outerHTML.slice(0, 160)),
    ...[...document.querySelectorAll("img:not([alt]):not([aria-hidden=true])")].map(e => "no alt: " + e.outerHTML),
    ...[...document.querySelectorAll("[role=tab]")].filter(e => !e.closest("[role=tablist]")).map(() => "a tab alone"),
    ...ids.filter((id, i) => ids.indexOf(id) !== i).map(id => "two of id " + id),
    ...[...document.querySelectorAll("[aria-hidden=true]")].flatMap(e =>
      [...e.querySelectorAll("button, input, select, a[href], [tabindex='0']")].map(f => "hidden, yet reached: "
        + f.outerHTML.slice(0, 160))),
    ...(document.documentElement.lang ? [] : ["no language"]),
  ]; }"""
"""What a screen reader could not name."""

TOO_WIDE = """() => { const width = document.documentElement.clientWidth;
  const kinds = "main, section, aside, header, nav, button, table, figure, form, input";
  const overflowing = [...document.querySelectorAll(kinds)].filter(e => e.checkVisibility({visibilityProperty: true})
      && e.getBoundingClientRect().right > width + 1
      && !e.closest("[style*=overflow], .formula, .monomials, .scroller"));
  return [...(document.documentElement.scrollWidth > width ? ["the page"] : []),
    ...overflowing.slice(0, 5).map(e => e.outerHTML.slice(0, 120))]; }"""
"""What leaves the page at its right side."""

PANELS = ["manual", "bench", "draw", "take-away"]


PICTURES = bool(os.environ.get("GCRULES_STUDIO_PICTURES"))
LOOKS = [(WIDE, "light"), (TABLET, "dark"), *([(WIDE, "dark"), (TABLET, "light")] if PICTURES else [])]


@pytest.mark.parametrize(("size", "scheme"), LOOKS, ids=[f"{size['width']}-{scheme}" for size, scheme in LOOKS])
def test_every_view_has_names_and_fits(sit_down: Callable[..., Desk], size: dict[str, int], scheme: str) -> None:
    desk = sit_down(viewport=size, color_scheme=scheme).visit()
    found: list[str] = []

    def look(view: str) -> None:
        found.extend(f"{view}: {fault}" for script in (NAMELESS, TOO_WIDE) for fault in desk.run(script))
        if PICTURES:
            folder = ROOT / "build" / "studio-pictures"
            folder.mkdir(parents=True, exist_ok=True)
            desk.page.wait_for_timeout(300)
            desk.page.screenshot(path=folder / f"{size['width']}-{scheme}-{view}.png")

    desk.page.wait_for_selector(".card svg")
    look("start")
    desk.open("example", "octahedral")
    for stage in STAGES:
        desk.step(stage)
        look(stage)
    desk.slide("z", -350)
    desk.verdict("singular")
    desk.one("warning-more").click()
    desk.one("tab-readings").click()
    look("singular")
    for panel in PANELS:
        desk.one(f"panel-{panel}").click()
        desk.painted()
        look(panel)
    for name in ("gallardo-4dof", *(("3-rps", "delta") if PICTURES else ())):
        desk.open("robot", name)
        for stage in ("limbs", "equivalent", "condition", "statement"):
            desk.step(stage)
            look(f"{name}-{stage}")
    desk.step("equivalent")
    desk.one("robot-figure").click()
    look("figure")
    assert found == []
