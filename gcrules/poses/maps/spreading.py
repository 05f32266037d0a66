"""Home's branch of a robot of joints over a grid: in large blocks of nodes, then in smaller ones, then node by node.

Every step is proved: from the middle of a block, or from a node, one branch of solutions leads straight to the middle
of the next block, and in all of that there is one configuration near its middle; so each node of it has that one. What
no block holds is reached along the edges of the grid. So a node is reached where proved steps along edges lead to it
from what is reached, whatever holes are between; the steps are taken in a fixed order, and of several configurations
that a node may have on the branch, as around its ends, the first one counts.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import HALVINGS, Lattice, Nodes, Truths, blocks
from gcrules.poses.maps.patches import Patches

__all__ = ["NEAR", "spread"]

_SIZES = (8, 4, 2)
"""Cells along the side of a block."""
_FEW = 256
"""Nodes of a grid on which only the largest blocks are tried: smaller ones take as long as all nodes at once."""
_FROM_FIRST = 10
"""Halvings of the steps from the first node: few begin there, and home may be beside a singularity of a limb, where no
longer ones are proved.
"""
NEAR = 1e-9
"""Room for rounding in comparing configurations."""


def spread(lattice: Lattice, first: int) -> Patches:
    """The branch of the lattice's start, which is the configuration of the node `first`."""
    found = _Spreading(lattice, first)
    for size in _SIZES if lattice.size > _FEW else _SIZES[:1]:
        _Blocks(found, size).spread()
    found.spread_nodes()
    found.turn_the_rest()
    return found.patches()


class _Rows:
    """An array that grows along its first axis."""

    def __init__(self, width: tuple[int, ...], kind: type) -> None:
        self._held: NDArray[Any] = np.zeros((64, *width), dtype=kind)
        self.count = 0

    def add(self, rows: NDArray[Any]) -> None:
        while self.count + len(rows) > len(self._held):
            self._held = np.concatenate([self._held, np.zeros_like(self._held)])
        self._held[self.count : self.count + len(rows)] = rows
        self.count += len(rows)

    @property
    def all(self) -> NDArray[Any]:
        return self._held[: self.count]


