r"""Zero curves from the signs at the nodes of a grid, for slices on which the superbracket is no polynomial.

Each edge with a change of sign gets a zero, found by halving in the compiled superbracket itself; in a cell whose four
edges all change sign the middle decides which zeros belong together. What lies between nodes of equal signs is not
seen: `cells` and `regular_cells` say where something may be missed.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from gcrules.poses.maps.joining import Arcs

__all__ = ["bracketed", "marched"]

Floats = NDArray[np.float64]
Value = Callable[[Floats], Floats]
"""The superbracket at places (N, axes) that are counted in nodes."""

_HALVINGS = 50


def bracketed(value: Value, low: Floats, high: Floats, halvings: int = _HALVINGS) -> Floats:
    """The zero between places of different signs, (N, axes) each; 0 counts as positive."""
    if not len(low):
        return low
    rising = value(low) < 0
    start, stop = np.zeros(len(low)), np.ones(len(low))
    along = high - low
    for _ in range(halvings):
        t = (start + stop) / 2
        beyond = (value(low + t[:, None] * along) >= 0) == rising
        start, stop = np.where(beyond, start, t), np.where(beyond, t, stop)
    found: Floats = low + ((start + stop) / 2)[:, None] * along
    return found


def marched(values: Floats, value: Value, halvings: int = _HALVINGS) -> Arcs:
    """The arcs between the zeros on the edges of a grid with these values at its nodes, (n0, n1); there are none at
    nodes whose value is not a number.
    """
    sign, known = values >= 0, ~np.isnan(values)
    # Edges along the axis 0, then along the axis 1: their zeros, and the numbers of these.
    places, lines, number = [], [], []
    count = 0
    for axis in range(2):
        changed = np.diff(sign, axis=axis) & np.delete(known, 0, axis) & np.delete(known, -1, axis)
        nodes = np.argwhere(changed)
        step = np.zeros(2)
        step[axis] = 1
        low = nodes.astype(np.float64)
        places.append(bracketed(value, low, low + step, halvings))
        lines.append(np.stack([np.full(len(nodes), 1 - axis), nodes[:, 1 - axis]], axis=1))
        table = np.full(changed.shape, -1, dtype=np.int64)
        table[changed] = count + np.arange(len(nodes))
        number.append(table)
        count += len(nodes)
    all_places, all_lines = np.concatenate(places), np.concatenate(lines)
    bottom, top = number[0][:, :-1], number[0][:, 1:]  # edges of each cell: along the axis 0, at its two ends of axis 1
    left, right = number[1][:-1, :], number[1][1:, :]
    around = np.stack([bottom, top, left, right], axis=-1).reshape(-1, 4)
    crossed = (around >= 0).sum(axis=1)
    two = around[crossed == 2]
    pairs = [two[two >= 0].reshape(-1, 2)]
    saddles = np.flatnonzero(crossed == 4)
    if len(saddles):
        i, j = np.divmod(saddles, sign.shape[1] - 1)
        middle = value(np.stack([i + 0.5, j + 0.5], axis=1)) >= 0
        same = middle == sign[i, j]
        a, b, c, d = around[saddles].T
        pairs.append(np.stack([a, np.where(same, d, c)], axis=1))
        pairs.append(np.stack([b, np.where(same, c, d)], axis=1))
    ends = np.concatenate(pairs)
    return Arcs(all_places[ends], all_lines[ends].astype(np.int64))
