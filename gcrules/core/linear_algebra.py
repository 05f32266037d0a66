r"""Gauss and Jordan's elimination, over the rationals or modulo a prime.

>>> rank([[1, 2], [2, 4]]), rank([[1, 2], [3, 4]], 5)
(1, 2)
>>> [tuple(map(str, v)) for v in kernel([[1, 2, 1]], 3)]
[('-2', '1', '0'), ('-1', '0', '1')]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from gcrules.core.budget import checkpoint

__all__ = ["content", "cross", "echelon", "kernel", "permutation_sign", "rank"]

Row = tuple[Any, ...]


def echelon(matrix: Iterable[Sequence[Any]], modulus: int | None = None) -> tuple[tuple[Row, ...], tuple[int, ...]]:
    """The reduced echelon form without zero rows, and the columns of its leading ones.

    Entries are whole numbers or Fractions; whole numbers modulo the prime `modulus`, if there is one.
    """
    left: list[list[Any]] = [[_number(x, modulus) for x in row] for row in matrix]
    pivots: list[int] = []
    for column in range(len(left[0]) if left else 0):
        checkpoint()
        top = len(pivots)
        found = next((i for i in range(top, len(left)) if left[i][column]), None)
        if found is None:
            continue
        left[top], left[found] = left[found], left[top]
        lead = left[top][column]
        inverse = 1 / lead if modulus is None else pow(lead, -1, modulus)
        left[top] = first = [_number(x * inverse, modulus) for x in left[top]]
        for i, row in enumerate(left):
            if i != top and (factor := row[column]):
                less = [x - factor * y for x, y in zip(row, first, strict=True)]
                left[i] = less if modulus is None else [x % modulus for x in less]
        pivots.append(column)
    return tuple(map(tuple, left[: len(pivots)])), tuple(pivots)


def rank(matrix: Iterable[Sequence[Any]], modulus: int | None = None) -> int:
    """The number of independent rows."""
    return len(echelon(matrix, modulus)[1])


def kernel(matrix: Iterable[Sequence[Any]], width: int, modulus: int | None = None) -> list[Row]:
    """A basis of the vectors of length `width` that are orthogonal to all rows: one for each column without a leading
    one.
    """
    rows, pivots = echelon(matrix, modulus)
    found = []
    for free in (c for c in range(width) if c not in pivots):
        vector = [_number(int(i == free), modulus) for i in range(width)]
        for row, column in zip(rows, pivots, strict=True):
            vector[column] = _number(-row[free], modulus)
        found.append(tuple(vector))
    return found


def _number(x: Any, modulus: int | None) -> Any:
    return Fraction(x) if modulus is None else x % modulus


def permutation_sign(order: Sequence[int]) -> int:
    """+1 for an even arrangement of distinct numbers, −1 for an odd one."""
    inversions = sum(order[i] > order[j] for i in range(len(order)) for j in range(i + 1, len(order)))
    return -1 if inversions % 2 else 1


def content(numbers: Iterable[int | Fraction]) -> Fraction:
    """The largest rational number of which all of these, not all 0, are whole multiples; positive."""
    exact = list(numbers)
    return Fraction(gcd(*(c.numerator for c in exact)), lcm(*(c.denominator for c in exact)))


def cross(a: Sequence[Any], b: Sequence[Any]) -> tuple[Any, Any, Any]:
    """a × b in any ring."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
