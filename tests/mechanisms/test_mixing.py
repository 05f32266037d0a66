"""Determinants of random combinations of rows along a path: in a frame, and as they are defined."""

from __future__ import annotations

import random
from collections.abc import Sequence

from gcrules.mechanisms.lines.singular import PRIME, Mixing, interpolated, roots
from gcrules.screws import RESIDUES

Rows = tuple[tuple[int, ...], ...]


def defined(seed: int, rows: Sequence[Sequence[int]], usual: int) -> int:
    """det(A · rows · Bᵀ), A and B with unit matrices before the same drawn numbers."""
    rng, shape = random.Random(seed), (len(rows), len(rows[0]))
    a, b = (
        [
            [*(int(i == j) for j in range(usual)), *(rng.randrange(PRIME) for _ in range(size - usual))]
            for i in range(usual)
        ]
        for size in shape
    )
    right = [[sum(x * y for x, y in zip(row, other, strict=True)) for other in b] for row in rows]
    both = [[sum(x * row[k] for x, row in zip(one, right, strict=True)) for k in range(usual)] for one in a]
    return int(RESIDUES.determinant([[x % PRIME for x in row] for row in both]))


def test_two_roads() -> None:
    rng = random.Random(5)
    zeros = 0
    for seed in range(200):
        height, width = rng.randint(1, 8), rng.randint(1, 8)
        usual = rng.randint(1, min(height, width))
        start = [[rng.choice((0, rng.randrange(PRIME))) for _ in range(width)] for _ in range(height)]
        step = [[rng.randrange(PRIME) * (n % 2) for _ in range(width)] for n in range(height)]
        bend = seed % 4 == 0  # a row that is the same at two members, and another one elsewhere

        def rows(t: int, start: list[list[int]] = start, step: list[list[int]] = step, bend: bool = bend) -> Rows:
            return tuple(
                tuple((a + t * b + bend * (n == 0) * t * (t - 1)) % PRIME for a, b in zip(x, y, strict=True))
                for n, (x, y) in enumerate(zip(start, step, strict=True))
            )

        value = Mixing(random.Random(seed), rows(0), usual).along(rows)
        pairs = [(value(t), defined(seed, rows(t), usual)) for t in range(5)]
        assert any(all((x - sign * y) % PRIME == 0 for x, y in pairs) for sign in (1, -1)), seed
        zeros += all(x == 0 for x, _ in pairs)
    assert zeros < 100


def test_members_with_less_rank() -> None:
    """Of four rows of rank 3 with the number t in one place; at t = 7 the second is twice the first."""

    def rows(t: int) -> Rows:
        return (1, 2, 3, 0), (2, 4, t - 1, 0), (0, 1, 1, 0), (1, 3, 4, 0)

    value = Mixing(random.Random(1), rows(2), 3).along(rows)
    assert roots(interpolated(value) or []) == (7,)
    assert [RESIDUES.rank(rows(t)) for t in (2, 7)] == [3, 2]
