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

__all__ = [
    "FirstRows",
    "content",
    "cross",
    "determinant",
    "echelon",
    "fraction_of",
    "kernel",
    "kernel_part",
    "permutation_sign",
    "rank",
    "whole_determinant",
]

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
    """The same modulo a prime: the eliminated rows are freed of the leading columns of each other, from the last on."""
    eliminated, pivots = _eliminated(matrix, modulus)
    found = list(eliminated)
    for n in range(len(found) - 2, -1, -1):
        row = found[n]
        for column, after in zip(pivots[n + 1 :], found[n + 1 :], strict=True):
            if factor := row[column]:
                row = [x - factor * y for x, y in zip(row, after, strict=True)]
        found[n] = [x % modulus for x in row]
    order = sorted(range(len(pivots)), key=pivots.__getitem__)
    return tuple(tuple(found[i]) for i in order), tuple(pivots[i] for i in order)


def _eliminated(matrix: Iterable[Sequence[int]], modulus: int) -> tuple[Sequence[Sequence[int]], Sequence[int]]:
    """Independent rows modulo a prime with the same span, and the columns of their leading ones, in which all rows
    after them are zero. Each row is taken modulo the prime once, after all steps.
    """
    found: list[list[int]] = []
    pivots: list[int] = []
    for given in matrix:
        checkpoint()
        row = list(given)
        for column, before in zip(pivots, found, strict=True):
            if factor := row[column] % modulus:
                row = [x - factor * y for x, y in zip(row, before, strict=True)]
        row = [x % modulus for x in row]
        lead = next((k for k, x in enumerate(row) if x), None)
        if lead is not None:
            inverse = pow(row[lead], -1, modulus)
            found.append([x * inverse % modulus for x in row])
            pivots.append(lead)
    return found, pivots


def rank(matrix: Iterable[Sequence[Any]], modulus: int | None = None) -> int:
    """The number of independent rows."""
    return len(echelon(matrix)[1] if modulus is None else _eliminated(matrix, modulus)[1])


def kernel(matrix: Iterable[Sequence[Any]], width: int, modulus: int | None = None) -> list[Row]:
    """A basis of the vectors of length `width` that are orthogonal to all rows: one for each column without a leading
    one.
    """
    rows, pivots = echelon(matrix, modulus)
    zero, one = _number(0, modulus), _number(1, modulus)
    found = []
    for free in (c for c in range(width) if c not in pivots):
        vector = [zero] * width
        vector[free] = one
        for row, column in zip(rows, pivots, strict=True):
            vector[column] = _number(-row[free], modulus)
        found.append(tuple(vector))
    return found


def kernel_part(
    matrix: Sequence[Sequence[Any]], width: int, part: int, modulus: int | None = None
) -> tuple[tuple[Row, ...], int]:
    """The span, in reduced echelon form, of what `kernel` has in the first columns, so many as the `part`; and the rank
    of the rows. Combinations of rows bind it that are zero in all other columns, which are eliminated first.
    """
    rows = [(*row[part:], *row[:part]) for row in matrix]
    found, pivots = echelon(rows) if modulus is None else _eliminated(rows, modulus)
    bound = [row[-part:] for row, pivot in zip(found, pivots, strict=True) if pivot >= width - part]
    return echelon(kernel(bound, part, modulus), modulus)[0], len(pivots)


def _number(x: Any, modulus: int | None) -> Any:
    return Fraction(x) if modulus is None else x % modulus


def fraction_of(residue: int, modulus: int) -> Fraction:
    """The fraction of the smallest numbers that has a residue modulo a prime (Wang's algorithm).

    >>> fraction_of(2 * pow(3, -1, 101) % 101, 101)
    Fraction(2, 3)
    """
    (r, s), (t, u) = (modulus, residue % modulus), (0, 1)
    while s * s * 2 > modulus:
        r, s, t, u = s, r % s, u, t - r // s * u
    return Fraction(s, u)


def determinant(matrix: Iterable[Sequence[int]], modulus: int) -> int:
    """Of whole numbers modulo a prime: by elimination down to four rows, and of these by Laplace's expansion."""
    rows = [[x % modulus for x in row] for row in matrix]
    value = 1
    while rows and len(rows) != 4:
        place = next((i for i, row in enumerate(rows) if row[0]), None)
        if place is None:
            return 0
        lead, *rest = rows.pop(place)
        value = (-value if place % 2 else value) * lead % modulus
        inverse = -pow(lead, -1, modulus)
        rows = [
            [(x + factor * y) % modulus for x, y in zip(row[1:], rest, strict=True)]
            if (factor := row[0] * inverse % modulus)
            else row[1:]
            for row in rows
        ]
    return (value * _of_four(*rows) if rows else value) % modulus


def whole_determinant(m: list[list[int]]) -> int:
    """The determinant of whole numbers by Bareiss' elimination without fractions, which uses the matrix up."""
    n, sign, previous = len(m), 1, 1
    for k in range(n - 1):
        pivot = next((i for i in range(k, n) if m[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            m[k], m[pivot], sign = m[pivot], m[k], -sign
        top, first = m[k], m[k][k]
        for row in m[k + 1 :]:
            factor = row[k]
            for j in range(k + 1, n):
                row[j] = (row[j] * first - factor * top[j]) // previous
        previous = first
    return sign * m[-1][-1]


class FirstRows:
    """The first rows of many matrices, freed of each other modulo a prime, for the determinants of all of them."""

    def __init__(self, rows: Iterable[Sequence[int]], modulus: int) -> None:
        self.modulus = modulus
        self.value = 1
        self._found: list[tuple[int, list[int]]] = []
        for given in rows:
            checkpoint()
            row = self._freed(given)
            lead = next((k for k, x in enumerate(row) if x), None)
            if lead is None:
                self.value = 0
                break
            self.value = self.value * row[lead] % modulus
            inverse = pow(row[lead], -1, modulus)
            self._found.append((lead, [x * inverse % modulus for x in row]))

    def determinant(self, rows: Sequence[Sequence[int]]) -> int:
        """That of the square matrix with these rows below."""
        if not self.value:
            return 0
        pivots = [lead for lead, _ in self._found]
        columns = [k for k in range(len(pivots) + len(rows)) if k not in pivots]
        below = [[row[k] for k in columns] for row in map(self._freed, rows)]
        sign = permutation_sign([*pivots, *columns])
        return sign * self.value * determinant(below, self.modulus) % self.modulus

    def _freed(self, given: Sequence[int]) -> list[int]:
        row = list(given)
        for lead, before in self._found:
            if factor := row[lead] % self.modulus:
                row = [x - factor * y for x, y in zip(row, before, strict=True)]
        return [x % self.modulus for x in row]


def _of_four(a: Sequence[int], b: Sequence[int], c: Sequence[int], d: Sequence[int]) -> int:
    """The determinant, by minors of the first two rows and of the last two."""
    (a0, a1, a2, a3), (b0, b1, b2, b3), (c0, c1, c2, c3), (d0, d1, d2, d3) = a, b, c, d
    return (
        (a0 * b1 - a1 * b0) * (c2 * d3 - c3 * d2)
        - (a0 * b2 - a2 * b0) * (c1 * d3 - c3 * d1)
        + (a0 * b3 - a3 * b0) * (c1 * d2 - c2 * d1)
        + (a1 * b2 - a2 * b1) * (c0 * d3 - c3 * d0)
        - (a1 * b3 - a3 * b1) * (c0 * d2 - c2 * d0)
        + (a2 * b3 - a3 * b2) * (c0 * d1 - c1 * d0)
    )


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
