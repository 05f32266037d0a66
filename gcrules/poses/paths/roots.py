r"""All real zeros of an exact polynomial in [0, 1], with their multiplicities: no sampling, no floats.

Polynomials are lists of integers, lowest power first. Zeros at 0 and 1 are divided out; Yun's algorithm parts the rest
into factors without multiple zeros, one for each multiplicity; Descartes' rule of signs and halving (Vincent, Collins,
Akritas) isolate the zeros of each. Everything is integer arithmetic, so nothing can be missed, a touching zero neither.

>>> [(str(r.lower), r.multiplicity) for r in roots([-1, 7, -16, 12])]            # (3x − 1) (2x − 1)²
[('1/3', 1), ('1/2', 2)]
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import gcd, lcm

from gcrules.core.budget import checkpoint

__all__ = ["WIDTH", "Root", "integers", "roots", "sign_after", "sign_before", "value"]

Poly = list[int]

WIDTH = Fraction(1, 2**60)
"""An interval that holds a zero is not wider than this."""

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
    found = [Fraction(c) for c in coefficients]
    common = lcm(*(c.denominator for c in found))
    return _primitive([int(c * common) for c in found])


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
    return sign_after([c * (-1) ** n for n, c in enumerate(_shifted(p))])


def roots(coefficients: Sequence[Fraction | int]) -> tuple[Root, ...]:
    """All zeros in [0, 1] in ascending order, in disjoint intervals. The zero polynomial is refused (ValueError)."""
    p = integers(coefficients)
    if not p:
        raise ValueError("every number is a zero of the zero polynomial")
    found: list[tuple[Root, Poly]] = []
    at_zero = next(n for n, c in enumerate(p) if c)
    p = p[at_zero:]
    at_one = 0
    while len(p) > 1 and not sum(p):
        checkpoint()
        p = _quotient(p, [-1, 1])
        at_one += 1
    for place, times in ((Fraction(0), at_zero), (Fraction(1), at_one)):
        if times:
            found.append((Root(place, place, times), [0]))
    for factor, times in _parted(p):
        found += [(Root(low, high, times), factor) for low, high in _isolated(factor)]
    return tuple(_apart([(_refined(r, q), q) for r, q in found]))


def _parted(p: Poly) -> Iterator[tuple[Poly, int]]:
    """Factors without multiple zeros, and the multiplicities of their zeros in p; what has no zero in (0, 1) may be
    left out.
    """
    changes = _changes(p)
    if changes <= 1:  # none, or a single one
        if changes:
            yield p, 1
        return
    slope = _derivative(p)
    common = _gcd(p, slope)
    b, c, times = _quotient(p, common), _quotient(slope, common), 1
    d = _difference(c, _derivative(b))
    while len(b) > 1:
        checkpoint()
        factor = _gcd(b, d)
        if len(factor) > 1:
            yield factor, times
        b, c, times = _quotient(b, factor), _quotient(d, factor), times + 1
        d = _difference(c, _derivative(b))


def _isolated(p: Poly) -> Iterator[tuple[Fraction, Fraction]]:
    """Intervals, each with exactly one of the zeros of p in (0, 1) inside; p has no multiple ones."""
    waiting = [(p, Fraction(0), Fraction(1))]
    while waiting:
        checkpoint()
        q, start, width = waiting.pop()
        changes = _changes(q)
        if changes == 1:
            yield start, start + width
        elif changes:
            half, degree = width / 2, len(q) - 1
            left = [c << (degree - n) for n, c in enumerate(q)]  # q(x/2), times a power of 2
            if not sum(left):
                yield start + half, start + half
                left = _quotient(left, [-1, 1])
            waiting += [(left, start, half), (_shifted(left), start + half, half)]


def _changes(p: Poly) -> int:
    """Descartes' bound for the number of zeros in (0, 1): exact if it is 0 or 1, and always of the right parity."""
    signs = [c > 0 for c in _shifted(p[::-1]) if c]
    return sum(a != b for a, b in pairwise(signs))


def _refined(r: Root, p: Poly) -> Root:
    """The interval halved down to `WIDTH`, or the zero itself if it is a simple quotient."""
    while not r.exact and r.upper - r.lower > WIDTH:
        checkpoint()
        r = _halved(r, p)
    near = r.middle.limit_denominator(_SIMPLE)
    if not r.exact and r.lower < near < r.upper and not value(p, near):
        return Root(near, near, r.multiplicity)
    return r


def _halved(r: Root, p: Poly) -> Root:
    middle = value(p, r.middle)
    if not middle:
        return Root(r.middle, r.middle, r.multiplicity)
    # p has no zero in the interval but one, a single one; near the lower end it has the sign of p just above it.
    low = value(p, r.lower) or -value(p, r.upper) or value(_derivative(p), r.lower)
    if (low > 0) != (middle > 0):
        return Root(r.lower, r.middle, r.multiplicity)
    return Root(r.middle, r.upper, r.multiplicity)


def _apart(found: Sequence[tuple[Root, Poly]]) -> list[Root]:
    """The same zeros, ascending, in intervals without a common inner point; zeros of different factors differ."""
    placed = sorted(found, key=lambda f: f[0].middle)
    while any(x.upper > y.lower for (x, _), (y, _) in pairwise(placed)):
        checkpoint()
        placed = [(r if r.exact else _halved(r, p), p) for r, p in placed]
        placed.sort(key=lambda f: f[0].middle)
    return [r for r, _ in placed]


# --- integer polynomials -------------------------------------------------------------------------------------------


def _primitive(p: Poly) -> Poly:
    """Divided by the greatest common divisor of the coefficients, without leading zeros."""
    while p and not p[-1]:
        p = p[:-1]
    common = gcd(*p)
    return [c // common for c in p] if common > 1 else p


def _shifted(p: Sequence[int]) -> Poly:
    """p(x + 1)."""
    found = list(p)
    for i in range(len(found) - 1):
        for j in range(len(found) - 2, i - 1, -1):
            found[j] += found[j + 1]
    return found


def _derivative(p: Poly) -> Poly:
    return [n * c for n, c in enumerate(p)][1:]


def _difference(p: Poly, q: Poly) -> Poly:
    size = max(len(p), len(q))
    found = [a - b for a, b in zip(p + [0] * (size - len(p)), q + [0] * (size - len(q)), strict=True)]
    while found and not found[-1]:
        found.pop()
    return found


def _quotient(p: Poly, q: Poly) -> Poly:
    """p / q, which is a polynomial with integer coefficients (q is primitive)."""
    rest, found = list(p), [0] * max(len(p) - len(q) + 1, 0)
    for n in reversed(range(len(found))):
        found[n] = rest[n + len(q) - 1] // q[-1]
        for i, c in enumerate(q):
            rest[n + i] -= found[n] * c
    return found


def _gcd(p: Poly, q: Poly) -> Poly:
    """The greatest common divisor, primitive, with a positive leading coefficient."""
    p, q = _primitive(p), _primitive(q)
    while q:
        checkpoint()
        p, q = q, _primitive(_remainder(p, q))
    return [-c for c in p] if p[-1] < 0 else p


def _remainder(p: Poly, q: Poly) -> Poly:
    """Of p times a power of the leading coefficient of q, after division by q."""
    rest = list(p)
    while len(rest) >= len(q):
        checkpoint()
        lead, gap = rest[-1], len(rest) - len(q)
        rest = [c * q[-1] for c in rest]
        for i, c in enumerate(q):
            rest[gap + i] -= lead * c
        rest.pop()
    return rest
