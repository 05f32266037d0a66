"""Limbs with bodies and loops of their own, against the equilibrium of all bodies taken one by one."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest
from mechanisms.bodies import chains
from places import DATA

import gcrules as gc
from gcrules.core.errors import FileError
from gcrules.mechanisms.conditions.lost_wrenches import lines_that_hold
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.limb_file import LimbSpec, read_limb
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import read_pose
from gcrules.mechanisms.lines.equivalent import equivalent
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose
from gcrules.screws import RESIDUES

NAMES = ("h4", "gantry-tau", "par4")


@cache
def analysis(name: str) -> RobotAnalysis:
    found = gc.analyze(name)
    assert isinstance(found, RobotAnalysis)
    return found


def freedoms(name: str, values: Mapping[str, Any], *, locked: bool) -> int:
    """Of the platform: the twists of all bodies that no chain between two of them resists."""
    blocks = {"platform": 0}
    between = []
    for start, end, own in chains(analysis(name).robot, values, RESIDUES):
        for n in (start, end):
            blocks.setdefault(n, len(blocks)) if n != "base" else None
        between.append((start, end, own.locked(RESIDUES) if locked else own.constraints(RESIDUES)))
    rows = []
    for start, end, wrenches in between:
        for w in wrenches:
            row = [0] * (6 * len(blocks))
            for body, sign in ((start, -1), (end, 1)):
                if body != "base":
                    at = 6 * blocks[body]
                    row[at : at + 6] = [sign * c for c in (*w[3:], *w[:3])]
            rows.append(row)
    still = [[int(i == k) for i in range(6 * len(blocks))] for k in range(6)]
    return RESIDUES.rank([*rows, *still]) - RESIDUES.rank(rows)


@pytest.mark.parametrize("name", NAMES)
def test_ranks_are_those_of_all_bodies(name: str) -> None:
    robot = analysis(name).robot
    for seed in range(4):
        values = robot.family.member(("bodies", seed))
        found = ranks(robot.family, robot.limbs, values)
        assert 6 - found.constraints == freedoms(name, values, locked=False) == robot.mobility
        assert 6 - found.wrenches == freedoms(name, values, locked=True) == 0


def test_gantry_tau_is_singular_where_its_three_rods_lie_in_a_plane() -> None:
    """Three parallel rods in one plane hold one turn less, though the limb's couples have names there."""
    robot = analysis("gantry-tau").robot
    values = dict(robot.family.member("flat"))
    moved = {n: values[n] for n in ("A1", "B1", "A2", "C2", "A3", "C3", "d2", "d3")}
    moved["D3"] = tuple(2 * a - c + 3 * d for a, c, d in zip(values["A3"], values["C3"], values["d3"], strict=True))
    every = {n: RESIDUES.vector(v) for n, v in robot.values_at(moved).items()}
    assert ranks(robot.family, robot.limbs, every).wrenches == 5
    assert freedoms("gantry-tau", every, locked=True) == 1


def test_lines_that_hide_a_lost_wrench_are_replaced() -> None:
    robot = analysis("gantry-tau").robot
    first = equivalent(robot.family, robot.limbs, robot.values_at())
    assert any(line.couple for line in first.lines or ())
    found = lines_that_hold(robot.family, first, robot.values_at())
    assert found.lines is not None
    assert not any(line.couple for line in found.lines)


@pytest.mark.parametrize(
    ("name", "pose"),
    [
        ("h4", "x=0.1, y=-0.2, z=0.5, yaw=20deg"),
        ("par4", "x=0.1, y=-0.2, z=0.4, yaw=9deg"),
        ("gantry-tau", "x=0.1, y=0.1, z=0.2"),  # two rods that spin, one of them in a limb with loops
    ],
)
def test_a_pose_is_reached_and_its_branch_proved(name: str, pose: str) -> None:
    m = linkage(analysis(name).robot)
    solution = solve(m, read_pose(m, pose))
    assert solution.doubt is None
    for chain, own in zip(m.home.chains, solution.configuration.links, strict=True):
        for a, b in chain.loops:
            assert own[a] == pytest.approx(own[b], abs=1e-9 * m.size)
    said = gc.pose(name, pose)
    assert "no body of the robot can move with the actuators locked" in str(said.reason).lower()


