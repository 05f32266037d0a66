r"""The exact polynomials along a path, where they are needed: not where floats prove all that would be asked of them.

The polynomial of a segment has no zero where the coefficients of `FloatProofs` are all of one sign. Its degree is the
highest power with a coefficient that is proved to be other than 0, as long as it can have no higher one: no more than 6
where the quaternion changes, and the degree in the coordinates that change (`degree_along`). Everywhere else the exact
polynomial is found.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.paths.float_proofs import FloatProofs
from gcrules.poses.paths.forms import forms, superbracket
from gcrules.poses.paths.segments import Segments

__all__ = ["NO_ZERO", "degree_along", "polynomials"]

Polynomial = Sequence[int]

_MANY = 100  # of fewer segments the exact polynomials are found sooner than what `degree_along` tells

NO_ZERO: Polynomial = (1,)
"""It stands for the polynomial of a segment without a zero, which is not found."""


def polynomials(way: Segments) -> tuple[list[Polynomial], tuple[int, ...]]:
    """For each segment a polynomial with the same zeros in [0, 1], and the degree of its own one; −1 for 0."""
    turns, shifts = way.changes
    proofs = FloatProofs(forms(way.rig), way.motions, turns, shifts)
    free = proofs.without_zero()
    degrees = np.full(len(way), -1)
    degrees[free] = proofs.degrees(np.flatnonzero(free))
    known = free & (degrees == 6 * turns + 3 * shifts.any(axis=1))
    unknown = np.flatnonzero(free & ~known)
    kinds, which, counts = np.unique(
        np.hstack([way.present, shifts])[unknown], axis=0, return_inverse=True, return_counts=True
    )
    for n in np.flatnonzero(counts >= _MANY):
        alike = unknown[which == n]
        known[alike] = degrees[alike] == 6 * turns[alike] + degree_along(way.rig, tuple(kinds[n].tolist()))
    found = [NO_ZERO] * len(way)
    for k in np.flatnonzero(~known).tolist():
        checkpoint()
        report(f"segment {k + 1} of {len(way)}")
        found[k] = way[k].polynomial
        degrees[k] = len(found[k]) - 1
    return found, tuple(degrees.tolist())


@lru_cache(maxsize=64)
def degree_along(rig: MovingPlatform, kind: tuple[bool, ...]) -> int:
    """The degree of n³ D in the coordinates that change; exact. `kind` says which components of the quaternion and of
    the translation are other than 0 somewhere (7), and which of the translation change (3).

    n³ D is of degree 6 in the quaternion and 3 in (1, t). Such a polynomial is 0 if it is 0 for all whole, not negative
    numbers of these sums (the principal lattice of a simplex). So are the coefficients of powers of x, if each
    coordinate that changes is multiplied by x.
    """
    turns, shifts = _lattice(6, kind[:4]), _lattice(3, (True, *kind[4:7]))
    lines = np.zeros((4, 2, shifts.shape[1]), object)
    for line, row, changes in zip(lines, shifts, (False, *kind[7:]), strict=True):
        line[int(changes)] = row
    pairs = np.repeat(turns, shifts.shape[1], axis=1), np.tile(lines, turns.shape[1])
    found = superbracket(forms(rig).whole, pairs[0][:, None], pairs[1])
    return max(np.flatnonzero(found.any(axis=1)).tolist(), default=0)


def _lattice(total: int, present: tuple[bool, ...]) -> NDArray[Any]:
    """All ways to part a whole number into whole ones, the others 0: (len(present), M)."""
    parts = [n for n in product(range(total + 1), repeat=sum(present)) if sum(n) == total]
    found = np.zeros((len(present), len(parts)), object)
    found[np.array(present)] = np.array(parts, object).T
    return found
