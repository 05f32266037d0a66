r"""Polynomials over the rationals: from their values to their coefficients, and to their rational roots in an interval.

>>> f = polynomial(lambda t: t * t - Fraction(1, 4))
>>> print(*f, *rational_roots(f, Fraction(2)))
-1/4 0 1 -1/2 1/2
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from gcrules.poses.paths.roots import roots

__all__ = ["polynomial", "rational_roots"]

_MOST_DEGREE = 8
_MOST_DENOMINATOR = 60


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
        found = _times_linear(found, -t, Fraction(1), c)
    while found and not found[-1]:
        found.pop()
    return found or None


def rational_roots(f: Sequence[Fraction], reach: Fraction) -> list[Fraction]:
    """The roots between −reach and reach with a small denominator, exact, at which the polynomial changes its sign."""
    moved: list[Fraction] = []  # in x with t = reach (2x − 1)
    for c in reversed(f):
        moved = _times_linear(moved, -reach, 2 * reach, c)
    found = {reach * (2 * r.middle - 1) for r in roots(moved) if r.exact and r.multiplicity % 2}
    return sorted({t for t in found if t and t.denominator <= _MOST_DENOMINATOR}, key=lambda t: (abs(t), t))


def _times_linear(p: Sequence[Fraction], a: Fraction, b: Fraction, c: Fraction) -> list[Fraction]:
    """p · (a + b t) + c."""
    product = [a * low + b * high for low, high in zip([*p, Fraction(0)], [Fraction(0), *p], strict=True)]
    return [product[0] + c, *product[1:]]
