"""The 3D viewer, alone and in the report, in a browser from file://."""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Iterator
from operator import mul
from pathlib import Path
from typing import Any

import pytest
from places import ROOT
from views.shown_pages import Open, Shown, open_from_file
from views.viewed_structures import OCTAHEDRAL, STRUCTURES

import gcrules as gc
from gcrules.conditions.pose_value import judged, measure
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.load import read_robot
from gcrules.screws.pose_text import parse_pose
from gcrules.views.drawing.palette import ROLES
from gcrules.views.report.report_page import in_script
from gcrules.views.report.robot_report import robot_scene
from gcrules.views.report.scene_json import Scenery, scene
from gcrules.views.viewer import viewer_script

EXAMPLES = ROOT / "examples"
POSES = [
    None,
    {"translation": [30.0, -10.0, 25.0], "quaternion": [math.cos(0.2), 0.0, 0.0, math.sin(0.2)]},
    {"translation": [-0.1, 0.2, 0.05], "quaternion": [0.9, 0.3, -0.2, 0.1]},
]
OTHER = gc.analyze("Aa Ab Ba Bb Cc Dd")


# --- in a browser --------------------------------------------------------------------------------------------------


@pytest.fixture
def open_page(chromium: Any, tmp_path: Path) -> Iterator[Open]:
    contexts = []

    def opened(text: str, **options: Any) -> Shown:
        shown = open_from_file(chromium, tmp_path / "page.html", text, **options)
        contexts.append(shown.page.context)
        return shown

    yield opened
    for context in contexts:
        context.close()


@pytest.fixture(scope="module")
def bare(chromium: Any, tmp_path_factory: pytest.TempPathFactory) -> Shown:
    """A page with nothing but the viewer's script and a place for it; what a viewer reports is collected in `log`."""
    code = viewer_script()
    page = (
        "<!doctype html><meta charset=utf-8><style>body{margin:0}#v{width:900px;height:640px}</style><div id=v></div>"
        f"<script>{code}</script><script>let log = [], viewer; function start(renderer, scene) {{ log = [];"
        "viewer?.dispose(); viewer = GcrulesViewer.createViewer(document.getElementById('v'), {renderer,"
        "onPose: (p, done) => log.push({...p, done}), onPick: n => log.push(n), onHover: h => window.under = h});"
        "viewer.show(scene); }</script>"
    )
    return open_from_file(chromium, tmp_path_factory.mktemp("viewer") / "page.html", page)


@pytest.fixture
def view(bare: Shown) -> Iterator[Open]:
    """A new viewer with a scene."""

    def shown(data: dict[str, Any], renderer: str = "auto") -> Shown:
        bare.page.mouse.move(1, 1)
        bare.run(f"start('{renderer}', {in_script(data)})")
        bare.settled()
        return bare

    yield shown
    assert bare.faults == []
    assert bare.requests == []


RENDERERS = pytest.mark.parametrize("renderer", ["auto", "svg"])


@pytest.mark.browser
@RENDERERS
def test_points_are_where_they_are_seen_from(view: Open, renderer: str) -> None:
    data = scene(OCTAHEDRAL)
    shown = view(data, renderer)
    assert shown.run("viewer.renderer") == ("webgl" if renderer == "auto" else "svg")
    for side, (right, up) in {"top": (0, 1), "front": (0, 2), "side": (1, 2)}.items():
        shown.run(f"viewer.setView('{side}')")
        at = {n: shown.place(n) for n in "abcdef"}
        for p in "abcdef":
            assert 0 < at[p][0] < 900
            assert 0 < at[p][1] < 640
        for names in ("ace", "bdf"):  # in one body, of which perspective changes little
            for p in names:
                for q in names:
                    if data["points"][p][right] - data["points"][q][right] > 90:
                        assert at[p][0] > at[q][0], (side, p, q)
                    if data["points"][p][up] - data["points"][q][up] > 90:
                        assert at[p][1] < at[q][1], (side, p, q)
    assert shown.run("viewer.toScreen('zz')") is None


