r"""The superbracket as an exact polynomial, of degree ≤ 3, in the translation t at a fixed orientation.

The rows of the determinant are (L_i + t, a_i × (b_i + t)), L_i = b_i − a_i. With moments about the point t instead of
the origin the last three columns become a_i × b_i + b_i × t. The first three hold t in multiples of one constant
column, so their minors have degree ≤ 1; in the last three, the parts b_i × t are orthogonal to t, so of their minors
the part of degree 3 is zero. The total is at most 1 + 2 = 3. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import lcm

from gcrules.algebra.language.legs_text import Leg
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import whole_determinant

__all__ = [
    "EXPONENTS",
    "FACTORED_BITS",
    "Cubic",
    "bits",
    "determinant",
    "interpolated",
    "superbracket_at",
    "translation_polynomial",
]

Exponents = tuple[int, int, int]
Points = Mapping[str, Sequence[Fraction]]

EXPONENTS: tuple[Exponents, ...] = tuple(e for e in product(range(4), repeat=3) if sum(e) <= 3)  # type: ignore[misc]
"""The twenty monomials of degree ≤ 3, which are as many places where one is determined by its values."""

FACTORED_BITS = 3_000
"""Polynomials with longer coefficients are not parted into factors: the primes for that are sought for minutes."""


def bits(numbers: Iterable[Fraction]) -> int:
    """The length of the longest of these rational numbers, brought to whole numbers in the same ratios."""
    listed = [Fraction(c) for c in numbers]
    common = lcm(*(c.denominator for c in listed))
    return max((int(c * common).bit_length() for c in listed), default=0)


_FALLING = ((1,), (0, 1), (0, Fraction(-1, 2), Fraction(1, 2)), (0, Fraction(1, 3), Fraction(-1, 2), Fraction(1, 6)))


@dataclass(frozen=True)
class Cubic:
    """Σ c x^i y^j z^k with i + j + k ≤ 3, exact; `coefficients` leaves out zeros."""

    coefficients: Mapping[Exponents, Fraction]

    def __post_init__(self) -> None:
        found = {e: Fraction(c) for e, c in self.coefficients.items() if c}
        object.__setattr__(self, "coefficients", FrozenMap(found))

    @property
    def degree(self) -> int:
        """The total degree; −1 for the zero polynomial."""
        return max(map(sum, self.coefficients), default=-1)

    def __call__(self, x: Fraction, y: Fraction, z: Fraction) -> Fraction:
        return sum((c * x**i * y**j * z**k for (i, j, k), c in self.coefficients.items()), Fraction(0))

    def stretched(self, size: Fraction) -> Cubic:
        """The polynomial in t / size."""
        return Cubic({e: c * size ** sum(e) for e, c in self.coefficients.items()})


def translation_polynomial(legs: Sequence[Leg], points: Points, moving: Sequence[str], step: Fraction) -> Cubic:
    """The superbracket after the joints `moving` have been shifted by t, as a polynomial in t; exact.

    `points` are homogeneous with last coordinate 1. It is interpolated on the lattice of the multiples of `step` > 0
    (any will do; the numbers stay small near the robot's size).
    """
    return interpolated({e: superbracket_at(legs, points, moving, [step * c for c in e]) for e in EXPONENTS}, step)


def interpolated(samples: Mapping[Exponents, Fraction], step: Fraction) -> Cubic:
    """The polynomial of degree ≤ 3 with these values at the multiples of `step` that `EXPONENTS` lists."""
    values = dict(samples)
    for axis in range(3):  # values on the lattice → forward differences at 0, one axis after the other
        for order in range(1, 4):
            for e in sorted(EXPONENTS, key=lambda e: -e[axis]):
                if e[axis] >= order:
                    before = (*e[:axis], e[axis] - 1, *e[axis + 1 :])
                    values[e] -= values[before]  # type: ignore[index]
    coefficients = dict.fromkeys(EXPONENTS, Fraction(0))
    for e, difference in values.items():
        for powers in product(*(range(n + 1) for n in e)):
            factor = Fraction(1)
            for n, power in zip(e, powers, strict=True):
                factor *= _FALLING[n][power]
            coefficients[powers] += difference * factor / step ** sum(powers)  # type: ignore[index]
    return Cubic(coefficients)


def superbracket_at(
    legs: Sequence[Leg], points: Points, moving: Sequence[str] = (), shift: Sequence[Fraction | int] = (0, 0, 0)
) -> Fraction:
    """The superbracket, −det of the rows (b − a, a × b), after some joints have been shifted; exact."""
    rows = []
    for a, b in legs:
        (p, q) = (
            [c + s for c, s in zip(points[n][:3], shift, strict=True)] if n in moving else list(points[n][:3])
            for n in (a, b)
        )
        moment = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
        rows.append([d - c for c, d in zip(p, q, strict=True)] + moment)
    return -determinant(rows)


def determinant(rows: Sequence[Sequence[Fraction]]) -> Fraction:
    """The determinant, exact."""
    scale = Fraction(1)
    m: list[list[int]] = []
    for row in rows:
        common = lcm(*(c.denominator for c in map(Fraction, row)))
        m.append([int(c * common) for c in row])
        scale *= common
    return Fraction(whole_determinant(m)) / scale
