"""Working modes: against closed forms, the family that a file describes, and the lengths of all bodies."""

from __future__ import annotations

import itertools
import json
import math
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.modes.limb_solutions import limb_solutions
from gcrules.mechanisms.modes.working_modes import LimbChoices, choices_of, in_working_mode
from gcrules.mechanisms.robot import Robot
from gcrules.poses.modes import working

# Of each robot how many ways its limbs have: an elbow gives two, a leg whose length is driven one.
WAYS = {
    "3-rps": (1, 1, 1),
    "3-prs": (2, 2, 2),
    "3-rrr": (2, 2, 2),
    "3-rpr": (1, 1, 1),
    "3-rrr-spherical": (2, 2, 2),
    "agile-eye": (2, 2, 2),
    "delta": (2, 2, 2),
    "orthoglide": (2, 2, 2),
    "4-ruu": (2, 2, 2, 2),
    "6-rus": (2,) * 6,
    "6-pus": (2,) * 6,
    "3-uru": (4, 4, 4),
    "5r": (2, 1),
    "gough-stewart": (1,) * 6,
    "8-cables": (1,) * 8,
    "gantry-tau": (2, 2, 2),
    "h4": (4, 4),
    "par4": (16,),
    "tricept": (1, 1, 1, 1),
}


@cache
def choices(name: str) -> LimbChoices:
    robot = gc.load(name)
    assert isinstance(robot, Robot)
    return choices_of(robot)


@pytest.mark.parametrize("name", WAYS)
def test_each_limb_has_the_ways_of_its_kind(name: str) -> None:
    assert tuple(len(limb) for limb in choices(name).limbs) == WAYS[name]


@pytest.mark.parametrize("name", ["3-rrr", "delta", "3-rrr-spherical", "3-prs", "6-rus", "5-rpur", "h4", "gantry-tau"])
def test_every_mode_is_the_same_robot(name: str) -> None:
    """Points that move with one link keep their distances, directions their angles; the platform stays where it is."""
    found = choices(name)
    before = linkage(found.linkage.robot)
    for mode in itertools.islice(found.modes(), 12):
        after = linkage(in_working_mode(found, mode))
        links: dict[tuple[int, int], list[str]] = {}
        for n, own in before.attachments.items():
            for a in own:
                links.setdefault((a.limb, a.link), []).append(n)
        sorts = before.robot.family.sorts
        for names in links.values():
            points = [n for n in names if sorts.get(n) == "point"]
            for p, q in itertools.combinations(points, 2):
                lengths = [np.linalg.norm(m.home.values[p] - m.home.values[q]) for m in (before, after)]
                assert lengths[0] == pytest.approx(lengths[1], abs=1e-9)
            for p, q in itertools.combinations([n for n in names if n not in points], 2):
                cosines = [_cosine(m.home.values[p], m.home.values[q]) for m in (before, after)]
                assert cosines[0] == pytest.approx(cosines[1], abs=1e-9)
        for n in before.robot.platform:
            if sorts.get(n) == "point":
                assert after.home.values[n] == pytest.approx(before.home.values[n], abs=1e-12)


def _cosine(u: np.ndarray, v: np.ndarray) -> float:
    return float(u @ v / np.linalg.norm(u) / np.linalg.norm(v))


def test_planar_elbows_are_the_meets_of_two_circles() -> None:
    """Closed form: the elbow B is one of the two points at its distances from A and C, exactly."""
    found = choices("3-rrr")
    home = found.linkage.robot.values_at()
    for k in (1, 2, 3):
        a, b, c = ([Fraction(x) for x in home[f"{n}{k}"][:2]] for n in "ABC")
        along = [c[i] - a[i] for i in (0, 1)]
        part = sum((b[i] - a[i]) * along[i] for i in (0, 1)) / sum(x * x for x in along)
        mirrored = [2 * (a[i] + part * along[i]) - b[i] for i in (0, 1)]
        mode = tuple(int(n == k) for n in (1, 2, 3))
        other = in_working_mode(found, mode).values_at()
        assert list(other[f"B{k}"][:2]) == mirrored
        assert [other[f"B{n}"] == home[f"B{n}"] for n in (1, 2, 3)] == [n != k for n in (1, 2, 3)]


