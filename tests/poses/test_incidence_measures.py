"""The measures of incidences: of four planes, tetrahedra, planes and lines, and where they do not count."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from poses.structures import ANALYSES, STRUCTURES

import gcrules as gc
from gcrules.algebra.evaluate import evaluate
from gcrules.conditions.analysis import Analysis
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.extensors import mutual_moment, normalised, plane_equation
from gcrules.poses.numbers.incidence_measures import NEAR_ZERO, readings

seeds = st.integers(0, 2**32 - 1)


def random_points(a: Analysis, seed: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    return {n: np.concatenate([rng.normal(size=(4, 3)), np.ones((4, 1))], axis=1) for n in a.structure.names}


@pytest.mark.parametrize("legs", STRUCTURES)
@settings(max_examples=15, deadline=None)
@given(seed=seeds, scale=st.floats(0.05, 50))
def test_readings_know_neither_frame_nor_unit(legs: str, seed: int, scale: float) -> None:
    a = ANALYSES[legs]
    points = random_points(a, seed)
    rng = np.random.default_rng(seed + 1)
    turn, shift = matrices(rng.normal(size=(1, 4)))[0], rng.normal(size=3)
    moved = {n: np.concatenate([scale * p[:, :3] @ turn.T + shift, p[:, 3:]], axis=1) for n, p in points.items()}
    conditions = (a.condition, *a.readings)
    here, there = readings(conditions, points), readings(conditions, moved)
    assert here
    for x, y in zip(here, there, strict=True):
        both = x.valid & y.valid
        factor = scale**x.power
        assert np.allclose(x.values[both] * factor, y.values[both], rtol=1e-5, atol=1e-7 * factor), x.name
        if not x.power:
            assert ((x.values[both] >= 0) & (x.values[both] <= 1 + 1e-12)).all()
    assert np.allclose(normalised(a.condition.cofactor, points), normalised(a.condition.cofactor, moved), rtol=1e-5)


def test_readings_of_four_planes() -> None:
    """The spread is the least largest distance, the clearance a shift of one plane that closes the tetrahedron."""
    a = ANALYSES["ab af cb cd ed ef"]
    points = {n: p[:1] for n, p in random_points(a, 5).items()}
    found = {(r.part, r.name): r.values[0] for r in readings((a.condition,), points)}
    part = str(a.condition.expression)
    planes = np.stack(
        [plane_equation(np.array([evaluate(p, points)]).reshape(1, 4))[0] for p in a.condition.expression.children]
    )
    planes /= np.linalg.norm(planes[:, :3], axis=1)[:, None]
    best = np.inf
    x = np.linalg.lstsq(planes[:, :3], -planes[:, 3], rcond=None)[0]
    for signs in itertools.product((1, -1), repeat=3):  # where the largest distances are equal: s_i d_i = t
        matrix = np.concatenate([planes[:, :3], -np.array([1, *signs])[:, None]], axis=1)
        *x, t = np.linalg.solve(matrix, -planes[:, 3])
        if np.abs(planes[:, :3] @ x + planes[:, 3]).max() <= abs(t) + 1e-9:
            best = min(best, abs(t))
    assert found[part, "spread of the planes"] == pytest.approx(best)
    for moved in range(4):
        corner = np.linalg.solve(np.delete(planes, moved, 0)[:, :3], -np.delete(planes, moved, 0)[:, 3])
        assert abs(planes[moved, :3] @ corner + planes[moved, 3]) >= found[part, "clearance"] - 1e-9


def test_readings_of_a_tetrahedron() -> None:
    a = ANALYSES["Aa Ab Ac Bd Be Cf"]
    corners = {"A": (0, 0, 0), "a": (1, 1, 0), "b": (1, 0, 1), "c": (0, 1, 1)}  # regular, edges √2
    points = {n: np.array([[*corners.get(n, (i, i * i, 1)), 1.0]]) for i, n in enumerate(a.structure.names)}
    found = {r.name: r.values[0] for r in readings((a.condition,), points) if r.part == "[Aabc]"}
    assert found["normalised volume"] == pytest.approx(1)
    assert found["smallest height"] == pytest.approx(2 / math.sqrt(3))
    assert found["third singular value"] == pytest.approx(1)


def test_readings_of_two_planes_and_a_line() -> None:
    a = ANALYSES["Aa Ab Ac Bd Ce Df"]
    places = {"A": (0, 0, 0), "B": (0, 0, 1), "d": (1, 0, 0), "C": (0, 0, 2), "e": (0, 1, 0)}  # planes of the z axis
    places |= {"D": (3, -1, 5), "f": (3, 1, 5), "a": (1, 2, 4), "b": (4, 2, 1), "c": (5, 3, 3)}
    points = {n: np.array([[*p, 1.0]]) for n, p in places.items()}
    found = {r.name: r.values[0] for r in readings((a.condition,), points) if "Df" in r.part}
    assert found["clearance"] == pytest.approx(3)
    assert 0 < found["reciprocal condition number"] < 1
    points["D"], points["f"] = np.array([[3, -3, 5, 1.0]]), np.array([[1, -1, 4, 1.0]])  # through (0, 0, 7/2)
    found = {r.name: r.values[0] for r in readings((a.condition,), points) if "Df" in r.part}
    assert found["clearance"] == pytest.approx(0, abs=1e-12)
    assert found["reciprocal condition number"] == pytest.approx(0, abs=1e-12)


def test_a_reading_is_not_valid_where_its_cofactor_is_near_zero() -> None:
    a = ANALYSES["Aa Ab Bc Cd De Ef"]
    points = random_points(a, 3)
    before = readings((a.condition,), points)
    assert before[0].valid.all()
    arm = {n: (points[n] - points["A"])[:, :3] for n in "BcCd"}
    p = np.cross(np.cross(arm["B"], arm["c"]), np.cross(arm["C"], arm["d"]))  # along the meet of ABc and ACd
    points["a"] = points["A"] + np.concatenate([p, np.zeros((4, 1))], axis=1)
    found = readings((a.condition,), points)
    assert (normalised(a.condition.cofactor, points) < NEAR_ZERO).all()
    assert not found[0].valid.any()
    assert "near zero" in found[0].why


def test_mutual_moments() -> None:
    z = np.array([evaluate(gc.parse("ab"), {"a": (0, 0, 0, 1), "b": (0, 0, 2, 1)})], float)
    x = np.array([evaluate(gc.parse("ab"), {"a": (0, 3, 5, 1), "b": (7, 3, 5, 1)})], float)
    assert abs(mutual_moment(z, x)[0]) == pytest.approx(3)
