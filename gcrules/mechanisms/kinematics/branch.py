r"""Whether one step of a course follows one branch of solutions, and crosses no singular configuration: proofs.

The wanted pose is a chain like the limbs: slides along x, y, z, then turns about z, y, x for yaw, pitch, roll (for a
whole rotation vector one turn about it). Its wanted coordinates grow evenly, the others are unknown. So the loops of
all limbs and the wanted values are equations of one kind, and `tubes` proves that they have exactly one solution near
the straight way from one configuration to the next, and a continuous one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.coordinates import coordinates, wrapped
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, rotations
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.kinematics.tubes import Arm, Choice, Spread, follows, keeps_rank, spreads
from gcrules.screws.pose_text import SHIFTS, TURNS, VECTOR

__all__ = ["Move", "can_be_followed", "follows_branch", "is_regular"]

Parts = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Move:
    """The way from a configuration: by how much the coordinates of each limb grow, and where the platform is then."""

    here: Configuration
    amounts: tuple[Floats, ...]
    platform: Floats

    @classmethod
    def between(cls, here: Configuration, there: Configuration) -> Move:
        """The way from one configuration to another one."""
        pairs = zip(here.joint_values, there.joint_values, strict=True)
        return cls(here, tuple(b - a for a, b in pairs), there.platform)


def can_be_followed(wanted: Target) -> bool:
    """Whether there are proofs for ways to what is wanted: not for one or two components of a rotation vector."""
    return sum(n in VECTOR for n in wanted.names) in (0, len(VECTOR))


def follows_branch(m: Linkage, wanted: Target, move: Move, parts: Parts) -> bool:
    """Whether it is proved that the solutions at two parts of the way lie on one branch: one curve of solutions, beside
    which there is no other one close to the straight way between them. False proves nothing.
    """
    return _Step(m, wanted, move, parts).tube is not None


def is_regular(m: Linkage, wanted: Target, move: Move, parts: Parts) -> bool:
    """Whether it is proved that the branch between two solutions meets no singular configuration: with the actuators
    locked neither the platform nor a link, but those that spin idly, can move anywhere on it. False proves nothing.
    """
    step = _Step(m, wanted, move, parts)
    near = step.tube
    if near is None:
        return False
    near = near if wanted.driven else near[1:]
    return keeps_rank(step.limbs, step.passive, step.passive_idle, near)


class _Step:
    """The way between two solutions as a tube around a straight one."""

    def __init__(self, m: Linkage, wanted: Target, move: Move, parts: Parts) -> None:
        here = move.here
        centre = here.platform[:3, :3] @ m.centre + here.platform[:3, 3]
        arms = [Arm.of(c, a, centre, m.size) for c, a in zip(here.chains, move.amounts, strict=True)]
        held = _coordinates(m, ((place, k) for place, k, _ in m.locked))
        driven = _coordinates(m, ((a.place, a.coordinate) for a in m.actuators))
        self.passive = [~(h | d) for h, d in zip(held, driven, strict=True)]
        moving = [int((~h).sum()) for h in held]
        self.idle = _left(moving, m.ranks)
        self.passive_idle = _left([int(p.sum()) for p in self.passive], m.passive_ranks)
        self.limbs: tuple[Spread, ...] = spreads(arms)
        self.tube: tuple[Floats, ...] | None
        pose = None if wanted.driven else _pose_arm(m, wanted, move, parts, centre)
        if wanted.driven:
            self.tube = follows(self.limbs, self.passive, self.passive_idle)
        elif pose is None:
            self.tube = None
        else:
            arm, free = pose
            self.tube = follows(spreads([arm, *arms]), [free, *(~h for h in held)], self.idle)


def _left(moving: Sequence[int], ranks: Sequence[int]) -> int:
    """How many motions inside the limbs always leave the platform at rest; never too many, but of limbs with
    coordinates that stay at 0 perhaps too few.
    """
    return sum(max(0, n - rank) for n, rank in zip(moving, ranks, strict=True))


def _coordinates(m: Linkage, places: Iterator[tuple[int, int]]) -> list[Choice]:
    found: list[Choice] = [np.zeros(len(c.turns), dtype=bool) for c in m.home.chains]
    for place, k in places:
        found[place][k] = True
    return found


def _pose_arm(m: Linkage, w: Target, move: Move, parts: Parts, centre: Floats) -> tuple[Arm, Choice] | None:
    """The wanted pose as a chain, and which of its coordinates are free; None where it is none."""
    here = move.here
    grown = (parts[1] - parts[0]) * w.values
    known = dict(zip(w.names, grown, strict=True))
    if not can_be_followed(w):
        return None
    vector = any(n in VECTOR for n in w.names)
    turns = SHIFTS if vector else (*SHIFTS, *TURNS)
    change = coordinates(turns, move.platform, m.centre) - coordinates(turns, here.platform, m.centre)
    amounts = wrapped(turns, change)
    free = np.array([n not in known for n in turns])
    amounts = np.where(free, amounts, [known.get(n, 0.0) for n in turns])
    axes = [np.eye(3)[k] for k in range(3)]
    slides = [np.concatenate([np.zeros(3), axis]) for axis in axes]
    if vector:
        turn = np.array([known[n] for n in VECTOR])
        length = float(np.linalg.norm(turn))
        about = [turn / length if length else axes[2]]
        amounts, free = np.append(amounts, length), np.append(free, False)
    else:
        pitch, yaw = coordinates(("pitch", "yaw"), here.platform, m.centre)
        tilted = rotations(np.array([0, 0, yaw]))
        about = [axes[2], tilted @ axes[1], tilted @ rotations(np.array([0, pitch, 0])) @ axes[0]]
        order = [0, 1, 2, 5, 4, 3]
        amounts, free = amounts[order], free[order]
    screws = [*slides, *(np.concatenate([axis, np.cross(centre, axis)]) for axis in about)]
    count = len(screws)
    chain = Chain(np.array(screws), tuple(range(count)), np.ones(count), tuple(k > 2 for k in range(count)))
    return Arm.of(chain, amounts, centre, m.size), free
