r"""Products of several expressions: the irreducible factors of a polynomial in groups, each of them one expression."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import reduce
from itertools import combinations
from operator import mul

from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.factoring.limits import Budget
from gcrules.factoring.matches import search
from gcrules.factoring.trees import Written

__all__ = ["Groups", "sub_multisets"]

_Cover = tuple[tuple[Row, ...], list[list[Written]]]


@dataclass
class Groups:
    """The irreducible factors of a polynomial: the brackets `rows`, and `parts` that are no brackets, each as often as
    it occurs. `built` is the largest number of extensors of a search; `known` remembers what searches found.
    """

    rows: tuple[Row, ...]
    parts: Sequence[BracketPolynomial]
    budget: Budget
    built: int = 0
    known: dict[tuple[tuple[int, ...], tuple[Row, ...]], list[Written]] = field(default_factory=dict)

    def cover(self) -> _Cover | None:
        """The brackets left over, and for each group of parts, with brackets inside it where need be, all expressions
        that are multiples of its product; None if the parts cannot be so grouped.

        Small groups are tried first, and few brackets inside. Raises LimitReached.
        """
        return self._cover(tuple(range(len(self.parts))), self.rows)

    def _cover(self, left: tuple[int, ...], rows: tuple[Row, ...]) -> _Cover | None:
        if not left:
            return rows, []
        first, *others = left
        for size in range(len(others) + 1):
            for more in combinations(others, size):
                for inside in sub_multisets(rows):
                    found = self._expressions((first, *more), inside)
                    rest = found and self._cover(tuple(i for i in others if i not in more), _without(rows, inside))
                    if rest:
                        return rest[0], [found, *rest[1]]
        return None

    def _expressions(self, group: tuple[int, ...], inside: tuple[Row, ...]) -> list[Written]:
        """Those of one group; equal parts bear one number, so that no product is searched twice."""
        key = tuple(sorted(self.parts.index(self.parts[i]) for i in group)), inside
        if key not in self.known:
            target = reduce(mul, (self.parts[i] for i in group))
            self.known[key], built = search(target * target.with_terms({inside: 1}), self.budget)
            self.built = max(self.built, built)
        return self.known[key]


def sub_multisets(rows: tuple[Row, ...]) -> Iterator[tuple[Row, ...]]:
    """Those of some brackets, small ones first."""
    for size in range(len(rows) + 1):
        yield from dict.fromkeys(combinations(rows, size))


def _without(rows: tuple[Row, ...], some: tuple[Row, ...]) -> tuple[Row, ...]:
    left = list(rows)
    for row in some:
        left.remove(row)
    return tuple(left)
