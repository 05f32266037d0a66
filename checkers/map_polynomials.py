"""The determinant of six legs as a polynomial in whole numbers, for `check_map.py`, which explains it.

Polynomials are dictionaries from exponents, one for each axis of the map, to coefficients other than 0.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import product

from certificate_bounds import Refused
from map_slice import TRANSLATION, exact, expect, whole


def plus(p, q, by=1):
    found = dict(p)
    for e, c in q.items():
        found[e] = found.get(e, 0) + by * c
    return {e: c for e, c in found.items() if c}


def times(p, q):
    found = {}
    for e, c in p.items():
        for d, b in q.items():
            key = tuple(map(sum, zip(e, d)))
            found[key] = found.get(key, 0) + c * b
    return {e: c for e, c in found.items() if c}


def in_whole_numbers(p):
    """It times a positive number."""
    by = math.lcm(*(Fraction(c).denominator for c in p.values())) if p else 1
    return {e: int(c * by) for e, c in p.items()}


def determinant(rows, one):
    """By minors of the first rows, for each choice of columns."""
    minors = {0: one}
    for row in rows:
        found = {}
        for mask, p in minors.items():
            for c in range(len(rows)):
                if not mask >> c & 1 and row[c]:
                    sign = -1 if (mask >> c).bit_count() % 2 else 1
                    found[mask | 1 << c] = plus(found.get(mask | 1 << c, {}), times(p, row[c]), sign)
        minors = found
    return minors.get((1 << len(rows)) - 1, {})


def coordinates(s):
    """The coordinates of the axes as polynomials in places counted in nodes."""
    zero = (0,) * len(s.axes)
    return [
        {e: c for e, c in ((zero, a.start), ((*zero[:k], 1, *zero[k + 1 :]), a.step)) if c}
        for k, a in enumerate(s.axes)
    ]


def superbracket(s):
    """The determinant on a slice without turns, up to a positive number, in places counted in nodes."""
    zero, names = (0,) * len(s.axes), [a.name for a in s.axes]
    moved = [{zero: c} if c else {} for c in s.shift]
    for name, p in zip(names, coordinates(s)):
        moved[TRANSLATION.index(name)] = p
    rows = []
    for base, arm in zip(s.bases, s.arms):
        far = [sum(r * c for r, c in zip(row, arm)) for row in s.turn]
        f = [plus(moved[j], {zero: far[j] - base[j]}) for j in range(3)]
        m = [plus(times({zero: base[i]}, f[j]), times({zero: base[j]}, f[i]), -1) for i, j in ((1, 2), (2, 0), (0, 1))]
        by = math.lcm(*(Fraction(c).denominator for p in f + m for c in p.values()))
        rows.append([{e: int(c * by) for e, c in p.items()} for p in f + m])
    return determinant(rows, {zero: 1})


def parts_of(s, listed, p):
    """The factors of p that a file lists, in places counted in nodes. Raises Refused where their product is not p, up
    to a number.
    """
    expect(isinstance(listed, list) and len(listed) <= 3, "at most three factors are expected")
    zero, found = (0,) * len(s.axes), []
    whole_product = {zero: 1}
    for one in listed:
        expect(isinstance(one, dict) and set(one) == {"multiplicity", "terms"}, "not a factor")
        expect(isinstance(one["terms"], list) and 0 < len(one["terms"]) <= 20, "not a factor")
        f = {}
        for term in one["terms"]:
            expect(isinstance(term, list) and len(term) == 2 and isinstance(term[0], list), "not a term")
            expect(len(term[0]) == len(zero) and sum(whole(e, 0, 3) for e in term[0]) <= 3, "not a term of degree 3")
            part = {zero: exact(term[1])}
            for e, c in zip(term[0], coordinates(s)):
                for _ in range(e):
                    part = times(part, c)
            f = plus(f, part)
        expect(set(f) - {zero}, "a factor that is a constant")
        found.append(in_whole_numbers(f))
        for _ in range(whole(one["multiplicity"], 1, 3)):
            whole_product = times(whole_product, f)
    some = next(iter(p))
    if set(p) != set(whole_product) or any(c * whole_product[some] != p[some] * whole_product[e] for e, c in p.items()):
        raise Refused("the factors' product is not the superbracket")
    return found


class Polynomial:
    """A polynomial in whole numbers; boxes and places are counted in 2^-depth cells."""

    def __init__(self, p):
        self.degrees = [max(e[k] for e in p) for k in range(len(next(iter(p))))]
        self.p, self.at_depth = p, {}
        self.dense = list(product(*(range(n + 1) for n in self.degrees)))

    def coefficients(self, depth):
        if depth not in self.at_depth:
            self.at_depth[depth] = [self.p.get(e, 0) << depth * (sum(self.degrees) - sum(e)) for e in self.dense]
        return self.at_depth[depth]

    def bernstein(self, depth, low, width):
        """The coefficients in a box, times a positive number."""
        values = self.coefficients(depth)
        for n, a, w in zip(self.degrees, low, width):  # the first exponent becomes the last one, each time
            inner = len(values) // (n + 1)
            columns = [values[i * inner : (i + 1) * inner] for i in range(n + 1)]
            by = math.lcm(*(math.comb(n, j) for j in range(n + 1)))
            shifted = [
                [
                    sum(math.comb(i, j) * a ** (i - j) * w**j * columns[i][r] for i in range(j, n + 1))
                    for j in range(n + 1)
                ]
                for r in range(inner)
            ]
            values = [
                sum(math.comb(k, j) * by // math.comb(n, j) * row[j] for j in range(k + 1))
                for row in shifted
                for k in range(n + 1)
            ]
        return values

    def sign(self, depth, low, width):
        """That of all values in a box; 0 where it is not known."""
        values = self.bernstein(depth, low, width)
        return 1 if min(values) > 0 else -1 if max(values) < 0 else 0

    def corner(self, depth, place):
        """The sign at a place."""
        value = sum(
            c * math.prod(u**n for u, n in zip(place, e)) for c, e in zip(self.coefficients(depth), self.dense) if c
        )
        return (value > 0) - (value < 0)
