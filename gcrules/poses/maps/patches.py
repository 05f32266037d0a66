"""Home's branch over a grid, in short: from which configuration each node is solved, so that parts do by themselves."""

from __future__ import annotations

from collections.abc import Mapping
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import HALVINGS, Lattice, Nodes, blocks

__all__ = ["Patches"]

_ARRAYS = ("owner", "places", "amounts", "reach", "turned")


@dataclass(frozen=True, eq=False)
class Patches:
    """P configurations that are proved to be connected with the first one, and around each either a block of nodes, in
    which the branch has one configuration nearer than `reach` (P, all) for all values of the coordinates, or itself as
    the one of a node.

    `owner` (N,) is the number of that from which a node is solved, −1 where none is reached; `places` (P, axes) and
    `amounts` (P, all) are those of the configurations. `turned` (P,) times the sign of their determinant is its sign,
    0 where it is not known.
    """

    lattice: Lattice
    owner: NDArray[np.int32]
    places: Floats
    amounts: Floats
    reach: Floats
    turned: NDArray[np.int8]

    def to_bytes(self) -> bytes:
        """All but the lattice."""
        data = BytesIO()
        np.savez(data, **{name: getattr(self, name) for name in _ARRAYS})
        return data.getvalue()

    @classmethod
    def of_bytes(cls, lattice: Lattice, data: bytes) -> Patches:
        """The same again. Raises KeyError and ValueError for others."""
        with np.load(BytesIO(data), allow_pickle=False) as found:
            arrays: Mapping[str, Any] = {name: found[name] for name in _ARRAYS}
        if arrays["owner"].shape != (lattice.size,) or arrays["amounts"].shape[1:] != lattice.units.shape:
            raise ValueError("patches of another grid")
        return cls(lattice, **arrays)

    def at(self, nodes: Nodes) -> tuple[Floats, NDArray[np.int8]]:
        """The amounts (K, all) at nodes, not a number where none is reached, and the signs (K,) by which those of the
        determinants of their frames are multiplied, 0 where they are not known.
        """
        amounts = self.amounts_at(nodes)
        return amounts, self._turned(amounts, self.owner[nodes], self.lattice.places(nodes))

    def amounts_at(self, nodes: Nodes) -> Floats:
        """The amounts (K, all) at nodes, not a number where none is reached."""
        owner, places = self.owner[nodes], self.lattice.places(nodes)
        found = np.where((owner >= 0)[:, None], self.amounts[owner], np.nan)
        far = np.flatnonzero((owner >= 0) & (places != self.places[owner]).any(axis=1))
        if not len(far):
            return found
        own = owner[far]
        ways = self.amounts[own], self.places[own], places[far]
        there = self.lattice.solved(*ways)
        lost = np.flatnonzero(~(np.abs(there - ways[0]) <= self.reach[own]).all(axis=1))
        if len(lost):
            there[lost] = self.lattice.solved(*(w[lost] for w in ways), halvings=HALVINGS)
        found[far] = there
        return found

    def _turned(self, amounts: Floats, owner: NDArray[np.int32], places: Floats) -> NDArray[np.int8]:
        found = np.where(owner >= 0, self.turned[owner], 0).astype(np.int8)
        far = np.flatnonzero((found != 0) & (places != self.places[owner]).any(axis=1) & ~np.isnan(amounts[:, 0]))
        if len(far):
            several, which = np.unique(owner[far], return_inverse=True)
            frames = self.lattice.frames(self.amounts[several])[which], self.lattice.frames(amounts[far])
            ends = self.places[owner[far]], places[far]
            found[far] *= self.lattice.turned(self.amounts[owner[far]], amounts[far], ends, frames)
        return found

    def signed(self, places: Floats) -> Floats:
        """Margins with the sign of the determinant at any places (K, axes), solved from what the nearest corner of the
        cell is solved from; not a number where none is reached.
        """
        lattice = self.lattice
        last = np.array(lattice.shape) - 1
        owner = np.full(len(places), -1, dtype=np.int32)
        corners = [np.rint(places)]
        corners += [np.floor(places) + c for c in np.ndindex(*(2,) * len(lattice.shape))]
        for corner in corners:
            own = self.owner[lattice.nodes(np.clip(corner, 0, last))]
            owner = np.where((owner < 0) & (own >= 0) & (self.turned[own] != 0), own, owner)
        found = np.full(len(places), np.nan)
        there = np.flatnonzero(owner >= 0)
        for some in blocks(len(there)):
            checkpoint()
            k = there[some]
            amounts = lattice.solved(self.amounts[owner[k]], self.places[owner[k]], places[k])
            good = ~np.isnan(amounts[:, 0])
            k, amounts = k[good], amounts[good]
            sign = self._turned(amounts, owner[k], places[k]) * lattice.frames(amounts).sign
            found[k] = margins(lattice.course.m, lattice.at(amounts)).sigma * sign
        return found
