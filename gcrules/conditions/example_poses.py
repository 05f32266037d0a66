r"""Exact worked poses of a structure: singular ones and others, with small rational coordinates."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import lcm

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.core.dataclass import dataclass
from gcrules.core.floats import int_if_whole
from gcrules.core.frozen import FrozenMap

__all__ = ["WorkedPose", "regular_poses", "singular_pose", "singular_poses"]

Coordinate = int | Fraction
Position = tuple[Coordinate, Coordinate, Coordinate]
Shape = Mapping[str, Sequence[float]]

_TRIES = 1000
_ENOUGH = 60  # singular poses from which to take those with the smallest numbers
_SIZE = 5
_LARGEST = 40  # of numerators and denominators in a worked pose
_TILTS = ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))  # halves: a platform rises by one unit over two


@dataclass(frozen=True)
class WorkedPose:
    """Homogeneous coordinates (x, y, z, 1) of every joint, exact, and the superbracket's value there."""

    points: Mapping[str, tuple[Coordinate, Coordinate, Coordinate, Coordinate]]
    value: Fraction

    @property
    def height(self) -> int:
        """The largest numerator or denominator that occurs."""
        return max(max(abs(c.numerator), c.denominator) for point in self.points.values() for c in point)


def singular_pose(structure: Structure, avoid: tuple[Expr, ...] = (), shape: Shape | None = None) -> WorkedPose:
    """The first of the `singular_poses`. Raises ValueError where there is none among those that are tried."""
    found = next(singular_poses(structure, avoid, shape), None)
    if found is None:
        raise ValueError("no singular pose was found")
    return found


def regular_poses(
    structure: Structure, avoid: tuple[Expr, ...] = (), shape: Shape | None = None
) -> Iterator[WorkedPose]:
    """Small poses at which neither the superbracket nor any of `avoid` vanishes, in the same sequence in every run.

    They stay near `shape` (Cartesian coordinates of size about 1 for each joint), if it is given.
    """
    for pose in _starts(structure, shape):
        points = _homogeneous(pose)
        value = Fraction(evaluate(structure.superbracket, points))
        if value and all(evaluate(e, points) for e in avoid):
            yield WorkedPose(points, value)


def singular_poses(
    structure: Structure, avoid: tuple[Expr, ...] = (), shape: Shape | None = None
) -> Iterator[WorkedPose]:
    """Singular poses found by moving one joint of a start, those with the smallest numbers first.

    A joint with two legs is moved along one of them: that leg's line stays, so the superbracket is linear in the motion
    and has one exact zero. A joint with a single leg is moved towards another joint of its body, in whose plane it
    stays, or upright. `avoid` lists expressions that must not vanish there (cofactors).
    """
    candidates: list[tuple[int, int, WorkedPose]] = []
    moves = _moves(structure)
    for pose in _starts(structure, shape):
        whole = {n: (int(2 * x), int(2 * y), int(2 * z)) for n, (x, y, z) in pose.items()}  # starts have halves
        gradient = _gradient(structure.legs, whole)
        for joint, leg, direction in moves if gradient else ():
            t = _to_zero(structure.legs, whole, gradient, joint, leg, direction)
            if t is None or t.denominator > _LARGEST * _SIZE:
                continue
            place = _moved(pose, joint, direction, t)
            if all(_apart(place, p, 1) for n, p in pose.items() if n != joint):  # the others are, from the start
                moved = {**pose, joint: place}
                found = WorkedPose(_homogeneous(moved), Fraction(0))
                if found.height <= _LARGEST and _above(structure, moved):
                    candidates.append((found.height, len(candidates), found))
        if len(candidates) >= _ENOUGH:
            break
    for _, _, found in sorted(candidates, key=lambda c: c[:2]):
        points = _whole(found.points)
        if evaluate(structure.superbracket, points) == 0 and all(evaluate(e, points) for e in avoid):
            yield found


Pose = dict[str, Position]


def _homogeneous(pose: Pose) -> Mapping[str, tuple[Coordinate, Coordinate, Coordinate, Coordinate]]:
    return FrozenMap({n: (x, y, z, 1) for n, (x, y, z) in pose.items()})


def _whole(points: Mapping[str, Sequence[Coordinate]]) -> dict[str, list[int]]:
    """The same points with whole coordinates: what vanishes is told much faster without fractions."""
    scales = {n: lcm(*(c.denominator for c in point)) for n, point in points.items()}
    return {n: [int(c * scales[n]) for c in point] for n, point in points.items()}


def _moves(structure: Structure) -> list[tuple[str, int, str | None]]:
    """(joint, the leg there whose line changes, the point to move it towards; None is upright)."""
    number = Counter(n for leg in structure.legs for n in leg)
    moves: list[tuple[str, int, str | None]] = []
    for joint in structure.names:
        there = [i for i, leg in enumerate(structure.legs) if joint in leg]
        if number[joint] == 2:
            moves += [(joint, i, _end(structure.legs[j], joint)) for i, j in (there, there[::-1])]
        elif number[joint] == 1:
            side = structure.sides.get(joint, "")
            body = [n for n in structure.names if n != joint and structure.sides.get(n, "") == side]
            moves += [(joint, there[0], n) for n in (*body, None)]
    return moves


