r"""Exact random points of one structure, on which rules test what they claim before it is proved."""

from __future__ import annotations

from itertools import combinations

from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.language.legs_text import Structure

__all__ = ["SAMPLES", "RandomWitness"]

SAMPLES = 2
_MOST = 1 << 30
_TRIES = 100  # small positions that are drawn until one satisfies what is assumed
_ONE = Number(1)


class RandomWitness:
    """Values of expressions and of the superbracket at two exact random points modulo a prime (see `seeds`), and at
    one with small whole coordinates, where a multiple of the prime shows (left out where assumptions leave none that is
    found). All satisfy what is assumed.
    """

    def __init__(self, structure: Structure) -> None:
        construction, rank = structure.construction, structure.rank
        self._rank = rank
        self._at = [Evaluator(construction.random_points((structure.text(), n)), rank, PRIME) for n in range(SAMPLES)]
        small = next(filter(None, map(construction.rational_points, range(1, _TRIES))), None)
        self._small = Evaluator(small, rank) if small else None
        self._exact = self._small.value(structure.superbracket)[0] if self._small else 0
        self._superbracket = [at.value(structure.superbracket)[0] for at in self._at]

    def zero(self, e: Expr) -> bool:
        """Whether an expression vanishes at the points."""
        return not any(any(at.value(e)) for at in self._at)

    def proportional(self, e: Expr, f: Expr) -> bool:
        """Whether two extensors of one step are multiples of each other at the points."""
        pairs = ((at.value(e), at.value(f)) for at in self._at)
        return not any((x[i] * y[j] - x[j] * y[i]) % PRIME for x, y in pairs for i, j in combinations(range(len(x)), 2))

    def at_infinity(self, e: Expr) -> bool:
        """Whether an extensor lies at infinity: its coordinates with the last row vanish."""
        last = [self._rank - 1 in rows for rows in combinations(range(self._rank), e.step)]
        return not any(any(c for c, here in zip(at.value(e), last, strict=True) if here) for at in self._at)

    def coefficient(self, e: Expr, cofactor: Expr = _ONE) -> int | None:
        """The integer c with cofactor · superbracket = c · e at all points, or None; c is below 2³⁰ in size."""
        pairs = [
            (at.value(cofactor)[0] * value % PRIME, at.value(e)[0])
            for at, value in zip(self._at, self._superbracket, strict=True)
        ]
        left, right = pairs[0]
        if not left or not right:
            return None
        c = left * pow(right, -1, PRIME) % PRIME
        c = c - PRIME if c > PRIME // 2 else c
        holds = abs(c) < _MOST and not any((left - c * right) % PRIME for left, right in pairs)
        if not holds:
            return None
        if self._small is None:
            return int(c)
        return int(c) if self._small.value(cofactor)[0] * self._exact == c * self._small.value(e)[0] else None
