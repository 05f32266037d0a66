"""The sections of a report about modes, aspects, a plan and a free region: they say what the results say."""

from __future__ import annotations

import gzip
import json
import re
from base64 import b64decode
from collections.abc import Callable
from html import escape, unescape
from pathlib import Path
from typing import Any

import pytest
from commands import invoke, refuse_report
from places import EXAMPLES
from views.shown_pages import Shown, open_from_file
from views.shown_sections import agrees, plain

import gcrules as gc
from gcrules.views.report.answer_sections import answers_html

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
ROBOTS = {"six legs": OCTAHEDRAL, "joints in space": "3-rps", "joints in a plane": "3-rpr"}
WAYS: dict[str, tuple[str, list[str], str]] = {
    "six legs": (OCTAHEDRAL, ["home", "0 0 -300; rotvec 0 0 60 deg"], "way"),
    "six legs, none": (OCTAHEDRAL, ["home", "0 0 -733.333; rotvec -20.241 -4.04819 0 deg"], "none"),
    "joints": ("3-rps", ["home", "z=0.2, roll=20deg, pitch=10deg"], "way"),
    "joints, none": ("3-rpr", ["home", "x=-0.13, y=-0.282, yaw=93.23deg"], "none"),
}
ANSWERS: dict[str, tuple[dict[str, Any], Callable[[str], Any]]] = {
    "modes": ({"modes": True}, gc.assembly_modes),
    "aspects": ({"aspects": True}, gc.aspects),
    "box": ({"free": "box"}, gc.free_region),
}


@pytest.mark.parametrize("robot", [OCTAHEDRAL, "3-rpr"], ids=["six legs", "joints"])
@pytest.mark.parametrize("question", ANSWERS)
def test_a_section_says_what_the_result_says(question: str, robot: str) -> None:
    asked, function = ANSWERS[question]
    agrees(gc.report(robot, interactive=False, **asked), function(robot))


CERTIFIED: dict[str, Callable[[], Any]] = {
    "map": lambda: gc.singular_map(OCTAHEDRAL, ["x -490:490:5", "z -490:490:5"]),
    "free": lambda: gc.free_region(OCTAHEDRAL),
    "boxes": lambda: gc.box_map(OCTAHEDRAL, ["x -10:10"]),
    "plan": lambda: gc.plan(OCTAHEDRAL, *WAYS["six legs, none"][1]),
}


@pytest.mark.parametrize("kind", CERTIFIED)
def test_a_report_carries_the_certificate_of_an_answer(kind: str) -> None:
    answer = CERTIFIED[kind]()
    [section] = answers_html(gc.analyze(OCTAHEDRAL), [answer], "centroid", live=False)
    assert f"<code>python checkers/check_{kind}.py FILE</code>" in section
    [(name, data)] = re.findall(r'download="([^"]+)" href="data:application/gzip;base64,([^"]+)"', section)
    assert name.endswith(f"-{kind}.json.gz")
    assert json.loads(gzip.decompress(b64decode(data))) == answer.certificate()


def test_a_report_says_why_no_program_checks_an_answer() -> None:
    way, driven = gc.plan(OCTAHEDRAL, *WAYS["six legs"][1]), gc.free_region("3-rpr", over="actuators")
    [section] = answers_html(gc.analyze(OCTAHEDRAL), [way], "centroid", live=False)
    assert "Checking it again" not in section
    [section] = answers_html(gc.analyze("3-rpr"), [driven], "centroid", live=False)
    with pytest.raises(gc.GcrulesError) as fault:
        driven.certificate()
    assert escape(fault.value.message) in section
    assert "download=" not in section


@pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)
def test_each_assembly_mode_has_a_picture(robot: str) -> None:
    page = gc.report(robot, interactive=False, modes=True)
    found = gc.assembly_modes(robot)
    titles = re.findall(r'<figure class="card"><svg.*?<title>(.*?)</title>', page, re.DOTALL)
    assert [unescape(t).split(" in ")[-1] for t in titles] == [
        f"mode {m.number}: {m.verdict}, σ = {m.margin:.4g}" for m in found.modes
    ]
    assert page.count(found.modes[0].certificate.method.replace("'", "&#x27;")) >= len(found.modes)


def test_working_and_operation_modes_of_joints() -> None:
    page = gc.report("3-rrr", interactive=False, modes=True)
    agrees(page, gc.working_modes("3-rrr"))
    agrees(page, gc.operation_modes("3-rrr"))
    assert "Working modes" not in gc.report(OCTAHEDRAL, interactive=False, modes=True)


def test_modes_that_a_robot_has_not_are_told_with_the_reason() -> None:
    with pytest.raises(gc.GcrulesError) as fault:
        gc.operation_modes("capaman")
    assert fault.value.message in plain(gc.report("capaman", interactive=False, modes=True))


def test_modes_at_a_pose() -> None:
    page = gc.report(OCTAHEDRAL, interactive=False, modes=True, at="0 0 -30")
    agrees(page, gc.assembly_modes(OCTAHEDRAL, "0 0 -30"))


@pytest.mark.parametrize(("robot", "poses", "outcome"), WAYS.values(), ids=WAYS)
def test_a_plan(robot: str, poses: list[str], outcome: str) -> None:
    page = gc.report(robot, interactive=False, plan=poses)
    found = gc.plan(robot, *poses)
    assert found.outcome == outcome
    agrees(page, found)
    section = page[page.index('<section class="motion') :]
    assert ('<figure class="plot">' in section) == (outcome == "way")
    assert section.count('class="card"') == len(found.poses)


