"""Whole ranges in the studio as a person asks for them, maps and certificates; and the account of a model."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.mechanisms.models.importing import import_file
from gcrules.views.forms import shown
from gcrules.views.numerals import in_prose

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs Playwright")

from studio_page import Desk

pytestmark = pytest.mark.browser

FILE = str(EXAMPLES / "octahedral.yaml")


def test_whole_ranges_are_proved_and_stopped(desk: Desk) -> None:
    """The ranges that are ticked, with their bar, their words and the picture; a long one is stopped."""
    desk.run("() => gcrules.open({kind: 'robot', id: '3-rpr'})")
    desk.answered()
    desk.one("panel-where").click()
    assert desk.one("boxes-over-x").is_checked()
    desk.one("boxes-over-y").uncheck()
    assert desk.page.get_by_test_id("boxes-low-y").count() == 0
    desk.one("boxes-over-yaw").check()
    for name, low, high in (("x", "-0.5", "0.5"), ("yaw", "-60", "80")):
        for which, value in (("low", low), ("high", high)):
            field = desk.one(f"boxes-{which}-{name}")
            field.fill(value)
            field.press("Enter")
    desk.one("boxes-most").select_option("4000")
    desk.one("boxes-limits").fill("q1 -1..")
    desk.one("boxes-go").click()
    desk.one("boxes-decided").wait_for()
    assert "is not free" in desk.text("boxes-verdict")
    kinds = [s.get_attribute("data-kind") for s in desk.page.get_by_test_id("boxes-share").all()]
    assert {"free", "other", "crossed"} <= set(kinds)
    decided = float(desk.one("boxes-decided").get_attribute("data-decided"))
    assert 0.5 < decided < 1
    assert f"{100 * decided:.3g} % of the volume is decided" in desk.text("boxes-decided")
    assert desk.one("boxes-picture").get_attribute("alt").startswith("Boxes of poses of Planar 3-RPR robot")
    assert desk.one("boxes-picture").evaluate("e => e.naturalWidth") > 100
    wide = desk.page.locator(".where .volume").bounding_box()["width"]
    parts = [b.bounding_box()["width"] for b in desk.page.locator(".where .volume span").all()]
    assert sum(parts) == pytest.approx(wide, abs=3)
    desk.run("() => gcrules.open({kind: 'example', name: 'octahedral'})")
    desk.answered()
    desk.one("panel-where").click()
    wide, turned = (-900.0, 900.0), (-80.0, 80.0)
    ranges(desk, x=wide, y=wide, z=wide, roll=turned, pitch=turned, yaw=turned)
    desk.one("boxes-most").select_option("2000000")
    desk.stop("boxes-go", "boxes-stop")


def ranges(desk: Desk, **wanted: tuple[float, float]) -> None:
    """Tick these coordinates and no others, each with its range."""
    for axis in desk.study["wholes"]:
        name = axis["name"]
        desk.one(f"boxes-over-{name}").set_checked(name in wanted)
        for which, value in zip(("low", "high"), wanted.get(name, ()), strict=False):
            field = desk.one(f"boxes-{which}-{name}")
            field.fill(str(value))
            field.press("Enter")


def certificate(desk: Desk, kind: str, name: str, **wanted: tuple[float, float]) -> None:
    """A robot with the question for a certificate."""
    desk.open(kind, name)
    desk.one("panel-where").click()
    desk.one("whole-certificate").click()
    ranges(desk, **wanted)


def arrived(desk: Desk) -> None:
    desk.page.wait_for_function("() => !gcrules.moving.active.value")
    desk.answered()


def test_a_range_is_certified(desk: Desk, tmp_path: Path) -> None:
    """Cones and tilt are asked for, the margin is told, and the file is the one that the library writes."""
    certificate(desk, "example", "octahedral", x=(-50, 50), roll=(-10, 10))
    desk.one("boxes-cone").fill("60 deg")
    desk.one("boxes-tilt").fill("8 deg")
    desk.one("boxes-most").select_option("4000")
    desk.one("boxes-go").click()
    desk.one("certify-file").wait_for()
    same = gc.certify(FILE, ["x -50:50", "roll -10:10 deg"], cone="60 deg", tilt="8 deg", boxes=4_000)
    assert desk.text("certify-verdict") in " ".join(same.text(unicode=True).split())
    assert desk.page.locator(".certify .answer.free .bounds dt").first.inner_text() == f"σ ≥ {same.bound:.4g}"
    assert desk.one("certify-place").get_attribute("data-kind") == "least"
    desk.one("certify-go").click()
    arrived(desk)
    assert desk.numbers["margin"] == pytest.approx(same.least)
    assert desk.one("certify-go").is_disabled()
    with desk.page.expect_download() as download:
        desk.one("certify-file").click()
    assert download.value.suggested_filename == "octahedral-platform-3-3-certificate.json.gz"
    path = tmp_path / "kept.json.gz"
    download.value.save_as(path)
    assert json.loads(gzip.decompress(path.read_bytes())) == json.loads(json.dumps(same.to_json()))


def test_the_platform_goes_to_the_singular_pose_of_a_certificate(desk: Desk) -> None:
    certificate(desk, "example", "octahedral", z=(-400, 0), roll=(-5, 5))
    desk.one("boxes-go").click()
    place = desk.one("certify-place")
    place.wait_for()
    assert place.get_attribute("data-kind") == "singular"
    assert "meet in a point" in place.inner_text()
    assert "There is a singular pose in range" in desk.text("certify-verdict")
    assert desk.one("boxes-picture").evaluate("e => e.naturalWidth") > 100
    desk.one("certify-go").click()
    arrived(desk)
    desk.verdict("singular")
    assert desk.page.locator(".certify .tip", has_text="The robot has moved since").count() == 0


def test_map_and_certificate_share_the_question(desk: Desk) -> None:
    """Each keeps its answer; cones and tilt are those of the certificate."""
    certificate(desk, "robot", "3-rpr", x=(-0.1, 0.1))
    assert desk.page.get_by_test_id("boxes-tilt").count() == 0  # it neither rolls nor pitches
    desk.one("boxes-cone").fill("40")
    desk.one("boxes-go").click()
    fault = desk.one("fault")
    fault.wait_for()
    assert "is not a cone" in fault.inner_text()
    desk.one("whole-map").click()
    assert desk.page.get_by_test_id("boxes-cone").count() == 0
    assert desk.page.get_by_test_id("fault").count() == 0
    desk.one("boxes-most").select_option("4000")
    desk.one("boxes-go").click()
    desk.one("boxes-decided").wait_for()
    words = desk.text("boxes-verdict")
    desk.one("whole-certificate").click()
    desk.one("boxes-cone").fill("")
    desk.one("boxes-go").click()
    desk.one("certify-file").wait_for()
    assert "No singular pose in range" in desk.text("certify-verdict")
    assert "compares with the joints" in desk.page.locator(".kept").inner_text()
    desk.one("whole-map").click()
    assert desk.text("boxes-verdict") == words


def test_a_long_certificate_is_stopped(desk: Desk) -> None:
    certificate(desk, "robot", "6-rus", **dict.fromkeys("xyz", (-0.2, 0.2)), roll=(-10, 10), pitch=(-10, 10))
    desk.one("boxes-most").select_option("2000000")
    desk.stop("boxes-go", "certify-stop")


def test_kinds_of_boxes_are_told_apart_in_the_dark_and_on_a_telephone(desk: Desk) -> None:
    desk.page.set_viewport_size({"width": 390, "height": 844})
    desk.one("theme").click()
    certificate(desk, "robot", "3-rpr", x=(-0.5, 0.5), yaw=(-60, 80))
    desk.one("whole-map").click()
    desk.one("boxes-limits").fill("actuators -0.6..0.6")
    desk.one("boxes-go").click()
    desk.one("boxes-decided").wait_for()
    assert desk.run("document.documentElement.scrollWidth") == 390
    rail = [b.bounding_box() for b in desk.page.locator(".rail button").all()]
    assert len(rail) == 10
    assert all(b["x"] >= 0 and b["x"] + b["width"] <= 390 for b in rail)
    colours = [s.evaluate("e => getComputedStyle(e).backgroundColor") for s in desk.page.locator(".volume span").all()]
    assert len(colours) == 5
    paints = [tuple(int(c) for c in colour[4:-1].split(",")) for colour in colours]
    for k, one in enumerate(paints):
        assert all(max(abs(a - b) for a, b in zip(one, other, strict=True)) > 40 for other in paints[:k])


# --- a model --------------------------------------------------------------------------------------------------------

MODEL = EXAMPLES / "models" / "rotary-hexapod.xml"


def test_a_model_that_is_opened_is_accounted_for(desk: Desk) -> None:
    """Which joint of it each actuator is, what it reaches, and what was merged and moved."""
    desk.one("file").set_input_files(MODEL)
    desk.one("model").wait_for()
    drives = [row.inner_text().split() for row in desk.page.get_by_test_id("model-drive").all()]
    assert drives == [[f"q{k}", f"leg{k}_motor", "−1.2", "to", "1.2"] for k in range(1, 7)]
    assert (
        desk.text("model-verdict")
        == "rotary-hexapod (MJCF) is read as 6-R*US: top moves relative to world, mobility 6."
    )
    desk.page.locator("[data-testid=model] summary").click()
    words = " ".join(desk.one("model").inner_text().split())
    (facts,) = shown(import_file(MODEL), "account").blocks
    assert {"base", "platform", "merged", "moved", "checked"} <= {name for name, _ in facts.rows}
    assert all(" ".join(in_prose(value).split()) in words for name, value in facts.rows if name != "checked")
    desk.open("robot", "3-rpr", "limbs")
    assert desk.page.get_by_test_id("model").count() == 0
