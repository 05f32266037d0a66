r"""Factors of the polynomial over the rationals, each proved irreducible.

A polynomial is irreducible if it is so on one rational line on which its degree does not fall; by Hilbert's theorem
almost every line tells, and on it mostly the degrees of factors modulo a few primes. So large polynomials need no
search, and sympy's is left for small ones.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.poses.numbers.cubic import FACTORED_BITS, bits

__all__ = ["MAX_TERMS", "PossibleFactor", "divided", "factored", "primitive"]

MAX_TERMS = 300
"""Polynomials of more terms that are reducible on lines are not factored by search."""

LINES = 4
_PRIMES = (101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197)
_SPREAD = 50  # lines go through points with whole coordinates up to this


@dataclass(frozen=True)
class PossibleFactor:
    """A polynomial that may divide: `kind` is norm | bracket, `name` what it is."""

    kind: str
    name: str
    polynomial: Any


def primitive(p: Any) -> tuple[Any, Any]:
    """(c, q): p = c q, q of whole coefficients without a common divisor, the first one positive; p is not 0."""
    c, q = p.clear_denoms()
    q = q.set_ring(q.ring.clone(domain=q.ring.domain.get_ring()))
    content, q = q.primitive()
    if q.LC < 0:
        content, q = -content, -q
    return p.ring.domain(int(content)) / p.ring.domain(int(c)), q


def factored(p: Any, candidates: Sequence[PossibleFactor], limit: int = MAX_TERMS) -> list[tuple[str, str, Any, int]]:
    """(kind, name, factor, multiplicity) of a primitive polynomial; the kind is norm | bracket | condition.

    Raises LimitReached for a part that is neither proved irreducible nor small enough for a search.
    """
    found = []
    for c in candidates:
        checkpoint()
        if c.polynomial.is_ground:
            continue
        for part, _ in _irreducible(c.polynomial, limit):
            p, times = divided(p, part)
            if times:
                found.append((c.kind, c.name, part, times))
    if not p.is_ground:
        found += [("condition", "", part, times) for part, times in _irreducible(p, limit)]
    return found


def divided(p: Any, divisor: Any) -> tuple[Any, int]:
    """(q, n): p = q divisorⁿ with n as large as can be; neither is a number."""
    times = 0
    while (quotient := _quotient(p, divisor)) is not None:
        checkpoint()
        p, times = quotient, times + 1
    return p, times


def _quotient(p: Any, divisor: Any) -> Any:
    """p / divisor where the divisor divides, else None; most that do not are told by one value."""
    at = [random.Random(k).randint(1, 10**9) for k in range(len(p.ring.gens))]
    values = [f.evaluate(list(zip(f.ring.gens, at, strict=True))) for f in (p, divisor)]
    if values[1] and values[0] % values[1]:
        return None
    (quotient,), rest = p.div([divisor])
    return quotient if rest == 0 else None


def _irreducible(p: Any, limit: int) -> Iterator[tuple[Any, int]]:
    """The irreducible factors with their multiplicities."""
    powers = tuple(min(e) for e in zip(*p.monoms(), strict=True))
    for x, n in zip(p.ring.gens, powers, strict=True):
        if n:
            yield x, n
    if any(powers):
        p = p.div([p.ring.from_dict({powers: 1})])[0][0]
    if p.is_ground:
        return
    on_lines: tuple[int, ...] = ()
    for k in range(LINES):
        checkpoint()
        on_lines = _degrees_on_a_line(p, k)
        if len(on_lines) == 1:
            yield p, 1
            return
    if len(p) > limit:
        raise LimitReached(
            f"a factor of {len(p)} terms may be reducible (on a line: degrees {', '.join(map(str, on_lines))})",
            hint=f"search for its factors with --limit {len(p)}, which may take a very long time",
        )
    long = bits(Fraction(int(c.numerator), int(c.denominator)) for c in p.coeffs())
    if long > FACTORED_BITS:
        raise LimitReached(
            f"a factor with numbers of {long:,} bits may be reducible; at most {FACTORED_BITS:,} are searched",
            hint="give coordinates and poses with fewer digits",
        )
    yield from p.factor_list()[1]


def _degrees_on_a_line(p: Any, seed: int) -> tuple[int, ...]:
    """The degrees of the factors on a random line; () where the degree falls there."""
    rng = random.Random(seed)
    start, along = ([rng.randint(-_SPREAD, _SPREAD) for _ in p.ring.gens] for _ in range(2))
    degree = max(map(sum, p.monoms()))
    row = []
    for k in range(degree + 1):
        at = [a + k * v for a, v in zip(start, along, strict=True)]
        row.append(int(p.evaluate(list(zip(p.ring.gens, at, strict=True)))))
    line = _interpolated(row)
    if not line[0]:
        return ()
    if _irreducible_modulo(line):
        return (degree,)
    from sympy import Poly, Symbol
    from sympy.polys.domains import ZZ

    return tuple(f.degree() for f, n in Poly(line, Symbol("s"), domain=ZZ).factor_list()[1] for _ in range(n))


def _interpolated(values: Sequence[int]) -> list[int]:
    """Whole coefficients, highest first, of a multiple of the polynomial with these values at 0, 1, 2 …"""
    differences, row = [], list(values)
    while row:
        checkpoint()
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
    last = len(differences) - 1
    found = [differences[last]]  # Newton's form, from inside: f = Δ_k + (s − k)/(k + 1) f, times (k + 1) … last
    times = 1
    for k in range(last - 1, -1, -1):
        times *= k + 1
        found = [a - k * b for a, b in zip([*found, 0], [0, *found], strict=True)]
        found[-1] += differences[k] * times
    return found


def _irreducible_modulo(line: Sequence[int]) -> bool:
    """Whether degrees of factors modulo some primes prove a polynomial irreducible: no sum of some of them is left
    that is possible modulo each.
    """
    from sympy.polys.domains import ZZ
    from sympy.polys.galoistools import gf_ddf_zassenhaus, gf_from_int_poly, gf_monic, gf_sqf_p

    degree = len(line) - 1
    every = 1 | 1 << degree
    possible = (1 << degree + 1) - 1
    for prime in _PRIMES:
        checkpoint()
        f = gf_from_int_poly([ZZ(c) for c in line], prime)
        if len(f) != len(line) or not gf_sqf_p(f, prime, ZZ):
            continue
        sums = 1
        for g, n in gf_ddf_zassenhaus(gf_monic(f, prime, ZZ)[1], prime, ZZ):
            for _ in range((len(g) - 1) // n):
                sums |= sums << n
        possible &= sums
        if possible == every:
            return True
    return False
