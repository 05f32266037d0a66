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
from collections.abc import Iterable

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row
from gcrules.algebra.straightening.straighten import straighten_terms

__all__ = ["easy_order", "easy_places", "same_function"]


def easy_order(poly: BracketPolynomial) -> tuple[str, ...]:
    """The points, those at infinity first, bracket by bracket; those that do not occur last."""
    return tuple(poly.points[i] for i in easy_places(poly.terms, len(poly.points), poly.ideal))


def easy_places(monomials: Iterable[Monomial], points: int, ideal: int) -> tuple[int, ...]:
    """The same for monomials over so many points, the first `ideal` of them at infinity; by their numbers."""
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


def same_function(one: BracketPolynomial, other: BracketPolynomial, limit: int) -> bool:
    """Whether two polynomials are equal modulo syzygies, proved by the normal form of their difference in an order in
    which it is found quickly. Raises LimitReached beyond `limit` terms at a time.
    """
    difference = one - other
    order = easy_order(difference)
    return not straighten_terms(difference.over(order, difference.ideal).terms, difference.ideal, limit)
