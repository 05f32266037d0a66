r"""Poses of a platform on six legs as states: the translation, and the turn as a unit quaternion.

Straight ways are those of `paths.segment`: the centre moves on a straight line, the platform turns about one axis.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.arrays import from_vectors, matrices
from gcrules.poses.plans.region import Region, Truths
from gcrules.poses.plans.space import Ways
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import from_vector
from gcrules.screws.study import quaternion_product

__all__ = ["MOST_TURNED", "NAMES", "LegSpace", "region_of", "row_of"]

NAMES = ("x", "y", "z", "turn")
"""The coordinates of a region: a translation, and by how much the platform is turned from home, at most 180°."""

_STEP = 0.04  # rad, or sizes: the distance of samples
_BLOCK = 4096
MOST_TURNED = np.pi
"""No turn is by more."""

_HALF_TURN = 1e-9  # of the cosine of half the angle: a half turn has no shorter way


def region_of(rig: MovingPlatform) -> Region:
    """All translations by up to the robot's size, with all turns."""
    s = rig.size
    return Region(NAMES, (-s, -s, -s, 0.0), (s, s, s, MOST_TURNED), (False, False, False, True))


def row_of(pose: Pose) -> Floats:
    """The state of a pose."""
    return np.array([*map(float, pose.translation), *pose.unit_quaternion])


