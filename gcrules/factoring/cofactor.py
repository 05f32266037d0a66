r"""Rational factorization: one expression that equals a polynomial times a cofactor.

First the brackets of the points are cofactors, one of each orbit under symmetries of the polynomial. For each the whole
family is searched, so a bracket that is excluded works with no expression at all.

Then meets of constructed lines (rank 4). Let A be a point and Aa, Ab, g, h lines such that the polynomial vanishes if
the ends of one coincide. The line t through A that crosses g and h, and the line s in the plane Aab that crosses them,

    t = (A ∨ g) ∧ (A ∨ h),   s = (g ∧ Aab) ∨ (h ∧ Aab),

are taken as letters, t ∧ ab as the cofactor. Only expressions that hold s and t are searched, so nothing is excluded by
a search in vain. (For a superbracket with the legs Aa, Ab, g and h: without the other two legs the platform can turn
about t and about s.)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, permutations, product

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr
from gcrules.errors import LimitReached
from gcrules.factoring.brackets import vanishing_pairs
from gcrules.factoring.extensors import Tree, extensor, leaves
from gcrules.factoring.limits import Budget
from gcrules.factoring.matches import search
from gcrules.factoring.symmetry import orbits
from gcrules.factoring.trees import Written

__all__ = ["Rational", "bracket_cofactors", "line_cofactors"]


@dataclass(frozen=True)
class Rational:
    """cofactor · polynomial is a multiple of each of the expressions, simplest first."""

    cofactor: Expr
    polynomial: BracketPolynomial
    expressions: tuple[Written, ...]


def bracket_cofactors(
    poly: BracketPolynomial, budget: Budget, terms: int
) -> Iterator[tuple[list[Row], Rational | LimitReached | None]]:
    """For every orbit of brackets the expressions found with its first as the cofactor, None if there are none, or the
    limit that was reached. `poly` is in normal form.
    """
    used = sorted({i for m in poly.terms for row in m for i in row})
    rows = [r for r in combinations(used, poly.rank) if r[-1] >= poly.ideal]
    for orbit in orbits(poly, rows, limit=terms):
        multiple = poly * poly.with_terms({(orbit[0],): 1})
        try:
            written, _ = search(multiple, budget.renewed())
        except LimitReached as reached:
            yield orbit, reached
            continue
        bracket = ex.Bracket(tuple(ex.Point(poly.points[i]) for i in orbit[0]))
        yield orbit, Rational(bracket, multiple, tuple(written)) if written else None


@dataclass(frozen=True)
class _Transversals:
    """The lines t and s for a pencil (A; a, b) and lines g, h, and t ∧ ab."""

    centre: str
    ends: tuple[str, str]
    t: Tree
    s: Tree
    cofactor: Expr
    letters: Counter[str]  # what s and t use beyond the cofactor
    others: tuple[tuple[str, ...], ...]  # the lines that do not go through A


def _transversals(poly: BracketPolynomial) -> Iterator[_Transversals]:
    lines = sorted(vanishing_pairs(poly))
    for i, A in enumerate(poly.points):
        through = [poly.points[sum(line) - i] for line in lines if i in line]
        others = [tuple(poly.points[j] for j in line) for line in lines if i not in line]
        for (a, b), (g, h) in product(combinations(through, 2), combinations(others, 2)):
            pencil, ag, ah = _joined(A, a, b), _joined(A, *g), _joined(A, *h)
            t: Tree = ("meet", ag, ah)
            s: Tree = ("join", ("meet", pencil, _joined(*g)), ("meet", pencil, _joined(*h)))
            cofactor = ex.meet(extensor(ag, 4), extensor(ah, 4), extensor(_joined(a, b), 4))
            yield _Transversals(A, (a, b), t, s, cofactor, Counter([A, A, a, b, *g, *h]), tuple(others))


def line_cofactors(poly: BracketPolynomial, budget: Budget) -> Iterator[Rational]:
    """Expressions that hold s and t and equal a cofactor times the polynomial, for the cofactors t ∧ ab; if there are
    none, [A a k] (t ∧ ab) for the lines k; if there are none either, (t ∧ ab)(t' ∧ ab) for two lines t through A.

    Rank 4 without ideal points only. Raises LimitReached.
    """
    if poly.rank != 4 or poly.ideal:
        return
    degrees = Counter(poly.degrees() or {})
    every = list(_transversals(poly))
    for kind in (_alone, _with_a_bracket, _in_pairs):
        found = False
        for one, cofactor, letters in kind(every):
            if one.letters <= degrees + letters:
                for rational in _with(poly, one, cofactor, budget):
                    found = True
                    yield rational
        if found:
            return


_Choice = tuple[_Transversals, Expr, Counter[str]]  # … and the letters of what stands beside t ∧ ab


def _alone(every: list[_Transversals]) -> Iterator[_Choice]:
    yield from ((one, one.cofactor, Counter()) for one in every)


def _with_a_bracket(every: list[_Transversals]) -> Iterator[_Choice]:
    for one in every:
        for end, line in product(one.ends, one.others):
            names = sorted({one.centre, end, *line}, key=ex.point_key)
            if len(names) == 4:
                yield one, ex.mul(ex.Bracket(tuple(map(ex.Point, names))), one.cofactor), Counter(names)


def _in_pairs(every: list[_Transversals]) -> Iterator[_Choice]:
    for one, other in permutations(every, 2):
        if (one.centre, one.ends) == (other.centre, other.ends):
            yield one, ex.mul(one.cofactor, other.cofactor), Counter(_letters(other.cofactor))


def _with(poly: BracketPolynomial, one: _Transversals, cofactor: Expr, budget: Budget) -> Iterator[Rational]:
    expanded = expand(cofactor, points=poly.points)
    assert isinstance(expanded, BracketPolynomial)
    multiple = poly * expanded.over(poly.points)
    degrees = Counter(multiple.degrees() or {})
    spent = Counter(leaves(one.t)) + Counter(leaves(one.s))
    if multiple and spent <= degrees:
        written, _ = search(multiple, budget.renewed(), [(one.s, 2), (one.t, 2)])
        if written:
            yield Rational(cofactor, multiple, tuple(written))


def _letters(e: Expr) -> Iterator[str]:
    """The points of an expression, each as often as it is written."""
    return (part.name for part in ex.subexpressions(e) if isinstance(part, ex.Point))


def _joined(*points: str) -> Tree:
    tree: Tree = points[0]
    for p in points[1:]:
        tree = ("join", tree, p)
    return tree
