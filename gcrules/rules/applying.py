r"""One application of an identity: to a bracket polynomial, whose terms it replaces, or to a part of an expression."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import lru_cache

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import holds
from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Monomial, Terms, sorted_row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Number, Point, Power, Product, Sum
from gcrules.algebra.language.rule_text import Instance, Order
from gcrules.algebra.names import point_key
from gcrules.algebra.parts import first_part, substitute
from gcrules.algebra.space import Assumption, Space
from gcrules.rules.matching import match_monomial, matches, trials

__all__ = ["applications", "left_terms", "only_brackets", "polynomial_of", "rewrite_expression"]


# --- bracket polynomials -------------------------------------------------------------------------------------------


def only_brackets(e: Expr) -> bool:
    """Whether an expression is a polynomial in brackets of points, as it stands."""
    match e:
        case Number():
            return True
        case Bracket(args=args):
            return all(isinstance(a, Point) for a in args)
        case Sum(terms=parts) | Product(factors=parts):
            return all(map(only_brackets, parts))
        case Power(base=base):
            return only_brackets(base)
    return False


def polynomial_of(e: Expr, space: Space) -> BracketPolynomial:
    """An expression of brackets alone, expanded."""
    found = expand(e, points=space.points, ideal=space.ideal, rank=space.rank)
    assert isinstance(found, BracketPolynomial)
    return found


_Patterns = tuple[tuple[Coefficient, tuple[tuple[str, ...], ...]], ...]


@lru_cache(maxsize=256)
def left_terms(instance: Instance) -> _Patterns:
    """The terms of the left side, those with the most different points first."""
    found = expand(instance.left, rank=instance.rank)
    assert isinstance(found, BracketPolynomial)
    terms = [(c, rows) for c, rows in found.named()]
    return tuple(sorted(terms, key=lambda t: -len({n for row in t[1] for n in row})))


@lru_cache(maxsize=256)
def _right(instance: Instance) -> _Patterns:
    found = expand(instance.right, rank=instance.rank)
    assert isinstance(found, BracketPolynomial)
    return tuple(found.named())


def applications(instance: Instance, polynomial: BracketPolynomial, space: Space) -> Iterator[BracketPolynomial]:
    """The polynomials that one application leads to, none of them equal to it. Raises LimitReached where matching takes
    too long.
    """
    left = left_terms(instance)
    if not left:
        return
    c, first = left[0]
    run_of = {n: run for run, names in instance.runs.items() for n in names}
    count = trials()
    for monomial, coefficient in polynomial.terms.items():
        for binding, sign, used in match_monomial(first, monomial, run_of, count):
            rest = tuple(row for i, row in enumerate(monomial) if i not in used)
            factor = Fraction(coefficient, c) * sign
            images = [(factor * k, *_image(rows, binding, rest)) for k, rows in left]
            if any(polynomial.terms.get(m, 0) != s * k for k, s, m in images if s):
                continue
            if len({m for _, s, m in images if s}) < sum(1 for _, s, _ in images if s):
                continue
            if not all(_holds(guard, binding, polynomial, space) for guard in instance.guards):
                continue
            terms: Terms = dict(polynomial.terms)
            for _, s, m in images:
                if s:
                    del terms[m]
            for k, rows in _right(instance):
                s, m = _image(rows, binding, rest)
                if s:
                    terms[m] = terms.get(m, 0) + factor * k * s
            after = polynomial.with_terms(_finite(terms, polynomial.ideal))
            if after != polynomial:
                yield after


def _image(rows: tuple[tuple[str, ...], ...], binding: Mapping[str, int], rest: Monomial) -> tuple[int, Monomial]:
    """Sign (0 where a point repeats in a bracket) and monomial of a pattern under a binding, times the rest."""
    sign, brackets = 1, list(rest)
    for row in rows:
        s, bracket = sorted_row(binding[n] for n in row)
        sign *= s
        brackets.append(bracket)
    return sign, tuple(sorted(brackets))


def _finite(terms: Terms, ideal: int) -> Terms:
    """Without the terms that have a bracket of points at infinity."""
    return {m: c for m, c in terms.items() if not any(row[-1] < ideal for row in m)}


def _holds(guard: Order | Assumption, binding: Mapping[str, int], polynomial: BracketPolynomial, space: Space) -> bool:
    if isinstance(guard, Order):
        a, b = binding[guard.left], binding[guard.right]
        return a < b if guard.sign == "<" else a != b
    return _assumed(guard, {n: Point(polynomial.points[i]) for n, i in binding.items()}, space)


def _assumed(guard: Assumption, values: Mapping[str, Expr], space: Space) -> bool:
    """Whether an assumption, with its points replaced, is proved in the space: where nothing is known, it is not."""
    args = tuple(substitute(a, dict(values), space.rank) for a in guard.args)
    return holds(Assumption(guard.kind, args, guard.text), space)


# --- expressions ---------------------------------------------------------------------------------------------------


def rewrite_expression(instance: Instance, e: Expr, space: Space) -> Expr | None:
    """The expression with the first part, from the outside in, that looks like the left side replaced; None where no
    part does. Raises LimitReached where matching takes too long.
    """
    count = trials()

    def at(part: Expr) -> Expr | None:
        for values, sign, rest in matches(instance.left, part, space.rank, count):
            if not all(_satisfied(g, values, space) for g in instance.guards):
                continue
            right = substitute(instance.right, dict(values), space.rank)
            after = ex.signed(sign, _with_rest(part, right, rest, space.rank))
            if after != part:
                return after
        return None

    return first_part(e, at, space.rank)


def _satisfied(guard: Order | Assumption, values: Mapping[str, Expr], space: Space) -> bool:
    if isinstance(guard, Assumption):
        return _assumed(guard, values, space)
    a, b = values[guard.left], values[guard.right]
    if guard.sign == "!=":
        return a != b
    if not (isinstance(a, Point) and isinstance(b, Point)):
        return False
    place = {n: i for i, n in enumerate((*space.ideal, *space.points))}
    return _key(a.name, place) < _key(b.name, place)


def _key(name: str, place: Mapping[str, int]) -> tuple[int, tuple[str, int, int]]:
    return place.get(name, len(place)), point_key(name)


def _with_rest(part: Expr, new: Expr, rest: tuple[Expr, ...], rank: int) -> Expr:
    """What stands for the matched parts of a join, meet or product, with the parts left over behind it."""
    if not rest:
        return new
    match part:
        case Join():
            return ex.join(new, *rest, rank=rank)
        case Meet():
            return ex.meet(new, *rest, rank=rank)
    return ex.mul(new, *rest)
