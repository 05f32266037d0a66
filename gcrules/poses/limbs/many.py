r"""A robot of joints at very many poses: each is led straight from home, in stacks, and what is asked for is computed.

The loops are closed step by step by Newton's method (`straight`), a step that fails being halved. So a pose has the
configuration to which the straight way from home leads, as for `gc.pose`; that no step changed to another branch is
proved where that is asked for. Each configuration is checked as `sound` checks it; where there is none, the numbers are
not numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.kinematics.branch import Steps, follow_branch
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.determinants import frames, relative_sign
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.loops import Course, Joints
from gcrules.mechanisms.kinematics.margin import limb_margins, margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import sound, stays_still
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import factor_values, factors
from gcrules.poses.limbs.straight import after, led, number_of_steps
from gcrules.poses.limbs.sweep import blocks
from gcrules.screws.pose_text import COORDINATES

__all__ = ["NUMBERS", "Solved", "numbers_at", "solved"]

Truths = NDArray[np.bool_]
Values = Mapping[str, Floats]

_HALVINGS = 10  # of a step that fails: down to a thousandth of it


class Solved:
    """N configurations of a robot: `amounts` (N, all) of all joints from home, and the places of all names, (N, 3)."""

    def __init__(self, m: Limbs, amounts: Floats, values: Values) -> None:
        self.m, self.amounts, self.values = m, amounts, values

    @cached_property
    def here(self) -> Configurations:
        """They themselves, with screws that are carried along."""
        return after(Configurations.of([self.m.linkage.home]), self.amounts)

    @property
    def factors(self) -> Floats:
        """The values of the factors whose zeros are singularities, (N, factors)."""
        live = [f.live for f in factors(self.m.analysis, self.m.linkage.home.values)]
        return factor_values(self.m.analysis, self.values)[:, live]

    @property
    def actuators(self) -> Floats:
        """The amounts of the actuators from home, (N, actuators)."""
        every = self.here.joint_values
        return np.stack([every[a.place][:, a.coordinate] for a in self.m.linkage.actuators], axis=1)

    @property
    def coordinates(self) -> Floats:
        """All coordinates of the pose, (N, 9)."""
        return coordinates(COORDINATES, self.here.platform, self.m.linkage.centre)


NUMBERS: Mapping[str, Callable[[Solved], Floats]] = MappingProxyType(
    {
        "factors": lambda s: s.factors,
        "margins": lambda s: margins(s.m.linkage, s.here).sigma,
        "limb_margins": lambda s: limb_margins(s.m.linkage, s.here),
        "actuators": lambda s: s.actuators,
        "coordinates": lambda s: s.coordinates,
    }
)
"""What configurations have, each (N, …). Beside it "signs" and "proved" tell of the ways that lead to them."""


def numbers_at(m: Limbs, target: Target, wanted: Floats, asked: Collection[str]) -> dict[str, NDArray[np.generic]]:
    """What is `asked` for, of `NUMBERS` and of the ways ("signs", "proved"), where the values of the target's names are
    `wanted` (N, names), from home. Not a number where there is no configuration; a sign is 0 there, and a proof False.
    """
    found: dict[str, NDArray[np.generic]] = {}
    for some in blocks(len(wanted)):
        checkpoint()
        report(f"{some.start:,} of {len(wanted):,} poses")
        way = solved(m, target, wanted[some], signs="signs" in asked, prove="proved" in asked)
        good = np.flatnonzero(way.reached)
        own = Solved(m, way.amounts[good], way.values)
        part = {"signs": way.signs, "proved": way.proved} | {n: _spread(NUMBERS[n](own), way.reached) for n in NUMBERS if n in asked}
        for name in asked:
            whole = found.setdefault(name, np.empty((len(wanted), *part[name].shape[1:]), part[name].dtype))
            whole[some] = part[name]
    return found
