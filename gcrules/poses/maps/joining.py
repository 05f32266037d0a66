r"""Arcs that are joined into curves: ends that lie on one line of the grid and agree are the same point."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass

__all__ = ["Arcs", "joined"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_SAME = 1e-8  # of a cell


@dataclass(frozen=True, eq=False)
class Arcs:
    """N short arcs with their ends' places (N, 2, 2), in nodes, and the lines that hold the ends, (N, 2, 2)."""

    places: Floats
    lines: Integers

    @staticmethod
    def together(parts: Sequence[Arcs]) -> Arcs:
        places = [np.zeros((0, 2, 2)), *(p.places for p in parts)]
        lines = [np.zeros((0, 2, 2), dtype=np.int64), *(p.lines for p in parts)]
        return Arcs(np.concatenate(places), np.concatenate(lines))

    def __len__(self) -> int:
        return len(self.places)


def joined(arcs: Arcs) -> list[Floats]:
    """The curves as places (K, 2), closed ones with the first place again at the end; they end where arcs branch."""
    if not len(arcs):
        return []
    number, places = _points(arcs)
    at: dict[int, list[tuple[int, int]]] = defaultdict(list)
    for n, (p, q) in enumerate(number.tolist()):
        if p != q:
            at[p].append((n, q))
            at[q].append((n, p))
    done: set[int] = set()
    found: list[Floats] = []
    # Curves with ends first, then the closed ones.
    for start in [*(p for p, out in at.items() if len(out) != 2), *at]:
        for n, following in at[start]:
            if n not in done:
                found.append(places[_walk(at, done, start, n, following)])
    return found


def _walk(at: dict[int, list[tuple[int, int]]], done: set[int], start: int, arc: int, following: int) -> list[int]:
    way = [start, following]
    done.add(arc)
    while len(at[way[-1]]) == 2 and way[-1] != start:
        checkpoint()
        onward = next(((n, q) for n, q in at[way[-1]] if n not in done), None)
        if onward is None:
            break
        done.add(onward[0])
        way.append(onward[1])
    return way


def _points(arcs: Arcs) -> tuple[Integers, Floats]:
    """A number for each end, (N, 2), equal for ends that agree; and the places of the numbers."""
    places, lines = arcs.places.reshape(-1, 2), arcs.lines.reshape(-1, 2)
    along = np.where(lines[:, 0] == 0, places[:, 1], places[:, 0])
    along = np.where(lines[:, 0] == 2, places[:, 1], along)
    order = np.lexsort((along, lines[:, 1], lines[:, 0]))
    sorted_lines, sorted_along = lines[order], along[order]
    new = np.ones(len(order), dtype=bool)
    new[1:] = (np.diff(sorted_lines, axis=0) != 0).any(axis=1) | (np.diff(sorted_along) > _SAME)
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.cumsum(new) - 1
    return number.reshape(-1, 2), places[order][new]
