r"""Configurations of a robot of joints as states: coordinates of its platform, and the amounts of all joints from home.

Straight ways are those along which the coordinates grow evenly; the loops are closed step by step. The sign of a
determinant of the undriven joints' screws, or of the condition's factors, tells that nothing singular was stepped over.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates, wrapped
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import Course, Joints
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import stays_still
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.lattice import blocks
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.straight import led, number_of_steps
from gcrules.poses.plans.region import Region, Truths
from gcrules.poses.plans.space import Ways
from gcrules.poses.signs.of_limbs import one_sign
from gcrules.screws.pose_text import ANGLES

__all__ = ["LimbSpace"]

_ALIKE = 1e-6  # of amounts, in rad and sizes: configurations that are the same
_HALVINGS = 3
_MOST_HALVINGS = 10
_FINER = 2  # samples for each step that the loops need

Places = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class LimbSpace:
    """Configurations with a `margin` at least, whose actuators keep to `limits`, in a `region` of coordinates."""

    m: Limbs
    names: tuple[str, ...]
    region: Region
    margin: float
    limits: LengthLimits | None = None
    _home: Configurations = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_home", Configurations.of([self.m.linkage.home]))

    @cached_property
    def course(self) -> Course:
        """The equations of the coordinates."""
        return Course(self.m.linkage, Target(self.names, np.zeros(len(self.names))))

    @property
    def weights(self) -> Floats:
        return self.course.weights

    @cached_property
    def joints(self) -> int:
        """How many amounts of joints a state has."""
        return sum(len(c.turns) for c in self.m.linkage.home.chains)

    def from_home(self, places: Floats) -> tuple[Floats, Truths]:
        """The states (N, width) to which the straight ways from home lead at coordinates (N, names), and which do."""
        steps = _FINER * number_of_steps(self.course, places)
        zero = np.zeros((len(places), self.joints))
        amounts, good = led(
            self.course, self._home, zero, lambda on, part: part * places[on], places, steps, halvings=_MOST_HALVINGS
        )
        return np.concatenate([places, amounts], axis=1), good

    def row_of(self, c: Configuration) -> Floats:
        """The state of a configuration to which a way from home led. Raises InputError where the straight way of the
        coordinates leads to another one.

        Its own amounts of joints with several freedoms depend on the way, as their screws are made anew on it; those of
        a state do not.
        """
        m = self.m.linkage
        row, good = self.from_home(coordinates(self.names, c.platform[None], m.centre))
        there, close = self.at(row), _ALIKE * max(m.size, 1.0)
        near = np.allclose(there.here.platform[0], c.platform, rtol=0.0, atol=close)
        driven = [c.joint_values[a.place][a.coordinate] for a in m.actuators]
        if not (good[0] and near and np.allclose(there.actuators[0], driven, rtol=0.0, atol=close)):
            raise InputError(
                "the straight way of the coordinates from home leads to a configuration other than that of the pose",
                hint="choose start and goal nearer to home, or another --mode",
            )
        return np.asarray(row[0])

    def at(self, states: Floats) -> Solved:
        """The configurations of states, with the screws that the names make there."""
        return Solved.of(self.m, states[:, len(self.names) :])

    @property
    def freedoms(self) -> int:
        return len(self.names)

    def moved(self, states: Floats, displacements: Floats) -> Floats:
        found = states.copy()
        found[:, : len(self.names)] += displacements * self.weights
        return found

    def coordinates(self, states: Floats) -> Floats:
        return np.asarray(states[:, : len(self.names)])

    def reach(self, states: Floats) -> Floats:
        return self.at(states).actuators

    def good(self, states: Floats) -> Truths:
        return self._looked_at(states)[0]

    def margins(self, states: Floats) -> Floats:
        return np.abs(self._looked_at(states)[1])

    def apart(self, states: Floats, others: Floats) -> Floats:
        n = len(self.names)
        change = wrapped(self.names, states[:, None, :n] - others[None, :, :n]) / self.weights
        return np.asarray(np.linalg.norm(change, axis=2))

    def lengths(self, states: Floats, others: Floats) -> Floats:
        n = len(self.names)
        return np.asarray(np.linalg.norm(wrapped(self.names, states[:, :n] - others[:, :n]) / self.weights, axis=1))

    def alike(self, states: Floats, others: Floats) -> Truths:
        """By the platform and the places of all names: amounts of joints with three freedoms are not unique."""
        here, there = self.at(states), self.at(others)
        sorts, size = self.m.linkage.robot.family.sorts, self.m.linkage.size
        units = np.where(np.arange(4) < 3, 1.0, size)
        apart = (np.abs(here.here.platform - there.here.platform) / units).max(axis=(1, 2))
        for name, place in here.values.items():
            unit = size if sorts[name] == "point" else max(float(np.linalg.norm(place, axis=-1).max()), 1e-300)
            apart = np.maximum(apart, np.abs(place - there.values[name]).max(axis=-1) / unit)
        return np.asarray(apart <= _ALIKE)

    def drawn(self, random: Any, number: int, ends: Floats, spread: float) -> Floats:
        n, half = len(self.names), number // 2
        values = self.region.drawn(random, number)
        part = random.uniform(size=(half, 1))
        along = ends[0, :n] + part * wrapped(self.names, ends[-1, :n] - ends[0, :n])
        values[:half] = along + random.normal(size=(half, n)) * spread * self.weights
        values = values[self.region.holds(values)]
        return np.concatenate([values, np.zeros((len(values), ends.shape[1] - n))], axis=1)

    def between(self, states: Floats, others: Floats, parts: Floats) -> Floats:
        n, found = len(self.names), others.copy()
        change = wrapped(self.names, others[:, :n] - states[:, :n])
        found[:, :n] = states[:, :n] + parts[:, None] * change
        return found

    def gone(self, states: Floats, goals: Floats) -> Ways:
        parts = [self._gone(states[some], goals[some]) for some in blocks(len(states))]
        return Ways(*(np.concatenate(p) for p in zip(*((w.ends, w.parts) for w in parts), strict=True)))

    def _gone(self, states: Floats, goals: Floats) -> Ways:
        n, m = len(self.names), self.m.linkage
        begin = states[:, :n]
        grown = wrapped(self.names, goals[:, :n] - begin)
        good, start = self._looked_at(states)
        steps = np.where(good, _FINER * number_of_steps(self.course, grown), 0)
        reached = np.zeros(len(states))
        amounts = states[:, n:].copy()

        def accept(now: Configurations, joints: Joints, on: Places, step: Floats) -> Truths:
            fine = joints.closed & stays_still(m, joints.amounts)
            k = np.flatnonzero(fine)
            if not len(k):
                return fine
            some = on[k]
            far = reached[some] + _share(step[k], grown[some])
            there = amounts[some] + np.concatenate(joints.amounts, axis=1)[k]
            kept, signed = self._looked_at(np.concatenate([begin[some] + far[:, None] * grown[some], there], axis=1))
            kept &= signed * start[some] > 0
            fine[k[~kept]] = False
            ahead = some[kept]
            amounts[ahead], reached[ahead] = there[kept], far[kept]
            return fine

        _, whole = led(
            self.course,
            self._home,
            states[:, n:],
            lambda on, part: begin[on] + part * grown[on],
            grown,
            steps,
            accept,
            _HALVINGS,
        )
        ends = np.concatenate([begin + reached[:, None] * grown, amounts], axis=1)
        still = ~np.any(grown, axis=1) & good
        return Ways(ends, np.where(whole | still, 1.0, np.minimum(reached, 1 - 1e-9)))

    def waypoint(self, state: Floats, *, rounded: bool) -> Mapping[str, float]:
        """The coordinates of a state; rounded they can be written with few digits."""
        if not rounded:
            return FrozenMap(zip(self.names, state.tolist(), strict=False))
        unit = 10.0 ** (np.floor(np.log10(self.m.linkage.size)) - 3)
        found = {}
        for name, value in zip(self.names, state.tolist(), strict=False):
            angle = name in ANGLES
            found[name] = float(np.radians(round(np.degrees(value), 2))) if angle else float(round(value / unit) * unit)
        return FrozenMap(found)

    def _looked_at(self, states: Floats) -> tuple[Truths, Floats]:
        """Which states keep to all that is asked for, and margins with a sign that changes at singular ones only."""
        m, n = self.m.linkage, len(self.names)
        good, signed = np.zeros(len(states), dtype=bool), np.zeros(len(states))
        inside = np.flatnonzero(self.region.holds(states[:, :n]))
        for part in blocks(len(inside)):
            checkpoint()
            some = inside[part]
            there = self.at(states[some])
            sigma = margins(m, there.here).sigma
            sign = one_sign(self.m, there)
            signed[some] = sigma * np.where(sign == 0, 1.0, sign)
            good[some] = sigma >= self.margin
            if self.limits is not None:
                good[some] &= self.limits.allow(there.actuators)
        return good, signed


def _share(step: Floats, grown: Floats) -> Floats:
    """What part of all they grow by the wanted values grow in a step, (K,)."""
    most = np.argmax(np.abs(grown), axis=1)[:, None]
    whole = np.take_along_axis(grown, most, axis=1)[:, 0]
    return np.asarray(np.take_along_axis(step, most, axis=1)[:, 0] / np.where(whole == 0, 1.0, whole))
