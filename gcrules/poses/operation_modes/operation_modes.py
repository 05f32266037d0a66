r"""The operation modes of a robot: the irreducible sets of poses that its limbs allow, their actuators free.

Each limb's equations are found by interpolation and taken apart by elimination with cases: over each irreducible set of
orientations where their rank is constant the poses are an irreducible stratum. A stratum is a mode unless it lies in a
larger one. Derived here; the parameters are those of Study's kinematic mapping.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, product
from random import Random
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import kernel, rank
from gcrules.core.seeds import drawn
from gcrules.mechanisms.kinematics.linkage import linkage as _linkage
from gcrules.mechanisms.load import Folders, Source, load
from gcrules.mechanisms.robot import Robot
from gcrules.poses.operation_modes.assemblies import STARTS, Membership
from gcrules.poses.operation_modes.assemblies import random_assemblies as _assemblies
from gcrules.poses.operation_modes.limb_constraints import (
    DEGREE,
    STUDY,
    Equation,
    LimbConstraints,
    codimension,
    gradient,
    limb_constraints,
    of_degree,
)
from gcrules.poses.operation_modes.motion_kinds import POSES, motion_in_words
from gcrules.poses.operation_modes.orientations import pieces
from gcrules.poses.operation_modes.random_poses import holds, random_pose
from gcrules.poses.operation_modes.rational_poses import HOME, common_pose, inside, witness
from gcrules.poses.operation_modes.report import Assemblies, OperationMode, OperationModes, Transition
from gcrules.poses.operation_modes.strata import PoseBundle, Stratum, rows_of, strata
from gcrules.poses.operation_modes.study import Motion, coupled, motions, velocities
from gcrules.screws import RATIONALS

__all__ = ["operation_modes"]

_NEAR = 1e-7


@dataclass(frozen=True)
class _Candidate:
    """A stratum with a few random poses, the equations of low degree that hold at them, and the dimension of the space
    tangent to what the limbs allow there.
    """

    bundle: PoseBundle
    poses: tuple[tuple[int, ...], ...]
    equations: tuple[Equation, ...]
    tangent: int

    @property
    def stratum(self) -> Stratum:
        return self.bundle.stratum

    @property
    def proper(self) -> bool:
        return self.tangent == self.stratum.dimension


def operation_modes(source: Source, *, plugins: Folders = ()) -> OperationModes:
    """The operation modes of a robot with its dimensions at home, in Study parameters x0 … x3, y0 … y3 of the platform;
    home is x0 = 1, all others 0.

    `source` is what `load` takes. Raises InputError for sources without joints or home, for limbs with bodies of their
    own and for screw joints; LimitReached for limbs of whose poses nothing is found that is linear in y and of a
    degree up to 4.
    """
    robot = load(source, plugins=plugins)
    if not isinstance(robot, Robot) or not robot.limbs:
        raise InputError("operation modes are those of robots of joints", hint="gcrules robot list shows such robots")
    moves = _exact_motions(robot)
    limbs = tuple(limb_constraints(limb.name, own) for limb, own in zip(robot.limbs, moves, strict=True))
    parts = [[one] if one.enough else _parts(robot, n, moves[n], one) for n, one in enumerate(limbs)]
    whole = all(one.enough for one in limbs)
    least = max(0, 6 - sum(6 - one.dimension for one in limbs)) if whole else 0
    random = drawn("operation modes", robot.id)
    candidates: list[_Candidate] = []
    for chosen in product(*parts):
        equations = [e for one in chosen for e in one.equations]
        found = {(s.orientations.basis, s.rows): s for s in strata(*rows_of(equations), least)}
        tangent = None if whole else _at_home(moves)
        candidates += [_candidate(s, equations, random, tangent) for s in found.values()]
    candidates.sort(key=lambda c: (-c.stratum.dimension, not inside(c.bundle, HOME)))
    kept: list[_Candidate] = []
    for one in candidates:
        checkpoint()
        if one.proper or not any(all(holds(other.bundle, p) for p in one.poses) for other in kept):
            kept.append(one)
    inside_of, assemblies = _assembled(robot, kept)
    equations = [e for one in limbs for e in one.equations]
    alone = whole and _alone_at_home(kept, equations)
    modes = tuple(_mode(n, one, inside_of[n - 1], alone) for n, one in enumerate(kept, 1))
    meets = tuple(_transition(a, b, kept) for a, b in combinations(range(len(kept)), 2))
    return OperationModes(robot, limbs, whole, least, modes, len(candidates) - len(kept), meets, assemblies)


def _exact_motions(robot: Robot) -> list[tuple[Motion, ...]]:
    if robot.home is None:
        raise InputError(f"{robot.id} has no home configuration, whose dimensions are needed", hint="add the key home")
    values = robot.values_at()
    for d in robot.family.definitions:
        if any(d.relation.residual(d.sort, RATIONALS, values, values[d.name])):
            raise InputError(
                f"home keeps the relation of {d.name} ({d.text}) only nearly, so its limbs are others in exact numbers",
                hint="leave out of home what the relations determine, or give fractions",
            )
    return [motions(limb, values) for limb in robot.limbs]


def _parts(robot: Robot, place: int, moves: Sequence[Motion], whole: LimbConstraints) -> list[LimbConstraints]:
    """Of a limb whose poses have no equations linear in y the parts that have: where two turns are coupled. Raises
    LimitReached where there are none.
    """
    found = [part for own in coupled(moves) if (part := limb_constraints(whole.name, own)).enough]
    largest = max((part.dimension for part in found), default=0)
    if not found:
        raise LimitReached(
            f"the poses of {whole.name} ({robot.limbs[place].chain}) are given by no equations linear in y0 … y3 of a"
            f" degree up to {DEGREE}, so the modes are not decomposed",
            hint="gcrules robot pose follows the mode in which home is",
        )
    return [part for part in found if part.dimension == largest]


def _at_home(moves: Sequence[Sequence[Motion]]) -> int:
    """The dimension of the space of the platform's twists that all limbs allow at home."""
    normals: list[Any] = []
    for own in moves:
        still = [Fraction(0)] * (1 + max((m.place for m in own), default=-1))
        normals += kernel([HOME, *velocities(own, still)], 8)
    return 6 - (rank([*normals, gradient(STUDY, HOME)]) - 1 if normals else 0)