def test_arms_of_delta_turn_to_the_other_meet_of_circle_and_sphere() -> None:
    """Closed form: a cos q + b sin q = a for the end of the arm on its circle, at its distance from the platform."""
    found = gc.working_modes("delta")
    m = choices("delta").linkage
    values = m.home.values
    for k, actuator in enumerate(m.actuators, 1):
        joint, bars = m.robot.limbs[k - 1].joints
        centre, axis = (values[arg[0][1]] for arg in joint.args)
        (start, end) = (values[bars.args[0][0][1]], values[bars.args[2][0][1]])
        axis = axis / np.linalg.norm(axis)
        far = start + end
        arm = start - centre
        flat = arm - axis * (axis @ arm)
        across = np.cross(axis, flat)
        e = far - centre - axis * (axis @ arm)
        # |e − flat cos q − across sin q| is the same at q and at 0
        a, b = -2 * e @ flat, -2 * e @ across
        q = 2 * math.atan2(b, a)
        mode = next(one for one in found.modes if one.name == "".join("-" if n == k else "+" for n in (1, 2, 3)))
        assert math.remainder(mode.offsets[actuator.name] - q, math.tau) == pytest.approx(0, abs=1e-9)


def test_modes_have_the_numbers_of_the_robot_in_them() -> None:
    pose = "x=0.5, y=0, yaw=10deg"
    found = gc.working_modes("3-rrr", pose)
    assert [mode.name for mode in found.modes] == ["+++", "++-", "+-+", "+--", "-++", "-+-", "--+", "---"]
    for mode in found.modes:
        alone = gc.pose(gc.load("3-rrr", mode=mode.name), pose, nearest=False)
        assert mode.pose is not None
        assert (mode.pose.verdict, mode.pose.margin) == (alone.verdict, pytest.approx(alone.margin, abs=1e-12))


def test_the_locus_vanishes_where_a_way_in_any_mode_crosses() -> None:
    """Two roads: the exact polynomial over all modes at once, and the sign of the determinant along a way in each."""
    (part,) = gc.locus("3-rrr", over="x", at="y=0, yaw=0deg").parts
    crossed = {}
    for name in ("+++", "++-", "+-+", "+--", "-++", "-+-", "--+", "---"):
        way = gc.path(gc.load("3-rrr", mode=name), ["home", "x=2, y=0, yaw=0deg"], samples=8)
        for crossing in way.crossings:
            low, high = (part.form([2 * Fraction(end)]) for end in (crossing.lower, crossing.upper))
            assert low * high < 0
            crossed[name] = crossing.coordinates[0]
    assert set(crossed) == {"++-", "+--", "--+", "---"}


def test_exact_where_it_can_be() -> None:
    """The other solution of a quadratic equation with rational coefficients and one rational root is rational."""
    for name in ("3-rrr", "delta", "3-rrr-spherical", "6-rus", "3-prs"):
        for mode in itertools.islice(choices(name).modes(), 8):
            home = in_working_mode(choices(name), mode).home
            assert home is not None
            assert max(Fraction(c).denominator for v in home.values() for c in v) <= 10**6


def test_more_solutions_than_can_be_told_apart_have_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    several, two = (choices(name).linkage for name in ("3-uru", "delta"))
    monkeypatch.setattr("gcrules.mechanisms.modes.limb_solutions.MOST", 2)
    assert limb_solutions(several, 0).moving
    assert not limb_solutions(two, 0).moving


@pytest.mark.parametrize(
    ("source", "mode", "said"),
    [
        ("delta", "+-", "the mode +- has 2 parts, and delta has 3 limbs"),
        ("delta", "++x", "'++x' names no mode"),
        ("delta", "1.3.1", "1.3.1 is not a working mode of delta: at home 2 ways of arm 2"),
        ("3-rps", "+-+", "+-+ is not a working mode of 3-rps: at home only this one way of leg 2"),
        ("examples/octahedral.yaml", "+", "legs between two points have only one way to hold"),
        ("ab af cb cd ed ef", "+", "legs between two points have only one way to hold"),
    ],
)
def test_what_is_no_mode_is_refused(source: str, mode: str, said: str) -> None:
    result = CliRunner().invoke(cli, ["pose", source, "--mode", mode])
    assert (result.exit_code, said in result.stderr.replace("\n", " ")) == (2, True), result.stderr


@pytest.mark.parametrize("name", ["home", "+++", "1.1.1", " +++ ", "−++", "2.1.1"])
def test_signs_and_numbers_name_modes(name: str) -> None:
    found = gc.load("delta", mode=name)
    assert isinstance(found, Robot)
    assert found.title.endswith("working mode -++") == (name in ("−++", "2.1.1"))


