r"""The operation modes of a robot: the irreducible sets of poses that its limbs allow, their actuators free.

Each limb's equations are found by interpolation and taken apart by elimination with cases: over each irreducible set of
orientations where their rank is constant the poses are an irreducible stratum. A stratum is a mode unless it lies in a
larger one. Derived here; the parameters are those of Study's kinematic mapping.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from random import Random
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import rank
from gcrules.core.seeds import PRIME, drawn
from gcrules.mechanisms.load import Folders, Source, load
from gcrules.mechanisms.robot import Robot
from gcrules.poses.operation_modes.limb_constraints import (
    DEGREE,
    STUDY,
    Equation,
    LimbConstraints,
    codimension,
    gradient,
    limb_constraints,
    of_degree,
    value,
)
from gcrules.poses.operation_modes.motion_kinds import POSES, motion_in_words
from gcrules.poses.operation_modes.orientations import pieces
from gcrules.poses.operation_modes.random_poses import at_residues, independent, random_pose
from gcrules.poses.operation_modes.rational_poses import HOME, common_pose, inside, witness
from gcrules.poses.operation_modes.report import Assemblies, OperationMode, OperationModes, Transition
from gcrules.poses.operation_modes.strata import Stratum, rows_of, strata

__all__ = ["operation_modes"]

_linkage = deferred("gcrules.mechanisms.kinematics.linkage:linkage")  # numpy
_assemblies = deferred("gcrules.poses.operation_modes.assemblies:random_assemblies")
_parameters = deferred("gcrules.poses.operation_modes.assemblies:study_parameters")

_NEAR = 1e-7


@dataclass(frozen=True)
class _Candidate:
    """A stratum with a few random poses and the equations of low degree that hold at them; None of a stratum of which
    no random poses are to be had.
    """

    stratum: Stratum
    poses: tuple[tuple[int, ...], ...]
    equations: tuple[Equation, ...]
    tangent: int


def operation_modes(source: Source, *, plugins: Folders = ()) -> OperationModes:
    """The operation modes of a robot with its dimensions at home, in Study parameters x0 … x3, y0 … y3 of the platform;
    home is x0 = 1, all others 0.

    `source` is what `load` takes. Raises InputError for sources without joints or home, for limbs with bodies of their
    own and for screw joints; LimitReached for limbs whose equations are not linear in y, or of a degree above 4.
    """
    robot = load(source, plugins=plugins)
    if not isinstance(robot, Robot) or not robot.limbs:
        raise InputError("operation modes are those of robots of joints", hint="gcrules robot list shows such robots")
    limbs = tuple(_constraints(robot))
    rows, forms = rows_of([e for one in limbs for e in one.equations])
    least = max(0, 6 - sum(6 - one.dimension for one in limbs))
    random = drawn("operation modes", robot.id)
    equations = [e for one in limbs for e in one.equations]
    candidates = [_candidate(s, equations, random) for s in _distinct(strata(rows, forms, least))]
    candidates.sort(key=lambda c: -c.stratum.dimension)
    chosen: list[_Candidate] = []
    for one in candidates:
        checkpoint()
        if not any(_lies_in(one, other) for other in chosen):
            chosen.append(one)
    chosen.sort(key=lambda c: (-c.stratum.dimension, not inside(c.stratum, HOME)))
    found, assemblies = _assembled(robot, chosen)
    modes = tuple(_mode(n, one, found[n - 1]) for n, one in enumerate(chosen, 1))
    meets = tuple(_transition(a, b, chosen) for a, b in combinations(range(len(chosen)), 2))
    return OperationModes(robot, limbs, least, modes, len(candidates) - len(chosen), meets, assemblies)


def _constraints(robot: Robot) -> Sequence[LimbConstraints]:
    if robot.home is None:
        raise InputError(f"{robot.id} has no home configuration, whose dimensions are needed", hint="add the key home")
    values = robot.values_at()
    for d in robot.family.definitions:
        if any(d.relation.residual(d.sort, _exact(), values, values[d.name])):
            raise InputError(
                f"home keeps the relation of {d.name} ({d.text}) only nearly, so its limbs are others in exact numbers",
                hint="leave out of home what the relations determine, or give fractions",
            )
    found = []
    for limb in robot.limbs:
        one = limb_constraints(limb, values)
        if not one.enough:
            raise LimitReached(
                f"the poses of {limb.name} ({limb.chain}) are given by no equations of a degree up to {DEGREE} that are linear"
                " in y0 … y3, so their modes are not taken apart",
                hint="gcrules robot pose follows the mode in which home is",
            )
        found.append(one)
    return found


def _exact() -> Any:
    from gcrules.screws import RATIONALS

    return RATIONALS


def _distinct(found: Any) -> list[Stratum]:
    """The strata, without those of equal orientations and rows."""
    kept: dict[Any, Stratum] = {}
    for s in found:
        kept.setdefault((s.orientations.basis, s.rows), s)
    return list(kept.values())


def _candidate(one: Stratum, equations: Sequence[Equation], random: Random) -> _Candidate:
    poses = tuple(random_pose(one, random) for _ in range(POSES))
    tangent = 6 - (rank([gradient(e, poses[0], PRIME) for e in (STUDY, *equations)], PRIME) - 1)
    own: list[Equation] = []
    for degree in (1, 2):
        own += of_degree(degree, [STUDY, *own], lambda: random_pose(one, random))
    return _Candidate(one, poses, tuple(own), tangent)


def _lies_in(one: _Candidate, other: _Candidate) -> bool:
    """Whether one is seen to lie in the closure of the other, at random poses."""
    if one.tangent == one.stratum.dimension:
        return False
    s = other.stratum
    return all(_holds(s, p) for p in one.poses)


def _holds(s: Stratum, pose: Sequence[int]) -> bool:
    x, y = pose[:4], (*pose[4:], 1)
    if any(at_residues(f, x) for f in s.orientations.basis) or not independent(s.rows, x):
        return False
    return not any(sum(at_residues(f, x) * b for f, b in zip(row, y, strict=True)) % PRIME for row in s.rows)


def _mode(number: int, one: _Candidate, assembled: int) -> OperationMode:
    s = one.stratum
    shifting = 4 - len(s.rows)
    at_home = True if inside(s, HOME) else False if any(value(e, HOME) for e in one.equations) else None
    return OperationMode(
        number,
        s.dimension,
        s.orientations.dimension,
        shifting,
        motion_in_words(one.poses, s.orientations, shifting),
        one.equations,
        codimension(one.equations, one.poses[0]) == 6 - s.dimension,
        witness(s),
        at_home,
        one.tangent == s.dimension,
        s.orientations.prime,
        assembled,
    )


def _transition(a: int, b: int, chosen: Sequence[_Candidate]) -> Transition:
    one, other = chosen[a].stratum, chosen[b].stratum
    shared = pieces([*one.orientations.basis, *other.orientations.basis])
    if not shared:
        return Transition((a + 1, b + 1), False, None)
    pose = common_pose(one, other, shared)
    return Transition((a + 1, b + 1), None if pose is None else True, pose)


def _assembled(robot: Robot, chosen: Sequence[_Candidate]) -> tuple[list[int], Assemblies]:
    """How many random assemblies are in each mode, and how many in none."""
    m = _linkage(robot)
    inside_of, tried, outside = [0] * len(chosen), 0, 0
    for place in _assemblies(m):
        tried += 1
        pose = _parameters(place, [float(c) for c in m.origin]).tolist()
        near = [n for n, one in enumerate(chosen) if all(_size(e, pose) <= _NEAR * m.size for e in one.equations)]
        for n in near:
            inside_of[n] += 1
        outside += not near
    from gcrules.poses.operation_modes.assemblies import STARTS

    return inside_of, Assemblies(STARTS, tried, outside)


def _size(equation: Equation, pose: Sequence[float]) -> float:
    largest = max((abs(c) for form in equation for c in form.values()), default=Fraction(1))
    return abs(float(value(equation, pose))) / float(largest)
