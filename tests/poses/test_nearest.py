"""The superbracket as a polynomial of translations, and the nearest singular poses."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.language.legs_text import read_legs
from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.poses.nearest.poses import _checked
from gcrules.poses.nearest.taylor import taylor
from gcrules.poses.nearest.zero import fibonacci, nearest_zero
from gcrules.poses.numbers.cubic import EXPONENTS, Cubic, superbracket_at, translation_polynomial
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import product

F = Fraction
seeds = st.integers(0, 2**32 - 1)


# --- poses as text and as numbers ----------------------------------------------------------------------------------

HALF = math.sqrt(0.5)


# --- the polynomial of translations and its nearest zero -----------------------------------------------------------

coordinates = st.tuples(*[st.fractions(-5, 5, max_denominator=7)] * 3)


@settings(max_examples=12)
@given(st.lists(coordinates, min_size=12, max_size=12), coordinates, st.sampled_from([F(1), F(1, 3), F(100)]))
def test_the_superbracket_is_a_cubic_in_the_translation(
    places: list[tuple[F, F, F]], t: tuple[F, F, F], step: F
) -> None:
    structure = read_legs("Aa Bb Cc Dd Ee Ff")
    points = {n: (*p, F(1)) for n, p in zip("ABCDEFabcdef", places, strict=True)}
    f = translation_polynomial(structure.legs, points, "abcdef", step)
    assert f.degree <= 3
    moved = {n: (*(c + s * (n in "abcdef") for c, s in zip(p[:3], t, strict=True)), F(1)) for n, p in points.items()}
    assert f(*t) == evaluate(structure.superbracket, moved) == superbracket_at(structure.legs, points, "abcdef", t)


X, Y, Z, O = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
XX, YY, ZZ = (2, 0, 0), (0, 2, 0), (0, 0, 2)


@pytest.mark.parametrize(
    ("coefficients", "distance"),
    [
        pytest.param({O: -2, X: 1}, 2.0, id="plane"),
        pytest.param({O: -5, X: 3, Y: 4}, 1.0, id="oblique plane"),
        pytest.param({O: 9, XX: -1, YY: -1, ZZ: -1}, 3.0, id="sphere: nearest everywhere"),
        pytest.param({O: 4, XX: -1, YY: -1}, 2.0, id="cylinder: nearest on a circle"),
        pytest.param({O: 9, XX: 1, YY: 1, ZZ: 1}, math.inf, id="definite"),
        pytest.param({O: 9, X: 2, XX: 1}, math.inf, id="semidefinite without zero"),
        pytest.param({O: 5}, math.inf, id="constant"),
        pytest.param({O: 1, X: -2, XX: 1, YY: 1}, 1.0, id="touches on a line"),
        pytest.param({O: 1, X: -2, XX: 1, YY: 1, ZZ: 1}, 1.0, id="touches in a point"),
        pytest.param({O: 1, X: -2, XX: 1}, 1.0, id="double plane"),
        pytest.param({O: -1, X: 3, XX: -3, (3, 0, 0): 1}, 1.0, id="triple plane"),
        pytest.param({O: 4, X: -4, XX: 1, Y: -4, (1, 1, 0): 4, (2, 1, 0): -1}, 1.0, id="double plane and a plane"),
        pytest.param({O: 1, X: -2, XX: 1, YY: -1}, HALF, id="two planes"),
        pytest.param({O: -1, (1, 1, 1): 1}, math.sqrt(3), id="xyz = 1"),
        pytest.param({O: 1, (3, 0, 0): 1, (1, 2, 0): -3}, 1.0, id="monkey saddle"),
        pytest.param({O: -(10**9), (0, 0, 3): 1}, 1000.0, id="far"),
        pytest.param({O: F(-1, 10**9), X: 1, XX: 5}, 1e-9, id="near"),
        pytest.param({O: 1, XX: -10000, YY: 1, ZZ: 1}, 0.01, id="sharp"),
        pytest.param({X: 1}, 0.0, id="zero at the start"),
        pytest.param({}, 0.0, id="zero everywhere"),
    ],
)
def test_nearest_zeros_that_are_known(coefficients: dict[Any, Any], distance: float) -> None:
    f = Cubic({e: F(c) for e, c in coefficients.items()})
    found = nearest_zero(f, 1.0)
    assert found.certified
    assert found.never == math.isinf(distance)
    assert found.distance == pytest.approx(distance, rel=1e-6)
    assert found.lower <= distance * (1 + 1e-12)
    if found.point is not None:
        assert found.upper is not None
        assert found.upper >= found.distance
        assert found.residual <= 1e-12


@settings(max_examples=15, deadline=None)
@given(seeds, st.integers(1, 3))
def test_no_ray_meets_a_nearer_zero(seed: int, degree: int) -> None:
    rng = np.random.default_rng(seed)
    f = Cubic({e: F(int(rng.integers(-9, 10))) for e in EXPONENTS if 0 < sum(e) <= degree} | {O: F(3)})
    found = nearest_zero(f, 1.0)
    rays = taylor(f, F(1)).on_rays(fibonacci(3000)).min()
    assert found.lower <= rays * (1 + 1e-9)
    assert found.distance <= rays * (1 + 1e-9)
    assert found.certified
    if found.point is not None:
        assert abs(float(f(*found.point))) <= 1e-12 * 3


@pytest.mark.parametrize("name", ["octahedral", "platform-6-4"])
def test_nearest_poses_are_singular(robots: dict[str, Analysis], name: str) -> None:
    found = gc.pose(robots[name], "0.01 0.02 0; euler zyx 5 -3 2 deg")
    assert [n.kind for n in found.nearest] == ["translation", "rotation", "combined"]
    translation, rotated, both = found.nearest
    assert translation.certified
    assert translation.pose.quaternion == found.pose.quaternion
    assert both.distance <= min(translation.distance, found.jacobian.length * rotated.distance) * (1 + 1e-9)
    for n, bound in zip(found.nearest, (found.shift, found.rotation, found.combined), strict=True):
        assert bound <= n.lower <= n.distance <= n.upper
        assert n.sigma < 1e-12
        there = gc.pose(robots[name], n.pose, nearest=False)
        assert there.verdict == "singular"
        assert gc.pose(robots[name], n.pose.text(), nearest=False).verdict == "singular"
        assert 1 <= len(there.dependence.legs) <= 6
        sizes = [abs(r.value) / (found.rig.size if r.unit else 1) for r in there.readings if r.value is not None]
        assert min(sizes) < 1e-9
        assert n.causes
    # the metrics are what they are said to be
    assert math.dist(translation.pose.translation, found.pose.translation) == pytest.approx(translation.distance)
    back = product(rotated.pose.quaternion, (found.pose.quaternion[0], *(-c for c in found.pose.quaternion[1:])))
    assert Pose(quaternion=back).angle == pytest.approx(rotated.distance)


LEG_TO_NOTHING = """
legs: [Aa, Bb, Cc, Dd, Ee, Ff]
points: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0], D: [-3, 1, 0], E: [1, -3, 0], F: [2, 3, 1],
         a: [0, 0, 1/10], b: [2, 1, 4], c: [1, 3, 3], d: [-1, 3, 3], e: [-1, -2, 3], f: [2, -3, 3]}
"""


def test_a_leg_may_vanish_in_a_singular_pose() -> None:
    """The pose in which Aa has no length is singular; the nearest one is no farther, and nothing stumbles over it."""
    robot = parse_platform(LEG_TO_NOTHING)
    found = gc.pose(robot, nearest=False, threshold="0.1 deg").rig
    points = found.exact(Pose())
    assert (
        translation_polynomial(found.structure.legs, points, found.structure.platform, F(1))(F(0), F(0), F(-1, 10)) == 0
    )
    translation = gc.pose(robot).nearest[0]
    assert translation.certified
    assert translation.distance <= 0.1 * (1 + 1e-9)
    there = _checked(found, translation, Pose((F(0), F(0), F(-1, 10))))
    assert there.exact
    assert there.sigma == 0
    assert there.causes == ("The leg Aa has no length: A and a are in the same place.",)


def test_exact_nearest_pose(robots: dict[str, Analysis]) -> None:
    """The platform's joints in the plane of the base's: found as an exact pose."""
    translation = gc.pose(robots["four-dof"]).nearest[0]
    assert translation.pose.translation == (0, 0, F(-7, 10))
    assert translation.exact
    assert gc.pose(robots["four-dof"], "0 0 -0.7").superbracket == 0
