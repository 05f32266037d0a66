r"""Exact arithmetic with formal square roots over the rational functions of some variables, and norms there.

A `Surd` is scale · Σ part · (product of roots) / ∏ divisor^power: parts are polynomials with whole coefficients, by the
set of their roots (as bits), divisors are irreducible and cancelled. Each root s_i is formal: s_i² is its radicand, in
which earlier roots may occur, and both signs count alike, also where the radicand is a square. So the product of a
surd over all signs of its roots, its norm, is a rational function.

>>> from gcrules.poses.loci.known import whole_ring
>>> field = SurdField(whole_ring(["x"]))
>>> x = field.gens[0]
>>> r = (x + 1).root()
>>> n, roots = norm((2 + x * r) * (x * x + 1).inverse())
>>> print(n), roots
(1) (-x^3 - x^2 + 4) / (x^2 + 1)^2
(None, (0,))
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import gcd, isqrt, lcm
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.loci.form import PolynomialForm

__all__ = ["MAX_SURD_TERMS", "Surd", "SurdField", "eliminated_roots", "norm"]

MAX_SURD_TERMS = 60_000
"""Surds of more terms are not computed with."""

_FACTORED = 80  # terms of divisors that are factored; longer ones stay whole
_POINT = (1009, 1013, 1019, 1021, 1031, 1033, 1039)  # where divisibility is tried
_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)

Parts = Mapping[int, Any]


class SurdField:
    """The variables are those of `ring`, over the whole numbers; roots and divisors come as they are needed. The square
    root of a surd is its formal root times a number whose sign is that of the product of the divisors in `signs`.
    """

    def __init__(self, ring: Any) -> None:
        self.ring = ring
        self.radicands: list[Parts] = []
        self.signs: list[tuple[int, ...]] = []
        self.divisors: list[Any] = []
        self.values: list[int] = []
        self.gens = tuple(Surd(self, Fraction(1), {0: x}, {}) for x in ring.gens)

    def number(self, c: int | Fraction) -> Surd:
        """A rational number."""
        return Surd(self, Fraction(c), {0: self.ring.one}, {}) if c else Surd(self, Fraction(1), {}, {})

    def made(self, scale: Fraction, parts: Parts, below: Mapping[int, int]) -> Surd:
        """A surd in lowest terms."""
        parts = {m: p for m, p in parts.items() if p}
        if not parts:
            return self.number(0)
        terms = sum(map(len, parts.values()))
        checkpoint()
        if terms > MAX_SURD_TERMS:
            raise LimitReached(
                f"eliminating the joints makes polynomials of more than {MAX_SURD_TERMS:,} terms",
                hint="leave fewer coordinates free: name some with --over, or give values to others with --fix",
            )
        content = gcd(*(int(c) for p in parts.values() for c in p.coeffs()))
        if content != 1:
            parts = {m: p.quo_ground(content) for m, p in parts.items()}
        left = {}
        for k, times in below.items():
            while times and (quotients := self._divided(parts, k)):
                parts, times = quotients, times - 1
            if times:
                left[k] = times
        return Surd(self, scale * content, parts, left)

    def _divided(self, parts: Parts, k: int) -> Parts | None:
        """All parts by a divisor; None where it does not divide each."""
        divisor, value = self.divisors[k], self.values[k]
        if value > 1 and any(_value(p, value) for p in parts.values()):
            return None
        found = {}
        for m, p in parts.items():
            (quotient,), rest = p.div([divisor])
            if rest:
                return None
            found[m] = quotient
        return found

    def power(self, below: Mapping[int, int]) -> Any:
        """The product of divisors with these powers."""
        found = self.ring.one
        for k, times in below.items():
            found = found * self.divisors[k] ** times
        return found

    def product(self, one: Parts, other: Parts) -> dict[int, Any]:
        """Products of parts, squares of roots replaced."""
        found: dict[int, Any] = {}
        for m, p in one.items():
            for n, q in other.items():
                checkpoint()
                for mask, r in self._reduced(m & n, {m ^ n: p * q}).items():
                    found[mask] = found[mask] + r if mask in found else r
        return found

    def _reduced(self, twice: int, parts: dict[int, Any]) -> Parts:
        """Parts times the radicands of some roots."""
        while twice:
            last = twice.bit_length() - 1
            parts, twice = self.product(parts, self.radicands[last]), twice ^ (1 << last)
        return parts

    def root(self, radicand: Parts, signs: tuple[int, ...]) -> int:
        """The number of a new root: two joints have signs of their own, also where their radicands are equal."""
        self.radicands.append(radicand)
        self.signs.append(signs)
        return len(self.radicands) - 1

    def divided_by(self, p: Any) -> tuple[Fraction, dict[int, int]]:
        """What dividing by a polynomial that is not 0 is: the content, and powers of divisors."""
        content, factors = p.factor_list() if len(p) <= _FACTORED else (1, [(p, 1)])
        below = {}
        for q, times in factors:
            if q.LC < 0:
                q, content = -q, content * (-1) ** times
            if q not in self.divisors:
                self.divisors.append(q)
                self.values.append(abs(int(q.evaluate(list(zip(q.ring.gens, _POINT, strict=False))))))
            below[self.divisors.index(q)] = times
        return Fraction(int(content)), below


@dataclass(frozen=True, eq=False)
class Surd:
    """scale · Σ parts / ∏ divisor^power (`below`), in lowest terms; without parts it is 0."""

    field: SurdField
    scale: Fraction
    parts: Parts
    below: Mapping[int, int]

    def __bool__(self) -> bool:
        return bool(self.parts)

    def __neg__(self) -> Surd:
        return Surd(self.field, -self.scale, self.parts, self.below)

    def __add__(self, other: Any) -> Surd:
        other = self._surd(other)
        if not self or not other:
            return self or other
        below = {k: max(self.below.get(k, 0), other.below.get(k, 0)) for k in (*self.below, *other.below)}
        scale = Fraction(
            gcd(self.scale.numerator, other.scale.numerator), lcm(self.scale.denominator, other.scale.denominator)
        )
        found: dict[int, Any] = {}
        for s in (self, other):
            by = self.field.power({k: n - s.below.get(k, 0) for k, n in below.items()}) * int(s.scale / scale)
            for m, p in s.parts.items():
                found[m] = found[m] + p * by if m in found else p * by
        return self.field.made(scale, found, below)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Surd:
        return self.__add__(-self._surd(other))

    def __rsub__(self, other: Any) -> Surd:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Surd:
        if isinstance(other, int | Fraction):
            return Surd(self.field, self.scale * other, self.parts, self.below) if other else self.field.number(0)
        below = {k: self.below.get(k, 0) + other.below.get(k, 0) for k in (*self.below, *other.below)}
        return self.field.made(self.scale * other.scale, self.field.product(self.parts, other.parts), below)

    __rmul__ = __mul__

    def _surd(self, other: Any) -> Surd:
        return other if isinstance(other, Surd) else self.field.number(other)

    @property
    def roots(self) -> int:
        """The roots that occur, as bits."""
        found = 0
        for m in self.parts:
            found |= m
        return found

    def inverse(self) -> Surd:
        """1 / self. Raises InputError for 0."""
        field = self.field
        if not self:
            raise InputError(
                "a limb has no definite place in any of these poses: what its equation is divided by is 0 there",
                hint="leave another coordinate free, or give others other values",
            )
        if self.roots:
            conjugate = self.conjugate(self.roots.bit_length() - 1)
            return conjugate * (self * conjugate).inverse()
        content, below = field.divided_by(self.parts[0])
        return field.made(1 / (self.scale * content), {0: field.power(self.below)}, below)

    def conjugate(self, root: int) -> Surd:
        """With the other sign of a root."""
        bit = 1 << root
        parts = {m: -p if m & bit else p for m, p in self.parts.items()}
        return Surd(self.field, self.scale, parts, self.below)

    def root(self) -> Surd:
        """A formal square root."""
        field = self.field
        if not self:
            return self
        odd = field.power({k: n % 2 for k, n in self.below.items()})
        square, rest = _square_part(self.scale.numerator * self.scale.denominator)
        below = {k: (n + 1) // 2 for k, n in self.below.items()}
        signs = tuple(k for k, n in below.items() if n % 2)
        number = field.root({m: p * odd * rest for m, p in self.parts.items()}, signs)
        return Surd(field, Fraction(square, self.scale.denominator), {1 << number: field.ring.one}, below)

    def __str__(self) -> str:
        above = " + ".join(
            f"({PolynomialForm.of(p)})" + "".join(f" s{k}" for k in range(m.bit_length()) if m >> k & 1)
            for m, p in self.parts.items()
        )
        below = " ".join(f"({PolynomialForm.of(self.field.divisors[k])})^{n}" for k, n in self.below.items())
        return f"({self.scale}) {above}" + (f" / {below}" if below else "")


def eliminated_roots(x: Surd) -> tuple[int, ...]:
    """The roots that a surd depends on, also through radicands."""
    every, left = 0, x.roots
    while left:
        last = left.bit_length() - 1
        every |= 1 << last
        left ^= 1 << last
        for mask in x.field.radicands[last]:
            left |= mask
    return tuple(k for k in range(every.bit_length()) if every >> k & 1)


def norm(x: Surd) -> tuple[Surd, tuple[int, ...]]:
    """The product over both signs of each root that it depends on, also through radicands, and which roots these are.

    It is a rational function: the last root is eliminated first, for radicands know earlier ones only. Raises
    LimitReached where it grows beyond `MAX_SURD_TERMS`.
    """
    field, eliminated = x.field, []
    while x.roots:
        last = x.roots.bit_length() - 1
        eliminated.append(last)
        bit = 1 << last
        rest = {m: p for m, p in x.parts.items() if not m & bit}
        along = {m ^ bit: p for m, p in x.parts.items() if m & bit}
        square = field.product(along, field.product(along, field.radicands[last]))
        total = field.product(rest, rest)
        for m, p in square.items():
            total[m] = total[m] - p if m in total else -p
        x = field.made(x.scale**2, total, {k: 2 * n for k, n in x.below.items()})
    return x, tuple(sorted(eliminated))


def _value(p: Any, modulus: int) -> int:
    """The value at the point of trials, modulo a number."""
    total = 0
    powers = [_powers(x, p.degree(g), modulus) for x, g in zip(_POINT, p.ring.gens, strict=False)]
    for e, c in p.terms():
        term = int(c)
        for row, n in zip(powers, e, strict=True):
            term = term * row[n] % modulus
        total += term
    return total % modulus


def _powers(x: int, degree: Any, modulus: int) -> list[int]:
    found = [1]
    for _ in range(max(int(degree), 0)):
        found.append(found[-1] * x % modulus)
    return found


def _square_part(c: int) -> tuple[int, int]:
    """(s, r): c = s² r, without the squares of small primes in r."""
    sign, c, square = (-1 if c < 0 else 1), abs(c), 1
    for p in _PRIMES:
        while c % (p * p) == 0:
            c, square = c // (p * p), square * p
    whole = isqrt(c)
    return (square * whole, sign) if whole * whole == c else (square, sign * c)
