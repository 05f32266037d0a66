"""What is said of a home configuration that is singular, of published conditions, and in which number verbs stand."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner
from commands import assert_refused

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.english import agreeing, listed, of_kind
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.remark import home_remark
from gcrules.rules.plugin import shipped_folder

ROBOTS = [one.id for one in robots(())]


def shipped(name: str) -> str:
    folder = shipped_folder()
    assert folder is not None
    return (folder / name / "robot.yaml").read_text(encoding="utf-8")


def changed(name: str, places: Mapping[str, str]) -> str:
    """The text of a robot's file with other coordinates at home."""
    lines = shipped(name).splitlines()
    for point, place in places.items():
        at = next(i for i, line in enumerate(lines) if line.startswith(f"  {point}: ["))
        lines[at] = f"  {point}: {place}"
    return "\n".join(lines) + "\n"


STRAIGHT = {"B1": "[2, 3/2, 0]", "B2": "[8, 3/2, 0]", "B3": "[5, 7, 0]"}
FLAT = {"S1": "[1, 0, 0]", "S2": "[-1/2, 1, 0]", "S3": "[-1/2, -1, 0]"}
NEARLY_FLAT = {n: place.replace("0]", "0.001]") for n, place in FLAT.items()}

HOMES = {
    "flat": ("3-rps", FLAT, "home is singular: the planes of leg 1", "the platform gains 3 independent motions"),
    "nearly": ("3-rps", NEARLY_FLAT, "home is close to singular (margin 0.0006", "nearly: the planes of leg 1"),
    "one leg": (
        "3-rrr",
        {n: STRAIGHT[n] for n in ("B1",)},
        "home is singular: leg 1 is singular by itself: its own twists depend on each other",
        "",
    ),
    "two legs": (
        "3-rrr",
        {n: STRAIGHT[n] for n in ("B1", "B2")},
        "leg 1 and leg 2 are singular by themselves: the twists of each depend on each other",
        "",
    ),
    "three legs": (
        "3-rrr",
        STRAIGHT | {"B3": "[11/2, 7, 0]", "C3": "[6, 5, 0]"},
        "leg 1, leg 2 and leg 3 are singular by themselves",
        "",
    ),
    "one motion": (
        "3-rrr",
        STRAIGHT,
        "home is singular: the lines B1C1, B2C2 and B3C3 meet in a point",
        "; the platform can turn about the line through (5, 3.75, 0) along (0, 0, 1), which no limb resists",
    ),
}


@pytest.mark.parametrize(("name", "places", "says", "more"), HOMES.values(), ids=HOMES)
def test_a_singular_home_is_said_to_be_one(
    name: str, places: Mapping[str, str], says: str, more: str, tmp_path: Path
) -> None:
    path = tmp_path / "robot.yaml"
    path.write_text(changed(name, places), encoding="utf-8")
    remark = home_remark(analyze_robot(read_robot(path)))
    assert says in remark
    assert more in remark
    checked = CliRunner().invoke(cli, ["robot", "check", str(path)])
    assert checked.exit_code == 0, checked.output
    assert f"  warning: {remark}\n" in checked.stdout
    for command in (["robot", "analyze"], ["analyze"]):
        done = CliRunner().invoke(cli, [*command, str(path), "--json"])
        assert done.exit_code == 0
        assert done.stderr == f"warning: {remark}\n"


@pytest.mark.parametrize("name", ROBOTS)
def test_shipped_homes_are_regular(name: str) -> None:
    assert home_remark(analyze_robot(read_robot(name))) == ""


# --- homes far from the origin --------------------------------------------------------------------------------------


def moved(name: str, shift: int) -> str:
    """The text of a robot's file with the points of its home, but not its directions, shifted along x."""
    robot = parse_robot(shipped(name))
    points = {d.name for d in robot.family.definitions if d.sort == "point"}
    assert robot.home is not None
    places = {n: [Fraction(c) for c in v] for n, v in robot.home.items()}
    return changed(
        name,
        {
            n: "[" + ", ".join(str(c + shift * (k == 0)) for k, c in enumerate(v)) + "]"
            for n, v in places.items()
            if n in points
        },
    )


@pytest.mark.parametrize("name", ["orthoglide", "delta"])
def test_the_margin_at_a_home_far_from_the_origin(name: str) -> None:
    expected = gc.pose(name, nearest=False).margin
    for shift in (1_000, -100_000, 10**9, 10**25):
        found = gc.pose(parse_robot(moved(name, shift)), nearest=False)
        assert found.margin == pytest.approx(expected, rel=0, abs=1e-10)
        assert any(note.startswith("all places are measured from (") for note in found.notes) == (abs(shift) > 1000)


# --- published conditions -------------------------------------------------------------------------------------------

BRACKETS = "[S1A1B1C1] [S1S3A3B3] [S1S3S2A2]"
FACTORS = ["1", "-1", "2", "1/2", "-1/2", "-3/7", "1/3", "2000000000001", "1/2000000000001", "-22/7"]


@pytest.mark.parametrize("factor", FACTORS)
def test_the_factor_of_a_published_condition(factor: str) -> None:
    text = shipped("gallardo-4dof").replace(f'"{BRACKETS}"', f'"{factor} {BRACKETS}"')
    published = analyze_robot(parse_robot(text)).published
    assert published is not None
    assert published.verdict == "proved"
    assert (
        published.detail == f"the superbracket is {1 / Fraction(factor)} times it: both sides have the same normal form"
    )


def test_at_half() -> None:
    superbracket = analyze_robot(read_robot("3-rps")).lines
    assert superbracket is not None
    text = f'{shipped("3-rps")}condition: "-2 {superbracket.structure.superbracket}"\n'
    published = analyze_robot(parse_robot(text)).published
    assert published is not None
    assert published.detail.startswith("the superbracket is -1/2 times it")


# --- lists and verbs ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("names", "said"),
    [(["a"], "a is"), (["a", "a"], "a is"), (["a", "b"], "a and b are"), (["a", "b", "c"], "a, b and c are")],
)
def test_verbs_agree_with_lists(names: list[str], said: str) -> None:
    assert agreeing(names, "is", "are") == said
    assert listed(names) == said.rpartition(" ")[0]


@pytest.mark.parametrize(("names", "said"), [([], ""), (["a"], "the plane a"), (["a", "b"], "the planes a and b")])
def test_kinds(names: list[str], said: str) -> None:
    assert of_kind("plane", names) == said


def test_coordinates_that_do_not_determine_the_pose() -> None:
    done = CliRunner().invoke(cli, ["robot", "pose", "3-rps", "--at", "yaw=1deg, x=0, y=0"])
    assert_refused(done, 2, "yaw, x and y do not determine the pose of 3-rps near home")


def test_lengths_in_another_unit_than_directions_are_named_as_a_cause() -> None:
    """Delta with joints ten million times as close together, and its bars as long as before."""
    home = {
        name: ([Fraction(c) / 10**7 for c in place] if name[0] in "OAB" else place)
        for name, place in yaml.safe_load(shipped("delta"))["home"].items()
    }
    text = shipped("delta").partition("home:")[0] + "home:\n"
    text += "".join(f"  {name}: [{', '.join(map(str, place))}]\n" for name, place in home.items())
    for asked in ({"x": 0, "y": 0, "z": 0}, {"x": 0}):
        with pytest.raises(gc.InputError, match="no 3 coordinates determine the pose") as fault:
            gc.pose(gc.load(text), asked, nearest=False)
        assert "Directions count where bars lie along them" in fault.value.render()
