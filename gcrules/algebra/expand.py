r"""Expansion: any expression of joins, meets, brackets and superbrackets as a polynomial in brackets of points.

>>> from gcrules.algebra.language.syntax import parse
>>> print(expand(parse("ab /\\ cde")))
[acde] * b - [bcde] * a
>>> print(expand(parse("abf /\\ ace /\\ edf /\\ cbd")))
[abcd][acef][bdef] - [abce][adef][bcdf]
"""

from __future__ import annotations

from bisect import bisect
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, reduce
from itertools import chain, combinations, product, repeat
from math import comb
from typing import TypeVar

from gcrules.algebra.bracket import (
    BracketPolynomial,
    Coefficient,
    ExtensorPolynomial,
    Monomial,
    Row,
    Terms,
    sorted_row,
    tableau_order,
)
from gcrules.algebra.expr import (
    MAX_COEFFICIENT_BITS,
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    common_rank,
    points_of,
    too_many_bits,
)
from gcrules.algebra.scalars import written_out
from gcrules.algebra.superbrackets.determinant import Pair, determinant_terms
from gcrules.algebra.superbrackets.superbracket import form_terms
from gcrules.core.budget import MORE_TERMS, checkpoint, watched
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["MAX_BRACKETS", "MAX_TERMS", "Expander", "Multivector", "expand", "shuffles"]

MAX_TERMS = 200_000
MAX_BRACKETS = 1_000_000  # in one monomial
_LOOK_EVERY = 1_000  # products of terms between two looks at the clock
_MANY_BRACKETS = 64  # in a product that takes as long as two with few of them
_LONG = 1_000  # products of terms that are many for one product of polynomials
_SUPERBRACKET_WORK = 120  # what the 24 terms of a superbracket take, in products of terms
_SET_WORK = 20  # the same for a choice of joins of points, one from each line

_Key = TypeVar("_Key")
Multivector = dict[Row, Terms]  # extensor (increasing points; () for a scalar) -> its coefficient


