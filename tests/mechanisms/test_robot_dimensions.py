"""What the dimensions of robots of joints say beyond their families: facts of the bodies, singular in every pose."""

from __future__ import annotations

import dataclasses
import math
from fractions import Fraction

import numpy as np
import pytest
from commands import invoke
from places import DATA, EXAMPLES

import gcrules as gc
from gcrules.conditions.dimensions.facts import KINDS
from gcrules.mechanisms.dimensions.axes import axis_facts
from gcrules.mechanisms.dimensions.directions import direction_facts
from gcrules.mechanisms.dimensions.robot_dimensions import Parts, facts_of_design
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import coordinates_target
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS


def facts(robot: Robot) -> set[tuple[str, str, frozenset[str]]]:
    return {(f.kind, f.body, frozenset(f.members)) for f in facts_of_design(robot)}


def with_home(name: str, **changed: tuple[float | int | Fraction, ...]) -> Robot:
    robot = read_robot(name)
    home = {n: tuple(map(Fraction, p)) for n, p in {**(robot.home or {}), **changed}.items()}
    return dataclasses.replace(robot, home=home)


# --- facts ---


def test_the_axes_of_a_base_are_in_one_plane_beyond_the_family() -> None:
    assert ("flat axes", "base", frozenset({"A1r1", "A2r2", "A3r3"})) in facts(read_robot("3-rps"))


def test_what_the_relations_say_is_no_news() -> None:
    """In the Agile Eye all axes meet in O at right angles by its relations."""
    assert not facts(read_robot("agile-eye"))


def test_a_random_member_of_a_family_has_no_facts() -> None:
    robot = read_robot("3-upu")
    member = robot.family.member("elsewhere", RATIONALS)
    made = dataclasses.replace(robot, home={d.name: member[d.name] for d in robot.family.definitions})
    assert not facts(made)


def test_one_number_away_is_no_fact() -> None:
    assert not {k for k, _, _ in facts(with_home("3-rps", r2=(2, 1, 1)))} & {"flat axes", "level"}


def test_nearly_so_is_told_with_its_deviation() -> None:
    found = [f for f in facts_of_design(with_home("3-rps", r2=(2, 1, Fraction(1, 10**6)))) if f.kind == "flat axes"]
    assert [f.exact for f in found] == [False]
    assert found[0].deviation == pytest.approx(1e-6 / math.sqrt(5), rel=1e-3)
    assert found[0].sentence.endswith("(nearly: up to 4.5e-07 of the size, or rad)")


def test_slides_at_right_angles_are_one_fact() -> None:
    assert ("perpendicular", "base", frozenset({"d1", "d2", "d3"})) in facts(read_robot("orthoglide"))


def test_equal_cranks_and_rods() -> None:
    found = facts(read_robot("4-ruu"))
    assert ("lengths", "links", frozenset({"A1B1", "A2B2", "A3B3"})) in found
    assert ("lengths", "links", frozenset({"B1C1", "B2C2", "B3C3"})) in found


def test_legs_are_compared_by_their_joints_alone() -> None:
    """The first axes of the joints U of six legs are of no account."""
    kinds = {kind for kind, _, _ in facts(read_robot("gough-stewart"))}
    assert kinds <= {"coplanar", "conic", "circle", "rotation", "mirror", "similar", "affine", "projective"}


@pytest.mark.parametrize("name", ["3-crr", "4-ruu", "3-upu", "h4", "par4", "delta", "3-rrr", "tricept"])
def test_bodies_and_lengths_keep_as_the_joints_move(name: str) -> None:
    """In another pose names of the base are where they were, those of the platform where its motion takes them, and
    lengths within links are what they were.
    """
    robot = read_robot(name)
    m = linkage(robot)
    there = solve(m, coordinates_target(m, dict.fromkeys(free_coordinates(m), 0.05))).configuration
    parts = Parts.of(robot)
    home, turn, shift = m.home.values, there.platform[:3, :3], there.platform[:3, 3]
    for n in parts.points[0]:
        assert np.allclose(there.values[n], home[n], atol=1e-7)
    for n in parts.points[1]:
        assert np.allclose(there.values[n], turn @ home[n] + shift, atol=1e-7)
    for p, q in parts.lengths:
        assert math.dist(there.values[p], there.values[q]) == pytest.approx(math.dist(home[p], home[q]), abs=1e-7)


# --- symmetry, seen by NumPy ---


