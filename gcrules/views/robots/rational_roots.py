r"""Polynomials over the rationals: from their values to their coefficients, and to their rational roots in an interval.

>>> f = polynomial(lambda t: t * t - Fraction(1, 4))
>>> print(*f, *rational_roots(f, Fraction(2)))
-1/4 0 1 -1/2 1/2
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise

__all__ = ["polynomial", "rational_roots"]

_MOST_DEGREE = 8
_MOST_DENOMINATOR = 60
_GRID = 96  # places between which a change of sign is looked for


def polynomial(value: Callable[[Fraction], Fraction]) -> list[Fraction] | None:
    """The coefficients of 1, t, t² … of a polynomial with these values; None for degrees above 8, and for zero."""
    points: list[Fraction] = []
    table: list[Fraction] = []  # divided differences
    for k in range(_MOST_DEGREE + 3):
        t = Fraction((k + 1) // 2 * (-1) ** k)
        new = [value(t)]
        for i, old in enumerate(table):
            new.append((new[i] - old) / (t - points[i]))
        points.append(t)
        table.append(new[-1])
        if k > 2 and not any(table[-2:]):
            break
    else:
        return None
    found: list[Fraction] = []
    for c, t in zip(reversed(table), reversed(points), strict=True):
        shifted = [Fraction(0), *found]
        for i, old in enumerate(found):
            shifted[i] -= old * t
        shifted[0] += c
        found = shifted
    while found and not found[-1]:
        found.pop()
    return found or None


def rational_roots(f: Sequence[Fraction], reach: Fraction) -> list[Fraction]:
    """The roots between −reach and reach with a small denominator, exact, at which the polynomial changes its sign."""
    grid = [reach * Fraction(2 * k - _GRID, _GRID) for k in range(_GRID + 1)]
    values = [_at(f, t) for t in grid]
    found = [t for t, v in zip(grid, values, strict=True) if v == 0 and t.denominator <= _MOST_DENOMINATOR]
    for (a, p), (b, q) in pairwise(zip(grid, values, strict=True)):
        if p * q < 0:
            root = _between(f, a, b).limit_denominator(_MOST_DENOMINATOR)
            if a <= root <= b and _at(f, root) == 0:
                found.append(root)
    return sorted({t for t in found if t}, key=lambda t: (abs(t), t))


def _between(f: Sequence[Fraction], a: Fraction, b: Fraction) -> Fraction:
    """A place within 2^-40 of the root between two places of different signs."""
    negative = _at(f, a) < 0
    for _ in range(46):
        middle = ((a + b) / 2).limit_denominator(1 << 60)
        if (_at(f, middle) < 0) == negative:
            a = middle
        else:
            b = middle
    return (a + b) / 2


def _at(f: Sequence[Fraction], t: Fraction) -> Fraction:
    value = Fraction(0)
    for c in reversed(f):
        value = value * t + c
    return value
