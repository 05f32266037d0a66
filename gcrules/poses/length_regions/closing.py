r"""Closing three legs in the plane: the polynomial of degree 6 whose real zeros are the assembly modes.

With t = tan(φ/2), φ the turn of the platform from home and n = 1 + t², the ends of leg k are apart by the vector
p + u_k, p from A_1 to B_1 and u_k = R(φ) b_k − a_k. The squares s_k of the lengths ask |p|² = s_1 and
2 p · u_k = s_k − s_1 − |u_k|². The last two are linear in p; put into the first they leave

    f = v_2² d_3 − 2 v_2 v_3 e + v_3² d_2 − 4 s_1 n g²,    v_k = (s_k − s_1) n − d_k,

where d_k = n |u_k|², e = n u_2 · u_3 and g = n u_2 × u_3 are of degree 2 in t. Two modes with the same φ, which is
no singularity, are a double zero of f where g = 0. The resultant E of g and v_2 e − v_3 d_2 vanishes then; the
discriminant of f is E² times the polynomial whose zeros are the singular lengths.

Source: Gosselin, Sefrioui and Richard (1992) for the degree 6; what is divided by is derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.poses.length_regions.integer_polynomials import combined, product, resultant, roots_between
from gcrules.poses.paths.roots import integers

__all__ = ["Closing", "Plane"]

Plane = tuple[int, int]

_N = [1, 0, 1]


@dataclass(frozen=True)
class Closing:
    """The polynomials in t of three legs with whole coordinates."""

    d2: tuple[int, ...]
    d3: tuple[int, ...]
    e: tuple[int, ...]
    g: tuple[int, ...]

    @classmethod
    def of(cls, base: Sequence[Plane], platform: Sequence[Plane]) -> Closing:
        """From the places of A_2, A_3 seen from A_1, and those of B_2, B_3 seen from B_1 at home."""
        (x2, y2), (x3, y3) = (_moved(a, b) for a, b in zip(base, platform, strict=True))
        return cls(
            d2=_without_n(combined((1, product(x2, x2)), (1, product(y2, y2)))),
            d3=_without_n(combined((1, product(x3, x3)), (1, product(y3, y3)))),
            e=_without_n(combined((1, product(x2, x3)), (1, product(y2, y3)))),
            g=_without_n(combined((1, product(x2, y3)), (-1, product(y2, x3)))),
        )

    def polynomial(self, squares: Sequence[Any]) -> list[Any]:
        """f for these squares of the lengths, seven coefficients."""
        v2, v3 = self._v(squares)
        return combined(
            (1, product(v2, v2, self.d3)),
            (-2, product(v2, v3, self.e)),
            (1, product(v3, v3, self.d2)),
            (-4 * squares[0], product(_N, self.g, self.g)),
        )

    def singular(self, squares: Sequence[int]) -> Fraction | None:
        """The polynomial of the singular lengths at whole squares, times a number; None where it is not had so."""
        lost = self._lost(squares)
        if not lost:
            return None
        f = self.polynomial(squares)
        one, other = [(6 - i) * c for i, c in enumerate(f[:-1])], [i * c for i, c in enumerate(f)][1:]
        return Fraction(resultant(one, other), lost * lost)

    def modes(self, squares: Sequence[Fraction]) -> int | None:
        """How many real zeros f has, those at infinity too; exact. None where E is 0: two of them may be one zero."""
        denominator = lcm(*(s.denominator for s in squares))
        if not self._lost([int(s * denominator) for s in squares], denominator):
            return None
        f = integers(self.polynomial(squares))
        one = Fraction(1)
        inside = roots_between(f, -one, one)
        whole = [*f, *[0] * (7 - len(f))]
        outside = [r for r in roots_between(integers(whole[::-1]), -one, one) if abs(r.middle) != 1]
        return len(inside) + len(outside)

    def _lost(self, squares: Sequence[int], times: int = 1) -> int:
        """E, times a number, for whole squares that are so many times as large as they should be."""
        v2, v3 = self._v(squares, times)
        return resultant(self.g, combined((1, product(v2, self.e)), (-1, product(v3, self.d2))))

    def _v(self, squares: Sequence[Any], times: int = 1) -> tuple[list[Any], list[Any]]:
        """v_2 and v_3, times a number by which the squares are multiplied."""
        s1, s2, s3 = squares
        return combined((s2 - s1, _N), (-times, self.d2)), combined((s3 - s1, _N), (-times, self.d3))


def _moved(a: Plane, b: Plane) -> tuple[list[int], list[int]]:
    """The coordinates of n u = n (R(φ) b − a)."""
    return [b[0] - a[0], -2 * b[1], -b[0] - a[0]], [b[1] - a[1], 2 * b[0], -b[1] - a[1]]


def _without_n(p: Sequence[int]) -> tuple[int, ...]:
    """A polynomial of degree 4 divided by n."""
    high, low = p[4], p[3]
    return p[2] - high, low, high
