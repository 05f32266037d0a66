r"""What holds everywhere on a way that was driven: how large the margin is at least, and what the actuators do.

The way is in steps that are proved to follow one branch of solutions, each with a bound of the margin
(`gcrules.mechanisms.kinematics.margin_bounds`); those whose bound is much less than the least margin that was met are
halved: branch and bound in the parameter. The middle of a step is solved from its begin, and is on the branch where
both halves are proved.
"""

from __future__ import annotations

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.branch import Steps
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.itinerary import Itinerary
from gcrules.mechanisms.kinematics.loops import close_loops
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.margin_bounds import StepBounds, bounds_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.limbs.lattice import blocks
from gcrules.poses.limbs.nodes import Nodes
from gcrules.poses.paths.least import aim_of

__all__ = ["WayBounds", "no_bounds", "way_bounds"]

_NEAR = 0.98  # the bound is driven up to this times the least margin that was met
_MOST = 6_000  # steps that are halved at most
_HALVINGS = 14


@dataclass(frozen=True, eq=False)
class WayBounds:
    """Everywhere on the way σ is at least `least`, proved, 0 where nothing is, and on each of its segments what
    `segments` says at least; a margin of `met` was met, at `parameter`. The amounts of the actuators stay in `ranges`
    (A, 2), infinite where that is not proved.
    """

    segments: Floats
    met: float
    parameter: float
    ranges: Floats

    @property
    def least(self) -> float:
        return min(float(self.segments.min()), self.met)


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Steps from `here` at the parameters of `ends` (2, N)."""

    here: Configurations
    ends: Floats


def no_bounds(way: Itinerary) -> WayBounds:
    """Nothing is proved."""
    return WayBounds(np.zeros(len(way.courses)), np.inf, 0.0, np.array([[-np.inf, np.inf]] * len(way.m.actuators)))


def way_bounds(way: Itinerary, nodes: Nodes, asked: float = 0.0) -> WayBounds:
    """The bounds of a way through nodes that are proved to lie on one branch, the first and the last of the way among
    them; no step from one to the next leads over a pose. The margin `asked` for is proved where that is possible.
    """
    m = way.m
    sigma = np.concatenate([margins(m, some.here).sigma for some in nodes.blocks()])
    met, at = float(sigma.min()), float(nodes.parameters[int(sigma.argmin())])
    places = np.array([sum(len(c.turns) for c in m.home.chains[: a.place]) + a.coordinate for a in m.actuators], int)
    least, low, high = np.full(len(way.courses), np.inf), np.full(len(places), np.inf), np.full(len(places), -np.inf)
    pieces = _Pieces(nodes.here[:-1], np.stack([nodes.parameters[:-1], nodes.parameters[1:]]))
    left = _MOST
    for halving in range(_HALVINGS + 1):
        again = []
        for some in blocks(pieces.ends.shape[1]):
            checkpoint()
            here, ends = pieces.here[some], pieces.ends[:, some]
            found = _bounds(way, here, ends)
            done = found.followed & (found.least >= aim_of(met, asked, _NEAR))
            if halving == _HALVINGS or left <= 0:
                done[:] = True
            if done.any():
                np.minimum.at(least, way.segments(ends[0, done]), found.least[done])
                low = np.minimum(low, found.low[done][:, places].min(axis=0))
                high = np.maximum(high, found.high[done][:, places].max(axis=0))
            left -= int((~done).sum())
            if not done.all():
                again.append(_halved(way, here[~done], ends[:, ~done]))
        if not again:
            break
        more = [a for a in again if a is not None]
        if len(more) < len(again):  # a middle is not reached
            return no_bounds(way)
        pieces = _Pieces(Configurations.together([p.here for p in more]), np.concatenate([p.ends for p in more], 1))
        sigma = np.concatenate([margins(m, pieces.here[some]).sigma for some in blocks(len(pieces.here))])
        if sigma.min() < met:
            met, at = float(sigma.min()), float(pieces.ends[0, int(sigma.argmin())])
    return WayBounds(least, met, at, np.stack([low, high], axis=1))


def _bounds(way: Itinerary, here: Configurations, ends: Floats) -> StepBounds:
    """Of steps to the solutions at their ends; of those that have none nothing is proved."""
    joints = close_loops(way.course, here, way.goals(ends[1]))
    found = bounds_of(way.m, way.course.target, Steps.of(here, joints, way.grown(*ends)))
    open_ = ~joints.closed
    return StepBounds(
        np.where(open_, 0.0, found.least),
        np.where(open_[:, None], -np.inf, found.low),
        np.where(open_[:, None], np.inf, found.high),
    )


def _halved(way: Itinerary, here: Configurations, ends: Floats) -> _Pieces | None:
    """Both halves of steps; None where a middle has no solution."""
    middle = ends.mean(axis=0)
    joints = close_loops(way.course, here, way.goals(middle))
    if not joints.closed.all():
        return None
    between = here.after(joints.amounts, joints.links)
    halves = np.concatenate([np.stack([ends[0], middle]), np.stack([middle, ends[1]])], axis=1)
    return _Pieces(Configurations.together([here, between]), halves)
