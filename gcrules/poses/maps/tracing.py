r"""The zero curves of a factor on a slice of two translations, complete and with proved shape where a part is simple.

Cells are halved until a part is simple: a derivative has one sign in it, and each of its edges has at most one zero
(Descartes' rule on Bernstein coefficients), two edges have one. Then the curve in the part is one arc without loops,
from edge to edge. Parts that are not simple after the last halving (there the curve crosses or touches itself, or
nearly) become a star: arcs from the middle to the zeros on their edges.

Traced is f + δ, with δ four times the rounding of coefficients: then a curve that runs along edges or through nodes of
the grid, where f is exactly 0, is met once. It moves the curve by δ/|slope|, which is far below 1e-6 of a cell.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.poses.maps.bernstein import corners, halves
from gcrules.poses.maps.cells import block_error, open_cells
from gcrules.poses.maps.joining import Arcs
from gcrules.poses.maps.slices import SliceFactor

__all__ = ["DEPTH", "polished", "traced"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

DEPTH = 10
"""How often a cell is halved; parts are then 1/1024 of a cell wide."""
_BLOCK = 100_000
_MOST = 400_000

# The edges of a part: axis that is fixed, end of it (0 low, 1 high).
_EDGES = ((0, 0), (0, 1), (1, 0), (1, 1))


def traced(f: SliceFactor, shape: tuple[int, ...], middle: tuple[int, ...]) -> Arcs:
    """The arcs of f = 0 over a grid of nodes of this shape; places are counted in nodes, 0 the first one."""
    found = []
    reach = tuple(max(m, n - 1 - m) for m, n in zip(middle, shape, strict=True))
    error = block_error(f, reach)
    cells, b = open_cells(f, (-middle[0], -middle[1]), (shape[0] - 1, shape[1] - 1), reach)
    for start in range(0, len(cells), _BLOCK):
        checkpoint()
        part = slice(start, start + _BLOCK)
        found.append(_arcs(b[part] + 4 * error, (cells[part] + np.array(middle)) << DEPTH, error))
    return Arcs.together(found)


def _arcs(b: Floats, corner: Integers, error: float) -> Arcs:
    """`corner` in units of 2^-DEPTH cells."""
    found: list[Arcs] = []
    for depth in range(DEPTH + 1):
        checkpoint()
        flat = b.reshape(len(b), 16)
        open_ = (flat.min(axis=1) <= error) & (flat.max(axis=1) >= -error)
        b, corner = b[open_], corner[open_]
        if not len(b):
            break
        width = 1 << (DEPTH - depth)
        once, never = _edges(b, error)
        sure = _monotone(b, error) & (once | never).all(axis=1)
        single = sure & (once.sum(axis=1) == 2)
        empty = sure & never.all(axis=1)
        found.append(_single(b[single], corner[single], once[single], width))
        rest = ~single & ~empty
        b, corner = b[rest], corner[rest]
        if depth == DEPTH or len(b) > _MOST // 4:
            found.append(_stars(b, corner, width))
            break
        for axis in range(2):
            low, high = halves(b, axis)
            step = np.zeros(2, dtype=np.int64)
            step[axis] = width // 2
            b, corner = np.concatenate([low, high]), np.concatenate([corner, corner + step])
    return Arcs.together(found)


def _edge(b: Floats, axis: int, end: int) -> Floats:
    """The coefficients along an edge, (N, 4)."""
    return np.asarray(np.take(b, 3 * end, axis=axis + 1))


def _edges(b: Floats, error: float) -> tuple[Booleans, Booleans]:
    """For each part and edge whether it surely has exactly one zero, and whether surely none: (N, 4) each."""
    once, never = [], []
    for axis, end in _EDGES:
        c = _edge(b, axis, end)
        sure = (np.abs(c) > error).all(axis=1)
        changes = (np.diff(c > 0, axis=1)).sum(axis=1)
        once.append(sure & (changes == 1))
        never.append(sure & (changes == 0))
    return np.stack(once, axis=1), np.stack(never, axis=1)


def _monotone(b: Floats, error: float) -> Booleans:
    found = np.zeros(len(b), dtype=bool)
    for axis in (1, 2):
        d = np.diff(b, axis=axis).reshape(len(b), -1)
        found |= (d > 2 * error).all(axis=1) | (d < -2 * error).all(axis=1)
    return found


def _single(b: Floats, corner: Integers, once: Booleans, width: int) -> Arcs:
    places = np.zeros((len(b), 2, 2))
    lines = np.zeros((len(b), 2, 2), dtype=np.int64)
    count = np.zeros(len(b), dtype=np.int64)
    for k, (axis, end) in enumerate(_EDGES):
        n = np.flatnonzero(once[:, k])
        places[n, count[n]], lines[n, count[n]] = _on_edge(b[n], corner[n], axis, end, width)
        count[n] += 1
    return Arcs(places, lines)


def _on_edge(b: Floats, corner: Integers, axis: int, end: int, width: int) -> tuple[Floats, Integers]:
    """The zeros on an edge, in nodes, and the lines that hold them: (axis, its place in units of 2^-DEPTH cells)."""
    line = corner[:, axis] + end * width
    place = np.empty((len(b), 2))
    place[:, axis] = line / (1 << DEPTH)
    place[:, 1 - axis] = (corner[:, 1 - axis] + width * _root(_edge(b, axis, end))) / (1 << DEPTH)
    return place, np.stack([np.full(len(b), axis), line], axis=1)


def _root(c: Floats) -> Floats:
    """The zero in [0, 1] of cubics (N, 4) whose ends have different signs, by halving."""
    low, high = np.zeros(len(c)), np.ones(len(c))
    rising = c[:, 3] > c[:, 0]
    for _ in range(54):
        checkpoint()
        t = (low + high) / 2
        u = 1 - t
        value = c[:, 0] * u**3 + 3 * c[:, 1] * u * u * t + 3 * c[:, 2] * u * t * t + c[:, 3] * t**3
        above = (value > 0) == rising
        low, high = np.where(above, low, t), np.where(above, t, high)
    found: Floats = (low + high) / 2
    return found


def _stars(b: Floats, corner: Integers, width: int) -> Arcs:
    """Arcs from the middle of each part to the zeros that show on its edges."""
    c = corners(b).reshape(-1, 2, 2) > 0
    parts = []
    for axis, end in _EDGES:
        ends = np.take(c, end, axis=axis + 1)
        n = np.flatnonzero(ends[:, 0] != ends[:, 1])
        place, line = _on_edge(b[n], corner[n], axis, end, width)
        centre = (corner[n] + width / 2) / (1 << DEPTH)
        # The middle of a part lies on no line of the grid of parts; axis 2 makes a key of its own for it.
        key = np.stack([np.full(len(n), 2), corner[n, 0] + width // 2], axis=1)
        parts.append(Arcs(np.stack([place, centre], axis=1), np.stack([line, key], axis=1)))
    return Arcs.together(parts)


def polished(f: SliceFactor, places: Floats, middle: tuple[int, ...]) -> Floats:
    """Places in nodes, moved along the slope onto f = 0; by less than a part's width, else they are left."""
    found = places
    value, slope = _with_slope(f, found, middle)
    for _ in range(6):
        step = value[:, None] * slope / np.maximum((slope**2).sum(axis=1), 1e-300)[:, None]
        moved = found - step
        new_value, new_slope = _with_slope(f, moved, middle)
        better = (np.abs(moved - places).max(axis=1) < 2.0**-DEPTH) & (np.abs(new_value) < np.abs(value))
        found = np.where(better[:, None], moved, found)
        value, slope = np.where(better, new_value, value), np.where(better[:, None], new_slope, slope)
    return found


def _with_slope(f: SliceFactor, places: Floats, middle: tuple[int, ...]) -> tuple[Floats, Floats]:
    u, v = (places - np.array(middle)).T
    a, b = (np.stack([np.ones_like(w), w, w**2, w**3]) for w in (u, v))
    da, db = (np.stack([np.zeros_like(w), np.ones_like(w), 2 * w, 3 * w**2]) for w in (u, v))

    def at(p: Floats, q: Floats) -> Floats:
        return np.asarray(np.einsum("pq,pn,qn->n", f.tensor, p, q))

    return at(a, b), np.stack([at(da, b), at(a, db)], axis=1)
