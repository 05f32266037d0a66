r"""Cables only pull: whether tensions that are all positive balance each other, so that any wrench can be resisted.

The rows of A (n, f) are the rates of n actuators for unit motions in the f freedoms of the platform. Efforts τ balance
each other where Aᵀτ = 0; these τ = N z are spanned by the left singular vectors of A beyond the f-th. Of the τ whose
mean over the cables is 1 that with the largest least tension t is sought,

    t = max min τ_i   over Nz = τ, Σ τ_i = c over the c cables,

a linear program in z and t with a vertex for each choice of n − f cables at their least tension: all are solved at
once. The cables hold the platform (wrench closure) exactly where A has full rank and t > 0; t is 1 where all tensions
are equal. Where t ≤ 0, the multipliers y ≥ 0 of the least ones give a motion ξ with Aξ = −(y − t/c) ≤ 0: the platform
can move without any cable getting longer. Source: linear programming duality; the vertices are derived here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass

__all__ = ["CableTensions", "Closure", "closure", "closures"]

Floats = NDArray[np.float64]

_NOTHING = 1e-9


@dataclass(frozen=True)
class CableTensions:
    """Whether cables, which only pull, hold the platform: the `least` tension, for a mean one of 1, where all efforts
    balance each other. Where it is positive these are the `efforts`, by actuator; else the platform can move along the
    twist `escape` (v at the centre; ω) without any cable getting longer.
    """

    least: float
    efforts: tuple[tuple[str, float], ...] = ()
    escape: tuple[float, ...] | None = None

    @property
    def held(self) -> bool:
        """Whether there is wrench closure."""
        return not self.escape

    def to_json(self) -> dict[str, Any]:
        return {
            "closure": self.held,
            "least_tension": self.least,
            "efforts": dict(self.efforts),
            "escape": None if self.escape is None else list(self.escape),
        }


@dataclass(frozen=True, eq=False)
class Closure:
    """At one pose the `least` tension for a mean tension of 1, from −1 (none, or much less than 0) to 1. Where it is
    positive `efforts` (n,) are those that balance each other, the other actuators' among them; else none does, and
    `escape` (f,) is a motion in the freedoms that makes no cable longer.
    """

    least: float
    efforts: Floats | None
    escape: Floats | None


def closures(rates: Floats, pulls: Sequence[bool]) -> Floats:
    """The least tensions (N,) at N poses, from the rates (N, n, f) of actuators of which those that are cables pull."""
    found = np.full(len(rates), -1.0)
    for _, _, least, sound in _vertices(rates, pulls):
        found = np.where(sound, np.maximum(found, least), found)
    found = np.clip(found, -1.0, 1.0)
    found[~np.isfinite(rates).all(axis=(1, 2))] = np.nan
    return np.asarray(found)


def closure(rates: Floats, pulls: Sequence[bool]) -> Closure:
    """The same at one pose, with what shows it."""
    cables = np.array(pulls)
    best, efforts, held = -np.inf, None, None
    for tensions, active, least, sound in _vertices(rates[None], pulls):
        if sound[0] and least[0] > best:
            best, efforts, held = float(least[0]), tensions[0], active
    if best > _NOTHING:
        return Closure(min(best, 1.0), efforts, None)
    slack = np.where(cables, 1.0, 0.0)
    if held is not None:
        basis = _kernel(rates[None])[0]
        share = best / cables.sum()
        y = np.linalg.lstsq(
            np.vstack([basis[held].T, np.ones(len(held))]),
            np.append(share * basis[cables].sum(axis=0), 1.0),
            rcond=None,
        )[0]
        slack = -share * slack
        slack[held] += y
    escape = -np.linalg.lstsq(rates, slack, rcond=None)[0]
    return Closure(max(best, -1.0), None, np.asarray(escape / np.linalg.norm(escape)))


def _kernel(rates: Floats) -> Floats:
    """Orthonormal columns (N, n, n − f) of the efforts that balance each other."""
    known = np.where(np.isfinite(rates), rates, 0.0)
    return np.asarray(np.linalg.svd(known)[0][:, :, rates.shape[2] :])


def _vertices(rates: Floats, pulls: Sequence[bool]) -> Iterator[tuple[Floats, list[int], Floats, NDArray[np.bool_]]]:
    """For each choice of cables at their least tension the efforts (N, n), which ones these are, the least tension
    (N,), and where that is a solution.
    """
    basis = _kernel(rates)
    size = basis.shape[2]
    cables = np.flatnonzero(pulls)
    if not size or not len(cables):
        return
    total = basis[:, cables].sum(axis=1)  # (N, r)
    right = np.zeros((len(rates), size + 1, 1))
    right[:, -1] = len(cables)
    for active in combinations(cables.tolist(), size):
        checkpoint()
        left = np.zeros((len(rates), size + 1, size + 1))
        left[:, :size, :size] = basis[:, active]
        left[:, :size, size] = -1.0
        left[:, size, :size] = total
        good = np.abs(np.linalg.det(left)) > _NOTHING**2
        solved = np.linalg.solve(np.where(good[:, None, None], left, np.eye(size + 1)), right)[..., 0]
        tensions = (basis @ solved[:, :size, None])[..., 0]
        least = solved[:, size]
        room = _NOTHING * np.maximum(1.0, np.abs(tensions).max(axis=1))
        yield tensions, list(active), least, good & (tensions[:, cables].min(axis=1) >= least - room)
