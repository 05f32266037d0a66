r"""The readings of a condition at poses: those of the published procedure, and measures and clearances with a meaning.

The published readings (SinguLab2008) change with frame and unit; here their matrices are taken at unit scale (centroid
of the joints as origin, their root-mean-square distance from it as unit) and made of unit vectors, so they do not. The
measures and the clearances are derived here; docs/pose.md says why they are what they are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.expr import Bracket, Expr, Meet, Product, Sum, meet
from gcrules.conditions.gained_motion import factors
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays
from gcrules.poses.numbers.extensors import (
    Points,
    coordinates,
    line_vectors,
    mutual_moment,
    normalised,
    plane_equation,
    size_of,
    unit_scale,
)
from gcrules.rules.condition import Condition

__all__ = ["NEAR_ZERO", "IncidenceMeasure", "readings"]

Floats = NDArray[np.float64]

NEAR_ZERO = 1e-3
"""A reading is not valid where its cofactor, normalised to [0, 1], or an entity that it is made of, is smaller."""


@dataclass(frozen=True, eq=False)
class IncidenceMeasure(HoldsArrays):
    """A number read off one part of a condition in N poses, shape (N,): 0 where this part makes the robot singular.

    `part` is the expression in DSL text; `name` and `meaning` say what is measured; `power` is the dimension, 1 for a
    length in the robot's unit, 0 for a pure number in [0, 1]. `published` marks the readings of the procedure. Where
    `valid` is false the number says nothing; `why` then says why.
    """

    part: str
    name: str
    meaning: str
    values: Floats
    valid: NDArray[np.bool_]
    power: int = 0
    published: bool = False
    why: str = ""


_Measure = tuple[str, str, Floats, int, bool]  # name, meaning, values, power, published


def readings(conditions: Sequence[Condition], points: Points) -> tuple[IncidenceMeasure, ...]:
    """All readings of all conditions, each part once; `points` are homogeneous coordinates (N, 4).

    They are computed at unit scale, where no product of lengths is too large or too small for a float.
    """
    found: dict[tuple[str, str], IncidenceMeasure] = {}
    points, unit = unit_scale(points), size_of(points)
    with np.errstate(divide="ignore", invalid="ignore"):
        for condition in conditions:
            cofactor = normalised(condition.cofactor, points)
            for part in factors(condition.expression):
                expression = str(part)
                for name, meaning, values, power, published in _measures(part, condition, points):
                    finite = np.isfinite(values)
                    why = "an entity is not determined" if not finite.all() else ""
                    if (cofactor < NEAR_ZERO).any():
                        why = f"the cofactor {condition.cofactor} is near zero"
                    valid = finite & (cofactor >= NEAR_ZERO)
                    reading = IncidenceMeasure(
                        expression, name, meaning, values * unit**power, valid, power, published, why
                    )
                    found.setdefault((expression, name), reading)
    return tuple(found.values())


def _measures(part: Expr, condition: Condition, points: Points) -> Iterator[_Measure]:
    steps = sorted(c.step for c in part.children)
    if isinstance(part, Bracket) and steps == [1, 1, 1, 1]:
        yield from _tetrahedron(part, points)
    elif isinstance(part, Meet) and steps == [3, 3, 3, 3]:
        yield from _four_planes(part, points)
    elif isinstance(part, Meet) and steps in ([2, 2], [2, 3, 3]):
        yield from _two_lines(part, points)
    elif isinstance(part, Sum) and condition.lines:
        yield from _transversals(part, condition, points)


# --- tetrahedra ----------------------------------------------------------------------------------------------------


def _tetrahedron(part: Bracket, points: Points) -> Iterator[_Measure]:
    """Of the centred corners' singular values s1 ≥ s2 ≥ s3: |6 V| = 2 s1 s2 s3, and Σ s² is fixed by the edges."""
    corners = np.stack([coordinates(p, points)[:, :3] for p in part.children], axis=1)
    s = np.linalg.svd(corners - corners.mean(axis=1, keepdims=True), compute_uv=False)
    volume = 2 * s.prod(axis=1)
    size = ((s**2).sum(axis=1) / 3) ** 1.5
    yield (
        "normalised volume",
        "volume by that of the regular one with the same sum of squared edges",
        s.prod(axis=1) / size,
        0,
        True,
    )
    yield (
        "third singular value",
        "root of the summed squared distances of the corners from the plane nearest to them",
        s[:, 2],
        1,
        False,
    )
    faces = [np.cross(corners[:, j] - corners[:, i], corners[:, k] - corners[:, i]) for i, j, k in _FACES]
    largest = np.linalg.norm(np.stack(faces), axis=2).max(axis=0)
    yield (
        "smallest height",
        "clearance: a corner has to move that far for the tetrahedron to be flat",
        volume / largest,
        1,
        False,
    )


_FACES = tuple(combinations(range(4), 3))


# --- four planes ---------------------------------------------------------------------------------------------------


