"""What grows with the points: random products of brackets, and expressions of joins and meets."""

from __future__ import annotations

import random

__all__ = ["PLANTED", "Monomial", "products"]

Monomial = tuple[tuple[int, ...], ...]

PLANTED = [
    (3, r"[ab /\ cd, e, f]"),
    (3, r"[ab /\ cd, ef /\ gh, i]"),
    (3, r"[ab /\ cd, ef /\ gh, ij /\ kl]"),
    (3, r"[((ab /\ cd) \/ e) /\ fg, hi /\ jk, lm /\ no]"),
    (4, r"abc /\ def /\ gh"),
    (4, r"abc /\ def /\ ghi /\ jkl"),
    (4, r"((abc /\ de) \/ (fgh /\ ij) \/ k) /\ (lmn /\ op)"),
]
"""Rank and expression, each point used once."""


def products(rank: int, points: int, number: int) -> list[Monomial]:
    """Random products of as few brackets as hold all the points; some points occur twice if they do not fill them."""
    rng = random.Random(100 * rank + points)
    brackets = -(-points // rank)
    found: list[Monomial] = []
    while len(found) < number:
        places = [*range(points), *rng.sample(range(points), brackets * rank - points)]
        rng.shuffle(places)
        rows = [tuple(sorted(places[i : i + rank])) for i in range(0, len(places), rank)]
        if all(len(set(row)) == rank for row in rows):
            found.append(tuple(sorted(rows)))
    return found