@pytest.mark.browser
def test_a_picture_that_grows_is_fitted_until_a_view_is_chosen(view: Open) -> None:
    """As in a frame that is laid out after its report has begun."""
    shown = view(scene(OCTAHEDRAL))

    def widened(*widths: int) -> dict[str, Any]:
        for width in widths:
            shown.run(f"document.getElementById('v').style.width = '{width}px', 0")
            shown.settled()
        return {n: shown.run(f"viewer.toScreen('{n}')") for n in "abcdef"}

    try:
        narrow, wide = (
            max(y for _, y in widened(w).values()) - min(y for _, y in widened(w).values()) for w in (90, 900)
        )
        assert wide > 3 * narrow
        shown.run("viewer.setView('top'), 0")
        shown.settled()
        assert widened(900) == widened(90, 900)
    finally:
        widened(900)


@pytest.mark.browser
def test_a_fit_leaves_free_what_the_host_covers(bare: Shown) -> None:
    data = scene(OCTAHEDRAL)
    tall = {**data, "points": {name: [x, y, 6 * z] for name, (x, y, z) in data["points"].items()}}
    top = {}
    for covered in (0, 120):
        bare.run(
            "viewer?.dispose(), viewer = GcrulesViewer.createViewer(document.getElementById('v'),"
            f"{{ covered: () => [{covered}, 0] }}), viewer.show({in_script(tall)}), viewer.setView('front'), 0"
        )
        bare.settled()
        top[covered] = min(bare.place(name)[1] for name in "abcdef")
    assert top[0] < 120 < top[120]


@pytest.mark.browser
@RENDERERS
def test_the_drawing_is_seen(view: Open, renderer: str) -> None:
    """At a joint of the base the picture has its colour."""
    shown = view(scene(OCTAHEDRAL), renderer)
    png = shown.page.screenshot()
    x, y = shown.place("a")
    pixel = shown.page.evaluate(
        """async ([png, x, y]) => { const image = new Image(); image.src = 'data:image/png;base64,' + png;
        await image.decode(); const pen = document.createElement('canvas').getContext('2d');
        pen.canvas.width = 900; pen.canvas.height = 640; pen.drawImage(image, 0, 0);
        return [...pen.getImageData(Math.round(x), Math.round(y), 1, 1).data]; }""",
        [base64.b64encode(png).decode(), x, y],
    )
    assert max(pixel[:3]) < 120


@pytest.mark.browser
@RENDERERS
def test_handles_shift_the_platform(view: Open, renderer: str) -> None:
    shown = view(scene(OCTAHEDRAL), renderer)
    shown.run("viewer.setView('front'); viewer.setMode('translate')")
    shown.settled()
    before = {n: shown.place(n) for n in "abcdef"}
    x, y = _middle(shown)
    _drag(shown, (x, y - 55), (x, y - 135))  # along the blue arrow
    poses = shown.run("log")
    assert [p["done"] for p in poses][-1] is True
    tx, ty, tz = poses[-1]["translation"]
    assert tz > 30
    assert abs(tx) + abs(ty) < 1e-6 * tz
    assert poses[-1]["quaternion"] == [1, 0, 0, 0]
    shown.settled()
    assert all(shown.place(n) == pytest.approx(before[n], abs=1e-6) for n in "ace")
    assert all(before[n][1] - shown.place(n)[1] > 40 for n in "bdf")


@pytest.mark.browser
@RENDERERS
def test_handles_turn_the_platform(view: Open, renderer: str) -> None:
    shown = view(scene(OCTAHEDRAL), renderer)
    shown.run("viewer.setView('top'); viewer.setMode('rotate')")
    shown.settled()
    before = {n: shown.place(n) for n in "abcdef"}
    x, y = _middle(shown)
    at = RING / math.sqrt(2)  # of the ring about z, seen from the top; the others are seen from their sides
    _drag(shown, (x + at, y - at), (x - at / 3, y - 1.4 * at))
    last = shown.run("log")[-1]
    w, qx, qy, qz = last["quaternion"]
    assert abs(qz) > 0.1
    assert math.hypot(qx, qy) < 0.02
    assert math.hypot(w, qx, qy, qz) == pytest.approx(1)
    assert last["translation"] == pytest.approx([0, 0, 0], abs=1e-6)
    shown.settled()
    assert all(shown.place(n) == pytest.approx(before[n], abs=1e-6) for n in "ace")
    assert all(math.dist(shown.place(n), before[n]) > 5 for n in "bdf")


