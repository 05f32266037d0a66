r"""All real zeros of an exact polynomial in [0, 1], with their multiplicities: no sampling, no floats.

Polynomials are lists of integers, lowest power first. Halving and Descartes' rule of signs isolate the zeros (Vincent,
Collins, Akritas). Where that would not end, as some are multiple, or take long, as some are very near each other, sympy
does (Yun's factors without multiple zeros, then continued fractions); it takes half a second to load. Everything is
exact: nothing is missed, a touching zero neither.

>>> [(str(r.lower), r.multiplicity) for r in roots([-1, 7, -16, 12])]            # (3x − 1) (2x − 1)²
[('1/3', 1), ('1/2', 2)]
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import content

__all__ = ["WIDTH", "Root", "integers", "roots", "sign_after", "sign_before", "value"]

Poly = list[int]

WIDTH = Fraction(1, 2**60)
"""An interval that holds a zero is not wider than this."""

_NEAR = Fraction(1, 2**24)  # zeros that are not told apart on intervals of this width are left to sympy
_SIMPLE = 10**6  # quotients with denominators up to this are tried as the zero itself


@dataclass(frozen=True)
class Root:
    """One real zero: strictly between `lower` and `upper`, or exactly `lower` = `upper`."""

    lower: Fraction
    upper: Fraction
    multiplicity: int

    @property
    def middle(self) -> Fraction:
        return (self.lower + self.upper) / 2

    @property
    def exact(self) -> bool:
        return self.lower == self.upper


def integers(coefficients: Sequence[Fraction | int]) -> Poly:
    """The polynomial times a positive number, with coprime integer coefficients and without leading zeros."""
    p = [Fraction(c) for c in coefficients]
    while p and not p[-1]:
        p.pop()
    divisor = content(p) if p else 1
    return [int(c / divisor) for c in p]


def value(p: Sequence[int], x: Fraction) -> int:
    """The sign of p at x is that of the result, p(x) times a power of the denominator."""
    top, bottom, total, power = x.numerator, x.denominator, 0, 1
    for c in reversed(p):
        total = total * top + c * power
        power *= bottom
    return total


def sign_after(p: Sequence[int]) -> int:
    """The sign of p just above 0; 0 for the zero polynomial."""
    return next((1 if c > 0 else -1 for c in p if c), 0)


def sign_before(p: Sequence[int]) -> int:
    """The sign of p just below 1; 0 for the zero polynomial."""
    return sign_after(_seen_from_one(p))


def roots(coefficients: Sequence[Fraction | int]) -> tuple[Root, ...]:
    """All zeros in [0, 1] in ascending order, in disjoint intervals. The zero polynomial is refused (ValueError)."""
    p = integers(coefficients)
    if not p:
        raise ValueError("every number is a zero of the zero polynomial")
    at_zero, at_one = (next(n for n, c in enumerate(q) if c) for q in (p, _seen_from_one(p)))
    ends = [Root(Fraction(x), Fraction(x), n) for x, n in ((0, at_zero), (1, at_one)) if n]
    inside = _halved(p)
    return tuple(_isolated(p)) if inside is None else tuple(sorted([*ends, *inside], key=lambda r: r.lower))


def _shifted(p: Sequence[int]) -> Poly:
    """p(x + 1)."""
    found = list(p)
    for i in range(len(found) - 1):
        for j in range(len(found) - 2, i - 1, -1):
            found[j] += found[j + 1]
    return found


def _seen_from_one(p: Sequence[int]) -> Poly:
    """(1 + x)ⁿ p(1 / (1 + x)), n the degree: x from 0 to ∞ runs through p from 1 to 0."""
    return _shifted(p[::-1])


def _halved(p: Poly) -> list[Root] | None:
    """The zeros in (0, 1), as long as halving tells them apart; else None."""
    found: list[Root] = []
    waiting = [(p, Fraction(0), Fraction(1))]  # what is seen of p on [start, start + width], as a function on [0, 1]
    while waiting:
        checkpoint()
        q, start, width = waiting.pop()
        signs = [c > 0 for c in _seen_from_one(q) if c]
        changes = sum(a != b for a, b in pairwise(signs))  # zeros in (0, 1): never more, and exactly so many if 0 or 1
        if changes == 1:
            r = _single(q)
            found.append(_exactly(Root(start + width * r.lower, start + width * r.upper, 1), p))
        elif changes and width < _NEAR:
            return None
        elif changes:
            low = [c << (len(q) - 1 - n) for n, c in enumerate(q)]  # q(x / 2) and q((1 + x) / 2), times a power of 2
            high = _shifted(low)
            if not high[0]:
                found.append(Root(start + width / 2, start + width / 2, next(n for n, c in enumerate(high) if c)))
            waiting += [(low, start, width / 2), (high, start + width / 2, width / 2)]
    return found


def _single(p: Poly) -> Root:
    """The only zero in (0, 1), a simple one, by halving."""
    low, high, below = Fraction(0), Fraction(1), sign_after(p)
    while high - low > WIDTH:
        checkpoint()
        middle = (low + high) / 2
        there = value(p, middle)
        if not there:
            return Root(middle, middle, 1)
        low, high = (middle, high) if (there > 0) == (below > 0) else (low, middle)
    return _exactly(Root(low, high, 1), p)


def _isolated(p: Poly) -> list[Root]:
    """All zeros in [0, 1], by sympy's exact arithmetic."""
    from sympy import QQ, ZZ, Poly, Symbol

    checkpoint()
    intervals = Poly(p[::-1], Symbol("x"), domain=ZZ).intervals(eps=QQ(1, WIDTH.denominator), inf=0, sup=1)
    return [_exactly(Root(_fraction(low), _fraction(high), n), p) for (low, high), n in intervals]


def _fraction(x: Any) -> Fraction:
    """Of a rational number of sympy."""
    return Fraction(int(x.p), int(x.q))


def _exactly(r: Root, p: Poly) -> Root:
    """The zero itself if it is a simple quotient."""
    near = r.middle.limit_denominator(_SIMPLE)
    simple = not r.exact and r.lower < near < r.upper and not value(p, near)
    return Root(near, near, r.multiplicity) if simple else r
