r"""Singular surfaces over three coordinates: marching cubes, then every vertex brought onto the zero set.

On a slice of translations each factor of the superbracket gives sheets of its own, so sheets that cross each other stay
apart, and factors without a change of sign in the superbracket are seen. On other slices the sign of the superbracket
is marched. The grid is taken in slabs of layers, whose meshes share the vertices of the layer between them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.maps.marching import bracketed
from gcrules.poses.maps.slices import SliceFactor, middle

__all__ = ["MAX_TRIANGLES", "Sheet", "of_factor", "sheet"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Value = Callable[[Floats], Floats]
Layers = Callable[[int, int], Floats]
"""The values at the nodes of the layers from one to the one before another."""

MAX_TRIANGLES = 1_200_000
"""In all sheets of a surface."""
_SLAB = 1_000_000  # nodes that are marched at once
_AT_ONCE = 50_000  # places
_ON = 1e-4  # marching cubes gives places in single precision
_TINY = np.float32(1e-30)

Sheet = tuple[Floats, Floats, Integers, NDArray[np.bool_]]
"""Places in nodes (V, 3), gradients there (per node), triangles (F, 3), and which places were brought to zero."""


def of_factor(f: SliceFactor, shape: tuple[int, ...]) -> tuple[Value, Layers]:
    """A factor as a function of places, and at layers of nodes."""
    start = np.array(middle(shape), dtype=np.float64)
    exponents = sorted(f.polynomial)

    def value(places: Floats) -> Floats:
        powers: list[list[Any]] = []
        for w in (places - start).T:
            powers.append([1.0, w, w * w, w * w * w])
        found = np.zeros(len(places))
        for i, j, k in exponents:
            found += f.tensor[i, j, k] * powers[0][i] * powers[1][j] * powers[2][k]
        return found

    def layers(first: int, last: int) -> Floats:
        nodes = [np.arange(first, last), np.arange(shape[1]), np.arange(shape[2])]
        powers = [np.stack([(n - c) ** k for k in range(4)]) for n, c in zip(nodes, start, strict=True)]
        found: Floats = np.einsum("pqr,pi,qj,rk->ijk", f.tensor, *powers, optimize=True)
        return found

    return value, layers


def sheet(value: Value, layers: Layers, shape: tuple[int, ...], before: int = 0) -> Sheet:
    """The surface on which the values are 0. Raises LimitReached for too many triangles, `before` among them."""
    march = _marching_cubes()
    value = _in_parts(value)
    places: list[Floats] = []
    faces: list[Integers] = []
    good: list[NDArray[np.bool_]] = []
    total, triangles = 0, before
    border: tuple[Integers, Integers] = np.zeros((0, 4), dtype=np.int64), np.zeros(0, dtype=np.int64)
    for first, last in _slabs(shape):
        checkpoint()
        values = layers(first, last)
        known = ~np.isnan(values)
        largest = float(np.abs(values[known]).max(initial=0))
        if not largest or values[known].min() >= 0 or values[known].max() < 0:
            border = border[0][:0], border[1][:0]
            continue
        small = (values / largest).astype(np.float32)
        small = np.where(values >= 0, np.maximum(small, _TINY), np.minimum(small, -_TINY))
        found, corners, _, _ = march(np.where(known, small, _TINY), level=0.0, allow_degenerate=False)
        if not known.all():
            found, corners = _among(known, found, corners)
        vertex = np.asarray(found, dtype=np.float64) + np.array([first, 0, 0])
        triangles += len(corners)
        if triangles > MAX_TRIANGLES:
            raise LimitReached(f"the surface has more than {MAX_TRIANGLES:,} triangles", hint="use a coarser grid")
        keys = _keys(vertex)
        vertex, sure = _onto(value, vertex, keys)
        # Vertices that are the same edge of the grid are one, here and in the slab before.
        unique, index, back = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        back = back.reshape(-1)
        known = _lookup(border, unique)
        fresh = np.flatnonzero(known < 0)
        known[fresh] = total + np.arange(len(fresh))
        places.append(vertex[index[fresh]])
        good.append(sure[index[fresh]])
        total += len(fresh)
        corner = known[back[np.asarray(corners, dtype=np.int64)]]
        proper = (corner[:, 0] != corner[:, 1]) & (corner[:, 1] != corner[:, 2]) & (corner[:, 2] != corner[:, 0])
        faces.append(corner[proper])
        shared = (unique[:, 1] == last - 1) & (unique[:, 0] != 0)
        border = unique[shared], known[shared]
    where = np.concatenate([np.zeros((0, 3)), *places])
    slope = _gradient(value, where)
    listed = np.concatenate([np.zeros((0, 3), dtype=np.int64), *faces])
    return where, slope, _turned(where, slope, listed), np.concatenate([np.zeros(0, dtype=bool), *good])


def _marching_cubes() -> Any:
    try:
        from skimage.measure import marching_cubes  # an extra of the installation
    except ImportError:
        raise InputError("surfaces need scikit-image", hint='pip install "gcrules[maps]"') from None
    return marching_cubes


def _among(known: NDArray[np.bool_], vertex: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """The triangles in cells all of whose corners are known, with their vertices."""
    whole = np.asarray(sliding_window_view(known, (2, 2, 2)).all(axis=(3, 4, 5)))
    cell = np.clip(np.floor(vertex[faces].mean(axis=1)).astype(np.int64), 0, np.array(whole.shape) - 1)
    used, back = np.unique(faces[whole[tuple(cell.T)]], return_inverse=True)
    return vertex[used], back.reshape(-1, 3)


def _in_parts(value: Value) -> Value:
    """The same, for many places without much memory."""

    def found(places: Floats) -> Floats:
        parts = [value(places[n : n + _AT_ONCE]) for n in range(0, len(places), _AT_ONCE)]
        return np.concatenate([np.zeros(0), *parts])

    return found


def _slabs(shape: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Layers from, to (not included); neighbours share one layer."""
    step = max(1, _SLAB // (shape[1] * shape[2]) - 1)
    for first in range(0, shape[0] - 1, step):
        checkpoint()
        yield first, min(first + step + 1, shape[0])


def _keys(vertex: Floats) -> Integers:
    """For each vertex the axis of its edge and the edge's lower node; axis 3 for a node, 4 for the inside of a cell
    (with a number of its own).
    """
    near = np.rint(vertex)
    whole = np.abs(vertex - near) <= _ON
    number = whole.sum(axis=1)
    axis = np.where(number == 3, 3, np.where(number == 2, np.argmin(whole, axis=1), 4))
    low = np.where(whole, near, np.floor(vertex)).astype(np.int64)
    inside = np.flatnonzero(axis == 4)
    low[inside, 2] = -1 - inside
    return np.concatenate([axis[:, None], low], axis=1).astype(np.int64)


def _onto(value: Value, vertex: Floats, keys: Integers) -> tuple[Floats, NDArray[np.bool_]]:
    """Vertices on edges by halving between the two nodes, the others by Newton's method along the gradient."""
    found = vertex.copy()
    sure = np.zeros(len(vertex), dtype=bool)
    for axis in range(3):
        at = np.flatnonzero(keys[:, 0] == axis)
        low = keys[at, 1:].astype(np.float64)
        high = low.copy()
        high[:, axis] += 1
        differs = (value(low) >= 0) != (value(high) >= 0) if len(at) else np.zeros(0, dtype=bool)
        found[at[differs]] = bracketed(value, low[differs], high[differs])
        sure[at[differs]] = True
    rest = np.flatnonzero(~sure)
    if len(rest):
        place = vertex[rest]
        for _ in range(6):
            slope = _gradient(value, place)
            place = place - value(place)[:, None] * slope / np.maximum((slope**2).sum(axis=1), 1e-300)[:, None]
        step = np.abs(place - vertex[rest]).max(axis=1)
        slope = np.linalg.norm(_gradient(value, place), axis=1)
        near = np.isfinite(place).all(axis=1) & (step < 1) & (np.abs(value(place)) <= 1e-6 * slope)
        found[rest[near]] = place[near]
        sure[rest[near]] = True
    return found, sure


def _gradient(value: Value, places: Floats) -> Floats:
    """By differences of ±1/1000 of a cell."""
    found = np.zeros_like(places)
    if len(places):
        for k in range(3):
            step = np.zeros(3)
            step[k] = 1e-3
            found[:, k] = (value(places + step) - value(places - step)) / 2e-3
    return found


def _lookup(known: tuple[Integers, Integers], keys: Integers) -> Integers:
    """The numbers of keys that are known already, −1 for others."""
    table = {tuple(k): n for k, n in zip(known[0].tolist(), known[1].tolist(), strict=True)}
    if not table:
        return np.full(len(keys), -1, dtype=np.int64)
    return np.array([table.get(tuple(k), -1) for k in keys.tolist()], dtype=np.int64)


def _turned(places: Floats, slope: Floats, faces: Integers) -> Integers:
    """The triangles, all turned round if most of them are not as the gradient says: neighbours stay alike."""
    if len(faces):
        a, b, c = (places[faces[:, k]] for k in range(3))
        along = (np.cross(b - a, c - a) * slope[faces].sum(axis=1)).sum(axis=1)
        if (along < 0).sum() > (along > 0).sum():
            return np.ascontiguousarray(faces[:, ::-1])
    return faces
