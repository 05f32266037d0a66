"""Determinants of matrices with the same first rows are those of the whole matrices."""

from __future__ import annotations

import random

import pytest

from gcrules.core.linear_algebra import FirstRows, determinant

PRIMES = (5, 101, 2**61 - 1)


@pytest.mark.parametrize("p", PRIMES)
def test_first_rows(p: int) -> None:
    rng = random.Random(p)
    zeros = 0
    for _ in range(200):
        size = rng.randint(1, 7)
        matrix = [[rng.choice((0, rng.randrange(-p, p))) for _ in range(size)] for _ in range(size)]
        if size > 2 and rng.random() < 0.3:
            matrix[1] = [2 * x for x in matrix[0]]
        number = rng.randint(0, size)
        found = FirstRows(matrix[:number], p).determinant(matrix[number:])
        assert found == determinant(matrix, p)
        zeros += not found
    assert 0 < zeros < 200


def test_many_ends() -> None:
    first = FirstRows([[1, 2, 3], [4, 5, 6]], 101)
    assert [first.determinant([row]) for row in ([7, 8, 9], [7, 8, 10], [0, 0, 0])] == [0, 98, 0]
