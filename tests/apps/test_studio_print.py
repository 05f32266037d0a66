"""The studio's page and reports on paper: in light colours, drawings in place of controls, pages that are filled."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import Desk

pytestmark = pytest.mark.browser

SitDown = Callable[..., Desk]

SEEN = "s => [...document.querySelectorAll(s)].filter(e => e.checkVisibility()).map(e => e.className)"
FILLED = 0.75  # of the height of each page but the last


def fills(page: Any, path: Path) -> list[float]:
    """How far down the words of each page of its print reach, as a share of the height."""
    page.pdf(path=path, format="A4", print_background=True)
    boxes = subprocess.run(["pdftotext", "-bbox", path, "-"], check=True, capture_output=True, text=True).stdout
    sheets = re.findall(r'<page width="[\d.]+" height="([\d.]+)">(.*?)</page>', boxes, re.DOTALL)
    return [max(map(float, re.findall(r'yMax="([\d.]+)"', words))) / float(height) for height, words in sheets]


def test_on_paper_the_page_is_light_with_a_drawing_and_without_controls(sit_down: SitDown) -> None:
    desk = sit_down(color_scheme="dark").visit().open("example", "octahedral", "condition")
    desk.painted()
    theme = "document.documentElement.dataset.theme"
    assert desk.run(theme) == "dark"
    desk.run("window.dispatchEvent(new Event('beforeprint'))")
    desk.page.emulate_media(media="print")
    assert desk.run(theme) == "light"
    drawing = desk.one("paper").locator("svg")
    assert drawing.is_visible()
    assert drawing.locator("rect").first.get_attribute("fill") == "#FFFFFF"
    for hidden in (".scene", ".viewer-tools", ".slider", ".player", ".steps-nav", ".nearest", ".rail", ".stepper"):
        assert desk.run(SEEN, hidden) == []
    assert desk.run(SEEN, ".number") != [], "the pose is told"
    desk.run("window.dispatchEvent(new Event('afterprint'))")
    desk.page.emulate_media(media="screen")
    assert desk.run(theme) == "dark"
    assert not drawing.is_visible()
    assert desk.faults == []


def test_the_drawing_on_paper_is_that_of_the_screen_though_the_view_is_hidden_by_then(sit_down: SitDown) -> None:
    desk = sit_down().visit().open("robot", "delta", "check")
    desk.painted()
    seen = desk.run("gcrules.space.viewer.value.svg()")
    desk.page.emulate_media(media="print")
    desk.painted()
    assert not desk.page.locator(".scene").is_visible()
    assert desk.run("gcrules.space.viewer.value.svg()") == seen
    desk.page.emulate_media(media="screen")


@pytest.mark.needs("pdftotext")
@pytest.mark.parametrize(("kind", "name"), [("example", "octahedral"), ("robot", "3-rps"), ("robot", "delta")])
def test_printed_pages_of_the_studio_are_filled(sit_down: SitDown, tmp_path: Path, kind: str, name: str) -> None:
    desk = sit_down().visit().open(kind, name)
    for stage in ("structure", "condition", "check"):
        desk.step(stage)
        desk.painted()
        shares = fills(desk.page, tmp_path / f"{stage}.pdf")
        assert min(shares[:-1], default=1) > FILLED


@pytest.mark.needs("pdftotext")
@pytest.mark.parametrize("source", [str(EXAMPLES / "octahedral.yaml"), "3-rps", "delta"])
def test_printed_pages_of_a_report_are_filled(sit_down: SitDown, tmp_path: Path, source: str) -> None:
    page = sit_down().page.context.new_page()
    path = tmp_path / "report.html"
    path.write_text(gc.report(source), encoding="utf-8")
    page.goto(path.as_uri())
    page.wait_for_function("() => document.querySelector('.gcx-view canvas, .gcx-view svg')")
    shares = fills(page, tmp_path / "report.pdf")
    assert len(shares) > 1
    assert min(shares[:-1]) > FILLED
