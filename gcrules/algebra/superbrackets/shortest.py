r"""The shortest superbracket over all orders of the six lines and both forms.

The superbracket of the same six lines has many bracket forms: the 24-term and the 16-term form, each written for any of
the 720 orders of the lines. Repeated points make brackets vanish and terms cancel; the fewest terms tell most.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import permutations
from typing import TYPE_CHECKING, Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms, sorted_row, tableau_order
from gcrules.algebra.superbrackets.superbracket import FORMS, form_terms
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import permutation_sign
from gcrules.core.shown import Shown

if TYPE_CHECKING:
    import numpy as np

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
    least = min(int(t.counts.min()) for t in tables.values())
    found: dict[Any, SuperbracketForm] = {}
    for form, table in tables.items():
        checkpoint()
        for i in table.representatives(least):
            candidate = superbracket_form(lines, _orders()[i], form, points=points, ideal=ideal, dead=dead)
            terms = candidate.polynomial.terms
            lead = next(iter(terms.values()), 1)
            found.setdefault(tuple((m, c * lead) for m, c in terms.items()), candidate)
    return tuple(found.values())


def counts(
    lines: Sequence[Line], *, points: Sequence[str] = (), ideal: Sequence[str] = ()
) -> dict[int, np.ndarray[Any, Any]]:
    """For both forms the numbers of terms left for the 720 orders of the lines (in lexicographic sequence)."""
    return {form: table.counts for form, table in _tables(lines, points, ideal).items()}


@cache
def _orders() -> tuple[tuple[int, ...], ...]:
    return tuple(permutations(range(6)))


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


@dataclass(frozen=True)
class _Table:
    """The terms left for each order: `rows` (which order), `keys` (which monomial), `sums` (coefficients)."""

    rows: np.ndarray[Any, Any]
    keys: np.ndarray[Any, Any]
    sums: np.ndarray[Any, Any]
    counts: np.ndarray[Any, Any]

    def representatives(self, terms: int) -> list[int]:
        """The first order of each different polynomial (up to sign) with this number of terms."""
        import numpy as np

        if terms == 0:
            return [int(np.flatnonzero(self.counts == 0)[0])] if (self.counts == 0).any() else []
        chosen = self.counts[self.rows] == terms
        keys, sums = self.keys[chosen].reshape(-1, terms), self.sums[chosen].reshape(-1, terms)
        if not len(keys):
            return []
        _, first = np.unique(np.hstack([keys, sums * sums[:, :1]]), axis=0, return_index=True)
        orders = self.rows[chosen].reshape(-1, terms)[:, 0]
        return sorted(int(orders[i]) for i in first)


_PLACES = (1 << 12, 1 << 8, 1 << 4, 1)  # of the four points of a bracket in its code


@lru_cache(maxsize=32)
def _table(line_ends: tuple[int, ...], form: int, ideal: int, zero: frozenset[Row] = frozenset()) -> _Table:
    """All 720 orders at once.

    A bracket becomes a code of four points with four bits each, a monomial the code of its three sorted brackets, so
    like terms are equal numbers within a row. A table takes up to 0.2 MB.
    """
    import numpy as np

    orders = np.array(_orders())
    ends = np.array(line_ends, dtype=np.int64).reshape(6, 2)[orders].reshape(len(orders), 12)
    terms = form_terms(form)
    letters = ends[:, np.array([m for _, m in terms])]  # (orders, terms, 3, 4)
    signs = np.broadcast_to(np.array([s for s, _ in terms]), letters.shape[:2]).copy()
    inversions = sum((letters[..., i] > letters[..., j]).astype(np.int64) for i in range(4) for j in range(i + 1, 4))
    letters = np.sort(letters, axis=-1)
    dead = (letters[..., 1:] == letters[..., :-1]).any(-1) | (letters[..., -1] < ideal)
    signs *= 1 - 2 * (np.asarray(inversions).sum(-1) % 2)
    codes = letters @ np.array(_PLACES)
    if zero:
        dead |= np.isin(codes, [sum(i * k for i, k in zip(row, _PLACES, strict=True)) for row in zero])
    signs[dead.any(-1)] = 0
    keys = np.sort(codes, axis=-1) @ np.array([1 << 32, 1 << 16, 1])
    at = np.argsort(keys, axis=-1, kind="stable")
    keys = np.take_along_axis(keys, at, -1)
    signs = np.take_along_axis(signs, at, -1)
    first = np.ones(keys.shape, dtype=bool)
    first[:, 1:] = keys[:, 1:] != keys[:, :-1]
    sums = np.add.reduceat(signs.ravel(), np.flatnonzero(first)).astype(np.int16)
    live = sums != 0
    rows = np.nonzero(first)[0][live].astype(np.int16)
    return _Table(rows, keys[first][live], sums[live], np.bincount(rows, minlength=len(orders)))
