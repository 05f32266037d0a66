"""Numbers at a pose: guarantees hold and say something, nearest poses are nearest, causes are right, faults told."""

from __future__ import annotations

import itertools
import json
import math
import pickle
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.language.legs_text import read_legs
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.description.platform_file import Platform, load_platform, parse_platform
from gcrules.mechanisms.platform_analysis import analyze
from gcrules.poses.nearest.cover import free_angle, free_distance
from gcrules.poses.nearest.multistart import Determinant, best_zero
from gcrules.poses.nearest.poses import _checked
from gcrules.poses.nearest.taylor import taylor
from gcrules.poses.nearest.zero import fibonacci, nearest_zero
from gcrules.poses.numbers.arrays import from_poses, from_vectors, matrices, read_arrays
from gcrules.poses.numbers.cubic import EXPONENTS, Cubic, determinant, superbracket_at, translation_polynomial
from gcrules.poses.numbers.extensors import mutual_moment, normalised, plane_equation
from gcrules.poses.numbers.incidence_measures import NEAR_ZERO, readings
from gcrules.poses.numbers.motion import dependence, exact_dependence
from gcrules.poses.numbers.variety import signature, variety
from gcrules.screws.guarantees import closeness, noise
from gcrules.screws.margin import Jacobian, jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.rotations import from_euler, product, rotation
from gcrules.screws.threshold import parse_threshold

F = Fraction
EXAMPLES = ("octahedral", "platform-6-3", "platform-6-4", "platform-6-6", "four-dof")
small = st.integers(-6, 6)
seeds = st.integers(0, 2**32 - 1)


@pytest.fixture(scope="module")
def robots(root: Any) -> dict[str, Analysis]:
    return {n: analyze(load_platform(root / "examples" / f"{n}.yaml")) for n in (*EXAMPLES, "octahedral-singular")}


