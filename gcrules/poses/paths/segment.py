r"""From one pose to the next: a motion along which the superbracket is a polynomial in one parameter, exactly.

For s from 0 to 1 the translation is (1 − s) t₀ + s t₁ and the turn that of the quaternion q(s) = (1 − s) q₀ + s q₁, of
quaternions of equal length, the shorter way: the platform turns about one fixed axis, through the same turns as with
constant angular velocity and only at a slightly different pace (see `Motions.turned`), and its centre moves on a
straight line.

With R = N(q)/n, n = |q|², let p be the place of the centre, β_i the platform's arms and a_i the joints of the base.
With moments about p the rows of the superbracket D are (p + Rβ_i − a_i, Rβ_i × (p − a_i)). Minors of R of order two are
entries of R. So in R the minors of the first three columns have degree ≤ 1; those of the last three, the determinants
of three β_i × Rᵀ(p − a_i), are sums of products of two brackets, each of degree ≤ 1 in R: degree ≤ 2. In t the total
degree is ≤ 3 (`cubic`). Hence n³ D is a polynomial of degree ≤ 6 in q and ≤ 3 in t: of degree ≤ 9 in s, ≤ 6 without
translation, ≤ 3 without turn. n > 0, so D has the same zeros. Derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from itertools import count, islice
from math import gcd, lcm

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault
from gcrules.core.linear_algebra import whole_determinant
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.paths.motions import Motions
from gcrules.poses.paths.roots import integers
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import Quaternion, Vector, unscaled

__all__ = ["Segment"]

_Whole = tuple[dict[str, list[int]], list[list[int]], list[list[int]]]


@dataclass(frozen=True)
class Segment:
    """The motion from pose (t0, q0) to pose (t1, q1); q0 and q1 have equal length and no obtuse angle."""

    rig: MovingPlatform
    t0: Vector
    t1: Vector
    q0: Quaternion
    q1: Quaternion

    def pose(self, s: Fraction) -> Pose:
        """The pose at s, exact."""
        x, y, z = (a + s * (b - a) for a, b in zip(self.t0, self.t1, strict=True))
        return Pose((x, y, z), self._quaternion(s))

    def _quaternion(self, s: Fraction) -> Quaternion:
        w, x, y, z = (a + s * (b - a) for a, b in zip(self.q0, self.q1, strict=True))
        return w, x, y, z

    @cached_property
    def motion(self) -> Motions:
        """The same in floats."""
        return Motions(*(np.array([[float(c) for c in v]]) for v in (self.t0, self.t1, self.q0, self.q1)))

    @property
    def degree(self) -> int:
        """What the degree of `polynomial` is at most."""
        return 6 * (self.q0 != self.q1) + 3 * (self.t0 != self.t1)

    @cached_property
    def polynomial(self) -> tuple[int, ...]:
        """The superbracket along the segment times a positive function: integers, lowest power first; () if it is 0.

        It is interpolated at one place more than its degree asks for. Raises EngineFault where the last does not fit.
        The polynomial that is interpolated has whole coefficients (see `_value`), so all divided differences are whole.
        """
        places = list(islice((s for k in count() for s in ((k, -k) if k else (0,))), self.degree + 2))
        whole = self._whole()  # not kept: a path may have very many segments
        table = [self._value(s, whole) for s in places]
        for order in range(1, len(places)):
            for i in reversed(range(order, len(places))):
                table[i] = (table[i] - table[i - 1]) // (places[i] - places[i - order])
        if table[-1]:
            raise EngineFault("the superbracket along a path has a higher degree than was proved")
        found: list[int] = []
        for place, difference in zip(reversed(places[:-1]), reversed(table[:-1]), strict=True):  # Horner, as Newton's
            found = [a - place * b for a, b in zip([0, *found], [*found, 0], strict=True)]
            found[0] += difference
        return tuple(integers(found))

    def _whole(self) -> _Whole:
        """Lengths as whole multiples of one unit: base joints and arms, the ends of the centre's path, quaternions."""
        r = self.rig
        moving = {n for n in r.structure.names if r.structure.sides[n] == "platform"}
        joints = {
            n: [c - m for c, m in zip(p, r.centre, strict=True)] if n in moving else list(p)
            for n, p in r.points.items()
        }
        centres = [[c + m for c, m in zip(t, r.centre, strict=True)] for t in (self.t0, self.t1)]
        unit = _common([*joints.values(), *centres])
        turns = _common([self.q0, self.q1])
        return (
            {n: [int(c * unit) for c in p] for n, p in joints.items()},
            [[int(c * unit) for c in p] for p in centres],
            [[int(c * turns) for c in q] for q in (self.q0, self.q1)],
        )

    def _value(self, s: int, whole: _Whole) -> int:
        """|q|⁶ times the superbracket at a whole s, up to a positive constant.

        The determinant is −n⁹ D, n = |q|², with whole coefficients in s. So −n³ D has, too, once the common divisor of
        the coefficients of n is taken out of the n⁶ that it is divided by (Gauss' lemma).
        """
        joints, (c0, c1), (q0, q1) = whole
        w, x, y, z = (a + s * (b - a) for a, b in zip(q0, q1, strict=True))
        n = w * w + x * x + y * y + z * z
        turn = unscaled((w, x, y, z))  # n R
        centre = [n * (a + s * (b - a)) for a, b in zip(c0, c1, strict=True)]
        sides = self.rig.structure.sides
        places = {}  # all n times the point
        for name, (u, v, t) in joints.items():
            if sides[name] == "platform":
                places[name] = tuple(m + r[0] * u + r[1] * v + r[2] * t for m, r in zip(centre, turn, strict=True))
            else:
                places[name] = (n * u, n * v, n * t)
        rows = []
        for a, b in self.rig.structure.legs:
            (i, j, k), (u, v, t) = places[a], places[b]
            rows.append([u - i, v - j, t - k, j * t - k * v, k * u - i * t, i * v - j * u])
        return -whole_determinant(rows) // (n // _content(q0, q1)) ** 6  # forces are n times too long, moments n²


def _content(q0: Sequence[int], q1: Sequence[int]) -> int:
    """The greatest common divisor of the coefficients of |q0 + s (q1 − q0)|²."""
    step = [b - a for a, b in zip(q0, q1, strict=True)]
    return gcd(
        *(sum(a * b for a, b in zip(p, q, strict=True)) for p, q in ((q0, q0), (step, step))),
        2 * sum(a * b for a, b in zip(q0, step, strict=True)),
    )


def _common(rows: Sequence[Sequence[Fraction]]) -> int:
    return lcm(*(c.denominator for row in rows for c in row))
