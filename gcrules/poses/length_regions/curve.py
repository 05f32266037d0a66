r"""The singular lengths over two lengths: an algebraic curve in their squares, and the lines on which it is critical.

The curve D(x, y) = 0 is had from its values, as all polynomials here. It is of degree 12 for a generic robot. Where its
resultant with its derivative by y vanishes a line x = const is critical: it touches the curve, passes through a
crossing, a cusp or an isolated point. Everything is exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property, reduce
from itertools import count
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.length_regions.integer_polynomials import (
    derivative,
    interpolated,
    primitive,
    reach_of,
    roots_between,
    subresultants,
    value_at,
)
from gcrules.poses.paths.roots import WIDTH, Root, integers, value

__all__ = ["CriticalLine", "SingularCurve"]

_DEGREE = 12
_MORE = 2  # values beyond what is needed, which check it
_FINE = 64  # bits after the point of a place on a critical line
_MOST_BITS = 1 << 14


@dataclass(frozen=True)
class CriticalLine:
    """x strictly between `low` and `high`, and no other critical x from the one to the other.

    Its multiplicity as a zero of the resultant is `order`, 0 where the line is critical only as the curve meets one of
    the `edges` there. `height` bounds y at the only double point on it, None where that is not known to be one.
    """

    low: Fraction
    high: Fraction
    order: int
    edges: tuple[int, ...]
    height: tuple[Fraction, Fraction] | None


@dataclass(frozen=True)
class SingularCurve:
    """Coefficients of y⁰, y¹ …, each a polynomial in x with whole coefficients."""

    columns: tuple[tuple[int, ...], ...]

    @classmethod
    def of(cls, value_of: Callable[[int, int], Fraction | None], step: int) -> SingularCurve | None:
        """From the values at whole places, `step` apart; None if they are not those of a polynomial of degree 12 whose
        highest power of y has a constant coefficient.
        """
        number = _DEGREE + 1 + _MORE
        places = [step * (2 * i + 1) for i in range(number)]
        rows = [_row(value_of, x, step, number) for x in places]
        if any(row is None or len(row) > _DEGREE + 1 for row in rows):
            return None
        found = [row for row in rows if row is not None]
        most = max(map(len, found))
        if most < 2:
            return None
        columns = [interpolated(places, [r[j] if j < len(r) else 0 for r in found]) for j in range(most)]
        if len(columns[-1]) != 1 or any(len(c) > _DEGREE + 1 for c in columns):
            return None
        return cls(tuple(map(tuple, primitive(columns))))

    def along_y(self, x: Fraction) -> list[Fraction]:
        """The polynomial in y."""
        return [Fraction(value_at(c, x)) for c in self.columns]

    def along_x(self, y: Fraction) -> list[Fraction]:
        """The polynomial in x, without leading zeros."""
        found = [Fraction(0)] * max(map(len, self.columns))
        power = Fraction(1)
        for c in self.columns:
            for i, a in enumerate(c):
                found[i] += a * power
            power *= y
        while found and not found[-1]:
            found.pop()
        return found

    def heights(self, x: Fraction) -> list[Root]:
        """All real y on the curve, in ascending order."""
        p = self.along_y(x)
        reach = reach_of(p)
        return roots_between(p, -reach, reach)

    @cached_property
    def elimination(self) -> tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]] | None:
        """The resultant r(x) of D and its derivative by y, and the coefficients of 1 and y of their subresultant of
        degree 1, up to common numbers; None if r vanishes everywhere, for the curve has a multiple part then.
        """
        n = len(self.columns) - 1
        number = _DEGREE * (_DEGREE - 1) + 1 + _MORE
        places, values = [], []
        for x in count(1):
            checkpoint()
            p = [value_at(c, x) for c in self.columns]
            if n == 1:
                found: tuple[list[int], int] | None = p, derivative(p)[0]
            else:
                found = subresultants(p, derivative(p))
            if found is not None and found[1]:
                places.append(x)
                values.append((found[1], *found[0]))
            if len(places) == number:
                break
            if x > 3 * number:
                return None
        r, s0, s1 = (interpolated(places, [v[k] for v in values]) for k in range(3))
        if not r or len(r) > number - _MORE:
            return None
        both = primitive([s0, s1])
        return tuple(integers(r)), tuple(both[0]), tuple(both[1])

    def critical_lines(self, low: Fraction, high: Fraction, edges: Sequence[Fraction]) -> list[CriticalLine] | None:
        """Those with `low` < x < `high`, in ascending order; None where they cannot be had."""
        from sympy import ZZ, Poly, Symbol

        if self.elimination is None:
            return None
        x = Symbol("x")
        resultant_, *double = self.elimination
        parts: list[tuple[int, list[int]]] = []
        for factor, order in Poly(list(resultant_)[::-1], x, domain=ZZ).sqf_list()[1]:
            parts.append((order, [int(c) for c in factor.all_coeffs()[::-1]]))
        along = [integers(self.along_x(e)) for e in edges]
        if not all(along):
            return None
        simple = [Poly(p[::-1], x, domain=ZZ).sqf_part() for p in along]
        every = reduce(Poly.lcm, [Poly(p[::-1], x, domain=ZZ) for _, p in parts] + simple)
        whole = [int(c) for c in every.all_coeffs()[::-1]]
        of_edges = [[int(c) for c in p.all_coeffs()[::-1]] for p in simple]
        found = []
        for at, end in _apart(whole, roots_between(whole, low, high), low, high):
            orders = [(order, p) for order, p in parts if _changes(p, at, end)]
            met = tuple(k for k, p in enumerate(of_edges) if _changes(p, at, end))
            order = orders[0][0] if orders else 0
            height = _height(double, orders[0][1], at, end) if orders else None
            found.append(CriticalLine(at, end, order, met, height))
        return found


def _row(value_of: Callable[[int, int], Fraction | None], x: int, step: int, number: int) -> list[Fraction] | None:
    places: list[int] = []
    values: list[Fraction] = []
    for k in range(3 * number):
        y = step * (3 * k + 1)
        here = value_of(x, y)
        if here is not None:
            places.append(y)
            values.append(here)
        if len(places) == number:
            return interpolated(places, values)
    return None


def _apart(p: Sequence[int], found: Sequence[Root], low: Fraction, high: Fraction) -> list[tuple[Fraction, Fraction]]:
    """Intervals with the zeros strictly inside, that do not touch; without zeros at `low` and `high`."""
    inside = [r for r in found if low < r.upper and r.lower < high and not (r.exact and r.lower in (low, high))]
    narrow = [(r.lower, r.upper) if r.exact else _inside(p, r.lower, r.upper) for r in inside]
    ends = [low, *(c for pair in narrow for c in pair), high]
    room = [min((b - a) / 4, (high - low) * WIDTH) for a, b in zip(ends[::2], ends[1::2], strict=True)]
    return [
        (one - before, other + after) if one == other else (one, other)
        for (one, other), before, after in zip(narrow, room, room[1:], strict=False)
    ]


def _inside(p: Sequence[int], low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
    """A narrower interval with the only zero between, whose ends, which may be zeros, are both moved."""
    one, other = low, high
    below = value(p, low) or value(derivative(p), low)
    while one == low or other == high:
        middle = (one + other) / 2
        there = value(p, middle)
        if not there:
            return middle, middle
        one, other = (middle, other) if (there > 0) == (below > 0) else (one, middle)
    return one, other


def _changes(p: Sequence[int], low: Fraction, high: Fraction) -> bool:
    """Whether a polynomial without multiple zeros changes its sign: it has one zero in between, or none."""
    return (value(p, low) > 0) != (value(p, high) > 0)


def _height(double: Sequence[Sequence[int]], p: Sequence[int], low: Fraction, high: Fraction) -> Any:
    """Bounds of y = −s₀/s₁ at the zero of p, near each other; None where s₁ may vanish there."""
    bits = _FINE
    reach = max(abs(low), abs(high), Fraction(1))
    while bits <= _MOST_BITS:
        checkpoint()
        low, high = _narrowed(p, low, high, Fraction(1, 1 << bits))
        s0, s1 = (_bounds(s, low, high, reach) for s in double)
        if s1[0] > 0 or s1[1] < 0:
            ends = [-a / b for a in s0 for b in s1]
            least, most = _rounded(min(ends), -1), _rounded(max(ends), 1)
            if most - least < Fraction(1, 1 << (_FINE - 24)):
                return least, most
        bits *= 2
    return None


def _narrowed(p: Sequence[int], low: Fraction, high: Fraction, width: Fraction) -> tuple[Fraction, Fraction]:
    """The interval around the simple zero of p, halved until it is not wider."""
    below = value(p, low) > 0
    while high - low > width:
        middle = (low + high) / 2
        there = value(p, middle)
        if not there:
            return middle - width / 2, middle + width / 2
        low, high = (middle, high) if (there > 0) == below else (low, middle)
    return low, high


def _bounds(p: Sequence[int], low: Fraction, high: Fraction, reach: Fraction) -> tuple[Fraction, Fraction]:
    """Of the values from `low` to `high`, both within `reach`, by the mean value theorem."""
    middle = (low + high) / 2
    here = value_at(p, middle)
    slope = value_at([abs(c) for c in derivative(p)], reach)
    doubt = slope * (high - low) / 2
    return here - doubt, here + doubt


def _rounded(x: Fraction, way: int) -> Fraction:
    top = x * (1 << _FINE)
    whole = top.numerator // top.denominator
    return Fraction(whole + (way > 0), 1 << _FINE)
