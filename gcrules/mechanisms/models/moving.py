"""Configurations of a model near its home, all loops closed: what holds in all of them is no accident of the home."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, exponential, inverse, logarithm
from gcrules.mechanisms.models.model import ModelCoupling
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.snapping import size_of

__all__ = ["Moving", "kernel", "span"]

_STEP = 0.2  # rad, and parts of the size
_RANK = 1e-7
_CLOSED = 1e-11


class Moving:
    """Motions between bodies from a base, with what couples them; lengths are in parts of the size."""

    def __init__(
        self, motions: Sequence[Motion], base: str, couplings: Sequence[ModelCoupling] = (), size: float | None = None
    ) -> None:
        self.motions = tuple(motions)
        self.base = base
        self.size = size or size_of(motions)
        self.screws = np.concatenate([m.screws for m in motions])
        turns = self.screws[:, :3].any(axis=1)
        self.screws[turns, 3:] /= self.size  # slides go in parts of the size
        ends = np.cumsum([0, *(len(m.screws) for m in motions)])
        self.own = [slice(int(a), int(b)) for a, b in pairwise(ends)]
        places = {m.joint: own.start for m, own in zip(motions, self.own, strict=True)}
        kinds = {m.joint: m.kind for m in motions}
        self.coupled = np.zeros((0, len(self.screws)))
        for c in couplings:
            if c.joint in places and c.leader in places:
                row = np.zeros(len(self.screws))
                unit = {"P": self.size}  # of slides, whose values are parts of the size
                row[places[c.joint]] = unit.get(kinds[c.joint], 1.0)
                row[places[c.leader]] = -c.ratio * unit.get(kinds[c.leader], 1.0)
                self.coupled = np.vstack([self.coupled, row / np.abs(row).max()])
        self._tree()

    def _tree(self) -> None:
        """Steps (motion, whether it goes forward) that reach all bodies from the base, and the motions left over."""
        self.steps: list[tuple[int, bool]] = []
        self.ways: dict[str, list[tuple[int, bool]]] = {self.base: []}
        waiting = [self.base]
        while waiting:
            here = waiting.pop(0)
            for k, m in enumerate(self.motions):
                for near, far, forward in ((m.start, m.end, True), (m.end, m.start, False)):
                    if near == here and far not in self.ways:
                        self.ways[far] = [*self.ways[here], (k, forward)]
                        self.steps.append((k, forward))
                        waiting.append(far)
        used = {k for k, _ in self.steps}
        self.closing = [k for k in range(len(self.motions)) if k not in used]

    def _single(self, k: int, values: Floats, *, forward: bool) -> Floats:
        motion = np.eye(4)
        for i in range(self.own[k].start, self.own[k].stop):
            motion = motion @ exponential(self.screws[i], values[i])
        return motion if forward else inverse(motion)

    def poses(self, values: Floats) -> dict[str, Floats]:
        """How each body has moved from home, (4, 4)."""
        found = {self.base: np.eye(4)}  # lengths in parts of the size
        for k, forward in self.steps:
            m = self.motions[k]
            near, far = (m.start, m.end) if forward else (m.end, m.start)
            found[far] = found[near] @ self._single(k, values, forward=forward)
        return found

    def _rows(self, poses: Mapping[str, Floats], values: Floats) -> Floats:
        """The twists of all motions where they are, each as it moves its `end` against its `start`."""
        found = np.zeros_like(self.screws)
        for k, m in enumerate(self.motions):
            here = poses[m.start]
            for i in range(self.own[k].start, self.own[k].stop):
                found[i] = carried(here, self.screws[i])
                here = here @ exponential(self.screws[i], values[i])
        return found

    def _twist(self, body: str, rows: Floats) -> Floats:
        """How the twist of a body (6, n) depends on the rates of all motions."""
        found = np.zeros((6, len(rows)))
        for k, forward in self.ways[body]:
            found[:, self.own[k]] = rows[self.own[k]].T * (1 if forward else -1)
        return found

    def conditions(self, values: Floats) -> tuple[Floats, Floats]:
        """How far the loops are open, and how that changes with the values."""
        poses = self.poses(values)
        rows = self._rows(poses, values)
        residuals, rates = [self.coupled @ values], [self.coupled]
        for k in self.closing:
            m = self.motions[k]
            there = poses[m.start] @ self._single(k, values, forward=True)
            residuals.append(logarithm(there @ inverse(poses[m.end])))
            rate = self._twist(m.start, rows) - self._twist(m.end, rows)
            rate[:, self.own[k]] += rows[self.own[k]].T
            rates.append(rate)
        return np.concatenate(residuals), np.concatenate(rates)

    @cached_property
    def home(self) -> Floats:
        return np.zeros(len(self.screws))

    def near_home(self, seed: int) -> Floats | None:
        """Values of a configuration some way from home, or None where none was found."""
        rng = np.random.default_rng(seed)
        rates = self.conditions(self.home)[1]
        free = kernel(rates)
        for step in _STEP * 0.5 ** np.arange(8):
            checkpoint()
            values = free @ rng.normal(size=free.shape[1])
            values *= step / max(float(np.abs(values).max(initial=0.0)), 1e-12)
            for _ in range(25):
                residual, rates = self.conditions(values)
                if np.abs(residual).max(initial=0.0) < _CLOSED:
                    if np.abs(values).max(initial=0.0) > step / 10:
                        return values
                    break
                values = values - np.linalg.lstsq(rates, residual, rcond=_RANK)[0]
                if np.abs(values).max() > 10 * step:
                    break
        return None

    def twists(self, body: str, values: Floats, held: Sequence[str] = (), tolerance: float = _RANK) -> Floats:
        """A basis (n, 6) of the twists that the joints allow a body there, with some of them held; lengths in parts of
        the size.
        """
        rates = self.conditions(values)[1]
        rows = self._rows(self.poses(values), values)
        still = [np.eye(len(rows))[own] for m, own in zip(self.motions, self.own, strict=True) if m.joint in held]
        free = kernel(np.concatenate([rates, *still]), tolerance)
        return span((self._twist(body, rows) @ free).T, tolerance)


def kernel(matrix: Floats, tolerance: float = _RANK) -> Floats:
    """An orthonormal basis of what a matrix maps to zero, as columns."""
    if not len(matrix):
        return np.eye(matrix.shape[1])
    _, sizes, right = np.linalg.svd(matrix)
    return right[int((sizes > tolerance).sum()) :].T


def span(rows: Floats, tolerance: float = _RANK) -> Floats:
    """An orthonormal basis of the span of rows."""
    if not len(rows):
        return np.zeros((0, rows.shape[1]))
    _, sizes, right = np.linalg.svd(rows, full_matrices=False)
    return right[sizes > tolerance]
