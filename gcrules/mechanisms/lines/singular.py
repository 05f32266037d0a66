r"""Singular members of a family, exact: roots of polynomials modulo the prime along lines of parameters.

A value such as a determinant is a polynomial in the parameter t of a path of members. It is interpolated, and its roots
modulo the prime are members at which it vanishes exactly.

>>> sorted(roots([6, PRIME - 5, 1]))
[2, 3]
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Sequence
from functools import cache

from gcrules.algebra.evaluate import PRIME
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import FirstRows, permutation_sign
from gcrules.screws import RESIDUES

__all__ = ["PRIME", "Mixing", "Poly", "at", "divided", "gcd", "interpolated", "radical", "roots"]

_HIGHEST = 63
_CHECKS = (1_000_003, 2_000_029)

_Rows = Sequence[Sequence[int]]
Poly = list[int]  # coefficients of 1, t, t² …; the last is not zero


def interpolated(value: Callable[[int], int]) -> Poly | None:
    """The polynomial that takes these values modulo the prime (degree 63 at most, else None); checked at two points.

    Newton's interpolation at 0, 1, 2 … goes on until the checks agree: Σ c_k t (t − 1) … (t − k + 1).
    """
    checks = [value(t) % PRIME for t in _CHECKS]
    seen, basis = [0] * len(_CHECKS), [1] * len(_CHECKS)
    coefficients: Poly = []
    factorial = 1
    for n in range(_HIGHEST + 1):
        checkpoint()
        factorial = factorial * (n or 1) % PRIME
        coefficients.append((value(n) - _newton(coefficients, n)) * pow(factorial, -1, PRIME) % PRIME)
        seen = [(x + coefficients[-1] * b) % PRIME for x, b in zip(seen, basis, strict=True)]
        if seen == checks:
            return _expanded(coefficients)
        basis = [b * (t - n) % PRIME for b, t in zip(basis, _CHECKS, strict=True)]
    return None


class Mixing:
    """Random combinations of rows, in random coordinates, as many as the rank that the rows have `usual`ly: their
    determinant vanishes where the rows have less rank, and elsewhere hardly ever.

    All combinations A · rows · Bᵀ with an invertible first block of A and of B have, up to a number, the determinant of
    those in which these blocks are unit matrices; the other blocks are drawn. Up to its sign that is the determinant of
    the rows in a frame, which keeps their zeros: beside them columns that A takes to 0, below them rows that Bᵀ does.
    """

    def __init__(self, rng: random.Random, rows: _Rows, usual: int) -> None:
        height, width = len(rows), len(rows[0]) if rows else usual
        left, right = (
            [[rng.randrange(PRIME) for _ in range(size - usual)] for _ in range(usual)] for size in (height, width)
        )
        corner = [0] * (height - usual)
        self._beside = _taken_to_zero(left, height - usual)
        self._below = [(*row, *corner) for row in zip(*_taken_to_zero(right, width - usual), strict=True)]

    def along(self, rows_at: Callable[[int], _Rows]) -> Callable[[int], int]:
        """The determinant modulo the prime at t, for rows of this shape that depend on t. Rows that are the same at two
        members are eliminated once, and a member at which one of them is another one is computed by itself.
        """
        rows_at = cache(rows_at)
        first, second = rows_at(0), rows_at(1)
        same = [i for i, (a, b) in enumerate(zip(first, second, strict=True)) if a == b]
        others = [i for i in range(len(first)) if i not in same]
        sign = permutation_sign([*same, *range(len(first), len(first) + len(self._below)), *others])
        above = FirstRows([*self._framed(first, same), *self._below], PRIME)

        def value(t: int) -> int:
            rows = rows_at(t)
            if any(rows[i] != first[i] for i in same):
                return int(RESIDUES.determinant([*self._framed(rows, range(len(rows))), *self._below]))
            return sign * above.determinant(self._framed(rows, others))

        return value

    def _framed(self, rows: _Rows, places: Iterable[int]) -> list[Sequence[int]]:
        return [(*rows[i], *self._beside[i]) for i in places]


def _taken_to_zero(drawn: _Rows, size: int) -> list[Sequence[int]]:
    """The rows of a matrix whose `size` columns (1, drawn) takes to 0."""
    unit = [[int(i == j) for j in range(size)] for i in range(size)]
    return [*([-x % PRIME for x in row] for row in drawn), *unit]


def _newton(coefficients: Poly, t: int) -> int:
    """The value at t of Σ c_k t (t − 1) … (t − k + 1)."""
    value = 0
    for k in range(len(coefficients) - 1, -1, -1):
        value = (value * (t - k) + coefficients[k]) % PRIME
    return value


def _expanded(coefficients: Poly) -> Poly:
    """Σ c_k t (t − 1) … (t − k + 1) in powers of t."""
    found: Poly = []
    for k in range(len(coefficients) - 1, -1, -1):  # found · (t − k) + c_k
        shifted = [0, *found]
        for i, c in enumerate(found):
            shifted[i] = (shifted[i] - k * c) % PRIME
        shifted[0] = (shifted[0] + coefficients[k]) % PRIME
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
    return tuple(sorted(_split(_monic(_trimmed([c % PRIME for c in f])), random.Random(1))))


def _split(f: Poly, rng: random.Random) -> list[int]:
    """The roots of a polynomial with leading coefficient 1, each once.

    Where x is a root, (x + a) to the power (p − 1) / 2 is 1, −1 or 0; in a larger field, where roots of other factors
    lie, it is another number.
    """
    if len(f) < 2:
        return []
    if len(f) == 2:
        return [-f[0] % PRIME]
    if len(f) == 3:
        middle = f[1] * pow(-2, -1, PRIME)
        root = RESIDUES.root(middle * middle - f[0])
        return [] if root is None else list({(middle + s * root) % PRIME for s in (1, -1)})
    a = rng.randrange(PRIME)
    power = _power([a, 1], (PRIME - 1) // 2, f)
    found = [] if at(f, -a) else [-a % PRIME]
    for sign in (1, -1):
        found += _split(_monic(gcd(_minus(power, [sign]), f)), rng)
    return found


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
    return _monic(found)


def _monic(f: Poly) -> Poly:
    """The polynomial divided by its leading coefficient."""
    if not f or f[-1] == 1:
        return f
    lead = pow(f[-1], -1, PRIME)
    return [c * lead % PRIME for c in f]


def _power(base: Poly, exponent: int, modulus: Poly) -> Poly:
    """The power of a linear polynomial modulo one of degree 2 or more with leading coefficient 1, from the exponent's
    first digit on: squares, and products with the linear one.
    """
    (b, a), size, tail = base, len(modulus) - 1, modulus[:-1]
    found = [1] + [0] * (size - 1)
    for digit in f"{exponent:b}":
        checkpoint()
        product = [0] * (2 * size)
        for i, x in enumerate(found):
            if x:
                product[2 * i] += x * x
                twice = 2 * x
                for j in range(i + 1, size):
                    product[i + j] += twice * found[j]
        if digit == "1":
            product = [b * (x % PRIME) + a * (y % PRIME) for x, y in zip(product, [0, *product[:-1]], strict=True)]
        for k in range(2 * size - 1, size - 1, -1):
            if c := product[k] % PRIME:
                for i, x in enumerate(tail, k - size):
                    product[i] -= c * x
        found = [x % PRIME for x in product[:size]]
    return _trimmed(found)
