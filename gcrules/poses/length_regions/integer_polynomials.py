r"""Polynomials in one variable as lists of integers or fractions, lowest power first: products, resultants, values.

>>> resultant([-2, 0, 1], [-1, 1])                                                 # x² − 2 and x − 1
-1
>>> interpolated([0, 1, 2], [1, 2, 5])
[Fraction(1, 1), Fraction(0, 1), Fraction(1, 1)]
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, isqrt, log2
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import content
from gcrules.poses.paths.roots import Root, integers, roots

__all__ = [
    "combined",
    "derivative",
    "determinant",
    "interpolated",
    "primitive",
    "product",
    "reach_of",
    "resultant",
    "root_of",
    "roots_between",
    "subresultants",
    "value_at",
]

Poly = list[Any]


def product(*factors: Sequence[Any]) -> Poly:
    found: Poly = [1]
    for p in factors:
        new = [0] * (len(found) + len(p) - 1)
        for i, a in enumerate(found):
            for j, b in enumerate(p):
                new[i + j] += a * b
        found = new
    return found


def combined(*terms: tuple[Any, Sequence[Any]]) -> Poly:
    """The sum of numbers times polynomials."""
    found: Poly = [0] * max(len(p) for _, p in terms)
    for c, p in terms:
        for i, a in enumerate(p):
            found[i] += c * a
    return found


def derivative(p: Sequence[Any]) -> Poly:
    return [i * c for i, c in enumerate(p)][1:]


def value_at(p: Sequence[Any], x: Any) -> Any:
    found: Any = 0
    for c in reversed(p):
        found = found * x + c
    return found


def determinant(matrix: Sequence[Sequence[int]]) -> int:
    """Of integers, without fractions (Bareiss)."""
    m = [list(row) for row in matrix]
    sign, before = 1, 1
    for k in range(len(m) - 1):
        pivot = next((i for i in range(k, len(m)) if m[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            m[k], m[pivot], sign = m[pivot], m[k], -sign
        for i in range(k + 1, len(m)):
            for j in range(k + 1, len(m)):
                m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) // before
        before = m[k][k]
    return sign * m[-1][-1]


def resultant(p: Sequence[int], q: Sequence[int]) -> int:
    """Of binary forms with these coefficients: leading ones may be 0."""
    m, n = len(p) - 1, len(q) - 1
    rows = [[0] * i + [*p] + [0] * (n - 1 - i) for i in range(n)]
    return determinant(rows + [[0] * i + [*q] + [0] * (m - 1 - i) for i in range(m)])


def subresultants(p: Sequence[int], q: Sequence[int]) -> tuple[Poly, int] | None:
    """The subresultants of degrees 1 and 0 of integer polynomials whose degrees differ by 1, the second one up to its
    sign the resultant; None where a degree drops by more than 1 on the way.

    Source: Brown and Traub's remainder sequence.
    """
    one, other = [*p], [*q]
    lead, scale = 1, 1
    while len(other) > 1:
        rest = one
        for k in (1, 0):
            top = rest[-1]
            rest = [other[-1] * c for c in rest]
            for i, c in enumerate(other):
                rest[k + i] -= top * c
            rest.pop()
        if not rest or not rest[-1]:
            return None
        divisor = lead * scale
        one, other = other, [c // divisor for c in rest]
        lead = scale = one[-1]
    return one, other[0]


def interpolated(places: Sequence[Any], values: Sequence[Any]) -> list[Fraction]:
    """The polynomial with these values (Newton's divided differences), without leading zeros."""
    table = [Fraction(v) for v in values]
    for k in range(1, len(table)):
        for i in range(len(table) - 1, k - 1, -1):
            table[i] = (table[i] - table[i - 1]) / (places[i] - places[i - k])
    found: list[Fraction] = []
    for c, x in zip(reversed(table), reversed(places), strict=True):
        moved = [Fraction(0), *found]
        for i, a in enumerate(found):
            moved[i] -= x * a
        moved[0] += c
        found = moved
    while found and not found[-1]:
        found.pop()
    return found


def primitive(rows: Sequence[Sequence[Fraction]]) -> list[list[int]]:
    """The coefficients of a polynomial in two variables times one number: coprime integers."""
    divisor = content([c for row in rows for c in row])
    return [[int(c / divisor) for c in row] for row in rows]


def roots_between(p: Sequence[Any], low: Fraction, high: Fraction) -> list[Root]:
    """All real roots from `low` to `high`, in ascending order."""
    checkpoint()
    width = high - low
    moved: Poly = []
    for c in reversed(p):
        moved = combined((low, [*moved, 0]), (width, [0, *moved]), (1, [c]))
    return [Root(low + width * r.lower, low + width * r.upper, r.multiplicity) for r in roots(moved)]


def reach_of(p: Sequence[Any]) -> Fraction:
    """A power of 2 that is larger than all roots in absolute value (Fujiwara's bound)."""
    whole = integers(p)
    bits = [
        (abs(c).bit_length() - abs(whole[-1]).bit_length() + 1) / (len(whole) - 1 - i)
        for i, c in enumerate(whole[:-1])
        if c
    ]
    return Fraction(2) ** (ceil(max(bits, default=0.0)) + ceil(log2(2)) + 1)


def root_of(x: Fraction, scale: int) -> float:
    """The length whose square, times `scale`, is this; 0 where it is below 0."""
    square = max(x / scale, Fraction(0))
    top, bottom = isqrt(square.numerator), isqrt(square.denominator)
    if top * top == square.numerator and bottom * bottom == square.denominator:
        return top / bottom
    fine = 1 << 60
    return isqrt(int(square * fine * fine)) / fine
