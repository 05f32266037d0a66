r"""Every scalar expression of joins and meets with one multidegree, met in the middle.

A tree with n leaves has either an edge with n/2 leaves on both sides, or a node all of whose branches have fewer than
n/2 (its centroid). So every expression is a pair of extensors of n/2 letters each, or a triple A, B, C of extensors of
fewer than n/2 letters each; no extensor of more than n/2 letters has to be built but the joins and meets of B and C.

If E = c · P for a constant c, then E(x) P(y) = E(y) P(x) at any two positions, also modulo a prime; expressions that
fail this are no multiples of P. This holds without any probability. Those that pass are candidates.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.algebra.factoring.extensors import CHUNK, Extensors, Level, scalar, spread, wedge
from gcrules.algebra.factoring.modular import Ints
from gcrules.algebra.factoring.residues import Floats
from gcrules.algebra.factoring.tree_letters import Tree
from gcrules.core.dataclass import dataclass

__all__ = ["Candidate", "candidates", "middles"]

Middle = tuple[int, int] | tuple[int, int, int]


@dataclass(frozen=True)
class Candidate:
    """An expression that passes the test: extensors (letters, place); the last two of three are joined or met."""

    parts: tuple[tuple[int, int], ...]

    def trees(self, extensors: Extensors) -> Iterator[tuple[Tree, Tree]]:
        """All pairs of complementary extensors that agree with this one at the positions, the simplest first."""
        (n, i), *rest = self.parts
        for a in extensors.forms(n, i):
            if len(rest) == 1:
                for b in extensors.forms(*rest[0]):
                    yield a, b
                continue
            (m, j), (l, k) = rest
            steps = m % extensors.rank + l % extensors.rank
            for b in extensors.forms(m, j):
                for c in extensors.forms(l, k):
                    yield a, ("join" if steps < extensors.rank else "meet", b, c)


def middles(letters: int, rank: int, *, points: bool = True) -> tuple[Middle, ...]:
    """The numbers of letters of the pairs and triples that meet every tree with so many letters.

    No extensor has a multiple of d letters. In a triple the steps add up to d or 2d. A triple that contains joined
    points only as its last part is left out where moving some of these points makes two halves, if all letters are
    `points` (a given extensor cannot be moved in part).

    >>> middles(12, 4), middles(8, 4), middles(16, 4), middles(9, 3)
    (((6, 6),), ((3, 3, 2),), ((7, 7, 2), (7, 6, 3), (6, 5, 5)), ((4, 4, 1),))
    """
    half = letters // 2
    found: list[Middle] = []
    halves = letters % 2 == 0 and half % rank != 0
    if halves:
        found.append((half, half))
    for a in range((letters - 1) // 2, 0, -1):
        for b in range(min(a, letters - a - 1), 0, -1):
            c = letters - a - b
            if c > b or 0 in (a % rank, b % rank, c % rank):
                continue
            movable = points and a % rank + b % rank + c % rank == rank and c < rank and a + c >= half
            if not (halves and movable):
                found.append((a, b, c))
    return tuple(found)


def candidates(extensors: Extensors, value: Sequence[int]) -> Iterator[Candidate]:
    """All expressions of the whole multidegree that may be multiples of a polynomial with these values.

    The values are those at `extensors.positions`, not 0 modulo the prime. Expressions that agree with another one by
    the rules of the levels are left out. Raises LimitReached.
    """
    letters = extensors.letters
    for middle in middles(letters.number, extensors.rank, points=not letters.given):
        test = _Test(extensors, extensors.level(middle[0]), value)
        if len(middle) == 2:
            yield from _halves(extensors, test, middle[0])
        else:
            yield from _thirds(extensors, test, middle)


class _Test:
    """Whether E(x) P(y) = E(y) P(x) for E = A · B. The first two positions are tested by one product of matrices for
    all A and B of two groups, the third on what passes.
    """

    def __init__(self, extensors: Extensors, level: Level, value: Sequence[int]) -> None:
        self.field = extensors.field
        self.effort = extensors.effort
        self.level = level
        self.table = scalar(extensors.rank, level.step)
        self.value = self.field.reduced(np.array(value, dtype=np.float64))

    def dual(self, vectors: Floats) -> Floats:
        """Vectors B of the complementary step so arranged that A · B is a sum of products of like coordinates."""
        out = np.empty_like(vectors)
        for i, j, sign in self.table:
            np.multiply(vectors[j], sign, out=out[i])
        return out

    def weighted(self, dual: Floats) -> Floats:
        """B at the first position times P at the second and minus the reverse: A · B is then the difference to test."""
        weights = np.array([self.value[1], -self.value[0]])
        return self.field.reduced(dual[:, :2] * weights[:, None])

    def passed(self, low: int, high: int, weighted: Floats, dual: Floats) -> tuple[Ints, Ints]:
        """Places in low … high and in the second factor where the test holds and E is not 0."""
        a = self.level.at(slice(low, high))
        self.effort.multiply((high - low) * dual.shape[2])
        product = a[:, :2].reshape(-1, high - low).T @ weighted.reshape(-1, dual.shape[2])
        i, j = self.field.multiples(product)
        if len(i):
            e = self.field.reduced((a[:, :, i] * dual[:, :, j]).sum(axis=0))
            same = self.field.reduced(e[0] * self.value[2]) == self.field.reduced(e[2] * self.value[0])
            i, j = i[same & (e[0] != 0)], j[same & (e[0] != 0)]
        return i + low, j


def _halves(extensors: Extensors, test: _Test, letters: int) -> Iterator[Candidate]:
    level, whole = test.level, extensors.letters.all
    codes, start, count = level.groups
    other = np.searchsorted(codes, whole - codes)
    for g, h in enumerate(other.tolist()):
        if h < g or h >= len(codes) or codes[g] + codes[h] != whole:
            continue
        low, high = int(start[g]), int(start[g] + count[g])
        begin, end = int(start[h]), int(start[h] + count[h])
        for part in range(begin, end, CHUNK):
            stop = min(end, part + CHUNK)
            dual = test.dual(level.at(slice(part, stop)))
            weighted = test.weighted(dual)
            wide = max(1, CHUNK // (stop - part))
            for row in range(low, high, wide):
                i, j = test.passed(row, min(high, row + wide), weighted, dual)
                yield from (
                    Candidate(((letters, p), (letters, q + part))) for p, q in zip(i.tolist(), j.tolist(), strict=True)
                )


def _thirds(extensors: Extensors, test: _Test, sizes: tuple[int, int, int]) -> Iterator[Candidate]:
    n, m, l = sizes
    whole = extensors.letters.all
    level, b, c = test.level, extensors.level(m), extensors.level(l)
    table = wedge(extensors.rank, b.step, c.step)
    codes, start, count = level.groups
    codes_b, start_b, count_b = b.groups
    codes_c, start_c, count_c = c.groups
    if not len(codes_c):
        return
    for code, low, number in zip(codes.tolist(), start.tolist(), count.tolist(), strict=True):
        rest = whole - code - codes_b
        h = np.minimum(np.searchsorted(codes_c, rest), len(codes_c) - 1)
        fits = codes_c[h] == rest
        if n == m:
            fits &= codes_b <= code
        if m == l:
            fits &= codes_c[h] <= codes_b
        g, h = np.flatnonzero(fits), h[fits]
        for i, j in spread(start_b[g], count_b[g], start_c[h], count_c[h]):
            vectors = extensors.product(table, b.at(i), c.at(j))
            dual = test.dual(vectors)
            weighted = test.weighted(dual)
            wide = max(1, CHUNK // len(i))
            for row in range(low, low + number, wide):
                p, q = test.passed(row, min(low + number, row + wide), weighted, dual)
                yield from (
                    Candidate(((n, x), (m, int(i[y])), (l, int(j[y]))))
                    for x, y in zip(p.tolist(), q.tolist(), strict=True)
                )