def _end(leg: Leg, start: str) -> str:
    return leg[1] if leg[0] == start else leg[0]


def _to_zero(
    legs: Sequence[Leg],
    pose: Mapping[str, tuple[int, int, int]],
    gradient: Sequence[Sequence[int]],
    joint: str,
    leg: int,
    other: str | None,
) -> Fraction | None:
    """How far to move a joint (1 is all the way) until the superbracket vanishes; None if it never does.

    It is linear in the motion, as only the row of one leg changes (that of the leg along which it moves is stretched).
    """
    before, change = (
        sum(r * g for r, g in zip(row, gradient[leg], strict=True))
        for row in (
            _row(pose[joint], pose[_end(legs[leg], joint)]),
            _row_of_motion(_step(pose, joint, other), pose[_end(legs[leg], joint)]),
        )
    )
    return Fraction(-before, change) if change else None


def _step(pose: Mapping[str, Sequence[Coordinate]], joint: str, other: str | None) -> Sequence[Coordinate]:
    return [e - s for s, e in zip(pose[joint], pose[other], strict=True)] if other else (0, 0, 2)


def _moved(pose: Pose, joint: str, other: str | None, t: Fraction) -> Position:
    x, y, z = (int_if_whole(s + t * d) for s, d in zip(pose[joint], _step(pose, joint, other), strict=True))
    return x, y, z


def _above(structure: Structure, pose: Pose) -> bool:
    """Whether the platform is above the base."""
    low, high = ([pose[n][2] for n in side] for side in (structure.base, structure.platform))
    return not (low and high) or max(low) + 2 <= min(high)


def _apart(p: Position, q: Position, least: int) -> bool:
    """Whether some coordinate differs by so much."""
    (x, y, z), (u, v, w) = p, q
    return not (-least < x - u < least and -least < y - v < least and -least < z - w < least)


def _starts(structure: Structure, shape: Shape | None) -> Iterator[Pose]:
    """Small poses near a shape (else with the platform above the base), the same in every run.

    Bodies are plane: the base lies in z = 0, a platform with more than three joints in a plane with a simple slope.
    """
    rng = random.Random(2008)
    sides = (structure.base, structure.platform)
    for number in range(_TRIES):
        pose: Pose = {}
        tilt = _TILTS[rng.randint(0, len(_TILTS) - 1)]
        for n in structure.names:
            near = shape[n] if shape else (0.0, 0.0, 1.0)
            spread = int(number > 0) if shape else 4  # the first one is the shape itself, rounded
            x, y = (round(_SIZE * c) + rng.randint(-spread, spread) for c in near[:2])
            z: Coordinate = round(_SIZE * near[2])
            if n in structure.base:
                z = 0
            elif n in structure.platform and len(structure.platform) > 3:
                z = int_if_whole(Fraction(2 * _SIZE + tilt[0] * x + tilt[1] * y, 2))
            else:
                z += rng.randint(-1, 1)
            pose[n] = (x, y, z)
        if not _crowded(pose, pose, 1) and _above(structure, pose) and not any(_crowded(pose, s, 2) for s in sides):
            yield pose


def _crowded(pose: Pose, joints: Iterable[str], least: int) -> bool:
    return not all(_apart(pose[a], pose[b], least) for a, b in combinations(joints, 2))


def _row(p: Sequence[int], q: Sequence[int]) -> list[int]:
    """The line of a leg: force and moment; the determinant of six such rows is the superbracket or its opposite."""
    (x, y, z), (u, v, w) = p, q
    return [u - x, v - y, w - z, y * w - z * v, z * u - x * w, x * v - y * u]


def _row_of_motion(step: Sequence[Coordinate], q: Sequence[int]) -> list[int]:
    """How the row changes when its first point moves by a step."""
    (x, y, z), (u, v, w) = map(int, step), q
    return [-x, -y, -z, y * w - z * v, z * u - x * w, x * v - y * u]


def _gradient(legs: Sequence[Leg], pose: Mapping[str, tuple[int, int, int]]) -> list[list[int]]:
    """For each leg the numbers by which its row is multiplied in the determinant; [] where the determinant vanishes.

    Elimination without fractions (Bareiss) beside the unit matrix.
    """
    size = len(legs)
    rows = [[*_row(pose[a], pose[b]), *(int(i == j) for j in range(size))] for i, (a, b) in enumerate(legs)]
    last = 1
    for k in range(size):
        pivot = next((i for i in range(k, size) if rows[i][k]), None)
        if pivot is None:
            return []
        rows[k], rows[pivot] = rows[pivot], rows[k]
        top = rows[k]
        for i in range(size):
            if i != k:
                first = rows[i][k]
                rows[i] = [(c * top[k] - first * t) // last for c, t in zip(rows[i], top, strict=True)]
        last = top[k]
    return [[rows[i][size + j] for i in range(size)] for j in range(size)]
