"""How robots are framed: whole when they open, and two side by side from the same direction."""

from __future__ import annotations

from collections.abc import Callable

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from places import ROOT
from studio_page import Desk

pytestmark = pytest.mark.browser

LINKED = "() => gcrules.space.viewer.value.scene.skeleton === gcrules.posing.numbers.value.skeleton"
DRAWN = """() => {
  const box = document.createElement("div");
  box.style.cssText = "position: fixed; left: 0; top: 0; visibility: hidden";
  box.innerHTML = gcrules.space.viewer.value.svg();
  document.body.append(box);
  const [svg] = box.children;
  const shapes = [...svg.querySelectorAll("title + rect + g > :not([stroke-opacity='0.28'])")].map(e => e.getBBox());
  box.remove();
  return {width: Number(svg.getAttribute("width")), height: Number(svg.getAttribute("height")), count: shapes.length,
    left: Math.min(...shapes.map(b => b.x)), right: Math.max(...shapes.map(b => b.x + b.width)),
    top: Math.min(...shapes.map(b => b.y)), bottom: Math.max(...shapes.map(b => b.y + b.height))};
}"""
"""What is drawn apart from the grid and the labels: how much, and how far it reaches."""


ALIKE = """() => {
  const [one, other] = ["viewer", "beside-picture"].map(id => {
    const corner = document.querySelector(`[data-testid=${id}] svg[viewBox="-34 -34 68 68"]`);
    return [...corner.querySelectorAll("line")].flatMap(l => [l.x2.baseVal.value, l.y2.baseVal.value]); });
  return Math.hypot(...one.map((x, i) => x - other[i])) < 0.2;
}"""
"""Whether the axes in the corners of both pictures, drawn in their own pixels, have their tips at the same places."""


FROM_ABOVE = """() => {
  const {eye, target} = gcrules.space.viewer.value.stand;
  const [x, y, z] = eye.map((e, i) => e - target[i]);
  return Math.hypot(x, y) < 0.01 * z;
}"""


def whole(desk: Desk) -> None:
    desk.page.wait_for_function(LINKED)
    desk.painted()
    found = desk.run(DRAWN)
    assert found["count"] > 20
    assert found["left"] >= 0
    assert found["top"] >= 0
    assert found["right"] <= found["width"]
    assert found["bottom"] <= found["height"]
    assert found["bottom"] - found["top"] > 0.4 * found["height"], "it is not lost in the picture"


@pytest.mark.parametrize("name", ["agile-eye", "3-rrr-spherical", "quadrupteron", "3-puu"])
def test_a_robot_opens_with_all_its_links_in_sight(sit_down: Callable[..., Desk], name: str) -> None:
    whole(sit_down(viewport={"width": 1100, "height": 720}).visit().open("robot", name))


@pytest.mark.parametrize("size", [(1440, 900), (2560, 1080), (390, 844), (320, 640)], ids=str)
@pytest.mark.parametrize("name", ["delta", "gough-stewart", "capaman", "3-rrr"])
def test_robots_fill_panes_of_any_shape(sit_down: Callable[..., Desk], name: str, size: tuple[int, int]) -> None:
    """All of it is seen, and it reaches to within a tenth of the pane and the room of its labels."""
    desk = sit_down(viewport={"width": size[0], "height": size[1]}).visit().open("robot", name)
    desk.page.wait_for_function(LINKED)
    desk.painted()
    found = desk.run(DRAWN)
    wide, high = found["right"] - found["left"], found["bottom"] - found["top"]
    assert wide <= found["width"]
    assert high <= found["height"]
    assert max(wide / found["width"], high / found["height"]) > 0.7


def test_entities_that_come_are_seen_whole(sit_down: Callable[..., Desk]) -> None:
    """The steps come to the planes, which reach beyond the robot; a view that was chosen is kept."""
    desk = sit_down(viewport={"width": 1440, "height": 900}).visit().open("class", "6-3.2")
    desk.painted()
    desk.step("planes")
    desk.painted()
    found = desk.run(DRAWN)
    assert found["left"] >= 0
    assert found["right"] <= found["width"]
    assert found["top"] >= 0
    assert found["bottom"] <= found["height"]
    desk.step("structure")
    desk.one("view-top").click()
    desk.painted()
    before = desk.run("gcrules.space.viewer.value.stand")
    desk.step("planes")
    desk.painted()
    assert desk.run("gcrules.space.viewer.value.stand") == before


