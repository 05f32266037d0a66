"""The data of the 3D viewer and the report that holds them: complete, plain, and safe in a page."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from html.parser import HTMLParser
from typing import Any

import pytest
from click.testing import CliRunner
from places import ROOT
from views.viewed_structures import OCTAHEDRAL, STRUCTURES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.load import read_robot
from gcrules.rules.catalog.file import load
from gcrules.screws.pose_text import parse_pose
from gcrules.views.drawing.palette import ROLES
from gcrules.views.report.report_page import in_script
from gcrules.views.report.robot_report import robot_scene
from gcrules.views.report.scene_json import Scenery, drawable, scene

EXAMPLES = ROOT / "examples"
SOURCES = ROOT / "studio-ui" / "src" / "viewer"
OTHER = gc.analyze("Aa Ab Ba Bb Cc Dd")


# --- what Python gives it ------------------------------------------------------------------------------------------


def test_the_palette_is_that_of_the_figures() -> None:
    text = (SOURCES / "palette.ts").read_text(encoding="utf-8")
    found = re.findall(r'^  (\w+): \["(#\w{6})", "(#\w{6})"\],$', text, re.MULTILINE)
    assert {role: (light, dark) for role, light, dark in found} == ROLES


@pytest.mark.parametrize("name", STRUCTURES)
def test_a_scene_is_plain_data(name: str) -> None:
    a = STRUCTURES[name]
    found = scene(a)
    assert json.loads(json.dumps(found, allow_nan=False))["unit"] == (a.platform.units if a.platform else "")
    assert set(found["points"]) == set(a.structure.names) == {*found["base"], *found["platform"]}
    assert [tuple(leg) for leg in found["legs"]] == list(a.structure.oriented)
    assert [e["id"] for e in found["entities"]] == [f"e{i}" for i in range(len(found["entities"]))]
    assert found["size"] > 0
    if a.platform:
        assert all(
            found["points"][n] == pytest.approx([float(c) for c in a.platform.points[n]]) for n in a.structure.names
        )


def test_every_class_has_a_scene() -> None:
    for entry in load().entries[::3]:
        found = scene(gc.analyze(entry.legs))
        assert len(found["legs"]) == 6
        json.dumps(found, allow_nan=False)


@pytest.mark.parametrize("legs", ["ab bc ca ad be cf", "ab bc ca de ef fd"])
def test_lines_without_a_platform_are_drawn_and_stay(legs: str) -> None:
    found = scene(gc.analyze(legs))
    assert "recipe" not in found
    assert found["motion"] is None
    assert len(found["legs"]) == 6


def test_robots_on_six_legs_move_as_platforms() -> None:
    found = robot_scene(analyze_robot(read_robot("gough-stewart")))
    assert len(found["platform"]) == 6
    assert "recipe" in found
    assert "recipe" not in robot_scene(analyze_robot(read_robot("3-rps")))
    shown = gc.view(read_robot("gough-stewart"))
    assert shown.verdict == "regular"
    assert shown.numbers(nearest=False).margin == pytest.approx(shown.margin)


def test_a_pose_moves_the_platform_rigidly() -> None:
    s = Scenery.of(OCTAHEDRAL)
    exact = parse_pose("10 20 -5; euler zyx 30 10 -20 deg")
    at = s.points(exact)
    same = s.points({"translation": [10, 20, -5], "quaternion": exact.unit_quaternion})
    assert s.invented is False
    for n in OCTAHEDRAL.structure.names:
        assert at[n] == pytest.approx(same[n])
    assert all(at[n] == s.points()[n] for n in OCTAHEDRAL.structure.base)
    middle = [sum(at[n][i] for n in "bdf") / 3 for i in range(3)]
    assert middle == pytest.approx([float(c) + t for c, t in zip(s.about, (10, 20, -5), strict=True)])
    assert math.dist(at["b"], at["d"]) == pytest.approx(math.dist(s.points()["b"], s.points()["d"]))


def test_planes_that_meet_have_their_point_drawn_and_the_motion() -> None:
    found = scene(STRUCTURES["octahedral-singular"])
    (point,) = found["constructed"]
    assert point["label"] == "M"
    assert point["at"] == pytest.approx((19500 / 43, -400 / 43, 18000 / 43))
    assert len(point["entities"]) == 4
    assert found["motion"]["pitch"] == pytest.approx(134.516, abs=1e-3)
    assert scene(OCTAHEDRAL)["motion"] is None


def test_named_lines_are_constructed() -> None:
    found = scene(OTHER)
    p: Any
    q: Any
    p, q = found["constructed"]
    assert [p["label"], q["label"]] == ["p", "q"]
    a, b = (found["points"][n] for n in "AB")
    along = [y - x for x, y in zip(a, b, strict=True)]
    assert sum(x * y for x, y in zip(along, p["direction"], strict=True)) ** 2 == pytest.approx(math.hypot(*along) ** 2)


@pytest.mark.parametrize("options", [{"given": "coplanar(A, B, C, D)"}, {"ideal": "A"}], ids=["given", "ideal"])
def test_what_has_no_shape_is_not_drawn(options: dict[str, str]) -> None:
    a = gc.analyze("Aa Ab Bc Bd Ce Df", **options)
    assert not drawable(a)
    assert "GcrulesViewer" not in gc.report(a)
    with pytest.raises(InputError, match="no robot to draw"):
        scene(a)


# --- the report as text --------------------------------------------------------------------------------------------

EVIL = "</script><script>alert(1)</script><!-- <ScRiPt ]]> \u2028 &amp; \"'"


class Scripts(HTMLParser):
    """The scripts of a page as a browser reads them, and what is loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.scripts: list[list[str]] = []
        self.loaded: list[str] = []
        self.inside = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        named = (v or "" for k, v in attrs if k in ("src", "href"))
        self.loaded += [v for v in named if not v.startswith(("#", "data:"))]
        self.inside = tag == "script"
        if self.inside:
            self.scripts.append([""])

    def handle_endtag(self, tag: str) -> None:
        self.inside = False

    def handle_data(self, data: str) -> None:
        if self.inside:
            self.scripts[-1].append(data)