@pytest.mark.parametrize(
    "words",
    [
        ["analyze", "3-rrr", "--mode", "-++", "--json"],
        ["pose", "3-rrr", "--mode", "-++", "--no-nearest", "--json"],
        ["robot", "pose", "3-rrr", "--mode", "-++", "--no-nearest", "--json"],
        ["path", "3-rrr", "--mode", "-++", "--at", "home", "--at", "x=0.1, y=0, yaw=0deg", "--json"],
        ["locus", "3-rrr", "--mode", "-++", "--over", "x", "--json"],
        ["export", "3-rrr", "--mode", "-++", "--language", "python"],
        ["map", "3-rrr", "--mode", "-++", "--over", "x -0.1:0.1:3", "--over", "y -0.1:0.1:3", "--json"],
    ],
    ids=lambda words: words[0],
)
def test_every_command_about_robots_takes_a_mode(words: list[str]) -> None:
    result = CliRunner().invoke(cli, words)
    assert result.exit_code == 0, result.stderr
    assert "working mode -++" in result.stdout


def test_the_list_as_json() -> None:
    result = CliRunner().invoke(cli, ["modes", "3-rrr", "--working", "--json"])
    found = json.loads(result.stdout)
    assert (found["number"], len(found["modes"]), found["limbs"][0]["ways"]) == (8, 8, 2)
    assert found["modes"][0]["name"] == "+++"


def test_many_modes_are_listed_by_single_limbs(monkeypatch: pytest.MonkeyPatch) -> None:
    found = choices("3-uru")
    assert len(working._listed(found)) == 64
    monkeypatch.setattr(working, "LISTED", 32)
    single = [tuple(k if n == place else 0 for n in range(3)) for place in range(3) for k in (1, 2, 3)]
    assert working._listed(found) == [(0, 0, 0), *single]


# --- assembly modes as homes ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("source", ["3-rps", "delta", "examples/octahedral.yaml", "3-rpr"])
def test_a_home_in_an_assembly_mode_has_the_actuators_and_margin_of_it(source: str) -> None:
    """The numbers of the mode are those of the robot at its new home, with actuators as they were."""
    found = gc.assembly_modes(source)
    assert len(found.modes) > 1
    for mode in found.modes[1:4]:
        moved = gc.load(source, mode=f"assembly {mode.number}")
        here = gc.pose(moved, nearest=False)
        assert here.margin == pytest.approx(mode.margin, abs=1e-9)
        again = gc.assembly_modes(moved)
        assert len(again.modes) == len(found.modes)
        assert sorted(m.margin for m in again.modes) == pytest.approx(sorted(m.margin for m in found.modes), abs=1e-8)


def test_an_assembly_mode_that_is_not_there_is_refused() -> None:
    result = CliRunner().invoke(cli, ["pose", "3-rps", "--mode", "assembly 40"])
    assert (result.exit_code, "it has assembly modes 1 to 8" in result.stderr) == (2, True)


# --- operation modes as homes --------------------------------------------------------------------------------------


def test_a_home_in_an_operation_mode_is_its_witness() -> None:
    found = gc.operation_modes("4-upu")
    other = next(mode for mode in found.modes if not mode.home)
    robot = gc.load("4-upu", mode=f"operation {other.number}")
    assert isinstance(robot, Robot)
    assert robot.title.endswith(f"operation mode {other.number}")
    here = gc.pose(robot, nearest=False)
    assert (here.residual < 1e-9, here.verdict) == (True, "regular")
    analysed = gc.analyze("4-upu")
    home, there = (linkage(r).home.values for r in (analysed.robot, robot))
    ends = [limb.joints[-1].points[0] for limb in analysed.robot.limbs]
    for p, q in itertools.combinations(ends, 2):  # on the platform
        assert np.linalg.norm(home[p] - home[q]) == pytest.approx(np.linalg.norm(there[p] - there[q]), abs=1e-9)


@pytest.mark.parametrize(
    ("name", "mode", "said"),
    [
        ("4-upu", "operation 9", "its modes are 1 to 2"),
        ("examples/octahedral.yaml", "operation 1", "are those of robots of joints"),
        ("3-upu", "operation 2", "3-upu is not a member of its family in that pose: u1 would have two directions"),
    ],
)
def test_operation_modes_that_are_no_homes_are_refused(name: str, mode: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        gc.load(name, mode=mode)
