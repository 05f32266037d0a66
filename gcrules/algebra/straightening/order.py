r"""Orders of the points in which a polynomial is quickly straightened.

The normal form depends on the order, whether it is zero does not. Where the points of each bracket that occurs in many
terms stand side by side, there is little to straighten: products of separate brackets are standard then.

    >>> from gcrules.algebra.expand import expand
    >>> from gcrules.algebra.language.syntax import parse
    >>> easy_order(expand(parse("[ace][bdf] - [ace][bfd]", rank=3)))
    ('a', 'c', 'e', 'b', 'd', 'f')
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from itertools import combinations, islice
from operator import gt
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms, sorted_row
from gcrules.algebra.straightening.syzygies import pattern_of
from gcrules.core.budget import watched

__all__ = ["divided", "easiest", "easy_order", "orders", "reordered"]

_ROWS = 1_000  # different brackets among which an easy order is quickly found
_FEW = 20  # terms that are straightened before orders are compared
_LOOKED_AT = 50  # terms by which orders are compared

Order = tuple[int, ...]


def easy_order(poly: BracketPolynomial) -> tuple[str, ...]:
    """The points, those at infinity first, bracket by bracket; those that do not occur last."""
    return tuple(poly.points[i] for i in _bracket_by_bracket(poly.terms, len(poly.points), poly.ideal))


def orders(monomials: Collection[Monomial], points: int, ideal: int) -> tuple[Order, ...]:
    """Orders of so many points that may be easy, the first `ideal` of them, which are at infinity, before the others.
    Rows of one entry do not count.
    """
    brackets = [tuple(row for row in m if len(row) > 1) for m in monomials]
    found = [_by_frequency(brackets, points, ideal)]
    if len({row for m in brackets for row in m}) <= _ROWS:
        easy = _bracket_by_bracket(brackets, points, ideal)
        found += [easy, (*easy[:ideal][::-1], *easy[ideal:][::-1])]
    return tuple(dict.fromkeys(found))


def easiest(terms: Mapping[Monomial, Any], ideal: int) -> Terms:
    """Raw terms in the order of points in which straightening seems to be shortest."""
    points = 1 + max((i for m in terms for row in m if len(row) > 1 for i in row), default=-1)
    if len(terms) <= _FEW:
        return reordered(terms, _by_frequency(terms, points, ideal))
    return min((reordered(terms, order) for order in orders(terms, points, ideal)), key=_work)


def divided(terms: Mapping[Monomial, Any]) -> tuple[Monomial, Mapping[Monomial, Any]]:
    """The brackets that divide all terms, and what is left of the terms without them.

    >>> divided({((0, 1), (0, 1), (2, 3)): 1, ((0, 1), (0, 2), (1, 3)): -1})
    (((0, 1),), {((0, 1), (2, 3)): 1, ((0, 2), (1, 3)): -1})
    """
    common: Counter[Row] | None = None
    for m in watched(terms):
        common = Counter(m) if common is None else common & Counter(m)
        if not common:
            return (), terms
    if common is None:
        return (), terms
    left = {tuple(sorted((Counter(m) - common).elements())): c for m, c in watched(terms.items())}
    return tuple(sorted(common.elements())), left


def _by_frequency(monomials: Iterable[Monomial], points: int, ideal: int) -> Order:
    """Those that occur often go first, so that many rows agree in their first points."""
    often = Counter(i for m in monomials for row in m if len(row) > 1 for i in row)
    return tuple(sorted(range(points), key=lambda x: (x >= ideal, -often[x], x)))


def _bracket_by_bracket(monomials: Iterable[Monomial], points: int, ideal: int) -> Order:
    """The brackets of most terms go first, the points of each side by side."""
    all_rows = [row for m in monomials for row in m]
    rows, often = Counter(all_rows), Counter(i for row in all_rows for i in row)
    placed: dict[int, None] = {}

    def next_best(row: Row) -> tuple[int, int, tuple[int, ...]]:
        return rows[row], sum(i in placed for i in row), tuple(-i for i in row)

    while rows:
        row = max(rows, key=next_best)
        placed.update((i, None) for i in sorted(row, key=lambda i: (-often[i], i)))
        rows = Counter({r: n for r, n in rows.items() if any(i not in placed for i in r)})
    placed.update((i, None) for i in range(points))
    return tuple(sorted((i for i in placed if i < points), key=lambda i: i >= ideal))


def _work(terms: Mapping[Monomial, Any]) -> int:
    """An estimate of what straightening takes, in terms made: each pair of rows that is not standard multiplies them by
    the terms of its own straightening.
    """
    total = 0
    for m in watched(islice(terms, 0, None, max(1, len(terms) // _LOOKED_AT))):
        made = 1
        for above, below in combinations(m, 2):
            if any(map(gt, above, below)):
                made *= 1 + pattern_of(above, below)[1]
        total += made - 1
    return total


def reordered(terms: Mapping[Monomial, Any], order: Iterable[int]) -> Terms:
    """Raw terms in which points have the numbers of their places in an order. Numbers that are not in it stay as they
    are, and so do rows of one entry.
    """
    place = {x: n for n, x in enumerate(order)}
    rows = {row for m in terms for row in m}
    known = {row: sorted_row(place.get(i, i) for i in row) if len(row) > 1 else (1, row) for row in rows}
    moved: Terms = {}
    for m, c in watched(terms.items()):
        signed = [known[row] for row in m]
        for sign, _ in signed:
            c = c * sign
        key = tuple(sorted(row for _, row in signed))
        moved[key] = moved.get(key, 0) + c
    return moved
