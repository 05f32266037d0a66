"""Configurations of a robot with its actuators held, sought from random joints: where no count of them is known."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.assembled import configuration_at
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import loop_gaps, loop_rows, units_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.limb_joints import Held, same_spans, spans_of

__all__ = ["Search", "search"]

_STARTS = 100  # in a round
_QUIET = 2  # rounds without anything new
_ROUNDS = 8
_ITERATIONS = 60
_CLOSED = 1e-9
_LONGEST = 0.6
_MANY = 60  # configurations: they are taken as points of curves


@dataclass(frozen=True, eq=False)
class Search:
    """What was found from so many starts, the last `quiet` of which found nothing new. `many` tells that there seemed
    no end of it. `outside` counts, by reasons, the starts that led out of the robot's family.
    """

    found: tuple[Configuration, ...]
    outside: Mapping[str, int]
    starts: int
    quiet: int
    many: bool


def search(m: Linkage, held: Held) -> Search:
    """Configurations with the driven joints held."""
    rng = np.random.default_rng(23)
    found: list[Configuration] = []
    spans: list[Floats] = []
    outside: dict[str, int] = {}
    starts = quiet = 0
    for number in range(_ROUNDS):
        before = len(found)
        for amounts in _closed(m, held, rng, home_too=not number):
            try:
                c = configuration_at(m, amounts)
            except NotClosed as fault:
                outside[str(fault)] = outside.get(str(fault), 0) + 1
                continue
            own = spans_of(m, held, c)
            if not any(same_spans(own, other) for other in spans):
                found.append(c)
                spans.append(own)
        starts += _STARTS
        quiet = quiet + _STARTS if len(found) == before else 0
        if quiet >= _QUIET * _STARTS or len(found) > _MANY:
            break
    return Search(tuple(found), FrozenMap(outside), starts, quiet, len(found) > _MANY)


def _closed(m: Linkage, held: Held, rng: np.random.Generator, *, home_too: bool) -> list[list[Floats]]:
    """Amounts of all limbs' coordinates that close the loops, from random ones."""
    chains = m.home.chains
    cuts = np.cumsum([len(a) for a in held.amounts])
    free = [int(k + s) for s, own in zip([0, *cuts], held.free, strict=False) for k in own]
    units = units_of(m)
    every = np.tile(np.concatenate(held.amounts), (_STARTS, 1))
    first = 1 if home_too else 0
    every[first:, free] += rng.uniform(-np.pi, np.pi, (_STARTS - first, len(free))) * units[free]
    home = np.broadcast_to(np.eye(4), (_STARTS, 4, 4))
    size = np.full(_STARTS, np.inf)
    for _ in range(_ITERATIONS):
        checkpoint()
        amounts = np.split(every, cuts[:-1], axis=1)
        links = [c.links(a) for c, a in zip(chains, amounts, strict=True)]
        gaps = loop_gaps(chains, links, home, m)
        size = np.abs(gaps).max(axis=1, initial=0.0)
        twists = [c.after(own).shared_twists for c, own in zip(chains, links, strict=True)]
        rows = (loop_rows(twists, home, m) * units)[..., free]
        squares = np.minimum((gaps * gaps).sum(axis=1), 1.0) + 1e-14
        turned = np.swapaxes(rows, -1, -2)
        normal = turned @ rows + squares[:, None, None] * np.eye(len(free))
        step = -np.linalg.solve(normal, turned @ gaps[..., None])[..., 0]
        longest = np.abs(step).max(axis=1, keepdims=True)
        every[:, free] += step * units[free] * (_LONGEST / np.maximum(longest, _LONGEST))
    return [np.split(own, cuts[:-1]) for own in every[size <= _CLOSED]]
