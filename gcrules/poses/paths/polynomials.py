r"""The exact polynomials along a path, where they are needed: not where floats prove all that would be asked of them.

The polynomial of a segment has no zero where the coefficients of `FloatProofs` are all of one sign. Its degree is the
highest power with a coefficient that is proved to be other than 0, as long as those of higher ones are exactly 0: there
are none, or it is the leading one and vanishes for all segments along the same coordinates (`vanishing`). Everywhere
else the exact polynomial is found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.paths.float_proofs import FloatProofs
from gcrules.poses.paths.forms import forms, superbracket
from gcrules.poses.paths.segments import Segments

__all__ = ["NO_ZERO", "polynomials", "vanishing"]

Polynomial = Sequence[int]

NO_ZERO: Polynomial = (1,)
"""It stands for the polynomial of a segment without a zero, which is not found."""


def polynomials(way: Segments) -> tuple[list[Polynomial], tuple[int, ...]]:
    """For each segment a polynomial with the same zeros in [0, 1], and the degree of its own one; −1 for 0."""
    turns, shifts = way.changes
    proofs = FloatProofs(forms(way.rig), way.motions, turns, shifts)
    free = proofs.without_zero()
    degrees = np.full(len(way), -1)
    degrees[free] = proofs.powers(np.flatnonzero(free))
    most = 6 * turns + 3 * shifts.any(axis=1)
    known = free & (degrees == most)
    for k in np.flatnonzero(free & ~known & shifts.any(axis=1) & (degrees == most - 1)).tolist():
        known[k] = vanishing(way.rig, tuple(shifts[k].tolist()))
    found = [NO_ZERO] * len(way)
    for k in np.flatnonzero(~known).tolist():
        checkpoint()
        report(f"segment {k + 1} of {len(way)}")
        found[k] = way[k].polynomial
        degrees[k] = len(found[k]) - 1
    return found, tuple(degrees.tolist())


@lru_cache(maxsize=32)
def vanishing(rig: MovingPlatform, axes: tuple[bool, bool, bool]) -> bool:
    """Whether the leading coefficient is 0 for all segments on which the platform moves along these axes only; exact.

    It is of degree 6 in a quaternion and 3 in a translation: 0 if it is 0 for all whole, not negative components of the
    sums 6 and 3 (the principal lattice of a simplex).
    """
    turns = np.array(list(_parted(6, 4)), object).T
    shifts = np.zeros((4, len(list(_parted(3, sum(axes))))), object)
    shifts[[False, *axes]] = np.array(list(_parted(3, sum(axes))), object).T
    number = shifts.shape[1]
    pairs = np.repeat(turns, number, axis=1), np.tile(shifts, turns.shape[1])
    return not superbracket(forms(rig).whole, pairs[0][:, None], pairs[1][:, None]).any()


def _parted(total: int, parts: int) -> Iterator[tuple[int, ...]]:
    """All ways to part a whole number into so many whole ones."""
    if parts == 1:
        yield (total,)
        return
    for first in range(total + 1):
        yield from ((first, *rest) for rest in _parted(total - first, parts - 1))