RING = 76
"""Half the width of the ring in pixels: it does not depend on the robot."""


def _middle(shown: Shown) -> tuple[float, float]:
    """Where the handles are: at the centroid of the platform's joints."""
    box = shown.page.locator("#v").bounding_box()
    at = [shown.place(n) for n in "bdf"]
    return box["x"] + sum(x for x, _ in at) / 3, box["y"] + sum(y for _, y in at) / 3


def _drag(shown: Shown, start: tuple[float, float], end: tuple[float, float]) -> None:
    shown.page.mouse.move(*start)
    shown.page.mouse.down()
    for k in range(1, 6):
        shown.page.mouse.move(*(s + (e - s) * k / 5 for s, e in zip(start, end, strict=True)))
    shown.settled()
    shown.page.mouse.up()


@pytest.mark.browser
@RENDERERS
def test_picking_is_tolerant_and_hides_the_handles(view: Open, renderer: str) -> None:
    shown = view(scene(OCTAHEDRAL), renderer)
    shown.run("viewer.setMode('translate')")
    shown.run("viewer.setMode('pick')")
    shown.settled()
    for name in "abf":
        x, y = shown.place(name)
        shown.page.mouse.click(x + 7, y - 6)
    assert shown.run("log") == ["a", "b", "f"]
    shown.page.mouse.click(5, 5)
    assert shown.run("log.length") == 3


@pytest.mark.browser
@RENDERERS
def test_keys_move_and_pick(view: Open, renderer: str) -> None:
    data = scene(OCTAHEDRAL)
    shown = view(data, renderer)
    surface = shown.page.get_by_role("application")
    surface.focus()
    for key in ("ArrowRight", "PageUp", "PageUp", "Shift+ArrowLeft"):
        shown.page.keyboard.press(key)
    pose = shown.run("viewer.pose")
    step = data["size"] / 100
    assert pose["translation"] == pytest.approx([step, 0, 2 * step])
    assert 2 * math.degrees(math.asin(pose["quaternion"][3])) == pytest.approx(2)
    shown.page.wait_for_function("log.length && log.at(-1).done")
    assert "turned by 2 degrees" in shown.page.locator("[aria-live]").inner_text()
    shown.run("viewer.setMode('pick')")
    for key in ("ArrowRight", "ArrowRight", "Enter"):
        shown.page.keyboard.press(key)
    assert shown.run("log.at(-1)") == "c"


@pytest.mark.browser
@RENDERERS
def test_pictures(view: Open, renderer: str) -> None:
    shown = view(scene(STRUCTURES["octahedral-singular"]), renderer)
    shown.run("viewer.setMode('translate'); viewer.setTheme('dark')")
    png = base64.b64decode(shown.run("viewer.snapshot('png')").removeprefix("data:image/png;base64,"))
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert (int.from_bytes(png[16:20]), int.from_bytes(png[20:24])) == (1800, 1280)
    assert len(png) > 20_000
    svg = shown.run("viewer.snapshot('svg')")
    assert svg.startswith("<svg")
    assert svg.count("<circle") == 7  # six joints and the common point
    assert ROLES["entity1"][1] in svg
    assert ">M<" in svg


