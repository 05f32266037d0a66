"""Robot files with a configuration for drawings: its faults, what is drawn in it, and changes of the file."""

from __future__ import annotations

from dataclasses import replace

import pytest
from mechanisms.shipped_robots import GOOD

import gcrules as gc
from gcrules.apps.studio.gallery import _of_limbs as of_limbs
from gcrules.apps.studio.gallery import gallery
from gcrules.apps.studio.limb_editor import limbs_answer
from gcrules.core.errors import FileError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.editing.edits import Edit, edited
from gcrules.mechanisms.editing.reading import read_sheet
from gcrules.mechanisms.editing.robot_text import home_changed, refitted
from gcrules.mechanisms.editing.writing import rewritten
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.load import load
from gcrules.poses.modes.choose import in_mode
from gcrules.screws import RATIONALS
from gcrules.views.figure import figure
from gcrules.views.pages.robot_pages import robot_pages
from gcrules.views.robots.robot_drawing import draw_robot, robot_thumbnail

HOME = f"""{GOOD}home:
  A1: [4, 0, 0]
  A2: [-2, 3, 0]
  A3: [-2, -3, 0]
  S1: [2, 0, 5]
  S2: [-1, 1.5, 5]
  S3: [-1, -1.5, 5]
  r1: [0, 1, 0]
  r2: [3, 2, 0]
  r3: [3, -2, 0]
"""
FILE = f"""{HOME}drawing: # wider
  S1: [3, 0, 4]
  S2: [-1.5, 2.25, 4]
"""


def changed(text: str, edit: Edit) -> str:
    placed = read_sheet(text)
    return rewritten(text, placed, refitted(text, placed, edited(placed.sheet, edit))[0])


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        (FILE.replace("S1: [3, 0, 4]", "S1: [3, 1, 4]"), "23:7", "in the drawing S1 is not as its relation says"),
        (FILE.replace("S1: [3, 0, 4]", "T1: [3, 0, 4]"), "23:3", "T1 is not defined"),
        (FILE.replace("S1: [3, 0, 4]", "S1: [3, 0]"), "23:7", "a list of 2, expected 3"),
        (
            FILE.replace("S1: [3, 0, 4]", "S1: [4, 0, 0]"),
            "23:3",
            "is in the same place as another point in the drawing",
        ),
        (f"{HOME}drawing: {{r1: [0, 0, 0]}}\n", "22:15", "the direction r1 is zero in the drawing"),
        (FILE.replace(HOME[HOME.index("home:") :], ""), "13:3", "there is no home"),
    ],
)
def test_faults_have_their_places(text: str, place: str, message: str) -> None:
    with pytest.raises(FileError) as caught:
        parse_robot(text)
    assert message in str(caught.value)
    assert f":{place}" in caught.value.render()


def test_what_a_drawing_leaves_out_is_as_at_home() -> None:
    robot = parse_robot(FILE)
    home, drawn = robot.values_at(), robot.values_at(robot.drawing)
    assert {n for n in home if home[n] != drawn[n]} == {"S1", "S2"}


def test_figures_are_drawn_in_it_and_say_so() -> None:
    robot = parse_robot(FILE, name="mine")
    a, plain = analyze_robot(robot), analyze_robot(replace(robot, drawing=None))
    there = robot.values_at(robot.drawing)
    assert figure(a).svg() == draw_robot(a).svg()
    assert draw_robot(a).svg() != draw_robot(a, there).svg()  # which does not say why
    assert "in a configuration chosen for drawings" in draw_robot(a).svg()
    assert "chosen" not in draw_robot(a, there).svg() + draw_robot(plain).svg()
    assert draw_robot(plain).svg() == draw_robot(a, robot.values_at()).svg()
    assert robot_thumbnail(a).svg() == robot_thumbnail(a, there).svg() != robot_thumbnail(plain).svg()
    page, old = robot_pages([robot])["mine.md"], robot_pages([replace(robot, drawing=None)])["mine.md"]
    assert "the robot in a configuration chosen for the drawing, with the wrenches" in page
    assert "That configuration is not home" in page
    assert "The wrenches have full rank in it." in page
    assert "the robot at home, with the wrenches" in old
    assert "chosen" not in old


def test_a_page_says_when_the_drawing_is_singular() -> None:
    robot = parse_robot(f"{HOME}drawing:\n  S1: [6, 0, 0]\n  S2: [-3, 4.5, 0]\n  S3: [-3, -4.5, 0]\n")
    assert "It is singular: the wrenches lose rank in it." in robot_pages([robot])["robot.md"]


def test_poses_keep_to_home() -> None:
    robot = parse_robot(FILE)
    assert gc.pose(robot).margin == gc.pose(parse_robot(HOME)).margin


def test_another_mode_is_drawn_at_its_own_home() -> None:
    robot = in_mode(load("delta"), "-++")
    assert robot.drawing is None
    assert robot.home != load("delta").home


@pytest.mark.parametrize("name", ["3-rrr-spherical", "4-ruu", "delta", "exechon"])
def test_shipped_drawings_are_not_singular(name: str) -> None:
    robot = gc.analyze(name).robot
    assert robot.drawing is not None
    assert ranks(robot.family, robot.limbs, robot.values_at(robot.drawing), RATIONALS).wrenches == 6


def test_arms_and_rods_of_the_drawn_delta_are_equally_long() -> None:
    robot = gc.analyze("delta").robot
    at = {n: [float(c) for c in v] for n, v in robot.values_at(robot.drawing).items()}
    for first, second in (("O", "A"), ("A", "B")):
        lengths = [
            sum((p - q) ** 2 for p, q in zip(at[f"{first}{k}"], at[f"{second}{k}"], strict=True)) ** 0.5
            for k in (1, 2, 3)
        ]
        assert lengths == pytest.approx([lengths[0]] * 3, rel=0.01)


def test_thumbnails_of_the_studio() -> None:
    robot = gc.analyze("delta").robot
    (card,) = (one for one in gallery()["robots"] if one["id"] == "delta")
    assert card["svg"] == of_limbs(robot) != of_limbs(replace(robot, drawing=None))


def test_changes_of_limbs_keep_it() -> None:
    assert changed(FILE, Edit("title", text="Mine")) == FILE.replace("three legs", "Mine")
    renamed = changed(FILE, Edit("name rename", name="S%", text="B%"))
    assert renamed == FILE.replace("S1", "B1").replace("S2", "B2").replace("S3", "B3").replace("S%", "B%")
    single = parse_robot(changed(FILE, Edit("limb single")))
    assert single.drawing == parse_robot(FILE).drawing
    turned = home_changed(FILE, "robot.yaml", {"r1": ("1", "1", "")})
    robot = parse_robot(turned)
    assert robot.drawing is not None
    assert robot.drawing["S1"] != parse_robot(FILE).drawing["S1"]
    assert robot.drawing["S2"] == parse_robot(FILE).drawing["S2"]


def test_another_number_of_copies_has_no_drawing() -> None:
    text = changed(FILE, Edit("copies", to=4)).replace("mobility: 3", "mobility: 2")
    assert "drawing" not in text


def test_the_limb_editor_tells_its_faults() -> None:
    view = limbs_answer(FILE.replace("S1: [3, 0, 4]", "S1: [3, 1, 4]"))
    assert "in the drawing S1 is not as its relation says" in str(view)
