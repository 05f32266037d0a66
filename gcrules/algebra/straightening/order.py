r"""An order of the points in which a polynomial is quickly straightened.

The normal form depends on the order, whether it is zero does not. Where the points of each bracket that occurs in many
terms stand side by side, there is little to straighten: products of separate brackets are standard then.

    >>> from gcrules.algebra.expand import expand
    >>> from gcrules.algebra.language.syntax import parse
    >>> easy_order(expand(parse("[ace][bdf] - [ace][bfd]", rank=3)))
    ('a', 'c', 'e', 'b', 'd', 'f')
"""

from __future__ import annotations

from collections import Counter

from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.straightening.straighten import straighten_terms

__all__ = ["easy_order", "same_function"]


def easy_order(poly: BracketPolynomial) -> tuple[str, ...]:
    """The points, those at infinity first, bracket by bracket; those that do not occur last."""
    rows = Counter(row for m in poly.terms for row in m)
    often = Counter(i for m in poly.terms for row in m for i in row)
    placed: dict[int, None] = {}

    def next_best(row: Row) -> tuple[int, int, tuple[int, ...]]:
        return rows[row], sum(i in placed for i in row), tuple(-i for i in row)

    while rows:
        row = max(rows, key=next_best)
        placed.update((i, None) for i in sorted(row, key=lambda i: (-often[i], i)))
        rows = Counter({r: n for r, n in rows.items() if any(i not in placed for i in r)})
    placed.update((i, None) for i in range(len(poly.points)))
    return tuple(poly.points[i] for i in sorted(placed, key=lambda i: i >= poly.ideal))


def same_function(one: BracketPolynomial, other: BracketPolynomial, limit: int) -> bool:
    """Whether two polynomials are equal modulo syzygies, proved by the normal form of their difference in an order in
    which it is found quickly. Raises LimitReached beyond `limit` terms at a time.
    """
    difference = one - other
    order = easy_order(difference)
    return not straighten_terms(difference.over(order, difference.ideal).terms, difference.ideal, limit)
