r"""Mobility of the platform at a configuration, constraints that are there more than once, and the count of Grübler.

>>> from gcrules.screws.joints import joint
>>> from gcrules.screws.limbs import limb
>>> x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
>>> arm = limb(joint("P", direction=x, actuated=True), joint("P", direction=y))
>>> other = limb(joint("P", direction=y, actuated=True), joint("P", direction=x))
>>> found = mobility([arm, other])
>>> found.freedom, found.constraints.dimension, found.overconstraints, found.grubler, found.regular
(2, 4, 4, -2, True)
"""

from __future__ import annotations

from collections.abc import Iterable

from gcrules.core.dataclass import dataclass
from gcrules.screws.fields import Field
from gcrules.screws.jacobians import common_field
from gcrules.screws.limbs import Limb
from gcrules.screws.systems import ScrewSystem

__all__ = ["Mobility", "mobility"]


@dataclass(frozen=True)
class Mobility:
    """What the limbs leave to the platform, to first order, at one configuration.

    twists       what the platform can do: the intersection of the limbs' twist systems
    constraints  the span of all constraint wrenches, reciprocal to it
    locked       the span of all wrenches with the actuators locked
    free         what the platform can do with the actuators locked, reciprocal to `locked`
    freedoms     of the joints, for each limb
    ranks        of the limbs' twists
    actuators    their number

    grubler + overconstraints = freedom + idle, always.
    """

    twists: ScrewSystem
    constraints: ScrewSystem
    locked: ScrewSystem
    free: ScrewSystem
    freedoms: tuple[int, ...]
    ranks: tuple[int, ...]
    actuators: int

    @property
    def freedom(self) -> int:
        """Degrees of freedom of the platform: 6 − rank of all constraint wrenches."""
        return self.twists.dimension

    @property
    def overconstraints(self) -> int:
        """How many constraint wrenches more the limbs have than are independent."""
        return sum(6 - rank for rank in self.ranks) - self.constraints.dimension

    @property
    def idle(self) -> int:
        """Motions inside limbs that leave the platform at rest, such as the spin of a leg between two ball joints."""
        return sum(self.freedoms) - sum(self.ranks)

    @property
    def grubler(self) -> int:
        """The count of Grübler and Kutzbach for the whole mechanism: Σ freedoms − 6 (limbs − 1)."""
        return sum(self.freedoms) - 6 * (len(self.freedoms) - 1)

    @property
    def regular(self) -> bool:
        """Whether the platform is at rest when the actuators are: the rank of all wrenches is 6."""
        return self.locked.dimension == 6


def mobility(limbs: Iterable[Limb], field: Field | None = None) -> Mobility:
    """The mobility of a platform on these limbs. Raises InputError for no limbs, or many configurations at once."""
    chain = tuple(limbs)
    field = field or common_field(chain)
    systems = [one.system(field) for one in chain]
    locked = _sum(field, [one.locked_system(field) for one in chain])
    constraints = _sum(field, [one.reciprocal() for one in systems])
    return Mobility(
        twists=constraints.reciprocal(),
        constraints=constraints,
        locked=locked,
        free=locked.reciprocal(),
        freedoms=tuple(one.freedoms for one in chain),
        ranks=tuple(one.dimension for one in systems),
        actuators=sum(len(one.actuated) for one in chain),
    )


def _sum(field: Field, systems: Iterable[ScrewSystem]) -> ScrewSystem:
    return ScrewSystem.span([row for one in systems for row in one.basis], field)
