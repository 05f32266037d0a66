r"""Solutions that are not isolated: whether a singular solution lies on a curve of solutions, and the curve.

At a solution x of n equations in eight unknowns (in a chart) the derivatives have a kernel. A step along a vector of it
is corrected by Gauss and Newton's method across it. If x is an isolated solution, however singular, nothing is found
nearby; on a curve the correction converges to a solution at a distance that the step was. Several such steps in a row
are taken as a curve: this holds numerically, it is no proof.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import FORMS, STUDY

__all__ = ["curve_through", "project", "rows_of", "sharpened", "values_of"]

_ITERATIONS = 60
_SOLVED = 1e-12
_KERNEL = 1e-5  # singular values of the derivatives, in parts of the largest, that count as 0
_STEPS = (0.04, 0.01, 0.0025)  # of Study parameters of length 1; small curves bend more
_NEEDED = 6  # steps for a curve
_LONGEST = 400
_SHARP = 8  # steps of Newton's method for multiple solutions
_NEAR = 1e-3


def _system(forms: Floats) -> Floats:
    own = np.tensordot(forms / np.linalg.norm(forms, axis=1, keepdims=True), FORMS, axes=1)
    return np.concatenate([own, STUDY[None]])


def values_of(forms: Floats, x: Floats) -> Floats:
    """The values (n + 1,) of forms (n, 17), made of length 1, and of Study's quadric at real parameters (8,)."""
    return np.asarray(np.einsum("nij,i,j->n", _system(forms), x, x))


def rows_of(forms: Floats, x: Floats) -> Floats:
    """Their derivatives (n + 1, 8)."""
    return np.asarray(2 * _system(forms) @ x)


def project(forms: Floats, x: Floats, across: Floats | None = None) -> Floats | None:
    """The real solution (8,) of length 1 near x, in the plane through x across a vector if one is given; or None."""
    system = _system(forms)
    start = x / np.linalg.norm(x)
    x = start
    for _ in range(_ITERATIONS):
        values = np.einsum("nij,i,j->n", system, x, x)
        rows, r = [2 * system @ x, start[None]], [values, np.zeros(1)]  # the size stays
        if across is not None:
            rows.append(across[None])
            r.append(np.array([across @ (x - start)]))
        step, *_ = np.linalg.lstsq(np.concatenate(rows), -np.concatenate(r), rcond=1e-9)
        x = x + step
        if np.abs(step).max() < 1e-15:
            break
    size = np.linalg.norm(x)
    found = x / size
    if not (np.isfinite(size) and np.linalg.norm(found[:4]) > 1e-6):
        return None
    return found if np.abs(np.einsum("nij,i,j->n", system, found, found)).max() <= _SOLVED else None


def sharpened(forms: Floats, x: Floats) -> Floats:
    """A multiple solution near x (8,), of length 1, at which the derivatives have a kernel of one vector v: Newton's
    method for x and v, which converges where that for x alone creeps. x where it does not.
    """
    system = _system(forms)
    start = x / np.linalg.norm(x)
    v = np.linalg.svd(np.concatenate([2 * system @ start, start[None]]))[2][-1]
    at, along = start, v
    for _ in range(_SHARP):
        rows = np.concatenate([2 * system @ at, start[None]])
        bent = np.concatenate([2 * system @ along, np.zeros((1, 8))])
        values = np.append(np.einsum("nij,i,j->n", system, at, at), start @ at - 1)
        r = np.concatenate([values, rows @ along, [v @ along - 1]])
        none = np.zeros_like(rows)
        matrix = np.block([[rows, none], [bent, rows], [np.zeros((1, 8)), v[None]]])
        step, *_ = np.linalg.lstsq(matrix, -r, rcond=None)
        at, along = at + step[:8], along + step[8:]
    found = at / np.linalg.norm(at)
    near = np.linalg.norm(found - start) <= _NEAR
    return found if near and np.abs(np.einsum("nij,i,j->n", system, found, found)).max() <= _SOLVED else start


def curve_through(forms: Floats, x: Floats) -> tuple[Floats, bool] | None:
    """Points (N, 8) of a curve of real solutions, one after the other, that goes through the solution near x (8,), and
    whether it comes back to where it begins; None where no curve was found.
    """
    start = project(forms, x)
    if start is None:
        return None
    _, s, v = np.linalg.svd(np.concatenate([rows_of(forms, start), start[None]]))
    s = np.append(s, np.zeros(8 - len(s)))
    for tangent, step in product(v[s <= _KERNEL * s[0]], _STEPS):
        way, closed = _walk(forms, start, tangent, step)
        back = [] if closed else _walk(forms, start, -tangent, step)[0]
        if max(len(way), len(back)) >= _NEEDED:
            return np.array([*back[::-1], start, *way]), closed
    return None


def _walk(forms: Floats, start: Floats, tangent: Floats, step: float) -> tuple[list[Floats], bool]:
    """Points along a curve from its start, until it is back there, which is told, or goes on no more."""
    found: list[Floats] = []
    x = start
    while len(found) < _LONGEST:
        checkpoint()
        there = project(forms, x + step * tangent, tangent)
        if there is None:
            break
        there = there if there @ x > 0 else -there
        moved = float(np.linalg.norm(there - x))
        if not 0.5 * step < moved < 2 * step:
            break
        tangent = (there - x) / moved
        x = there
        found.append(x)
        if len(found) > _NEEDED and min(np.linalg.norm(x - start), np.linalg.norm(x + start)) < 0.7 * step:
            return found, True
    return found, False
