"""Many configurations of one robot at once: what is needed to move on from them and to measure them, in stacks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.chains import Chain, moved
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Configurations"]

Places = NDArray[np.intp]


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
        chains = (several[0].chains[k].placed(np.stack([c.chains[k].screws for c in several])) for k in limbs)
        amounts = (np.stack([c.joint_values[k] for c in several]) for k in limbs)
        return cls(tuple(chains), tuple(amounts), np.stack([c.platform for c in several]))

    def __len__(self) -> int:
        return len(self.platform)

    def __getitem__(self, chosen: Any) -> Configurations:
        """Those of an array of places, or a mask."""
        chains = (c.placed(c.screws[chosen]) for c in self.chains)
        return Configurations(tuple(chains), tuple(a[chosen] for a in self.joint_values), self.platform[chosen])

    def replaced(self, places: Places, others: Configurations) -> Configurations:
        """With others at some places."""
        order = np.arange(len(self))
        order[places] = len(self) + np.arange(len(others))
        return Configurations.together([self, others])[order]

    def moved(self, amounts: Sequence[Floats]) -> tuple[list[Floats], Configurations]:
        """How the links move where the coordinates grow by these amounts, and the configurations then."""
        links, chains = moved(self.chains, amounts)
        values = tuple(a + b for a, b in zip(self.joint_values, amounts, strict=True))
        return links, Configurations(tuple(chains), values, links[0][:, -1] @ self.platform)

    def after(self, amounts: Sequence[Floats], links: Sequence[Floats]) -> Configurations:
        """Those to which the coordinates grow by these amounts, the links moving like this."""
        return Configurations(
            tuple(c.after(k) for c, k in zip(self.chains, links, strict=True)),
            tuple(a + b for a, b in zip(self.joint_values, amounts, strict=True)),
            links[0][:, -1] @ self.platform,
        )

    @classmethod
    def together(cls, parts: Sequence[Configurations]) -> Configurations:
        """Several stacks of one robot as one."""
        limbs = range(len(parts[0].chains))
        chains = (parts[0].chains[k].placed(np.concatenate([p.chains[k].screws for p in parts])) for k in limbs)
        amounts = (np.concatenate([p.joint_values[k] for p in parts]) for k in limbs)
        return cls(tuple(chains), tuple(amounts), np.concatenate([p.platform for p in parts]))
