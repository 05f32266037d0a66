r"""Irreducible factors of polynomials in which every point occurs once: which points belong together, at any length.

Two points i and j are in different factors exactly where P(i, j) P(i', j') = P(i, j') P(i', j), all others held: P is
then a function of i times one of j, and by Gauss's lemma a product of polynomials of which only one holds i, only one
j. A position at which this fails proves that the two are in one factor. Written with the points of a factor A first,
the normal form of A · B is that of A, each tableau with each one of B below it: so A and B are read off it, which
proves both.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Monomial, primitive
from gcrules.algebra.factoring.modular import MODULUS
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint

__all__ = ["blocks_apart", "each_point_once"]


def each_point_once(poly: BracketPolynomial) -> bool:
    """Whether every point that occurs does so once in each term."""
    degrees = poly.degrees()
    return bool(degrees) and set((degrees or {}).values()) == {1}


def blocks_apart(poly: BracketPolynomial, *, limit: int) -> list[BracketPolynomial] | None:
    """The irreducible factors, in normal form, of a polynomial in which every point occurs once (without ideal points);
    their product is a multiple of it. None where what seems to be apart is not. Raises LimitReached.
    """
    blocks, found = _blocks(poly), []
    rest = poly
    for block in blocks[:-1]:
        checkpoint()
        both = _divided(rest, block, limit)
        if both is None:
            return None
        found.append(both[0])
        rest = both[1]
    return [primitive(p)[1] for p in (*found, rest)]


def _blocks(poly: BracketPolynomial) -> list[tuple[int, ...]]:
    """Points, by their places, that are in one factor for certain; which are apart holds at random positions."""
    used = sorted({i for m in poly.terms for row in m for i in row})
    pairs = list(combinations(used, 2))
    at = random_positions(len(pairs), len(poly.points), poly.rank, MODULUS)
    other = random_positions(len(pairs), len(poly.points), poly.rank, MODULUS, seed=1)
    first, second = np.array(pairs).T
    rows = np.arange(len(pairs))
    one, two, both = at.copy(), at.copy(), at.copy()
    one[rows, first] = both[rows, first] = other[rows, first]
    two[rows, second] = both[rows, second] = other[rows, second]
    v, v_one, v_two, v_both = (values(primitive(poly)[1], x, MODULUS) for x in (at, one, two, both))
    together = (v * v_both - v_one * v_two) % MODULUS != 0
    home = {i: i for i in used}
    for i, j in (pair for pair, t in zip(pairs, together.tolist(), strict=True) if t):
        one_home, other_home = home[i], home[j]
        home = {k: one_home if h == other_home else h for k, h in home.items()}
    return [tuple(i for i in used if home[i] == h) for h in dict.fromkeys(home.values())]


def _divided(
    poly: BracketPolynomial, block: tuple[int, ...], limit: int
) -> tuple[BracketPolynomial, BracketPolynomial] | None:
    """The factor in the points of the block, and what is left; None if that is no product."""
    order = (*block, *(i for i in range(len(poly.points)) if i not in block))
    moved = straighten(poly.over(tuple(poly.points[i] for i in order)), limit=limit)
    assert isinstance(moved, BracketPolynomial)
    rows, left = divmod(len(block), poly.rank)
    if left or any(m[rows - 1][-1] >= len(block) for m in moved.terms):
        return None
    leading, c = next(iter(moved.terms.items()))
    upper = {m[:rows]: k for m, k in moved.terms.items() if m[rows:] == leading[rows:]}
    lower = {m[rows:]: Fraction(k) / c for m, k in moved.terms.items() if m[:rows] == leading[:rows]}
    if len(upper) * len(lower) != len(moved) or any(moved.terms.get(m) != k for m, k in _product(upper, lower)):
        return None
    one, other = (straighten(moved.with_terms(t).over(poly.points), limit=limit) for t in (upper, lower))
    assert isinstance(one, BracketPolynomial)
    assert isinstance(other, BracketPolynomial)
    return one, other


def _product(
    upper: dict[Monomial, int | Fraction], lower: dict[Monomial, Fraction]
) -> Iterator[tuple[Monomial, int | Fraction]]:
    for a, k in upper.items():
        for b, c in lower.items():
            yield (*a, *b), k * c