@pytest.mark.browser
def test_highlights_and_layers_change_the_drawing(view: Open) -> None:
    shown = view(scene(OCTAHEDRAL), "svg")
    plain = shown.run("viewer.snapshot('svg')")
    mark = ROLES["mark"][0]
    assert mark not in plain
    assert mark in shown.run("(viewer.highlight({points: ['a']}), viewer.snapshot('svg'))")
    entity = shown.run("(viewer.highlight({entities: ['e0']}), viewer.snapshot('svg'))")
    assert 'fill-opacity="0.43"' in entity  # the one
    assert 'fill-opacity="0.08"' in entity  # the others
    assert mark in shown.run("(viewer.highlight({legs: [['b', 'a']]}), viewer.snapshot('svg'))")
    assert shown.run("(viewer.highlight(null), viewer.snapshot('svg'))") == plain
    for layer, sign in {"labels": ">a<", "entities": ROLES["entity1"][0], "legs": ROLES["leg"][0]}.items():
        assert sign in plain
        assert sign not in shown.run(f"(viewer.setVisible('{layer}', false), viewer.snapshot('svg'))")
        assert shown.run(f"(viewer.setVisible('{layer}', true), viewer.snapshot('svg'))") == plain


DIFFERENCE = """async ([one, other]) => {
  const pixels = async url => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const pen = document.createElement("canvas").getContext("2d");
    [pen.canvas.width, pen.canvas.height] = [450, 320];
    pen.drawImage(image, 0, 0, 450, 320);
    return pen.getImageData(0, 0, 450, 320).data;
  };
  const [a, b] = [await pixels(one), await pixels(other)];
  const far = (x, i, y, j) => Math.max(...[0, 1, 2].map(k => Math.abs(x[i + k] - y[j + k])));
  const flat = (x, i) => [-4, 4, -1800, 1800].every(step => far(x, i, x, i + step) < 3);
  let [apart, drawn] = [0, 0];
  for (let i = 1800; i < a.length - 1800; i += 4) {
    if (far(a, i, [255, 255, 255], 0) < 8 || !flat(a, i) || !flat(b, i)) continue;
    drawn++;
    if (far(a, i, b, i) > 5) apart++;
  }
  return [apart / drawn, drawn / (450 * 320)];
}"""
"""Of the pixels inside of areas, the share that has another colour in another drawing; and how many there are."""


@pytest.mark.browser
@pytest.mark.parametrize("name", ["octahedral", "octahedral-singular", "four-dof"])
def test_both_renderers_paint_the_same(view: Open, name: str) -> None:
    """Areas that intersect too: WebGL sorts triangles, SVG is painted from back to front."""
    pictures = []
    for renderer in ("auto", "svg"):
        shown = view(scene(STRUCTURES[name]), renderer)
        for layer in ("labels", "legs", "grid", "motion"):
            shown.run(f"viewer.setVisible('{layer}', false)")
        pictures.append(shown.run("viewer.snapshot('png')"))
    apart, drawn = shown.page.evaluate(DIFFERENCE, pictures)
    assert drawn > 0.05
    assert apart < 0.01


@pytest.mark.browser
def test_areas_that_intersect_are_split(view: Open) -> None:
    """No polygon of the picture is one of the six areas that cross each other."""
    shown = view(scene(STRUCTURES["octahedral-singular"]), "svg")
    assert shown.run("viewer.snapshot('svg')").count("<polygon") > 12


@pytest.mark.browser
@pytest.mark.parametrize("name", STRUCTURES)
def test_labels_keep_clear_of_each_other(view: Open, name: str) -> None:
    shown = view(scene(STRUCTURES[name]))
    boxes = shown.run(
        """[...document.querySelectorAll(".gcrules-viewer [aria-hidden] > span:not([hidden])")].map(e => {
        const b = e.getBoundingClientRect(); return [e.textContent, b.left, b.top, b.right, b.bottom]; })"""
    )
    names = [box[0] for box in boxes]
    assert set(STRUCTURES[name].structure.names) <= set(names)
    for i, (_, *a) in enumerate(boxes):
        assert 0 <= a[0] < a[2] <= 900
        for _, *b in boxes[:i]:
            width, height = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            smaller = min((c[2] - c[0]) * (c[3] - c[1]) for c in (a, b))
            assert max(width, 0) * max(height, 0) < 0.2 * smaller


