r"""Polynomials in brackets written in whole letters: the points of a line that stand in two brackets become a meet.

A polynomial that comes from an expression with a letter does not change if the points of the letter are chosen anew. So
a monomial may be replaced by its mean over all ways to share the points of the letter out among the rows in which
they stand, which is a meet: [L₁ X] Y ∨ L₂ − [L₂ X] Y ∨ L₁ = Y ∨ (L ∧ X).

>>> from gcrules.algebra.expand import expand
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import parse
>>> print(in_letters(expand(parse("abc /\\ L", context=parse_assumption("line L")))))
L /\ abc
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import factorial, prod

from gcrules.algebra import expr as ex
from gcrules.algebra import scalars
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Row, Terms, sorted_row, tableau_order
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Expr
from gcrules.algebra.for_two_points import written_back
from gcrules.algebra.letters import grouped, letter, letter_of, letters_of, split_letters
from gcrules.algebra.linear_in_lines import gathered, linear_in_lines
from gcrules.algebra.screw_letters import screws_of
from gcrules.core.budget import watched
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["in_letters", "whole_letters"]

Polynomial = BracketPolynomial | ExtensorPolynomial

_MOST = 500  # terms of polynomials that are written anew


def in_letters(p: Polynomial, *, short: bool = False) -> Expr:
    """The polynomial as an expression, in whole letters where it can be written so."""
    written = p.to_expr(short=short)
    if screws_of(p.points):
        found = whole_screws(p, written)
    elif not letters_of(p.points) or not _split(p):
        return written
    else:
        found = whole_letters(p) if len(p) <= _MOST else None
    return written if found is None else found


def whole_screws(p: Polynomial, written: Expr) -> Expr | None:
    """The polynomial, as an expression `written` in points, in whole screws and other letters; None where a term has a
    screw more than twice, and where it cannot be written so.
    """
    found = []
    for terms, lines in linear_in_lines(_terms(p), screws_of(p.points)):
        q = _collected(p, terms)
        if len(q) > _MOST:
            return None
        whole = whole_letters(q) if _split(q) else q.to_expr()
        part = None if whole is None else written_back(whole, lines, p.rank)
        if part is None:
            return None
        found.append(part)
    total = gathered(ex.add(*found, rank=p.rank))
    difference = ex.sub(written, total, rank=p.rank) if total != ex.ZERO else written
    return total if vanishes(difference, rank=p.rank, ideal=p.points[: p.ideal]) else None


def _collected(p: Polynomial, terms: Iterable[tuple[Fraction, Sequence[Sequence[str]]]]) -> Polynomial:
    """A polynomial of the kind of another one: Σ coefficient · extensor · brackets, the first row the extensor's."""
    found = list(terms)
    names = tableau_order((n for _, rows in found for row in rows for n in row), p.points, p.points[: p.ideal])
    index, ideal = {n: i for i, n in enumerate(names)}, sum(n in p.points[: p.ideal] for n in names)
    parts: dict[Row, Terms] = {}
    for c, rows in found:
        signed = [sorted_row(index[n] for n in row) for row in rows]
        extensor, *brackets = (row for _, row in signed)
        into, key = parts.setdefault(extensor, {}), tuple(sorted(brackets))
        into[key] = into.get(key, 0) + c * prod(sign for sign, _ in signed)
    whole = {row: BracketPolynomial(p.rank, names, some, ideal) for row, some in parts.items()}
    if isinstance(p, ExtensorPolynomial):
        return ExtensorPolynomial(p.rank, names, p.step, whole, ideal)
    return whole.get((), BracketPolynomial(p.rank, names, {}, ideal))


def whole_letters(p: Polynomial) -> Expr | None:
    """The polynomial in whole letters; None where a letter stands in a term more than once without all its points
    side by side, where letters close a circle of brackets, and where the polynomial depends on the choice of their
    points.
    """
    total: dict[_Term, Fraction] = {}
    for coefficient, rows in watched(_terms(p)):
        found = _term(rows)
        if found is None:
            return None
        share, term = found
        if share:
            total[term] = total.get(term, Fraction(0)) + coefficient * share
    steps = letters_of(p.points)
    written = ex.add(*(ex.mul(ex.Number(c), *t.factors(p.rank, steps)) for t, c in total.items() if c), rank=p.rank)
    difference = ex.sub(p.to_expr(), written, rank=p.rank) if written != ex.ZERO else p.to_expr()
    return written if vanishes(difference, rank=p.rank, ideal=p.points[: p.ideal]) else None


def _terms(p: Polynomial) -> Iterator[tuple[Fraction, tuple[tuple[str, ...], ...]]]:
    """Each term with its rows of names, the first of them that of its extensor."""
    parts = p.parts.items() if isinstance(p, ExtensorPolynomial) else [((), p)]
    for row, part in parts:
        for c, rows in part.named():
            yield Fraction(c), (tuple(p.points[i] for i in row), *rows)