def _candidate(one: Stratum, equations: Sequence[Equation], random: Random, at_home: int | None) -> _Candidate:
    """`at_home` is the dimension of the tangent space there where the equations are those of parts of limbs; then it is
    what bounds modes through home.
    """
    poses = tuple(random_pose(one, random) for _ in range(POSES))
    own: list[Equation] = []
    for degree in (1, 2):
        own += sorted(of_degree(degree, [STUDY, *own], lambda: random_pose(one, random)), key=_order)
    bundle = PoseBundle(one, (*one.rows, *rows_of(own)[0]))
    if at_home is None:
        tangent = 6 - codimension(equations, poses[0])
    else:
        tangent = at_home if inside(bundle, HOME) else 6
    return _Candidate(bundle, poses, tuple(own), tangent)


def _order(equation: Equation) -> tuple[bool, list[tuple[int, ...]]]:
    """Those without y come first, then as in a dictionary."""
    return any(equation[:4]), [
        (n, *(-k for k in e)) for n, form in enumerate(equation) for e in sorted(form, reverse=True)
    ]


def _alone_at_home(kept: Sequence[_Candidate], equations: Sequence[Equation]) -> bool:
    """Whether a mode through home has the dimension of the tangent space there: then it is the only one through home,
    which is a regular pose of the set of all.
    """
    tangent = 6 - (rank([gradient(e, HOME) for e in (STUDY, *equations)]) - 1)
    return any(inside(one.bundle, HOME) and one.stratum.dimension == tangent for one in kept)


def _mode(number: int, one: _Candidate, assembled: int, alone: bool) -> OperationMode:
    """`alone` says that no other mode goes through home than one of which that is seen."""
    at_home = inside(one.bundle, HOME)
    s = one.stratum
    shifting = 4 - len(s.rows)
    return OperationMode(
        number,
        s.dimension,
        s.orientations.dimension,
        shifting,
        motion_in_words(one.poses, s.orientations, shifting),
        one.equations,
        codimension(one.equations, one.poses[0]) == 6 - s.dimension,
        witness(one.bundle),
        False if at_home is None and alone else at_home,
        one.proper,
        s.orientations.prime,
        assembled,
    )


def _transition(a: int, b: int, kept: Sequence[_Candidate]) -> Transition:
    one, other = kept[a].bundle, kept[b].bundle
    shared = pieces([*one.stratum.orientations.basis, *other.stratum.orientations.basis])
    if not shared:
        return Transition((a + 1, b + 1), False, None)
    pose = common_pose(one, other, shared)
    return Transition((a + 1, b + 1), None if pose is None else True, pose)


def _assembled(robot: Robot, kept: Sequence[_Candidate]) -> tuple[list[int], Assemblies]:
    """How many random assemblies are in each mode, and how many in none."""
    m = _linkage(robot)
    found, closed, outside = [0] * len(kept), 0, 0
    member = [Membership(one.bundle) for one in kept]
    for pose in _assemblies(m):
        closed += 1
        inside_of = [own(pose, _NEAR * max(1.0, m.size)) for own in member]
        for n, yes in enumerate(inside_of):
            found[n] += yes is True
        outside += all(yes is False for yes in inside_of)
    return found, Assemblies(STARTS, closed, outside)
