r"""Scalars that are linear in a point, as the hyperplane on which the point lies if they vanish; sums with numbers.

>>> from gcrules.algebra.language.syntax import parse
>>> print(hyperplane(parse("[abcd]"), "b", 4))
acd
>>> print(hyperplane(parse(r"aa' /\ bb' /\ cc'", rank=3), "c'", 3))
-(c \/ (aa' /\ bb'))
>>> print(hyperplane(parse("[abcd][aefg]"), "a", 4))
None
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Meet, Number, Point, Product, Sum, points_of
from gcrules.algebra.scalars import bracket
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import content

__all__ = ["hyperplane", "is_extensor", "simplified", "weighted", "weights"]

_MAX_TERMS = 2_000  # of an expression that is expanded to take a point out of it


def hyperplane(e: Expr, name: str, rank: int) -> Expr | None:
    """The expression S of step rank − 1 with e = [S p] for all p, or None where no such S is found.

    A point that occurs once in each term is taken out of joins, meets and sums as they are written; otherwise the
    scalar is expanded, and each of its monomials must hold the point exactly once.
    """
    return _scalar(e, name, rank) or _expanded(e, name, rank)


def is_extensor(e: Expr, rank: int) -> bool:
    """Whether the expression is the join of points wherever it is not zero, as sums of lines in space need not be."""
    if e.step <= 1 or e.step >= rank - 1:
        return True
    match e:
        case Join(args=args) | Meet(args=args):
            return all(is_extensor(a, rank) for a in args)
        case Product(factors=factors):
            return all(is_extensor(f, rank) for f in factors)
    return False


def _scalar(e: Expr, name: str, rank: int) -> Expr | None:
    """The S of `hyperplane` where each term holds the point once as it is written; else None."""
    match e:
        case Bracket(args=args):
            return _out(ex.join(*args, rank=rank), name, None, rank)
        case Meet(args=args) if e.step == 0 and (i := _only(args, name)) is not None:
            rest = ex.meet(*args[:i], *args[i + 1 :], rank=rank)
            return _turned(_meet_sign(args, i, rank), _out(args[i], name, rest, rank))
        case Product(factors=factors) if (i := _only(factors, name)) is not None:
            return _times((*factors[:i], *factors[i + 1 :]), _scalar(factors[i], name, rank))
        case Sum(terms=terms):
            return _total([_scalar(t, name, rank) for t in terms], rank)
    return None


def _out(e: Expr, name: str, other: Expr | None, rank: int) -> Expr | None:
    """S with [e other] = [S p]; `other` is None where e has full step."""
    match e:
        case Point(name=found) if found == name:
            return None if other is None else _turned(-1 if (rank - 1) % 2 else 1, other)
        case Join(args=args) if (i := _only(args, name)) is not None:
            sign = -1 if args[i].step * sum(a.step for a in args[:i]) % 2 else 1
            rest = [*args[:i], *args[i + 1 :], *([other] if other is not None else [])]
            return _turned(sign, _out(args[i], name, ex.join(*rest, rank=rank), rank))
        case Meet(args=args) if other is not None and (i := _only(args, name)) is not None:
            rest = [*args[:i], *args[i + 1 :], other]
            return _turned(_meet_sign(args, i, rank), _out(args[i], name, ex.meet(*rest, rank=rank), rank))
        case Product(factors=factors) if (i := _only(factors, name)) is not None:
            rest = [*factors[:i], *factors[i + 1 :]]
            if factors[i].step:
                return _times(rest, _out(factors[i], name, other, rank))
            (extensor,) = (f for f in rest if f.step)
            closed = bracket(extensor, *([other] if other is not None else []), rank=rank)
            scalars = [f for f in rest if not f.step]
            return _times((*scalars, closed), _scalar(factors[i], name, rank))
        case Sum(terms=terms):
            return _total([_out(t, name, other, rank) for t in terms], rank)
    return None


def _only(parts: Sequence[Expr], name: str) -> int | None:
    """The place of the one part that holds the point."""
    places = [i for i, part in enumerate(parts) if name in points_of(part)]
    return places[0] if len(places) == 1 else None


def _meet_sign(args: Sequence[Expr], i: int, rank: int) -> int:
    """The sign of moving factor i of a meet to the front: B ∧ A = (−1)^((d−k)(d−h)) A ∧ B."""
    return -1 if (rank - args[i].step) * sum(rank - a.step for a in args[:i]) % 2 else 1


def _turned(sign: int, found: Expr | None) -> Expr | None:
    return None if found is None else ex.signed(sign, found)


def _times(scalars: Sequence[Expr], found: Expr | None) -> Expr | None:
    return None if found is None else ex.mul(*scalars, found)


def _total(found: Sequence[Expr | None], rank: int) -> Expr | None:
    terms = [t for t in found if t is not None]
    return ex.add(*terms, rank=rank) if len(terms) == len(found) else None


def _expanded(e: Expr, name: str, rank: int) -> Expr | None:
    """The S of `hyperplane` by expansion, where each monomial holds the point once; else None."""
    try:
        polynomial = expand(e, rank=rank, limit=_MAX_TERMS)
    except LimitReached:
        return None
    assert isinstance(polynomial, BracketPolynomial)
    terms = []
    for c, rows in polynomial.named():
        checkpoint()
        places = [(i, row.index(name)) for i, row in enumerate(rows) if name in row]
        if len(places) != 1:
            return None
        ((i, j),) = places
        brackets = [Bracket(tuple(map(Point, row))) for row in (*rows[:i], *rows[i + 1 :])]
        rest = ex.join(*(Point(n) for n in rows[i] if n != name), rank=rank)
        terms.append(ex.mul(Number(-c if (rank - 1 - j) % 2 else c), *brackets, rest))
    return ex.add(*terms, rank=rank) if terms else None


# --- sums with numbers ---------------------------------------------------------------------------------------------


def weights(e: Expr, factor: Fraction = Fraction(1)) -> dict[Expr, Fraction]:
    """The terms of a sum with their numbers, however it is written; terms that cancel are left out."""
    match e:
        case Product(factors=(Number(value=value), *rest)):
            return weights(ex.mul(*rest), factor * value)
        case Sum(terms=terms):
            found: dict[Expr, Fraction] = {}
            for t in terms:
                checkpoint()
                for part, c in weights(t, factor).items():
                    found[part] = found.get(part, Fraction(0)) + c
            return {part: c for part, c in found.items() if c}
    return {} if e == ZERO else {e: factor}


def weighted(row: Mapping[Expr, Fraction], rank: int) -> Expr:
    """The sum of terms, each with its number."""
    return ex.add(*(ex.mul(Number(c), e) for e, c in row.items()), rank=rank)


def simplified(e: Expr, rank: int) -> Expr:
    """A sum, or a multiple of it, with like terms collected and no common divisor of its numbers."""
    row = weights(e)
    divisor = content(row.values())
    unchanged = divisor == 1 and len(row) == len(e.children)
    return e if unchanged else weighted({t: c / divisor for t, c in row.items()}, rank)
