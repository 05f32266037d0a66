r"""A robot's factors, margin and actuators as programs, where what they need has a closed form.

Each program is compared with the joints at configurations that were solved by Newton's method and proved to lie on
home's branch: at poses drawn anew in each process, which had no part in finding it. Both are analytic functions of
the pose where the robot is not singular, so that programs which differ anywhere would differ at almost all of these.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.seeds import drawn
from gcrules.mechanisms.kinematics.coordinates import principal
from gcrules.mechanisms.kinematics.margin import kept_axes, margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.closed_forms import ClosedForms, run
from gcrules.poses.compiling.limb_amounts import amounts
from gcrules.poses.compiling.limb_factors import traced_factors
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.limb_reach import placing_roots, reach_is_seen
from gcrules.poses.compiling.limb_wrenches import BalancedLines, balanced_lines, balanced_wrenches, plain_wrenches
from gcrules.poses.compiling.roots import NoForm, cosine_and_sine
from gcrules.poses.compiling.scalars import Ring
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.turns import TurnedBy
from gcrules.poses.limbs.many import Solved, proved_at
from gcrules.screws.pose_text import SHIFTS

__all__ = ["limb_places", "limb_programs", "solved_near_home", "wrench_forms"]

_POSES = 24  # from which closed forms are found, and as many with which they are compared
_REACHES = (0.1, 0.02, 0.005, 1e-3, 2e-4)  # in parts of the robot's size, and rad; about a far centre little is far
_EQUAL = 1e-9  # of values from −1 to 1


def limb_programs(m: Limbs, target: Target) -> ClosedForms:
    """The programs that are found and checked for coordinates of the platform; none for actuators."""
    places = limb_places(m, target)
    if places is None:
        return _none(m)
    factors = _lowered(places, lambda: traced_factors(m, places))
    return _checked(replace(_wrenches_and_actuators(m, places), factors=factors), target, m)


@dataclass(frozen=True)
class WrenchForms:
    """What the closed forms of a robot tell of its wrenches and limbs: `checked` programs of the margin and of the
    actuators, the `plain` wrenches, followed by all roots that place links, and the balanced `lines`; whether every
    limb reaches a pose in which these roots exist.
    """

    checked: ClosedForms
    plain: Program
    lines: BalancedLines
    reached: bool


def wrench_forms(m: Limbs, target: Target, turned_by: TurnedBy) -> WrenchForms | None:
    """The wrenches over coordinates of the platform; `turned_by` makes cosines and sines of angles. None where they
    have no closed form.
    """
    places = limb_places(m, target, turned_by)
    if places is None:
        return None
    roots, reached = placing_roots(m, places), reach_is_seen(m, places)
    found = _checked(_wrenches_and_actuators(m, places), target, m)
    if found.wrenches is None:
        return None
    return WrenchForms(found, plain_wrenches(m, places, roots), balanced_lines(m, places), reached)


def _none(m: Limbs) -> ClosedForms:
    return ClosedForms(columns=len(kept_axes(m.linkage)), turns=tuple(a.angle for a in m.linkage.actuators))


def limb_places(m: Limbs, target: Target, turned_by: TurnedBy = cosine_and_sine) -> LimbPlaces | None:
    """Where points and directions are over coordinates of the platform; None where they have no closed form."""
    if target.driven:
        return None
    found = solved_near_home(m, target, np.random.default_rng(0))
    try:
        return None if found is None else LimbPlaces(target.names, found[1], turned_by)
    except NoForm:
        return None


def _wrenches_and_actuators(m: Limbs, places: LimbPlaces) -> ClosedForms:
    wrenches = _lowered(places, lambda: tuple(c for row in balanced_wrenches(m, places) for c in row))
    return replace(_none(m), wrenches=wrenches, actuators=_lowered(places, lambda: amounts(places)))


def _lowered(places: LimbPlaces, of: Callable[[], tuple[Ring, ...]]) -> Program | None:
    try:
        return lower(places.graph, *of())
    except NoForm:
        return None


def _checked(made: ClosedForms, target: Target, mechanism: Limbs) -> ClosedForms:
    """Those that agree with the joints at other configurations."""
    seed = drawn("closed form", mechanism.robot.id, *target.names).getrandbits(64)
    check = solved_near_home(mechanism, target, np.random.default_rng(seed))
    if check is None:
        return _none(mechanism)
    poses, there = check
    m, factors, wrenches, actuators = mechanism.linkage, made.factors, made.wrenches, made.actuators
    if factors and not _agree(run(factors, "numpy", poses).T - there.factors):
        factors = None
    if wrenches and not _agree(made.margins("numpy", poses) - margins(m, there.here).sigma):
        wrenches = None
    if actuators:
        off = made.amounts("numpy", poses) - there.actuators
        actuators = actuators if _agree(np.where(made.turns, principal(off), off / m.size)) else None
    return replace(made, factors=factors, wrenches=wrenches, actuators=actuators)


def _agree(differences: Floats) -> bool:
    return bool(np.nan_to_num(np.abs(differences), nan=np.inf).max(initial=0.0) <= _EQUAL)


def solved_near_home(m: Limbs, target: Target, rng: np.random.Generator) -> tuple[Floats, Solved] | None:
    """Poses that are proved to be reached, and the configurations there."""
    units = np.array([m.linkage.size if n in SHIFTS else 1.0 for n in target.names])
    for reach in _REACHES:
        poses = rng.uniform(-reach, reach, (_POSES, len(units))) * units
        places, there = proved_at(m, target, poses)
        if len(places) > _POSES // 2:
            return poses[places], there
    return None
