r"""Products of several expressions: the irreducible factors of a polynomial in groups, each of them one expression."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import field
from functools import reduce
from math import prod
from operator import mul
from typing import TypeVar

from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.factoring.trees import Written
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Cover", "Group", "Groups", "sub_multisets"]

_Numbers = tuple[int, ...]
_T = TypeVar("_T")
_Row = TypeVar("_Row", Row, tuple[str, ...])
_MOST_TERMS = 20_000  # of a group that is searched


@dataclass(frozen=True)
class Group:
    """`times` times the product of some parts (places, each as often as it is taken) and brackets: all expressions that
    are multiples of it, the simplest first.
    """

    parts: _Numbers
    inside: tuple[Row, ...]
    expressions: list[Written]
    times: int = 1


@dataclass(frozen=True)
class Cover:
    """The brackets left over, and groups that hold each part as often as it occurs."""

    outside: Counter[Row]
    groups: tuple[Group, ...]


@dataclass
class Groups:
    """The irreducible factors of a polynomial: the brackets `rows`, and the different `parts` that are no brackets,
    each as often as `times` says. `built` is the largest number of extensors of a search; `known` remembers what
    searches found, `ended` the limits that ended some.
    """

    rows: Counter[Row]
    parts: Sequence[BracketPolynomial]
    times: Sequence[int]
    effort: Effort
    built: int = 0
    known: dict[tuple[_Numbers, tuple[Row, ...]], list[Written]] = field(default_factory=dict)
    ended: dict[tuple[_Numbers, tuple[Row, ...]], LimitReached] = field(default_factory=dict)

    def cover(self) -> Cover | None:
        """Groups of which each is one expression, with brackets inside it where need be; None if there are none.

        Small groups are tried first, and few brackets inside. Raises LimitReached where a search ended at a limit and
        no others make a cover.
        """
        found = self._cover(tuple(self.times), self.rows)
        if found is None and self.ended:
            raise next(iter(self.ended.values()))
        return found

    def alone(self, part: int) -> list[Written] | LimitReached:
        """The expressions of one part without brackets inside, or the limit at which their search ended."""
        try:
            found = self._expressions((part,), ())
        except LimitReached as reached:
            return reached
        return self.ended.get(((part,), ()), found)

    def _cover(self, left: _Numbers, rows: Counter[Row]) -> Cover | None:
        checkpoint()
        first = next((i for i, n in enumerate(left) if n), None)
        if first is None:
            return Cover(rows, ())
        others = tuple(n - (i == first) for i, n in enumerate(left))
        for size in range(sum(others) + 1):
            for more in _chosen(list(enumerate(others)), size):
                for inside in sub_multisets(rows):
                    group = tuple(sorted((first, *more)))
                    found = self._expressions(group, inside)
                    rest = found and self._rest(left, rows, Group(group, inside, found))
                    if rest:
                        return rest
        return None

    def _rest(self, left: _Numbers, rows: Counter[Row], group: Group) -> Cover | None:
        """A group as often as it can be taken, else fewer times, and a cover of what is left."""
        parts, brackets = Counter(group.parts), Counter(group.inside)
        most = min(*(left[i] // n for i, n in parts.items()), *(rows[r] // n for r, n in brackets.items()), 10**9)
        for times in range(most, 0, -1):
            remaining = tuple(n - times * parts[i] for i, n in enumerate(left))
            used = Counter({row: times * n for row, n in brackets.items()})
            rest = self._cover(remaining, rows - used)
            if rest is not None:
                taken = Group(group.parts, group.inside, group.expressions, times)
                return Cover(rest.outside, (taken, *rest.groups))
        return None

    def _expressions(self, group: _Numbers, inside: tuple[Row, ...]) -> list[Written]:
        """Those of one group; no product is searched twice."""
        checkpoint()
        key = group, inside
        if key not in self.known:
            effort = self.effort.renewed()
            try:
                if prod(len(self.parts[i]) for i in group) > _MOST_TERMS:
                    raise LimitReached(
                        f"a product of {len(group)} irreducible factors has more than {_MOST_TERMS:,} terms,"
                        " so it is not decided whether one expression equals it",
                        hint="factor the irreducible factors one by one",
                    )
                target = reduce(mul, (self.parts[i] for i in group))
                self.known[key], built = search(target * target.with_terms({inside: 1}), effort)
                self.built = max(self.built, built)
            except LimitReached as reached:
                self.known[key], self.ended[key] = [], reached.with_traceback(None)  # which holds the extensors
            self.effort.products += effort.products
        return self.known[key]


def sub_multisets(rows: Counter[_Row]) -> Iterator[tuple[_Row, ...]]:
    """Those of some brackets, small ones first."""
    for size in range(rows.total() + 1):
        yield from _chosen(sorted(rows.items()), size)


def _chosen(items: Sequence[tuple[_T, int]], size: int) -> Iterator[tuple[_T, ...]]:
    """So many of some items, each no more often than it is there."""
    if not size:
        yield ()
    for i, (item, n) in enumerate(items):
        for k in range(min(n, size), 0, -1):
            for rest in _chosen(items[i + 1 :], size - k):
                yield (item,) * k + rest
