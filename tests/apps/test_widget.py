"""The widget: it follows the pose from both sides and warns."""

from __future__ import annotations

import sys
from typing import Any

import pytest
from places import ROOT
from views.viewed_structures import OCTAHEDRAL

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.load import read_robot
from gcrules.views.report.scene_json import scene
from gcrules.views.viewer import viewer_script

EXAMPLES = ROOT / "examples"


# --- the widget ----------------------------------------------------------------------------------------------------


def test_a_widget_follows_the_pose_from_both_sides() -> None:
    platform = load_platform(EXAMPLES / "octahedral.yaml")
    shown: Any = gc.view(platform)
    assert shown.scene == scene(OCTAHEDRAL)
    assert shown.verdict == "regular"
    heard: list[float] = []
    shown.observe(lambda change: heard.append(change["new"]), "margin")
    shown.pose = "1 2 10 mm; euler zyx 30 0 0 deg"
    assert shown.pose["translation"] == [1, 2, 10]
    assert heard == [shown.margin]
    there = gc.pose(platform, "1 2 10; euler zyx 30 0 0 deg", about="centroid", nearest=False)
    assert shown.margin == pytest.approx(there.margin)
    assert shown.numbers(nearest=False).margin == pytest.approx(there.margin)
    shown.set_state({"pose": {"translation": [0, 0, 5], "quaternion": [2, 0, 0, 0]}})  # what the page sends
    assert shown.pose == {"translation": [0, 0, 5], "quaternion": [1, 0, 0, 0]}


def test_a_widget_warns() -> None:
    shown = gc.view(load_platform(EXAMPLES / "octahedral-singular.yaml"))
    assert shown.verdict == "singular"


NAN = {"translation": [0, 0, float("nan")], "quaternion": [1, 0, 0, 0]}
LENGTHS = {"translation": [0, 0], "quaternion": [1, 0, 0, 0, 0]}
NO_TURN = {"translation": [0, 0, 0], "quaternion": [0, 0, 0, 0]}


@pytest.mark.parametrize("pose", [{}, 3, "1 2", LENGTHS, NAN, NO_TURN], ids=str)
def test_no_pose(pose: Any) -> None:
    with pytest.raises(InputError):
        gc.view("ab af cb cd ed ef", pose=pose)


def test_a_widget_of_a_robot_stays_at_home() -> None:
    shown = gc.view(read_robot("3-rps"))
    assert shown.margin is None
    assert len(shown.scene["limbs"]) == 3
    with pytest.raises(InputError, match="legs and coordinates"):
        shown.numbers()


def test_without_the_extra_a_widget_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "anywidget", None)
    monkeypatch.delitem(sys.modules, "gcrules.apps.notebook.widget", raising=False)
    with pytest.raises(InputError, match="needs the package anywidget") as fault:
        gc.view("ab af cb cd ed ef")
    assert fault.value.hint == 'pip install "gcrules[widget]"'


LAB = """.cell dl { display: block; margin: 1em 0; } .cell dt { float: left; width: 20%; font-weight: bold; }
.cell dd { float: left; width: 80%; margin: 0; }"""
"""What JupyterLab 4 does to lists of terms in the output of a cell."""


@pytest.mark.browser
def test_numbers_stand_beside_their_names_in_a_notebook(chromium: Any) -> None:
    page = chromium.new_page(viewport={"width": 1000, "height": 700})
    page.set_content(f"<style>{LAB}</style><div class=cell style='height: 600px'></div>")
    page.add_script_tag(content=viewer_script())
    page.evaluate("scene => GcrulesViewer.explore(document.querySelector('.cell'), scene)", scene(OCTAHEDRAL))
    names, numbers = ([e.bounding_box() for e in page.locator(f".gcx-numbers {tag}").all()] for tag in ("dt", "dd"))
    assert len(names) == len(numbers) == 2
    for name, number in zip(names, numbers, strict=True):
        assert abs(name["y"] - number["y"]) < 3
        assert number["x"] >= name["x"] + name["width"]
    assert "determinant of the six lines" in page.locator(".gcx-meaning").inner_text()
    page.close()


def test_a_widget_of_a_file_is_that_of_its_platform() -> None:
    path = EXAMPLES / "octahedral.yaml"
    assert gc.view(str(path)).scene == gc.view(load_platform(path)).scene
