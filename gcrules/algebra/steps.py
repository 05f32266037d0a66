r"""The single steps that a computation with brackets is made of, each as a function of an expression and its space.

Every function gives an expression equal to the one it is given, or None where there is nothing for it to do.

>>> from gcrules.algebra.language.syntax import parse
>>> e = parse(r"ab /\ cde /\ agh")
>>> for step in (expanded_meets, multiplied_out, expanded_meets, without_zeros, in_order):
...     e = step(e, Space())
...     print(e)
([acde] * b - [bcde] * a) /\ agh
[acde](b /\ agh) - [bcde](a /\ agh)
[acde][bagh] - [bcde][aagh]
[acde][bagh]
-[abgh][acde]
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import combinations, product
from math import comb, prod

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, tableau_order
from gcrules.algebra.expand import expand, shuffles
from gcrules.algebra.expr import (
    ZERO,
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
)
from gcrules.algebra.parts import everywhere, first_part, rebuilt
from gcrules.algebra.scalars import bracket, power, superbracket, written_out
from gcrules.algebra.space import Space
from gcrules.algebra.straightening.straighten import next_syzygy
from gcrules.algebra.superbrackets.superbracket import form_terms
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import permutation_sign

__all__ = [
    "common_factors",
    "expanded_meets",
    "in_order",
    "lines_in_order",
    "multiplied_out",
    "superbracket_terms",
    "syzygy",
    "without_dots",
    "without_zeros",
]

MAX_TERMS = 2_000
"""Steps are for reading: none leads to more terms than this."""


# --- superbrackets -------------------------------------------------------------------------------------------------


def superbracket_terms(e: Expr, space: Space, form: int = 24) -> Expr | None:
    """The first superbracket of six joins of two points as the sum of all 24 (or 16) terms, zero or not."""

    def at(part: Expr) -> Expr | None:
        ends = _ends(part)
        if ends is None or len(ends) != 6:
            return None
        points = [Point(n) for line in ends for n in line]
        return ex.add(
            *(
                ex.mul(Number(sign), *(Bracket(tuple(points[i] for i in row)) for row in rows))
                for sign, rows in form_terms(form)
            )
        )

    return first_part(e, at, space.rank)


def lines_in_order(e: Expr, space: Space) -> Expr | None:
    """Superbrackets with the points of each line, then the lines in tableau order, with the sign of the exchanges."""
    place = _places(e, space)

    def at(part: Expr) -> Expr | None:
        ends = _ends(part)
        if ends is None:
            return None
        lines = [tuple(sorted(line, key=place.__getitem__)) for line in ends]
        turned = sum(a != b for a, b in zip(lines, ends, strict=True))
        order = sorted(range(len(lines)), key=lambda i: [place[n] for n in lines[i]])
        sorted_lines = (ex.join(*map(Point, lines[i])) for i in order)
        return ex.mul(Number((-1) ** turned * permutation_sign(order)), superbracket(*sorted_lines, rank=space.rank))

    return _changed(e, everywhere(e, at, space.rank))


def _ends(e: Expr) -> tuple[tuple[str, str], ...] | None:
    """The end points of the lines of a superbracket, if each line is the join of two points."""
    if not isinstance(e, Superbracket):
        return None
    found = []
    for line in e.lines:
        match line:
            case Join(args=(Point(name=a), Point(name=b))):
                found.append((a, b))
            case _:
                return None
    return tuple(found)


# --- brackets ------------------------------------------------------------------------------------------------------


def without_zeros(e: Expr, space: Space) -> Expr | None:
    """Brackets and joins with a repeated point, and brackets of points at infinity only, are 0."""

    def at(part: Expr) -> Expr | None:
        if not isinstance(part, Bracket | Join):
            return None
        names = [a.name for a in part.args if isinstance(a, Point)]
        infinite = isinstance(part, Bracket) and len(names) == len(part.args) and set(names) <= set(space.ideal)
        return ZERO if infinite or len(set(names)) < len(names) else None

    return _changed(e, everywhere(e, at, space.rank))


def in_order(e: Expr, space: Space) -> Expr | None:
    """Sums of products of brackets (times a join of points) in tableau order, like terms collected.

    Only for expressions made of brackets of points alone. Sums inside products stay there; numbers in front of them
    go into the first of them.
    """
    return _changed(e, _sorted(e, space)) if _plain(e) else None


def common_factors(e: Expr, space: Space) -> Expr | None:
    """Brackets that all terms of a sum share, in front of it."""
    if not isinstance(e, Sum) or not all(map(_is_monomial, e.terms)):
        return None
    brackets: list[Counter[Expr]] = [Counter(f for f in _factors(t) if isinstance(f, Bracket)) for t in e.terms]
    common = brackets[0]
    for other in brackets[1:]:
        common &= other
    if not common:
        return None
    rest = []
    for term in e.terms:
        left, kept = Counter(common), []
        for f in _factors(term):
            if left[f]:
                left[f] -= 1
            else:
                kept.append(f)
        rest.append(ex.mul(*kept))
    in_front = sorted(common.elements(), key=lambda b: _factors(e.terms[0]).index(b))
    return ex.mul(*in_front, ex.add(*rest, rank=space.rank))


def syzygy(e: Expr, space: Space) -> Expr | None:
    """A sum of products of brackets in tableau order after one van der Waerden syzygy, on its largest monomial that is
    no standard tableau.
    """
    if e.step or not (_plain(e) and all(map(_is_monomial, _summands(e)))):
        return None
    polynomial = expand(e, points=space.points, ideal=space.ideal, rank=space.rank)
    assert isinstance(polynomial, BracketPolynomial)
    if polynomial.to_expr() != e:
        return None
    step = next_syzygy(polynomial)
    return None if step is None else step[1].to_expr()


# --- joins and meets -----------------------------------------------------------------------------------------------


def expanded_meets(e: Expr, space: Space) -> Expr | None:
    """The innermost meets of joins of points: the two of them whose meet has the fewest terms, by the definition of the
    meet as a signed sum over shuffles, in front of the others (meets commute up to sign).
    """
    return _changed(e, _one_layer(e, space.rank))


def without_dots(e: Expr, space: Space) -> Expr | None:
    """Dotted brackets as the sums that they stand for."""
    return _changed(e, everywhere(e, lambda p: written_out(p) if isinstance(p, Dotted) else None, space.rank))


def multiplied_out(e: Expr, space: Space) -> Expr | None:
    """Products, powers, joins, meets and brackets of sums as sums, numbers and scalars in front.

    Raises LimitReached beyond `MAX_TERMS` terms.
    """
    return _changed(e, ex.add(*_products(e, space.rank), rank=space.rank))


def _one_layer(e: Expr, rank: int) -> Expr:
    """The innermost meets replaced by their shuffles, the cheapest pair of arguments first."""
    checkpoint()
    if isinstance(e, Meet) and (pair := _cheapest_pair(e, rank)):
        i, j = pair
        rest = tuple(a for n, a in enumerate(e.args) if n not in pair)
        odd = [n for n in (i, j, *(n for n in range(len(e.args)) if n not in pair)) if (rank - e.args[n].step) % 2]
        found = ex.signed(permutation_sign(odd), _shuffled(_points(e.args[i]), _points(e.args[j]), rank))
        if found.step or not rest:
            return ex.meet(found, *rest, rank=rank)
        return ex.mul(found, *(bracket(x, rank=rank) for x in rest))
    children = tuple(_one_layer(c, rank) for c in e.children)
    return rebuilt(e, children, rank) if children != e.children else e


def _cheapest_pair(e: Meet, rank: int) -> tuple[int, int] | None:
    """The places of two joins of points whose meet has the fewest terms, the first such pair."""
    simple = [(i, a.step) for i, a in enumerate(e.args) if _points(a)]
    pairs = {(i, j): min(_sizes(k, h, rank)) for (i, k), (j, h) in combinations(simple, 2)}
    return min(pairs, key=pairs.__getitem__, default=None)


def _sizes(k: int, h: int, rank: int) -> tuple[int, int]:
    """Terms of the meet of steps k and h when the first, or the second, is split."""
    return comb(k, rank - h), comb(h, rank - k)


def _shuffled(a: Sequence[Expr], b: Sequence[Expr], rank: int) -> Expr:
    """The meet of two joins of points, split on the side that has fewer terms."""
    k, h = len(a), len(b)
    split, whole, outer = a, b, 1
    first_split, second_split = _sizes(k, h, rank)
    if second_split < first_split:
        split, whole, outer = b, a, (-1) ** ((rank - k) * (rank - h))
    terms = []
    for sign, first, rest in shuffles(len(split), rank - len(whole)):
        bracket = Bracket((*(split[i] for i in first), *whole))
        terms.append(ex.mul(Number(outer * sign), bracket, ex.join(*(split[i] for i in rest), rank=rank)))
    return ex.add(*terms, rank=rank)


def _points(e: Expr) -> tuple[Expr, ...]:
    """The points of a join of points; none for anything else."""
    points = e.args if isinstance(e, Join) else (e,)
    return points if all(isinstance(p, Point) for p in points) else ()


def _products(e: Expr, rank: int) -> list[Expr]:
    """The terms of an expression when everything is multiplied out."""
    checkpoint()
    match e:
        case Sum(terms=terms):
            return [p for t in terms for p in _products(t, rank)]
        case Product(factors=factors):
            return [ex.mul(*choice) for choice in _choices(factors, rank)]
        case Power(base=base, exponent=n):
            return [ex.mul(*choice) for choice in _choices((base,) * n, rank)]
        case Join() | Meet() | Bracket() | Superbracket():
            found = []
            for choice in _choices(e.children, rank):
                scalars = [f for part in choice for f in _factors(part) if f.step == 0]
                extensors = tuple(f for part in choice for f in _factors(part) if f.step)
                whole = len(extensors) == len(e.children)
                found.append(ex.mul(*scalars, rebuilt(e, extensors, rank)) if whole else ZERO)
            return found
    return [e]


def _choices(parts: Sequence[Expr], rank: int) -> Iterator[tuple[Expr, ...]]:
    terms = [_products(part, rank) for part in parts]
    if prod(map(len, terms)) > MAX_TERMS:
        raise LimitReached(f"multiplied out, an expression has more than {MAX_TERMS:,} terms")
    return product(*terms)


# --- the order of points -------------------------------------------------------------------------------------------


def _sorted(e: Expr, space: Space) -> Expr:
    """Monomials and sums of them in tableau order, like terms collected, other factors as they are."""
    if all(map(_is_monomial, _summands(e))):
        return _collected(e, space)
    match e:
        case Sum(terms=terms):
            return ex.add(*(_sorted(t, space) for t in terms), rank=space.rank)
        case Power(base=base, exponent=n):
            return power(_sorted(base, space), n, space.rank)
    others = [_sorted(f, space) for f in _factors(e) if not _is_monomial(f)]
    monomial = _collected(ex.mul(*(f for f in _factors(e) if _is_monomial(f))), space)
    for i, other in enumerate(others):
        if isinstance(other, Sum):
            numbers = [f for f in _factors(monomial) if isinstance(f, Number)]
            others[i] = ex.add(*(ex.mul(*numbers, t) for t in other.terms), rank=space.rank)
            monomial = ex.mul(*(f for f in _factors(monomial) if f not in numbers))
            break
    found = ex.mul(monomial, *others)
    return _collected(found, space) if _is_monomial(found) else found


def _collected(e: Expr, space: Space) -> Expr:
    """An expression of step 0 or more as its expansion."""
    found = expand(e, points=space.points, ideal=space.ideal, rank=space.rank)
    if isinstance(found, BracketPolynomial):
        return found.to_expr()
    terms = []
    for row, coefficient in found.parts.items():
        extensor = ex.join(*(Point(found.points[i]) for i in row), rank=space.rank)
        terms += [ex.mul(t, extensor) for t in _summands(coefficient.to_expr())]
    return ex.add(*terms, rank=space.rank)


def _places(e: Expr, space: Space) -> dict[str, int]:
    """The place of each point in the tableau order."""
    return {n: i for i, n in enumerate(tableau_order(ex.points_of(e), space.points, space.ideal))}


# --- what an expression is made of ---------------------------------------------------------------------------------


def _plain(e: Expr) -> bool:
    """Whether an expression is made of numbers, brackets of points and joins of points alone."""
    match e:
        case Number() | Point():
            return True
        case Bracket(args=args) | Join(args=args):
            return all(isinstance(a, Point) for a in args)
        case Sum(terms=parts) | Product(factors=parts):
            return all(map(_plain, parts))
        case Power(base=base):
            return _plain(base)
    return False


def _is_monomial(e: Expr) -> bool:
    return not isinstance(e, Sum | Power) and not any(isinstance(f, Sum | Power) for f in _factors(e))


def _summands(e: Expr) -> tuple[Expr, ...]:
    return e.terms if isinstance(e, Sum) else (e,)


def _factors(e: Expr) -> tuple[Expr, ...]:
    return e.factors if isinstance(e, Product) else (e,)


def _changed(e: Expr, after: Expr) -> Expr | None:
    return None if after == e else after