@pytest.mark.browser
def test_euler_angles_are_those_of_the_engine(view: Open) -> None:
    shown = view(scene(OCTAHEDRAL))
    for angles in ([30, 10, -20], [-170, 80, 5], [0, 0, 0], [12, -60, 179]):
        quaternion = shown.run(f"GcrulesViewer.fromEuler({angles})")
        there = parse_pose(f"0 0 0; euler ZYX {' '.join(map(str, angles))} deg").unit_quaternion
        assert abs(sum(map(mul, quaternion, there))) == pytest.approx(1, abs=1e-12)
        assert shown.run(f"GcrulesViewer.eulerAngles({quaternion})") == pytest.approx(angles, abs=1e-9)


@pytest.mark.browser
@RENDERERS
def test_what_is_pointed_at_is_told_and_marked(view: Open, renderer: str) -> None:
    shown = view(scene(OCTAHEDRAL), renderer)
    x, y = shown.place("a")
    shown.page.mouse.move(x + 5, y + 5)
    assert shown.run("window.under") == {"point": "a"}
    assert ROLES["mark"][0] in shown.run("viewer.snapshot('svg')")
    b, c = shown.place("b"), shown.place("c")
    shown.page.mouse.move(*((2 * p + q + r) / 4 for p, q, r in zip((x, y), b, c, strict=True)))
    assert shown.run("window.under") == {"entity": "e0"}  # the plane abc
    shown.page.mouse.move(3, 3)
    assert shown.run("window.under") is None
    assert ROLES["mark"][0] not in shown.run("viewer.snapshot('svg')")


@pytest.mark.browser
@RENDERERS
def test_limbs_with_their_wrenches(view: Open, renderer: str) -> None:
    data = robot_scene(analyze_robot(read_robot("3-rps")))
    shown = view(data, renderer)
    assert [limb["name"] for limb in data["limbs"]] == ["leg 1", "leg 2", "leg 3"]
    assert {frozenset(p["label"]) for p in data["planes"]} == {frozenset(f"r{i}A{i}S{i}") for i in (1, 2, 3)}
    for p in data["planes"]:
        assert all(sum(map(mul, p["normal"], c)) == pytest.approx(p["offset"], abs=1e-9) for c in p["through"])
    assert shown.page.locator("[aria-hidden] > span").get_by_text("A1S1", exact=True).count() == 1
    svg = shown.run("viewer.snapshot('svg')")
    assert ROLES["entity3"][0] in svg
    bare = shown.run("(viewer.setVisible('wrenches', false), viewer.snapshot('svg'))")
    assert len(bare) < 0.8 * len(svg)


@pytest.mark.browser
def test_the_gained_motion_swings(view: Open) -> None:
    """Not with reduced motion, where the platform stands still at the end of its swing."""
    shown = view(scene(STRUCTURES["octahedral-singular"]), "svg")
    still = shown.run("viewer.snapshot('svg')")
    shown.run("viewer.animateMotion(true)")
    shown.settled()
    end = shown.run("viewer.snapshot('svg')")
    assert end != still
    shown.settled()
    assert shown.run("viewer.snapshot('svg')") == end
    shown.page.emulate_media(reduced_motion="no-preference")
    shown.run("viewer.animateMotion(true)")
    shown.page.wait_for_timeout(100)
    moving = {shown.run("viewer.snapshot('svg')") for _ in range(3) if not shown.settled()}
    shown.page.emulate_media(reduced_motion="reduce")
    assert len(moving) == 3


@pytest.mark.browser
def test_nothing_is_drawn_while_nothing_changes(view: Open) -> None:
    shown = view(scene(OCTAHEDRAL))
    shown.run("viewer.setView('top')")
    shown.page.wait_for_timeout(200)
    asked = """() => { let count = 0; const own = window.requestAnimationFrame;
        window.requestAnimationFrame = act => { count++; return own(act); };
        return new Promise(done => setTimeout(() => { window.requestAnimationFrame = own; done(count); }, 150)); }"""
    assert shown.run(asked) == 0


@pytest.mark.browser
@RENDERERS
def test_an_empty_view_waits_for_its_scene(view: Open, renderer: str) -> None:
    nothing = {"points": {}, "base": [], "platform": [], "legs": [], "about": [0, 0, 0], "size": 1, "unit": ""}
    shown = view(nothing | {"entities": []}, renderer)
    shown.run(f"viewer.show({in_script(scene(OCTAHEDRAL))})")
    shown.settled()
    assert all(0 < c < 900 for c in shown.place("a"))


