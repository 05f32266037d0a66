r"""Which cells of a slice of translations are free of singular poses: proved with Bernstein coefficients.

A cell is *free* where every factor of the superbracket has coefficients of one sign, the cell being halved along all
axes as often as need be; *crossed* where a factor has both signs, or an exact zero at a corner, so that the cell holds
a singular pose; *undecided* where neither was proved after the last halving. A cell contains its boundary.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.poses.maps.bernstein import coefficients, corners, halves, tolerance
from gcrules.poses.maps.slices import SliceFactor

__all__ = ["CROSSED", "FREE", "MEANINGS", "OUTSIDE", "UNDECIDED", "block_error", "certified", "open_cells"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Statuses = NDArray[np.uint8]

FREE, CROSSED, UNDECIDED, OUTSIDE = range(4)
MEANINGS = ("free", "crossed", "undecided", "outside")
"""The last one is for robots of joints: cells with a corner that is not reached."""

_DEPTH = {2: 12, 3: 6}  # halvings, by the number of axes
_BLOCK = 20_000  # blocks of cells at once
_MOST = 400_000  # parts of cells at once; the cells of more stay undecided


def certified(
    factors: Sequence[SliceFactor], first: tuple[int, ...], shape: tuple[int, ...], reach: tuple[int, ...]
) -> Statuses:
    """The status of all cells of a box, an array of this shape; `first` is the lower corner of its first cell."""
    found = np.zeros(shape, dtype=np.uint8)
    for f in factors:
        cells, b = open_cells(f, first, shape, reach)
        place = tuple((cells - np.array(first)).T)
        found[place] = _worst(found[place], _one(f, cells, b, block_error(f, reach)))
    return found


def open_cells(
    f: SliceFactor, first: tuple[int, ...], shape: tuple[int, ...], reach: tuple[int, ...]
) -> tuple[Integers, Floats]:
    """The cells of a box but for those in blocks that are free at a glance: corners (N, axes) and coefficients."""
    axes = len(shape)
    width = tuple(next(w for w in (1, 2, 4, 8, 16) if w >= min(n, 16)) for n in shape)
    starts = [np.arange(0, n, w) for n, w in zip(shape, width, strict=True)]
    cells = np.stack(np.meshgrid(*starts, indexing="ij"), axis=-1).reshape(-1, axes) + np.array(first)
    kept = [(np.zeros((0, axes), dtype=np.int64), np.zeros((0, *[4] * axes)))]
    for start in range(0, len(cells), _BLOCK):
        checkpoint()
        blocks = cells[start : start + _BLOCK]
        kept.append(_opened(blocks, coefficients(f.tensor, blocks, width), width, first, shape, block_error(f, reach)))
    return np.concatenate([c for c, _ in kept]), np.concatenate([b for _, b in kept])


def _opened(
    cells: Integers,
    b: Floats,
    width: tuple[int, ...],
    first: tuple[int, ...],
    shape: tuple[int, ...],
    error: float,
) -> tuple[Integers, Floats]:
    """Blocks of cells, halved until they are single cells or free."""
    for axis in [k for w in (16, 8, 4, 2) for k in range(len(shape)) if width[k] >= w] + [-1]:
        flat = b.reshape(len(b), 4 ** len(shape))
        open_ = (flat.min(axis=1) <= error) & (flat.max(axis=1) >= -error)
        open_ &= (cells - np.array(first) < shape).all(axis=1)
        b, cells = b[open_], cells[open_]
        if axis >= 0:
            step = np.zeros(len(shape), dtype=np.int64)
            step[axis] = width[axis] // 2
            width = tuple(w // 2 if k == axis else w for k, w in enumerate(width))
            b, cells = np.concatenate(halves(b, axis)), np.concatenate([cells, cells + step])
    return cells, b


def block_error(f: SliceFactor, reach: tuple[int, ...]) -> float:
    """What a coefficient may be off by; that of blocks too, which may stand out of the box."""
    return tolerance(f.tensor, tuple(r + 16 for r in reach))


def _worst(one: Statuses, other: Statuses) -> Statuses:
    """Crossed by any factor is crossed; else undecided by any is undecided."""
    found: Statuses = np.where((one == CROSSED) | (other == CROSSED), np.uint8(CROSSED), np.maximum(one, other))
    return found


def _one(f: SliceFactor, corner: Integers, b: Floats, error: float) -> Statuses:
    """The status of cells with these corners and coefficients."""
    found = np.zeros(len(corner), dtype=np.uint8)
    owner = np.arange(len(corner))
    axes = corner.shape[1]
    for depth in range(_DEPTH[axes] + 1):
        checkpoint()
        flat = b.reshape(len(b), 4**axes)
        open_ = (flat.min(axis=1) <= error) & (flat.max(axis=1) >= -error)
        b, owner = b[open_], owner[open_]
        at_corners = corners(b)
        found[owner[(at_corners.min(axis=1) < -error) & (at_corners.max(axis=1) > error)]] = CROSSED
        if depth == 0:
            small = (np.abs(at_corners).min(axis=1, initial=np.inf) <= error) & (found[owner] != CROSSED)
            cells = owner[small]
            found[cells[_zero_at_corners(f, corner[cells])]] = CROSSED
        keep = found[owner] != CROSSED
        b, owner = b[keep], owner[keep]
        if not len(b) or len(b) << axes > _MOST:
            break
        if depth < _DEPTH[axes]:
            for axis in range(axes):
                b = np.concatenate(halves(b, axis))
                owner = np.concatenate([owner, owner])
    found[owner] = UNDECIDED
    return found


def _zero_at_corners(f: SliceFactor, cells: Integers) -> NDArray[np.bool_]:
    """Whether the polynomial is exactly 0 at a corner of each cell."""
    if not len(cells):
        return np.zeros(0, dtype=bool)
    axes = cells.shape[1]
    offsets = np.array(np.meshgrid(*[[0, 1]] * axes)).reshape(axes, -1).T
    places = (cells[:, None, :] + offsets).reshape(-1, axes)
    unique, back = np.unique(places, axis=0, return_inverse=True)
    zero = np.array([f.exact(tuple(p)) == 0 for p in unique.tolist()])
    return np.asarray(zero[back.reshape(-1)].reshape(len(cells), -1).any(axis=1))
