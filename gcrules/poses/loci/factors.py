r"""Factors of the polynomial over the rationals, each proved irreducible.

A polynomial is irreducible if it is so on one rational line on which its degree does not fall; by Hilbert's theorem
almost every line tells. So large polynomials need no search, and sympy's is left for small ones.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached
from gcrules.poses.numbers.cubic import FACTORED_BITS, bits

__all__ = ["MAX_TERMS", "PossibleFactor", "divided", "factored", "primitive"]

MAX_TERMS = 300
"""Polynomials of more terms that are reducible on lines are not factored by search."""

LINES = 4
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
            hint=f"search for its factors with --limit {len(p)}, which may take very long",
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
    from sympy import Poly, Symbol
    from sympy.polys.domains import QQ
    from sympy.polys.polyfuncs import interpolate

    rng = random.Random(seed)
    start, along = ([rng.randint(-_SPREAD, _SPREAD) for _ in p.ring.gens] for _ in range(2))
    degree = max(map(sum, p.monoms()))
    s = Symbol("s")
    values = []
    for k in range(degree + 1):
        at = [a + k * v for a, v in zip(start, along, strict=True)]
        values.append((k, int(p.evaluate(list(zip(p.ring.gens, at, strict=True))))))
    line = Poly(interpolate(values, s), s, domain=QQ)
    if line.degree() < degree:
        return ()
    return tuple(f.degree() for f, n in line.factor_list()[1] for _ in range(n))
