r"""Following the solutions of six linear conditions on motions from one system to another, all at once.

The systems are Q(t) = (1 − t) Q₀ + t Q₁ with t from 1 to 0; the equations are xᵀ Q_k(t) x = 0, x the Study parameters,
with c·x = 1 in a chart c that follows x. The predictor is Runge and Kutta's of order 4, the corrector Newton's; each
path has a step of its own. Q₁ is a system that is solved, its forms mixed by a random complex matrix, so that with
probability one no two paths meet before t = 0. A path that ends at a regular solution jumps to t = 0 at last; one that
ends at a singular place or at infinity (h = a·a → 0) is followed to a very small t, and how h shrinks tells which.
That is numerical: that no path is lost is seen from the ends, which are different, and as many as paths.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import Complexes

__all__ = ["Accuracy", "PathEnds", "follow", "jacobians", "residuals"]

Truths = NDArray[np.bool_]


@dataclass(frozen=True)
class Accuracy:
    """How near a path is kept: the first and the second step of Newton's method, in parts of x, and how small a first
    one makes the next step longer.
    """

    first: float = 1e-4
    second: float = 1e-8
    longer: float = 1e-5


_FIRST = 0.05  # step
_GROWTH = 1.5
_LEAST = 1e-9  # t, at which paths that have not ended are told by how they behave
_MARKS = (1e-2, 1e-5)  # t, from which on that is seen, of paths that stop early, and of the others
_WHOLE = 0.999  # of t: a step that is longer goes to 0
_APART = 5  # from a mark to the end
_SHORTEST = 1e-5  # step, in parts of t
_MOST = 4000  # steps
_NUDGE = 1e-14


@dataclass(frozen=True, eq=False)
class PathEnds:
    """Where N paths are at last: Study parameters (N, 8) of length 1, the t (N,) there, 0 of those that ended, and the
    exponent (N,) with which |h| shrinks as t does, not a number where there is none. `steps` are those of all at once.
    """

    x: Complexes
    t: Floats
    exponents: Floats
    steps: int


def follow(start: Complexes, end: Complexes, x: Complexes, accuracy: Accuracy) -> PathEnds:
    """The solutions x (N, 8) of the start, quadrics (7, 8, 8), as it becomes the end."""
    number = len(x)
    x = x / np.linalg.norm(x, axis=1, keepdims=True)
    charts = x.conj()
    system = _System.between(start, end)
    t, step = np.ones(number), np.full(number, _FIRST)
    active = np.ones(number, dtype=bool)
    marks = np.full((len(_MARKS), number, 2), np.nan)
    steps = 0
    while active.any() and steps < _MOST:
        checkpoint()
        steps += 1
        on = np.flatnonzero(active)
        here, at, c = x[on], t[on], charts[on]
        by = np.where(step[on] < _WHOLE * at, step[on], at)
        half, whole = by[:, None] / 2, by[:, None]
        k1 = system.slope(here, at, c)
        k2 = system.slope(here - half * k1, at - by / 2, c)
        k3 = system.slope(here - half * k2, at - by / 2, c)
        k4 = system.slope(here - whole * k3, at - by, c)
        there = here - whole / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        first = system.correction(there, at - by, c)
        there = there + first
        second = system.correction(there, at - by, c)
        there = there + second
        size = np.abs(there).max(axis=1)
        moved, left = np.abs(first).max(axis=1), np.abs(second).max(axis=1)
        good = np.isfinite(left) & (moved < accuracy.first * size) & (left < accuracy.second * size)
        done = on[good]
        x[done] = there[good] / np.linalg.norm(there[good], axis=1, keepdims=True)
        charts[done] = x[done].conj()
        t[done] = np.where(by < _WHOLE * at, at - by, 0.0)[good]
        step[on[good & (moved < accuracy.longer * size)]] *= _GROWTH
        step[on[~good]] = by[~good] / 2
        for mark, below in zip(marks, _MARKS, strict=True):
            new = done[(t[done] < below) & (t[done] > 0) & np.isnan(mark[done, 0])]
            mark[new] = np.stack([t[new], _height(x[new])], axis=1)
        active[on] = (t[on] > _LEAST) & (step[on] > _SHORTEST * t[on])
    with np.errstate(divide="ignore", invalid="ignore"):
        early, late = (np.log(_height(x) / mark[:, 1]) / np.log(t / mark[:, 0]) for mark in marks)
        exponents = np.where(t < marks[1, :, 0] / _APART, late, np.where(t < marks[0, :, 0] / _APART, early, np.nan))
    return PathEnds(x, t, np.where(t > 0, exponents, np.nan), steps)


def _height(x: Complexes) -> Floats:
    return np.asarray(np.abs((x[:, :4] ** 2).sum(axis=1)))


@dataclass(frozen=True, eq=False)
class _System:
    """Q(t) = end + t change, both as (8, 56)."""

    end: Complexes
    change: Complexes

    @classmethod
    def between(cls, start: Complexes, end: Complexes) -> _System:
        flat = (q.transpose(1, 0, 2).reshape(8, 56) for q in (end, start - end))
        return cls(*flat)

    def slope(self, x: Complexes, t: Floats, charts: Complexes) -> Complexes:
        """dx/dt."""
        rows, changes = self._rows(x, t)
        return _solved(rows, charts, (changes @ x[:, :, None])[..., 0])

    def correction(self, x: Complexes, t: Floats, charts: Complexes) -> Complexes:
        """The step of Newton's method."""
        rows, _ = self._rows(x, t)
        return _solved(rows, charts, (rows @ x[:, :, None])[..., 0])

    def _rows(self, x: Complexes, t: Floats) -> tuple[Complexes, Complexes]:
        changes = (x @ self.change).reshape(len(x), 7, 8)
        return (x @ self.end).reshape(len(x), 7, 8) + t[:, None, None] * changes, changes


def _solved(rows: Complexes, charts: Complexes, values: Complexes) -> Complexes:
    """y with 2 rows · y = −values, and 0 in the chart."""
    matrix = np.concatenate([2 * rows, charts[:, None]], axis=1)
    right = np.zeros((len(rows), 8, 1), dtype=complex)
    right[:, :7, 0] = -values
    try:
        return np.asarray(np.linalg.solve(matrix, right)[..., 0])
    except np.linalg.LinAlgError:  # one of them is singular to the last digit
        nudge = _NUDGE * np.exp(1j * np.arange(64)).reshape(8, 8)
        return np.asarray(np.linalg.solve(matrix + nudge, right)[..., 0])


def residuals(system: Complexes, x: Complexes) -> Complexes:
    """The values (N, 7) of quadrics (7, 8, 8) at x (N, 8)."""
    return np.asarray(np.einsum("nij,ki,kj->kn", system, x, x))


def jacobians(system: Complexes, x: Complexes, chart: Complexes) -> Complexes:
    """Their derivatives (N, 8, 8), with a chart (8,) or (N, 8) in the last row."""
    rows = 2 * np.einsum("nij,kj->kni", system, x)
    return np.concatenate([rows, np.broadcast_to(chart, x.shape)[:, None]], axis=1)
