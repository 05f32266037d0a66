r"""What a plan is sought in: the states of a mechanism, and straight ways between them that keep a margin.

A state is a row of floats: what tells a pose, and for a robot of joints the amounts of all joints beside it. States
and ways are looked at in stacks, at samples; what is found so is proved afterwards.
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.region import Region, Truths

__all__ = ["Space", "Ways"]


@dataclass(frozen=True, eq=False)
class Ways:
    """What came of going straight from states to others, K times: the last good states `ends` (K, width), after which
    `parts` (K,) of the ways, 1 where the end is reached.
    """

    ends: Floats
    parts: Floats

    @property
    def whole(self) -> Truths:
        """Which of them reach their end."""
        return np.asarray(self.parts >= 1.0)


class Space(Protocol):
    """States that keep to a margin, to limits and to a region."""

    @property
    def region(self) -> Region: ...
    @property
    def limits(self) -> LengthLimits | None: ...

    @property
    def freedoms(self) -> int:
        """How many numbers tell a displacement."""

    def moved(self, states: Floats, displacements: Floats) -> Floats:
        """The poses (K, width) after displacements (K, freedoms) of states, in parts of the size and rad."""

    def coordinates(self, states: Floats) -> Floats:
        """Those of the region, (N, names)."""

    def reach(self, states: Floats) -> Floats:
        """What the limits are for, (N, names): lengths of legs, or amounts of actuators."""

    def good(self, states: Floats) -> Truths:
        """Which states (N, width) keep to all that is asked for."""

    def margins(self, states: Floats) -> Floats:
        """Their margins σ, (N,)."""

    def apart(self, states: Floats, others: Floats) -> Floats:
        """The distances (N, K) of the poses of states (N, width) and others (K, width), lengths in parts of the
        robot's size, angles in rad: how long straight ways are.
        """

    def lengths(self, states: Floats, others: Floats) -> Floats:
        """The same of pairs, (K,)."""

    def alike(self, states: Floats, others: Floats) -> Truths:
        """Which states (K, width) are the same as the others (K, width)."""

    def drawn(self, random: Any, number: int, ends: Floats, spread: float) -> Floats:
        """Poses of the region at random: of these half around the straight way between the first and the last of the
        states `ends` (M, width), with this spread; the joints of a robot are not yet known.
        """

    def gone(self, states: Floats, goals: Floats) -> Ways:
        """Straight ways from states (K, width) to the poses of the goals (K, width)."""

    def between(self, states: Floats, others: Floats, parts: Floats) -> Floats:
        """The poses (K, width) after parts (K,) of the straight ways from states to others."""