def test_a_limb_that_loses_a_wrench_is_crossed() -> None:
    """There the wrenches of the limb span the same on both sides, and those on all bodies change their sign."""
    found = gc.path("gantry-tau", ["home", "x=0, y=-1, z=0"])
    assert isinstance(found, RobotPath)
    (crossing,) = found.crossings
    assert "contains the direction d3" in " ".join(crossing.causes)
    nearest = gc.pose("gantry-tau").nearest
    assert nearest is not None
    assert nearest.margin < 1e-4


@pytest.mark.parametrize("name", NAMES)
def test_of_no_motion_more_is_noticed_than_there_is(name: str) -> None:
    """The trio of rods ends in a ball joint on the platform, but passes on more than forces through that."""
    m = linkage(analysis(name).robot)
    found = margins(m, Configurations.of([m.home]))
    assert 0 < found.sigma[0] <= found.singular_values[0].max() <= 1 + 1e-12


def test_ways_through_a_limb_meet_no_body_twice() -> None:
    text = "base to a: R(A, x) a to b: R(B, x) b to a: R(C, x) a to platform: R(D, x) b to platform: R(E, x)"
    joints, chains = read_limb(text)
    limb = LimbSpec("test", joints, subchains=chains)
    assert [[j.names[0] for j in way] for way in limb.ways()] == [["A", "B", "E"], ["A", "D"]]


def test_par4_has_no_margin_where_it_is_singular() -> None:
    """Its one limb applies all wrenches elsewhere; a body moves where they lose rank."""
    m = linkage(analysis("par4").robot)
    found = margins(m, Configurations.of([m.home]))
    assert found.rows.shape[1] == 6
    assert 0 < found.sigma[0] < np.linalg.svd(found.rows[0], compute_uv=False)[-1]


LEGS = """title: test
copies: 2
points: {A%: free, B%: free}
limbs:
  - joints:
      - base to hub: U(A1, x, y) P*(A1 B1) S(B1)
      - FIRST
      - hub to platform: R(B2, z)
mobility: 1
"""


@pytest.mark.parametrize(
    ("chain", "message"),
    [
        ("hup to platform: S(A2)", "no chain before this one leads to hup"),
        ("base to base: S(A2)", "no chain leads from base to base"),
        ("base to hup: S(A2)", "nothing else is joined to hup"),
        ("S(A2)", "a chain does not say between which bodies it leads"),
    ],
)
def test_faults(chain: str, message: str) -> None:
    with pytest.raises(FileError, match=message):
        parse_robot(LEGS.replace("FIRST", chain))


def test_pantographs_double_what_their_slides_do() -> None:
    """Three of them in planes along the driven slides: a Tripteron whose platform goes twice as far."""
    robot = gc.load(DATA / "robots" / "3-pantograph.yaml")
    a = gc.analyze(robot)
    assert isinstance(a, RobotAnalysis)
    assert "exactly when the directions n1', n2' and n3' are parallel to one plane" in a.statement
    assert "n1' is the direction n1 × e1" in a.statement
    assert (a.structure.mobility, a.structure.over) == (3, 3)
    for seed in range(3):
        values = a.robot.family.member(("pantograph", seed))
        assert 6 - ranks(a.robot.family, a.robot.limbs, values).wrenches == 0
    found = gc.pose(a, "x=0.4, y=-0.2, z=0.1", nearest=False)
    assert isinstance(found, RobotPose)
    assert [v for _, v in found.actuators] == pytest.approx([0.2, -0.1, 0.05])
    assert found.jacobian.amplification.speeds == pytest.approx((2, 2, 2))
    assert found.margin > 0.04
    for k in "123":
        o, d, e = (np.array(found.points[f"{n}{k}"], dtype=float) for n in "ODE")
        assert e == pytest.approx(2 * d - o)