def random_robot(seed: int, number: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Base points (6, 3) and platform points (number, 6, 3) of a robot that moves a little from pose to pose."""
    rng = np.random.default_rng(seed)
    base, arms = rng.normal(size=(6, 3)), rng.normal(size=(6, 3)) * rng.uniform(0.3, 1.5)
    turns = matrices(from_vectors(rng.normal(size=(number, 3)) * 0.5))
    ends = np.einsum("nij,kj->nki", turns, arms) + rng.normal(size=(number, 1, 3)) * 0.3 + [0, 0, 2]
    return base, ends


# --- poses as text and as numbers ----------------------------------------------------------------------------------

HALF = math.sqrt(0.5)


@pytest.mark.parametrize(
    ("text", "translation", "quaternion"),
    [
        ("1 2 3", (1, 2, 3), (1, 0, 0, 0)),
        ("1, -2.5, 1/3", (1, F(-5, 2), F(1, 3)), (1, 0, 0, 0)),
        ("translation 1e-3 0 .5 mm", (F(1, 1000), 0, F(1, 2)), (1, 0, 0, 0)),
        ("0 0 1; quaternion 0 1 0 0", (0, 0, 1), (0, 1, 0, 0)),
        ("quat xyzw 1 0 0 0", (0, 0, 0), (0, 1, 0, 0)),
        ("quaternion 0.6 0 0 0.8; 1 0 0", (1, 0, 0), (F(3, 5), 0, 0, F(4, 5))),
        ("0 0 0; rotation-vector 0 0 90 deg", (0, 0, 0), (1, 0, 0, 1)),
        ("rotvec 180 0 0 degrees", (0, 0, 0), (0, 1, 0, 0)),
        ("euler zyx 90 0 0 deg", (0, 0, 0), (1, 0, 0, 1)),
        ("euler XYZ 0 0 -90 °;", (0, 0, 0), (-1, 0, 0, 1)),
        ("rotation-vector 0 0 0 rad", (0, 0, 0), (1, 0, 0, 0)),
    ],
)
def test_poses_as_text(text: str, translation: tuple[Any, ...], quaternion: tuple[Any, ...]) -> None:
    found = parse_pose(text, "mm")
    assert found.translation == translation
    assert rotation(found.quaternion) == rotation(quaternion)  # exactly
    again = parse_pose(found.text(), "mm")
    assert again.translation == tuple(F(repr(float(c))) for c in found.translation)
    assert np.allclose(np.array(again.rotation, float), np.array(found.rotation, float), atol=1e-15)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "empty"),
        (" ; ", "empty"),
        ("1 2", "3 numbers, found 2"),
        ("1 2 3 4 5", "3 numbers, found 5"),
        ("nan 0 0", "finite"),
        ("0 0 -inf", "finite"),
        ("0 0 x", "expected a number"),
        ("0 0 1/0", "division by zero"),
        ("0 0 1e999999999", "too long"),
        ("0 0 " + "1" * 100, "too long"),
        ("0 0 1 cm", "mixed units"),
        ("0 0 1 parsec", "no unit"),
        ("1 2 3; 4 5 6", "second translation"),
        ("quaternion 1 0 0 0; euler zyx 0 0 0 deg", "second turn"),
        ("quaternion 1 1 0 0", "length 1.41421"),
        ("quaternion 0 0 0 0", "length 0"),
        ("quaternion 1 0 0", "4 numbers"),
        ("euler 1 2 3 deg", "no sequence"),
        ("euler xxz 1 2 3 deg", "no sequence"),
        ("euler xYz 1 2 3 deg", "no sequence"),
        ("euler", "without their sequence"),
        ("euler zyx 1 2 3", "without a unit"),
        ("rotation-vector 1 2 3", "without a unit"),
        ("quaternoin 1 0 0 0", "no part of a pose"),
    ],
)
def test_poses_at_fault(text: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_pose(text, "mm")
    assert says in str(caught.value)
    assert caught.value.exit_code == 2


def test_a_fault_has_its_place() -> None:
    with pytest.raises(GcrulesError) as caught:
        parse_pose("0 0 0; euler zyx 1 2 3", "mm")
    assert caught.value.render().splitlines()[:3] == [
        "error: --at:1:8: angles without a unit",
        "  0 0 0; euler zyx 1 2 3",
        "         ^^^^^^^^^^^^^^^",
    ]


def test_a_quaternion_that_is_nearly_of_length_1_is_normalised_and_noted() -> None:
    found = parse_pose("quaternion 0.7071 0 0 0.7071")
    assert "normalised" in found.notes[0]
    assert sum(c * c for c in found.unit_quaternion) == pytest.approx(1)
    assert rotation(found.quaternion) == rotation((F(1), F(0), F(0), F(1)))
    assert parse_pose(f"quaternion {HALF} 0 0 {HALF}").notes == ()


@pytest.mark.parametrize(
    ("given_numbers", "says"),
    [
        (np.zeros((2, 3), dtype=complex), "not numbers"),
        (np.zeros((2, 3), dtype=bool), "not numbers"),
        (np.array([["1", "2", "3"]]), "not numbers"),
        (np.array([[1, 2, 10**400]], dtype=object), "not numbers"),
        (np.array([[1, 2, 3j]], dtype=object), "not numbers"),
        (np.array([[1, None, 3]], dtype=object), "row 0 is not finite"),
        (np.ma.masked_array(np.zeros((2, 3)), mask=np.eye(2, 3)), "masked"),
    ],
    ids=["complex", "truth values", "text", "too large", "complex objects", "nothing", "masked"],
)
def test_arrays_of_other_things_are_refused(given_numbers: Any, says: str) -> None:
    """Nothing is converted silently: an imaginary part or a mask would be lost."""
    with pytest.raises(InputError, match=says):
        gc.pose(OCTAHEDRON, given_numbers)


def test_normalised_quaternions_of_arrays_are_noted() -> None:
    exactly = gc.pose(OCTAHEDRON, quaternion=[(1, 0, 0, 0), (HALF, 0, 0, HALF)])
    nearly = gc.pose(OCTAHEDRON, quaternion=[(1, 0, 0, 0), (0.7071, 0, 0, 0.7071)])
    assert exactly.notes == ()
    assert nearly.notes == ("quaternions normalised: 1, off from length 1 by up to 9.6e-06",)
    assert np.allclose(nearly.value, exactly.value)
    listed = gc.pose(OCTAHEDRON, ["0 0 0; quaternion 0.7071 0 0 0.7071"])
    assert "normalised" in listed.notes[0]


@given(st.tuples(small, small, small, small).filter(any))
def test_matrices_of_quaternions_are_exactly_orthogonal(q: tuple[int, int, int, int]) -> None:
    m = rotation(tuple(map(F, q)))  # type: ignore[arg-type]
    for i, j in itertools.product(range(3), repeat=2):
        assert sum(a * b for a, b in zip(m[i], m[j], strict=True)) == (i == j)
    assert determinant(m) == 1
    assert np.allclose(matrices(np.array([q], float))[0], np.array(m, float))


SEQUENCES = [s for s in map("".join, itertools.product("xyz", repeat=3)) if s[0] != s[1] != s[2]]


@pytest.mark.parametrize("sequence", [*SEQUENCES, *(s.upper() for s in SEQUENCES)])
def test_euler_angles_are_products_of_turns(sequence: str) -> None:
    angles = (0.3, -1.1, 2.0)
    expected = np.eye(3)
    for letter, angle in zip(sequence, angles, strict=True):
        i = "xyz".index(letter.lower())
        j, k = (i + 1) % 3, (i + 2) % 3
        turn = np.eye(3)
        turn[j, j] = turn[k, k] = math.cos(angle)
        turn[k, j], turn[j, k] = math.sin(angle), -math.sin(angle)
        # about fixed axes later turns stand to the left, about turning axes to the right
        expected = turn @ expected if sequence.islower() else expected @ turn
    found = from_euler(sequence, [F(repr(a)) for a in angles], degrees=False)
    assert np.allclose(np.array(rotation(found), float), expected, atol=1e-14)
    assert np.allclose(read_arrays(euler=(sequence, [angles]))[1][0], expected, atol=1e-14)


@given(st.tuples(*[st.floats(-7, 7).map(lambda c: round(c, 9))] * 3))
def test_rotation_vectors(v: tuple[float, float, float]) -> None:
    one = parse_pose("rotvec {} {} {} rad".format(*map(repr, v)))
    many = read_arrays(rotation_vectors=[v])[1][0]
    assert np.allclose(np.array(one.rotation, float), many, atol=1e-13)
    size = math.hypot(*v) % (2 * math.pi)
    assert one.angle == pytest.approx(min(size, 2 * math.pi - size), abs=1e-7)


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
        assert np.allclose(getattr(closeness(j), name), getattr(closeness(k), name), rtol=1e-6, atol=1e-9)
    for name in ("shift", "combined"):
        assert np.allclose(scale * getattr(closeness(j), name), getattr(closeness(k), name), rtol=1e-6, atol=1e-9)


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


def singular_poses(base: np.ndarray, j: Jacobian, dimension: int, reach: float, seed: int) -> np.ndarray:
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


def displaced(j: Jacobian, x: np.ndarray) -> np.ndarray:
    shift, vector = (np.zeros(3), x) if len(x) == 3 else (x[:3], x[3:] / j.radius)
    return j.arms[0] @ matrices(from_vectors(vector[None, :]))[0].T + j.centroid[0] + shift


@settings(max_examples=5, deadline=None)
@given(seeds)
def test_no_singular_pose_where_the_guarantees_say_so(seed: int) -> None:
    base, ends = random_robot(seed)
    j = jacobian(base, ends)
    c = closeness(j)
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
    bound = closeness(j).shift[0]
    assert zero.certified
    assert bound >= 2 * sigma * shortest / (2 + sigma) * (1 - 1e-9)  # the simpler bound follows
    assert zero.distance >= bound
    if zero.point is not None:
        other = ends[0] + np.array([float(c) for c in zero.point])
        assert leg_turns(base, ends[0], other) >= closeness(j).turn[0] * (1 - 1e-9)


def test_the_guarantees_are_not_vacuous(robots: dict[str, Analysis]) -> None:
    """Six legs at right angles in pairs: the bounds come within a small factor of the truth."""
    ends = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    along = np.array([[0, 1, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1], [1, 0, 0], [1, 0, 0]], float)
    j = jacobian(ends - along, ends[None])
    c = closeness(j)
    assert c.sigma[0] == pytest.approx(math.sqrt(1 / 3))
    x = best_zero(Determinant.of(ends - along, j), 3, math.pi)
    assert x is not None
    assert c.rotation[0] <= np.linalg.norm(x) <= 3 * c.rotation[0]
    zero = nearest_zero(translation_polynomial(LEGS, as_points(ends - along, ends), "abcdef", F(1)), 1.0)
    assert c.shift[0] <= zero.distance <= 2 * c.shift[0]
    for name in EXAMPLES:
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
    assert both.distance <= min(translation.distance, found.radius * rotated.distance) * (1 + 1e-9)
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


# --- readings ------------------------------------------------------------------------------------------------------

STRUCTURES = ["ab af cb cd ed ef", "Aa Ab Ac Bd Be Cf", "Aa Ab Ac Bd Ce Df", "Aa Ab Ba Bb Cc Dd", "Aa Ab Bc Cd De Ef"]
ANALYSES = {legs: analyze(legs) for legs in STRUCTURES}


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


# --- at a singular pose --------------------------------------------------------------------------------------------


def line(p: tuple[int, ...], q: tuple[int, ...]) -> tuple[Fraction, ...]:
    u = [F(b - a) for a, b in zip(p, q, strict=True)]
    return (*u, *(F(int(c)) for c in np.cross(p, q)))


O3 = (0, 0, 0)
RULING = [line((t, 0, 0), (t, 1, t)) for t in (1, 2, -1, 3)]  # of z = xy
MEETING = [
    line((s, 0, 0), (0, t, 1)) for s, t in ((1, 1), (2, -1), (3, 5), (-1, 2), (4, 3))
]  # y = z = 0 and x = 0, z = 1
TURNED = [  # of the elliptic congruence spanned by rulings of hyperboloids about the z axis
    line((r, 0, 0), (r, r, 1)) for r in (1, 2)
] + [line((0, r, 0), (-r, r, 1)) for r in (1, 3)]


@pytest.mark.parametrize(
    ("lines", "name"),
    [
        pytest.param([line(O3, (1, 2, 3))], "a single line", id="line"),
        pytest.param([line(O3, (1, 0, 0)), line((0, 0, 1), (0, 1, 1))], "two skew lines", id="skew"),
        pytest.param([line(O3, (1, 0, 0)), line(O3, (0, 1, 0))], "a planar pencil", id="pencil"),
        pytest.param([line(O3, (1, 0, 0)), line((0, 1, 0), (1, 1, 0))], "a planar pencil", id="parallel"),
        pytest.param([line(O3, e) for e in ((1, 0, 0), (0, 1, 0), (1, 1, 1))], "a bundle", id="bundle"),
        pytest.param([line(p, (*p[:2], 1)) for p in (O3, (1, 0, 0), (0, 1, 0))], "a bundle", id="parallel bundle"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line((1, 0, 0), (0, 1, 0))], "a plane field", id="plane"
        ),
        pytest.param(RULING[:3], "a regulus", id="regulus"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line((1, 0, 0), (1, 0, 1))],
            "two planar pencils with a common line",
            id="two pencils",
        ),
        pytest.param(MEETING[:4], "a hyperbolic linear congruence", id="hyperbolic"),
        pytest.param(TURNED, "an elliptic linear congruence", id="elliptic"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line(O3, (0, 0, 1)), line((1, 0, 0), (0, 1, 0))],
            "a degenerate linear congruence",
            id="bundle and plane",
        ),
        pytest.param(
            [line((0, 0, 0), (1, 0, 0)), *(line((x, 0, 0), (x, 1, x)) for x in (1, 2, 3))],
            "a parabolic linear congruence",
            id="parabolic",
        ),
        pytest.param(
            [
                line((0, 0, z), p)
                for z, p in ((0, (1, 0, 0)), (1, (0, 1, 0)), (2, (1, 1, 0)), (3, (1, 5, 2)), (5, (2, 0, 1)))
            ],
            "a special linear complex (all lines that meet one line)",
            id="special",
        ),
        pytest.param(
            [line((0, x, z), (y, 1, z)) for x, y, z in ((0, 1, 0), (1, 3, 1), (4, 2, 2), (2, 7, 3), (5, 1, 5))],
            "a special linear complex (all lines parallel to one plane)",
            id="parallel to a plane",
        ),
        pytest.param([*TURNED, line((1, 0, 0), (5, 3, 2))], "a general linear complex", id="general"),
        pytest.param(
            [line(O3, e) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
            + [line((1, 0, 0), (0, 1, 0)), line((0, 1, 0), (0, 0, 1)), line((1, 0, 0), (0, 0, 1))],
            "no variety",
            id="tetrahedron",
        ),
    ],
)
def test_line_varieties(lines: list[tuple[Fraction, ...]], name: str) -> None:
    assert variety(lines).name.startswith(name)
    # the same in floats, from an orthonormal basis of the span
    rows = np.array(lines, float)
    basis = np.linalg.svd(rows)[2][: len(rows)]
    assert variety([tuple(r) for r in basis], 1e-9).name.startswith(name)


@given(st.lists(st.lists(small, min_size=4, max_size=4), min_size=4, max_size=4))
def test_signatures(rows: list[list[int]]) -> None:
    m = np.array(rows)
    form = m + m.T
    values = np.linalg.eigvalsh(form.astype(float))
    expected = ((values > 1e-9).sum(), (values < -1e-9).sum(), (abs(values) <= 1e-9).sum())
    assert signature([[F(int(c)) for c in row] for row in form]) == expected


def test_causes_motion_and_legs(robots: dict[str, Analysis]) -> None:
    found = gc.pose(robots["octahedral-singular"])
    assert found.verdict == "singular"
    assert found.value == found.closeness == found.turn == 0
    assert found.causes[0] == "The planes abc, aef, bdf and cde meet in a point: (453.488, -9.30233, 418.605) mm."
    assert all(n.distance == 0 and n.exact for n in found.nearest)
    d = found.dependence
    (motion,) = d.motions
    assert d.exact
    assert d.within.name == "a general linear complex"
    assert motion.kind == "screw motion"
    points = {n: np.array([float(c) for c in p]) for n, p in found.rig.points.items()}
    for a, b in found.rig.legs:  # the motion moves each joint across its leg
        velocity = np.cross(motion.axis, points[b] - motion.point) + motion.pitch * np.array(motion.axis)
        assert velocity @ (points[b] - points[a]) == pytest.approx(0, abs=1e-6)
    forces = np.array(
        [
            s * (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
            for s, (a, b) in zip(d.stress, found.rig.legs, strict=True)
        ]
    )
    moments = np.cross([points[a] for a, _ in found.rig.legs], forces)
    assert np.allclose(forces.sum(axis=0), 0)
    assert np.allclose(moments.sum(axis=0), 0, atol=1e-9)


PENCIL = """
legs: [Aa, Ab, Bc, Cd, De, Ef]
points: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0], D: [-3, 1, 0], E: [1, -3, 0],
         a: [1, 0, 2], b: [2, 0, 4], c: [3, 1, 3], d: [1, 3, 3], e: [-3, 2, 3], f: [2, -3, 3]}
