r"""A way that was driven step by step: where the determinant of the wrenches changes its sign, and what is proved.

Between two steps `gcrules.mechanisms.kinematics.branch` proves that nothing is singular, or the step is parted until it
does or is too short. Where the sign changes something is singular; the place is narrowed down.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache, cached_property, lru_cache
from itertools import pairwise

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.branch import Steps, are_regular
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import Frames, frames, relative_sign
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import Course, close_loops
from gcrules.mechanisms.kinematics.solve import Solution, goal
from gcrules.mechanisms.kinematics.targets import Target

__all__ = ["Node", "Stretch", "Way"]

_NARROW = 1e-5  # of the way: how closely a crossing is located
_SHORTEST = 1 / 4096  # of the way: shorter stretches are not parted for a proof
_BESIDE = 0.4  # of a stretch: where it is parted if its middle has no sign
_SIGNS = 400  # stretches that are looked at for changes of sign
_MOST = 400  # stretches that are looked at for the proof of one way

Node = tuple[float, Configuration]
"""A part of the way, and the configuration there."""

Stretch = tuple[float, float]


@lru_cache(maxsize=8)
def _at_home(m: Linkage) -> Frames:
    """Where most ways begin."""
    return frames(m, Configurations.of([m.home]), m.centre)


class Way:
    """The steps of a way from one configuration to another: `nodes` in order, the first one at part 0."""

    def __init__(self, m: Linkage, target: Target, nodes: Sequence[Node]) -> None:
        self.m, self.target, self.nodes = m, target, list(nodes)
        self.course = Course(m, target)
        self.end = self.nodes[-1][0]
        self._looks = _SIGNS
        self._frames = cache(lambda c: frames(m, Configurations.of([c]), m.centre))

    @classmethod
    def to(cls, m: Linkage, target: Target, start: Configuration) -> tuple[Way, float | None]:
        """The way to a target, and the part from which on its branch is not proved (None: it is). Raises InputError
        where the robot does not assemble.
        """
        found = goal(Course(m, target), Solution(start, target), 0.0, 1.0)
        return cls(m, target, [(0.0, start), *zip(found.parts, found.way, strict=True)]), found.doubt

    def at(self, part: float) -> Configuration:
        """The configuration at a part of the way, from the step before it; its branch is not proved anew. Raises
        InputError.
        """
        near = max((n for n in self.nodes if n[0] <= part), key=lambda n: n[0])
        return self._from(near, part, doubt=near[0])

    def _from(self, near: Node, part: float, doubt: float | None = None) -> Configuration:
        if near[0] == part:
            return near[1]
        start = Solution(near[1], self.target, doubt=doubt)
        return goal(self.course, start, near[0], part).configuration

    def between(self, a: Node, b: Node, share: float = 0.5) -> Node | None:
        """The configuration in the middle of a stretch, or at another share; None where it is not reached."""
        checkpoint()
        part = a[0] + (b[0] - a[0]) * share
        try:
            return part, self._from(a, part)
        except InputError:
            return None

    # --- the sign of the determinant ---

    def frames(self, c: Configuration) -> Frames:
        if c is self.m.home:
            return _at_home(self.m)
        return self._of_nodes.get(c) or self._frames(c)

    @cached_property
    def _of_nodes(self) -> Mapping[Configuration, Frames]:
        nodes = [c for _, c in self.nodes]
        several = frames(self.m, Configurations.of(nodes), self.m.centre)
        return {c: several[k : k + 1] for k, c in enumerate(nodes)}

    def signs(self) -> tuple[tuple[Stretch, ...], float | None]:
        """The short stretches in which the determinant changes its sign, and the first place where that cannot be
        told. Robots with more actuators than freedoms have no such sign.
        """
        if self.m.robot.redundant:
            return (), None
        crossings: list[Stretch] = []
        unknown: float | None = None
        first, *others = self.nodes
        if not self.frames(first[1]).signed[0]:
            return (), first[0]
        signed = [first, *(n for n in others if self.frames(n[1]).signed[0])]
        for a, b in pairwise(signed):
            for found, sure in self._changes(a, b):
                if sure:
                    crossings.append(found)
                elif unknown is None:
                    unknown = sum(found) / 2
        return tuple(crossings), unknown

    def _changes(self, a: Node, b: Node) -> Iterator[tuple[Stretch, bool]]:
        sign = self._sign(a, b)
        if sign == 1:
            return
        self._looks -= 1
        if b[0] - a[0] <= _NARROW * self.end or self._looks < 0:
            yield (a[0], b[0]), sign == -1
            return
        middle = self.between(a, b)
        if middle is None:
            yield (a[0], b[0]), False
            return
        if sign == -1:
            first = self._sign(a, middle)
            if first == 0 and (beside := self.between(a, b, _BESIDE)):  # the middle is the crossing, within rounding
                middle, first = beside, self._sign(a, beside)
            yield from self._changes(a, middle) if first != 1 else self._changes(middle, b)
        else:
            yield from self._changes(a, middle)
            yield from self._changes(middle, b)

    def _sign(self, a: Node, b: Node) -> int:
        return int(relative_sign(self.frames(a[1]), self.frames(b[1]))[0])

    # --- proofs ---

    def proved_to(self, most: int = _MOST) -> float:
        """The part up to which it is proved that nothing is singular."""
        left = self.unproved(most)
        return left[0][0] if left else self.end

    def unproved(self, most: int = _MOST) -> tuple[Stretch, ...]:
        """The stretches, those side by side as one, outside of which it is proved that nothing is singular. So many
        stretches are looked at, the longest ones first.
        """
        every = Configurations.of([c for _, c in self.nodes])
        parts = np.array([p for p, _ in self.nodes])
        ends = np.stack([parts[:-1], parts[1:]], axis=1)
        here, there = every[:-1], every[1:]
        found: list[Stretch] = []
        while len(ends):
            checkpoint()
            order = np.lexsort((ends[:, 0], ends[:, 0] - ends[:, 1]))  # what is left at last lies side by side
            found += map(tuple, ends[order[most:]].tolist())
            order = order[:most]
            most -= len(order)
            ends, here, there = ends[order], here[order], there[order]
            grown = (ends[:, 1:] - ends[:, :1]) * self.target.values
            left = ~are_regular(self.m, self.target, Steps.between(here, there, grown))
            short = ends[:, 1] - ends[:, 0] <= _SHORTEST * self.end
            found += map(tuple, ends[left & short].tolist())
            left &= ~short
            ends, here, there = ends[left], here[left], there[left]
            middle = ends.mean(axis=1)
            joints = close_loops(self.course, here, self.course.goal(middle))
            found += map(tuple, ends[~joints.closed].tolist())
            ends, middle = ends[joints.closed], middle[joints.closed]
            here, there = here[joints.closed], there[joints.closed]
            amounts, links = ([x[joints.closed] for x in several] for several in (joints.amounts, joints.links))
            between = here.after(amounts, links)
            ends = np.concatenate([np.stack([ends[:, 0], middle], 1), np.stack([middle, ends[:, 1]], 1)])
            here, there = Configurations.together([here, between]), Configurations.together([between, there])
        return tuple(_joined(sorted(found)))


def _joined(stretches: Sequence[Stretch]) -> Iterator[Stretch]:
    """Stretches in order, those that touch as one."""
    start: float | None = None
    end = 0.0
    for a, b in stretches:
        if start is not None and a == end:
            end = b
            continue
        if start is not None:
            yield start, end
        start, end = a, b
    if start is not None:
        yield start, end
