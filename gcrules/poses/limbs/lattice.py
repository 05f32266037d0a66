"""The nodes of a grid of wanted values of a robot of joints, and configurations led from place to place."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.branch import Steps, follow_branch
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import Frames, frames, relative_orientation
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import Course, Joints, units_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import stays_still
from gcrules.poses.limbs.straight import after, led, number_of_steps

__all__ = ["HALVINGS", "Lattice", "Nodes", "Truths", "blocks"]

Truths = NDArray[np.bool_]
Nodes = NDArray[np.intp]

HALVINGS = 3
"""Of a step on the way from node to node, for its proof."""
_TURNS = 6  # halvings of a way on which frames turn too far to be compared
_AT_ONCE = 256  # configurations: their arrays fit into a cache


class Lattice:
    """A grid of this `shape`, its nodes numbered in its order. The wanted coordinates are `origin` (names,) at the
    first node and grow by `steps` (axes, names) from one node to the next.

    Amounts (K, all) are those of all joints from the configuration `start` on, not a number where there are none;
    places (K, axes) are counted in nodes along each axis.
    """

    def __init__(
        self, course: Course, shape: tuple[int, ...], origin: Floats, steps: Floats, start: Configuration
    ) -> None:
        self.course, self.shape, self.origin, self.steps, self.start = course, shape, origin, steps, start
        self.units = units_of(course.m)
        self._start = Configurations.of([start])

    def layers(self, first: int, stop: int) -> Lattice:
        """Some whole layers along the first axis."""
        origin = self.origin + first * self.steps[0]
        return Lattice(self.course, (stop - first, *self.shape[1:]), origin, self.steps, self.start)

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return int(np.prod(self.shape))

    def places(self, nodes: Nodes) -> Floats:
        """The places of nodes."""
        return np.stack(np.unravel_index(nodes, self.shape), axis=1).astype(float)

    def nodes(self, places: Floats) -> Nodes:
        """The numbers of the nodes at whole places."""
        index = np.rint(places).astype(np.intp)
        return np.asarray(np.ravel_multi_index(tuple(index.T), self.shape))

    def neighbours(self, nodes: Nodes, step: int = 1) -> Iterator[tuple[Nodes, Nodes]]:
        """Both ways along each axis the nodes that have a neighbour there, so many steps on, and these neighbours."""
        index = np.stack(np.unravel_index(nodes, self.shape), axis=1)
        for axis, along in product(range(len(self.shape)), (step, -step)):
            moved = index.copy()
            moved[:, axis] += along
            inside = (moved[:, axis] >= 0) & (moved[:, axis] < self.shape[axis])
            yield nodes[inside], np.asarray(np.ravel_multi_index(tuple(moved[inside].T), self.shape))

    def at(self, amounts: Floats) -> Configurations:
        """The configurations of amounts."""
        return after(self._start, amounts)

    def frames(self, amounts: Floats) -> Frames:
        """The frames of their wrenches."""
        m = self.course.m
        return Frames.together(
            [frames(m, self.at(amounts[some]), m.centre) for some in blocks(len(amounts))]
            or [frames(m, self.at(amounts), m.centre)]
        )

    def solved(self, amounts: Floats, before: Floats, places: Floats, *, halvings: int | None = None) -> Floats:
        """Amounts at places, from those at places `before`; not a number where there are none near by, or, with
        `halvings`, where it is not proved that they lie on one branch, in steps that are halved so many times at most.
        """
        found = np.full(amounts.shape, np.nan)
        for some in blocks(len(places)):
            grown = (places[some] - before[some]) @ self.steps
            begin = self.origin + before[some] @ self.steps
            if halvings is None:
                found[some] = self._led(amounts[some], begin, grown)
            else:
                found[some] = self._followed(amounts[some], begin, grown, halvings)
        return found

    def _led(self, amounts: Floats, begin: Floats, grown: Floats, halvings: int = 0) -> Floats:
        def accept(_now: Configurations, joints: Joints, _on: Nodes, _step: Floats) -> Truths:
            return joints.closed & stays_still(self.course.m, joints.amounts)

        def goals(on: Nodes, part: Floats) -> Floats:
            return np.asarray(begin[on] + part * grown[on])

        steps = np.where(np.isnan(amounts[:, 0]), 0, self._parts(grown))
        found, good = led(self.course, self._start, amounts, goals, grown, steps, accept, halvings, growth=1.0)
        return np.where(good[:, None], found, np.nan)

    def _parts(self, grown: Floats) -> int:
        """In how many steps all wanted values grow so much."""
        return int(number_of_steps(self.course, grown).max(initial=1))

    def _followed(self, amounts: Floats, begin: Floats, grown: Floats, halvings: int) -> Floats:
        """All steps are predicted first, one after the other, and then proved at once: a proof of few steps takes as
        long as one of many. Of those that fail both halves are tried, with the configuration between.
        """
        parts = self._parts(grown)
        ways = [amounts]
        for k in range(parts):
            ways.append(self._led(ways[-1], begin + k / parts * grown, grown / parts, halvings))
        good = ~np.isnan(ways[-1][:, 0])
        owner, part = np.tile(np.flatnonzero(good), parts), np.repeat(np.arange(parts) / parts, good.sum())
        low, high = (np.concatenate([w[good] for w in some]) for some in (ways[:-1], ways[1:]))
        for halving in range(halvings + 1):
            width = 0.5**halving / parts
            failed = ~self._proved(low, high, width * grown[owner])
            if halving == halvings:
                good[owner[failed]] = False
                break
            failed &= good[owner]
            owner, part, low, high = owner[failed], part[failed], low[failed], high[failed]
            middle = self._led(low, begin[owner] + part[:, None] * grown[owner], width / 2 * grown[owner])
            good[owner[np.isnan(middle[:, 0])]] = False
            left = good[owner]
            owner, part = np.tile(owner[left], 2), np.concatenate([part[left], part[left] + width / 2])
            low, high = np.concatenate([low[left], middle[left]]), np.concatenate([middle[left], high[left]])
            if not len(owner):
                break
        return np.where(good[:, None], ways[-1], np.nan)

    def _proved(self, low: Floats, high: Floats, grown: Floats) -> Truths:
        """Whether steps from configurations to others are proved to lie on one branch."""
        found = np.zeros(len(low), dtype=bool)
        for some in blocks(len(low)):
            steps = Steps.between(self.at(low[some]), self.at(high[some]), grown[some])
            found[some] = follow_branch(self.course.m, self.course.target, steps)
        return found

    def turned(
        self, one: Floats, other: Floats, ends: tuple[Floats, Floats], known: tuple[Frames, Frames] | None = None
    ) -> NDArray[np.int8]:
        """Whether the frames of wrenches keep their orientation on the straight ways from places to others, `ends`, at
        which amounts are `one` and `other` (and their frames `known`): 1, or −1; 0 where that cannot be told.
        """
        a, b = known or (self.frames(one), self.frames(other))
        return self._turned(one, a, other, b, ends, _TURNS)

    def _turned(
        self, one: Floats, a: Frames, other: Floats, b: Frames, ends: tuple[Floats, Floats], halvings: int
    ) -> NDArray[np.int8]:
        found = relative_orientation(a, b)
        rest = np.flatnonzero((found == 0) & a.whole & b.whole)
        if not len(rest) or not halvings:
            return found
        before, after = (e[rest] for e in ends)
        half = (before + after) / 2
        middle = self.solved(one[rest], before, half)
        good = ~np.isnan(middle[:, 0])
        rest, middle, half, before, after = rest[good], middle[good], half[good], before[good], after[good]
        if len(rest):
            between = self.frames(middle)
            first = self._turned(one[rest], a[rest], middle, between, (before, half), halvings - 1)
            second = self._turned(middle, between, other[rest], b[rest], (half, after), halvings - 1)
            found[rest] = first * second
        return found


def blocks(number: int) -> Iterator[slice]:
    """As many at once as memory is for."""
    return (slice(k, min(k + _AT_ONCE, number)) for k in range(0, number, _AT_ONCE))
