r"""Rational factorization: one expression that equals a polynomial times a cofactor.

First the brackets of the points are cofactors, one of each orbit under symmetries of the polynomial. For each the whole
family is searched, with any of the brackets that divide the polynomial inside the expressions.

Then meets of constructed lines (rank 4). Let A be a point and Aa, Ab, g, h lines such that the polynomial vanishes if
the ends of one coincide. The line t through A that crosses g and h, and the line s in the plane Aab that crosses them,

    t = (A ∨ g) ∧ (A ∨ h),   s = (g ∧ Aab) ∨ (h ∧ Aab),

are taken as letters, t ∧ ab as the cofactor. Only expressions that hold s and t are searched, so nothing is excluded by
a search in vain. (For a superbracket with the legs Aa, Ab, g and h: without the other two legs the platform can turn
about t and about s.)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property, reduce
from itertools import combinations, permutations, product
from math import prod
from operator import mul

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.brackets import vanishing_pairs
from gcrules.algebra.factoring.coincidences import Coincidences
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.factoring.products import Cover, Groups, sub_multisets
from gcrules.algebra.factoring.symmetry import Swap, Symmetries, moved_row
from gcrules.algebra.factoring.tree_letters import Given, Tree, extensor, joined
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Rational", "bracket_cofactors", "line_cofactors"]


_MOST_INSIDE = 2_000


@dataclass(frozen=True)
class Rational:
    """cofactor · input is a multiple of the brackets `outside` times each of the expressions, simplest first; these are
    multiples of `polynomial`.
    """

    cofactor: Expr
    polynomial: BracketPolynomial
    expressions: tuple[Expr, ...]
    outside: tuple[Row, ...] = ()


def bracket_cofactors(
    rows: tuple[Row, ...], parts: Sequence[BracketPolynomial], effort: Effort, symmetries: Symmetries
) -> Iterator[tuple[list[Row], Rational | LimitReached | None]]:
    """For every orbit of brackets the expressions found with its first as the cofactor, None if there are none, or the
    limit that was reached.

    The input is the product of the brackets `rows` and of `parts`, in normal form, which are in no grouping
    expressions; the symmetries are the input's. Any of the brackets may stand inside an expression.
    """
    rest = reduce(mul, parts)
    used = sorted({i for m in symmetries.poly.terms for row in m for i in row})
    brackets = [r for r in combinations(used, rest.rank) if r[-1] >= rest.ideal]
    counted = Counter(rows)
    if prod(n + 1 for n in counted.values()) > _MOST_INSIDE:
        raise LimitReached(f"there are more than {_MOST_INSIDE:,} ways to leave brackets inside an expression")
    insides = list(sub_multisets(counted))
    exclusions = [Coincidences(rest * rest.with_terms({i: 1}), effort) for i in insides] if len(parts) == 1 else []
    different = Counter(parts)
    plain = Groups(counted, tuple(different), tuple(different.values()), effort.renewed())
    if len(parts) == 1:
        plain.known.update({((0,), inside): [] for inside in insides})
    else:
        plain.cover()
    for orbit in symmetries.orbits(brackets, moved_row):
        checkpoint()
        if exclusions and all(
            # symmetries keep all brackets together and none of them; others inside they may exchange
            c.exclude(orbit if inside in ((), rows) else orbit[:1])
            for c, inside in zip(exclusions, insides, strict=True)
        ):
            yield orbit, None
            continue
        try:
            more = counted + Counter([orbit[0]])
            found = Groups(more, plain.parts, plain.times, effort.renewed(), known=plain.known).cover()
        except LimitReached as reached:
            yield orbit, reached
            continue
        yield orbit, None if found is None else _rational(orbit[0], counted, rest, found)


def _rational(row: Row, rows: Counter[Row], rest: BracketPolynomial, cover: Cover) -> Rational:
    bracket = ex.Bracket(tuple(ex.Point(rest.points[i]) for i in row))
    inside = tuple(sorted((rows + Counter([row]) - cover.outside).elements()))
    groups = [group.expressions for group in cover.groups for _ in range(group.times)]
    expressions = (ex.mul(*(w.expression for w in choice)) for choice in product(*groups))
    outside = tuple(sorted(cover.outside.elements()))
    return Rational(bracket, rest * rest.with_terms({inside: 1}), tuple(expressions), outside)


_Pair = frozenset[int]


@dataclass(frozen=True)
class _Lines:
    """What t and s are made of: the point A, the ends a and b, the lines g and h; points by their places."""

    centre: int
    ends: _Pair
    crossed: frozenset[_Pair]

    def moved(self, swap: Swap) -> _Lines:
        return _Lines(
            swap.get(self.centre, self.centre),
            _moved(self.ends, swap),
            frozenset(_moved(line, swap) for line in self.crossed),
        )

    @cached_property
    def letters(self) -> Counter[int]:
        """Those of t ∧ ab."""
        return Counter([self.centre, self.centre, *self.ends, *(i for line in self.crossed for i in line)])

    def trees(self, names: Sequence[str]) -> tuple[Tree, Tree]:
        """t and s."""
        A, (a, b) = names[self.centre], _named(self.ends, names)
        g, h = (_named(line, names) for line in sorted(self.crossed, key=sorted))
        pencil = joined(A, a, b)
        t: Tree = ("meet", joined(A, *g), joined(A, *h))
        s: Tree = ("join", ("meet", pencil, joined(*g)), ("meet", pencil, joined(*h)))
        return t, s

    def cofactor(self, names: Sequence[str]) -> Expr:
        """t ∧ ab."""
        t, _ = self.trees(names)
        return ex.meet(extensor(t, 4), extensor(joined(*_named(self.ends, names)), 4))


@dataclass(frozen=True)
class _Choice:
    """A cofactor: t ∧ ab, times a bracket, or times that of another line through A."""

    one: _Lines
    bracket: Row = ()
    other: _Lines | None = None

    def fits(self, degrees: Counter[int]) -> bool:
        """Whether cofactor times polynomial has the letters of s and t: t ∧ ab has half of them."""
        beyond = Counter(self.bracket) + (self.other.letters if self.other else Counter())
        return self.one.letters <= degrees + beyond

    def moved(self, swap: Swap) -> _Choice:
        other = None if self.other is None else self.other.moved(swap)
        return _Choice(self.one.moved(swap), moved_row(self.bracket, swap), other)

    def cofactor(self, names: Sequence[str]) -> Expr:
        factors = [self.one.cofactor(names)]
        if self.bracket:
            factors.insert(0, ex.Bracket(tuple(ex.Point(names[i]) for i in self.bracket)))
        if self.other is not None:
            factors.append(self.other.cofactor(names))
        return ex.mul(*factors)


def line_cofactors(poly: BracketPolynomial, effort: Effort, symmetries: Symmetries) -> Iterator[Rational]:
    """Expressions that hold s and t and equal a cofactor times the polynomial, for the cofactors t ∧ ab; if there are
    none, [A a k] (t ∧ ab) for the lines k; if there are none either, (t ∧ ab)(t' ∧ ab) for two lines t through A.

    Of cofactors that symmetries of the polynomial take into each other the first is tried. Rank 4 without ideal points
    only. Raises LimitReached.
    """
    if poly.rank != 4 or poly.ideal:
        return
    lines = [tuple(sorted(pair)) for pair in sorted(vanishing_pairs(poly))]
    every = list(_constructed(lines, len(poly.points)))
    degrees = Counter(i for row in next(iter(poly.terms), ()) for i in row)
    for kind in (_alone, _with_a_bracket, _in_pairs):
        found = False
        choices = dict.fromkeys(c for c in kind(every, lines) if c.fits(degrees))
        for choice, *_ in symmetries.orbits(list(choices), _Choice.moved):
            rational = _with(poly, choice, effort)
            if rational is not None:
                found = True
                yield rational
        if found:
            return


def _constructed(lines: Sequence[Row], points: int) -> Iterator[_Lines]:
    for A in range(points):
        through = [sum(line) - A for line in lines if A in line]
        others = [frozenset(line) for line in lines if A not in line]
        for ends, crossed in product(combinations(through, 2), combinations(others, 2)):
            yield _Lines(A, frozenset(ends), frozenset(crossed))


def _alone(every: list[_Lines], lines: Sequence[Row]) -> Iterator[_Choice]:
    yield from map(_Choice, every)


def _with_a_bracket(every: list[_Lines], lines: Sequence[Row]) -> Iterator[_Choice]:
    for one in every:
        for end, line in product(sorted(one.ends), lines):
            row = {one.centre, end, *line}
            if len(row) == 4 and one.centre not in line:
                yield _Choice(one, tuple(sorted(row)))


def _in_pairs(every: list[_Lines], lines: Sequence[Row]) -> Iterator[_Choice]:
    for one, other in permutations(every, 2):
        if (one.centre, one.ends) == (other.centre, other.ends):
            yield _Choice(one, other=other)


def _with(poly: BracketPolynomial, choice: _Choice, effort: Effort) -> Rational | None:
    """What multiplies the polynomial to one expression, if the chosen lines do."""
    cofactor = choice.cofactor(poly.points)
    t, s = choice.one.trees(poly.points)
    expanded = expand(cofactor, points=poly.points)
    assert isinstance(expanded, BracketPolynomial)
    multiple = poly * expanded.over(poly.points)
    if not multiple:
        return None
    written, _ = search(multiple, effort.renewed(), [Given(s, 2), Given(t, 2)])
    return Rational(cofactor, multiple, tuple(w.expression for w in written)) if written else None


def _moved(pair: _Pair, swap: Swap) -> _Pair:
    return frozenset(swap.get(i, i) for i in pair)


def _named(pair: _Pair, names: Sequence[str]) -> list[str]:
    return [names[i] for i in sorted(pair)]
