"""Turns by angles are rational or rounded, and exact answers say which: a robot that is singular at all poses of a
slice is not called regular there because the turn was rounded.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.poses.numbers.arrays import read_arrays
from gcrules.screws.pose import AT_ROUNDED, ROUNDED
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.rotations import from_euler, is_rounded, rotation

HEXAPOD = str(EXAMPLES / "tutorial" / "hexapod.yaml")  # singular wherever it is turned by 90 degrees about z
SEQUENCES = [s for p in product("xyz", repeat=3) if p[0] != p[1] != p[2] for s in ("".join(p), "".join(p).upper())]
QUARTER = "0 0 0; euler zyz 30 0 60 deg"


@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("second", [-270, -180, -90, 0, 90, 180, 450])
@pytest.mark.parametrize(("first", "third"), [(30, 60), (-20, 110), (45, 45), (725, 5), (13, 77)])
def test_two_turns_about_one_axis_are_one(sequence: str, second: int, first: int, third: int) -> None:
    angles = (first, second, third)
    found = from_euler(sequence, [Fraction(a) for a in angles], degrees=True)
    expected = read_arrays(euler=(sequence, [np.radians(angles)]))[1][0]
    assert np.allclose(np.array(rotation(found), float), expected, atol=1e-12)
    if np.allclose(expected, np.round(expected), atol=1e-9):  # the axes go to axes
        assert not is_rounded(found)


@pytest.mark.parametrize(
    ("text", "quaternion"),
    [
        (QUARTER, (1, 0, 0, 1)),
        ("0 0 0; euler ZYZ 45 0 45 deg", (1, 0, 0, 1)),
    ],
)
def test_turns_that_are_exact(text: str, quaternion: tuple[int, ...]) -> None:
    pose = parse_pose(text)
    assert pose.exact_notes == ()
    assert tuple(c / pose.quaternion[0] for c in pose.quaternion) == quaternion


def test_turns_that_are_rounded() -> None:
    assert parse_pose("0 0 0; euler zyx 20 0 0 deg").exact_notes == (ROUNDED,)
    assert parse_pose("0 0 0; quaternion 0.8 0 0 0.6").exact_notes == ()


@pytest.mark.parametrize("at", [QUARTER, "yaw=90deg", "0 0 0; euler ZYZ 45 0 45 deg", "rotvec 0 0 90 deg"])
def test_a_slice_of_singular_poses_is_not_called_regular(at: str) -> None:
    found = gc.singular_map(HEXAPOD, ["x -50:50:6", "y -50:50:6"], at=at)
    assert found.everywhere
    assert gc.locus(HEXAPOD, "translation", at=at).vanishes


def test_a_rounded_turn_is_told() -> None:
    nearly = "0 0 0; quaternion 0.7071067811865477 0 0 0.7071067811865475"
    found = gc.singular_map(HEXAPOD, ["x -50:50:6", "y -50:50:6"], at=nearly)
    assert found.guarantee.startswith(AT_ROUNDED)
    assert "margins are 0 to rounding" in found.guarantee
    assert ROUNDED in found.notes
    locus = gc.locus(HEXAPOD, "translation", at=nearly)
    assert locus.question.turn_is_rounded
    assert locus.to_json()["rounded"] is True
    assert ROUNDED.split(":")[0] in " ".join(locus.text().split())


def test_an_exact_turn_needs_no_note() -> None:
    found = gc.singular_map(HEXAPOD, ["x -50:50:6", "y -50:50:6"], at="0 0 0; quaternion 0.8 0 0 0.6")
    assert not found.guarantee.startswith(AT_ROUNDED)
    assert not found.notes
    assert not gc.locus(HEXAPOD, "translation", at="0 0 0; quaternion 0.8 0 0 0.6").question.turn_is_rounded


@pytest.mark.parametrize(
    ("at", "rounded"),
    [("yaw=30deg", True), ("yaw=126.86989764584402deg", True), ("yaw=90deg", False), ("yaw=0deg", False)],
)
def test_half_tangents_of_a_robot_of_joints(at: str, rounded: bool) -> None:
    """Rounding may make a whole number of a tangent, which is rounded all the same."""
    found = gc.locus("3-rpr", "x, y", at=at)
    assert bool(found.question.rounded) == rounded == found.to_json()["rounded"]
    assert ("within 1e-12" in " ".join(found.text().split())) == rounded
