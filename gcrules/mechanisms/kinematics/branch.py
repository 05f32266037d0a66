r"""Whether steps of courses follow one branch of solutions, and cross no singular configuration: proofs, many at once.

The wanted pose is a chain like the limbs: slides along x, y, z, then turns about z, y, x for yaw, pitch, roll (for a
whole rotation vector one turn about it). Its wanted coordinates grow evenly, the others are unknown. So the loops of
all limbs and the wanted values are equations of one kind, and `tubes` proves that they have exactly one solution near
the straight way from one configuration to the next, and a continuous one; or near a configuration for all values of the
wanted coordinates within a box, a cell.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.arms import Arm, Spread, spreads
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates, wrapped
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Joints
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed, rotations
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.kinematics.tubes import Choice, follows, holds, keeps_rank
from gcrules.screws import RESIDUES
from gcrules.screws.pose_text import SHIFTS, TURNS, VECTOR

__all__ = ["Cells", "Steps", "are_regular", "can_be_followed", "follow_and_are_regular", "follow_branch", "tubes"]

Truths = NDArray[np.bool_]
Spreads = tuple[Spread, ...]

_ROOM = 1.0 + 1e-9  # for rounding of values within a cell
_KEPT = 16  # robots of which it is known what moves


@dataclass(frozen=True, eq=False)
class Steps:
    """N steps: the configurations where they begin, by how much the coordinates of each limb grow (N, n), where the
    platform is then (N, 4, 4), and by how much the wanted values grow (N, names).
    """

    here: Configurations
    amounts: tuple[Floats, ...]
    platform: Floats
    grown: Floats

    @classmethod
    def of(cls, here: Configurations, joints: Joints, grown: Floats) -> Steps:
        """The steps that joints make."""
        return cls(here, joints.amounts, joints.links[0][:, -1] @ here.platform, grown)

    def __getitem__(self, chosen: Any) -> Steps:
        """Those of an array of places, or a mask."""
        grown = tuple(a[chosen] for a in self.amounts)
        return Steps(self.here[chosen], grown, self.platform[chosen], self.grown[chosen])

    @classmethod
    def between(cls, here: Configurations, there: Configurations, grown: Floats) -> Steps:
        """The steps from configurations to others."""
        pairs = zip(here.joint_values, there.joint_values, strict=True)
        return cls(here, tuple(b - a for a, b in pairs), there.platform, grown)


def can_be_followed(m: Linkage, wanted: Target) -> bool:
    """Whether there are proofs for ways to what is wanted: not for one or two components of a rotation vector in
    space. In the plane rz is the yaw.
    """
    return m.robot.family.plane or sum(n in VECTOR for n in wanted.names) in (0, len(VECTOR))


def _without_vector(m: Linkage, wanted: Target) -> Target:
    """The same one, of a planar robot with the yaw in place of rz."""
    if not m.robot.family.plane or len(VECTOR) == sum(n in VECTOR for n in wanted.names):
        return wanted
    return replace(wanted, names=tuple("yaw" if n == "rz" else n for n in wanted.names))


def follow_branch(m: Linkage, wanted: Target, steps: Steps) -> Truths:
    """Whether it is proved (N,) that the solutions at the ends of a step lie on one branch: one curve of solutions,
    beside which there is no other one close to the straight way between them. False proves nothing.
    """
    return np.asarray(np.isfinite(tubes(m, wanted, steps)[0]).all(axis=-1))


def are_regular(m: Linkage, wanted: Target, steps: Steps) -> Truths:
    """Whether it is proved (N,) that the branch between two solutions meets no singular configuration: with the
    actuators locked neither the platform nor a link, but those that spin idly, can move anywhere on it. False proves
    nothing.
    """
    return follow_and_are_regular(m, wanted, steps)[1]


def follow_and_are_regular(m: Linkage, wanted: Target, steps: Steps) -> tuple[Truths, Truths]:
    """What `follow_branch` and `are_regular` give, at once. Steps that are regular follow the branch."""
    around, limbs = _tubes_and_limbs(m, wanted, steps)
    follow = np.asarray(np.isfinite(around[0]).all(axis=-1))
    if limbs is None:
        limbs = spreads(_arms(m, steps.here, steps.amounts))
    reach = [np.abs(a.amounts) / 2 + t for a, t in zip(limbs, around, strict=False)]
    return follow, follow & keeps_rank(limbs, _undriven(m).free, _undriven(m).idle, reach)


def tubes(m: Linkage, wanted: Target, steps: Steps) -> tuple[Floats, ...]:
    """How far the coordinates of each limb are from the straight way at most; infinite where nothing is proved."""
    return _tubes_and_limbs(m, wanted, steps)[0]


def _tubes_and_limbs(m: Linkage, wanted: Target, steps: Steps) -> tuple[tuple[Floats, ...], Spreads | None]:
    """The same, and the limbs in the middle of their ways where these were looked at by themselves."""
    if wanted.driven:
        limbs = spreads(_arms(m, steps.here, steps.amounts))
        return follows(limbs, _following(m).free, _following(m).idle), limbs
    if not can_be_followed(m, wanted):
        return tuple(np.full(a.shape, np.inf) for a in steps.amounts), None
    pose, grown, free = _pose_chain(m, _without_vector(m, wanted), steps)
    arms = _arms(m, steps.here, steps.amounts, (pose, grown))
    return follows(spreads(arms), [free, *_unlocked(m).free], _unlocked(m).idle)[1:], None


@dataclass(frozen=True, eq=False)
class Cells:
    """Boxes of wanted values around configurations: how far (N, n) the coordinates of each limb can be from those of
    the middle, infinite where it is not proved that there is one branch; `regular` (N,) where it is proved that no
    configuration of it is singular.
    """

    reach: tuple[Floats, ...]
    regular: Truths

    @classmethod
    def around(cls, m: Linkage, wanted: Target, here: Configurations, widths: Floats) -> Cells:
        """Of the values of the wanted coordinates, in the order of their names, that differ by no more than `widths`
        (N, names) from those of a configuration; coordinates with the width 0 have one value.
        """
        still = [np.zeros(a.shape) for a in here.joint_values]
        arms = _arms(m, here, still)
        limbs = spreads(arms)
        known = [np.zeros(a.shape) for a in still]
        if wanted.driven:
            for n, a in enumerate(leading(m)):
                known[a.place][:, a.coordinate] = widths[:, n] * _ROOM / (1.0 if a.angle else m.size)
            tubes = holds(limbs, _following(m).free, _following(m).idle, known)
            reach = [k + t for k, t in zip(known, tubes, strict=True)]
        else:
            wanted = _without_vector(m, wanted)
            places = Steps(here, tuple(still), here.platform, np.zeros(widths.shape))
            pose, grown, free = _pose_chain(m, wanted, places)
            order = _order(wanted)
            far = np.zeros(grown.shape)
            for n, name in enumerate(wanted.names):
                far[:, order.index(name)] = widths[:, n] * _ROOM / (m.size if name in SHIFTS else 1.0)
            chains = spreads(_arms(m, here, still, (pose, grown)))
            reach = list(holds(chains, [free, *_unlocked(m).free], _unlocked(m).idle, [far, *known])[1:])
        return cls(tuple(reach), keeps_rank(limbs, _undriven(m).free, _undriven(m).idle, reach))

    @property
    def one_branch(self) -> Truths:
        """Where it is proved that there is one."""
        return np.asarray(np.isfinite(self.reach[0]).all(axis=-1))


def _arms(
    m: Linkage, here: Configurations, amounts: Sequence[Floats], pose: tuple[Chain, Floats] | None = None
) -> list[Arm]:
    """The arms of all limbs, after that of the wanted pose, if there is one."""
    first = [pose] if pose else []
    chains, every = zip(*first, *zip(here.chains, amounts, strict=True), strict=True)
    return Arm.several(chains, every, _centre(m, here), m.size)


def _centre(m: Linkage, here: Configurations) -> Floats:
    return np.asarray(here.platform[:, :3, :3] @ m.centre + here.platform[:, :3, 3])


@dataclass(frozen=True, eq=False)
class _Moving:
    """Which coordinates of each limb move, and how many of their motions inside the limbs leave the platform at rest
    in the whole family.
    """

    free: tuple[Choice, ...]
    idle: int

    @classmethod
    def of(cls, m: Linkage, free: Sequence[Choice]) -> _Moving:
        places = [np.flatnonzero(own).tolist() for own in free]
        idle = sum(len(own) - limb.rank_of(own, RESIDUES) for own, limb in zip(places, m.generic, strict=True))
        return cls(tuple(free), idle)


@lru_cache(maxsize=_KEPT)
def _unlocked(m: Linkage) -> _Moving:
    """The coordinates that may move."""
    return _Moving.of(m, [~h for h in _coordinates(m, ((place, k) for place, k, _ in m.locked))])


@lru_cache(maxsize=_KEPT)
def _undriven(m: Linkage) -> _Moving:
    """The coordinates that may move at once with the actuators locked, those that have to stay at 0 among them."""
    return _Moving.of(m, [~d for d in _coordinates(m, ((a.place, a.coordinate) for a in m.actuators))])


@lru_cache(maxsize=_KEPT)
def _following(m: Linkage) -> _Moving:
    """The coordinates that follow when the robot is driven: they may move, and lead not."""
    lead = _coordinates(m, ((a.place, a.coordinate) for a in leading(m)))
    return _Moving.of(m, [u & ~a for u, a in zip(_unlocked(m).free, lead, strict=True)])


def _coordinates(m: Linkage, places: Iterator[tuple[int, int]]) -> list[Choice]:
    found: list[Choice] = [np.zeros(len(c.turns), dtype=bool) for c in m.home.chains]
    for place, k in places:
        found[place][k] = True
    return found


def _order(w: Target) -> tuple[str, ...]:
    """The coordinates of the pose as a chain, from the base; a rotation vector is one more turn."""
    return SHIFTS if any(n in VECTOR for n in w.names) else (*SHIFTS, *reversed(TURNS))


def _pose_chain(m: Linkage, w: Target, steps: Steps) -> tuple[Chain, Floats, Choice]:
    """The wanted pose as a chain, how much its coordinates grow, and which of them are free."""
    here, centre, number = steps.here, _centre(m, steps.here), len(steps.here)
    known = dict(zip(w.names, steps.grown.T, strict=True))
    order = _order(w)
    change = coordinates(order, steps.platform, m.centre) - coordinates(order, here.platform, m.centre)
    amounts = wrapped(order, change)
    for n, name in enumerate(order):
        amounts[:, n] = known.get(name, amounts[:, n])
    free = np.array([n not in known for n in order])
    axes = np.eye(3)
    if order == SHIFTS:
        turn = np.stack([known[n] for n in VECTOR], axis=1)
        length = np.linalg.norm(turn, axis=1, keepdims=True)
        about = np.where(length > 0, turn / np.where(length > 0, length, 1.0), axes[2])[:, None]
        amounts = np.concatenate([amounts, length], axis=1)
        free = np.append(free, False)
    else:
        pitch, yaw = coordinates(("pitch", "yaw"), here.platform, m.centre).T
        tilted = rotations(yaw[:, None] * axes[2])
        rolled = tilted @ rotations(pitch[:, None] * axes[1])
        about = np.stack([np.broadcast_to(axes[2], (number, 3)), tilted[..., 1], rolled[..., 0]], axis=1)
    count = 3 + about.shape[1]
    screws = np.zeros((number, count, 6))
    screws[:, :3, 3:] = axes
    screws[:, 3:, :3] = about
    screws[:, 3:, 3:] = crossed(centre[:, None], about)
    chain = Chain(screws, tuple(range(count)), np.ones(count), tuple(k > 2 for k in range(count)))
    return chain, amounts, free
