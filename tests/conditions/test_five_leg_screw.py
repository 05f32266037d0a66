"""What the general 6-6 says besides its complex: the screw that five legs leave free, against plain fractions."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import combinations

import pytest

import gcrules as gc

POINTS = "ABCDEFabcdef"
LEGS = ("Aa", "Bb", "Cc", "Dd", "Ee", "Ff")
OPPOSITE = {"AB": ("ab", 1), "Ab": ("aB", -1), "aB": ("Ab", -1), "ab": ("AB", 1)}
"""The lines that cross Aa and Bb, with the line across the tetrahedron and the sign of its term."""

Vector = list[Fraction]


def det(rows: list[Vector]) -> Fraction:
    if not rows:
        return Fraction(1)
    return sum(((-1) ** i * x * det([r[:i] + r[i + 1 :] for r in rows[1:]]) for i, x in enumerate(rows[0])), Fraction())


def plucker(one: Vector, other: Vector) -> Vector:
    return [one[i] * other[j] - one[j] * other[i] for i, j in combinations(range(4), 2)]


def moment(one: Vector, other: Vector) -> Fraction:
    """The mutual moment of two lines or screws."""
    signs = (1, -1, 1, 1, -1, 1)
    return sum((s * a * b for s, a, b in zip(signs, one, reversed(other), strict=True)), Fraction())


def platform(seed: int) -> dict[str, Vector]:
    rng = random.Random(seed)
    return {n: [*(Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(3)), Fraction(1)] for n in POINTS}


def screw(at: dict[str, Vector]) -> Vector:
    """The motion in the words of the statement: turns about four lines, weighted by superbrackets."""
    five = [plucker(at[a], at[b]) for a, b in LEGS[:5]]
    found = [Fraction()] * 6
    for line, (turn, sign) in OPPOSITE.items():
        weight = sign * det([*five, plucker(*(at[n] for n in line))])
        found = [x + weight * y for x, y in zip(found, plucker(*(at[n] for n in turn)), strict=True)]
    return found


@pytest.mark.parametrize("seed", range(6))
def test_the_motion_is_what_the_five_legs_leave_free(seed: int) -> None:
    """It changes the length of none of the five, and that of the sixth as the superbracket says."""
    at = platform(seed)
    motion = screw(at)
    legs = [plucker(at[a], at[b]) for a, b in LEGS]
    assert any(motion)
    assert [moment(motion, leg) for leg in legs[:5]] == [0] * 5
    flat = det([at[n] for n in "ABab"])
    assert moment(motion, legs[5]) == flat * det(legs) != 0


def test_a_sixth_leg_that_the_motion_leaves_alone_makes_it_singular() -> None:
    at = platform(11)
    motion = screw(at)
    # The points X with Ff reciprocal to the motion, F given, are those of a plane: f is moved along x into it.
    here = moment(motion, plucker(at["F"], at["f"]))
    slope = moment(motion, plucker(at["F"], [Fraction(1), *[Fraction()] * 3]))
    at["f"] = [at["f"][0] - here / slope, *at["f"][1:]]
    assert det([plucker(at[a], at[b]) for a, b in LEGS]) == 0


def test_dependent_five_legs_are_singular_and_have_no_motion_of_their_own() -> None:
    """Where the five depend on each other all weights vanish, so that the statement names the case by itself."""
    at = platform(12)
    at["E"], at["e"] = at["D"], [(x + y) / 2 for x, y in zip(at["D"], at["d"], strict=True)]
    assert not any(screw(at))
    assert det([plucker(at[a], at[b]) for a, b in LEGS]) == 0


def test_the_general_platform_says_it_beside_the_complex() -> None:
    a = gc.analyze("6-6")
    assert a.condition.kind == "linear-complex"
    (reading,) = a.readings
    assert reading.kind == "five-leg-screw"
    assert reading.certificate.method == "catalog-instance"
    assert "the robot is singular exactly when this motion does not change the length of Ff" in reading.statement
    assert "[[Aa, Bb, Cc, Dd, Ee, Ff]] = [[Aa" not in a.text()
    assert gc.analyze("6-6", recheck=True).readings[0].certificate.method == "normal-form"


def test_a_relation_that_flattens_the_tetrahedron_leaves_it_out() -> None:
    assert not [r for r in gc.analyze("Aa Bb Cc Dd Ee Ff", given=["coplanar(A,B,a,b)"]).readings
                if r.kind == "five-leg-screw"]  # fmt: skip


def test_a_direction_has_no_length() -> None:
    assert not [r for r in gc.analyze("Aa Bb Cc Dd Ee Ff", ideal="F").readings if r.kind == "five-leg-screw"]
