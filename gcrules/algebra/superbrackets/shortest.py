r"""The shortest superbracket over all orders of the six lines and both forms.

The superbracket of the same six lines has many bracket forms: the 24-term and the 16-term form, each written for any of
the 720 orders of the lines. Repeated points make brackets vanish and terms cancel; the fewest terms tell most.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, lru_cache
from itertools import count, islice, permutations
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms, sorted_row, tableau_order
from gcrules.algebra.superbrackets.superbracket import FORMS, form_terms
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import permutation_sign
from gcrules.core.shown import Shown

__all__ = ["SuperbracketForm", "counts", "shortest_forms", "superbracket_form"]

Line = tuple[str, str]
Dead = Iterable[Sequence[str]]
"""Brackets, given by their points, that vanish wherever the lines may be; the terms that hold one are left out."""


@dataclass(frozen=True)
class SuperbracketForm(Shown):
    """The superbracket of `lines` taken in `order` (positions from 0), written in the 24-term or 16-term form.

    The polynomial equals `sign` (the sign of the order) times the superbracket of the lines as given. The number of
    terms `form` is 0 where the polynomial is the expansion of the lines as they are given, in no such form.
    """

    form: int
    order: tuple[int, ...]
    polynomial: BracketPolynomial

    @property
    def sign(self) -> int:
        return permutation_sign(self.order)

    def to_json(self) -> dict[str, Any]:
        """`{form, order, terms, polynomial}`; `order` holds positions of the lines as typed, from 0; `form` is null for
        an expansion.
        """
        return {
            "form": self.form or None,
            "order": list(self.order),
            "terms": len(self.polynomial),
            "polynomial": str(self.polynomial),
        }


def superbracket_form(
    lines: Sequence[Line],
    order: Sequence[int] = range(6),
    form: int = 24,
    *,
    points: Sequence[str] = (),
    ideal: Sequence[str] = (),
    dead: Dead = (),
) -> SuperbracketForm:
    """The form with repeated points removed and like terms collected, for lines given by two points each.

    With `dead` it equals the superbracket only where these brackets vanish.
    """
    names = tableau_order((p for line in lines for p in line), points, ideal)
    index = {n: i for i, n in enumerate(names)}
    at_infinity = sum(n in set(ideal) for n in names)
    ends = [index[p] for i in order for p in lines[i]]
    zero = _rows(dead, index)
    terms: Terms = {}
    for sign, brackets in form_terms(form):
        rows = []
        for b in brackets:
            s, row = sorted_row(ends[i] for i in b)
            sign *= s if row[-1] >= at_infinity and row not in zero else 0
            rows.append(row)
        if sign:
            key: Monomial = tuple(sorted(rows))
            terms[key] = terms.get(key, 0) + sign
    return SuperbracketForm(form, tuple(order), BracketPolynomial(4, names, terms, at_infinity))


def shortest_forms(
    lines: Sequence[Line],
    *,
    points: Sequence[str] = (),
    ideal: Sequence[str] = (),
    forms: Sequence[int] = (24, 16),
    dead: Dead = (),
) -> tuple[SuperbracketForm, ...]:
    """All different polynomials with the fewest terms, up to sign; the first is *the* shortest form.

    `forms` says which forms are looked at, `dead` which brackets vanish.

    Deterministic: the 24-term form comes before the 16-term form, then orders in lexicographic sequence.
    """
    tables = {form: t for form, t in _tables(lines, points, ideal, dead).items() if form in forms}
    least = min(min(t.counts) for t in tables.values())
    found: dict[Any, SuperbracketForm] = {}
    for form, table in tables.items():
        checkpoint()
        for order in table.shortest if min(table.counts) == least else ():
            candidate = superbracket_form(lines, order, form, points=points, ideal=ideal, dead=dead)
            terms = candidate.polynomial.terms
            lead = next(iter(terms.values()), 1)
            found.setdefault(tuple((m, c * lead) for m, c in terms.items()), candidate)
    return tuple(found.values())


def counts(
    lines: Sequence[Line], *, points: Sequence[str] = (), ideal: Sequence[str] = ()
) -> dict[int, Mapping[int, int]]:
    """For both forms: number of terms -> how many of the 720 orders of the lines leave so many."""
    return {form: table.counts for form, table in _tables(lines, points, ideal).items()}


def _rows(dead: Dead, index: Mapping[str, int]) -> frozenset[Row]:
    """Brackets as increasing rows of the points that the lines have."""
    return frozenset(tuple(sorted(index[n] for n in names)) for names in dead if all(n in index for n in names))


def _tables(lines: Sequence[Line], points: Sequence[str], ideal: Sequence[str], dead: Dead = ()) -> dict[int, _Table]:
    names = tableau_order((p for line in lines for p in line), points, ideal)
    index = {n: i for i, n in enumerate(names)}
    at_infinity = sum(n in set(ideal) for n in names)
    ends = tuple(index[p] for line in lines for p in line)
    zero = _rows(dead, index)
    return {form: _table(ends, form, at_infinity, zero) for form in FORMS}


SAME = {
    24: "012345 543210",
    16: "012345 021435 102354 120534 201453 210543 345012 354102 435021 453201 534120 543210",
}
"""The orders of the lines in which a form has the same terms, up to their common sign."""


@cache
def _orders(form: int) -> tuple[tuple[int, ...], ...]:
    """The first, in lexicographic sequence, of all orders in which the form has the same terms."""
    same = [tuple(map(int, s)) for s in SAME[form].split()]
    first: dict[tuple[int, ...], tuple[int, ...]] = {}
    for order in permutations(range(6)):
        if order not in first:
            first.update((tuple([order[i] for i in s]), order) for s in same)
    return tuple(dict.fromkeys(first.values()))


@cache
def _brackets(form: int) -> tuple[tuple[tuple[int, ...], ...], tuple[tuple[int, int, int, int], ...]]:
    """The different brackets of a form, and its terms: a sign and the positions of three brackets among them."""
    rows = tuple(dict.fromkeys(row for _, monomial in form_terms(form) for row in monomial))
    at = {row: i for i, row in enumerate(rows)}
    return rows, tuple((sign, at[x], at[y], at[z]) for sign, (x, y, z) in form_terms(form))


@cache
def _primes() -> tuple[int, ...]:
    """One for each bracket of six lines that a form can hold: two lines (15), or one and ends of two others (240)."""
    return tuple(islice((n for n in count(2) if all(n % k for k in range(2, int(n**0.5) + 1))), 255))


@dataclass(frozen=True)
class _Table:
    """`counts`: number of terms -> how many of the 720 orders leave so many; `shortest`: the first order of each
    different polynomial (up to sign) with the fewest, in lexicographic sequence.
    """

    counts: Mapping[int, int]
    shortest: tuple[tuple[int, ...], ...]


@lru_cache(maxsize=32)
def _table(line_ends: tuple[int, ...], form: int, ideal: int, zero: frozenset[Row] = frozenset()) -> _Table:
    """All 720 orders.

    A bracket becomes a prime number with the bracket's sign, or 0 where it vanishes: then a term is a product of three
    numbers that is 0 where the term vanishes, and like terms are equal numbers up to sign.
    """
    brackets, terms = _brackets(form)
    primes: dict[Row, int] = defaultdict(iter(_primes()).__next__)
    known: dict[tuple[int, ...], int] = {}
    numbers: dict[int, int] = {}
    shortest: dict[Any, tuple[int, ...]] = {}
    least = len(terms) + 1
    for order in _orders(form):
        ends = [end for i in order for end in line_ends[2 * i : 2 * i + 2]]
        values = []
        for i, j, k, m in brackets:
            letters = ends[i], ends[j], ends[k], ends[m]
            value = known.get(letters)
            if value is None:
                sign, row = sorted_row(letters)
                living = sign and row[-1] >= ideal and row not in zero
                value = known[letters] = sign * primes[row] if living else 0
            values.append(value)
        sums: dict[int, int] = {}
        for sign, i, j, k in terms:
            if term := values[i] * values[j] * values[k]:
                key, one = (term, sign) if term > 0 else (-term, -sign)
                sums[key] = sums.get(key, 0) + one
        left = [item for item in sums.items() if item[1]]
        number = len(left)
        numbers[number] = numbers.get(number, 0) + 720 // len(_orders(form))
        if number < least:
            least, shortest = number, {}
        if number == least:
            left.sort()
            lead = left[0][1] if left else 1
            shortest.setdefault(tuple([(key, c * lead) for key, c in left]), order)
    return _Table(FrozenMap(sorted(numbers.items())), tuple(shortest.values()))