"""


FOUR_LEGS_MEET = """
legs: [Aa, Ab, Ac, Ad, Be, Cf]
points: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0],
         a: [1, 0, 2], b: [0, 1, 2], c: [-1, 0, 2], d: [0, -1, 3], e: [2, 1, 2], f: [1, 2, 2]}
"""


def test_two_legs_in_one_line() -> None:
    found = gc.pose(parse_platform(PENCIL), nearest=False)
    assert found.verdict == "singular"
    assert found.dependence.legs == ("Aa", "Ab")
    assert found.dependence.within.name == "a single line"
    assert found.dependence.stress == (1, -1, 0, 0, 0, 0)


@pytest.mark.parametrize("angle", [90, -90, 270])
def test_turned_by_a_right_angle(angle: int) -> None:
    """Similar hexagons, one turned by 90°: singular wherever the platform is, found exactly."""
    octahedron = """
legs: [ab, af, cb, cd, ed, ef]
points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
"""
    found = gc.pose(parse_platform(octahedron), f"0 0 0; euler zyx {angle} 0 0 deg", nearest=False)
    assert found.superbracket == 0
    assert found.verdict == "singular"
    near = gc.pose(parse_platform(octahedron), f"0 0 0; euler zyx {angle + 0.001} 0 0 deg", nearest=False)
    assert near.verdict == "close"
    assert near.superbracket != 0


def test_nearly_incident(robots: dict[str, Analysis]) -> None:
    found = gc.pose(robots["four-dof"], "0 0 -0.699999999", nearest=False)
    assert found.verdict == "close"
    assert found.causes == ("Nearly: the tetrahedron A1 B1 C1 S1 is flat: its four points lie in one plane.",)
    assert found.dependence is None
    assert [name for name, s in zip(found.rig.names, found.stress, strict=True) if abs(s) > 1e-3] == [
        "A1S1",
        "B1S1",
        "C1S1",
    ]
    below = gc.pose(robots["four-dof"], "0 0 -7/10", nearest=False)
    assert below.verdict == "singular"
    assert below.causes == ("The tetrahedron A1 B1 C1 S1 is flat: its four points lie in one plane.",)
    assert below.dependence.within.name == "a planar pencil"


def test_always_singular() -> None:
    found = gc.pose(parse_platform(FOUR_LEGS_MEET))
    assert found.verdict == "singular"
    assert found.causes[0].startswith("The robot is singular in every pose: four legs meet in the joint A")
    assert found.dependence.legs == ("Aa", "Ab", "Ac", "Ad")
    assert found.dependence.within.name.startswith("a bundle")


def test_singular_in_floats_only(robots: dict[str, Analysis]) -> None:
    """A singular pose rounded to floats is recognised, with the same motion as the exact one beside it."""
    a = robots["octahedral"]
    best = gc.pose(a, "0 0 0; euler zyx 10 20 30 deg").nearest[0]
    found = gc.pose(a, best.pose, nearest=False)
    assert found.superbracket != 0
    assert found.verdict == "singular"
    assert not found.dependence.exact
    assert found.dependence.within.name == "a general linear complex"
    j = jacobian(found.rig.base, found.rig.ends(*from_poses([best.pose])))
    (motion,) = found.dependence.motions
    velocity = np.cross(motion.axis, j.arms[0] + j.centroid[0] - motion.point) + motion.pitch * np.array(motion.axis)
    assert np.abs((velocity * j.directions[0]).sum(axis=1)).max() <= 1e-9 * np.abs(velocity).max()


@pytest.mark.parametrize("kind", ["bundle", "pencil", "plane", "axis"])
@settings(max_examples=10, deadline=None)
@given(seed=seeds)
def test_floats_and_exact_arithmetic_agree_on_dependence(kind: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    places = {n: tuple(map(int, rng.integers(-4, 5, size=3))) for n in "ABCDEFabcdef"}
    match kind:
        case "bundle":
            places |= dict.fromkeys("BCD", places["A"])
        case "pencil":
            places |= dict.fromkeys("ABC", (0, 0, 0)) | {n: (*places[n][:2], 0) for n in "abc"}
        case "plane":
            places |= {n: (*places[n][:2], 0) for n in "ABCDabcd"}
        case "axis":
            places |= {n: (0, 0, places[n][2]) for n in "ABCDE"} | {"F": (0, 0, 5)}
    assume(all(places[a] != places[b] for a, b in LEGS))
    points = {n: (*map(F, p), F(1)) for n, p in places.items()}
    ends = np.array([[float(c) for c in places[b]] for _, b in LEGS])
    assume(np.linalg.matrix_rank(ends - ends[0], tol=1e-9) >= 2)
    base = np.array([[float(c) for c in places[a]] for a, _ in LEGS])
    j = jacobian(base, ends[None])
    names = [a + b for a, b in LEGS]
    assert superbracket_at(LEGS, points) == 0
    one, other = exact_dependence(LEGS, names, points, j.centroid[0]), dependence(j, names)
    assert one.legs == other.legs
    assert one.within == other.within
    assert one.all_legs == other.all_legs
    assert len(one.motions) == len(other.motions)


# --- verdicts ------------------------------------------------------------------------------------------------------


def test_a_length_takes_the_places_as_exact(robots: dict[str, Analysis]) -> None:
    """A shift that is free of singular poses says nothing of joints that are elsewhere."""
    robot = next(iter(robots.values()))
    with pytest.raises(InputError, match="takes the joints' places as exact"):
        gc.pose(robot, threshold="1 mm", accuracy="1 mm", nearest=False)
    assert "for the joints' places as given" in gc.pose(robot, accuracy="1 mm", nearest=False).text()


@pytest.mark.parametrize(
    ("name", "threshold", "accuracy", "verdict"),
    [
        ("octahedral", "0.5 deg", None, "regular"),
        ("octahedral", "30deg", None, "close"),
        ("octahedral", "0.6 rad", None, "close"),
        ("octahedral", "349 mm", None, "regular"),
        ("octahedral", "351 mm", None, "close"),
        ("octahedral", "0.5 deg", "40 mm", "close"),
        ("octahedral", "0.5 deg", "1", "regular"),
        ("octahedral-singular", "0.5 deg", None, "singular"),
        ("platform-6-4", "0.5 deg", None, "regular"),
        ("platform-6-4", "1 deg", None, "close"),
    ],
)
def test_verdicts(robots: dict[str, Analysis], name: str, threshold: str, accuracy: str | None, verdict: str) -> None:
    found = gc.pose(robots[name], threshold=threshold, accuracy=accuracy, nearest=False)
    assert found.verdict == verdict
    assert found.reason.endswith(".")


@pytest.mark.parametrize("text", ["", "5", "0 deg", "-1 deg", "nan deg", "inf mm", "5 cm", "5 bananas", "deg"])
def test_thresholds_at_fault(text: str) -> None:
    with pytest.raises(InputError):
        parse_threshold(text, "mm")


# --- many poses ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", EXAMPLES)
def test_many_poses_have_the_numbers_of_each(
    robots: dict[str, Analysis], name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    a = robots[name]
    size = 50.0 if name == "octahedral" else 0.1
    shifts = np.random.default_rng(4).normal(size=(5, 3)) * size
    turns = np.random.default_rng(5).normal(size=(5, 3)) * 0.2
    many = gc.pose(a, shifts, rotation_vector=turns, about="centroid")
    assert len(many) == 5
    for i in range(5):
        one = gc.pose(a, shifts[i], rotation_vector=turns[i], about="centroid", nearest=False)
        assert many.value[i] == pytest.approx(one.value, rel=1e-9)
        for field in ("closeness", "turn", "shift", "rotation", "combined", "noise", "condition_number"):
            assert getattr(many, field)[i] == pytest.approx(getattr(one, field), rel=1e-9)
        assert many.verdict[i] == one.verdict
        for r, s in zip(many.readings, one.readings, strict=True):
            assert (r.part, r.name) == (s.part, s.name)
            assert (s.value is None and not r.valid[i]) or r.values[i] == pytest.approx(s.value, rel=1e-9)
    assert json.loads(json.dumps(many.to_json()))["verdict"] == many.verdict.tolist()
    monkeypatch.setattr("gcrules.poses.numbers.many.CHUNK", 2)
    parts = gc.pose(a, shifts, rotation_vector=turns, about="centroid")
    assert parts.verdict.tolist() == many.verdict.tolist()
    assert np.allclose(parts.closeness, many.closeness, rtol=1e-12)
    assert np.allclose(
        parts.readings[0].values if parts.readings else [], many.readings[0].values if many.readings else []
    )
    listed = gc.pose(a, [Pose(), parse_pose("0 0 0; euler XYZ 3 4 5 deg")])
    assert listed.closeness[0] == pytest.approx(gc.pose(a, nearest=False).closeness)


def test_a_centre_moves_the_same_robot(robots: dict[str, Analysis]) -> None:
    a = robots["octahedral"]
    c = np.array([10.0, -20.0, 300.0])
    r = np.array(parse_pose("euler ZYX 10 20 30 deg").rotation, float)
    about = gc.pose(a, "1 2 3; euler ZYX 10 20 30 deg", about="10, -20, 300", nearest=False)
    shift, turn = np.array([1, 2, 3]) + c - r @ c, ("ZYX", (10, 20, 30))
    origin = gc.pose(a, shift, euler=turn, degrees=True, about="origin", nearest=False)
    assert about.value == pytest.approx(origin.value)
    assert about.rig.centre == (10, -20, 300)


OCTAHEDRON = parse_platform(
    "legs: [ab, af, cb, cd, ed, ef]\nunits: mm\n"
    "points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}"
)


@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param({"at": [1, 2]}, id="two numbers"),
        pytest.param({"at": 5}, id="one number"),
        pytest.param({"at": [[1, 2], [3, 4]]}, id="shape (2, 2)"),
        pytest.param({"at": [[1, 2, 3], [4, 5]]}, id="ragged"),
        pytest.param({"at": np.zeros((0, 3))}, id="no poses"),
        pytest.param({"at": np.zeros((2, 2, 3))}, id="three axes"),
        pytest.param({"at": [0, 0, math.nan]}, id="NaN"),
        pytest.param({"at": [[0, 0, 0], [0, math.inf, 0]]}, id="infinity in a row"),
        pytest.param({"at": ["0 0 0", "0 0"]}, id="text at fault in a list"),
        pytest.param({"at": "0 0 0", "quaternion": (1, 0, 0, 0)}, id="turn beside text"),
        pytest.param({"at": [Pose()], "quaternion": [(1, 0, 0, 0)]}, id="turn beside poses"),
        pytest.param({"quaternion": (1, 1, 0, 0)}, id="long quaternion"),
        pytest.param({"quaternion": [(1, 0, 0, 0), (0.5, 0, 0, 0)]}, id="short quaternion in a row"),
        pytest.param({"quaternion": (1, 0, 0)}, id="three components"),
        pytest.param({"quaternion": (1, 0, 0, 0), "rotation_vector": (0, 0, 0)}, id="two turns"),
        pytest.param({"at": np.zeros((3, 3)), "quaternion": np.ones((2, 4)) / 2}, id="3 and 2"),
        pytest.param({"euler": ("zyz", (1, 2))}, id="two angles"),
        pytest.param({"euler": ("abc", (1, 2, 3))}, id="no sequence"),
        pytest.param({"euler": ("abc", [(1, 2, 3)])}, id="no sequence of rows"),
        pytest.param({"at": (-1, -2, -4)}, id="leg of no length"),
        pytest.param({"at": [(0, 0, 0), (-1, -2, -4)]}, id="leg of no length in a row"),
        pytest.param({"about": "middle"}, id="no centre"),
        pytest.param({"about": (1, 2)}, id="short centre"),
        pytest.param({"about": "0 0 0 m"}, id="centre in another unit"),
        pytest.param({"threshold": "3"}, id="threshold without unit"),
        pytest.param({"accuracy": -1}, id="negative accuracy"),
        pytest.param({"accuracy": "1 m"}, id="accuracy in another unit"),
        pytest.param({"at": np.zeros((2, 3)), "threshold": "5 mm"}, id="length for many poses"),
        pytest.param({"at": [0, 0, "x"]}, id="text among numbers"),
        pytest.param({"euler": "zyx"}, id="sequence without angles"),
        pytest.param({"euler": (1, 2, 3)}, id="angles without sequence"),
        pytest.param({"quaternion": 1}, id="a number for a quaternion"),
        pytest.param({"about": 5}, id="a number for a centre"),
        pytest.param({"threshold": 2}, id="threshold that is a number"),
        pytest.param({"at": "1e200 0 0"}, id="far"),
        pytest.param({"at": [(1e300, 0, 0), (0, 0, 0)]}, id="far in a row"),
        pytest.param({"at": "0 0 0", "about": "1e300 0 0", "euler": None, "accuracy": "nan"}, id="accuracy NaN"),
    ],
)
def test_python_tells_faults(arguments: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        gc.pose(OCTAHEDRON, **arguments)


BASE_ON_A_LINE = """
legs: [Aa, Ab, Ba, Bb, Cc, Cd]
points: {A: [0, 0, 0], B: [1, 0, 0], C: [2, 0, 0], a: [0, 0, 1], b: [1, 0, 1], c: [0, 1, 2], d: [2, 1, 1]}
"""
PLATFORM_ON_A_LINE = """
legs: [Aa, Ab, Ba, Bb, Ca, Cb]
points: {A: [0, 0, 0], B: [1, 0, 0], C: [0, 1, 0], a: [0, 0, 1], b: [1, 0, 1]}
"""
NO_BODIES = """
legs: [ab, bc, ca, ad, bd, cd]
points: {a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0], d: [0, 0, 1]}
"""


@pytest.mark.parametrize(
    ("robot", "says"),
    [
        pytest.param(BASE_ON_A_LINE, "A, B, C of the base lie on one line", id="base"),
        pytest.param(PLATFORM_ON_A_LINE, "a, b of the platform lie on one line", id="platform"),
        pytest.param(NO_BODIES, "do not tell", id="no bodies"),
    ],
)
def test_degenerate_robots(robot: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        gc.pose(parse_platform(robot))


@pytest.fixture(scope="module")
def here() -> Any:
    return gc.pose(OCTAHEDRON)


@pytest.mark.parametrize("power", [-70, -40, 40, 70])
def test_sizes_of_robots(here: Any, power: int) -> None:
    """Beyond floats they are refused, else nothing but the unit changes."""
    size = F(10) ** power
    scaled = replace(OCTAHEDRON, points={n: tuple(c * size for c in p) for n, p in OCTAHEDRON.points.items()})
    if abs(power) > 60:
        with pytest.raises(InputError, match="for floats"):
            gc.pose(scaled)
        return
    found = gc.pose(scaled)
    assert found.closeness == pytest.approx(here.closeness)
    for there, same, unit in zip(found.nearest, here.nearest, (size, 1, size), strict=True):
        assert there.distance == pytest.approx(float(unit) * same.distance, rel=1e-6, abs=0)
    json.dumps(found.to_json(), allow_nan=False)


def test_an_analysis_without_coordinates() -> None:
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.pose(ANALYSES[STRUCTURES[0]])


# --- the command line ----------------------------------------------------------------------------------------------


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["pose", *arguments], input=text)


def test_json_of_the_command(root: Any) -> None:
    done = run(str(root / "examples" / "octahedral.yaml"), "--at", "1 2 3; euler zyx 5 0 0 deg", "--json")
    assert done.exit_code == 0
    found = json.loads(done.stdout)
    assert {"schema", "value", "closeness", "verdict", "reason", "pose", "readings", "nearest"} <= set(found)
    assert found["verdict"] == "regular"
    assert 0 < found["closeness"] < 1
    assert found["pose"]["translation"] == [1, 2, 3]
    assert found["nearest"]["translation"]["certified"]
    assert all(r["valid"] for r in found["readings"])


@pytest.mark.parametrize(
    "arguments", [(), ("--ascii", "--no-nearest"), ("--latex", "--no-nearest"), ("--threshold", "5 mm", "--no-nearest")]
)
@pytest.mark.parametrize("name", ["octahedral", "octahedral-singular"])
def test_forms_of_the_answer(root: Any, name: str, arguments: tuple[str, ...]) -> None:
    done = run(str(root / "examples" / f"{name}.yaml"), *arguments)
    assert done.exit_code == 0, done.output
    if "--ascii" in arguments:
        assert done.stdout.isascii()
    if "--latex" in arguments:
        assert done.stdout.count("{") == done.stdout.count("}")
    elif not arguments:
        assert done.stdout.startswith("regular: " if name == "octahedral" else "singular: ")
        assert max(map(len, done.stdout.splitlines())) <= 100


@pytest.mark.parametrize(
    "arguments",
    [
        ("--at", "0 0 nan"),
        ("--at", "0 0 1 cm"),
        ("--at", "quaternion 1 1 1 1"),
        ("--at", "-1 -2 -4"),
        ("--at", ""),
        ("--about", "here"),
        ("--threshold", "5"),
        ("--accuracy", "x"),
        ("--accuracy", "-1"),
        ("--bananas",),
    ],
)
def test_the_command_tells_faults(arguments: tuple[str, ...]) -> None:
    robot = (
        "legs: [ab, af, cb, cd, ed, ef]\nunits: mm\n"
        "points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}"
    )
    done = run("-", *arguments, text=robot)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert "rror" in done.stderr


def test_a_file_that_is_missing() -> None:
    assert run("no-such-robot.yaml").exit_code == 2


def test_a_platform_is_a_value() -> None:
    assert isinstance(OCTAHEDRON, Platform)
    found = gc.pose(OCTAHEDRON, nearest=False)
    assert "<PoseReport" in repr(found)
    assert pickle.loads(pickle.dumps(found)) == found
    assert hash(found) == hash(gc.pose(OCTAHEDRON, nearest=False))
    assert str(found).startswith(found.verdict)
    assert found._repr_html_().startswith("<pre>")
