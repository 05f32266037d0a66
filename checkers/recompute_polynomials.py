"""Polynomials in brackets by their values modulo a prime, for checkers/recompute.py, whose head says what it needs."""

import random
from collections import Counter
from fractions import Fraction
from itertools import combinations
from math import ceil, gcd, lcm, log10

PRIMES = [2**n - 1 for n in (61, 127, 521, 607, 1279, 2203, 4423)]
SURE = 3  # positions at which what seems to vanish is looked at


class NotSo(Exception):
    """Something is not as the file says."""


class TooLarge(Exception):
    """An enumeration takes more steps than were allowed."""


def expect(condition, what, fault=ValueError):
    if not condition:
        raise fault(what)


class Steps:
    """Steps that are left."""

    def __init__(self, most):
        self.most, self.done = most, 0

    def take(self, number=1):
        self.expect(number)
        self.done += number

    def expect(self, number):
        enough = self.done + number <= self.most
        expect(enough, f"it takes more than {self.most:,} steps (--most allows more)", TooLarge)


def prime_above(bound):
    expect(bound < PRIMES[-1], "the numbers are too large for this program", TooLarge)
    return next(p for p in PRIMES if p > bound)


def sign_of(sequence):
    """The sign of a rearrangement into increasing order, 0 where something stands twice."""
    pairs = list(combinations(sequence, 2))
    return 0 if any(a == b for a, b in pairs) else (-1) ** sum(a > b for a, b in pairs)


# --- polynomials in brackets: {sorted tuple of sorted rows of points: coefficient} ------------------------------------


def read(e, points, definitions, rank, steps):
    """The polynomial that a side of a theorem is."""
    if isinstance(e, str):
        return read(definitions[e], points, definitions, rank, steps)
    if e[0] == "number":
        return {(): Fraction(e[1])} if Fraction(e[1]) else {}
    if e[0] == "bracket":
        expect(len(e) == rank + 1 and all(x in points and x not in definitions for x in e[1:]), "no bracket of points")
        sign = sign_of(e[1:])
        return {(tuple(sorted(e[1:])),): Fraction(sign)} if sign else {}
    expect(e[0] in ("sum", "product", "power"), f"{e[0]} in what should be a polynomial in brackets")
    parts = (
        [read(e[1], points, definitions, rank, steps)] * e[2]
        if e[0] == "power"
        else [read(part, points, definitions, rank, steps) for part in e[1:]]
    )
    total = parts[0]
    for part in parts[1:]:
        if e[0] == "sum":
            terms = [*total.items(), *part.items()]
        else:
            steps.take(len(total) * len(part))
            terms = [(tuple(sorted(m + n)), c * k) for m, c in total.items() for n, k in part.items()]
        total = {}
        for m, c in terms:
            total[m] = total.get(m, 0) + c
    return {m: c for m, c in total.items() if c}


def degrees_of(monomial):
    return Counter(x for row in monomial for x in row)


def determinant(rows, p):
    rows, value = [list(row) for row in rows], 1
    for i in range(len(rows)):
        pivot = next((k for k in range(i, len(rows)) if rows[k][i]), None)
        if pivot is None:
            return 0
        if pivot != i:
            rows[i], rows[pivot], value = rows[pivot], rows[i], -value
        value = value * rows[i][i] % p
        inverse = pow(rows[i][i], -1, p)
        for k in range(i + 1, len(rows)):
            factor = rows[k][i] * inverse % p
            rows[k] = [(a - factor * b) % p for a, b in zip(rows[k], rows[i])]
    return value % p


class Brackets(dict[tuple[str, ...], int]):
    """The values of brackets at one position, each computed once."""

    def __init__(self, at, p):
        self.at, self.p = at, p

    def __missing__(self, row):
        self[row] = determinant([self.at[x] for x in row], self.p)
        return self[row]

    def monomial(self, m):
        value = 1
        for row in m:
            value = value * self[row] % self.p
        return value

    def polynomial(self, poly):
        return sum(c * self.monomial(m) for m, c in poly.items()) % self.p


class Polynomial:
    """A polynomial, not zero modulo p, whose terms all use each point equally often, with whole coprime coefficients;
    and random positions.
    """

    def __init__(self, terms, rank, p, seed):
        expect(terms, "the polynomial is zero", NotSo)
        common = lcm(*(c.denominator for c in terms.values()))
        factor = gcd(*(int(c * common) for c in terms.values()))
        self.terms, self.rank = {m: int(c * common) // factor for m, c in terms.items()}, rank
        self.degrees = degrees_of(next(iter(terms)))
        expect(all(degrees_of(m) == self.degrees for m in terms), "terms that use the points differently")
        self.points, self.random = sorted(self.degrees), random.Random(seed)
        self.modulo(p)

    def modulo(self, p):
        """Values modulo another prime."""
        self.p = p
        expect(self.value(self.position()), "the polynomial vanishes at a random position", NotSo)

    def position(self):
        return {x: [self.random.randrange(self.p) for _ in range(self.rank)] for x in self.points}

    def merged(self, blocks):
        """A position at which the points of each block are one."""
        at = self.position()
        return {**at, **{x: at[block[0]] for block in blocks for x in block}}

    def value(self, at):
        return Brackets(at, self.p).polynomial(self.terms)

    def error(self, seen, tests):
        """How likely it is that one of so many tests saw something vanish that does not; `seen` did vanish."""
        bound = log10(4 * (self.rank + 1) * sum(self.degrees.values())) - log10(self.p)
        return f"error below 1e{ceil(SURE * bound + log10(tests))}" if seen else "certain"

    def dividing(self, steps):
        """All brackets but those that certainly do not divide: there is a position where the bracket alone is 0."""

        def on_plane(row):
            steps.take(len(self.terms))
            at = self.position()
            some = [self.random.randrange(self.p) for _ in row[1:]]
            at[row[0]] = [sum(s * at[x][i] for s, x in zip(some, row[1:])) % self.p for i in range(self.rank)]
            return at

        return [row for row in combinations(self.points, self.rank) if not self.value(on_plane(row))]

    def without_common(self):
        """Brackets that are in all terms, and the rest."""
        common = Counter(min(self.terms, key=len))
        for m in self.terms:
            common &= Counter(m)
        rest = {tuple(sorted((Counter(m) - common).elements())): c for m, c in self.terms.items()}
        return common, rest