def _four_planes(part: Meet, points: Points) -> Iterator[_Measure]:
    planes = [coordinates(p, points) for p in part.children]
    matrix = np.stack([_unit(p) for p in planes], axis=1)
    yield "reciprocal condition number", "of the 4×4 matrix of the planes", _reciprocal(matrix), 0, True
    equations = np.stack([plane_equation(p) for p in planes], axis=1)
    sizes = np.linalg.norm(equations[:, :, :3], axis=2)
    sizes[sizes <= 1e-12 * np.linalg.norm(equations, axis=2)] = np.nan  # no plane, or at infinity
    equations = equations / sizes[:, :, None]
    normals = equations[:, :, :3]
    cofactors = [(-1) ** i * np.linalg.det(np.delete(normals, i, axis=1)) for i in range(4)]
    weights = np.stack(cofactors, axis=1)  # of the offsets, up to a common sign
    value = np.abs((weights * equations[:, :, 3]).sum(axis=1))
    yield (
        "spread of the planes",
        "smallest over all points of the largest distance to the four planes",
        value / np.abs(weights).sum(axis=1),
        1,
        False,
    )
    yield (
        "clearance",
        "a plane has to be shifted that far to pass through the point of the other three",
        value / np.abs(weights).max(axis=1),
        1,
        False,
    )


# --- two planes and a line, two lines ------------------------------------------------------------------------------


def _two_lines(part: Meet, points: Points) -> Iterator[_Measure]:
    """Two lines; two planes stand for the line in which they meet."""
    planes = [c for c in part.children if c.step == 3]
    lines: list[Expr] = [c for c in part.children if c.step == 2]
    if planes:
        lines.append(meet(*planes))
    matrix = np.concatenate([_two_points(coordinates(line, points)) for line in lines], axis=2)
    what = "of two points on the meet of the planes and two on the line" if planes else "of two points on each line"
    yield "reciprocal condition number", f"of the 4×4 matrix {what}", _reciprocal(matrix), 0, True
    first, second = (coordinates(line, points) for line in lines)
    d, e = (_unit(line_vectors(line)[0]) for line in (first, second))
    sine = np.linalg.norm(np.cross(d, e), axis=1)
    distance = np.where(sine > 1e-9, np.abs(mutual_moment(first, second)) / sine, np.nan)
    yield "clearance", "shortest distance between the two lines", distance, 1, False


def _two_points(line: Floats) -> Floats:
    """Two orthonormal homogeneous points that span a line, shape (N, 4, 2): the columns' space of its 4×4 matrix."""
    matrix = np.zeros((len(line), 4, 4))
    for value, (i, j) in zip(line.T, combinations(range(4), 2), strict=True):
        matrix[:, i, j], matrix[:, j, i] = value, -value
    size = np.linalg.norm(matrix, axis=(1, 2))
    left, _, _ = np.linalg.svd(matrix / np.where(size > 0, size, 1)[:, None, None])
    left[size == 0] = np.nan
    found: Floats = left[:, :, :2]
    return found


# --- transversals --------------------------------------------------------------------------------------------------


def _transversals(part: Sum, condition: Condition, points: Points) -> Iterator[_Measure]:
    """(p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g): the directions of (m(p, g), m(q, g)) and (m(p, h), m(q, h))."""
    named = _ratio(part, condition)
    if named is None:
        return
    p, q, g, h = (coordinates(e, points) for e in named)
    rows = [np.stack([mutual_moment(p, x), mutual_moment(q, x)], axis=1) for x in (g, h)]
    u, v = (_unit(row, least=1e-9) for row in rows)
    sine = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    words = f"sine of the angle between the ratios that {named[2]} and {named[3]} allow to the turns about p and q"
    yield "transversals", words, sine, 0, False


def _ratio(part: Sum, condition: Condition) -> tuple[Expr, Expr, Expr, Expr] | None:
    """p, q, g and h of the ratio."""
    p, q = (line for _, line in condition.lines[:2])
    others = []
    for term in part.children:
        meets = [f for f in (term.children if isinstance(term, Product) else ()) if isinstance(f, Meet)]
        for f in meets:
            for line in (p, q):
                parts = line.children if isinstance(line, Meet) else (line,)
                rest = [c for c in f.children if c not in parts]
                if len(rest) == 1 and rest[0].step == 2 and len(f.children) == len(parts) + 1:
                    others.append(rest[0])
    singles = list(dict.fromkeys(others))
    return (p, q, singles[0], singles[1]) if len(singles) == 2 else None


# --- small helpers -------------------------------------------------------------------------------------------------


def _unit(rows: Floats, least: float | Floats = 0.0) -> Floats:
    """Rows of length 1; not a number where the length is at most `least`."""
    size = np.linalg.norm(rows, axis=-1, keepdims=True)
    found: Floats = np.where(size > np.reshape(least, (-1, 1)), rows / size, np.nan)
    return found


def _reciprocal(matrix: Floats) -> Floats:
    """Smallest by largest singular value; not a number where an entry is."""
    bad = ~np.all(np.isfinite(matrix), axis=(1, 2))
    usable: Floats = np.where(bad[:, None, None], 0.0, matrix)
    s = np.linalg.svd(usable, compute_uv=False)
    found: Floats = np.where(bad, np.nan, s[:, -1] / s[:, 0])
    return found
