r"""Fixed exact random points of one structure, on which rules test what they claim before it is proved."""

from __future__ import annotations

from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, random_rational_points
from gcrules.algebra.expr import Expr, Number
from gcrules.legs import Structure

__all__ = ["Oracle"]

_MOST = 1 << 30
_ONE = Number(1)


class Oracle:
    """Values of expressions and of the superbracket at two exact random points modulo a prime near 2⁶¹, and at one with
    small whole coordinates, where a multiple of the prime shows.
    """

    def __init__(self, structure: Structure) -> None:
        names, ideal = structure.names, structure.ideal
        self._at = [Evaluator(random_points(names, ideal=ideal, seed=n), 4, PRIME) for n in (1, 2)]
        self._small = Evaluator(random_rational_points(names, ideal=ideal, seed=1), 4)
        self._exact = self._small.value(structure.superbracket)[0]
        self._superbracket = [at.value(structure.superbracket)[0] for at in self._at]

    def zero(self, e: Expr) -> bool:
        """Whether an expression vanishes at the points."""
        return not any(any(at.value(e)) for at in self._at)

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
        return c if self._small.value(cofactor)[0] * self._exact == c * self._small.value(e)[0] else None
