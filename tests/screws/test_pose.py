"""Poses as text and as numbers, exact where they can be; faults with their places."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from poses.structures import OCTAHEDRON

import gcrules as gc
from gcrules.core.errors import GcrulesError, InputError
from gcrules.poses.numbers.arrays import matrices, read_arrays
from gcrules.poses.numbers.cubic import determinant
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.rotations import from_euler, rotation

F = Fraction
small = st.integers(-6, 6)


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
        ("0 0 1 parsec", "not a unit"),
        ("1 2 3; 4 5 6", "second translation"),
        ("quaternion 1 0 0 0; euler zyx 0 0 0 deg", "second turn"),
        ("quaternion 1 1 0 0", "length 1.41421"),
        ("quaternion 0 0 0 0", "length 0"),
        ("quaternion 1 0 0", "4 numbers"),
        ("euler 1 2 3 deg", "not a sequence"),
        ("euler xxz 1 2 3 deg", "not a sequence"),
        ("euler xYz 1 2 3 deg", "not a sequence"),
        ("euler", "without their sequence"),
        ("euler zyx 1 2 3", "without a unit"),
        ("rotation-vector 1 2 3", "without a unit"),
        ("quaternoin 1 0 0 0", "not a part of a pose"),
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
    exactly = gc.pose(OCTAHEDRON, quaternion=[(1, 0, 0, 0), (HALF, 0, 0, HALF)], nearest=False)
    nearly = gc.pose(OCTAHEDRON, quaternion=[(1, 0, 0, 0), (0.7071, 0, 0, 0.7071)], nearest=False)
    assert exactly.notes == ()
    assert nearly.notes == ("quaternions normalised: 1, off from length 1 by up to 9.6e-06",)
    assert np.allclose(nearly.value, exactly.value)
    listed = gc.pose(OCTAHEDRON, ["0 0 0; quaternion 0.7071 0 0 0.7071"], nearest=False)
    assert "normalised" in listed.notes[0]


@given(st.tuples(small, small, small, small).filter(any))
def test_matrices_of_quaternions_are_exactly_orthogonal(q: tuple[int, int, int, int]) -> None:
    m = rotation(tuple(map(F, q)))
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
