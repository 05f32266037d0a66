r"""The nearest singular pose in rotation, and in rotation and translation together: the best of a search, no proof.

A displacement is a vector of three or six coordinates in which its length is the metric: φ = |vector|, the angle of the
rotation about the centroid of the legs' platform ends; or (d, ρφ) with d the shift of this centroid and ρ the ends'
root-mean-square distance from it. Rays in many directions are followed to the first change of sign of the determinant;
the best are polished by Newton's method on the Lagrange equations. Every run gives the same answer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.poses.nearest.zero import fibonacci
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.screws.margin import LegJacobians

__all__ = ["Determinant", "best_zero"]

Floats = NDArray[np.float64]

_ROTATIONS, _BOTH = 800, 2500  # rays
_STEPS = 48
_STARTS = 8
_BLOCK = 6  # steps that are computed together
_ROUNDING = 1e-9  # of the lengths of directions


@dataclass(frozen=True, eq=False)
class Determinant:
    """The determinant of the legs after displacements x, shape (…, 3) or (…, 6), divided by its value at the pose.

    `base`, `centroid` and `arms` are in units of the `radius`.
    """

    base: Floats
    centroid: Floats
    arms: Floats
    radius: float

    @staticmethod
    def of(base: Floats, j: LegJacobians) -> Determinant:
        """At the one pose of a Jacobian."""
        return Determinant(base / j.radius, j.centroid[0] / j.radius, j.arms[0] / j.radius, j.radius)

    def __call__(self, x: Floats) -> Floats:
        flat = x.reshape(-1, x.shape[-1])
        if flat.shape[1] == 3:
            shifts, vectors = np.zeros_like(flat), flat
        else:
            shifts, vectors = flat[:, :3] / self.radius, flat[:, 3:] / self.radius
        arms = np.einsum("nij,kj->nki", matrices(from_vectors(vectors)), self.arms)
        along = arms + (self.centroid + shifts)[:, None, :] - self.base
        rows = np.concatenate([along, _cross(arms, along)], axis=2)
        found: Floats = (np.linalg.det(rows) / self._start).reshape(x.shape[:-1])
        return found

    @cached_property
    def _start(self) -> float:
        along = self.arms + self.centroid - self.base
        return float(np.linalg.det(np.concatenate([along, _cross(self.arms, along)], axis=1)))


def _cross(a: Floats, b: Floats) -> Floats:
    """The vector product of arrays (…, 3) of one shape; numpy's own takes five times as long for small ones."""
    (a1, a2, a3), (b1, b2, b3) = ((v[..., 0], v[..., 1], v[..., 2]) for v in (a, b))
    return np.stack([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1], axis=-1)


def best_zero(f: Determinant, dimension: int, reach: float, more: Floats | None = None) -> Floats | None:
    """The zero of f nearest to 0 that was found within `reach`, shape (dimension,); None if none was.

    `more` are further zeros to start from, shape (N, dimension).
    """
    if dimension == 3:
        directions = fibonacci(_ROTATIONS)
    else:
        directions = np.random.default_rng(0).normal(size=(_BOTH, dimension))
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    starts = _along_rays(f, directions, reach)
    if more is not None:
        starts = np.concatenate([more, starts])
    if not len(starts):
        return None
    order = np.argsort(np.linalg.norm(starts, axis=1), kind="stable")
    size = float(np.linalg.norm(starts[order[0]]))
    polished = [_polished(f, starts[i] / size, size) * size for i in order[:_STARTS]]
    return min(polished, key=lambda x: float(np.linalg.norm(x)))


def _along_rays(f: Callable[[Floats], Floats], directions: Floats, reach: float) -> Floats:
    """The first changes of sign along rays, found on a grid and halved to the last bit; shape (N, dimension).

    Of the rays, those only that may be among the `_STARTS` nearest: the grid is left as soon as so many are found,
    and so is a ray that changes behind so many others.
    """
    grid = reach * np.arange(1, _STEPS + 1) / _STEPS
    negative = np.zeros((len(directions), 0), dtype=bool)
    for some in np.split(grid, _STEPS // _BLOCK):
        checkpoint()
        negative = np.hstack([negative, f(directions[:, None, :] * some[None, :, None]) <= 0])
        if np.count_nonzero(hit := negative.any(axis=1)) >= _STARTS:
            break
    first = negative.argmax(axis=1)[hit]
    rays = directions[hit]
    low, high = grid[first] - grid[0], grid[first]
    for _ in range(50):
        checkpoint()
        if len(high) > _STARTS:
            near = low <= np.partition(high, _STARTS - 1)[_STARTS - 1] * (1 + _ROUNDING)
            rays, low, high = rays[near], low[near], high[near]
        middle = (low + high) / 2
        below = f(rays * middle[:, None]) <= 0
        low, high = np.where(below, low, middle), np.where(below, middle, high)
    found: Floats = rays * high[:, None]
    return found


def _polished(f: Callable[[Floats], Floats], x: Floats, size: float) -> Floats:
    """Newton's method for f = 0, ∇f + μ x = 0, with differences for derivatives; only ever nearer zeros are kept."""
    best, n = x, len(x)
    steps = np.eye(n)

    def slope(at: Floats, h: float = 1e-6) -> Floats:
        above, below = f(np.stack([at[..., None, :] + h * steps, at[..., None, :] - h * steps]) * size)
        found: Floats = (above - below) / (2 * h)
        return found

    for _ in range(25):
        checkpoint()
        g = slope(x)
        mu = -float(g @ x) / float(x @ x)
        h = 1e-4
        above, below = slope(np.stack([x + h * steps, x - h * steps]), h)
        second = (above - below) / (2 * h)
        system = np.zeros((n + 1, n + 1))
        system[:n, :n] = (second + second.T) / 2 + mu * np.eye(n)
        system[:n, n], system[n, :n] = x, g
        step = np.linalg.lstsq(system, -np.append(g + mu * x, f(x * size)), rcond=None)[0][:n]
        new = None
        for damping in (1.0, 0.5, 0.25, 0.1, 0.03):
            new = _on_ray(f, x + damping * step, size)
            if new is not None and np.linalg.norm(new) < np.linalg.norm(best) * (1 - 1e-15):
                break
        else:
            break
        moved = float(np.linalg.norm(new - x))
        best = x = new
        if moved < 1e-9:
            break
    return best


def _on_ray(f: Callable[[Floats], Floats], x: Floats, size: float) -> Floats | None:
    """The zero near x on its ray from 0, by a change of sign within a tenth of the distance."""
    factors = np.linspace(0.9, 1.1, 41)
    values = f(x[None, :] * factors[:, None] * size)
    change = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not len(change):
        return None
    for _ in range(12):  # each time the interval becomes 40 times smaller
        checkpoint()
        factors = np.linspace(factors[change[0]], factors[change[0] + 1], 41)
        values = f(x[None, :] * factors[:, None] * size)
        change = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
        if not len(change):  # at the last bit
            break
    found: Floats = x * factors[change[0] + 1 if len(change) else 20]
    return found