@pytest.mark.parametrize("path", ["tsai-3-upu.yaml", "snu-3-upu.yaml", "equilateral-3-rps.yaml"])
def test_a_turn_of_order_three(path: str) -> None:
    robot = read_robot(EXAMPLES / "published" / path)
    orders = [f.order for f in facts_of_design(robot) if f.kind == "rotation"]
    assert orders == [3]
    at = {n: np.array([float(c) for c in v]) for n, v in robot.values_at().items()}
    axis = np.cross(at["A2"] - at["A1"], at["A3"] - at["A1"])
    axis /= np.linalg.norm(axis)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    turn = np.eye(3) + math.sin(2 * math.pi / 3) * k + (1 - math.cos(2 * math.pi / 3)) * k @ k
    middle = (at["A1"] + at["A2"] + at["A3"]) / 3
    assert np.allclose(turn @ (at["A1"] - middle) + middle, at["A2"])


def test_a_direction_that_the_turn_does_not_carry_ends_it() -> None:
    robot = read_robot(EXAMPLES / "published" / "tsai-3-upu.yaml")
    home = {**(robot.home or {}), "u1": (Fraction(1), Fraction(2), Fraction(5))}
    assert not [f for f in facts_of_design(dataclasses.replace(robot, home=home)) if f.kind == "rotation"]


# --- singular in every pose ---


def test_a_regular_home_proves_that_there_are_regular_poses() -> None:
    found = gc.analyze("3-rps").dimensions
    assert found is not None
    assert found.architecture.verdict == "regular"
    assert found.architecture.sure.startswith("proved")


@pytest.mark.parametrize("path", ["moved/3-upu-snu.yaml", "moved/4-upu-singular.yaml"])
def test_a_design_that_is_singular_wherever_it_is_moved(path: str) -> None:
    found = gc.analyze(DATA / path)
    assert found.dimensions is not None
    assert found.dimensions.architecture.verdict == "seems singular"
    assert found.text().removeprefix("- ").startswith("It seems to be architecturally singular")


def test_a_home_that_is_singular_alone_is_left() -> None:
    found = gc.analyze(DATA / "moved" / "3-prr-singular.yaml").dimensions
    assert found is not None
    assert found.architecture.verdict == "regular"


def test_a_factor_of_the_design_that_is_zero_is_the_reason() -> None:
    """Slides of a 3-CPU that are parallel to one plane: its condition is one of the design."""
    robot = with_home("3-cpu", u3=(1, 1, 0), v3=(0, 1, 1), p3=(0, 0, 1))
    found = gc.analyze(robot).dimensions
    assert found is not None
    assert found.architecture.verdict == "singular"
    assert "[u1u2u3B1]" in found.architecture.sure


# --- options and views ---


def test_without_facts() -> None:
    assert gc.analyze("3-rps", facts=False).dimensions is None


@pytest.mark.parametrize("command", [("analyze",), ("robot", "analyze")])
def test_the_options_count_for_robots(command: tuple[str, ...]) -> None:
    assert "Dimensions" in invoke(*command, "3-rps").stdout
    assert "Dimensions" not in invoke(*command, "3-rps", "--no-facts").stdout


def test_a_tolerance_that_is_none_is_refused() -> None:
    with pytest.raises(gc.InputError, match="tolerance"):
        gc.analyze("3-rps", tolerance=0.5)


def test_all_views_have_the_section() -> None:
    found = gc.analyze("3-rps")
    said = "are in one plane"
    assert "6. Dimensions" in found.text()
    for shown in (str(found.to_json()), gc.report(found)):
        assert f"{said} (exactly)" in shown
    assert said in found.latex()  # where a table has a column for what holds only nearly, if anything does


def test_every_kind_makes_a_sentence() -> None:
    assert all(words.format(members="A and B", body="base", order=2) for words in KINDS.values())


# --- small parts ---


def test_axes_that_meet_far_from_their_points() -> None:
    lines = {"Aa": ((0, 0, 0), (1, 0, 0)), "Bb": ((9, 9, 0), (0, 1, 0)), "Cc": ((9, 0, 7), (0, 0, 1))}
    assert [(f.kind, f.members) for f in axis_facts(lines, "base")] == [("meet", ("Aa", "Bb", "Cc"))]


def test_axes_nearly_in_one_plane_are_told_so() -> None:
    off = Fraction(1, 10**7)
    lines = {"Aa": ((0, 0, 0), (1, 0, 0)), "Bb": ((0, 9, 0), (1, 1, 0)), "Cc": ((5, 2, off), (0, 1, 0))}
    (found,) = axis_facts(lines, "base", 1e-5, 10.0)
    assert (found.kind, found.exact) == ("flat axes", False)
    assert found.deviation == pytest.approx(1e-8)


def test_parallel_directions_need_no_unit_length() -> None:
    at = {"u": (1, 2, 3), "v": (-2, -4, -6), "w": (1, 2, 4)}
    assert [(f.kind, f.members) for f in direction_facts(at, "base")] == [("parallel", ("u", "v"))]
