r"""Straightening: the normal form of a bracket polynomial as a combination of standard tableaux.

A monomial is written as a tableau with its brackets as rows; it is *standard* if the rows increase strictly from left
to right and the columns do not decrease from top to bottom. Standard monomials are a basis of the bracket ring, so
two polynomials are equal as functions of the points if and only if their normal forms have the same terms.

Two adjacent rows with an offending column are replaced by means of the van der Waerden syzygy; the new first row is
always smaller, so taking the largest monomial first handles every monomial once. The two-row straightenings depend on
the relative order of the points only and are kept.

    >>> from gcrules.algebra.syntax import parse
    >>> print(straighten(parse("[p1p4p5][p1p5p6][p2p3p4]", rank=3)))
    [p1p2p3][p1p4p5][p4p5p6] - [p1p2p4][p1p4p5][p3p5p6] + [p1p3p4][p1p4p5][p2p5p6]
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from heapq import heapify, heappop, heappush
from itertools import combinations
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Monomial, Row, Terms, sorted_row
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.expr import Expr, permutation_sign, sub
from gcrules.errors import LimitReached

__all__ = ["Straightening", "is_standard", "next_syzygy", "straighten", "straighten_steps"]

WORK_PER_TERM = 25  # replacements that are made for each term that may be held
_WORK_OF_A_SYZYGY = 5  # what one term of a syzygy takes, in replacements

_RAISE = "raise the limit with --limit (in Python limit=...)"

_Pattern = tuple[tuple[tuple[int, Row, Row], ...], int]


def straighten(
    poly: BracketPolynomial | ExtensorPolynomial | Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """The normal form. An expression is expanded first (`points`, `ideal`, `rank`, `limit` as in `expand`).

    An extensor polynomial of step k is joined with d − k new points that come last in the order, straightened, and
    read back, so its normal form too is unique. Raises LimitReached beyond `limit` terms at a time.
    """
    if isinstance(poly, Expr):
        poly = expand(poly, points=points, ideal=ideal, rank=rank, limit=limit)
    if isinstance(poly, ExtensorPolynomial):
        return _extensor(poly, limit)
    return poly.with_terms(straighten_terms(poly.terms, poly.ideal, limit))


def _extensor(poly: ExtensorPolynomial, limit: int) -> ExtensorPolynomial:
    n = len(poly.points)
    new = tuple(range(n, n + poly.rank - poly.step))
    closed: Terms = {}
    for row, coefficient in poly.parts.items():
        for m, c in coefficient.terms.items():
            key = tuple(sorted((*m, row + new)))
            closed[key] = closed.get(key, 0) + c  # where nothing is new, [abcd] efgh and [efgh] abcd are one
    parts: dict[Row, Terms] = {}
    for m, c in straighten_terms(closed, poly.ideal, limit).items():
        (last,) = (row for row in m if row[poly.step :] == new) if new else (m[-1],)
        rest = list(m)
        rest.remove(last)
        parts.setdefault(last[: poly.step], {})[tuple(rest)] = c
    polynomials = {row: BracketPolynomial(poly.rank, poly.points, t, poly.ideal) for row, t in parts.items()}
    return ExtensorPolynomial(poly.rank, poly.points, poly.step, polynomials, poly.ideal)


def straighten_terms(terms: Mapping[Monomial, Any], ideal: int = 0, limit: int = MAX_TERMS) -> Terms:
    """The normal form of raw terms; rows whose points all come before `ideal` are 0."""
    pending: dict[Monomial, Any] = {}
    for m, c in terms.items():
        if c and not any(row[-1] < ideal for row in m):
            pending[m] = c
    heap = [_Last(m) for m in pending]
    heapify(heap)
    normal: Terms = {}
    seen: set[tuple[Row, Row]] = set()
    work = 0
    while heap:
        monomial = heappop(heap).monomial
        coefficient = pending.pop(monomial)
        if not coefficient:
            continue
        at = _offence(monomial)
        if at is None:
            normal[monomial] = coefficient
            continue
        above, below = monomial[:at], monomial[at + 2 :]
        pair = monomial[at], monomial[at + 1]
        if pair not in seen:
            seen.add(pair)
            work += _WORK_OF_A_SYZYGY * _pattern_of(*pair)[1]
        for c, first, second in _two_rows(*pair):
            if first[-1] < ideal:
                continue
            new = tuple(sorted((*above, first, second, *below)))
            if new in pending:
                pending[new] += c * coefficient
            else:
                pending[new] = c * coefficient
                heappush(heap, _Last(new))
            work += 1
        if len(pending) > limit:
            raise LimitReached(f"straightening holds more than {limit:,} terms at a time", hint=_RAISE)
        if work > WORK_PER_TERM * limit:
            raise LimitReached(f"straightening takes more than {WORK_PER_TERM * limit:,} replacements", hint=_RAISE)
    return normal


class _Last:
    """Reverses the order, so that a heap yields the largest monomial first."""

    __slots__ = ("monomial",)

    def __init__(self, monomial: Monomial) -> None:
        self.monomial = monomial

    def __lt__(self, other: _Last) -> bool:
        return self.monomial > other.monomial


def is_standard(monomial: Monomial) -> bool:
    """Whether a sorted monomial with increasing rows is a standard tableau.

    >>> is_standard(((0, 1, 2), (0, 3, 4))), is_standard(((0, 3, 4), (1, 2, 5)))
    (True, False)
    """
    return _offence(monomial) is None


def _offence(monomial: Monomial) -> int | None:
    """The first row that is larger than the one below it in some column."""
    for i in range(len(monomial) - 1):
        for x, y in zip(monomial[i], monomial[i + 1], strict=True):
            if x > y:
                return i
    return None


@lru_cache(maxsize=1 << 15)
def _two_rows(first: Row, second: Row) -> tuple[tuple[int, Row, Row], ...]:
    """The standard form of [first][second], from the one for points 0, 1, 2, … in the same relative order."""
    letters = sorted({*first, *second})
    pattern, _ = _pattern_of(first, second)
    return tuple((c, tuple(letters[i] for i in one), tuple(letters[i] for i in other)) for c, one, other in pattern)


def _pattern_of(first: Row, second: Row) -> _Pattern:
    place = {x: i for i, x in enumerate(sorted({*first, *second}))}
    return _two_row_pattern(tuple(place[x] for x in first), tuple(place[x] for x in second))


@lru_cache(maxsize=1 << 14)
def _two_row_pattern(first: Row, second: Row) -> _Pattern:
    """The standard form of [first][second], and the number of terms that its syzygies had."""
    work = 0
    normal: dict[Monomial, int] = {}
    pending: dict[Monomial, int] = {(first, second): 1}
    while pending:
        largest = max(pending)
        coefficient = pending.pop(largest)
        if not coefficient:
            continue
        one, other = largest
        column = _column(one, other)
        if column is None:
            normal[largest] = coefficient
            continue
        for c, rows in _syzygy(one, other, column):
            pending[rows] = pending.get(rows, 0) + c * coefficient
            work += 1
    return tuple((c, one, other) for (one, other), c in sorted(normal.items())), work


def _column(one: Row, other: Row) -> int | None:
    return next((j for j, (x, y) in enumerate(zip(one, other, strict=True)) if x > y), None)


def _syzygy(one: Row, other: Row, column: int) -> Iterator[tuple[int, Monomial]]:
    """[one][other] as the sum of the other terms of the van der Waerden syzygy that shuffles other[0 … column] with
    one[column …]; these d + 1 points are different, since the former are all smaller than the latter.
    """
    moving = (*one[column:], *other[: column + 1])
    up = len(one) - column
    for chosen in combinations(range(len(moving)), up):
        if chosen == tuple(range(up)):
            continue
        rest = tuple(i for i in range(len(moving)) if i not in chosen)
        s, first = sorted_row((*one[:column], *(moving[i] for i in chosen)))
        t, second = sorted_row((*(moving[i] for i in rest), *other[column + 1 :]))
        sign = s * t * permutation_sign(chosen + rest)
        if sign:
            yield -sign, (first, second) if first <= second else (second, first)


@dataclass(frozen=True)
class Straightening:
    """One recorded step: `before` (a single monomial) equals `after` by a syzygy on two of its rows."""

    before: BracketPolynomial
    after: BracketPolynomial
    rows: tuple[int, int]
    column: int

    @property
    def identity(self) -> Expr:
        """The step as an expression that must vanish, for replay on the oracle."""
        return sub(self.before.to_expr(), self.after.to_expr(), rank=self.before.rank)

    def __str__(self) -> str:
        return f"{self.before} = {self.after}"


def straighten_steps(
    poly: BracketPolynomial, limit: int = 2_000
) -> tuple[BracketPolynomial, tuple[Straightening, ...]]:
    """The normal form with every single van der Waerden syzygy that led to it, largest monomial first.

    Raises LimitReached beyond `limit` steps.
    """
    pending: Terms = {m: c for m, c in poly.terms.items() if not any(row[-1] < poly.ideal for row in m)}
    normal: Terms = {}
    steps: list[Straightening] = []
    while pending:
        monomial = max(pending)
        coefficient = pending.pop(monomial)
        step = _on_monomial(monomial, poly)
        if step is None:
            normal[monomial] = coefficient
            continue
        if len(steps) == limit:
            raise LimitReached(f"straightening takes more than {limit:,} syzygies", hint="leave out --steps")
        steps.append(step)
        for new, c in step.after.terms.items():
            pending[new] = pending.get(new, 0) + c * coefficient
            if not pending[new]:
                del pending[new]
    return poly.with_terms(normal), tuple(steps)


def next_syzygy(poly: BracketPolynomial) -> tuple[Straightening, BracketPolynomial] | None:
    """The syzygy on the largest monomial that is not standard, and the polynomial after it; None in normal form.

    >>> from gcrules.algebra.syntax import parse
    >>> step, after = next_syzygy(expand(parse("2[ade][bcf]", rank=3)))
    >>> print(step, after, sep="; ")
    [ade][bcf] = -[abc][def] + [abd][cef] - [abe][cdf] - [acd][bef] + [ace][bdf]; -2[abc][def] + ...
    """
    for monomial in sorted(poly.terms, reverse=True):
        step = _on_monomial(monomial, poly)
        if step is not None:
            return step, poly + (step.after - step.before) * poly.terms[monomial]
    return None


def _on_monomial(monomial: Monomial, poly: BracketPolynomial) -> Straightening | None:
    """The syzygy on the first two rows that keep a monomial over the points of `poly` from being standard."""
    at = _offence(monomial)
    if at is None:
        return None
    column = _column(monomial[at], monomial[at + 1])
    assert column is not None
    after: Terms = {}
    for sign, (first, second) in _syzygy(monomial[at], monomial[at + 1], column):
        if first[-1] < poly.ideal or second[-1] < poly.ideal:
            continue
        new = tuple(sorted((*monomial[:at], first, second, *monomial[at + 2 :])))
        after[new] = after.get(new, 0) + sign
    return Straightening(poly.with_terms({monomial: 1}), poly.with_terms(after), (at, at + 1), column)
