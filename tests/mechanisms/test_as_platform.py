"""Robots described by their joints that are six legs: every command about platforms takes them."""

from __future__ import annotations

import json
from typing import Any

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.apps.studio.subject import read_subject
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.methods import on_six_legs

LEGS = ("gough-stewart", "gough-stewart-63", "octahedral")
COMMANDS = {
    "pose": ["--accuracy", "0.01", "--no-nearest", "--at", "0 0 1; euler zyx 20 0 10 deg"],
    "path": ["--at", "0 0 0", "--at", "0 0 1; euler zyx 20 0 10 deg", "--samples", "4"],
    "map": ["--over", "x -1:1:4", "--over", "rz -40:40:4 deg"],
    "locus": ["--over", "translation"],
}


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, list(arguments), input=text)


@pytest.mark.parametrize("name", LEGS)
def test_legs_are_those_at_home(name: str) -> None:
    robot = read_robot(name)
    platform = as_platform(robot)
    assert len(platform.legs) == 6
    assert {end for _, end in platform.legs} == set(robot.platform)
    assert all(platform.points[n] == robot.home[n] for leg in platform.legs for n in leg)


@pytest.mark.parametrize("name", LEGS)
def test_both_ways_to_a_pose_agree(name: str) -> None:
    """The same wrenches: the platform's numbers, and those of the robot whose joints are solved."""
    at = "0.3 0.2 0.5; euler zyx 20 0 10 deg"
    robot = read_robot(name)
    one, other = gc.pose(robot, at, nearest=False), gc.pose(as_platform(robot), at, nearest=False)
    assert one.margin == pytest.approx(other.margin, rel=1e-9)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("name", LEGS)
def test_commands_take_an_id(command: str, name: str) -> None:
    done = run(command, name, *COMMANDS[command], "--json")
    assert done.exit_code == 0, done.stderr
    answer = json.loads(done.stdout)
    centre = [float(c) for c in answer["about"]]
    assert centre[2] == pytest.approx(4 if name == "octahedral" else 5)  # the centroid, as for "gcrules robot pose"


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_take_a_centre(command: str) -> None:
    origin = run(command, "octahedral", *COMMANDS[command], "--json", "--about", "origin")
    assert [float(c) for c in json.loads(origin.stdout)["about"]] == [0, 0, 0]


@pytest.mark.parametrize("name", [r.id for r in robots() if r.id not in LEGS])
def test_others_are_refused_with_the_reason(name: str) -> None:
    with pytest.raises(
        InputError, match=f"{name} is described by its joints and cannot be read as a platform"
    ) as fault:
        on_six_legs(mechanism(name), "a locus")
    assert f"gcrules robot pose {name}" in fault.value.render()


def test_what_is_for_six_legs_refuses_other_robots() -> None:
    done = run("pose", "3-rps", *COMMANDS["pose"])
    assert done.exit_code == 2
    assert "it has 3 limbs, not six" in done.stderr


def test_a_robot_from_standard_input(root: Any) -> None:
    text = (root / "plugins" / "octahedral" / "robot.yaml").read_text(encoding="utf-8")
    said = run("locus", "-", *COMMANDS["locus"], text=text).stdout
    assert said == run("locus", "octahedral", *COMMANDS["locus"]).stdout


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"P*(A1 B1)": "P*(A1 B2)"}, "not a leg"),
        ({"B1: free": "B1: on line A1 along x", "B1: [1, 2, 4]": "B1: [1, 0, 0]"}, "depends on the other body"),
    ],
    ids=["another limb's direction", "tied"],
)
def test_what_is_no_leg(root: Any, changes: dict[str, str], says: str) -> None:
    text = (root / "plugins" / "octahedral" / "robot.yaml").read_text(encoding="utf-8")
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(InputError, match=says):
        as_platform(parse_robot(text))


def test_a_slide_may_have_an_axis_of_its_own_name(root: Any) -> None:
    """The leg's force runs through its ends whatever the direction of the slide: every road says so."""
    text = (root / "plugins" / "octahedral" / "robot.yaml").read_text(encoding="utf-8")
    named = text.replace("P*(A1 B1)", "P*(w1)").replace("directions:\n", "directions:\n  w1: along A1 B1\n")
    assert named != text
    one, two = as_platform(parse_robot(text)), as_platform(parse_robot(named))
    assert (one.legs, one.points) == (two.legs, two.points)
    subject = read_subject({"kind": "file", "name": "robot.yaml", "text": named})
    assert subject.moving is not None
    assert subject.moving.legs == one.legs
    at = "z=0.2, roll=5deg"
    found = [gc.pose(source, at, nearest=False).margin for source in (gc.load(named), one)]
    assert found[0] == pytest.approx(found[1], rel=1e-9)


def test_a_robot_that_is_given_by_its_lines() -> None:
    """Six lines between points that hold all six freedoms are six legs; of fewer freedoms some are constraints."""
    lines: dict[str, Any] = {
        "title": "A platform as lines",
        "points": dict.fromkeys("ABCabc", "free"),
        "lines": "Aa Ab Bb Bc Cc Ca",
        "mobility": 6,
        "home": {"A": [0, 0, 0], "B": [3, 0, 0], "C": [0, 3, 0], "a": [1, 0, 2], "b": [2, 0, 2], "c": [1, 2, 3]},
    }
    assert on_six_legs(mechanism(lines), "a path").bodies == {"base": ("A", "B", "C"), "platform": ("a", "b", "c")}
    with pytest.raises(InputError, match="it has no limbs, not six"):
        on_six_legs(mechanism(lines | {"mobility": 4}), "a path")
