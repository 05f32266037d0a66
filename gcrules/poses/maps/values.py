r"""The numbers of a map, chunk by chunk: chunks know nothing of each other, and may be computed anywhere.

A chunk is a number of whole layers along the first axis. It holds, with the axes of the map first:
superbracket (length⁹), margin σ, leg_length (six of them), allowed (1 where the limits are kept), and cell_status
for the cells between its layers and up to the next one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.frozen import HoldsArrays
from gcrules.poses.compiling.compiled import CompiledCondition
from gcrules.poses.maps.cells import CROSSED, FREE, UNDECIDED, certified
from gcrules.poses.maps.grid import Grid
from gcrules.poses.maps.guarded import guarded
from gcrules.poses.maps.limits import LengthLimits
from gcrules.poses.maps.slices import SliceFactor, middle
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.margin import jacobian

__all__ = ["KINDS", "Chunk", "MapTask"]

Floats = NDArray[np.float64]
Chunk = Mapping[str, NDArray[Any]]

KINDS: Mapping[str, Any] = {
    "superbracket": np.float64,
    "margin": np.float32,
    "leg_length": np.float32,
    "allowed": np.uint8,
    "cell_status": np.uint8,
}
"""The arrays that a chunk can have, and their types."""

_POSES = 120_000  # in one chunk, about
_ROUNDING = 1e-12  # of σ: less is 0
_BATCH = 20_000  # poses whose Jacobians are in memory at once


@dataclass(frozen=True, eq=False)
class MapTask(HoldsArrays):
    """What is computed: `measure` is margin (everything) or value (the superbracket, and what the limits need).

    `factors` are those of the superbracket where all axes are translations, else None; `everywhere` says that it is
    exactly 0 in all poses of the slice.
    """

    grid: Grid
    condition: CompiledCondition
    measure: str
    limits: LengthLimits | None
    factors: tuple[SliceFactor, ...] | None
    everywhere: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """The arrays of each chunk."""
        full = ("margin", "leg_length") if self.measure == "margin" else ()
        return ("superbracket", *full, *(("allowed",) if self.limits else ()), "cell_status")

    @property
    def layers(self) -> int:
        """Layers of a chunk; the margin takes long, so its chunks are smaller."""
        poses = _POSES // 4 if self.measure == "margin" else _POSES
        return max(1, poses // math.prod(self.grid.shape[1:]))

    @property
    def number(self) -> int:
        """How many chunks there are."""
        return -(-self.grid.shape[0] // self.layers)

    def span(self, chunk: int) -> tuple[int, int]:
        """The layers of a chunk, the first one and the one after the last."""
        return chunk * self.layers, min((chunk + 1) * self.layers, self.grid.shape[0])

    def value(self, places: Floats) -> Floats:
        """The superbracket at places (N, axes) that are counted in nodes."""
        return self.condition(*self.grid.arrays(self.grid.coordinates(places)))

    def compute(self, chunk: int) -> Chunk:
        """All arrays of a chunk."""
        first, last = self.span(chunk)
        inner = self.grid.shape[1:]
        stop = min(last + 1, self.grid.shape[0])  # one layer more: the cells between it and the chunk belong here
        values = self._superbracket(first, stop)
        found: dict[str, NDArray[Any]] = {"superbracket": values[: last - first]}
        if self.measure == "margin" or self.limits:
            lengths, sigma = self._legs(first, last)
            if self.limits:
                found["allowed"] = self.limits.allow(lengths).astype(np.uint8).reshape(-1, *inner)
            if self.measure == "margin":
                found["leg_length"] = lengths.astype(np.float32).reshape(-1, *inner, 6)
                found["margin"] = sigma.astype(np.float32).reshape(-1, *inner)
        found["cell_status"] = self._cells(first, values)
        return {name: found[name] for name in self.names}

    def _superbracket(self, first: int, stop: int) -> Floats:
        inner = math.prod(self.grid.shape[1:])
        found = np.empty((stop - first) * inner)
        for start in range(0, len(found), 4 * _BATCH):
            checkpoint()
            part = found[start : start + 4 * _BATCH]
            part[:] = self.value(self._places(first * inner + start, len(part)))
        return found.reshape(-1, *self.grid.shape[1:])

    def _places(self, start: int, number: int) -> Floats:
        index = np.unravel_index(np.arange(start, start + number), self.grid.shape)
        return np.stack(index, axis=1).astype(np.float64)

    def _legs(self, first: int, last: int) -> tuple[Floats, Floats]:
        """Lengths (N, 6) and σ (N,), which is 0 where a leg has no length."""
        g, inner = self.grid, math.prod(self.grid.shape[1:])
        number = (last - first) * inner
        lengths, sigma = np.empty((number, 6)), np.zeros(number)
        for start in range(0, number, _BATCH):
            checkpoint()
            part = slice(start, min(start + _BATCH, number))
            ends = g.ends(g.coordinates(self._places(first * inner + start, part.stop - start)))
            lengths[part] = np.linalg.norm(ends - g.rig.base, axis=2)
            whole = (lengths[part] > ROUNDING * g.rig.size).all(axis=1)
            if self.measure == "margin" and whole.any():
                sigma[part][whole] = jacobian(g.rig.base, ends[whole]).sigma
        sigma[sigma < _ROUNDING] = 0.0
        return lengths, sigma

    def _cells(self, first: int, values: Floats) -> NDArray[np.uint8]:
        shape = tuple(n - 1 for n in values.shape)
        if self.everywhere:
            return np.full(shape, CROSSED, dtype=np.uint8)
        if self.factors is not None:
            start = middle(self.grid)
            reach = tuple(max(m, n - 1 - m) for m, n in zip(start, self.grid.shape, strict=True))
            return certified(self.factors, (first - start[0], *(-m for m in start[1:])), shape, reach)
        low = high = values
        for axis in range(len(shape)):
            n = values.shape[axis]
            one, other = np.arange(n - 1), np.arange(1, n)
            low = np.minimum(low.take(one, axis), low.take(other, axis))
            high = np.maximum(high.take(one, axis), high.take(other, axis))
        found = np.where((low <= 0) & (high >= 0), np.uint8(CROSSED), np.uint8(UNDECIDED))
        if self.measure == "value":  # quick, but nothing is proved
            return found
        unsure = np.argwhere(found == UNDECIDED)
        free = guarded(self.grid, unsure + np.array([first, *[0] * (len(shape) - 1)]))
        found[tuple(unsure[free].T)] = FREE
        return found
