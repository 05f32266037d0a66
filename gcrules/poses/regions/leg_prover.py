"""Boxes of poses of a platform on six legs around a pose, proved by the bounds of its legs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.poses.regions.cover import Tried
from gcrules.poses.regions.leg_bounds import are_regular
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.margin import jacobian
from gcrules.screws.pose_text import SHIFTS, VECTOR
from gcrules.screws.study import quaternion_product

__all__ = ["NAMES", "LegProver"]

NAMES = (*SHIFTS, *VECTOR)
"""The coordinates: a shift, and a rotation vector by which the platform is turned further."""

_BLOCK = 4096


@dataclass(frozen=True, eq=False)
class LegProver:
    """A `Prover`: the state of a pose is its translation and its unit quaternion; those of the `start` are given."""

    rig: MovingPlatform
    names: tuple[str, ...]
    weights: Floats
    start: Floats

    def tried(self, middles: Floats, halves: Floats, known: Floats, at: Floats) -> Tried:
        parts = [self._tried(middles[k : k + _BLOCK], halves[k : k + _BLOCK]) for k in range(0, len(middles), _BLOCK)]
        found = zip(*((t.proved, t.states, t.reach, t.margins) for t in parts), strict=True)
        return Tried(*(np.concatenate(p) for p in found))

    def led(self, known: Floats, at: Floats, to: Floats) -> Floats:
        return self._states(to * self.weights)

    def _tried(self, middles: Floats, halves: Floats) -> Tried:
        states = self._states(middles * self.weights)
        turns = matrices(states[:, 3:])
        ends = np.asarray(self.rig.ends(states[:, :3], turns))
        margins = np.zeros(len(states))
        there = np.linalg.norm(ends - self.rig.base, axis=2).min(axis=1) > ROUNDING * self.rig.size
        if there.any():
            j = jacobian(self.rig.base, ends[there])
            margins[there] = j.sigma * np.sign(np.linalg.det(j.rows))
        proved = np.zeros(len(states), dtype=bool)
        far = halves * self.weights
        for size in np.unique(far, axis=0):  # boxes of one size are proved at once
            k = np.flatnonzero((far == size).all(axis=1) & there)
            if len(k):
                proved[k] = are_regular(self.rig, ends[k], turns[k], *self._reach(size, len(k)))
        return Tried(proved, states, np.full(states.shape, np.inf), margins)

    def _states(self, displaced: Floats) -> Floats:
        whole = np.zeros((len(displaced), len(NAMES)))
        whole[:, [NAMES.index(n) for n in self.names]] = displaced
        turn = from_vectors(whole[:, 3:])
        turned = np.stack(quaternion_product(tuple(turn.T), tuple(self.start[3:])), axis=1)
        return np.concatenate([self.start[:3] + whole[:, :3], turned], axis=1)

    def _reach(self, far: Floats, number: int) -> tuple[list[tuple[Floats, float]], list[Floats], float]:
        """By how much a box of this size shifts and turns; for `are_regular`."""
        axes = np.eye(3)
        sizes = dict(zip(self.names, far.tolist(), strict=True))
        shifts = [(axes[k], sizes[n]) for k, n in enumerate(SHIFTS) if sizes.get(n)]
        turning = [k for k, n in enumerate(VECTOR) if n in sizes]
        turns = self._axes(turning)
        turn = float(np.linalg.norm([sizes[VECTOR[k]] for k in turning])) if turning else 0.0
        return shifts, [np.broadcast_to(a, (number, 3)) for a in turns], turn

    @staticmethod
    def _axes(turning: Sequence[int]) -> list[Floats]:
        """One angle alone turns about its axis; vectors of two or three add up to turns about any."""
        return [np.eye(3)[turning[0]]] if len(turning) == 1 else list(np.eye(3)) if turning else []
