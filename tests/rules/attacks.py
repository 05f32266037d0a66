"""Identities that are false, made by who knows (or guesses) the points and primes of checks."""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence

import pytest

from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expr import Expr, Number, Point, add, mul
from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.scalars import bracket

__all__ = ["ATTACKS", "EACH_ATTACK", "LEGS", "MERSENNE", "guessed"]

LEGS = "ab bc ca de fg hi"
MERSENNE = 2**61 - 1  # a prime that anybody would try


def guessed(names: Sequence[str], seeds: Iterable[object], prime: int = MERSENNE) -> list[dict[str, tuple[int, ...]]]:
    """Points that a generator with a seed known beforehand would draw."""
    found = []
    for seed in seeds:
        rng = random.Random(seed)
        found.append({n: tuple(rng.randrange(prime) for _ in range(4)) for n in names})
    return found


def monomials(structure: Structure, most: int) -> list[Expr]:
    """Products of three brackets with the degrees of the superbracket."""
    letters = sorted(n for leg in structure.legs for n in leg)
    found: dict[Expr, None] = {}
    for order in _shuffles(letters):
        rows = sorted("".join(sorted(order[i : i + 4])) for i in (0, 4, 8))
        if all(len(set(row)) == 4 for row in rows):
            found.setdefault(mul(*(bracket(*map(Point, row)) for row in rows)))
        if len(found) == most:
            break
    return list(found)


def _shuffles(letters: Sequence[str]) -> Iterable[tuple[str, ...]]:
    rng = random.Random(0)
    while True:
        order = list(letters)
        rng.shuffle(order)
        yield tuple(order)


def vanishing(exprs: Sequence[Expr], points: Sequence[Mapping[str, tuple[int, ...]]], prime: int = MERSENNE) -> Expr:
    """A combination of expressions, with whole coefficients, that vanishes at all points modulo the prime."""
    rows = [[int(evaluate(e, p, modulus=prime)) for e in exprs] for p in points]
    pivots: list[int] = []
    for row in range(len(rows)):
        pivot = next(k for k in range(len(exprs)) if rows[row][k] and k not in pivots)
        pivots.append(pivot)
        inverse = pow(rows[row][pivot], -1, prime)
        rows[row] = [x * inverse % prime for x in rows[row]]
        for other in range(len(rows)):
            if other != row:
                c = rows[other][pivot]
                rows[other] = [(x - c * y) % prime for x, y in zip(rows[other], rows[row], strict=True)]
    free = next(k for k in range(len(exprs)) if k not in pivots)
    numbers = {free: 1} | {pivot: -rows[row][free] % prime for row, pivot in enumerate(pivots)}
    return add(*(mul(Number(c), exprs[k]) for k, c in numbers.items() if c))


def _attacks() -> dict[str, Expr]:
    """False conditions: the superbracket of LEGS and what vanishes where the attacker expects to be looked at."""
    s = read_legs(LEGS)
    true, names = s.superbracket, s.names
    some = monomials(s, 12)
    found = {
        "first": _first(some, names),
        "two-points": vanishing(some[:6], guessed(names, (1, 2))),
        "five-points": vanishing(some[:6], guessed(names, (0, 1, 2, 40, 41))),
        "named-seeds": vanishing(some[:6], guessed(names, ("parameters 1", "robot 1", 5, 6, 7))),
        "small-points": vanishing(some[:6], [random_rational_points(names, seed=n) for n in range(1, 6)]),
        "one-multiple": mul(Number(MERSENNE), some[0]),
        "two-multiples": mul(Number(MERSENNE * (2**31 - 1)), some[0]),
        "one-term": some[1],
    }
    return {what: add(true, more) for what, more in found.items()}


def _first(some: Sequence[Expr], names: Sequence[str]) -> Expr:
    """What was once taken for zero: it is so at the three points that were drawn in every run, modulo the prime, and
    exactly at the one with small coordinates.
    """
    points = guessed(names, (0, 1, 2))
    (small,) = (random_rational_points(names, seed=5),)
    one, other = vanishing(some[:4], points), vanishing([*some[:3], some[4]], points)
    return add(mul(Number(int(evaluate(other, small))), one), mul(Number(-int(evaluate(one, small))), other))


ATTACKS = _attacks()
EACH_ATTACK = pytest.mark.parametrize("false", ATTACKS.values(), ids=ATTACKS)
