r"""Singular members of a family, exact: roots of polynomials modulo the prime along lines of parameters.

A value such as a determinant is a polynomial in the parameter t of a path of members. It is interpolated, and its roots
modulo the prime are members at which it vanishes exactly.

>>> sorted(roots([6, PRIME - 5, 1]))
[2, 3]
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence

from gcrules.algebra.evaluate import PRIME
from gcrules.core.budget import checkpoint

__all__ = ["PRIME", "Poly", "at", "divided", "gcd", "interpolated", "radical", "roots"]

_DEGREES = (3, 7, 15, 31, 63)
_CHECKS = (1_000_003, 2_000_029)

Poly = list[int]  # coefficients of 1, t, t² …; the last is not zero


def interpolated(value: Callable[[int], int]) -> Poly | None:
    """The polynomial that takes these values modulo the prime (degree 63 at most, else None); checked at two points."""
    known: list[int] = []
    for degree in _DEGREES:
        checkpoint()
        known += [value(t) % PRIME for t in range(len(known), degree + 1)]
        found = _newton(known)
        if all(at(found, t) == value(t) % PRIME for t in _CHECKS):
            return found
    return None


def _newton(values: Sequence[int]) -> Poly:
    """Interpolation at 0, 1, 2 … by divided differences."""
    table = list(values)
    for k in range(1, len(table)):
        inverse = pow(k, -1, PRIME)
        for i in range(len(table) - 1, k - 1, -1):
            table[i] = (table[i] - table[i - 1]) * inverse % PRIME
    found: Poly = []
    for k in range(len(table) - 1, -1, -1):  # found · (t − k) + table[k]
        shifted = [0, *found]
        for i, c in enumerate(found):
            shifted[i] = (shifted[i] - k * c) % PRIME
        shifted[0] = (shifted[0] + table[k]) % PRIME
        found = shifted
    return _trimmed(found)


def at(f: Poly, t: int) -> int:
    """The value at t."""
    value = 0
    for c in reversed(f):
        value = (value * t + c) % PRIME
    return value


def roots(f: Poly) -> tuple[int, ...]:
    """All roots modulo the prime, each once (of the zero polynomial none): Cantor and Zassenhaus' splitting."""
    f = _trimmed([c % PRIME for c in f])
    if len(f) < 2:
        return ()
    linear = gcd(_minus(_power([0, 1], PRIME, f), [0, 1]), f)
    return tuple(sorted(_split(linear, random.Random(1))))


def _split(f: Poly, rng: random.Random) -> list[int]:
    """The roots of a product of different linear factors."""
    if len(f) < 2:
        return []
    if len(f) == 2:
        return [-f[0] * pow(f[1], -1, PRIME) % PRIME]
    while True:
        half = _minus(_power([rng.randrange(PRIME), 1], (PRIME - 1) // 2, f), [1])
        part = gcd(half, f)
        if 1 < len(part) < len(f):
            return _split(part, rng) + _split(divided(f, part)[0], rng)


def _trimmed(f: Poly) -> Poly:
    while f and not f[-1]:
        f.pop()
    return f


def _minus(f: Poly, g: Poly) -> Poly:
    size = max(len(f), len(g))
    return _trimmed(
        [((f[i] if i < len(f) else 0) - (g[i] if i < len(g) else 0)) % PRIME for i in range(size)],
    )


def _times(f: Poly, g: Poly) -> Poly:
    found = [0] * (len(f) + len(g) - 1) if f and g else []
    for i, a in enumerate(f):
        for j, b in enumerate(g):
            found[i + j] = (found[i + j] + a * b) % PRIME
    return _trimmed(found)


def divided(f: Poly, g: Poly) -> tuple[Poly, Poly]:
    """Quotient and remainder modulo the prime."""
    rest, lead = list(f), pow(g[-1], -1, PRIME)
    quotient = [0] * max(len(f) - len(g) + 1, 0)
    for k in range(len(quotient) - 1, -1, -1):
        c = rest[k + len(g) - 1] * lead % PRIME
        quotient[k] = c
        for i, b in enumerate(g):
            rest[k + i] = (rest[k + i] - c * b) % PRIME
    return _trimmed(quotient), _trimmed(rest)


def gcd(f: Poly, g: Poly) -> Poly:
    """A greatest common divisor modulo the prime, up to a number."""
    while g:
        checkpoint()
        f, g = g, divided(f, g)[1]
    return f


def radical(f: Poly) -> Poly:
    """The polynomial with the same zeros, each of them once, and leading coefficient 1.

    >>> radical([0, 0, 2])  # 2 t²
    [0, 1]
    """
    if len(f) < 2:
        return [1] if f else []
    found = divided(f, gcd(f, _trimmed([n * c % PRIME for n, c in enumerate(f)][1:])))[0]
    lead = pow(found[-1], -1, PRIME)
    return [c * lead % PRIME for c in found]


def _power(base: Poly, exponent: int, modulus: Poly) -> Poly:
    found, base = [1], divided(base, modulus)[1]
    while exponent:
        checkpoint()
        if exponent & 1:
            found = divided(_times(found, base), modulus)[1]
        base = divided(_times(base, base), modulus)[1]
        exponent >>= 1
    return found
