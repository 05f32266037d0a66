r"""Products of two brackets: the van der Waerden syzygy, the exchange of points, and the standard form.

The standard form of [first][second] depends on the relative order of their points only. It is computed once for the
points 0, 1, 2, …, and kept; by exchanges, which have fewer terms than the syzygies that are shown to the user.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import combinations
from math import comb

from gcrules.algebra.bracket import Monomial, Row, sorted_row
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["Pattern", "exchange", "offending_column", "pattern_of", "syzygy", "two_row_pattern", "two_rows"]

Pattern = tuple[tuple[tuple[int, Row, Row], ...], int]
"""The terms of a standard form, each a coefficient and two rows, and how many terms were made on the way."""


@lru_cache(maxsize=1 << 15)
def two_rows(first: Row, second: Row) -> tuple[tuple[int, Row, Row], ...]:
    """The standard form of [first][second], from the one for points 0, 1, 2, … in the same relative order."""
    letters = sorted({*first, *second})
    pattern, _ = pattern_of(first, second)
    return tuple((c, tuple(letters[i] for i in one), tuple(letters[i] for i in other)) for c, one, other in pattern)


def pattern_of(first: Row, second: Row) -> Pattern:
    """The standard form for points 0, 1, 2, … in the relative order of these."""
    place = {x: i for i, x in enumerate(sorted({*first, *second}))}
    return two_row_pattern(tuple(place[x] for x in first), tuple(place[x] for x in second))


@lru_cache(maxsize=1 << 14)
def two_row_pattern(first: Row, second: Row) -> Pattern:
    """The standard form of [first][second], and the number of terms that were made on the way."""
    work = 0
    normal: dict[Monomial, int] = {}
    pending: dict[Monomial, int] = {(first, second): 1}
    while pending:
        checkpoint()
        largest = max(pending)
        coefficient = pending.pop(largest)
        if not coefficient:
            continue
        one, other = largest
        columns = [j for j, (x, y) in enumerate(zip(one, other, strict=True)) if x > y]
        if not columns:
            normal[largest] = coefficient
            continue
        for c, rows in exchange(one, other, min(columns, key=lambda j: comb(len(one), j))):
            pending[rows] = pending.get(rows, 0) + c * coefficient
            work += 1
    return tuple((c, one, other) for (one, other), c in sorted(normal.items())), work


def offending_column(one: Row, other: Row) -> int | None:
    """The first column in which row `one` is larger than the row below it."""
    return next((j for j, (x, y) in enumerate(zip(one, other, strict=True)) if x > y), None)


def syzygy(one: Row, other: Row, column: int) -> Iterator[tuple[int, Monomial]]:
    """[one][other] as the sum of the other terms of the van der Waerden syzygy that shuffles other[0 … column] with
    one[column …]; these d + 1 points are different, since the former are all smaller than the latter.
    """
    moving = (*one[column:], *other[: column + 1])
    up = len(one) - column
    for chosen in combinations(range(len(moving)), up):
        if chosen == tuple(range(up)):
            continue
        rest = tuple(i for i in range(len(moving)) if i not in chosen)
        s, first = sorted_row((*one[:column], *(moving[i] for i in chosen)))
        t, second = sorted_row((*(moving[i] for i in rest), *other[column + 1 :]))
        sign = s * t * permutation_sign(chosen + rest)
        if sign:
            yield -sign, (first, second) if first <= second else (second, first)


def exchange(one: Row, other: Row, number: int) -> Iterator[tuple[int, Monomial]]:
    """[one][other] as a sum: the first `number` points of `one` change places with as many of `other` in every way.

    If one[number] > other[number], each new first row is smaller than `one`: it holds the points that went, and of the
    points of `other` that stay the smallest is at most other[number].
    """
    going, staying = one[:number], one[number:]
    for chosen in combinations(range(len(other)), number):
        row = list(other)
        for x, i in zip(going, chosen, strict=True):
            row[i] = x
        s, first = sorted_row(row)
        t, second = sorted_row((*(other[i] for i in chosen), *staying))
        if s and t:
            yield s * t, (first, second) if first <= second else (second, first)