@pytest.mark.browser
def test_an_answer_for_an_older_pose_does_not_pull_the_platform_back(view: Open) -> None:
    data = scene(OCTAHEDRAL)
    shown = view(data)
    older = {"translation": [0, 0, 10], "quaternion": [1, 0, 0, 0]}
    newer = {"translation": [0, 0, 50], "quaternion": [1, 0, 0, 0]}
    points = Scenery.of(OCTAHEDRAL).points(older)
    found = shown.run(
        f"(viewer.setPose({json.dumps(newer)}), viewer.update({json.dumps({'points': points, 'pose': older})}),"
        " viewer.points())"
    )
    assert found["b"] == pytest.approx([c + d for c, d in zip(data["points"]["b"], (0, 0, 50), strict=True)])
    assert found["a"] == pytest.approx(data["points"]["a"])


@pytest.mark.browser
def test_numbers_without_a_server_are_those_of_the_engine(view: Open) -> None:
    shown = view(scene(OCTAHEDRAL))
    for a in (*STRUCTURES.values(), OTHER):
        s = Scenery.of(a)
        for pose in POSES:
            data = s.at(pose)
            found = shown.run(f"GcrulesViewer.numbersAt({in_script({**data, 'recipe': s.recipe})})")
            sigma = measure(a.structure, s.points(pose))
            assert found["margin"] == pytest.approx(sigma, rel=1e-9, abs=1e-12)
            assert found["verdict"] == judged(a.structure, s.points(pose))[1]
            exact = gc.evaluate(a.structure.superbracket, {n: (*p, 1.0) for n, p in data["points"].items()})
            assert found["superbracket"] == pytest.approx(exact, rel=1e-6, abs=1e-9 * data["size"] ** 9)
            assert [c["label"] for c in found["constructed"]] == [c["label"] for c in data["constructed"]]
            for mine, theirs in zip(found["constructed"], data["constructed"], strict=True):
                assert mine["at"] == pytest.approx(theirs["at"], rel=1e-6, abs=1e-6 * data["size"])
            assert (found["motion"] is None) == (data["motion"] is None)
            if data["motion"] and data["motion"]["pitch"] is not None:
                assert abs(found["motion"]["pitch"]) == pytest.approx(abs(data["motion"]["pitch"]), rel=1e-5)


MODEL = """async ([code, scene]) => {
  const { default: widget } = await import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
  const traits = { scene, pose: { translation: [0, 0, 0], quaternion: [1, 0, 0, 0] } };
  const heard = {};
  window.saved = [];
  window.kernel = pose => { traits.pose = pose; heard["change:pose"](); };
  const model = {
    get: name => traits[name],
    set: (name, value) => { traits[name] = value; },
    save_changes: () => saved.push(JSON.parse(JSON.stringify(traits.pose))),
    on: (event, act) => { heard[event] = act; },
    off: event => { delete heard[event]; },
  };
  const el = document.createElement("div");
  document.body.append(el);
  window.stop = widget.render({ model, el });
}"""
"""What a notebook does with a widget."""


@pytest.mark.browser
def test_the_widget_in_a_page(open_page: Open) -> None:
    shown = open_page("<!doctype html><meta charset=utf-8><title>cell</title>")
    code = str(pytest.importorskip("gcrules.apps.notebook.widget").RobotWidget._esm)
    shown.page.evaluate(MODEL, [code, scene(OCTAHEDRAL)])
    assert shown.page.locator(".gcx-unit").all_inner_texts() == [*["mm"] * 3, *["°"] * 3]
    slider = shown.page.get_by_role("slider", name="shift along z")
    slider.evaluate("e => { e.value = 40; e.dispatchEvent(new Event('input')); }")
    shown.page.wait_for_function("saved.length")
    (pose,) = shown.run("saved")
    assert pose == {"translation": [0, 0, pytest.approx(40)], "quaternion": [1, 0, 0, 0]}
    shown.run("kernel({translation: [0, 0, -25], quaternion: [1, 0, 0, 0]})")
    assert float(slider.input_value()) == pytest.approx(-25)
    assert shown.run("saved.length") == 1  # what the kernel says is not sent back
    shown.run("stop()")
    assert shown.page.locator(".gcrules-viewer").count() == 0
    assert shown.faults == []


