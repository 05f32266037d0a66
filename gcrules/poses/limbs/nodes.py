"""Configurations along a way, many at once, with all that is told of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import blocks

__all__ = ["Nodes"]


@dataclass(frozen=True, eq=False)
class Nodes:
    """N configurations at `parameters` (N,) of a way: `here`, the places of all names, (N, 3) each, and how all links
    went from home, (N, K + 1, 4, 4) for each limb. Screws are those that the names make, as in `Configuration`, and not
    carried along: amounts from one node to another are not the differences of the joint values.
    """

    parameters: Floats
    here: Configurations
    values: dict[str, Floats]
    links: tuple[Floats, ...]

    @classmethod
    def of(cls, parameters: Sequence[float] | Floats, several: Sequence[Configuration]) -> Nodes:
        """Those of configurations one by one."""
        names, limbs = several[0].values, range(len(several[0].links))
        return cls(
            np.array(parameters, dtype=float),
            Configurations.of(several),
            {n: np.stack([c.values[n] for c in several]) for n in names},
            tuple(np.stack([c.links[k] for c in several]) for k in limbs),
        )

    @classmethod
    def together(cls, parts: Sequence[Nodes]) -> Nodes:
        """Several stacks of one robot as one."""
        return cls(
            np.concatenate([p.parameters for p in parts]),
            Configurations.together([p.here for p in parts]),
            {n: np.concatenate([p.values[n] for p in parts]) for n in parts[0].values},
            tuple(np.concatenate(several) for several in zip(*(p.links for p in parts), strict=True)),
        )

    def __len__(self) -> int:
        return len(self.parameters)

    def __getitem__(self, chosen: Any) -> Nodes:
        """Those of an array of places, a slice or a mask."""
        values = {n: v[chosen] for n, v in self.values.items()}
        return Nodes(self.parameters[chosen], self.here[chosen], values, tuple(k[chosen] for k in self.links))

    def one(self, place: int) -> Configuration:
        """The configuration at a place."""
        here = self.here[[place]]
        return Configuration(
            {n: v[place] for n, v in self.values.items()},
            tuple(k[place] for k in self.links),
            tuple(a[0] for a in here.joint_values),
            tuple(replace(c, screws=c.screws[0]) for c in here.chains),
        )

    def blocks(self) -> Iterator[Nodes]:
        """As many at once as a cache is for."""
        for some in blocks(len(self)):
            checkpoint()
            yield self[some]
