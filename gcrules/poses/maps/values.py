r"""The numbers of a map, chunk by chunk: chunks know nothing of each other, and may be computed anywhere.

A chunk is a number of whole layers along the first axis. It holds, with the axes of the map first:
superbracket (length⁹), margin σ, leg_length (six of them), allowed (1 where the limits are kept), and cell_status
for the cells between its layers and up to the next one.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays
from gcrules.core.version import __version__
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.leg_amplification import amplified_by_legs
from gcrules.poses.compiling.compiled import CompiledCondition
from gcrules.poses.maps.cells import CROSSED, FREE, UNDECIDED, certified
from gcrules.poses.maps.grid import Grid
from gcrules.poses.maps.regular_cells import regular_cells
from gcrules.poses.maps.slices import MEMBERS, SliceFactor, middle
from gcrules.poses.maps.summary import MapSummary
from gcrules.poses.maps.task import Chunk, InLayers
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import AT_ROUNDED, ROUNDED

__all__ = ["LegsTask"]

Floats = NDArray[np.float64]

_POSES = 120_000  # in one chunk, about
_ROUNDING = 1e-12  # of σ: less is 0
_BY_ROUNDING = "; but margins are 0 to rounding, so that with the exact turn poses may be singular"
_BATCH = 20_000  # poses whose Jacobians are in memory at once


@dataclass(frozen=True, eq=False)
class LegsTask(InLayers, HoldsArrays):
    """A `MapTask` of a platform on six legs: `measure` is value (the superbracket, and what the limits need), margin
    (everything), or an index of the legs' rates, which comes on top.

    `factors` are those of the superbracket where all axes are translations, else None; `everywhere` says that it is
    exactly 0 in all poses of the slice.
    """

    grid: Grid
    condition: CompiledCondition
    measure: str
    limits: LengthLimits | None
    factors: tuple[SliceFactor, ...] | None
    everywhere: bool = False

    halvings = 50
    stage = None

    @property
    def names(self) -> tuple[str, ...]:
        """The arrays of each chunk."""
        full = () if self._quick else ("margin", "leg_length")
        return (
            *("superbracket", *full),
            *(("allowed",) if self.limits else ()),
            *((self.measure,) if self.measure in INDICES else ()),
            "cell_status",
        )

    @property
    def _quick(self) -> bool:
        return self.measure == "value"

    @property
    def layers(self) -> int:
        """Layers of a chunk; the margin takes long, so its chunks are smaller."""
        poses = _POSES if self._quick else _POSES // 4
        return max(1, poses // math.prod(self.grid.shape[1:]))

    def value(self, places: Floats) -> Floats:
        """The superbracket at places (N, axes) that are counted in nodes."""
        return self.condition(*self.grid.arrays(self.grid.coordinates(places)))

    def level(self, chunk: Chunk) -> Floats:
        """The superbracket at the nodes."""
        return chunk["superbracket"]

    def spare(self, coordinates: Floats) -> Floats:
        """By how much poses (N, axes) keep to the limits of leg lengths; below 0: not."""
        if self.limits is None:
            return np.ones(len(coordinates))
        parts = [np.zeros(0)]
        for start in range(0, len(coordinates), 5 * _BATCH):
            ends = self.grid.ends(coordinates[start : start + 5 * _BATCH])
            parts.append(self.limits.margin(np.linalg.norm(ends - self.grid.rig.base, axis=2)))
        return np.concatenate(parts)

    @property
    def beyond(self) -> str:
        """What is said of poses that are not allowed."""
        return "beyond the limits"

    @property
    def accuracy(self) -> str:
        """How curves are found that are no zeros of a polynomial."""
        return (
            "curves are traced from the signs at the nodes, zeros on edges found by halving; pieces smaller than a "
            "cell may be missed, but only in undecided cells"
        )

    @property
    def guard(self) -> str:
        """What a margin guarantees."""
        return "no pose is singular while every leg turns by less than asin(sigma) relative to the platform"

    def about(self, sentence: str) -> dict[str, str]:
        """The robot, its condition and the pose of the other coordinates."""
        rig = self.grid.rig
        return {
            "robot": rig.title,
            "legs": ", ".join(rig.names),
            "condition": sentence,
            "superbracket": self.condition.expression,
            "pose_of_the_rest": self.grid.at.text(),
            "centre_of_turns": " ".join(f"{float(c):.17g}" for c in rig.centre),
            "unit_of_length": rig.unit or "not named",
        }

    def subject(self) -> dict[str, Any]:
        """The robot and its legs."""
        rig = self.grid.rig
        return {
            "title": rig.title,
            "unit": rig.unit,
            "legs": [list(leg) for leg in rig.structure.legs],
            "platform": list(rig.structure.platform),
            "about": [float(c) for c in rig.centre],
        }

    def guarantee(self, summary: MapSummary) -> str:
        """What is proved, in one sentence; of a turn that was rounded it says so."""
        said = self._guarantee(summary)
        if ROUNDED not in self.grid.notes:
            return said
        doubtful = summary.margin == 0 and not self.everywhere and not any(summary.cells[1:])
        return AT_ROUNDED + said + _BY_ROUNDING * doubtful

    def _guarantee(self, summary: MapSummary) -> str:
        free, crossed, undecided = summary.cells
        there = "slice" if len(self.grid.axes) == 2 else "volume"
        if self.everywhere and self.factors is None:
            return f"every pose is singular: the superbracket is exactly 0 in {MEMBERS} random poses of the {there}"
        if self.everywhere:
            return f"the superbracket is the zero polynomial on this {there}, exactly: every pose is singular"
        if self.factors is None and self._quick:
            return f"none: {crossed:,} cells are crossed by a change of sign; a map of the margin proves others free"
        if self.factors is not None:
            how = "the superbracket is an exact polynomial there, its Bernstein coefficients show its signs"
        else:
            how = "by bounds of the legs' coordinates around their middles"
        left = f"{crossed:,} crossed, {undecided:,} undecided"
        if not crossed + undecided:
            return f"no pose of the {there} is singular: all {free:,} cells are proved free: {how}"
        return (
            f"every singular pose of the {there} lies in the {crossed + undecided:,} cells that are not free ({left}); "
            + (f"{free:,} cells are proved free: {how}")
        )

    @property
    def manifest(self) -> dict[str, Any]:
        """Of what its chunks are."""
        g = self.grid
        return {
            "version": __version__,
            "robot": {
                "legs": [list(leg) for leg in g.rig.structure.legs],
                "points": {n: [str(c) for c in p] for n, p in g.rig.points.items()},
                "unit": g.rig.unit,
            },
            "centre": [str(c) for c in g.rig.centre],
            "pose": [str(c) for c in (*g.at.translation, *g.at.quaternion)],
            "angles": [str(c) for c in g.angles],
            "over": [a.text for a in g.axes],
            "measure": self.measure,
            "superbracket": self.condition.expression,
            "limits": self.limits.to_json() if self.limits else None,
            "layers": self.layers,
        }

    def compute(self, chunk: int) -> Chunk:
        """All arrays of a chunk."""
        first, last = self.span(chunk)
        inner = self.grid.shape[1:]
        stop = min(last + 1, self.grid.shape[0])  # one layer more: the cells between it and the chunk belong here
        values = self._superbracket(first, stop)
        found: dict[str, NDArray[Any]] = {"superbracket": values[: last - first]}
        if not self._quick or self.limits:
            lengths, sigma, index = self._legs(first, last)
            if self.limits:
                found["allowed"] = self.limits.allow(lengths).astype(np.uint8).reshape(-1, *inner)
            if not self._quick:
                found["leg_length"] = lengths.astype(np.float32).reshape(-1, *inner, 6)
                if self.measure in INDICES:
                    found[self.measure] = index.astype(np.float32).reshape(-1, *inner)
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

    def _legs(self, first: int, last: int) -> tuple[Floats, Floats, Floats]:
        """Lengths (N, 6), σ (N,), which is 0 where a leg has no length, and the index, not a number there."""
        g, inner = self.grid, math.prod(self.grid.shape[1:])
        number = (last - first) * inner
        lengths, sigma, index = np.empty((number, 6)), np.zeros(number), np.full(number, np.nan)
        for start in range(0, number, _BATCH):
            checkpoint()
            part = slice(start, min(start + _BATCH, number))
            at = g.coordinates(self._places(first * inner + start, part.stop - start))
            ends = g.ends(at)
            lengths[part] = np.linalg.norm(ends - g.rig.base, axis=2)
            whole = (lengths[part] > ROUNDING * g.rig.size).all(axis=1)
            if not self._quick and whole.any():
                sigma[part][whole] = jacobian(g.rig.base, ends[whole]).sigma
            if self.measure in INDICES:
                every = amplified_by_legs(g.rig.base, ends, g.centres(at))
                index[part] = INDICES[self.measure].of(every)
        sigma[sigma < _ROUNDING] = 0.0
        return lengths, sigma, index

    def _cells(self, first: int, values: Floats) -> NDArray[np.uint8]:
        shape = tuple(n - 1 for n in values.shape)
        if self.everywhere:
            return np.full(shape, CROSSED, dtype=np.uint8)
        if self.factors is not None:
            start = middle(self.grid.shape)
            reach = tuple(max(m, n - 1 - m) for m, n in zip(start, self.grid.shape, strict=True))
            return certified(self.factors, (first - start[0], *(-m for m in start[1:])), shape, reach)
        low = high = values
        for axis in range(len(shape)):
            n = values.shape[axis]
            one, other = np.arange(n - 1), np.arange(1, n)
            low = np.minimum(low.take(one, axis), low.take(other, axis))
            high = np.maximum(high.take(one, axis), high.take(other, axis))
        found = np.where((low <= 0) & (high >= 0), np.uint8(CROSSED), np.uint8(UNDECIDED))
        if self._quick:  # , but nothing is proved
            return found
        unsure = np.argwhere(found == UNDECIDED)
        free = regular_cells(self.grid, unsure + np.array([first, *[0] * (len(shape) - 1)]))
        found[tuple(unsure[free].T)] = FREE
        return found
