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

__all__ = ["content", "cross", "determinant", "echelon", "kernel", "permutation_sign", "rank"]

Row = tuple[Any, ...]


def echelon(matrix: Iterable[Sequence[Any]], modulus: int | None = None) -> tuple[tuple[Row, ...], tuple[int, ...]]:
    """The reduced echelon form without zero rows, and the columns of its leading ones.

    Entries are whole numbers or Fractions; whole numbers modulo the prime `modulus`, if there is one.
    """
    if modulus is not None:
        return _modular(matrix, modulus)
    left: list[list[Any]] = [list(map(Fraction, row)) for row in matrix]
    pivots: list[int] = []
    for column in range(len(left[0]) if left else 0):
        checkpoint()
        top = len(pivots)
        found = next((i for i in range(top, len(left)) if left[i][column]), None)
        if found is None:
            continue
        left[top], left[found] = left[found], left[top]
        inverse = 1 / left[top][column]
        left[top] = first = [x * inverse for x in left[top]]
        for i, row in enumerate(left):
            if i != top and (factor := row[column]):
                left[i] = [x - factor * y for x, y in zip(row, first, strict=True)]
        pivots.append(column)
    return tuple(map(tuple, left[: len(pivots)])), tuple(pivots)


def _modular(matrix: Iterable[Sequence[int]], modulus: int) -> tuple[tuple[Row, ...], tuple[int, ...]]:
    """The same modulo a prime, row by row: each is reduced by those before it, and then they by it."""
    found: list[list[int]] = []
    pivots: list[int] = []
    for given in matrix:
        checkpoint()
        row = [x % modulus for x in given]
        for column, before in zip(pivots, found, strict=True):
            if factor := row[column]:
                row = [(x - factor * y) % modulus for x, y in zip(row, before, strict=True)]
        lead = next((k for k, x in enumerate(row) if x), None)
        if lead is None:
            continue
        inverse = pow(row[lead], -1, modulus)
        row = [x * inverse % modulus for x in row]
        for i, before in enumerate(found):
            if factor := before[lead]:
                found[i] = [(x - factor * y) % modulus for x, y in zip(before, row, strict=True)]
        found.append(row)
        pivots.append(lead)
    order = sorted(range(len(pivots)), key=pivots.__getitem__)
    return tuple(tuple(found[i]) for i in order), tuple(pivots[i] for i in order)


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


def determinant(matrix: Iterable[Sequence[int]], modulus: int) -> int:
    """Of whole numbers modulo a prime. Elimination without division: each step multiplies the rows that are left by the
    leading entry, and the product of these powers is divided out at the end.
    """
    rows = [[x % modulus for x in row] for row in matrix]
    above = below = 1
    while rows:
        place = next((i for i, row in enumerate(rows) if row[0]), None)
        if place is None:
            return 0
        first = rows.pop(place)
        lead, rest = first[0], first[1:]
        above = (-above if place % 2 else above) * lead % modulus
        below = below * pow(lead, len(rows), modulus) % modulus
        rows = [[(lead * x - row[0] * y) % modulus for x, y in zip(row[1:], rest, strict=True)] for row in rows]
    return above * pow(below, -1, modulus) % modulus


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
