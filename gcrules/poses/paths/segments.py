r"""The segments of a path through many poses: in floats all at once, each exact one made when it is asked for."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import overload

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import watched
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.arrays import Floats, pose_rows
from gcrules.poses.paths.motions import Motions
from gcrules.poses.paths.segment import Segment
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import Quaternion

__all__ = ["Segments", "segments"]

Truths = NDArray[np.bool_]

_NEAR = 1e-9  # two quaternions that are nearer to the same turn, or to a half turn apart, are compared exactly
_LONG = 1e100  # squares of longer quaternions, or of shorter ones than the inverse, are not known well enough


@dataclass(frozen=True, eq=False)
class Segments(Sequence[Segment]):
    """The segments between consecutive `poses`."""

    rig: MovingPlatform
    poses: tuple[Pose, ...]

    def __len__(self) -> int:
        return len(self.poses) - 1

    @overload
    def __getitem__(self, k: int) -> Segment: ...
    @overload
    def __getitem__(self, k: slice) -> tuple[Segment, ...]: ...
    def __getitem__(self, k: int | slice) -> Segment | tuple[Segment, ...]:
        if isinstance(k, slice):
            return tuple(self[n] for n in range(*k.indices(len(self))))
        number = range(len(self))[k]
        a, b = self.poses[number : number + 2]
        return Segment(self.rig, a.translation, b.translation, a.quaternion, _matched(a.quaternion, b.quaternion))

    @cached_property
    def rows(self) -> tuple[Floats, Floats]:
        """Translations (N, 3) and quaternions (N, 4) of the poses, as these have them."""
        return pose_rows(self.poses)

    @cached_property
    def motions(self) -> Motions:
        """The same in floats, each number the nearest but those of `q1`, which are off by fewer than 16 units of 2⁻⁵³
        of themselves. Raises InputError for a turn by exactly 180° between two poses.
        """
        shifts, quaternions = self.rows
        q0, q1 = quaternions[:-1], quaternions[1:]
        with np.errstate(all="ignore"):  # quaternions may be very long or short
            first, second = (np.linalg.norm(q, axis=1, keepdims=True) for q in (q0, q1))
            along = (q0 / first * (q1 / second)).sum(axis=1, keepdims=True)
            ends = q1 * (np.sign(along) * (first / second))
        plain = (np.abs(along[:, 0]) > _NEAR) & (np.abs(ends - q0) > _NEAR * first).any(axis=1)
        plain &= (np.minimum(first, second) > 1 / _LONG)[:, 0] & (np.maximum(first, second) < _LONG)[:, 0]
        for k in watched(np.flatnonzero(~plain).tolist()):
            self._check(k)
            ends[k] = [float(c) for c in self[k].q1]
        return Motions(shifts[:-1], shifts[1:], q0, ends)

    @cached_property
    def changes(self) -> tuple[Truths, Truths]:
        """Where the quaternion changes, (N,), and which coordinates of the translation do, (N, 3); exactly."""
        m = self.motions
        turns, shifts = (m.q0 != m.q1).any(axis=1), m.t0 != m.t1
        for k in watched(np.flatnonzero(~turns).tolist()):
            turns[k] = self[k].q0 != self[k].q1
        for k, axis in watched(np.argwhere(~shifts).tolist()):
            a, b = self.poses[k : k + 2]
            shifts[k, axis] = a.translation[axis] != b.translation[axis]
        return turns, shifts

    @cached_property
    def present(self) -> Truths:
        """Which components of quaternion and translation are other than 0 somewhere on a segment, (N, 7); exactly."""
        found = np.hstack(self.rows[::-1]) != 0
        for k, n in watched(np.argwhere(~found).tolist()):  # also numbers that are too small for floats
            p = self.poses[k]
            found[k, n] = bool((*p.quaternion, *p.translation)[n])
        return np.asarray(found[:-1] | found[1:])

    def _check(self, k: int) -> None:
        if not sum(c * d for c, d in zip(self.poses[k].quaternion, self.poses[k + 1].quaternion, strict=True)):
            raise InputError(
                f"from pose {k} to pose {k + 1} the platform turns by exactly 180°: both ways round are equally short",
                hint="put a pose between them that says which way",
            )


def segments(rig: MovingPlatform, poses: Sequence[Pose]) -> Segments:
    """The segments between consecutive poses. Raises InputError for a turn by exactly 180° between two of them."""
    found = Segments(rig, tuple(poses))
    found.motions  # noqa: B018 - which finds such a turn
    return found


def _matched(p: Quaternion, q: Quaternion) -> Quaternion:
    """q with the length of p (rounded to floats if need be) and the sign that makes the way short."""
    if p == q:
        return p
    along = sum(c * d for c, d in zip(p, q, strict=True))
    first, second = (sum(c * c for c in x) for x in (p, q))
    if along * along == first * second:
        return p  # the same turn
    factor = Fraction(math.sqrt(first / second)) if first != second else Fraction(1)
    w, x, y, z = (c * (factor if along > 0 else -factor) for c in q)
    return w, x, y, z
