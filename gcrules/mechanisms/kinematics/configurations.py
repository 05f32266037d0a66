"""Many configurations of one robot at once: what is needed to move on from them and to measure them, in stacks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Configurations"]


@dataclass(frozen=True, eq=False)
class Configurations:
    """N configurations: the limbs from here as `chains` with screws (N, K, 6), and from home the amounts of their
    coordinates (N, n) each and the `platform` (N, 4, 4).

    Screws are carried along with their links; the names that a file makes them from are not followed.
    """

    chains: tuple[Chain, ...]
    joint_values: tuple[Floats, ...]
    platform: Floats

    @classmethod
    def of(cls, several: Sequence[Configuration]) -> Configurations:
        """Configurations of one robot as a stack."""
        limbs = range(len(several[0].chains))
        chains = (replace(several[0].chains[k], screws=np.stack([c.chains[k].screws for c in several])) for k in limbs)
        amounts = (np.stack([c.joint_values[k] for c in several]) for k in limbs)
        return cls(tuple(chains), tuple(amounts), np.stack([c.platform for c in several]))

    def __len__(self) -> int:
        return len(self.platform)

    def __getitem__(self, chosen: Any) -> Configurations:
        """Those of an array of places, or a mask."""
        chains = (replace(c, screws=c.screws[chosen]) for c in self.chains)
        return Configurations(tuple(chains), tuple(a[chosen] for a in self.joint_values), self.platform[chosen])

    def after(self, amounts: Sequence[Floats], links: Sequence[Floats]) -> Configurations:
        """Those to which the coordinates grow by these amounts, the links moving like this."""
        return Configurations(
            tuple(c.after(k) for c, k in zip(self.chains, links, strict=True)),
            tuple(a + b for a, b in zip(self.joint_values, amounts, strict=True)),
            links[0][:, -1] @ self.platform,
        )

    def put(self, chosen: Any, others: Configurations) -> None:
        """Write others into these places."""
        for own, other in zip(self.chains, others.chains, strict=True):
            own.screws[chosen] = other.screws
        for a, b in zip(self.joint_values, others.joint_values, strict=True):
            a[chosen] = b
        self.platform[chosen] = others.platform

    @classmethod
    def empty(cls, like: Configurations, number: int) -> Configurations:
        """Places for so many configurations of the same robot, not a number yet."""

        def room(a: Floats) -> Floats:
            return np.full((number, *a.shape[1:]), np.nan)

        chains = (replace(c, screws=room(c.screws)) for c in like.chains)
        return cls(tuple(chains), tuple(room(a) for a in like.joint_values), room(like.platform))
