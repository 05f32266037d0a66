"""A plan for a robot of joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import zip_longest
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.path import path_targets
from gcrules.poses.methods import legs_within
from gcrules.poses.plans.domain import Place
from gcrules.poses.plans.leg_problem import LegProblem, leg_problem
from gcrules.poses.plans.limb_domain import LimbDomain, limb_space
from gcrules.poses.plans.problem import margin_kept
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.signs.sign import ConditionSign, opposite
from gcrules.screws.pose_text import SHIFTS, TURNS

__all__ = ["LimbProblem", "limb_problem"]

_DOUBT = "that the straight ways from home follow one branch to start and goal is not proved, so no sign excludes a way"
_ELSEWHERE = "the straight way from home does not lead to the goal, so it is known by its pose alone"


@dataclass(frozen=True, eq=False)
class LimbProblem:
    """A `Problem`: coordinates of the platform; the `roots` are the states of the start and, where the straight way
    from home leads there, of the goal. That they lie on one branch of it is `sure`, or not.
    """

    domain: LimbDomain
    start: Waypoint
    goal: Waypoint
    roots: Floats
    sure: bool
    notes: tuple[str, ...]
    whereto: str = "the configuration at the goal to which the straight way from home leads"

    @property
    def end(self) -> Floats:
        return self.domain.unsolved(self.goal)

    def opposed(self) -> tuple[tuple[ConditionSign, ConditionSign], ...]:
        if len(self.roots) < 2 or not self.sure:
            return ()
        ends = zip((self.start, self.goal), self.roots, strict=True)
        return opposite(*(self.domain.signs(Place(pose, row)) for pose, row in ends))


def limb_problem(
    m: Limbs, start: Any, goal: Any, asked: float, limits: str | None, within: str | None
) -> LimbProblem | LegProblem:
    """What is asked for; of a robot whose limbs are six legs by its platform. Raises InputError where start or goal do
    not keep to it.
    """
    if (legs := legs_within(m, limits)) is not None:
        return leg_problem(legs, start, goal, asked, limits, within)
    k = m.linkage
    first, last = path_targets(k, [start, goal])
    found = [solve(k, first)]
    check_target(k, last)
    try:
        found.append(solve(k, last))
    except InputError:
        if last.whole is not None:
            raise
    notes = list(k.notes)
    sure = all(one.doubt is None for one in found)
    if len(found) < 2:
        notes.append(_ELSEWHERE)
    elif not sure:
        notes.append(_DOUBT)
    configurations = [one.configuration for one in found]
    names = first.names if first.whole is None else (*SHIFTS, *TURNS)
    poses = [_pose(k, names, t, c) for t, c in zip_longest((first, last), configurations)]
    bare = limb_space(m, names, poses, 0.0, limits, within)
    roots = np.stack([bare.row_of(c) for c in configurations])
    space = replace(bare, margin=margin_kept(bare, roots, asked))
    return LimbProblem(LimbDomain(m, asked, space), poses[0], poses[1], roots, sure, tuple(notes))


def _pose(m: Linkage, names: Sequence[str], given: Target, c: Configuration | None) -> Mapping[str, float]:
    """The coordinates as they are given, or of a whole pose those of its configuration."""
    if given.whole is None:
        return FrozenMap(zip(given.names, given.values.tolist(), strict=True))
    assert c is not None
    place = without_rounding(names, coordinates(names, c.platform[None], m.centre)[0], m.size)
    return FrozenMap((n, float(f"{v:.12g}")) for n, v in zip(names, place.tolist(), strict=True))
