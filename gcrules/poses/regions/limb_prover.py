"""Boxes of coordinates or of actuators of a robot of joints, proved by Krawczyk's operator on its loops."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.loops import Course, units_of
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import stays_still
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.lattice import blocks
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.straight import after, led, number_of_steps
from gcrules.poses.regions.cover import Tried
from gcrules.poses.signs.of_limbs import one_sign

__all__ = ["LimbProver"]

_NEAR = 1e-9  # room for rounding in comparing configurations
_HALVINGS = 4


@dataclass(frozen=True, eq=False)
class LimbProver:
    """A `Prover`: the names of `target` have the values `centre` (n,) in the middle of all; a state is the amounts of
    all joints from home.
    """

    m: Limbs
    target: Target
    centre: Floats
    weights: Floats
    start: Floats

    @cached_property
    def course(self) -> Course:
        return Course(self.m.linkage, self.target)

    @cached_property
    def _home(self) -> Configurations:
        return Configurations.of([self.m.linkage.home])

    def tried(self, middles: Floats, halves: Floats, known: Floats, at: Floats) -> Tried:
        parts = [self._tried(middles[s], halves[s], known[s], at[s]) for s in blocks(len(middles))]
        found = zip(*((t.proved, t.states, t.reach, t.margins) for t in parts), strict=True)
        return Tried(*(np.concatenate(p) for p in found))

    def led(self, known: Floats, at: Floats, to: Floats) -> Floats:
        amounts, reached = self._led(known, at * self.weights, (to - at) * self.weights)
        return np.where(reached[:, None], amounts, np.nan)

    def _tried(self, middles: Floats, halves: Floats, known: Floats, at: Floats) -> Tried:
        m = self.m.linkage
        amounts, reached = self._led(known, at * self.weights, (middles - at) * self.weights)
        proved, signed = np.zeros(len(middles), dtype=bool), np.zeros(len(middles))
        reach = np.zeros(amounts.shape)
        some = np.flatnonzero(reached)
        if len(some):
            here = after(self._home, amounts[some])
            cells = Cells.around(m, self.target, here, halves[some] * self.weights)
            reach[some] = (np.concatenate(cells.reach, axis=1) + _NEAR) * units_of(m)
            proved[some] = cells.one_branch & cells.regular
            solved = Solved.of(self.m, amounts[some])
            sign = one_sign(self.m, solved)
            signed[some] = margins(m, solved.here).sigma * np.where(sign == 0, 1.0, sign)
        return Tried(proved, amounts, reach, signed)

    def _led(self, known: Floats, begin: Floats, change: Floats) -> tuple[Floats, np.ndarray]:
        still = ~np.any(change, axis=1)
        steps = np.where(still, 0.0, number_of_steps(self.course, change))
        found, good = led(
            self.course,
            self._home,
            known,
            lambda on, part: self.centre + begin[on] + part * change[on],
            change,
            steps,
            lambda _, joints, __, ___: joints.closed & stays_still(self.m.linkage, joints.amounts),
            _HALVINGS,
        )
        return found, good | still