def test_a_view_that_was_chosen_stays(sit_down: Callable[..., Desk]) -> None:
    desk = sit_down().visit().open("robot", "agile-eye")
    whole(desk)
    desk.one("view-top").click()
    desk.painted()
    before = desk.run("gcrules.space.viewer.value.stand")
    desk.slide("0", 5)
    desk.answered()
    desk.painted()
    assert desk.run("gcrules.space.viewer.value.stand") == before


def test_two_robots_side_by_side_are_seen_from_the_same_direction(sit_down: Callable[..., Desk]) -> None:
    desk = sit_down().visit().open("robot", "agile-eye")
    desk.one("panel-dimensions").click()
    desk.run("gcrules.comparing.choose('Spherical', {kind: 'robot', id: '3-rrr-spherical'})")
    desk.page.wait_for_function("() => gcrules.comparing.numbers.value")
    desk.page.wait_for_function(ALIKE)
    desk.one("view-top").click()
    desk.page.wait_for_function(f"() => ({FROM_ABOVE})() && ({ALIKE})()")


ELEVATION = """() => { const {eye, target} = gcrules.space.viewer.value.stand;
  const [x, y, z] = eye.map((e, i) => e - target[i]); return Math.atan2(z, Math.hypot(x, y)) * 180 / Math.PI; }"""


@pytest.mark.parametrize(
    ("name", "low", "high"), [("3-rrr", 55, 70), ("5r", 55, 70), ("delta", 15, 25), ("capaman", 15, 25)]
)
def test_robots_that_lie_flat_open_from_above(sit_down: Callable[..., Desk], name: str, low: int, high: int) -> None:
    desk = sit_down().visit().open("robot", name)
    desk.page.wait_for_function(LINKED)
    desk.painted()
    assert low < desk.run(ELEVATION) < high


SOFTWARE = """() => {
  const gl = document.createElement("canvas").getContext("webgl2");
  const unmasked = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
  return /swiftshader|llvmpipe/i.test(gl.getParameter(unmasked ?? gl.RENDERER)); }"""
FINENESS = """() => {
  const canvas = document.querySelector("[data-testid=viewer] canvas");
  return canvas.width / canvas.clientWidth; }"""
MOVED = """() => new Promise(done => {
  const canvas = document.querySelector("[data-testid=viewer] canvas"), seen = [];
  new MutationObserver((_, watch) => {
    seen.push(canvas.width / canvas.clientWidth);
    if (seen.at(-1) === 2) { watch.disconnect(); done(seen); }
  }).observe(canvas, {attributeFilter: ["width"]});
  gcrules.edit({pose: {translation: [0, 0, 40], quaternion: [1, 0, 0, 0]}}); })"""
"""How fine the drawing is after a move, until it is as fine as at first."""


def test_without_a_graphics_card_a_moving_picture_is_coarse_and_a_still_one_fine(
    sit_down: Callable[..., Desk],
) -> None:
    desk = sit_down().visit().open("example", "octahedral")
    if not desk.run(SOFTWARE):
        pytest.skip("there is a graphics card")
    desk.page.wait_for_function(f"() => ({FINENESS})() === 2")
    assert desk.run(MOVED) == [1, 2]


def test_long_names_of_actuators_leave_the_way_where_it_is(sit_down: Callable[..., Desk]) -> None:
    """Each takes one line, its end left out in the page and told where it is pointed at."""
    text = (ROOT / "plugins/6-rus/robot.yaml").read_text(encoding="utf-8")
    tops = []
    for name in ("leg %", "the very long arm of the machine with the number %"):
        desk = sit_down(viewport={"width": 1440, "height": 900}).visit()
        desk.run("text => gcrules.open({kind: 'file', name: 'r.yaml', text})", text.replace("leg %", name))
        desk.page.wait_for_function("() => gcrules.loaded.value.state === 'ready'")
        desk.answered()
        desk.painted()
        tops.append(desk.one("tab-way").bounding_box()["y"])
        assert desk.page.locator(".axis .name").first.get_attribute("title") == f"q1, {name.replace('%', '1')}"
        assert desk.run("document.documentElement.scrollWidth <= innerWidth")
    assert tops[0] == tops[1] < 820
