r"""Exact worked poses of a structure: one that is singular and one that is not, with rational coordinates."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr
from gcrules.frozen import FrozenMap
from gcrules.legs import Structure

__all__ = ["WorkedPose", "regular_pose", "singular_pose"]

Coordinate = int | Fraction
Pose = dict[str, tuple[Coordinate, Coordinate, Coordinate, Coordinate]]

_TRIES = 16
_SIZE = 4


@dataclass(frozen=True)
class WorkedPose:
    """Homogeneous coordinates (x, y, z, 1) of every joint, exact, and the superbracket's value there."""

    points: Mapping[str, tuple[Coordinate, Coordinate, Coordinate, Coordinate]]
    value: Fraction


def regular_pose(structure: Structure, avoid: tuple[Expr, ...] = ()) -> WorkedPose:
    """The first of the small whole poses tried at which neither the superbracket nor any of `avoid` vanishes."""
    for pose in _whole_poses(structure):
        value = Fraction(evaluate(structure.superbracket, pose))
        if value and all(evaluate(e, pose) for e in avoid):
            return WorkedPose(FrozenMap(pose), value)
    raise ValueError("the structure is singular in every pose that was tried")


def singular_pose(structure: Structure, avoid: tuple[Expr, ...] = ()) -> WorkedPose:
    """The singular pose with the smallest numbers among those found by moving one joint.

    A joint with two legs is moved along one of them: that leg's line stays, so the superbracket is linear in the motion
    and has one exact zero. A joint with a single leg is moved along x. `avoid` lists expressions that must not vanish
    there (cofactors). Raises ValueError if none is found.
    """
    number = Counter(n for leg in structure.legs for n in leg)
    along = [(a, b) for leg in structure.legs for a, b in (leg, leg[::-1]) if number[a] == 2]
    moves: list[tuple[str, str | None]] = [*along, *((n, None) for n in structure.names if number[n] == 1)]
    candidates: list[tuple[int, int, Pose]] = []
    for pose in _whole_poses(structure):
        value = Fraction(evaluate(structure.superbracket, pose))
        for joint, other in moves if value else ():
            moved = _to_zero(structure, pose, value, joint, other)
            if moved and len(set(moved.values())) == len(moved):
                candidates.append((_height(moved), len(candidates), moved))
    for _, _, pose in sorted(candidates):
        if evaluate(structure.superbracket, pose) == 0 and all(evaluate(e, pose) for e in avoid):
            return WorkedPose(FrozenMap(pose), Fraction(0))
    raise ValueError("no singular pose was found")


def _to_zero(structure: Structure, pose: Pose, value: Fraction, joint: str, other: str | None) -> Pose | None:
    """Move a joint towards another (or along x) to where the superbracket, here `value` and linear in the motion,
    vanishes.
    """
    start = pose[joint]
    step = tuple(e - s for s, e in zip(start, pose[other], strict=True)) if other else (1, 0, 0, 0)

    def at(t: Coordinate) -> Pose:
        x, y, z, w = (s + t * d for s, d in zip(start, step, strict=True))
        return {**pose, joint: (x, y, z, w)}

    # Along its own leg the joint stretches that leg's coordinates by 1 − t, which is taken out: the rest is linear.
    moved = Fraction(evaluate(structure.superbracket, at(-1)), 2 if other else 1)
    return at(value / (moved - value)) if moved != value else None


def _whole_poses(structure: Structure) -> Iterator[Pose]:
    """Small whole poses with the platform above the base and no two joints alike, the same in every run."""
    rng = random.Random(2008)
    high = set(structure.platform)
    for _ in range(_TRIES):
        pose = {}
        for n in structure.names:
            z = rng.randint(3, 5) if n in high else rng.randint(0, 1)
            pose[n] = (rng.randint(-_SIZE, _SIZE), rng.randint(-_SIZE, _SIZE), z, 1)
        if len(set(pose.values())) == len(pose):
            yield dict(pose)


def _height(pose: Pose) -> int:
    return max(max(abs(c.numerator), c.denominator) for point in pose.values() for c in point)
