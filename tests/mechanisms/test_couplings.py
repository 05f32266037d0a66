"""Joints that are geared to each other, against joints that move in the same way by themselves."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import gcrules as gc
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.poses.limbs.report import RobotPose
from gcrules.screws import RESIDUES
from gcrules.screws.joints import joint
from gcrules.screws.limbs import limb

SCREWS = """
title: three limbs with screws
copies: 3
points: {A%: free, B%: on line A% along u%, S%: free}
directions: {u%: free, v%: free}
limbs: [{LIMB}]
platform: S%
mobility: 3
home: {A1: [2, 0, 0], A2: [-1, 2, 0], A3: [-1, -2, 0], S1: [1, 0, 2], S2: [-1/2, 1, 2], S3: [-1/2, -1, 2],
  B1: [2, 0, 1], B2: [-1/2, 2, 1], B3: [-1, -3/2, 1],
  u1: [0, 0, 1], u2: [1, 0, 2], u3: [0, 1, 2], v1: [0, 1, 0], v2: [2, 1, 0], v3: [2, -1, 1]}
"""
DRIVEN = '{joints: "H*(A%, u%, 3/2) R(B%, v%) S(S%)"}'
SLIDES = '{joints: "R*:turn(A%, u%) P:slide(u%) R(B%, v%) S(S%)", couplings: slide = 3/2 turn}'
TURNS = '{joints: "R:turn(A%, u%) P*:slide(u%) R(B%, v%) S(S%)", couplings: [slide = 1.5 turn]}'
FREE = '{joints: "R*(A%, v%) H(B%, u%, -2) S(S%)"}'
GEARED = '{joints: "R*(A%, v%) P:a(u%) R:b(B%, u%) S(S%)", couplings: b = -1/2 a}'


@cache
def screws(chain: str) -> RobotAnalysis:
    found = gc.analyze(gc.load(SCREWS.replace("{LIMB}", chain)))
    assert isinstance(found, RobotAnalysis)
    return found


def posed(a: RobotAnalysis, pose: str) -> RobotPose:
    found = gc.pose(a, pose, nearest=False)
    assert isinstance(found, RobotPose)
    return found


@pytest.mark.parametrize(
    ("screw", "coupled", "ratio"), [(DRIVEN, SLIDES, 1.0), (DRIVEN, TURNS, 1.5), (FREE, GEARED, 1.0)]
)
def test_a_screw_is_a_hinge_and_a_slide_that_are_coupled(screw: str, coupled: str, ratio: float) -> None:
    one, other = screws(screw), screws(coupled)
    assert one.statement == other.statement
    assert one.condition is not None
    assert other.condition is not None
    assert one.condition.expression == other.condition.expression
    for seed in range(4):
        member = one.robot.family.member(("screw", seed))
        for a, b in zip(one.robot.limbs, other.robot.limbs, strict=True):
            both = [*a.at(member, RESIDUES).locked(RESIDUES), *b.at(member, RESIDUES).locked(RESIDUES)]
            assert RESIDUES.rank(both) == len(both) // 2
    there = [posed(a, "x=0.1, y=0.05, z=0.1") for a in (one, other)]
    assert there[1].margin == pytest.approx(there[0].margin)
    values = [np.array([v for _, v in p.actuators]) for p in there]
    assert values[1] == pytest.approx(ratio * values[0])
    assert there[0].assembly == there[1].assembly


def orthoglide(chain: str, *, plain: bool) -> str:
    robot = gc.load("orthoglide")
    assert isinstance(robot, gc.Robot)
    text = Path(robot.filename).read_text(encoding="utf-8")
    joints = "P*(d%) R(A%, e%) Pa(A% B%, n%) R(B%, e%)"
    assert joints in text
    return text if plain else text.replace(joints, chain)


def test_two_geared_hinges_are_a_parallelogram() -> None:
    """A gear pair 1 : −1 between parallel hinges moves on a circle without a turn."""
    geared = "P*(d%) R(A%, e%) R:a(A%, n%) R:b(B%, n%) R(B%, e%)\n    couplings: b = -a"
    one, other = (gc.analyze(gc.load(orthoglide(geared, plain=plain))) for plain in (True, False))
    assert isinstance(one, RobotAnalysis)
    assert isinstance(other, RobotAnalysis)
    assert (one.statement, one.structure.over) == (other.statement, other.structure.over)
    assert [s.conditions for s in one.limbs] == [s.conditions for s in other.limbs]
    assert other.robot.chain == "3-P*RRR~R"
    for pose in ("x=0.1, y=-0.2, z=0.3", "x=-0.4, y=0.5, z=0.2"):
        there = [posed(a, pose) for a in (one, other)]
        assert there[1].margin == pytest.approx(there[0].margin)
        assert [v for _, v in there[1].actuators] == pytest.approx([v for _, v in there[0].actuators])
        assert there[1].jacobian.amplification.speeds == pytest.approx(there[0].jacobian.amplification.speeds)


def test_a_chain_of_couplings_follows_the_driven_joint() -> None:
    """Belts that keep the hand's orientation: three parallel hinges with rates 1 : −2 : 1 slide along one line where
    the arms are equally long, and the hand rides on it.
    """
    robot = gc.load("""
    title: an arm with belts
    space: plane
    points: {A: free, B: free, C: free}
    limbs: [{name: arm, joints: "R*:a(A, z) R:b(B, z) R:c(C, z)", couplings: ["b = -2 a", "c = -1/2 b"]}]
    platform: C
    mobility: 1
    home: {A: [0, 0], B: [3, 4], C: [6, 0]}
    """)
    assert isinstance(robot, gc.Robot)
    (arm,) = robot.limbs
    assert [(c.joint, c.leader, c.ratio) for c in arm.couplings] == [(1, 0, -2), (2, 0, 1)]
    assert (arm.freedoms, arm.actuators, arm.coordinates) == (1, 1, ((0,), (0,), (0,)))
    (own,) = robot.limbs_at()
    assert [list(map(int, row)) for row in own.twists()] == [[0, 0, 0, -8, 0, 0]]
    angle = 0.3
    found = gc.pose(robot, actuators={"q1": angle})
    assert isinstance(found, RobotPose)
    start = np.arctan2(4, 3)
    assert found.coordinates["x"] == pytest.approx(10 * (np.cos(start + angle) - np.cos(start)))
    assert found.coordinates["yaw"] == pytest.approx(0, abs=1e-12)
    assert found.coordinates["y"] == pytest.approx(0, abs=1e-12)


FILE = """title: two limbs
points: {A: free, B: free, S: free}
directions: {u: free, v: free}
limbs:
  - joints: LIMB
    couplings: COUPLED
  - joints: R*:far(B, u) R(S, v)
