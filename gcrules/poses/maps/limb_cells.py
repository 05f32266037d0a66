r"""Which cells of a sweep are proved free of singular configurations: box by box, large ones first.

Around the configuration in the middle of a box `Cells` shows that for all values of the coordinates in the box there is
one configuration near by, a continuous one, and that none is singular. A box in which that fails is halved along its
longest sides, also below the size of a cell. What a proved box holds is connected: nodes and middles of other boxes
whose configurations lie in it. Only what is connected with a node counts: nodes are on home's branch.
"""

from __future__ import annotations

from itertools import product

import networkx as nx
import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.determinants import frames, relative_sign
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import HALVINGS, Truths, blocks
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.poses.maps.spreading import NEAR
from gcrules.poses.maps.sweep import Sweep

__all__ = ["LARGEST", "proved_cells"]

Integers = NDArray[np.int64]
Edges = NDArray[np.intp]
"""Nodes (K, 2): from one to the next one along an axis."""

LARGEST = 8
"""Cells along the side of the largest boxes."""
_UNIT = 4  # parts of a cell along each axis: the smallest boxes
_HOME = -1  # the number of what is on home's branch
_ALIKE = 1e-6  # configurations that are the same one
_MOST = 10_000  # boxes smaller than cells that are tried at once


def proved_cells(sweep: Sweep) -> NDArray[np.uint8]:
    """The status of each cell.

    A cell is free where all of it is proved, outside where a corner is not reached, crossed where one branch goes
    along one of its edges and the determinant has different signs at its ends, else undecided.
    """
    return _Boxes(sweep).statuses()


