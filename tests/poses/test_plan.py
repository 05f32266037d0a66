"""Plans: ways are checked at samples of their own, signs by the exact crossings of paths."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.plans.closing_sign import closing_signs, has_closing_sign
from gcrules.screws.pose import Pose

OCTAHEDRAL = EXAMPLES / "octahedral.yaml"
AROUND = "-36.9 75 87.5; rotvec 85.27 -39.32 115.91 deg", "215.1 70.5 125.5; rotvec 2.3 -27.94 46.06 deg"


def test_a_straight_way() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "0 0 -300")
    assert found.outcome == "way"
    assert len(found.poses) == 2
    assert found.path is not None
    assert found.path.verdict == "regular"
    assert found.length == pytest.approx(found.straight)


def test_a_way_around_a_singularity_keeps_its_margin() -> None:
    start, goal = AROUND
    straight = gc.path(OCTAHEDRAL, [start, goal])
    assert straight.zeros
    found = gc.plan(OCTAHEDRAL, start, goal, margin=0.02)
    assert found.outcome == "way"
    assert len(found.poses) > 2
    poses = [p for p in found.poses if isinstance(p, Pose)]
    samples = [
        gc.pose(OCTAHEDRAL, [_between(a, b, t) for t in np.linspace(0, 1, 25)]).margin.min() for a, b in pairwise(poses)
    ]
    assert min(samples) >= found.least >= 0.02


def _between(a: Pose, b: Pose, t: float) -> Pose:
    s = Fraction(t)
    p, q = np.array(a.unit_quaternion), np.array(b.unit_quaternion)
    q = q if p @ q > 0 else -q
    w, i, j, k = (Fraction(float(c)) for c in (1 - t) * p + t * q)
    x, y, z = (u + s * (v - u) for u, v in zip(a.translation, b.translation, strict=True))
    return Pose((x, y, z), (w, i, j, k))


def test_opposite_signs_exclude_a_way() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "0 0 -490")
    assert found.outcome == "none"
    assert not found.poses
    assert [o.start * o.goal < 0 for o in found.opposed] == [True]
    assert len(gc.path(OCTAHEDRAL, ["home", "0 0 -490"]).zeros) % 2 == 1


def test_limits_hold_between_samples() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "100 0 0", limits="leg lengths 200..900")
    assert found.outcome == "way"
    assert found.search is not None
    assert found.search.limits
    with pytest.raises(InputError, match="the goal does not keep to the limits"):
        gc.plan(OCTAHEDRAL, "home", "0 0 -300", limits="leg lengths 300..900")


@pytest.mark.parametrize("margin", [0.9, -1.0])
def test_margins_that_cannot_be(margin: float) -> None:
    with pytest.raises(InputError, match="margin"):
        gc.plan(OCTAHEDRAL, "home", "0 0 10", margin=margin)


def test_a_region_that_leaves_out_the_goal() -> None:
    with pytest.raises(InputError, match="the goal lies outside of the region"):
        gc.plan(OCTAHEDRAL, "home", "0 0 100", within="z -50..50")
    with pytest.raises(InputError, match="'w' is no coordinate"):
        gc.plan(OCTAHEDRAL, "home", "0 0 100", within="w -50..50")


def test_a_robot_of_joints() -> None:
    found = gc.plan("3-rps", "home", "z=0.2, roll=20deg, pitch=10deg", margin=0.2)
    assert found.outcome == "way"
    assert found.path is not None
    assert not found.path.crossings
    assert not found.path.undecided
    assert found.csv().splitlines()[0] == "z,roll [rad],pitch [rad]"


def test_nothing_is_decided_with_few_states() -> None:
    found = gc.plan(OCTAHEDRAL, *AROUND, margin=0.02, states=2)
    assert found.outcome == "undecided"
    assert found.path is None


WAYS = [
    ("3-rpr", "x=0.2, y=-0.1, yaw=55deg"),
    ("3-rpr", "x=-0.2, y=0.3, yaw=-70deg"),
    ("3-rps", "z=-0.3, roll=0deg, pitch=60deg"),
    ("3-rps", "z=0.1, roll=30deg, pitch=-20deg"),
    ("3-prs", "z=0.1, roll=50deg, pitch=-30deg"),
    ("delta", "x=0.3, y=0.4, z=-1"),
    ("3-upu", "x=0.3, y=0.1, z=-0.2"),
    ("tricept", "x=0.2, y=0.1, z=0.1"),
    ("6-pus", "x=0.1, y=0.1, z=0.1, roll=10deg, pitch=20deg, yaw=40deg"),
]


@pytest.mark.parametrize(("robot", "pose"), WAYS)
def test_closing_signs_change_at_each_crossing(robot: str, pose: str) -> None:
    m = mechanism(robot)
    assert isinstance(m, Limbs)
    assert has_closing_sign(m.linkage)
    try:
        path = gc.path(m.robot, ["home", pose], samples=8)
    except InputError as fault:
        pytest.skip(f"not reached: {fault.message}")
    if path.undecided:
        pytest.skip("some of the way is not decided")
    wanted = target_of(m.linkage, pose, None)
    assert wanted is not None
    a, b = closing_signs(
        m.linkage, Configurations.of([m.linkage.home, solve(m.linkage, wanted).configuration])
    ).tolist()
    assert a * b == (-1) ** len(path.crossings)