class _Spreading:
    """What is reached so far."""

    def __init__(self, lattice: Lattice, first: int) -> None:
        axes, width = len(lattice.shape), lattice.units.shape
        self.lattice, self.first = lattice, first
        self.owner = np.full(lattice.size, -1, dtype=np.int32)
        self.rows = {
            "places": _Rows((axes,), np.float64),
            "amounts": _Rows(width, np.float64),
            "reach": _Rows(width, np.float64),
            "turned": _Rows((), np.int8),
        }
        self.signed = not lattice.course.m.robot.redundant
        start = np.zeros((1, *width))
        known = self.signed and bool(lattice.frames(start).whole[0])
        self.add(np.array([first]), lattice.places(np.array([first])), start, start, np.array([int(known)], np.int8))

    def add(self, nodes: Nodes, places: Floats, amounts: Floats, reach: Floats, turned: NDArray[np.int8]) -> Nodes:
        """Note configurations and the node that each one is of, or in whose block it is; their numbers."""
        numbers = self.rows["places"].count + np.arange(len(nodes))
        several: tuple[NDArray[Any], ...] = (places, amounts, reach, turned)
        for held, rows in zip(self.rows.values(), several, strict=True):
            held.add(rows)
        self.owner[nodes] = numbers
        return numbers

    def patches(self) -> Patches:
        """What is reached now; the sign of the node nearest to the first one that has one is 1."""
        arrays = {name: rows.all.copy() for name, rows in self.rows.items()}
        found = Patches(self.lattice, self.owner, **arrays)
        sign = self._sign(found) if self.signed else 0
        return Patches(self.lattice, self.owner, **{**arrays, "turned": arrays["turned"] * np.int8(sign)})

    def _sign(self, found: Patches) -> int:
        reached = np.flatnonzero(self.owner >= 0)
        far = np.abs(self.lattice.places(reached) - self.lattice.places(np.array([self.first]))).sum(axis=1)
        reached = reached[np.argsort(far, kind="stable")]
        for some in blocks(len(reached)):
            checkpoint()
            amounts, turned = found.at(reached[some])
            known = turned != 0
            signs = turned[known] * self.lattice.frames(amounts[known]).sign
            if signs.any():
                return int(signs[np.flatnonzero(signs)[0]])
        return 1

    # --- node by node

    def spread_nodes(self) -> None:
        lattice = self.lattice
        front = self._border()
        while len(front):
            checkpoint()
            report(f"{int((self.owner >= 0).sum()):,} of {lattice.size:,} poses")
            amounts, turned = self._now().at(front)
            order = np.argsort(front)
            pairs = list(lattice.neighbours(front))
            parents, children = (np.concatenate(several) for several in zip(*pairs, strict=True))
            found = [front[:0]]
            while len(children := children[new := self.owner[children] < 0]):
                parents = parents[new]
                _, once = np.unique(children, return_index=True)
                k = order[np.searchsorted(front, parents[once], sorter=order)]
                found.append(self._step(front[k], amounts[k], turned[k], children[once]))
                parents, children = np.delete(parents, once), np.delete(children, once)
            front = np.concatenate(found)

    def _step(self, parents: Nodes, amounts: Floats, turned: NDArray[np.int8], children: Nodes) -> Nodes:
        """Reach nodes from those beside them; which are reached."""
        lattice = self.lattice
        ends = lattice.places(parents), lattice.places(children)
        there = lattice.solved(amounts, *ends, halvings=HALVINGS)
        again = np.isnan(there[:, 0]) & (parents == self.first)
        there[again] = lattice.solved(amounts[again], *(e[again] for e in ends), halvings=_FROM_FIRST)
        good = ~np.isnan(there[:, 0])
        children, there, before, after = children[good], there[good], *(e[good] for e in ends)
        sign = self.turned(turned[good], amounts[good], there, (before, after))
        self.add(children, after, there, np.zeros_like(there), sign)
        return children

    def _border(self) -> Nodes:
        """The nodes that are reached and have a neighbour that is not."""
        beside = np.zeros(self.lattice.size, dtype=bool)
        for _, others in self.lattice.neighbours(np.flatnonzero(self.owner < 0)):
            beside[others] = True
        return np.flatnonzero(beside & (self.owner >= 0))

    def _now(self) -> Patches:
        return Patches(self.lattice, self.owner, **{name: rows.all for name, rows in self.rows.items()})

    def turned(
        self, turned: NDArray[np.int8], one: Floats, other: Floats, ends: tuple[Floats, Floats]
    ) -> NDArray[np.int8]:
        """What `turned` is at other configurations; the first one that has frames is given 1."""
        if not self.signed or not len(other):
            return np.zeros(len(other), dtype=np.int8)
        if not self.rows["turned"].all.any():
            found = np.zeros(len(other), dtype=np.int8)
            found[np.flatnonzero(self.lattice.frames(other).whole)[:1]] = 1
            return found
        return turned * self.lattice.turned(one, other, ends)

    def turn_the_rest(self) -> None:
        """Carry orientations over nodes that have none."""
        lattice, turned = self.lattice, self.rows["turned"].all
        own = np.flatnonzero(self.owner >= 0)
        own = own[turned[self.owner[own]] == 0] if self.signed else own[:0]
        left = own[lattice.frames(self._now().amounts_at(own)).whole] if len(own) else own
        while len(left):
            checkpoint()
            before = len(left)
            for step in (1, 2):
                for nodes, others in lattice.neighbours(left, step):
                    owners = self.owner[others]
                    known = (owners >= 0) & (turned[owners] != 0) & (turned[self.owner[nodes]] == 0)
                    nodes, others = nodes[known], others[known]
                    amounts, there = self._now().at(others)
                    ends = lattice.places(others), lattice.places(nodes)
                    here = self._now().amounts_at(nodes)
                    turned[self.owner[nodes]] = there * lattice.turned(amounts, here, ends)
            left = left[turned[self.owner[left]] == 0]
            if len(left) == before:
                return


