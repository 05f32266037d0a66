r"""Straightening without syzygies: the normal form from the coefficients at diagonal monomials.

Written out in coordinates x[p, c] (point p, row c of its column), a bracket with points p1 < p2 < … has the leading
monomial x[p1, 1] x[p2, 2] … in the lexicographic order x[1, 1] > x[1, 2] > … > x[2, 1] > …, so a standard tableau has
the product of x[T[r][c], c] over all its places, and different standard tableaux have different leading monomials.
The coefficients of a bracket polynomial at these *diagonal* monomials therefore determine its normal form through a
unitriangular system of integers. It is exact, needs no prime, and shares no code with the rewriting in `straighten`.
Derived here; the idea is that of straightening by Capelli operators.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import lru_cache
from itertools import permutations
from typing import TYPE_CHECKING, Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms
from gcrules.algebra.expr import permutation_sign
from gcrules.errors import LimitReached

if TYPE_CHECKING:
    import numpy as np

__all__ = ["normal_form", "standard_tableaux"]

MAX_ARRANGEMENTS = 10_000_000
MAX_TABLEAUX = 5_000

_Content = tuple[int, ...]  # the points of a monomial with their multiplicities, increasing


def standard_tableaux(content: tuple[int, ...], rank: int) -> Iterator[Monomial]:
    """All standard tableaux with rows of length `rank` in which each point occurs as often as in `content`.

    >>> sum(1 for _ in standard_tableaux(tuple(range(12)), 4))
    462
    """
    rows = len(content) // rank
    letters = sorted(Counter(content).items())

    def fill(heights: tuple[int, ...], at: int, columns: tuple[Row, ...]) -> Iterator[Monomial]:
        if at == len(letters):
            yield tuple(zip(*columns, strict=True))
            return
        letter, count = letters[at]
        for places in _strips(heights, count, rows):
            grown = tuple(h + n for h, n in zip(heights, places, strict=True))
            longer = tuple((*c, *(letter,) * n) for c, n in zip(columns, places, strict=True))
            yield from fill(grown, at + 1, longer)

    if len(content) == rows * rank:
        yield from fill((0,) * rank, 0, ((),) * rank)


def _strips(heights: tuple[int, ...], count: int, rows: int) -> Iterator[tuple[int, ...]]:
    """Ways to put `count` equal points on top of columns of these heights: no two of them come into one row."""

    def place(column: int, left: int) -> Iterator[tuple[int, ...]]:
        if column == len(heights):
            if left == 0:
                yield ()
            return
        roof = rows if column == 0 else heights[column - 1]
        for n in range(min(left, roof - heights[column]), -1, -1):
            for rest in place(column + 1, left - n):
                yield (n, *rest)

    return place(0, count)


def normal_form(poly: BracketPolynomial) -> BracketPolynomial:
    """The normal form of a bracket polynomial; agrees with `straighten`.

    Monomials of unlike content are treated separately. Raises LimitReached where a monomial has more than 10⁷
    arrangements or a content more than 5,000 standard tableaux.
    """
    groups: dict[_Content, Terms] = {}
    for m, c in poly.terms.items():
        if not any(row[-1] < poly.ideal for row in m):
            groups.setdefault(tuple(sorted(i for row in m for i in row)), {})[m] = c
    normal: Terms = {}
    for content, terms in groups.items():
        normal |= _solve(content, poly.rank, terms)
    # With the points at infinity first in the order, a standard tableau that holds `rank` of them in one row is zero.
    return poly.with_terms({m: c for m, c in normal.items() if not any(row[-1] < poly.ideal for row in m)})


def _solve(content: _Content, rank: int, terms: Terms) -> Terms:
    if not content:
        return dict(terms)
    keys, tableaux = _basis(content, rank)
    value: Any = sum(_coefficients(m, content, rank).astype(object) * c for m, c in terms.items())
    found: Terms = {}
    for i in range(len(keys)):
        if value[i]:
            found[tableaux[i]] = value[i]
            value = value - _coefficients(tableaux[i], content, rank).astype(object) * value[i]
    return found


@lru_cache(maxsize=8)  # at most 3 MB each
def _basis(content: _Content, rank: int) -> tuple[np.ndarray[Any, Any], tuple[Monomial, ...]]:
    """The standard tableaux of a content with the codes of their diagonal monomials, largest first."""
    import numpy as np

    weights = _weights(content, rank)
    pairs = []
    for tableau in standard_tableaux(content, rank):
        pairs.append((sum(weights[p][c] for row in tableau for c, p in enumerate(row)), tableau))
        if len(pairs) > MAX_TABLEAUX:
            raise LimitReached(f"more than {MAX_TABLEAUX:,} standard tableaux")
    pairs.sort(reverse=True)
    return np.array([k for k, _ in pairs], dtype=np.int64), tuple(t for _, t in pairs)


@lru_cache(maxsize=64)
def _weights(content: _Content, rank: int) -> dict[int, tuple[int, ...]]:
    """Weights that turn a monomial in x[p, c] into a code; codes compare as monomials do in the lexicographic order.

    The power at the last column follows from the others, since each point's total degree is known.
    """
    weights: dict[int, tuple[int, ...]] = {}
    unit = 1
    for p, count in sorted(Counter(content).items(), reverse=True):
        powers = [0]
        for _ in range(rank - 1):
            powers.append(unit)
            unit *= count + 1
        weights[p] = tuple(reversed(powers))
    if unit.bit_length() > 62:
        raise LimitReached("a monomial of more than about 20 points")
    return weights


@lru_cache(maxsize=1024)  # at most 20 kB each
def _coefficients(monomial: Monomial, content: _Content, rank: int) -> np.ndarray[Any, Any]:
    """Coefficients of a bracket monomial at the diagonal monomials of the basis."""
    import numpy as np

    orders = list(permutations(range(rank)))
    if len(orders) ** len(monomial) > MAX_ARRANGEMENTS:
        raise LimitReached(f"a monomial of more than {MAX_ARRANGEMENTS:,} arrangements")
    row_signs = np.array([permutation_sign(o) for o in orders], dtype=np.int64)
    weights = _weights(content, rank)
    codes, signs = np.zeros(1, dtype=np.int64), np.ones(1, dtype=np.int64)
    for row in monomial:
        row_codes = np.array([sum(weights[p][c] for p, c in zip(row, o, strict=True)) for o in orders], dtype=np.int64)
        codes = (codes[:, None] + row_codes).ravel()
        signs = (signs[:, None] * row_signs).ravel()
    keys, _ = _basis(content, rank)
    at = np.searchsorted(-keys, -codes)
    hit = (at < len(keys)) & (keys[np.minimum(at, len(keys) - 1)] == codes)
    out = np.zeros(len(keys), dtype=np.int32)  # no sum exceeds the number of arrangements
    np.add.at(out, at[hit], signs[hit].astype(np.int32))
    return out
