r"""Which coordinates of a robot of joints stay free in its locus, and what the others are.

Its variables are coordinates of the platform, as many as it has freedoms: x, y, z, and for roll, pitch and yaw the
tangents of their halves, t_roll, t_pitch and t_yaw, in which cosines and sines are rational.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.solve import check_target, free_coordinates
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.loci.variables import half_tangents, read_fixed, read_free
from gcrules.screws.pose import Pose, exact
from gcrules.screws.pose_text import SHIFTS, TURNS, Amount, check_known, read_named

__all__ = ["TANGENTS", "LimbQuestion", "limb_question", "variable"]

_TANGENT = "t_"
TANGENTS = tuple(_TANGENT + n for n in TURNS)
"""The variables of the turn."""


@dataclass(frozen=True)
class LimbQuestion:
    """The `coordinates` that determine the pose, the variables that are `free`, in that order, and the values of the
    `fixed` ones, exact, of which those of the names in `rounded` stand for tangents that are not rational.
    """

    coordinates: tuple[str, ...]
    free: tuple[str, ...]
    fixed: Mapping[str, Fraction]
    rounded: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "fixed", FrozenMap(self.fixed))

    @property
    def variables(self) -> tuple[str, ...]:
        """Those of all coordinates, in their order."""
        return tuple(map(variable, self.coordinates))


def variable(coordinate: str) -> str:
    """The name of the variable of a coordinate.

    >>> variable("x"), variable("yaw")
    ('x', 't_yaw')
    """
    return coordinate if coordinate in SHIFTS else _TANGENT + coordinate


def limb_question(
    m: Linkage,
    over: str | Sequence[str] | None,
    fix: str | Mapping[str, Any] | None,
    at: str | Mapping[str, Any] | Pose | None,
    rotation: str,
) -> LimbQuestion:
    """What is asked for: as for six legs, but that coordinates have their names; what is neither free nor given is 0.

    Raises InputError for unknown names, names given twice, coordinates that do not determine the pose, and where
    nothing is left free.
    """
    if rotation not in ("quaternion", "ZYX"):
        raise InputError(
            f"the turn of {m.robot.id} has no variables {rotation[:20]!r} here",
            hint="leave --rotation out: the variables are t_roll, t_pitch and t_yaw, tangents of half the angles",
        )
    every = [variable(n) for n in (*SHIFTS, *TURNS)]
    named = {n: (variable(n),) for n in TURNS}
    fixed = read_fixed(fix, every)
    there, rounded = _at(m, at)
    base = tuple(map(variable, free_coordinates(m)))
    shifts = [n for n in base if n in SHIFTS]
    groups = {"translation": shifts, "rotation": [n for n in base if n not in SHIFTS], "all": base}
    asked = [] if over is None else read_free(over, every, groups | named)
    coordinates = _coordinates(m, base, dict.fromkeys((*asked, *fixed, *there)))
    free = asked if over is not None else [n for n in coordinates if n not in fixed and n not in there]
    both = [n for n in free if n in fixed or n in there]
    if both or (both := [n for n in fixed if n in there]):
        raise InputError(f"{', '.join(both)} cannot be given twice, or free and fixed")
    if not free:
        raise InputError("no variable is left free", hint=f"the variables are {', '.join(coordinates)}")
    rest = {n: fixed.get(n, there.get(n, Fraction(0))) for n in coordinates if n not in free}
    names = tuple(n.removeprefix(_TANGENT) for n in coordinates)
    return LimbQuestion(names, tuple(n for n in coordinates if n in free), rest, rounded)


def _coordinates(m: Linkage, base: tuple[str, ...], named: Mapping[str, Any]) -> tuple[str, ...]:
    """Those that are named with as many of the free ones as determine the pose."""
    if set(named) <= set(base):
        return base
    first = [n.removeprefix(_TANGENT) for n in named]
    chosen = free_coordinates(m, first) if len(first) < m.robot.mobility else tuple(first)
    lost = [n for n in first if n not in chosen]
    if lost:
        raise InputError(
            f"{', '.join(lost)} follows from other coordinates of {m.robot.id}",
            hint=f"independent there are, for example, {', '.join(free_coordinates(m))}",
        )
    check_target(m, Target(chosen, np.zeros(len(chosen))))
    return tuple(variable(n) for n in (*SHIFTS, *TURNS) if n in chosen)


def _at(m: Linkage, at: str | Mapping[str, Any] | Pose | None) -> tuple[dict[str, Fraction], tuple[str, ...]]:
    """The values of variables at a pose, and which of these are rounded."""
    if at is None:
        return {}, ()
    names = (*SHIFTS, *TURNS)
    if not isinstance(at, str | Mapping) or (isinstance(at, str) and "=" not in at):
        raise InputError(
            "the locus of a robot of joints takes coordinates by their names", hint='write "z=1/2, yaw=30deg"'
        )
    if isinstance(at, str):
        given: Mapping[str, Any] = read_named(at, {n: n in TURNS for n in names}, m.robot.units)
    else:
        check_known(at, names, "coordinate of a pose")
        given = {n: Amount(exact(v, n)) for n, v in at.items()}
    tangents, rounded = half_tangents({variable(n): v for n, v in given.items() if n not in SHIFTS})
    return {variable(n): tangents.get(variable(n), v.number) for n, v in given.items()}, rounded
