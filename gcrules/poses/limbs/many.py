r"""A robot of joints at very many poses: each is led straight from home, in stacks, and what is asked for is computed.

The loops are closed step by step by Newton's method (`straight`), a step that fails being halved. So a pose has the
configuration to which the straight way from home leads, as for `gc.pose`; that no step changed to another branch is
proved where that is asked for. Each configuration is checked as `sound` checks it; where there is none, the numbers are
not numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.conditions.factor_causes import ASIDE
from gcrules.mechanisms.kinematics.actuations import amplified
from gcrules.mechanisms.kinematics.amplification import Amplifications
from gcrules.mechanisms.kinematics.attachments import Values, moved
from gcrules.mechanisms.kinematics.branch import Steps, follow_branch
from gcrules.mechanisms.kinematics.chains import chain_of
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.determinants import frames, relative_sign
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import Course, Joints
from gcrules.mechanisms.kinematics.margin import limb_margins, margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import sound, stays_still
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import factor_values
from gcrules.poses.limbs.lattice import blocks
from gcrules.poses.limbs.straight import led, number_of_steps
from gcrules.screws.pose_text import COORDINATES

__all__ = ["NUMBERS", "WAYS", "Solved", "numbers_at", "proved_at"]

Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_HALVINGS = 10  # of a step that fails: down to a thousandth of it
_FEW = 2


@dataclass(frozen=True, eq=False)
class Solved:
    """N configurations of a robot: how the `links` of each limb went from home, (N, K + 1, 4, 4), and by what `amounts`
    of its coordinates, (N, n).
    """

    m: Limbs
    amounts: tuple[Floats, ...]
    links: tuple[Floats, ...]
    known: Configurations | None = None

    @classmethod
    def at(cls, m: Limbs, c: Configuration) -> Solved:
        """A single configuration that is known."""
        return cls(m, tuple(a[None] for a in c.joint_values), tuple(k[None] for k in c.links), Configurations.of([c]))

    @classmethod
    def of(cls, m: Limbs, amounts: Floats) -> Solved:
        """Those of amounts (N, all) of all joints from home."""
        chains = m.linkage.home.chains
        parts = np.split(amounts, np.cumsum([len(c.turns) for c in chains])[:-1], axis=1)
        return cls(m, tuple(parts), tuple(c.links(a) for c, a in zip(chains, parts, strict=True)))

    def __len__(self) -> int:
        return len(self.amounts[0])

    def __getitem__(self, chosen: Any) -> Solved:
        return Solved(self.m, tuple(a[chosen] for a in self.amounts), tuple(k[chosen] for k in self.links))

    @cached_property
    def here(self) -> Configurations:
        """They themselves, with the screws that the names make."""
        if self.known is not None:
            return self.known
        chains = []
        for limb in self.m.linkage.robot.limbs:
            own = chain_of(limb, self.values)
            chains.append(replace(own, screws=np.broadcast_to(own.screws, (len(self), *own.screws.shape[-2:]))))
        return Configurations(tuple(chains), self.amounts, self.links[0][:, -1])

    @cached_property
    def values(self) -> Values:
        """The places of all names, (N, 3) each."""
        k = self.m.linkage
        return moved(k.robot, k.attachments, k.home.values, self.links)

    @property
    def sound(self) -> Truths:
        """Which of them are configurations of the family, (N,)."""
        k = self.m.linkage
        if not len(self):
            return np.zeros(0, dtype=bool)
        try:
            sound(k, k.home.values, k.home.chains, self.links, self.amounts)
        except NotClosed:
            if len(self) <= 1:
                return np.zeros(len(self), dtype=bool)
            half = len(self) // 2
            return np.concatenate([self[:half].sound, self[half:].sound])
        return np.ones(len(self), dtype=bool)

    @property
    def factors(self) -> Floats:
        """The values of the factors whose zeros are singularities, (N, factors)."""
        live = [part.kind not in ASIDE for part in self.m.analysis.parts]
        found = factor_values(self.m.analysis, self.values)
        return found[:, live] if found.shape[1] else found

    @property
    def actuators(self) -> Floats:
        """The amounts of the actuators from home, (N, actuators)."""
        return np.stack([self.amounts[a.place][:, a.coordinate] for a in self.m.linkage.actuators], axis=1)

    @cached_property
    def amplifications(self) -> Amplifications:
        """What the actuators make of their rates."""
        return amplified(self.m.linkage, self.here)

    @property
    def coordinates(self) -> Floats:
        """All coordinates of the pose, (N, coordinates)."""
        return coordinates(COORDINATES, self.here.platform, self.m.linkage.centre)


NUMBERS: Mapping[str, Callable[[Solved], Floats]] = MappingProxyType(
    {
        "factors": lambda s: s.factors,
        "margins": lambda s: margins(s.m.linkage, s.here).sigma,
        "limb_margins": lambda s: limb_margins(s.m.linkage, s.here),
        "actuators": lambda s: s.actuators,
        "coordinates": lambda s: s.coordinates,
        "motions": lambda s: s.here.platform,
        "isotropy": lambda s: s.amplifications.isotropy,
        "speeds": lambda s: s.amplifications.speeds,
        "turns": lambda s: s.amplifications.turns,
    }
)
"""What configurations have, each (N, …)."""

WAYS = ("signs", "proved")
"""What is known of the ways from home to them, each (N,)."""


def numbers_at(m: Limbs, target: Target, wanted: Floats, asked: Collection[str]) -> dict[str, NDArray[Any]]:
    """What is `asked` for, of `NUMBERS` and of `WAYS`, where the names of the target have the values `wanted`
    (N, names), from home. Where there is no configuration numbers are not numbers, the sign is 0 and the proof False.
    """
    course = Course(m.linkage, target)
    home = Solved.of(m, np.zeros((1, sum(len(c.turns) for c in m.linkage.home.chains))))
    kinds = {"signs": np.zeros(1, dtype=np.int8), "proved": np.zeros(1, dtype=bool)}
    kinds |= {n: np.full_like(NUMBERS[n](home), np.nan) for n in asked if n in NUMBERS}
    found = {n: np.repeat(kinds[n], len(wanted), axis=0) for n in asked}
    for some in blocks(len(wanted)):
        checkpoint()
        report(f"{some.start:,} of {len(wanted):,} poses")
        ways = _Ways(m, course, wanted[some])
        reached, there = ways.ends(prove="proved" in asked, sign="signs" in asked)
        own = {"signs": ways.signs[reached], "proved": ways.proved[reached]}
        for n in asked if len(reached) else ():
            found[n][some][reached] = NUMBERS[n](there) if n in NUMBERS else own[n]
    return found


def proved_at(m: Limbs, target: Target, wanted: Floats) -> tuple[Places, Solved]:
    """Which of the wanted values (N, names) are proved with few steps to be reached on home's branch, and the
    configurations there.
    """
    return _Ways(m, Course(m.linkage, target), wanted).proved_ends()


class _Ways:
    """Ways from home straight to wanted values (N, names), and what is found on them."""

    def __init__(self, m: Limbs, course: Course, wanted: Floats) -> None:
        self.m, self.course, self.wanted = m, course, wanted
        self.home = Configurations.of([m.linkage.home])
        self.proved = np.zeros(len(wanted), dtype=bool)
        self.signs = np.zeros(len(wanted), dtype=np.int8)

    def ends(self, *, prove: bool, sign: bool) -> tuple[Places, Solved]:
        """Which are reached, and the configurations at the ends of these."""
        steps = number_of_steps(self.course, self.wanted)
        amounts = np.zeros((len(self.wanted), sum(len(c.turns) for c in self.m.linkage.home.chains)))
        if prove:
            amounts, self.proved = self._led(amounts, steps, prove=True, sign=sign)
            steps = np.where(self.proved, 0, steps)
            amounts[~self.proved] = 0.0
        more, good = self._led(amounts, steps, prove=False, sign=sign)
        return self._sound(more, good | self.proved)

    def proved_ends(self) -> tuple[Places, Solved]:
        """Those that are proved with few steps."""
        amounts = np.zeros((len(self.wanted), sum(len(c.turns) for c in self.m.linkage.home.chains)))
        steps = number_of_steps(self.course, self.wanted)
        return self._sound(*self._led(amounts, steps, prove=True, sign=False, halvings=_FEW))

    def _sound(self, amounts: Floats, reached: Truths) -> tuple[Places, Solved]:
        places = np.flatnonzero(reached)
        there = Solved.of(self.m, amounts[places])
        kept = there.sound
        return (places, there) if kept.all() else (places[kept], there[kept])

    def _led(
        self, amounts: Floats, steps: Floats, *, prove: bool, sign: bool, halvings: int = _HALVINGS
    ) -> tuple[Floats, Truths]:
        k, target = self.m.linkage, self.course.target
        on = steps > 0
        every = frames(k, self.home, k.centre)[np.zeros(len(steps), dtype=int)] if sign else None
        self.signs[on] = every.signed[on] if every is not None else 0

        def accept(now: Configurations, joints: Joints, on: Places, grown: Floats) -> Truths:
            nonlocal every
            good = joints.closed & stays_still(k, joints.amounts)
            if prove and good.any():
                good[good] = follow_branch(k, target, Steps.of(now, joints, grown)[good])
            if every is not None and good.any():
                ahead, links = on[good], [part[good] for part in joints.links]
                there = frames(k, now[good].after([a[good] for a in joints.amounts], links), k.centre)
                self.signs[ahead] *= relative_sign(every[ahead], there)
                every = every.replaced(ahead, there)
            return good

        def goals(on: Places, part: Any) -> Floats:
            return np.asarray(part * self.wanted[on])

        return led(self.course, self.home, amounts, goals, self.wanted, steps, accept, halvings)
