r"""The nearest singular pose in rotation, and in rotation and translation together: the best of a search, no proof.

A displacement is a vector of three or six coordinates in which its length is the metric: φ = |vector|, the angle of the
rotation about the centroid of the legs' platform ends; or (d, ρφ) with d the shift of this centroid and ρ the ends'
root-mean-square distance from it. Rays in many directions are followed to the first change of sign of the determinant;
the best are polished by Newton's method on the Lagrange equations. Every run gives the same answer.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.nearest.zero import fibonacci
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.screws.margin import LegJacobians

__all__ = ["Determinant", "best_zero"]

Floats = NDArray[np.float64]

_ROTATIONS, _BOTH = 800, 2500  # rays
_STEPS = 48
_JUMP = 4  # steps at once where the determinant falls slowly
_STARTS = 8
_HALVINGS = 12  # of an interval, to see which rays are the nearest
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


def best_zero(
    f: Determinant, dimension: int, reach: float, more: Floats | None = None, free: float = 0.0
) -> Floats | None:
    """The zero of f nearest to 0 that was found within `reach`, shape (dimension,); None if none was.

    `more` are further zeros to start from, shape (N, dimension); within `free` there is proved to be none.
    """
    directions = fibonacci(_ROTATIONS) if dimension == 3 else _spread(_BOTH)
    starts = _along_rays(f, directions, reach, free)
    if more is not None:
        starts = np.concatenate([more, starts])
    if not len(starts):
        return None
    order = np.argsort(np.linalg.norm(starts, axis=1), kind="stable")
    size = float(np.linalg.norm(starts[order[0]]))
    polished = _polished(f, starts[order[:_STARTS]] / size, size) * size
    found: Floats = polished[int(np.argmin(np.linalg.norm(polished, axis=1)))]
    return found


def _spread(number: int) -> Floats:
    """Unit vectors spread evenly over the sphere in six dimensions, shape (number, 6): points of Roberts's sequence, in
    pairs of coordinates turned into normal ones (Box and Muller).
    """
    root = 1.1127756842787055  # of x⁷ = x + 1
    u = (0.5 + np.arange(1, number + 1)[:, None] / root ** np.arange(1, 7)) % 1
    length, angle = np.sqrt(-2 * np.log(1 - u[:, :3])), 2 * np.pi * u[:, 3:]
    found = np.concatenate([length * np.cos(angle), length * np.sin(angle)], axis=1)
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))


def _along_rays(f: Callable[[Floats], Floats], directions: Floats, reach: float, free: float = 0.0) -> Floats:
    """The first changes of sign along rays, found on a grid and then to the last bit; shape (N, dimension).

    Of the rays, those only that may be among the `_STARTS` nearest: the grid is left as soon as so many are found,
    and so is a ray that changes behind so many others. Where f falls slowly, up to `_JUMP` steps of the grid are passed
    over: half of those in which f would come to 0 at the same rate.
    """
    start = min(int(free / reach * _STEPS), _STEPS)
    last, value = np.full(len(directions), start), np.ones(len(directions))  # where f was seen to be positive
    due = last + 1
    changed = np.zeros(len(directions), dtype=int)  # at which step, 0 for not yet

    def look(step: int, rays: NDArray[np.bool_]) -> None:
        (at,) = np.nonzero((changed == 0) & (last < step) & rays)
        new = f(directions[at] * (reach * step / _STEPS))
        changed[at[new <= 0]] = step
        at, new = at[new > 0], new[new > 0]
        fall = np.maximum((value[at] - new) / (step - last[at]), new / (2 * _JUMP))
        value[at], last[at], due[at] = new, step, step + np.maximum(new / (2 * fall), 1).astype(int)

    for step in range(start + 1, _STEPS + 1):
        checkpoint()
        look(step, due <= step)
        if np.count_nonzero(changed) >= _STARTS or step == _STEPS:
            look(step, due > step)  # those that were passed over may have changed as well
            break
    hit = changed > 0
    rays = directions[hit]
    low, high = reach * last[hit] / _STEPS, reach * changed[hit] / _STEPS
    for _ in range(_HALVINGS):
        checkpoint()
        if len(high) > _STARTS:
            near = low <= np.partition(high, _STARTS - 1)[_STARTS - 1] * (1 + _ROUNDING)
            rays, low, high = rays[near], low[near], high[near]
        middle = (low + high) / 2
        below = f(rays * middle[:, None]) <= 0
        low, high = np.where(below, low, middle), np.where(below, middle, high)
    found: Floats = rays * _narrowed(f, rays, low, high)[:, None]
    return found


def _polished(f: Callable[[Floats], Floats], starts: Floats, size: float) -> Floats:
    """Newton's method for f = 0, ∇f + μ x = 0 from zeros (N, n) at once, with differences for derivatives; only ever
    nearer zeros are kept.
    """
    best, n = starts.copy(), starts.shape[1]
    steps = np.eye(n)

    def slope(at: Floats, h: float = 1e-6) -> Floats:
        above, below = f(np.stack([at[..., None, :] + h * steps, at[..., None, :] - h * steps]) * size)
        found: Floats = (above - below) / (2 * h)
        return found

    going = np.arange(len(best))
    for _ in range(25):
        checkpoint()
        x = best[going]
        g = slope(x)
        mu = -(g * x).sum(axis=1) / (x * x).sum(axis=1)
        h = 1e-4
        above, below = slope(np.stack([x[:, None, :] + h * steps, x[:, None, :] - h * steps]), h)
        second = (above - below) / (2 * h)
        system = np.zeros((len(x), n + 1, n + 1))
        system[:, :n, :n] = (second + second.swapaxes(1, 2)) / 2 + mu[:, None, None] * steps
        system[:, :n, n], system[:, n, :n] = x, g
        aim = -np.concatenate([g + mu[:, None] * x, f(x * size)[:, None]], axis=1)
        step = np.array([np.linalg.lstsq(a, b, rcond=None)[0][:n] for a, b in zip(system, aim, strict=True)])
        left = np.arange(len(x))  # for which no nearer zero has been found
        for damping in (1.0, 0.5, 0.25, 0.1, 0.03):
            new = _on_rays(f, x[left] + damping * step[left], size)
            nearer = np.linalg.norm(new, axis=1) < np.linalg.norm(x[left], axis=1) * (1 - 1e-15)
            best[going[left[nearer]]] = new[nearer]
            left = left[~nearer]
            if not len(left):
                break
        going = going[np.linalg.norm(best[going] - x, axis=1) >= 1e-9]
        if not len(going):
            break
    return best


def _on_rays(f: Callable[[Floats], Floats], x: Floats, size: float) -> Floats:
    """The zeros near points (N, n) on their rays from 0, by a change of sign within a tenth of the distance; not a
    number where there is none.
    """
    factors = np.linspace(0.9, 1.1, 41)
    values = f(x[:, None, :] * factors[:, None] * size)
    change = (values[:, :-1] > 0) & (values[:, 1:] <= 0)
    hit, first = change.any(axis=1), change.argmax(axis=1)[change.any(axis=1)]
    found = np.full(x.shape, np.nan)
    found[hit] = x[hit] * _narrowed(f, x[hit] * size, factors[first], factors[first + 1])[:, None]
    return found


def _narrowed(f: Callable[[Floats], Floats], rays: Floats, low: Floats, high: Floats) -> Floats:
    """Multiples (N,) of rays (N, n) at which f ≤ 0, up to rounding the least that are more than `low`: f is positive at
    `low` and not at `high`.

    The chord's zero is about the square of the interval's width w off, so f is tried at 2 w² on either side of it; and
    in the middle, should the chord mislead.
    """
    at = np.stack([low, high], axis=1)
    values = f(rays[:, None, :] * at[:, :, None])
    values[:, 0] = np.maximum(values[:, 0], 1e-300)  # whatever rounding says
    values[:, 1] = np.minimum(values[:, 1], 0.0)
    every = np.arange(len(at))
    for _ in range(60):
        checkpoint()
        (low, high), (start, end) = at.T, values.T
        width = high - low
        if (width <= 4 * np.spacing(high)).all():
            break
        chord = low + width * start / (start - end)
        off = np.maximum(2 * width * width / high, 2 * np.spacing(high))
        tried = np.clip(np.stack([chord - off, chord + off, (low + high) / 2], axis=1), low[:, None], high[:, None])
        at = np.concatenate([at, tried], axis=1)
        values = np.concatenate([values, f(rays[:, None, :] * tried[:, :, None])], axis=1)
        order = np.argsort(at, axis=1, kind="stable")
        at, values = np.take_along_axis(at, order, 1), np.take_along_axis(values, order, 1)
        first = (values <= 0).argmax(axis=1)
        at, values = (np.stack([v[every, first - 1], v[every, first]], axis=1) for v in (at, values))
    return at[:, 1]