mobility: 1
"""


@pytest.mark.parametrize(
    ("joints", "coupled", "words"),
    [
        ("R*:a(A, u) R:b(B, u)", "b = 2 c", "6:22: no joint of this limb is named c"),
        ("R*:a(A, u) R:b(B, u)", "b = far", "6:20: far is a joint of another limb"),
        ("R*:a(A, u) R:b(B, u)", "b is a", "6:16: 'b is a' is not a coupling"),
        ("R*:a(A, u) R:b(B, u)", "b = 0 a", "6:20: a ratio of 0 would hold the joint still"),
        ("R*:a(A, u) R:b(B, u)", "b = a, a = 2 b", "6:22: a and b are already coupled"),
        ("R*:a(A, u) R*:b(B, u)", "b = a", "are both driven, though they move as one"),
        ("R*:a(A, u) U:b(B, u, v)", "b = a", "U:b(B, u, v) has several freedoms"),
        ("R*:a(A, u) R:a(B, u)", "a = a", "5:24: two joints of the limb are named a"),
        ("R*:a(A, u) R:b(B, v)", "b = a", "their axes are not always of equal length"),
        ("[base to m: 'R*:a(A, u)', m to platform: 'R:b(B, u)']", "b = a", "joints of different chains"),
    ],
)
def test_couplings_that_are_none(joints: str, coupled: str, words: str) -> None:
    with pytest.raises(GcrulesError) as caught:
        gc.load(FILE.replace("LIMB", joints).replace("COUPLED", coupled))
    assert words in caught.value.render()


def test_limbs_of_screws_are_coupled_too() -> None:
    u = (0, 0, 1)
    hinge, slide = joint("R", point=(1, 2, 3), axis=u, actuated=True), joint("P", direction=u)
    one = limb(hinge, slide, couplings=[(1, 0, 2)])
    assert (one.freedoms, one.actuated, one.passive) == (1, (0,), ())
    assert one.twists() == limb(joint("H", point=(1, 2, 3), axis=u, pitch=2)).twists()
    floats = limb(hinge, slide, couplings=[(1, 0, 0.5)])
    assert np.asarray(floats.twists()).tolist() == [[0, 0, 1, 2, -1, 0.5]]
    for wrong in ([(1, 1, 1)], [(2, 0, 1)], [(0, 1, 1)], [(1, 0, 1), (1, 0, 1)]):
        with pytest.raises(InputError):
            limb(hinge, slide, couplings=wrong)
    with pytest.raises(InputError, match="one freedom each"):
        limb(hinge, joint("S", point=(0, 0, 0)), couplings=[(1, 0, 1)])


def test_the_schema_knows_couplings() -> None:
    parts = json.loads((Path(gc.__file__).parent / "mechanisms/description/robot.schema.json").read_text("utf-8"))[
        "$defs"
    ]
    assert re.search(parts["joints"]["pattern"], "R*:a(A, u) R:b_2(B, u)")
    for text in ("b = -1/2 a", "b = 1.5 a, c = -a", "b=2*a"):
        assert re.search(parts["couplings"]["pattern"], text)
    assert not re.search(parts["couplings"]["pattern"], "b is a")
