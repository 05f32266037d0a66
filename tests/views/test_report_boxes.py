"""The section of a report about whole ranges: what `gcrules map boxes` says, and its picture in words."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from commands import invoke, refuse_report
from places import EXAMPLES
from views.shown_sections import agrees, plain

import gcrules as gc
from gcrules.poses.boxes.report import BoxMap
from gcrules.views.forms import shown

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
SIX = ["x -150:150", "y -150:150", "z -100:100", "roll -15:15 deg", "pitch -15:15 deg", "yaw -15:15 deg"]
ASKED: dict[str, tuple[str, list[str], dict[str, Any], tuple[int, int]]] = {
    "six legs, six coordinates": (OCTAHEDRAL, SIX, {}, (2, 2_047)),
    "six legs, one": (OCTAHEDRAL, ["z -400:200"], {"limits": "legs 300..900"}, (64, 2_047)),
    "joints, two": ("3-rpr", ["x -0.5:0.5", "yaw -60:80 deg"], {"at": "y=0.05", "limits": "q1 -0.6..0.6"}, (16, 511)),
    "joints, a margin": ("3-rpr", ["x -0.5:0.5", "yaw -60:80 deg"], {"margin": 0.05}, (16, 511)),
}


def section(page: str) -> str:
    return re.findall(r'<section class="motion.*?</section>', page, re.DOTALL)[-1]  # after the numbers at home


def label(page: str) -> str:
    """What the picture shows, as a screen reader says it."""
    found = re.search(r'<svg role="img" aria-label="(.*?)"', section(page))
    assert found
    return unescape(found[1])


@pytest.mark.parametrize(("robot", "over", "options", "cut"), ASKED.values(), ids=ASKED)
def test_the_section_says_what_the_map_says(
    robot: str, over: list[str], options: dict[str, Any], cut: tuple[int, int]
) -> None:
    page = gc.report(robot, interactive=False, over=over, **options)
    found = gc.box_map(robot, over, tiles=cut[0], boxes=cut[1], **options)
    assert isinstance(found, BoxMap)
    agrees(page, found)
    assert "<h2>Whole ranges of x" in page or "<h2>Whole ranges of z" in page
    assert ("--boxes N" in plain(page)) == (found.summary.shares[-1] > 0)


def test_text_and_page_have_one_account() -> None:
    found = gc.box_map("3-rpr", ["x -0.5:0.5", "yaw -60:80 deg"], tiles=4, boxes=63)
    told = shown(found, "account")
    text = " ".join(found.text(unicode=True).split())
    assert " ".join(told.verdict.split()) in text
    (facts,) = told.blocks
    assert all(" ".join(value.split()) in text for _, value in facts.rows)


def test_the_picture_is_told_in_words() -> None:
    over = ["x -0.5:0.5", "yaw -60:80 deg"]
    found = gc.box_map("3-rpr", over, tiles=16, boxes=511)
    assert isinstance(found, BoxMap)
    words = label(gc.report("3-rpr", interactive=False, over=over))
    assert words.startswith("Boxes of poses of Planar 3-RPR robot over x and yaw: ")
    # volumes of the boxes, added up here
    volumes = [
        sum(float((high - low).prod(axis=1).sum()) for low, high, _ in found.boxes(s)) for s in ("crossed", "undecided")
    ]
    for kind, volume in zip(("in boxes that hold a pose that is singular", "undecided"), volumes, strict=True):
        assert f"{100 * volume / 140:.3g} % {kind}" in words


def test_pairs_of_coordinates_are_drawn_where_something_is_left() -> None:
    over = [*SIX[:3], "yaw -90:90 deg"]
    assert label(gc.report(OCTAHEDRAL, interactive=False, over=over)).startswith(
        "For each pair of x, y, z and yaw which part of what is reached is not proved free"
    )
    assert "<svg" not in section(gc.report(OCTAHEDRAL, interactive=False, over=SIX))


def test_poses_below_a_margin_are_not_called_singular() -> None:
    page = gc.report("3-rpr", interactive=False, over=["x -0.05:0.05"], margin=0.9)
    assert "in boxes that hold a pose that is singular, or has a margin below 0.9" in label(page)
    assert "a margin below 0.9" in plain(page)


@pytest.mark.parametrize("over", [["x -0.5:0.5", "yaw -60:80 deg"], ["x -0.1:0.1:5", "yaw 10:60:5 deg"]])
def test_a_picture_brings_no_rules_for_the_rest_of_the_page(over: list[str]) -> None:
    drawn = section(gc.report("3-rpr", interactive=False, over=over))
    assert "<style" not in drawn
    assert 'stroke-linejoin="round"' in drawn
    assert "yaw" in label(drawn)


def test_without_matplotlib_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: Any) -> bytes:
        raise ImportError("no matplotlib")

    monkeypatch.setattr("gcrules.views.results.box_map.picture", missing)
    assert "gcrules[maps]" in plain(gc.report("3-rpr", interactive=False, over=["x -0.5:0.5"]))


def test_the_command_writes_the_same_page(tmp_path: Path) -> None:
    out = tmp_path / "page.html"
    words = ["--over", "x -0.2:0.2", "--over", "yaw -20:20 deg", "--limits", "actuators -0.6..0.6", "--margin", "0.01"]
    done = invoke("report", "3-rpr", "--no-3d", *words, "--at", "y=0.02", "-o", str(out))
    assert done.exit_code == 0, done.output
    assert out.read_text(encoding="utf-8") == gc.report(
        "3-rpr",
        interactive=False,
        over=["x -0.2:0.2", "yaw -20:20 deg"],
        limits="actuators -0.6..0.6",
        margin=0.01,
        at="y=0.02",
    )


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--over", "x -1:1", "--over", "y -1:1:5"], '"x -1:1" is a whole range, and "y -1:1:5" has a number of nodes'),
        (["--over", "y -1:1:5", "--over", "x -1:1"], '"x -1:1" is a whole range, and "y -1:1:5" has a number of nodes'),
        (["--over", "x -1:1", "--over", "rx -1:1 deg"], "whole boxes cannot range over rx"),
        (["--over", "x -1:1", "--over", "nowhere"], "not a coordinate with its range"),
        (["--over", "x -1:1", "--margin", "1.5"], "not from 0 to 1"),
        (["--over", "x -1:1:5", "--over", "y -1:1:5", "--margin", "0.1"], "a margin is that of a map of whole boxes"),
        (["--modes", "--margin", "0.1"], "a margin is that of a map of whole boxes"),
        (["--over", "x -1:1", "--margin", "nan"], "not from 0 to 1"),
    ],
)
def test_faults_of_the_command(options: list[str], message: str, tmp_path: Path) -> None:
    refuse_report(OCTAHEDRAL, options, message, tmp_path / "page.html")


def test_faults_of_the_function() -> None:
    with pytest.raises(gc.InputError, match="has a number of nodes"):
        gc.report("3-rpr", over=["x -1:1", "y -1:1:5"])
    with pytest.raises(gc.InputError, match="no coordinates"):
        gc.report("ab af cb cd ed ef", over=["x -1:1"])
    with pytest.raises(gc.InputError, match="one to six coordinates"):
        gc.report("3-rpr", over=["x -1:1"] * 7)