def expand(
    e: Expr,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """Expand an expression: a BracketPolynomial for step 0, an ExtensorPolynomial for any other step.

    `points` declares the tableau order (else sorted), `ideal` the points at infinity, whose brackets among themselves
    are 0. Every meet is expanded by its definition over shuffles. Raises LimitReached where more than `limit` terms
    (or twenty times as many products of terms) would be made.
    """
    rank = common_rank(rank, e)
    at_infinity = tuple(dict.fromkeys(ideal))
    order = tableau_order(points_of(e), points, at_infinity)
    ideal_count = sum(n in at_infinity for n in order)
    parts = Expander(order, rank, ideal_count, limit).value(e)
    if e.step == 0:
        return BracketPolynomial(rank, order, parts.get((), {}), ideal_count)
    polynomials = {row: BracketPolynomial(rank, order, terms, ideal_count) for row, terms in parts.items()}
    return ExtensorPolynomial(rank, order, e.step, polynomials, ideal_count)


class Expander:
    """Values of expressions as Σ coefficient · extensor; parts that occur again are expanded once.

    A coefficient is Σ number · monomial in brackets. Rows of one entry are parameters: they commute
    and are never straightened. A meet is split on the side that gives fewer terms; `as_defined` on the first.
    """

    def __init__(self, order: Sequence[str], rank: int, ideal: int, limit: int, *, as_defined: bool = False) -> None:
        self.index = {n: i for i, n in enumerate(order)}
        self.rank = rank
        self.ideal = ideal
        self.limit = limit
        self.as_defined = as_defined
        self.work = 0
        self.pause = 0  # the work at which the limits are looked at again
        self.known: dict[Expr, Multivector] = {}

    def value(self, e: Expr) -> Multivector:
        if e not in self.known:
            self.known[e] = self._value(e)
        return self.known[e]

    def _value(self, e: Expr) -> Multivector:
        match e:
            case Number(value=value):
                return {(): {(): value}} if value else {}
            case Point(name=name):
                return {(self.index[name],): {(): 1}}
            case Join(args=args):
                return reduce(self._join, map(self.value, args))
            case Bracket(args=args):
                return self._closed(reduce(self._join, map(self.value, args)))
            case Meet(args=args):
                return reduce(self._meet, map(self.value, args))
            case Superbracket(lines=lines):
                return self._superbracket([self.value(line) for line in lines])
            case Sum(terms=terms):
                total: Multivector = {}
                for t in terms:
                    for row, coefficients in self.value(t).items():
                        self._add(total, row, coefficients, 1)
                return total
            case Product(factors=factors):
                return self._product(Counter(factors))
            case Power(base=base, exponent=n):
                return self._product({base: n})
            case Dotted():
                return self.value(written_out(e))
        raise TypeError(f"not an expression: {e!r}")

    def _product(self, powers: Mapping[Expr, int]) -> Multivector:
        """The product of powers, of which at most one is no scalar. Monomials are not multiplied one by one."""
        value: Multivector | None = None
        brackets: list[Row] = []
        coefficient: Coefficient = 1
        for base, n in powers.items():
            found = self.value(base)
            terms = found.get((), {})
            if len(found) == len(terms) == 1:
                ((monomial, c),) = terms.items()
                coefficient *= self._number_power(c, n)
                if len(brackets) + n * len(monomial) > MAX_BRACKETS:
                    raise LimitReached(f"the expansion has monomials of more than {MAX_BRACKETS:,} brackets")
                brackets += monomial * n
                self._worked(1)
            else:
                value = reduce(self._join, repeat(found, n) if value is None else chain((value,), repeat(found, n)))
        if value is not None and not brackets and coefficient == 1:
            return value
        monomial_part: Multivector = {(): {tuple(sorted(brackets)): coefficient}}
        return monomial_part if value is None else self._join(value, monomial_part)

    def _number_power(self, base: Coefficient, exponent: int) -> Coefficient:
        bits = max(base.numerator.bit_length(), base.denominator.bit_length()) - 1
        if bits * exponent > MAX_COEFFICIENT_BITS:
            raise too_many_bits()
        return base**exponent

    def _join(self, a: Multivector, b: Multivector) -> Multivector:
        out: Multivector = {}
        for r, p in a.items():
            for s, q in b.items():
                sign, row = sorted_row(r + s)
                if sign:
                    self._add(out, row, self._times(p, q), sign)
        return out

    def _closed(self, a: Multivector) -> Multivector:
        """Extensors of full step become brackets."""
        out: Multivector = {}
        for row, p in a.items():
            self._add(out, (), self._times_bracket(p, row), 1)
        return out

    def _meet(self, a: Multivector, b: Multivector) -> Multivector:
        out: Multivector = {}
        for r, p in a.items():
            for s, q in b.items():
                coefficient = self._times(p, q)
                for sign, bracket, rest in _meet_rows(self.rank, r, s, self.as_defined):
                    self._add(out, rest, self._times_bracket(coefficient, bracket), sign)
        return out

    def _superbracket(self, lines: list[Multivector]) -> Multivector:
        match self.rank:
            case 2:
                return self._closed(lines[0])
            case 3:
                return reduce(self._meet, lines)  # [[L, M, N]] = L ∧ M ∧ N: both are det(L*, M*, N*), * the duals
            case 4:
                return self._by_24_terms(lines)
        return self._by_determinant(lines)

    def _by_24_terms(self, lines: list[Multivector]) -> Multivector:
        """The superbracket in rank 4, for each choice of one join of two points from every line."""
        out: Multivector = {}
        for choice in product(*(line.items() for line in lines)):
            self._worked(_SUPERBRACKET_WORK)
            ends = [i for row, _ in choice for i in row]
            coefficient = reduce(self._times, (p for _, p in choice))
            for sign, brackets in form_terms(24):
                rows = [sorted_row(ends[i] for i in b) for b in brackets]
                for s, _ in rows:
                    sign *= s
                if sign:
                    monomial: Terms = {tuple(sorted(r for _, r in rows)): sign}
                    if not any(self._at_infinity(r) for _, r in rows):
                        self._add(out, (), self._times(coefficient, monomial), 1)
        return out

    def _by_determinant(self, lines: list[Multivector]) -> Multivector:
        """Each set of different joins of two points that the lines consist of, with its coefficient, is taken once."""
        chosen: dict[tuple[Pair, ...], Terms] = {(): {(): 1}}
        for line in lines:
            longer: dict[tuple[Pair, ...], Terms] = {}
            self._worked(_SET_WORK * len(chosen) * len(line))
            for pairs, p in chosen.items():
                for (a, b), q in line.items():
                    at = bisect(pairs, (a, b))
                    if at and pairs[at - 1] == (a, b):
                        continue
                    more = (*pairs[:at], (a, b), *pairs[at:])
                    if max(Counter(chain.from_iterable(more)).values()) < self.rank:  # else 0
                        self._add(longer, more, self._times(p, q), (-1) ** (len(pairs) - at))
            chosen = longer
        out: Multivector = {}
        for pairs, p in chosen.items():
            if p:
                self._worked(_SUPERBRACKET_WORK)
                terms = determinant_terms(pairs, self.rank, self._worked)
                live = {m: c for m, c in terms.items() if not any(map(self._at_infinity, m))}
                self._add(out, (), self._times(p, live), 1)
        return out

    def _at_infinity(self, row: Row) -> bool:
        return row[-1] < self.ideal

    def _times_bracket(self, terms: Terms, row: Row) -> Terms:
        return {} if self._at_infinity(row) else self._times(terms, {(row,): 1})

    def _times(self, a: Terms, b: Terms) -> Terms:
        """The product of two polynomials in brackets."""
        brackets = len(next(iter(a), ())) + len(next(iter(b), ()))
        self._worked(len(a) * len(b) * (1 + brackets // _MANY_BRACKETS))
        if len(b) == 1 and () in b:
            return a if b[()] == 1 else {m: c * b[()] for m, c in a.items()}
        if len(a) < len(b):
            a, b = b, a
        out: Terms = {}
        for m, c in watched(a.items()) if len(a) * len(b) > _LONG else a.items():
            for n, k in b.items():
                key: Monomial = tuple(sorted(m + n)) if m and n else m or n
                value: Coefficient = out.get(key, 0) + c * k
                out[key] = value
        return out

    def _add(self, total: dict[_Key, Terms], row: _Key, terms: Terms, sign: int) -> None:
        """Add sign · terms to the coefficient of a row."""
        into = total.setdefault(row, {})
        for m, c in terms.items():
            value = into.get(m, 0) + sign * c
            if value:
                into[m] = value
            else:
                into.pop(m, None)
        self._worked(len(terms))
        if len(into) > self.limit:
            self._stop(f"the expansion has more than {self.limit:,} terms")

    def _worked(self, products: int) -> None:
        checkpoint()
        self.work += products
        if self.work > self.pause:
            if self.work > 20 * self.limit:
                self._stop(f"the expansion takes more than {20 * self.limit:,} products of terms")
            checkpoint()
            self.pause = min(self.work + _LOOK_EVERY, 20 * self.limit)

    def _stop(self, what: str) -> None:
        raise LimitReached(what, hint=MORE_TERMS)


@cache
def shuffles(step: int, first: int) -> tuple[tuple[int, Row, Row], ...]:
    """Sign and positions of every split of `step` places into `first` places and the rest, both increasing."""
    found = []
    for chosen in combinations(range(step), first):
        rest = tuple(i for i in range(step) if i not in chosen)
        found.append((permutation_sign(chosen + rest), chosen, rest))
    return tuple(found)


def _meet_rows(rank: int, a: Row, b: Row, as_defined: bool) -> list[tuple[int, Row, Row]]:
    """The terms sign · [bracket] rest of the meet of two joins of points."""
    k, h = len(a), len(b)
    split, whole, outer = a, b, 1
    if not as_defined and comb(h, rank - k) < comb(k, rank - h):
        split, whole = b, a
        outer = -1 if (rank - k) * (rank - h) % 2 else 1
    found = []
    for sign, first, rest in shuffles(len(split), rank - len(whole)):
        s, bracket = sorted_row((*(split[i] for i in first), *whole))
        if s:
            found.append((outer * sign * s, bracket, tuple(split[i] for i in rest)))
    return found