def test_a_way_out() -> None:
    page = gc.report(OCTAHEDRAL, interactive=False, plan=["0 0 -349.9"])
    assert "A way out" in page
    agrees(page, gc.plan(OCTAHEDRAL, "0 0 -349.9"))


def test_the_command_writes_the_same_page(tmp_path: Path) -> None:
    out = tmp_path / "page.html"
    words = ["--modes", "--plan", "home", "--plan", "x=0.1, y=0, yaw=5deg", "--within", "x -1..1"]
    done = invoke("report", "3-rpr", *words, "-o", str(out))
    assert done.exit_code == 0, done.output
    same = gc.report("3-rpr", modes=True, plan=["home", "x=0.1, y=0, yaw=5deg"], within="x -1..1")
    assert out.read_text(encoding="utf-8") == same


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--at", "0 0 1", "--aspects"], "add --over, --certify, --modes or --free"),
        (["--limits", "legs 1..3", "--modes"], "add --over, --certify, --aspects or --plan"),
        (["--within", "z 0..1", "--modes"], "add --aspects or --plan"),
        (["--plan", "home", "--plan", "0 0 1", "--plan", "0 0 2"], "a plan of 3 poses"),
        (["--free", "cube"], "cube"),
        (["--modes", "--at", "nowhere"], "nowhere"),
    ],
)
def test_faults_of_the_command(options: list[str], message: str, tmp_path: Path) -> None:
    refuse_report(OCTAHEDRAL, options, message, tmp_path / "page.html")


@pytest.mark.parametrize(
    ("options", "message"),
    [({"plan": []}, "a plan of 0 poses"), ({"free": "cube"}, "not a shape"), ({"within": "z 0..1"}, "ranges")],
)
def test_faults_of_the_function(options: dict[str, Any], message: str) -> None:
    with pytest.raises(gc.InputError, match=message):
        gc.report(OCTAHEDRAL, **options)


# --- in a browser --------------------------------------------------------------------------------------------------


def opened(chromium: Any, path: Path, page: str) -> Shown:
    """The page, with its last view in sight."""
    shown = open_from_file(chromium, path / "page.html", page)
    shown.page.locator(".lead").last.scroll_into_view_if_needed()
    shown.page.wait_for_selector(".lead .gcx")
    return shown


@pytest.mark.browser
@pytest.mark.parametrize(("robot", "poses"), [WAYS["six legs"][:2], WAYS["joints"][:2]], ids=["six legs", "joints"])
def test_the_view_goes_along_the_way(chromium: Any, tmp_path: Path, robot: str, poses: list[str]) -> None:
    """At its end the page, which computes by itself, has the margin of the library."""
    page = opened(chromium, tmp_path, gc.report(robot, plan=poses))
    page.page.get_by_role("button", name="Play").click()
    at_goal = gc.pose(robot, poses[1], nearest=False).margin
    assert page.run("document.querySelector('.lead output').textContent") == f"parameter 1.000, σ = {at_goal:.4g}"
    margin = page.page.locator(".lead .gcx-numbers dd").nth(1 if robot == OCTAHEDRAL else 0).inner_text()
    assert float(margin) == pytest.approx(at_goal, rel=1e-3)
    page.page.locator(".lead .tour input").fill("0")
    assert page.run("document.querySelector('.lead output').textContent").startswith("parameter 0.000")
    assert page.faults == []
    assert page.requests == []


@pytest.mark.browser
@pytest.mark.parametrize(("robot", "number"), [(OCTAHEDRAL, 3), ("3-rps", 5), ("delta", 2)])
def test_the_view_shows_assembly_modes(chromium: Any, tmp_path: Path, robot: str, number: int) -> None:
    page = opened(chromium, tmp_path, gc.report(robot, modes=True))
    page.page.get_by_role("button", name=f"Show Mode {number} in 3D").click()
    margin = page.page.locator(".lead .gcx-numbers dd").nth(1 if robot == OCTAHEDRAL else 0).inner_text()
    assert float(margin) == pytest.approx(gc.assembly_modes(robot)[number - 1].margin, rel=1e-3)
    assert page.faults == []


@pytest.mark.browser
def test_the_view_says_where_it_does_not_get(chromium: Any, tmp_path: Path) -> None:
    """Past a singular place the actuators lead elsewhere, or nowhere; back from there it is as before."""
    poses = ["home", "z=0.2, roll=20deg, pitch=10deg", "z=0.2, roll=85deg, pitch=10deg"]
    page = opened(chromium, tmp_path, gc.report("3-rps", path=poses))
    place, words = page.page.locator(".lead .tour input"), page.page.locator(".lead output")
    place.fill(place.get_attribute("max"))
    assert words.inner_text().startswith("parameter 2.000")
    assert "the view stands elsewhere" in words.inner_text()
    place.fill("10")
    assert "elsewhere" not in words.inner_text()
    margin = float(words.inner_text().rpartition("= ")[2])
    assert float(page.page.locator(".lead .gcx-numbers dd").first.inner_text()) == pytest.approx(margin, abs=1e-3)
