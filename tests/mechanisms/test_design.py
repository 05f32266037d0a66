"""Factors that a motion does not change: told as conditions on the design, checked against poses that were solved."""

import contextlib
import random
from functools import cache

import numpy as np
import pytest
from mechanisms.shipped_robots import analysis, robot

import gcrules as gc
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.design import is_of_design, rigid_bodies
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.poses.limbs.report import RobotPose
from gcrules.screws.pose_text import ANGLES

TRIPTERON = """
title: three translations
copies: 3
points: {A%: free, B%: free, C%: free}
directions: {u%: free}
limbs: [{name: leg %, joints: "P*(u%) R(A%, u%) R(B%, u%) R(C%, u%)"}]
platform: C%
mobility: 3
home:
  A1: [0, 0, 0]
  B1: [0.1, 1, 1.2]
  C1: [0.2, 1.6, 0.3]
  A2: [3, 0, 0]
  B2: [2, 0.1, 1.2]
  C2: [1.2, 1.3, 0.2]
  A3: [0, 3, 0.2]
  B3: [1, 2.5, 0.1]
  C3: [1, 1.6, 0.9]
  u1: [1, 0, 0]
  u2: [0, 1, 0.2]
  u3: [0.1, 0, 1]
"""
MOVING = ("3-rps", "3-rpr", "3-prs", "delta", "orthoglide", "3-upu", "tricept", "3-ups-s")


@cache
def tripteron() -> RobotAnalysis:
    return analyze_robot(parse_robot(TRIPTERON))


def poses(a: RobotAnalysis, number: int) -> list[RobotPose]:
    """So many random poses near home."""
    rng = random.Random(a.robot.id)
    m = linkage(a.robot)
    found: list[RobotPose] = []
    while len(found) < number:
        at = {n: rng.uniform(-0.2, 0.2) * (1 if n in ANGLES else m.size) for n in free_coordinates(m)}
        with contextlib.suppress(InputError):  # it does not assemble there
            here = gc.pose(a, at, nearest=False)
            assert isinstance(here, RobotPose)
            found.append(here)
    return found


def test_a_design_is_told_apart_from_the_motion() -> None:
    a = tripteron()
    (part,) = (p for p in a.parts if p.kind == "actuation")
    assert part.of_design
    assert "exactly when the directions u1, u2 and u3 are parallel to one plane, and then in every pose" in a.statement
    assert part.remark in a.text()
    assert part.remark in a.latex()
    assert [p["of_design"] for p in a.to_json()["parts"] if p["kind"] == "actuation"] == [True]


def test_its_value_is_the_same_in_every_pose() -> None:
    """An oracle: the loops closed in random poses."""
    volumes = [np.linalg.det([here.points[n] for n in ("u1", "u2", "u3")]) for here in poses(tripteron(), 6)]
    assert volumes == pytest.approx([volumes[0]] * 6, rel=1e-9)
    assert volumes[0] != 0


@pytest.mark.parametrize("name", MOVING)
def test_other_factors_change(name: str) -> None:
    a = analysis(name)
    first, *others = ([f.value for f in here.factors] for here in poses(a, 4))
    for k, p in enumerate(a.parts):
        if p.kind not in ("never", "choice", "limb"):
            assert not p.of_design
            assert any(abs(values[k] - first[k]) > 1e-6 for values in others)


def test_both_kinds_in_one_robot() -> None:
    """A robot whose sentence has a factor of each kind."""
    words = analysis("3-prrr").statement
    assert "By its design" not in words  # all of it is design
    assert "matter of its design" in words


def test_the_bodies_of_a_robot() -> None:
    base, platform = rigid_bodies(robot("3-rps"))
    assert {"A1", "A2", "A3", "x", "y", "z"} <= base
    assert {"S1", "S2", "S3"} <= platform
    assert not {"S1", "S2", "S3"} & base


def test_a_bracket_of_three_directions_is_their_volume() -> None:
    bodies = (frozenset("uvwA"), frozenset("PQRSu"))
    assert is_of_design(bodies, "uvw", parse("[uvwX]"))
    assert not is_of_design(bodies, "uvw", parse("[uvXY]"))
    assert is_of_design(bodies, "uvw", parse("[PQRS]"))
    assert not is_of_design(bodies, "uvw", parse("[APQR]"))
    assert is_of_design(bodies, "uvw", parse("uP /\\ QRS"))
