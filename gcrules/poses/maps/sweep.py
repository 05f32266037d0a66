r"""Whole layers of a grid of a robot of joints, solved from home's branch: configurations, margins, signs."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.actuations import amplified
from gcrules.mechanisms.kinematics.amplification import Index
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import Lattice, Nodes, blocks
from gcrules.poses.maps.patches import Patches

__all__ = ["Sweep"]


class Sweep:
    """The layers from `first` to before `stop` of the lattice of patches, as a lattice of its own.

    `amounts` (N, all) are those of all joints, not a number at nodes that are not `reached` (N,); `signs` (N,) those of
    the determinant of all wrenches, 0 where they are not known.
    """

    def __init__(self, patches: Patches, first: int, stop: int) -> None:
        whole = patches.lattice
        self.lattice: Lattice = whole.layers(first, stop)
        inner = self.lattice.size // (stop - first)
        number = self.lattice.size
        self.amounts = np.full((number, len(whole.units)), np.nan)
        self.signs: NDArray[np.int8] = np.zeros(number, dtype=np.int8)
        for some in blocks(number):
            checkpoint()
            nodes = first * inner + np.arange(some.start, some.stop)
            self.amounts[some], turned = patches.at(nodes)
            known = np.flatnonzero(turned)
            self.signs[some.start + known] = turned[known] * whole.frames(self.amounts[some][known]).sign
        self.reached = ~np.isnan(self.amounts[:, 0])

    @cached_property
    def sigma(self) -> Floats:
        """The margins at the nodes (N,), not a number where none is reached."""
        found = np.full(len(self.reached), np.nan)
        for nodes in self._kept():
            found[nodes] = margins(self.lattice.course.m, self.lattice.at(self.amounts[nodes])).sigma
        return found

    def index(self, index: Index) -> Floats:
        """An index of the actuators at the nodes (N,), not a number where none is reached."""
        found = np.full(len(self.reached), np.nan)
        for nodes in self._kept():
            found[nodes] = index.of(amplified(self.lattice.course.m, self.lattice.at(self.amounts[nodes])))
        return found

    def _kept(self) -> Iterator[Nodes]:
        kept = np.flatnonzero(self.reached)
        for some in blocks(len(kept)):
            checkpoint()
            yield kept[some]
