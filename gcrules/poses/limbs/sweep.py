r"""A robot of joints over a grid of coordinates, solved from node to node: configurations, margins, signs.

From a node that has been solved the loops are closed at its neighbours, many at once, and so on. What `boxes` does not
prove to hang together with the first node is forgotten again, so every number belongs to the branch of that node.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.mechanisms.kinematics.actuations import amplified
from gcrules.mechanisms.kinematics.amplification import Index
from gcrules.mechanisms.kinematics.branch import Steps, follow_branch
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import frames, relative_sign
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import Course, Joints, units_of
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import stays_still
from gcrules.poses.limbs.straight import after, led, number_of_steps

__all__ = ["Sweep", "blocks"]

Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_AT_ONCE = 256  # configurations: their arrays fit into a cache


class Sweep:
    """The nodes of a grid of this `shape`, numbered in its order. The wanted coordinates are `origin` (names,) at the
    first node and grow by `steps` (axes, names) from one node to the next. `start` is the configuration at the node
    `first`.

    `amounts` (N, all) are those of all joints from there, not a number at nodes that are not `reached` (N,).
    """

    def __init__(
        self, course: Course, shape: tuple[int, ...], origin: Floats, steps: Floats, first: int, start: Configuration
    ) -> None:
        self.course, self.shape, self.origin, self.steps, self.first = course, shape, origin, steps, first
        self.units = units_of(course.m)
        self._start = Configurations.of([start])
        number = int(np.prod(shape))
        self.amounts = np.full((number, len(self.units)), np.nan)
        self.reached = np.zeros(number, dtype=bool)
        self.amounts[first] = 0.0
        self.reached[first] = True
        self._spread()

    def places(self, nodes: Places) -> Floats:
        """The places of nodes, (K, axes), counted in nodes along each axis."""
        return np.stack(np.unravel_index(nodes, self.shape), axis=1).astype(float)

    def nodes(self, places: Floats) -> Places:
        """The numbers of the nodes at whole places (K, axes)."""
        index = np.rint(places).astype(np.intp)
        return np.asarray(np.ravel_multi_index(tuple(index.T), self.shape))

    def at(self, amounts: Floats) -> Configurations:
        """The configurations of amounts (K, all)."""
        return after(self._start, amounts)

    def solved(self, amounts: Floats, before: Floats, places: Floats, *, halvings: int | None = None) -> Floats:
        """Amounts (K, all) at places (K, axes), from those at places `before`; not a number where there are none near
        by, or, with `halvings`, where it is not proved that they lie on one branch, with so many halvings of the way.
        """
        found = np.full(amounts.shape, np.nan)
        for some in blocks(len(places)):
            grown = (places[some] - before[some]) @ self.steps
            begin = self.origin + before[some] @ self.steps
            parts = int(number_of_steps(self.course, grown).max(initial=1))
            found[some] = self._led(amounts[some], begin, grown, parts, prove=halvings is not None)
            for _ in range(halvings or 0):
                rest = np.flatnonzero(np.isnan(found[some, 0]) & ~np.isnan(amounts[some, 0]))
                if not len(rest):
                    break
                parts *= 2
                found[some.start + rest] = self._led(amounts[some][rest], begin[rest], grown[rest], parts, prove=True)
        return found

    def _led(self, amounts: Floats, begin: Floats, grown: Floats, parts: int, *, prove: bool) -> Floats:
        def accept(now: Configurations, joints: Joints, _on: Places, step: Floats) -> Truths:
            good = joints.closed & stays_still(self.course.m, joints.amounts)
            if prove and good.any():
                steps = Steps.of(now, joints, step)[good]
                good[good] = follow_branch(self.course.m, self.course.target, steps)
            return good

        steps = np.where(np.isnan(amounts[:, 0]), 0, parts)
        found, good = led(
            self.course, self._start, amounts, lambda on, part: begin[on] + part * grown[on], grown, steps, accept
        )
        return np.where(good[:, None], found, np.nan)

    def _spread(self) -> None:
        front = np.array([self.first])
        while len(front):
            report(f"{int(self.reached.sum()):,} of {len(self.reached):,} poses")
            found = [front[:0]]
            for parents, children in self.neighbours(front):
                new = ~self.reached[children]
                parents, children = parents[new], children[new]
                there = self.solved(self.amounts[parents], self.places(parents), self.places(children))
                good = ~np.isnan(there[:, 0])
                self.amounts[children[good]] = there[good]
                self.reached[children[good]] = True
                found.append(children[good])
            front = np.concatenate(found)

    def neighbours(self, nodes: Places) -> Iterator[tuple[Places, Places]]:
        """Both ways along each axis the nodes that have a neighbour there, and these neighbours."""
        index = np.stack(np.unravel_index(nodes, self.shape), axis=1)
        for axis, step in product(range(len(self.shape)), (1, -1)):
            moved = index.copy()
            moved[:, axis] += step
            inside = (moved[:, axis] >= 0) & (moved[:, axis] < self.shape[axis])
            yield nodes[inside], np.ravel_multi_index(tuple(moved[inside].T), self.shape)

    def keep(self, nodes: Truths) -> None:
        """Forget all other nodes (N,)."""
        self.reached &= nodes
        self.amounts[~self.reached] = np.nan
        self.__dict__.pop("signs", None)  # they may have been carried over other nodes

    # --- numbers ---

    @cached_property
    def sigma(self) -> Floats:
        """The margins at the nodes (N,), not a number where none is reached."""
        found = np.full(len(self.reached), np.nan)
        for nodes in self._kept():
            found[nodes] = margins(self.course.m, self.at(self.amounts[nodes])).sigma
        return found

    def index(self, index: Index) -> Floats:
        """An index of the actuators at the nodes (N,), not a number where none is reached."""
        found = np.full(len(self.reached), np.nan)
        for nodes in self._kept():
            found[nodes] = index.of(amplified(self.course.m, self.at(self.amounts[nodes])))
        return found

    @cached_property
    def signs(self) -> NDArray[np.int8]:
        """The sign of the determinant of all wrenches (N,), that of the first node that has one taken as 1; 0 where it
        is not known. It is carried along the edges of the grid; where a node has none, over that node.
        """
        m = self.course.m
        found = np.zeros(len(self.reached), dtype=np.int8)
        kept = np.flatnonzero(self.reached)
        if not len(kept):
            return found
        parts = [frames(m, self.at(self.amounts[nodes]), m.centre) for nodes in self._kept()]
        every = type(parts[0]).together(parts)
        row = np.full(len(self.reached), -1)
        row[kept] = np.arange(len(kept))
        signed = kept[every.signed]
        if not len(signed):
            return found
        far = self.places(signed) - self.places(np.array([self.first]))
        front = signed[np.argmin(np.abs(far).sum(axis=1))][None]
        found[front] = 1
        while len(front):
            checkpoint()
            more = [front[:0]]
            for parents, children in [*self.neighbours(front), *self._over(front, found)]:
                new = (found[children] == 0) & self.reached[children]
                parents, children = parents[new], children[new]
                relative = relative_sign(every[row[parents]], every[row[children]])
                found[children] = relative * found[parents]
                more.append(children[relative != 0])
            front = np.unique(np.concatenate(more))
        return found

    def _over(self, nodes: Places, found: NDArray[np.int8]) -> Iterator[tuple[Places, Places]]:
        """Both ways along each axis nodes, and those behind a neighbour that has no sign."""
        index = np.stack(np.unravel_index(nodes, self.shape), axis=1)
        for axis, step in product(range(len(self.shape)), (1, -1)):
            moved = index.copy()
            moved[:, axis] += 2 * step
            inside = (moved[:, axis] >= 0) & (moved[:, axis] < self.shape[axis])
            between = (index[inside] + moved[inside]) // 2
            middle = np.ravel_multi_index(tuple(between.T), self.shape)
            blank = self.reached[middle] & (found[middle] == 0)
            yield nodes[inside][blank], np.ravel_multi_index(tuple(moved[inside][blank].T), self.shape)

    def signed(self, places: Floats) -> Floats:
        """Margins with the sign of the determinant at any places (K, axes), solved from a node of the cell; not a
        number where none is reached.
        """
        near = np.full(len(places), -1)
        last = np.array(self.shape) - 1
        corners = [np.clip(np.rint(places), 0, last)]
        corners += [np.clip(np.floor(places) + c, 0, last) for c in product((0, 1), repeat=len(self.shape))]
        for corner in corners:
            node = self.nodes(corner)
            near = np.where((near < 0) & (self.signs[node] != 0), node, near)
        found = np.full(len(places), np.nan)
        at = np.flatnonzero(near >= 0)
        if not len(at):
            return found
        m = self.course.m
        amounts = self.solved(self.amounts[near[at]], self.places(near[at]), places[at])
        good = ~np.isnan(amounts[:, 0])
        at, there, here = at[good], self.at(amounts[good]), self.at(self.amounts[near[at[good]]])
        sign = relative_sign(frames(m, here, m.centre), frames(m, there, m.centre))
        found[at] = margins(m, there).sigma * sign * self.signs[near[at]]
        return found

    def _kept(self) -> Iterator[Places]:
        kept = np.flatnonzero(self.reached)
        for some in blocks(len(kept)):
            checkpoint()
            yield kept[some]


def blocks(number: int) -> Iterator[slice]:
    """As many at once as memory is for."""
    return (slice(k, min(k + _AT_ONCE, number)) for k in range(0, number, _AT_ONCE))