HALVING = """slider => {
  const value = degrees => {
    slider.value = degrees;
    slider.dispatchEvent(new Event("input"));
    return robot.numbers.superbracket;
  };
  let [low, high] = [0, 10];
  while (value(low) * value(high) > 0) [low, high] = [high, high + 10];
  const sign = Math.sign(value(low));
  for (let k = 0; k < 50; k++) {
    const middle = (low + high) / 2;
    if (value(middle) * sign > 0) low = middle;
    else high = middle;
  }
  return robot.numbers.margin;
}"""
"""Moves a slider to where the superbracket changes its sign."""


# --- the report in a browser ---------------------------------------------------------------------------------------


@pytest.mark.browser
def test_what_is_0_within_rounding_is_shown_as_0(open_page: Open) -> None:
    """In a pose whose superbracket is exactly 0 the figure that moves has 2e-18 for σ, in floats."""
    shown = open_page(gc.report(EXAMPLES / "octahedral-singular.yaml"))
    assert "within rounding" in shown.page.get_by_role("status").inner_text()
    assert shown.page.locator(".gcx-numbers dd").all_inner_texts()[:2] == ["0, within rounding"] * 2
    assert shown.run("robot.numbers.margin") < 1e-12


@pytest.mark.browser
@RENDERERS
def test_the_report_moves_the_platform_to_a_singular_pose(open_page: Open, renderer: str) -> None:
    """The octahedral platform turned about z: between two poses where the planes meet in no point there is one where
    they do. No request leaves the page.
    """
    page = gc.report(OCTAHEDRAL)
    if renderer == "svg":
        page = page.replace("<head>", "<head><script>HTMLCanvasElement.prototype.getContext = () => null</script>")
    shown = open_page(page, color_scheme="dark")
    assert shown.run("robot.viewer.renderer") == ("webgl" if renderer == "auto" else "svg")
    verdict = shown.page.get_by_role("status")
    assert verdict.inner_text().startswith("Regular")
    slider = shown.page.get_by_role("slider", name="turn about z")
    assert slider.evaluate(HALVING) < 1e-6
    assert verdict.inner_text().startswith("Warning")
    assert shown.run("robot.numbers.constructed.length") == 1
    shown.page.get_by_role("checkbox").check()
    assert "the platform can" in shown.page.locator(".gcx-numbers").inner_text()
    shown.page.get_by_role("button", name="Home").click()
    assert verdict.inner_text().startswith("Regular")
    assert shown.requests == []
    assert shown.faults == []


@pytest.mark.browser
@pytest.mark.parametrize(
    "legs", ["Aa Ab Ba Bb Cc Dd", "3-rps", "ab bc ca ad be cf"], ids=["sample", "robot", "triangle"]
)
def test_other_reports_come_to_life(open_page: Open, legs: str) -> None:
    a = gc.analyze(legs) if " " in legs else analyze_robot(read_robot(legs))
    shown = open_page(gc.report(a))
    assert shown.page.locator(".live .gcrules-viewer").is_visible()
    shown.page.emulate_media(media="print")
    assert not shown.page.locator(".live .gcrules-viewer").is_visible()
    assert shown.page.locator(".still svg").first.is_visible()
    shown.page.emulate_media(media="screen")
    sliders = shown.page.locator(".gcx-sliders input[type=range]")
    assert [s.is_visible() for s in sliders.all()] == [legs.startswith("Aa")] * 6
    assert shown.requests == []
    assert shown.faults == []


@pytest.mark.browser
def test_without_scripts_the_figure_is_there(open_page: Open) -> None:
    shown = open_page(gc.report(OCTAHEDRAL), java_script_enabled=False)
    assert shown.page.locator(".still svg").is_visible()
    assert shown.page.locator(".gcrules-viewer").count() == 0
