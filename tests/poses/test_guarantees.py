"""The measure is the same in every frame and unit, and its guarantees hold and say something."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from poses.platforms import PLATFORMS

import gcrules as gc
from gcrules.conditions.analysis import Analysis
from gcrules.poses.nearest.cover import free_angle, free_distance
from gcrules.poses.nearest.multistart import Determinant, best_zero
from gcrules.poses.nearest.zero import nearest_zero
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.poses.numbers.cubic import translation_polynomial
from gcrules.screws.guarantees import guarantees, noise
from gcrules.screws.margin import LegJacobians, jacobian

F = Fraction
seeds = st.integers(0, 2**32 - 1)


def random_robot(seed: int, number: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Base points (6, 3) and platform points (number, 6, 3) of a robot that moves a little from pose to pose."""
    rng = np.random.default_rng(seed)
    base, arms = rng.normal(size=(6, 3)), rng.normal(size=(6, 3)) * rng.uniform(0.3, 1.5)
    turns = matrices(from_vectors(rng.normal(size=(number, 3)) * 0.5))
    ends = np.einsum("nij,kj->nki", turns, arms) + rng.normal(size=(number, 1, 3)) * 0.3 + [0, 0, 2]
    return base, ends


# --- the measure and its guarantees --------------------------------------------------------------------------------


@settings(max_examples=60)
@given(seeds, st.floats(0.01, 100))
def test_sigma_knows_neither_frame_nor_unit(seed: int, scale: float) -> None:
    base, ends = random_robot(seed, 3)
    rng = np.random.default_rng(seed + 1)
    turn = matrices(rng.normal(size=(1, 4)))[0]
    shift = rng.normal(size=3) * 5
    j = jacobian(base, ends)
    k = jacobian(scale * (base @ turn.T) + shift, scale * (ends @ turn.T) + shift)
    assert ((j.sigma >= 0) & (j.sigma <= 1)).all()
    assert np.allclose(j.sigma, k.sigma, rtol=1e-6, atol=1e-10)
    assert np.allclose(j.singular_values, k.singular_values, rtol=1e-6, atol=1e-10)
    for name in ("turn", "rotation"):
        assert np.allclose(getattr(guarantees(j), name), getattr(guarantees(k), name), rtol=1e-6, atol=1e-9)
    for name in ("shift", "combined"):
        assert np.allclose(scale * getattr(guarantees(j), name), getattr(guarantees(k), name), rtol=1e-6, atol=1e-9)


@settings(max_examples=40)
@given(seeds)
def test_sigma_is_what_it_says(seed: int) -> None:
    """No twist does better, the softest one does as well; the stress balances up to σ."""
    base, ends = random_robot(seed)
    j = jacobian(base, ends)
    twists = np.concatenate([np.random.default_rng(seed).normal(size=(500, 6)), j.softest])
    velocities = twists[:, None, :3] + np.cross(twists[:, None, 3:], j.arms / j.radius)
    rates = (velocities * j.directions).sum(axis=2)
    ratio = np.sqrt((rates**2).sum(axis=1) / (velocities**2).sum(axis=(1, 2)))
    assert ratio.min() == pytest.approx(j.sigma[0], rel=1e-9)
    assert ratio[-1] == pytest.approx(j.sigma[0], rel=1e-6)
    assert (velocities[-1] ** 2).sum() / 6 == pytest.approx(1)


