"""Places of a robot at home as exact vectors, and what is computed with them without rounding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.linear_algebra import echelon
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.description.relations import Term
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.compiling.vectors import Vector, add, exact, scaled, sub, vector

__all__ = ["at_home", "combined_at", "floats", "left_inverse", "near"]

_SHORT = 10**6  # denominators of a centre that was computed in floats


def combined_at(term: Term, values: Mapping[str, Vector]) -> Vector:
    """A linear combination of places."""
    found: Vector = (0, 0, 0)
    for c, n in term:
        found = add(found, scaled(values[n], c))
    return found


def at_home(m: Linkage) -> dict[str, Vector]:
    """The places at home, exact as the file gives them; of a linkage that has been moved, those of its floats."""
    sorts, found = m.robot.family.sorts, {}
    written = home_values(m.robot)
    for n, value in m.home.values.items():
        own = written.get(n)
        if own is not None and sorts.get(n) == "point":
            own = sub(own, m.origin)
        found[n] = own if own is not None and np.array_equal(floats(own), value) else exact(value)
    return found


def near(place: Floats, rounded: float) -> Vector:
    """A place that was computed in floats: with short fractions where these are within what floats round off."""
    short = [Fraction(float(c)).limit_denominator(_SHORT) for c in place]
    return vector(
        [s if abs(float(s) - c) <= rounded else Fraction(float(c)) for s, c in zip(short, place, strict=True)]
    )


def floats(v: Sequence[Any]) -> Floats:
    return np.array([float(c) for c in v])


def left_inverse(matrix: Sequence[Sequence[Any]]) -> list[list[Fraction]]:
    """(MᵀM)⁻¹ Mᵀ for independent columns; no rows where there are none."""
    width = len(matrix[0])
    square = [[sum(row[i] * row[j] for row in matrix) for j in range(width)] for i in range(width)]
    rows, _ = echelon([[*left, *(row[i] for row in matrix)] for i, left in enumerate(square)])
    return [list(row[width:]) for row in rows]