def _split(p: Polynomial) -> bool:
    """Whether points of a letter stand alone."""
    return any(True for _, rows in _terms(p) for _ in split_letters(rows))


_Share = tuple[str, int]  # a letter, and how many of its points stand in a row


@dataclass(frozen=True, slots=True)
class _Row:
    """A bracket, or the extensor of a term: what it has of letters that are shared with another row, then the rest."""

    shares: tuple[_Share, ...]
    rest: tuple[str, ...]
    extensor: bool = False

    @property
    def key(self) -> tuple[bool, tuple[_Share, ...], tuple[str, ...]]:
        return not self.extensor, self.shares, self.rest


@dataclass(frozen=True, slots=True)
class _Term:
    """Rows in their order; each shared letter has the sign of the sharing from the earlier of its rows to the later."""

    rows: tuple[_Row, ...]

    def factors(self, rank: int, steps: Mapping[str, int]) -> Iterator[Expr]:
        """The scalars and the extensor whose product the term is, each tree of rows from its first row."""
        left = list(range(len(self.rows)))
        while left:
            root = left.pop(0)
            sign, args = self._inside(root, None, left, rank, steps)
            if sign < 0:
                yield ex.Number(sign)
            if self.rows[root].extensor:
                yield ex.join(*args, rank=rank) if args else ex.ONE
            else:
                yield scalars.bracket(*args, rank=rank)

    def _inside(
        self, at: int, parent: str | None, left: list[int], rank: int, steps: Mapping[str, int]
    ) -> tuple[int, list[Expr]]:
        """A sign, and what is joined in a row but for the letter that it shares with the row before it."""
        row, sign = self.rows[at], 1
        found: list[Expr] = []
        for name, here in row.shares:
            if name == parent:
                continue
            meets = [letter(name, steps[name])]
            for other in [i for i in left if any(n == name for n, _ in self.rows[i].shares)]:
                left.remove(other)
                inner, there = self._inside(other, name, left, rank, steps)
                shares = dict(self.rows[other].shares)
                earlier = list(shares)[: list(shares).index(name)]
                before = sum(shares[n] for n in earlier)
                sign *= inner * (-1) ** (shares[name] * (before + (other > at) * here))
                meets.append(ex.join(*there, rank=rank))
            found.append(ex.meet(*meets, rank=rank))
        return sign, [*found, *map(ex.Point, row.rest)]


def _term(rows: Sequence[tuple[str, ...]]) -> tuple[Fraction, _Term] | None:
    """The sign and the share of a monomial in the mean that takes its place, and that mean."""
    found: list[_Row] = []
    places: dict[str, list[tuple[int, list[int]]]] = {}
    sign = 1
    for i, names in enumerate(rows):
        alone = [n for n in grouped(names) if letter_of(n) is not None]
        alone.sort(key=_of)
        order = [names.index(n) for n in (*alone, *(n for n in names if n not in alone))]
        sign *= permutation_sign(order)
        counted: dict[str, list[int]] = {}
        for n in alone:
            name, number, _ = _of(n)
            counted.setdefault(name, []).append(number)
        for name, numbers in counted.items():
            places.setdefault(name, []).append((i, numbers))
        shares = tuple((name, len(numbers)) for name, numbers in counted.items())
        found.append(_Row(shares, tuple(n for n in names if n not in alone), extensor=i == 0))
    order = sorted(range(len(found)), key=lambda i: found[i].key)
    steps = letters_of(n for row in rows for n in row)
    share = Fraction(sign)
    for name, where in places.items():
        blocks = [numbers for _, numbers in sorted(where, key=lambda w: order.index(w[0]))]
        numbers = [n for block in blocks for n in block]
        if sorted(numbers) != list(range(1, steps[name] + 1)):
            return None
        ways = factorial(steps[name]) // prod(factorial(len(block)) for block in blocks)
        share *= Fraction(permutation_sign(numbers), ways)
        for (a, first), (b, _) in combinations(where, 2):
            if found[a].key == found[b].key and len(first) % 2:
                return Fraction(0), _Term(())
    edges = [tuple(i for i, _ in where) for where in places.values()]
    return None if _circle(len(rows), edges) else (share, _Term(tuple(found[i] for i in order)))


def _of(point: str) -> tuple[str, int, int]:
    of = letter_of(point)
    assert of is not None
    return of


def _circle(number: int, edges: Iterable[Sequence[int]]) -> bool:
    """Whether edges between so many nodes, of two or more nodes each, close a circle."""
    group = list(range(number))
    for ends in edges:
        if len({group[i] for i in ends}) < len(ends):
            return True
        group = [group[ends[0]] if g in [group[i] for i in ends] else g for g in group]
    return False
