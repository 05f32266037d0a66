"""Pictures, films and inner pages that the studio gives away."""

from __future__ import annotations

import base64
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

ENOUGH = 5  # different pictures: a film, and no still
LOOK = """async ([data, enough]) => {
  const video = document.createElement("video");
  video.muted = true;
  video.src = data;
  const rest = () => new Promise(done => setTimeout(done, 200));
  void video.play();
  const canvas = document.createElement("canvas");
  const shots = new Set();
  for (let tries = 0; tries < 300 && !video.ended && shots.size < enough; tries++) {
    await rest();
    if (!video.videoWidth) continue;
    [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
    canvas.getContext("2d").drawImage(video, 0, 0);
    shots.add(canvas.toDataURL());
  }
  return [video.videoWidth, video.videoHeight, shots.size];
}"""
"""Plays a film until enough is seen of it, or for a minute: a player may stall, and never come to the end."""


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def taken(desk: Desk, testid: str) -> Path:
    """What a button gives for download."""
    desk.one("panel-take-away").click()
    with desk.page.expect_download() as saving:
        desk.one(testid).click()
    return Path(saving.value.path())


def flat(pose: dict[str, Any]) -> list[float]:
    return [*pose["translation"], *pose["quaternion"], *pose.get("coordinates", [])]


def looked_at(desk: Desk, film: Path) -> list[Any]:
    """Width and height of a film, and how many different pictures were seen of it."""
    data = film.read_bytes()
    assert data[:4] == bytes.fromhex("1a45dfa3"), "no WebM"
    page = desk.page.context.new_page()
    found = page.evaluate(LOOK, ["data:video/webm;base64," + base64.b64encode(data).decode(), ENOUGH])
    page.close()
    return list(found)


@pytest.mark.parametrize(
    ("kind", "name", "slider", "value"), [("example", "octahedral", "z", -100), ("robot", "delta", "0", 12)]
)
def test_a_way_is_filmed(desk: Desk, kind: str, name: str, slider: str, value: float) -> None:
    desk.open(kind, name)
    desk.slide(slider, value)
    desk.answered()
    desk.let_go(slider)
    desk.page.wait_for_selector("[data-testid=way][data-proved=true]")
    pose = desk.pose
    width, height, pictures = looked_at(desk, taken(desk, "take-view-way"))
    viewer = desk.one("viewer").bounding_box()
    assert (width, height) == pytest.approx((2 * viewer["width"], 2 * viewer["height"]), abs=4)
    assert pictures == ENOUGH
    desk.answered()
    assert flat(desk.pose) == pytest.approx(flat(pose), abs=1e-6)
    assert len(desk.run("gcrules.timeline.stops.value")) == 2, "filming is no driving"


def test_the_gained_motion_is_filmed_where_there_is_one(desk: Desk) -> None:
    desk.open("example", "octahedral")
    desk.one("panel-take-away").click()
    desk.one("take-view-motion").click()
    fault = desk.page.locator("[data-testid=offer-view-motion] .fault")
    fault.wait_for()
    assert "gains no motion in this pose" in fault.inner_text()
    desk.slide("z", -350)
    desk.answered()
    desk.verdict("singular")
    *_, pictures = looked_at(desk, taken(desk, "take-view-motion"))
    assert pictures == ENOUGH


def test_a_film_is_stopped(desk: Desk) -> None:
    desk.open("robot", "delta")
    desk.slide("0", 12)
    desk.answered()
    desk.let_go("0")
    desk.page.wait_for_selector("[data-testid=way][data-proved=true]")
    pose = desk.pose
    desk.one("panel-take-away").click()
    desk.stop("take-view-way", "stop-view-way")
    desk.answered()
    assert flat(desk.pose) == pytest.approx(flat(pose), abs=1e-6)


@pytest.mark.parametrize(("kind", "name"), [("example", "octahedral"), ("robot", "delta")])
def test_the_report_lives_in_another_page(desk: Desk, tmp_path: Path, kind: str, name: str) -> None:
    desk.open(kind, name)
    desk.one("panel-take-away").click()
    with desk.page.expect_download() as saving:
        desk.one("embed-make").click()
    desk.page.wait_for_function("() => document.querySelector('[data-testid=embed]').value !== ''")
    line = desk.one("embed").input_value()
    assert f'src="{saving.value.suggested_filename}"' in line
    saving.value.save_as(tmp_path / saving.value.suggested_filename)
    around = tmp_path / "around.html"
    around.write_text(f"<!doctype html><title>around</title>{line}", encoding="utf-8")
    page = desk.page.context.new_page()
    page.goto(around.as_uri())
    inner = page.frame_locator("iframe")
    inner.locator(".gcrules-viewer").first.wait_for()
    assert page.locator("iframe").get_attribute("sandbox") == "allow-scripts"
    page.close()
