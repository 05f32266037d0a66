r"""Straightening: the normal form of a bracket polynomial as a combination of standard tableaux.

A monomial is written as a tableau with its brackets as rows; it is *standard* if the rows increase strictly from left
to right and the columns do not decrease from top to bottom. Standard monomials are a basis of the bracket ring, so
two polynomials are equal as functions of the points if and only if their normal forms have the same terms.

Two adjacent rows with an offending column are replaced by their standard form (see `two_rows`); the new first row is
always smaller, so taking the largest monomial first handles every monomial once. Where that becomes long, `levels`
goes on with the same replacements, many at a time.

    >>> from gcrules.algebra.language.syntax import parse
    >>> print(straighten(parse("[p1p4p5][p1p5p6][p2p3p4]", rank=3)))
    [p1p2p3][p1p4p5][p4p5p6] - [p1p2p4][p1p4p5][p3p5p6] + [p1p3p4][p1p4p5][p2p5p6]
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from heapq import heapify, heappop, heappush
from itertools import pairwise
from math import comb, inf
from operator import gt
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Monomial, Row, Terms
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.expr import Expr, sub
from gcrules.algebra.straightening.order import divided, easiest
from gcrules.algebra.straightening.syzygies import offending_column, pattern_of, syzygy, two_rows
from gcrules.algebra.straightening.work import WORK_PER_TERM, Work
from gcrules.core.budget import checkpoint, watched
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import LimitReached

__all__ = [
    "WORK_PER_TERM",
    "Last",
    "Straightening",
    "is_standard",
    "is_zero",
    "next_syzygy",
    "offence",
    "straighten",
    "straighten_steps",
    "straighten_terms",
    "terms_are_zero",
]

straighten_levels = deferred("gcrules.algebra.straightening.batch:straighten_levels")

_FEW = 20_000  # replacements after which arrays take over, unless there are more possible rows than they can number
_MOST_ROWS = 100_000
_TALL = 64  # brackets of a monomial for which arrays would be too large

_Pair = tuple[Row, Row]


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


def is_zero(
    poly: BracketPolynomial | ExtensorPolynomial | Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_TERMS,
) -> bool:
    """Whether the normal form has no terms: whether the value is 0 for all positions. Arguments as in `straighten`.

    That does not depend on the order of the points, so an order is taken in which less is to be done.
    """
    if isinstance(poly, Expr):
        poly = expand(poly, points=points, ideal=ideal, rank=rank, limit=limit)
    terms = _closed(poly)[0] if isinstance(poly, ExtensorPolynomial) else poly.terms
    return terms_are_zero(terms, poly.ideal, limit)


def _extensor(poly: ExtensorPolynomial, limit: int) -> ExtensorPolynomial:
    """The normal form of an extensor: closed by new points, straightened, and opened again."""
    closed, new = _closed(poly)
    parts: dict[Row, Terms] = {}
    for m, c in straighten_terms(closed, poly.ideal, limit).items():
        (last,) = (row for row in m if row[poly.step :] == new) if new else (m[-1],)
        rest = list(m)
        rest.remove(last)
        parts.setdefault(last[: poly.step], {})[tuple(rest)] = c
    polynomials = {row: BracketPolynomial(poly.rank, poly.points, t, poly.ideal) for row, t in parts.items()}
    return ExtensorPolynomial(poly.rank, poly.points, poly.step, polynomials, poly.ideal)


def _closed(poly: ExtensorPolynomial) -> tuple[Terms, Row]:
    """The extensors made brackets by new points, and these points."""
    n = len(poly.points)
    new = tuple(range(n, n + poly.rank - poly.step))
    closed: Terms = {}
    for row, coefficient in poly.parts.items():
        for m, c in coefficient.terms.items():
            key = tuple(sorted((*m, row + new)))
            closed[key] = closed.get(key, 0) + c  # where nothing is new, [abcd] efgh and [efgh] abcd are one
    return closed, new


def terms_are_zero(terms: Mapping[Monomial, Any], ideal: int = 0, limit: int = MAX_TERMS) -> bool:
    """Whether raw terms straighten to nothing."""
    _, left = divided(_alive(terms, ideal))  # a product is zero only where a factor is
    return not straighten_terms(easiest(left, ideal), ideal, limit)


def _alive(terms: Mapping[Monomial, Any], ideal: int) -> Terms:
    """Without terms that are zero."""
    return {m: c for m, c in terms.items() if c and not any(row[-1] < ideal for row in m)}


def straighten_terms(terms: Mapping[Monomial, Any], ideal: int = 0, limit: int = MAX_TERMS) -> Terms:
    """The normal form of raw terms; rows whose points all come before `ideal` are 0."""
    pending = _alive(terms, ideal)
    work = Work(limit)
    arrays = max(map(len, pending), default=0) <= _TALL and _possible_rows(pending) <= _MOST_ROWS
    normal = _largest_first(pending, ideal, work, _FEW if arrays else inf)
    if pending:
        for m, c in straighten_levels(pending, ideal, work).items():
            normal[m] = normal.get(m, 0) + c
    return normal


def _possible_rows(terms: Terms) -> int:
    letters = {i for m in terms for row in m for i in row}
    return comb(len(letters), max((len(row) for m in terms for row in m), default=0))


def _largest_first(pending: Terms, ideal: int, work: Work, enough: float) -> Terms:
    """Moves monomials from `pending` into the normal form until none is left or there was `enough` work."""
    heap = [Last(m) for m in pending]
    heapify(heap)
    normal: Terms = {}
    seen: set[_Pair] = set()
    while heap and work.replacements.done < enough:
        monomial = heappop(heap).monomial
        coefficient = pending.pop(monomial)
        if not coefficient:
            continue
        at = offence(monomial)
        if at is None:
            normal[monomial] = coefficient
            checkpoint()
            continue
        above, below = monomial[:at], monomial[at + 2 :]
        pair = monomial[at], monomial[at + 1]
        if pair not in seen:
            seen.add(pair)
            work.syzygies(pattern_of(*pair)[1])
        replacements = two_rows(*pair)
        for c, first, second in replacements:
            if first[-1] < ideal:
                continue
            new = tuple(sorted((*above, first, second, *below)))
            if new in pending:
                pending[new] += c * coefficient
            else:
                pending[new] = c * coefficient
                heappush(heap, Last(new))
        work.replacements.spend(len(replacements))
        work.terms.check(len(pending) + len(normal))
    return normal


class Last:
    """Reverses the order, so that a heap yields the largest monomial first."""

    __slots__ = ("monomial",)

    def __init__(self, monomial: Monomial) -> None:
        self.monomial = monomial

    def __lt__(self, other: Last) -> bool:
        return self.monomial > other.monomial


def is_standard(monomial: Monomial) -> bool:
    """Whether a sorted monomial with increasing rows is a standard tableau.

    >>> is_standard(((0, 1, 2), (0, 3, 4))), is_standard(((0, 3, 4), (1, 2, 5)))
    (True, False)
    """
    return offence(monomial) is None


def offence(monomial: Monomial) -> int | None:
    """The first row that is larger than the one below it in some column."""
    for i, (above, below) in enumerate(pairwise(monomial)):
        if above != below and any(map(gt, above, below)):
            return i
    return None


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
        checkpoint()
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

    >>> from gcrules.algebra.language.syntax import parse
    >>> step, after = next_syzygy(expand(parse("2[ade][bcf]", rank=3)))
    >>> print(step, after, sep="; ")
    [ade][bcf] = -[abc][def] + [abd][cef] - [abe][cdf] - [acd][bef] + [ace][bdf]; -2[abc][def] + ...
    """
    for monomial in watched(sorted(poly.terms, reverse=True)):
        step = _on_monomial(monomial, poly)
        if step is not None:
            return step, poly + (step.after - step.before) * poly.terms[monomial]
    return None


def _on_monomial(monomial: Monomial, poly: BracketPolynomial) -> Straightening | None:
    """The syzygy on the first two rows that keep a monomial over the points of `poly` from being standard."""
    at = offence(monomial)
    if at is None:
        return None
    column = offending_column(monomial[at], monomial[at + 1])
    assert column is not None
    after: Terms = {}
    for sign, (first, second) in syzygy(monomial[at], monomial[at + 1], column):
        if first[-1] < poly.ideal or second[-1] < poly.ideal:
            continue
        new = tuple(sorted((*monomial[:at], first, second, *monomial[at + 2 :])))
        after[new] = after.get(new, 0) + sign
    return Straightening(poly.with_terms({monomial: 1}), poly.with_terms(after), (at, at + 1), column)
