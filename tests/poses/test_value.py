"""Numbers in a pose: the measure does not know the frame, is zero just where singular; lines are drawn right."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Point, join
from gcrules.algebra.language.legs_text import read_legs
from gcrules.conditions.pose_value import XYZ, line_measure, line_points, measure, pose_value
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.screws.verdict import CLOSE

Pose = dict[str, tuple[int, int, int]]
LEGS = ["ab af cb cd ed ef", "Aa Bb Cc Dd Ee Ff", "Aa Ab Ba Bb Cc Dd", "Aa Ab Ac Bd Be Cf", "Aa Ab Bc Cd De Ef"]
ANALYSES = {legs: analyze_legs(legs) for legs in LEGS}
finite = st.floats(-3, 3, allow_nan=False)


@st.composite
def poses(draw: st.DrawFn, legs: str) -> Pose:
    point = st.tuples(*[st.integers(-6, 6)] * 3)
    names = ANALYSES[legs].structure.names
    return dict(zip(names, draw(st.lists(point, min_size=len(names), max_size=len(names), unique=True)), strict=True))


def moved(pose: Pose, angles: tuple[float, float, float], shift: tuple[float, float, float], scale: float) -> Pose:
    m = np.eye(3)
    for axis, angle in enumerate(angles):
        i, j = [k for k in range(3) if k != axis]
        turn = np.eye(3)
        turn[i, i] = turn[j, j] = np.cos(angle)
        turn[i, j], turn[j, i] = -np.sin(angle), np.sin(angle)
        m = turn @ m
    return {n: tuple(scale * (m @ np.array(p)) + np.array(shift)) for n, p in pose.items()}


def exact(pose: Pose) -> dict[str, tuple[Fraction, ...]]:
    return {n: (*map(Fraction, p), Fraction(1)) for n, p in pose.items()}


@pytest.mark.parametrize("legs", LEGS)
@settings(max_examples=40)
@given(data=st.data())
def test_frame_and_unit_do_not_matter(legs: str, data: st.DataObject) -> None:
    pose = data.draw(poses(legs))
    structure = ANALYSES[legs].structure
    elsewhere = moved(
        pose,
        data.draw(st.tuples(finite, finite, finite)),
        data.draw(st.tuples(finite, finite, finite)),
        data.draw(st.floats(0.01, 1000)),
    )
    for here, there in (
        (measure(structure, pose), measure(structure, elsewhere)),
        (line_measure(structure.legs, pose), line_measure(structure.legs, elsewhere)),
    ):
        assert 0 <= here <= 1 + 1e-12
        assert there == pytest.approx(here, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("legs", LEGS)
@settings(max_examples=40)
@given(data=st.data())
def test_zero_exactly_where_singular(legs: str, data: st.DataObject) -> None:
    a = ANALYSES[legs]
    pose = data.draw(poses(legs))
    if data.draw(st.booleans()):  # six joints in one plane make many of these poses singular
        pose = {n: (p[0], p[1], 0) for n, p in pose.items()}
        assume(len(set(pose.values())) == len(pose))
    found = pose_value(a.structure, a.condition, exact(pose))
    points = exact(pose)
    assert found.superbracket == evaluate(a.structure.superbracket, points)
    assert found.cofactor * found.superbracket == found.condition
    assert (found.verdict == "singular") == (found.superbracket == 0) == (found.margin == 0)
    assert (found.verdict == "close") == (0 < found.margin < CLOSE)
    if found.superbracket:
        assert found.margin == pytest.approx(measure(a.structure, pose))


def test_all_verdicts_occur() -> None:
    a = ANALYSES["ab af cb cd ed ef"]
    pose = {"a": (4, 0, 0), "c": (-2, 3, 0), "e": (-2, -3, 0), "b": (1, 2, 3), "d": (-3, 0, 3), "f": (1, -2, 3)}
    flat = {n: (*p[:2], 0) for n, p in pose.items()}
    regular, close, singular = (
        pose_value(a.structure, a.condition, exact(p), close=c) for p, c in ((pose, 1e-9), (pose, 1.0), (flat, 1e-3))
    )
    assert (regular.verdict, close.verdict, singular.verdict) == ("regular", "close", "singular")
    assert singular.to_json()["superbracket"] == "0"


def test_a_leg_of_no_length() -> None:
    assert line_measure((("a", "b"),) * 6, {"a": (1, 2, 3), "b": (1, 2, 3)}) == 0
    structure = ANALYSES["ab af cb cd ed ef"].structure
    assert measure(structure, dict.fromkeys("acebdf", (1, 2, 3))) == 0


def test_lines_without_bodies() -> None:
    """The edges of a tetrahedron: regular, but no joint is known to move."""
    structure = read_legs("ab ac ad bc bd cd")
    corners = {"a": (0, 0, 0), "b": (1, 0, 0), "c": (0, 1, 0), "d": (0, 0, 1)}
    assert measure(structure, corners) == line_measure(structure.legs, corners) > 0


triples = st.tuples(*[st.integers(-9, 9)] * 3)


@given(triples, triples, triples, st.floats(0.1, 50))
def test_line_points(a: XYZ, b: XYZ, centre: XYZ, reach: float) -> None:
    assume(a != b)
    plucker = evaluate(join(Point("a"), Point("b")), {"a": (*a, 1), "b": (*b, 1)})
    ends = line_points(plucker, centre, reach)
    assert ends is not None
    first, last = np.array(ends[0]), np.array(ends[1])
    direction = (np.array(b) - np.array(a)) / np.linalg.norm(np.array(b) - np.array(a))
    for p in (first, last):
        assert np.linalg.norm(np.cross(p - np.array(a), direction)) == pytest.approx(0, abs=1e-6)
    assert np.allclose(last - first, 2 * reach * direction, atol=1e-6)
    assert np.dot((first + last) / 2 - np.array(centre), direction) == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("plucker", [(0, 0, 0, 0, 0, 0), (1, 0, 0, 0, 0, 0), (2, 3, 0, 1, 0, 0)])
def test_no_points_for_lines_at_infinity(plucker: tuple[int, ...]) -> None:
    assert line_points(plucker, (0, 0, 0), 1) is None