def test_data_in_a_script_cannot_end_it() -> None:
    text = in_script({"title": EVIL, "values": [1.5, None]})
    assert "<" not in text
    assert "\u2028" not in text
    assert json.loads(text) == {"title": EVIL, "values": [1.5, None]}


def _platform(**changes: str) -> gc.Platform:
    given = OCTAHEDRAL.platform
    assert given is not None
    return gc.Platform(given.legs, given.points, **changes)


def test_hostile_titles_stay_text() -> None:
    page = gc.report(gc.analyze(_platform(title=EVIL, note=EVIL)))
    parser = Scripts()
    parser.feed(page)
    assert len(parser.scripts) == 3
    assert json.loads("".join(parser.scripts[0])) == json.loads(json.dumps(scene(gc.analyze(_platform()))))
    assert not parser.loaded


def test_a_small_report_has_no_scripts() -> None:
    page = gc.report(OCTAHEDRAL, interactive=False)
    assert "<script" not in page
    assert len(page) < 150_000 < 500_000 < len(gc.report(OCTAHEDRAL))


@pytest.mark.parametrize("name", ["3-rps", "gallardo-4dof", "delta", "3-rpr", "gough-stewart"])
def test_reports_of_robots(name: str) -> None:
    a = analyze_robot(read_robot(name))
    page = gc.report(a, interactive=False)
    parser = Scripts()
    parser.feed(page)
    assert not parser.loaded
    assert not parser.scripts
    for words in (a.statement, a.certificate, *(limb.limb.name for limb in a.structure.limbs)):
        assert words.replace("&", "&amp;") in page
    assert page.count('class="formula"') >= 1 + len(a.parts)


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["3-rps", "--no-3d"], 0, "<title>3-RPS robot"),
        ([str(ROOT / "plugins" / "gallardo-4dof" / "robot.yaml"), "--no-3d"], 0, "<title>Four-DOF robot"),
        (["3-rps", "--rank", "3"], 2, "A robot of joints takes"),
        (["3-rpz"], 2, "'3-rpz' is neither a file, nor the id of a robot"),
        (["ab"], 2, "leg"),
    ],
    ids=["id", "file", "options", "typing error", "one leg"],
)
def test_the_command(arguments: list[str], code: int, said: str) -> None:
    result = CliRunner().invoke(cli, ["report", *arguments])
    assert result.exit_code == code
    assert said in (result.stderr if code else result.stdout)


def test_a_report_takes_what_load_takes() -> None:
    page = gc.report("ab af cb cd ed ef", interactive=False)
    assert page == gc.report(gc.analyze("ab af cb cd ed ef"), interactive=False)
    with pytest.raises(InputError, match="is neither a file, nor the id"):
        gc.report("3-rsp")


@pytest.mark.parametrize("ask", [gc.analyze, gc.view], ids=["analyze", "view"])
def test_a_file_is_taken_where_legs_are(ask: Callable[[str], object]) -> None:
    assert ask(str(EXAMPLES / "octahedral.yaml"))
