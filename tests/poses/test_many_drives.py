"""Robots with several drives in each limb: numbers against differences of other solutions."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import gcrules as gc
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose

FILES = {
    "three slides in each of two limbs": """
title: two limbs with three slides each
copies: 2
points: {A%: free, C%: free}
directions: {s%: free, t%: free, w%: free}
limbs: [{joints: "P*(x) P*(y) P*(z) U(A%, s%, t%) R(C%, w%)"}]
platform: C1 C2
mobility: 6
home: {A1: [2, 0, 0], A2: [-2, 0, 0], C1: [1, 1, 3], C2: [-1, 1, 3], s1: [1, 0, 1], s2: [0, 1, -1],
  t1: [1, 1, 0], t2: [1, 0, 2], w1: [0, 1, 2], w2: [2, -1, 1]}
""",
    "driven universal joints": """
title: three limbs whose universal joints are driven
copies: 3
points: {A%: free, B%: free, S%: free}
directions: {u%: free, v%: free, w%: free}
limbs: [{joints: "U*(A%, u%, v%) R(B%, w%) S(S%)"}]
platform: S%
mobility: 6
home: {A1: [3, 0, 0], A2: [-2, 3, 0], A3: [-2, -3, 0], S1: [1, 0, 3], S2: [-1/2, 1, 3], S3: [-1/2, -1, 3],
  B1: [3, 1/2, 2], B2: [-2, 3, 2], B3: [-2, -4, 2], u1: [0, 0, 1], u2: [1, 0, 2], u3: [0, 1, 2],
  v1: [0, 1, 0], v2: [2, 1, 0], v3: [2, -1, 1], w1: [0, 1, 0], w2: [1, 1, 0], w3: [1, -1, 0]}
""",
    "driven cylindrical joints": """
title: three limbs whose cylindrical joints are driven
copies: 3
points: {A%: free, B%: free, S%: free}
directions: {u%: free, v%: free}
limbs: [{joints: "C*(A%, u%) R(B%, v%) S(S%)"}]
platform: S%
mobility: 6
home: {A1: [2, 0, 0], A2: [-1, 2, 0], A3: [-1, -2, 0], S1: [1, 0, 2], S2: [-1/2, 1, 2], S3: [-1/2, -1, 2],
  B1: [2, 0, 1], B2: [-1, 2, 1], B3: [-1, -2, 1], u1: [0, 0, 1], u2: [1, 0, 2], u3: [0, 1, 2],
  v1: [0, 1, 0], v2: [2, 1, 0], v3: [2, -1, 1]}
""",
}
THERE = {"x": 0.1, "y": 0.05, "z": 0.1, "roll": 0.05, "pitch": -0.03, "yaw": 0.07}
STEP = 1e-5


@cache
def analysis(name: str) -> RobotAnalysis:
    found = gc.analyze(gc.load(FILES[name]))
    assert isinstance(found, RobotAnalysis)
    return found


def posed(name: str, **changes: float) -> RobotPose:
    found = gc.pose(analysis(name), {n: v + changes.get(n, 0) for n, v in THERE.items()}, nearest=False)
    assert isinstance(found, RobotPose)
    return found


def amounts(found: RobotPose) -> np.ndarray:
    return np.array([v for _, v in found.actuators])


@pytest.mark.parametrize("name", FILES)
def test_wrenches_are_the_derivatives_of_what_the_drives_do(name: str) -> None:
    found = posed(name)
    for k, coordinate in enumerate("xyz"):
        ahead, behind = (amounts(posed(name, **{coordinate: s * STEP})) for s in (1, -1))
        assert (ahead - behind) / (2 * STEP) == pytest.approx(found.jacobian.rows[:6, k], abs=1e-6)
    passed = found.jacobian.amplification.transmission
    assert passed is not None
    assert all(0 <= x <= 1 for x in (*passed.inputs, *passed.outputs))


@pytest.mark.parametrize("name", FILES)
def test_drives_lead_back_to_the_pose(name: str) -> None:
    found = gc.pose(analysis(name), actuators=list(amounts(posed(name))), nearest=False)
    assert isinstance(found, RobotPose)
    assert {n: found.coordinates[n] for n in THERE} == pytest.approx(THERE, abs=1e-8)
    assert [a.name for a, _ in found.actuators] == [f"q{k}" for k in range(1, 7)]


@pytest.mark.parametrize("name", FILES)
def test_paths_and_maps_of_several_drives(name: str) -> None:
    along = gc.path(analysis(name), ["home", ", ".join(f"{n}={v}" for n, v in list(THERE.items())[:3])])
    assert isinstance(along, RobotPath)
    assert not along.crossings
    over = gc.singular_map(analysis(name), ["x 0:0.1:3", "z 0:0.1:3"])
    corner = gc.pose(analysis(name), "x=0.1, z=0.1", nearest=False)
    assert over.values("margin")[-1, -1] == pytest.approx(corner.margin, abs=1e-6)