class _Blocks:
    """Blocks of so many cells along each side, those that no larger block holds."""

    def __init__(self, spreading: _Spreading, size: int) -> None:
        self.spreading, self.lattice, self.size = spreading, spreading.lattice, size
        self.cells = np.array(self.lattice.shape) - 1
        self.shape = tuple((self.cells // size).tolist())
        self.axes = len(self.shape)
        self.waiting = self._free() if all(self.shape) else np.zeros(0, dtype=bool)

    def _free(self) -> Truths:
        """The blocks none of whose nodes is reached, but for the first one."""
        s, shape = self.spreading, self.lattice.shape
        taken = s.owner >= 0
        taken[s.first] = False
        inner = taken.reshape(shape)[tuple(slice(0, n * self.size) for n in self.shape)]
        inner = inner.reshape([k for n in self.shape for k in (n, self.size)])
        return np.asarray(~inner.any(axis=tuple(range(1, 2 * self.axes, 2)))).ravel()

    def spread(self) -> None:
        front = np.flatnonzero(self.waiting)
        while len(front):
            checkpoint()
            parents, children = self._ways(front)
            found = [front[:0]]
            while len(children := children[new := self.waiting[children]]):
                parents = parents[new]
                _, once = np.unique(children, return_index=True)
                found.append(self._try(children[once], parents[once]))
                parents, children = np.delete(parents, once), np.delete(children, once)
            front = self._beside(np.concatenate(found))

    def _ways(self, numbers: Nodes) -> tuple[Nodes, Nodes]:
        """The configurations from which blocks may be reached, and these blocks: the first node, if it is in a block,
        and those of the nodes behind its sides.
        """
        s, lattice, size = self.spreading, self.lattice, self.size
        low = self._low(numbers)
        first = lattice.places(np.array([s.first]))[0]
        holds = ((low <= first) & (first <= low + size)).all(axis=1)
        owners = [np.where(holds, s.owner[s.first], -1)]
        for axis, step in product(np.eye(self.axes, dtype=np.intp), (-size, size)):
            near = low + size // 2 + step * axis
            inside = ((near >= 0) & (near <= self.cells)).all(axis=1)
            owners.append(np.where(inside, s.owner[lattice.nodes(np.clip(near, 0, self.cells))], -1))
        owner, number = np.concatenate(owners), np.tile(numbers, len(owners))
        return owner[owner >= 0], number[owner >= 0]

    def _low(self, numbers: Nodes) -> NDArray[np.intp]:
        return np.stack(np.unravel_index(numbers, self.shape), axis=1) * self.size

    def _beside(self, numbers: Nodes) -> Nodes:
        """The blocks beside these that wait."""
        at = np.stack(np.unravel_index(np.unique(numbers), self.shape), axis=1)
        found = [numbers[:0]]
        for k, step in product(range(self.axes), (-1, 1)):
            moved = at.copy()
            moved[:, k] += step
            inside = (moved[:, k] >= 0) & (moved[:, k] < self.shape[k])
            found.append(np.ravel_multi_index(tuple(moved[inside].T), self.shape))
        beside = np.unique(np.concatenate(found))
        return np.asarray(beside[self.waiting[beside]])

    def _try(self, numbers: Nodes, owner: Nodes) -> Nodes:
        """Reach blocks from configurations; the numbers of those that are."""
        s, lattice, size = self.spreading, self.lattice, self.size
        low = self._low(numbers)
        place = (low + size // 2).astype(float)
        rows = {name: r.all for name, r in s.rows.items()}
        before, start = rows["places"][owner], rows["amounts"][owner]
        there = lattice.solved(start, before, place, halvings=HALVINGS)
        k = np.flatnonzero(~np.isnan(there[:, 0]))
        numbers, low, place, owner, there = numbers[k], low[k], place[k], owner[k], there[k]
        self.waiting[numbers] = False
        one, reach = self._proved(there)
        turned = s.turned(rows["turned"][owner], start[k], there, (before[k], place))
        good = np.flatnonzero(one & ((turned != 0) | (not s.signed)))
        numbers, low = numbers[good], low[good]
        self._take(low, place[good], there[good], reach[good], turned[good])
        return numbers

    def _proved(self, amounts: Floats) -> tuple[Truths, Floats]:
        lattice = self.lattice
        one, reach = np.zeros(len(amounts), dtype=bool), np.zeros(amounts.shape)
        far = self.size / 2 * np.abs(lattice.steps).sum(axis=0)
        for some in blocks(len(amounts)):
            checkpoint()
            here = lattice.at(amounts[some])
            cells = Cells.around(
                lattice.course.m, lattice.course.target, here, np.broadcast_to(far, (len(here), len(far)))
            )
            one[some] = cells.one_branch
            reach[some] = (np.concatenate(cells.reach, axis=1) + NEAR) * lattice.units
        return one, reach

    def _take(
        self, low: NDArray[np.intp], places: Floats, amounts: Floats, reach: Floats, turned: NDArray[np.int8]
    ) -> None:
        """Note blocks: each has the nodes from its low corner to before its high one, but at the end of the grid."""
        s, lattice, size = self.spreading, self.lattice, self.size
        numbers = s.add(lattice.nodes(places), places, amounts, reach, turned)
        ends = low + size == self.cells
        for offset in product(range(size + 1), repeat=self.axes):
            own = (ends | (np.array(offset) < size)).all(axis=1)
            nodes = lattice.nodes((low + np.array(offset))[own])
            blank = s.owner[nodes] < 0
            s.owner[nodes[blank]] = numbers[own][blank]