class _Boxes:
    def __init__(self, sweep: Sweep) -> None:
        self.sweep = sweep
        self.lattice = sweep.lattice
        self.cells = tuple(n - 1 for n in self.lattice.shape)
        self.axes = len(self.cells)
        self.graph: nx.Graph[int] = nx.Graph()
        self.graph.add_node(_HOME)
        self.graph.add_edges_from((_HOME, n) for n in np.flatnonzero(sweep.reached).tolist())
        self.count = len(sweep.reached)  # numbers of nodes are below, of middles from here on
        self.changes = self._changes()
        self.crossed = self._beside(self.changes)
        self.pieces: list[tuple[Integers, Integers, Integers]] = []  # number, low, width
        self.sums = _sums(sweep.reached.reshape(self.lattice.shape))

    def statuses(self) -> NDArray[np.uint8]:
        low, width = self._first()
        middles = np.full((len(low), len(self.lattice.units)), np.nan)
        before, number = np.zeros((len(low), self.axes)), np.full(len(low), -1)
        while len(low):
            report(f"proving {len(low):,} boxes")
            low, width, middles, before, number = self._level(low, width, middles, before, number)
        return self._statuses()

    def _first(self) -> tuple[Integers, Integers]:
        sides = []
        for n in self.cells:
            ends = [0]
            while ends[-1] < n * _UNIT:
                ends.append(ends[-1] + min(LARGEST * _UNIT, 1 << ((n * _UNIT - ends[-1]).bit_length() - 1)))
            sides.append(np.array(ends))
        low = np.stack(np.meshgrid(*(s[:-1] for s in sides), indexing="ij"), axis=-1).reshape(-1, self.axes)
        width = np.stack(np.meshgrid(*(np.diff(s) for s in sides), indexing="ij"), axis=-1).reshape(-1, self.axes)
        return low.astype(np.int64), width.astype(np.int64)

    def _level(
        self, low: Integers, width: Integers, known: Floats, before: Floats, parent: Integers
    ) -> tuple[Integers, Integers, Floats, Floats, Integers]:
        """Try boxes; those that are to be halved come back in parts, each with the configuration in the middle of what
        it is a part of, with the place and the number of that.
        """
        lattice = self.lattice
        lit = self._lit(low, width)
        low, width, known, before, parent = low[lit], width[lit], known[lit], before[lit], parent[lit]
        place = (low + width / 2) / _UNIT
        amounts, number = self._middles(low, width, place, known, before)
        one, regular = np.zeros(len(low), dtype=bool), np.zeros(len(low), dtype=bool)
        reach = np.zeros(amounts.shape)
        there = np.flatnonzero(~np.isnan(amounts[:, 0]))
        far = width / (2 * _UNIT) @ np.abs(lattice.steps)
        for some in blocks(len(there)):
            checkpoint()
            k = there[some]
            cells = Cells.around(lattice.course.m, lattice.course.target, lattice.at(amounts[k]), far[k])
            one[k], regular[k] = cells.one_branch, cells.one_branch & cells.regular
            reach[k] = np.concatenate(cells.reach, axis=1) * lattice.units + NEAR * lattice.units
        self._join(one, low, width, amounts, reach, number, known, parent)
        self.pieces.append((number[regular], low[regular], width[regular]))
        again = ~regular & (width > 1).any(axis=1)
        again &= ~((width == _UNIT).all(axis=1) & self.crossed[tuple((low // _UNIT).T)])
        small = again & (width <= _UNIT).all(axis=1)
        if small.sum() > _MOST:
            again &= ~small
        return self._halved(low[again], width[again], amounts[again], place[again], number[again])

    def _changes(self) -> Edges:
        """The edges of cells along which it is proved that one branch goes, from a node to the one after it, and at
        whose ends the determinant has different signs.
        """
        sweep, lattice, m = self.sweep, self.lattice, self.lattice.course.m
        found = []
        for parents, children in lattice.neighbours(np.flatnonzero(sweep.reached)):
            differ = (children > parents) & sweep.reached[children] & (sweep.signs[parents] != sweep.signs[children])
            parents, children = parents[differ], children[differ]
            there = lattice.solved(
                sweep.amounts[parents], lattice.places(parents), lattice.places(children), halvings=HALVINGS
            )
            one = np.flatnonzero(self._alike(there, sweep.amounts[children]))
            for some in blocks(len(one)):
                checkpoint()
                k = one[some]
                ends = (lattice.at(sweep.amounts[n[k]]) for n in (parents, children))
                k = k[relative_sign(*(frames(m, c, m.centre) for c in ends)) < 0]
                found.append(np.stack([parents[k], children[k]], axis=1))
        return np.concatenate([np.zeros((0, 2), dtype=np.intp), *found])

    def _alike(self, one: Floats, other: Floats) -> Truths:
        """Whether amounts (K, all) are those of the same configurations."""
        return np.asarray((np.abs(one - other) <= _ALIKE * self.lattice.units).all(axis=1))

    def _beside(self, edges: Edges) -> Truths:
        """The cells that have one of these edges."""
        found = np.zeros(self.cells, dtype=bool)
        low, high = (np.stack(np.unravel_index(edges[:, k], self.lattice.shape), axis=1) for k in (0, 1))
        for back in product((0, 1), repeat=self.axes):
            cell = low - np.array(back)
            inside = ((high <= cell + 1) & (cell >= 0) & (cell < np.array(self.cells))).all(axis=1)
            found[tuple(cell[inside].T)] = True
        return found

    def _lit(self, low: Integers, width: Integers) -> Truths:
        """Boxes in which, or in the cell around which, a node is reached."""
        first, last = low // _UNIT, -(-(low + width) // _UNIT)
        total = np.zeros(len(low), dtype=np.int64)
        for ends in product((0, 1), repeat=self.axes):
            corner = np.where(ends, last + 1, first)
            total += (-1) ** (self.axes - sum(ends)) * self.sums[tuple(corner.T)]
        return total > 0

    def _middles(
        self, low: Integers, width: Integers, place: Floats, known: Floats, before: Floats
    ) -> tuple[Floats, Integers]:
        """The configurations in the middle of boxes, and their numbers: those of nodes, or solved from what is known,
        else from a node near by.
        """
        sweep, lattice = self.sweep, self.lattice
        number = self.count + np.arange(len(low))
        self.count += len(low)
        whole = (np.rint(place) == place).all(axis=1)
        node = np.full(len(low), -1)
        node[whole] = lattice.nodes(place[whole])
        own = whole & sweep.reached[node]
        number[own] = node[own]
        source = np.where(np.isnan(known[:, :1]), np.nan, known)
        begin = before.copy()
        last = np.array(lattice.shape) - 1
        for corner in product((0, 1), repeat=self.axes):
            near = np.clip(np.floor(place) + np.array(corner), 0, last)
            nodes = lattice.nodes(near)
            blank = np.isnan(source[:, 0]) & sweep.reached[nodes]
            source[blank], begin[blank] = sweep.amounts[nodes[blank]], near[blank]
        found = np.where(own[:, None], sweep.amounts[node], np.nan)
        rest = ~own & ~np.isnan(source[:, 0])
        found[rest] = lattice.solved(source[rest], begin[rest], place[rest])
        return found, number

    def _join(
        self,
        one: Truths,
        low: Integers,
        width: Integers,
        amounts: Floats,
        reach: Floats,
        number: Integers,
        known: Floats,
        parent: Integers,
    ) -> None:
        """Note what is connected: the middle of each box with one branch, the nodes in it, and the middle of the box
        that it is a part of, where their configurations lie in it.
        """
        sweep, lattice = self.sweep, self.lattice
        inside = one & (np.abs(known - amounts) <= reach).all(axis=1)
        self.graph.add_edges_from(zip(number[inside].tolist(), parent[inside].tolist(), strict=True))
        first = -(-low // _UNIT)
        nodes = (low + width) // _UNIT - first + 1  # along each axis, in the box
        some = one & (nodes > 0).all(axis=1)
        for shape in np.unique(nodes[some], axis=0):
            which = np.flatnonzero(some & (nodes == shape).all(axis=1))
            for part in blocks(len(which)):
                checkpoint()
                k = which[part]
                for offset in product(*(range(n) for n in shape)):
                    node = lattice.nodes(first[k] + np.array(offset))
                    near = (np.abs(sweep.amounts[node] - amounts[k]) <= reach[k]).all(axis=1)
                    self.graph.add_edges_from(zip(number[k[near]].tolist(), node[near].tolist(), strict=True))

    def _halved(
        self, low: Integers, width: Integers, amounts: Floats, place: Floats, number: Integers
    ) -> tuple[Integers, Integers, Floats, Floats, Integers]:
        """Both halves along each of the longest sides."""
        parts = [(low, width, np.arange(len(low)))]
        for axis in range(self.axes):
            longest = width[:, axis] == width.max(axis=1, initial=0)
            more = []
            for at, wide, owner in parts:
                cut = longest[owner]
                step = np.zeros_like(at)
                thin = wide.copy()
                thin[cut, axis] //= 2
                step[:, axis] = thin[:, axis]
                more += [(at, thin, owner), ((at + step)[cut], thin[cut], owner[cut])]
            parts = more
        owner = np.concatenate([p[2] for p in parts])
        lows, widths = (np.concatenate([p[n] for p in parts]) for n in (0, 1))
        return lows, widths, amounts[owner], place[owner], number[owner]

    def _statuses(self) -> NDArray[np.uint8]:
        sweep, lattice = self.sweep, self.lattice
        mine = nx.node_connected_component(self.graph, _HOME)
        free = self._volumes(mine) == _UNIT**self.axes
        corners = list(product((0, 1), repeat=self.axes))
        reached = sweep.reached.reshape(lattice.shape)
        at = [tuple(slice(k, k + n) for k, n in zip(c, self.cells, strict=True)) for c in corners]
        outside = np.any([~reached[a] for a in at], axis=0)
        found = np.full(self.cells, UNDECIDED, dtype=np.uint8)
        found[self.crossed] = CROSSED
        found[outside] = OUTSIDE
        found[free & ~outside] = FREE
        return found

    def _volumes(self, mine: set[int]) -> Integers:
        """How much of each cell is proved, in smallest boxes."""
        found = np.zeros(self.cells, dtype=np.int64)
        number, low, width = (np.concatenate([p[k] for p in self.pieces]) for k in range(3))
        own = np.isin(number, np.fromiter(mine, dtype=np.int64, count=len(mine)))
        low, width = low[own], width[own]
        sizes = np.maximum(width // _UNIT, 1)
        for size in np.unique(sizes, axis=0):
            some = (sizes == size).all(axis=1)
            share = np.minimum(width[some], _UNIT).prod(axis=1)
            for offset in product(*(range(n) for n in size)):
                np.add.at(found, tuple((low[some] // _UNIT + np.array(offset)).T), share)
        return found


def _sums(reached: Truths) -> Integers:
    """Sums over all nodes before, with zeros in front."""
    found = np.pad(reached.astype(np.int64), [(1, 0)] * reached.ndim)
    for axis in range(reached.ndim):
        found = found.cumsum(axis=axis)
    return found
