r"""All brackets that divide a bracket polynomial, each with its proof.

If [ab…] divides P, then P vanishes where any two of its points coincide. So the brackets that may divide are the
cliques of a graph on the points, which one random position for each pair decides: a value that is not 0 excludes the
pair for certain. So does a value where one point of a bracket is a sum of the others. Division is exact: written with
the points of the bracket first, the bracket is the smallest row of all, hence it stands in every term of the normal
form of [ab…] · Q, and what is left is the normal form of Q. So the bracket divides if and only if it stands in every
term.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, islice

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms, primitive
from gcrules.algebra.factoring.modular import MODULUS, Ints
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached

__all__ = ["bracket_factors", "divided", "solution", "standard_tableaux", "vanishing_pairs"]

_MOST_UNKNOWNS = 600
_AT_ONCE = 500  # positions


def bracket_factors(poly: BracketPolynomial, *, limit: int) -> tuple[tuple[Row, ...], BracketPolynomial]:
    """The brackets that divide a polynomial in normal form, as often as they do, and the quotient in normal form.

    Rows hold places in `poly.points`. With ideal points a polynomial may be a product of brackets in several ways, of
    which the first is taken. Raises LimitReached where a normal form is too large.
    """
    found: list[Row] = []
    for row in _candidates(poly):
        while len(poly):
            checkpoint()
            quotient = divided(poly, row, limit=limit)
            if quotient is None:
                break
            found.append(row)
            poly = quotient
    return tuple(found), poly


def divided(poly: BracketPolynomial, row: Row, *, limit: int) -> BracketPolynomial | None:
    """The quotient of a polynomial by a bracket, in normal form; None if the bracket does not divide it."""
    ideal = set(range(poly.ideal))
    if not ideal <= set(row) and ideal:
        return _solved(poly, row, limit)
    names = [poly.points[i] for i in (*row, *(i for i in range(len(poly.points)) if i not in row))]
    moved = straighten(poly.over(tuple(names), poly.ideal), limit=limit)
    assert isinstance(moved, BracketPolynomial)
    smallest = tuple(range(poly.rank))
    if any(not m or m[0] != smallest for m in moved.terms):
        return None
    quotient = moved.with_terms({m[1:]: c for m, c in moved.terms.items()})
    normal = straighten(quotient.over(poly.points, poly.ideal), limit=limit)
    assert isinstance(normal, BracketPolynomial)
    return normal


def vanishing_pairs(poly: BracketPolynomial) -> frozenset[Row]:
    """The pairs of points that occur whose coincidence makes the polynomial vanish; others are excluded for certain."""
    used = sorted({i for m in poly.terms for row in m for i in row})
    pairs = list(combinations(used, 2))
    if not pairs:
        return frozenset()
    at = random_positions(len(pairs), len(poly.points), poly.rank, MODULUS, ideal=poly.ideal)
    for n, (a, b) in enumerate(pairs):
        at[n, b] = at[n, a]
    found = values(primitive(poly)[1], at, MODULUS).tolist()
    return frozenset(p for p, v in zip(pairs, found, strict=True) if not v)


def _candidates(poly: BracketPolynomial) -> Iterator[Row]:
    """The brackets whose points may not coincide in pairs, nor depend on each other, without making the polynomial
    vanish.
    """
    pairs = vanishing_pairs(poly)

    def cliques(row: Row, rest: Sequence[int]) -> Iterator[Row]:
        if len(row) == poly.rank:
            yield row
        for n, i in enumerate(rest):
            if len(row) < poly.rank:
                yield from cliques((*row, i), [j for j in rest[n + 1 :] if (i, j) in pairs])

    rows = (row for row in cliques((), sorted({i for p in pairs for i in p})) if row[-1] >= poly.ideal)
    while some := tuple(islice(rows, _AT_ONCE)):
        yield from _vanishing_rows(poly, some)


def _vanishing_rows(poly: BracketPolynomial, rows: Sequence[Row]) -> list[Row]:
    """Those that the polynomial vanishes with at a random position where the last point is a sum of the others."""
    checkpoint()
    at = random_positions(len(rows), len(poly.points), poly.rank, MODULUS, ideal=poly.ideal, seed=2)
    for n, row in enumerate(rows):
        at[n, row[-1]] = at[n, row[:-1]].sum(axis=0) % MODULUS
    found = values(primitive(poly)[1], at, MODULUS).tolist()
    return [row for row, v in zip(rows, found, strict=True) if not v]


def _solved(poly: BracketPolynomial, row: Row, limit: int) -> BracketPolynomial | None:
    """The quotient among ideal points, where a bracket may not be the smallest row: its coefficients are solved for."""
    degrees = [0] * len(poly.points)
    for r in next(iter(poly.terms), ()):
        for i in r:
            degrees[i] += 1
    for i in row:
        degrees[i] -= 1
    if min(degrees) < 0:
        return None
    unknowns = list(standard_tableaux(degrees, poly.rank, poly.ideal))
    if not unknowns:
        return None
    at = random_positions(len(unknowns) + 8, len(poly.points), poly.rank, MODULUS, ideal=poly.ideal, seed=1)
    columns = [values(poly.with_terms({m: 1}), at, MODULUS) for m in unknowns]
    bracket = values(poly.with_terms({(row,): 1}), at, MODULUS)
    system = np.stack([*(c * bracket % MODULUS for c in columns), values(poly, at, MODULUS)], axis=1)
    found = solution(system)
    if found is None:
        return None
    terms: Terms = {m: c - MODULUS if c > MODULUS // 2 else c for m, c in zip(unknowns, found, strict=True)}
    quotient = poly.with_terms(terms)
    product = straighten(poly.with_terms({(row,): 1}) * quotient, limit=limit)
    if product != straighten(poly, limit=limit):
        raise LimitReached("a bracket of points at infinity may divide, but the quotient's coefficients are too large")
    return quotient


def standard_tableaux(degrees: list[int], rank: int, ideal: int) -> Iterator[Monomial]:
    """All standard tableaux of this multidegree without a row of ideal points."""
    budget = _MOST_UNKNOWNS

    def rows(above: Row, rest: tuple[int, ...]) -> Iterator[Monomial]:
        checkpoint()
        if not any(rest):
            yield ()
            return
        first = next(i for i, d in enumerate(rest) if d)
        present = [i for i, d in enumerate(rest) if d]
        for row in combinations(present, rank):
            if row[0] != first or row[-1] < ideal or any(a > b for a, b in zip(above, row, strict=False)):
                continue
            left = tuple(d - (i in row) for i, d in enumerate(rest))
            for below in rows(row, left):
                yield (row, *below)

    for number, tableau in enumerate(rows((), tuple(degrees))):
        if number == budget:
            raise LimitReached(f"division by a bracket of points at infinity needs more than {budget} unknowns")
        yield tableau


def solution(system: Ints) -> list[int] | None:
    """The solution of an overdetermined system of linear equations modulo the prime; None if there is none."""
    n = system.shape[1] - 1
    for column in range(n):
        pivots = np.flatnonzero(system[column:, column]) + column
        if not len(pivots):
            return None
        pivot = int(pivots[0])
        system[[column, pivot]] = system[[pivot, column]]
        system[column] = system[column] * pow(int(system[column, column]), -1, MODULUS) % MODULUS
        factor = system[:, column].copy()
        factor[column] = 0
        system = (system - factor[:, None] * system[column][None, :]) % MODULUS
    return None if system[n:, n].any() else [int(v) for v in system[:n, n]]