def leg_turns(base: np.ndarray, ends: np.ndarray, other: np.ndarray) -> float:
    """The largest turn of a leg relative to the platform between two poses, the platform's own turn taken off."""
    arms, moved = ends - ends.mean(axis=0), other - other.mean(axis=0)
    u, _, v = np.linalg.svd(moved.T @ arms)
    turn = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v  # arms → moved
    a, b = ends - base, (other - base) @ turn
    cosine = (a * b).sum(axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
    return float(np.arccos(np.clip(cosine, -1, 1)).max())


def singular_poses(base: np.ndarray, j: LegJacobians, dimension: int, reach: float, seed: int) -> np.ndarray:
    """Singular displacements along random rays, the nearest one last."""
    f = Determinant.of(base, j)
    rng = np.random.default_rng(seed)
    found = []
    for x in rng.normal(size=(20, dimension)):
        steps = np.linspace(0, reach, 60)[1:, None] * x / np.linalg.norm(x)
        negative = np.flatnonzero(f(steps) <= 0)
        if len(negative):
            low, high = 0.0, 1.0
            top = steps[negative[0]]
            for _ in range(50):  # some zero on the way to the first negative value
                middle = (low + high) / 2
                low, high = (low, middle) if f(top * middle) <= 0 else (middle, high)
            found.append(top * high)
    best = best_zero(f, dimension, reach) if dimension == 3 else None
    return np.array([*found, *([] if best is None else [best])]).reshape(-1, dimension)


def displaced(j: LegJacobians, x: np.ndarray) -> np.ndarray:
    shift, vector = (np.zeros(3), x) if len(x) == 3 else (x[:3], x[3:] / j.radius)
    return j.arms[0] @ matrices(from_vectors(vector[None, :]))[0].T + j.centroid[0] + shift


@settings(max_examples=5, deadline=None)
@given(seeds)
def test_no_singular_pose_where_the_guarantees_say_so(seed: int) -> None:
    base, ends = random_robot(seed)
    j = jacobian(base, ends)
    c = guarantees(j)
    for dimension, bound in ((3, c.rotation[0]), (6, c.combined[0])):
        reach = 2.0 if dimension == 3 else 4 * j.radius
        for x in singular_poses(base, j, dimension, reach, seed):
            assert leg_turns(base, ends[0], displaced(j, x)) >= c.turn[0] * (1 - 1e-9)
            assert np.linalg.norm(x) >= bound


def as_points(base: np.ndarray, ends: np.ndarray) -> dict[str, tuple[Fraction, ...]]:
    return {
        n: (*(F(float(c)) for c in p), F(1)) for n, p in zip("ABCDEFabcdef", np.concatenate([base, ends]), strict=True)
    }


LEGS = tuple(zip("ABCDEF", "abcdef", strict=True))


@settings(max_examples=5, deadline=None)
@given(seeds)
def test_no_singular_translation_where_the_guarantee_says_so(seed: int) -> None:
    base, ends = random_robot(seed)
    j = jacobian(base, ends)
    f = translation_polynomial(LEGS, as_points(base, ends[0]), "abcdef", F(1))
    zero = nearest_zero(f, 1.0)
    sigma, shortest = j.sigma[0], j.lengths.min()
    bound = guarantees(j).shift[0]
    assert zero.certified
    assert bound >= 2 * sigma * shortest / (2 + sigma) * (1 - 1e-9)  # the simpler bound follows
    assert zero.distance >= bound
    if zero.point is not None:
        other = ends[0] + np.array([float(c) for c in zero.point])
        assert leg_turns(base, ends[0], other) >= guarantees(j).turn[0] * (1 - 1e-9)


def test_the_guarantees_are_not_vacuous(robots: dict[str, Analysis]) -> None:
    """Six legs at right angles in pairs: the bounds come within a small factor of the truth."""
    ends = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    along = np.array([[0, 1, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1], [1, 0, 0], [1, 0, 0]], float)
    j = jacobian(ends - along, ends[None])
    c = guarantees(j)
    assert c.sigma[0] == pytest.approx(math.sqrt(1 / 3))
    x = best_zero(Determinant.of(ends - along, j), 3, math.pi)
    assert x is not None
    assert c.rotation[0] <= np.linalg.norm(x) <= 3 * c.rotation[0]
    zero = nearest_zero(translation_polynomial(LEGS, as_points(ends - along, ends), "abcdef", F(1)), 1.0)
    assert c.shift[0] <= zero.distance <= 2 * c.shift[0]
    for name in PLATFORMS:
        found = gc.pose(robots[name], nearest=False)
        assert found.turn > 0
        assert found.shift > 0


@settings(max_examples=60)
@given(seeds, st.sampled_from([1e-6, 1e-3, 1e-2, 0.05]))
def test_noise_of_coordinates(seed: int, accuracy: float) -> None:
    base, ends = random_robot(seed)
    rng = np.random.default_rng(seed + 7)
    steps = rng.normal(size=(2, 6, 3))
    steps *= accuracy / np.linalg.norm(steps, axis=2, keepdims=True)
    j = jacobian(base, ends)
    moved = jacobian(base + steps[0], ends + steps[1])
    assert abs(moved.sigma[0] - j.sigma[0]) <= noise(j, accuracy)[0] + 1e-12
    assert noise(j, 1e9)[0] == 1


@settings(max_examples=4, deadline=None)
@given(seeds)
def test_angles_that_are_proved_free_hold_no_zero(seed: int) -> None:
    base, ends = random_robot(seed)
    j = jacobian(base, ends)
    free, both = free_angle(base, j, 1.5, limit=2000), free_distance(base, j, j.radius, limit=2000)
    x = best_zero(Determinant.of(base, j), 3, math.pi)
    assert x is None or np.linalg.norm(x) >= free
    assert 0 <= free <= 1.5
    assert 0 <= both <= j.radius
    assert both <= nearest_zero(translation_polynomial(LEGS, as_points(base, ends[0]), "abcdef", F(1)), 1.0).distance
    for x in singular_poses(base, j, 6, 4 * j.radius, seed):
        assert np.linalg.norm(x) >= both
