"""Random products of joins and meets, planted for the factorization to find again."""

from __future__ import annotations

import random

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr

__all__ = ["plant"]


def plant(rng: random.Random, rank: int, letters: list[str]) -> Expr | None:
    """A random expression without a scalar part that uses these letters; None if the random steps lead nowhere."""
    parts: list[Expr] = [ex.Point(n) for n in letters]
    while len(parts) > 1:
        pairs = [
            (i, j)
            for i in range(len(parts))
            for j in range(i)
            if parts[i].step + parts[j].step != rank or len(parts) == 2
        ]
        if not pairs:
            return None
        i, j = rng.choice(pairs)
        a, b = parts[i], parts[j]
        tied = ex.join(a, b, rank=rank) if a.step + b.step < rank else ex.meet(a, b, rank=rank)
        parts = [p for k, p in enumerate(parts) if k not in (i, j)] + [tied]
    return parts[0] if parts[0].step == 0 else None
