"""The sections of a report about a path and a map: the same for platforms on six legs and for robots of joints."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from commands import invoke, refuse_report
from places import EXAMPLES
from views.shown_sections import plain

import gcrules as gc
from gcrules.poses.paths.report import PathReport
from gcrules.views.report import motion_sections

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
PATHS: dict[str, tuple[str, list[str]]] = {
    "six legs, crossed": (OCTAHEDRAL, ["0 0 0", "0 0 0; rotvec 0 0 120 deg"]),
    "six legs, regular": (OCTAHEDRAL, ["home", "0 0 -100"]),
    "joints, crossed": ("3-rpr", ["home", "x=0, y=0, yaw=60deg", "x=0.1, y=0, yaw=0deg"]),
    "joints, regular": ("3-rps", ["home", "z=0.1, roll=10deg, pitch=5deg"]),
}
MAPS: dict[str, tuple[str, list[str], str | None]] = {
    "six legs": (OCTAHEDRAL, ["x -200:200:9", "rz -120:120:9 deg"], "0 0 -20"),
    "joints": ("3-rpr", ["x -0.1:0.1:5", "yaw 10:60:5 deg"], "y=0.05"),
    "actuators": ("3-rpr", ["q1 -0.1:0.1:5", "q2 -0.1:0.1:5"], None),
}


def words_of(page: str) -> str:
    """The text of a page's sections about paths and maps."""
    sections = re.findall(r'<section class="motion.*?</section>', page, re.DOTALL)
    assert sections
    return unescape(re.sub(r"<[^>]+>", " ", " ".join(sections)))


@pytest.mark.parametrize(("robot", "poses"), PATHS.values(), ids=PATHS)
def test_a_path_in_a_report(robot: str, poses: list[str]) -> None:
    page = gc.report(robot, interactive=False, path=poses)
    shown, found = words_of(page), gc.path(robot, poses)
    assert found.verdict.capitalize() in shown
    assert found.reason in shown
    met = found.zeros if isinstance(found, PathReport) else found.crossings
    assert len(re.findall(r"<tr><th>\d+</th><td>", page)) == len(met)
    for one in met:
        assert f"{one.parameter:.6g}" in shown
        assert all(cause.rstrip(".").lower() in shown.lower() for cause in one.causes)
    assert "<svg" in page[page.index('class="motion') :]
    if "crossed" in next(name for name, given in PATHS.items() if given == (robot, poses)):
        assert met


@pytest.mark.parametrize(("robot", "over", "at"), MAPS.values(), ids=MAPS)
def test_a_map_in_a_report(robot: str, over: list[str], at: str | None) -> None:
    page = gc.report(robot, interactive=False, over=over, at=at)
    shown, found = words_of(page), gc.singular_map(robot, over, at)
    assert found.guarantee[1:] in shown
    assert found.grid.rest in shown
    assert "<svg" in page[page.index('class="motion') :]


def test_undecided_stretches_are_listed() -> None:
    # the path ends where the robot is singular, so that no sign changes
    crossed = gc.path("3-rpr", ["home", "x=0, y=0, yaw=60deg"])
    assert not isinstance(crossed, PathReport)
    poses = ["home", f"x=0, y=0, yaw={60 * crossed.crossings[0].parameter!r}deg"]
    found = gc.path("3-rpr", poses)
    assert not isinstance(found, PathReport)
    assert found.undecided
    shown = words_of(gc.report("3-rpr", interactive=False, path=poses))
    assert "It is not decided whether a pose is singular." in shown
    assert all(f"{start:.6g} to {end:.6g}" in shown for start, end in found.undecided)


def test_a_surface_in_a_report() -> None:
    page = gc.report(OCTAHEDRAL, interactive=False, over=["x -200:200:5", "y -200:200:5", "rz -120:120:5 deg"])
    assert 'src="data:image/png;base64,' in page


def test_without_matplotlib_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: Any) -> bytes:
        raise ImportError("no matplotlib")

    monkeypatch.setattr(motion_sections, "picture", missing)
    page = gc.report(OCTAHEDRAL, interactive=False, over=["x -200:200:5", "rz -120:120:5 deg"])
    assert "gcrules[maps]" in words_of(page)


@pytest.mark.parametrize("robot", [OCTAHEDRAL, "3-rpr"])
def test_the_command_writes_the_same_page(robot: str, tmp_path: Path) -> None:
    path, over = (["home", "x=0.1, y=0, yaw=5deg"], ["x -0.1:0.1:3", "yaw 0:10:3 deg"])
    if robot == OCTAHEDRAL:
        path = ["home", "0 0 -10"]
    out = str(tmp_path / "page.html")
    words = [w for p in path for w in ("--path", p)] + [w for o in over for w in ("--over", o)]
    done = invoke("report", robot, "--no-3d", *words, "-o", out)
    assert done.exit_code == 0, done.output
    assert Path(out).read_text(encoding="utf-8") == gc.report(robot, interactive=False, path=path, over=over)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--at", "0 0 1"], "add --over, --certify, --modes or --free"),
        (["--limits", "legs 1..3"], "add --over, --certify, --aspects or --plan"),
        (["--plan", "home", "--plan", "0 0 1", "--threshold", "1 deg"], "add --path, --over or --modes"),
        (["--path", "0 0 0", "--poses", "poses.csv"], "either by"),
        (["--path", "0 0 0"], "two poses or more"),
        (["--over", "x 0:1:3"], "two or three coordinates"),
    ],
)
def test_faults_of_the_command(options: list[str], message: str, tmp_path: Path) -> None:
    refuse_report(OCTAHEDRAL, options, message, tmp_path / "page.html")


def test_faults_of_the_function() -> None:
    with pytest.raises(gc.InputError, match="that of a map"):
        gc.report(OCTAHEDRAL, at="0 0 1")
    with pytest.raises(gc.InputError, match="no coordinates"):
        gc.report("ab af cb cd ed ef", path=["0 0 0", "0 0 1"])


def test_a_factor_that_is_known_up_to_a_cofactor_says_so_at_home() -> None:
    (factor,) = gc.pose("4-upu", nearest=False).factors
    words = plain(gc.report("4-upu", interactive=False))
    assert factor.cofactor is not None
    assert "divided by the cofactor" in words
    assert f"which is {factor.cofactor_value:.4g} here" in words
