r"""A walk from one way to write a polynomial to others, in search of few terms.

The polynomial is written in a basis of bracket monomials. One step exchanges a monomial of the basis for another one;
the coordinates of all monomials and of the polynomial follow by one elimination modulo a prime, as in the simplex
method. Steps that leave fewer coordinates of the polynomial are preferred, then those that leave as many, then any;
what has just been taken out stays out for a while. Every shortest form is a basic one, so it can be reached, but
nothing is proved by not reaching it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.algebra.factoring.modular import MODULUS, Ints, inverse, reduced
from gcrules.core.budget import Count, checkpoint

__all__ = ["shorter_supports"]

_NEVER = 10**6
_OUT = (3, 10)  # for how many steps a monomial that was taken out stays out


def shorter_supports(
    value: Ints, target: Ints, first: Sequence[int], steps: int, seed: int, work: Count
) -> Iterator[tuple[int, ...]]:
    """Places of monomials that have the target in their span modulo p, each time fewer than before.

    `value` is (monomial, position) with more positions than the dimension; the basis is made of the monomials at
    `first`, then of others in sequence. Raises LimitReached.
    """
    rng = np.random.default_rng(seed)
    walk = _Walk(value, target, first)
    least = len(value) + 1
    for step in range(steps if walk.spans else 0):
        checkpoint()
        work.done += walk.table.size
        if work.left < 0:
            return
        support = np.flatnonzero(walk.table[:, -1])
        if len(support) < least:
            least = len(support)
            yield tuple(sorted(int(i) for i in walk.basis[support]))
        if len(support) < 2 or not walk.step(support, step, rng):
            return


class _Walk:
    def __init__(self, value: Ints, target: Ints, first: Sequence[int]) -> None:
        table = np.concatenate([value.T, target[:, None]], axis=1)
        basis: list[int] = []
        for column in dict.fromkeys((*first, *range(len(value)))):
            pivots = np.flatnonzero(table[len(basis) :, column])
            if len(pivots):
                low, row = len(basis), len(basis) + int(pivots[0])
                table[[low, row]] = table[[row, low]]
                _eliminate(table, low, column)
                basis.append(column)
                if len(basis) == len(table):
                    break
        self.spans = not table[len(basis) :, -1].any()
        self.table = table[: len(basis)]
        self.basis = np.array(basis)
        self.until = np.zeros(len(value), dtype=np.int64)

    def step(self, support: Ints, step: int, rng: np.random.Generator) -> bool:
        """Exchange one monomial for another; False where there is none to exchange."""
        table, width = self.table, self.table.shape[1] - 1
        filled = table[:, :width] != 0
        within = filled[support]
        ratio = reduced(table[support, :width] * inverse(table[support, -1])[:, None])
        gone = np.zeros(ratio.shape, dtype=np.int64)
        for row in ratio:
            gone += ratio == row
        change = filled.sum(axis=0) - within.sum(axis=0) + 1 - gone
        change[~within] = _NEVER
        change[:, self.basis] = _NEVER
        change[:, self.until > step] = _NEVER
        least = int(change.min())
        if least <= 0 or rng.random() < 0.5**least:
            rows, columns = np.nonzero(change == least)
            n = int(rng.integers(len(rows)))
            row, column = int(support[rows[n]]), int(columns[n])
        else:  # the polynomial stays as it is, the basis does not
            others = np.flatnonzero(table[:, -1] == 0)
            if not len(others):
                return False
            row = int(rng.choice(others))
            free = filled[row]
            free[self.basis] = False
            if not free.any():
                return True
            column = int(rng.choice(np.flatnonzero(free)))
        self.until[self.basis[row]] = step + int(rng.integers(*_OUT))
        _eliminate(table, row, column)
        self.basis[row] = column
        return True


def _eliminate(table: Ints, row: int, column: int) -> None:
    """Make the column a unit vector with its 1 in the row."""
    table[row] = reduced(table[row] * pow(int(table[row, column]), -1, MODULUS))
    factor = table[:, column].copy()
    factor[row] = 0
    rows, columns = np.flatnonzero(factor), np.flatnonzero(table[row])
    at = np.ix_(rows, columns)
    table[at] = reduced(table[at] + reduced((MODULUS - factor[rows])[:, None] * table[row, columns]))