@dataclass(frozen=True, eq=False)
class LegSpace:
    """Poses with a `margin` at least, whose legs keep to `limits`, in a `region`."""

    rig: MovingPlatform
    region: Region
    margin: float
    limits: LengthLimits | None = None

    @property
    def freedoms(self) -> int:
        return 6

    def moved(self, states: Floats, displacements: Floats) -> Floats:
        turn = from_vectors(displacements[:, 3:])
        turned = np.stack(quaternion_product(tuple(turn.T), tuple(states[:, 3:].T)), axis=1)
        return np.concatenate([states[:, :3] + displacements[:, :3] * self.rig.size, turned], axis=1)

    def coordinates(self, states: Floats) -> Floats:
        """Those of the region, (N, 4)."""
        turn = 2 * np.arctan2(np.linalg.norm(states[:, 4:], axis=1), np.abs(states[:, 3]))
        return np.concatenate([states[:, :3], turn[:, None]], axis=1)

    def reach(self, states: Floats) -> Floats:
        return np.asarray(np.linalg.norm(self._ends(states) - self.rig.base, axis=2))

    def good(self, states: Floats) -> Truths:
        return self._looked_at(states)[0]

    def margins(self, states: Floats) -> Floats:
        return np.abs(self._looked_at(states)[1])

    def apart(self, states: Floats, others: Floats) -> Floats:
        shift = np.linalg.norm(states[:, None, :3] - others[None, :, :3], axis=2) / self.rig.size
        turn = 2 * np.arccos(np.minimum(np.abs(states[:, 3:] @ others[:, 3:].T), 1.0))
        return np.asarray(np.hypot(shift, turn))

    def lengths(self, states: Floats, others: Floats) -> Floats:
        shift = np.linalg.norm(states[:, :3] - others[:, :3], axis=1) / self.rig.size
        turn = 2 * np.arccos(np.minimum(np.abs((states[:, 3:] * others[:, 3:]).sum(axis=1)), 1.0))
        return np.asarray(np.hypot(shift, turn))

    def alike(self, states: Floats, others: Floats) -> Truths:
        return np.ones(len(states), dtype=bool)

    def drawn(self, random: Any, number: int, ends: Floats, spread: float) -> Floats:
        half = number // 2
        values = self.region.drawn(random, number)
        axes = random.normal(size=(number, 3))
        vectors = axes / np.linalg.norm(axes, axis=1, keepdims=True) * values[:, 3:]
        states = np.concatenate([values[:, :3], from_vectors(vectors)], axis=1)
        one, other = (np.repeat(r[None], half, axis=0) for r in (ends[0], ends[-1]))
        along = self.between(one, other, random.uniform(size=half))
        along[:, :3] += random.normal(size=(half, 3)) * spread * self.rig.size
        turn = from_vectors(random.normal(size=(half, 3)) * spread)
        along[:, 3:] = np.stack(quaternion_product(tuple(turn.T), tuple(along[:, 3:].T)), axis=1)
        found = np.concatenate([along, states[half:]])
        return np.asarray(found[self._looked_at(found)[0]])

    def between(self, states: Floats, others: Floats, parts: Floats) -> Floats:
        towards = others.copy()
        towards[(states[:, 3:] * others[:, 3:]).sum(axis=1) < 0, 3:] *= -1
        found = states + parts[:, None] * (towards - states)
        found[:, 3:] /= np.linalg.norm(found[:, 3:], axis=1, keepdims=True)
        return np.asarray(found)

    def gone(self, states: Floats, goals: Floats) -> Ways:
        length = self.lengths(states, goals)
        steps = np.maximum(np.ceil(length / _STEP), 1).astype(np.intp)
        way = np.repeat(np.arange(len(states)), steps + 1)
        first = np.cumsum([0, *(steps[:-1] + 1)])
        part = (np.arange(len(way)) - first[way]) / steps[way]
        samples = self.between(states[way], goals[way], part)
        good, signed = self._looked_at(samples)
        good &= signed * signed[first[way]] > 0
        good &= (np.abs((states[:, 3:] * goals[:, 3:]).sum(axis=1)) > _HALF_TURN)[way] | (part == 0)
        bad = np.where(good, len(way), np.arange(len(way)))
        stop = np.minimum.reduceat(bad, first)  # the first bad sample of each way
        whole = stop >= np.append(first[1:], len(way))
        last = np.maximum(np.where(whole, np.append(first[1:], len(way)), stop) - 1, first)
        ends = np.where(whole[:, None], goals, samples[last])
        return Ways(ends, np.where(whole, 1.0, part[last]))

    def waypoint(self, state: Floats, *, rounded: bool) -> Pose:
        """The pose of a state; rounded it can be written with few digits."""
        if not rounded:
            x, y, z, *q = map(Fraction, state.tolist())
            return Pose((x, y, z), (q[0], q[1], q[2], q[3]))
        unit = Fraction(10) ** (int(np.floor(np.log10(self.rig.size))) - 3)
        x, y, z = (round(Fraction(c) / unit) * unit for c in state[:3].tolist())
        w, *v = (state[3:] * (1.0 if state[3] >= 0 else -1.0)).tolist()
        size = float(np.linalg.norm(v))
        angle = 2 * np.arctan2(size, w)
        vector = [round(Fraction(np.degrees(angle) * c / size), 2) if size > 1e-9 else Fraction(0) for c in v]
        return Pose((x, y, z), from_vector(vector, degrees=True))

    def _ends(self, states: Floats) -> Floats:
        """Those of the legs on the platform, (N, 6, 3)."""
        found = np.einsum("nij,kj->nki", matrices(states[:, 3:]), self.rig.arms)
        return np.asarray(found + (self.rig.centre_of_turns + states[:, :3])[:, None, :])

    def _looked_at(self, states: Floats) -> tuple[Truths, Floats]:
        """Which states keep to all that is asked for, and margins with the sign of the superbracket."""
        good, signed = np.zeros(len(states), dtype=bool), np.zeros(len(states))
        inside = np.flatnonzero(self.region.holds(self.coordinates(states)))
        for k in range(0, len(inside), _BLOCK):
            checkpoint()
            some = inside[k : k + _BLOCK]
            ends = self._ends(states[some])
            lengths = np.linalg.norm(ends - self.rig.base, axis=2)
            kept = lengths.min(axis=1) > ROUNDING * self.rig.size
            if self.limits is not None:
                kept &= self.limits.allow(lengths)
            if not kept.any():
                continue
            some = some[kept]
            j = jacobian(self.rig.base, ends[kept])
            signed[some] = j.sigma * np.sign(np.linalg.det(j.rows))
            good[some] = j.sigma >= self.margin
        return good, signed
