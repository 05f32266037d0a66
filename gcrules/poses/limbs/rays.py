r"""Straight ways from a configuration in many directions at once, up to where the determinant changes its sign.

A direction is a unit vector in the wanted coordinates, lengths divided by the robot's size. All ways go on side by
side, each by steps of its own, which halve where the loops do not close or the frames of the wrenches turn too far.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import Frames, frames, relative_sign
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course, close_loops
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import stays_still
from gcrules.mechanisms.kinematics.targets import Target

__all__ = ["ZERO", "Bundle", "Ends"]

Truths = NDArray[np.bool_]

ZERO = 1e-4
"""Of a margin: a sign of the determinant that changes where it is greater was lost, by a step to another branch."""

_STEP = 0.2  # in parts of the robot's size, or rad
_SHORTEST = 1e-4
_LOCATED = 1e-10
_ROUNDS = 60
_MOST = 400  # steps
_GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, eq=False)
class Ends:
    """Where ways end, (N,): at the `distance` at which the determinant is 0, infinite where it was not seen to change
    its sign; each was `followed` so far. `before` are the configurations short of it.
    """

    distance: Floats
    followed: Floats
    before: Configurations


class Bundle:
    """Ways from the home of a linkage; `names` are the coordinates that change."""

    def __init__(self, m: Linkage, names: tuple[str, ...]) -> None:
        self.m, self.names = m, names
        self.course = Course(m, Target(names, np.zeros(len(names))))
        self.weights = self.course.weights

    def frames(self, here: Configurations) -> Frames:
        return frames(self.m, here, self.m.centre)

    def moved(self, here: Configurations, goal: Floats) -> tuple[Configurations, Truths]:
        """Configurations near these ones at other places (N, names), and where there are such."""
        joints = close_loops(self.course, here, goal * self.weights)
        return here.after(joints.amounts, joints.links), joints.closed & stays_still(self.m, joints.amounts)

    def ends(self, directions: Floats, reach: float, *, nearest: bool = False) -> Ends:
        """Of ways in these directions (N, names), up to `reach`; those of no interest when only the `nearest` counts
        are left where they are.
        """
        number = len(directions)
        here = Configurations.of([self.m.home] * number)
        at, step = np.zeros(number), np.full(number, _STEP)
        end, active = np.full(number, np.inf), np.arange(number)
        signs = self.frames(here)
        active = active[signs.signed]
        for _ in range(_MOST):
            if not len(active):
                break
            checkpoint()
            far = np.minimum(at[active] + step[active], reach)
            there, good = self.moved(here[active], far[:, None] * directions[active])
            sign = np.zeros(len(active), dtype=np.int8)
            new = self.frames(there[good])
            sign[good] = relative_sign(signs[active[good]], new)
            on, crossed = sign > 0, sign < 0
            if crossed.any():
                k = active[crossed]
                found = self._located(here[k], signs[k], directions[k], at[k], far[crossed])
                end[k] = np.where(np.isnan(found), np.inf, found)
                sign[crossed] = np.where(np.isnan(found), 0, sign[crossed])
                crossed = sign < 0
            moved = active[on]
            here = here.replaced(moved, there[on])
            signs = signs.replaced(moved, new[on[good]])
            at[moved] = far[on]
            step[moved] = np.minimum(1.5 * step[moved], _STEP)
            step[active[sign == 0]] /= 2
            left = ~crossed & (step[active] >= _SHORTEST) & (at[active] < min(reach, end.min() if nearest else reach))
            active = active[left]
        return Ends(end, at, here)

    def _located(self, here: Configurations, signs: Frames, directions: Floats, low: Floats, high: Floats) -> Floats:
        """Where the determinant is 0, within rounding, between two places of each way: the Illinois variant of the rule
        of false position, after one halving. Steps from the near side are shorter where the loops do not close after
        them, which they may not just before a zero of the constraints. Not a number where there is none: a long step
        had led to another branch.
        """
        low, high, step = low.copy(), high.copy(), high - low
        zero = np.zeros(len(low), dtype=bool)
        value_low, value_high = np.abs(signs.determinant), np.full(len(low), np.nan)
        last = np.zeros(len(low), dtype=bool)
        for _ in range(_ROUNDS):
            checkpoint()
            part = np.where(np.isnan(value_high), 0.5, value_low / (value_low + value_high))
            middle = low + np.minimum(part * (high - low), step)
            there, good = self.moved(here, middle[:, None] * directions)
            new = self.frames(there)
            size, sign = np.abs(new.determinant), np.where(good, relative_sign(signs, new), 0)
            there_zero = good & ~new.signed & ~np.isnan(size)
            before, after = (sign > 0) & ~zero, (sign < 0) & ~zero
            on = before | after | there_zero
            again = on & (before == last)  # the same end stays: count it less
            value_high = np.where(before, np.where(again, value_high / 2, value_high), np.where(on, size, value_high))
            value_low = np.where(before, size, np.where(again, value_low / 2, value_low))
            last = np.where(on, before, last)
            moved = np.where(before, middle - low, np.where(on, high - middle, step))
            step = np.where(before, 2 * step, np.where(on, step, (middle - low) / 2))
            low, high = np.where(before | there_zero, middle, low), np.where(after | there_zero, middle, high)
            zero |= there_zero
            at = np.flatnonzero(before)
            here, signs = here.replaced(at, there[at]), signs.replaced(at, new[at])
            if (zero | (high - low <= _LOCATED) | (moved <= _LOCATED) | (step <= _LOCATED)).all():
                break
        nearest = np.where(value_high < value_low, high, low)
        there, good = self.moved(here, nearest[:, None] * directions)
        sigma = np.where(good, margins(self.m, there).sigma, margins(self.m, here).sigma)
        return np.where(zero | (sigma <= ZERO), nearest, np.nan)

    def least(self, here: Configurations, directions: Floats, low: Floats, high: Floats) -> Floats:
        """Where the margin is least between two places of each way, by golden section from configurations near by."""

        def sigma(at: Floats) -> Floats:
            there, good = self.moved(here, at[:, None] * directions)
            return np.where(good, margins(self.m, there).sigma, np.inf)

        a, b = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        at_a, at_b = sigma(a), sigma(b)
        while (high - low > _LOCATED).any():
            checkpoint()
            left = at_a < at_b
            low, high = np.where(left, low, a), np.where(left, b, high)
            new = np.where(left, high - _GOLDEN * (high - low), low + _GOLDEN * (high - low))
            at_new = sigma(new)
            a, b = np.where(left, new, b), np.where(left, a, new)
            at_a, at_b = np.where(left, at_new, at_b), np.where(left, at_a, at_new)
        return (low + high) / 2
