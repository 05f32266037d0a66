r"""Planes, lines and points of an expression in floats, vectorised over N poses: what the readings measure.

Lines have Plücker coordinates (12, 13, 14, 23, 24, 34), planes the coordinates (123, 124, 134, 234), as `evaluate`
gives them; a plane's equation n·x + d = 0 is read off them.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.evaluate import Evaluator, evaluate
from gcrules.algebra.expr import Expr
from gcrules.core.deferred import deferred

__all__ = [
    "Points",
    "coordinates",
    "line_vectors",
    "mutual_moment",
    "normalised",
    "plane_equation",
    "relative",
    "size_of",
    "unit_scale",
]

factors = deferred("gcrules.conditions.gained_motion:factors")

Floats = NDArray[np.float64]
Points = Mapping[str, Floats]
"""Homogeneous coordinates (N, 4) of every joint."""


def coordinates(e: Expr, points: Points) -> Floats:
    """The Plücker coordinates of an extensor, shape (N, C(4, step)); (N, 1) for a scalar."""
    value = evaluate(e, points)
    rows = value if isinstance(value, tuple) else (value,)
    found: Floats = np.stack([np.asarray(c, dtype=np.float64) for c in rows], axis=-1)
    return found


def relative(e: Expr, points: Points) -> Floats:
    """A scalar divided by the lengths of the coordinates of the extensors that it joins or meets, (N,): 0 where one of
    them vanishes.
    """
    parts = e.children if e.children and e.children[0].step else ()
    known = Evaluator(points, next(iter(points.values())).shape[-1])
    found: Floats = np.asarray(known.value(e)[0], dtype=np.float64)
    for part in parts:
        size = np.sqrt(sum(np.square(c) for c in known.value(part)))
        found = np.divide(found, size, out=np.zeros(np.broadcast(found, size).shape), where=size > 0)
    return found


def unit_scale(points: Points) -> Points:
    """The same points with their centroid as the origin and their root-mean-square distance from it as the unit."""
    centred, size = _centred(points), size_of(points)[:, None]
    one = np.ones((len(size), 1))
    return {n: np.concatenate([centred[:, i] / size, one], axis=1) for i, n in enumerate(points)}


def size_of(points: Points) -> Floats:
    """The root-mean-square distance of the points from their centroid, shape (N,); 1 where all are one point."""
    found: Floats = np.sqrt((_centred(points) ** 2).sum(axis=2).mean(axis=1))
    return np.where(found > 0, found, 1.0)


def _centred(points: Points) -> Floats:
    xyz = np.stack([p[:, :3] for p in points.values()], axis=1)
    found: Floats = xyz - xyz.mean(axis=1, keepdims=True)
    return found


def plane_equation(plane: Floats) -> Floats:
    """(n, d) with n·x + d = 0 on the plane: the cofactors of x in [x p q r], shape (N, 4)."""
    found: Floats = np.stack([plane[:, 3], -plane[:, 2], plane[:, 1], -plane[:, 0]], axis=1)
    return found


def line_vectors(line: Floats) -> tuple[Floats, Floats]:
    """The direction of a line and its moment about the origin (a × direction), shape (N, 3) each."""
    p12, p13, p14, p23, p24, p34 = line.T
    return np.stack([-p14, -p24, -p34], axis=1), np.stack([p23, -p13, p12], axis=1)


def mutual_moment(a: Floats, b: Floats) -> Floats:
    """Of two lines scaled to unit direction: distance times the sine of their angle, with a sign; shape (N,)."""
    (d, m), (e, n) = line_vectors(a), line_vectors(b)
    with np.errstate(divide="ignore", invalid="ignore"):
        found: Floats = ((d * n).sum(axis=1) + (e * m).sum(axis=1)) / (
            np.linalg.norm(d, axis=1) * np.linalg.norm(e, axis=1)
        )
    return found


def normalised(e: Expr, points: Points) -> Floats:
    """|e| for a scalar divided by the lengths of the coordinates of the extensors that it joins or meets, at unit
    scale, in [0, 1] for a bracket or a meet; the least over the factors of a product. Shape (N,).

    It does not know frame and unit: turns about the centroid leave these lengths as they are.
    """
    at = unit_scale(points)
    found = np.ones(len(next(iter(points.values()))))
    for factor in factors(e):
        found = np.minimum(found, np.abs(relative(factor, at)))
    return found
