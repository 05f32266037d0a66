"""A small linear program in doubles; the answer is used as a proof only after it was checked in whole numbers."""

from __future__ import annotations

import numpy as np

from gcrules.algebra.factoring.residues import Floats

__all__ = ["maximized"]

_STEPS = 2_000
_SMALL = 1e-9


def maximized(gain: Floats, use: Floats) -> Floats:
    """y ≥ 0 with use · y ≤ 1 in every row and gain · y as large as possible (the simplex method, from y = 0).

    `use` must not be negative and no column of it 0. What is returned is feasible up to rounding, and the best unless
    the method was cut short.

    >>> [float(v) for v in maximized(np.array([1.0, 1.0]), np.array([[1.0, 0.0], [1.0, 2.0]]))]
    [1.0, 0.0]
    """
    rows, columns = use.shape
    table = np.zeros((rows + 1, columns + 1))
    table[:rows, :columns] = use
    table[:rows, columns] = 1
    table[rows, :columns] = gain
    basis = [-1] * rows  # the column that each row solves for; −1 − row for its slack
    names = list(range(columns))
    for step in range(_STEPS):
        profit = table[rows, :columns]
        better = np.flatnonzero(profit > _SMALL)
        if not len(better):
            break
        # Bland's choice, which cannot go round in circles, after the greedy one had its time.
        j = int(better[np.argmax(profit[better])]) if step < _STEPS // 2 else int(better[0])
        column = table[:rows, j]
        positive = np.flatnonzero(column > _SMALL)
        if not len(positive):
            break
        i = int(positive[np.argmin(table[positive, columns] / column[positive])])
        pivot = table[i, j]
        basis[i], names[j] = names[j], basis[i]
        row, entering = table[i] / pivot, table[:, j].copy()
        table -= entering[:, None] * row
        table[i] = row
        table[:, j] = -entering / pivot
        table[i, j] = 1 / pivot
    found = np.zeros(columns)
    for i, name in enumerate(basis):
        if name >= 0:
            found[name] = max(0.0, table[i, columns])
    return found
