r"""A claim as a multiple of one thing that is given: then it holds wherever that vanishes, without exceptions.

>>> from gcrules.algebra.expr import sub
>>> from gcrules.algebra.language.syntax import parse, parse_equation
>>> claim = parse_equation("[eab][ecd][fac][fbd] == [eac][ebd][fab][fcd]", rank=3)
>>> six = parse("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", rank=3)
>>> print(cofactor(sub(*claim, rank=3), six, 3))
1
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import islice

from gcrules.algebra.bracket import BracketPolynomial, Row, tableau_order
from gcrules.algebra.evaluate import Evaluator, random_rational_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.straightening.diagonal import standard_tableaux
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import kernel

__all__ = ["cofactor"]

_MOST = 200  # standard tableaux
_MORE = 4  # positions beyond as many as there are tableaux
_SIZE = 50  # of coordinates


def cofactor(e: Expr, given: Expr, rank: int, ideal: Iterable[str] = ()) -> Expr | None:
    """The polynomial in brackets that something given has to be multiplied by to make a scalar, None where none is
    found. What is found holds at some positions more than it takes; that it holds is left to be proved. Raises
    LimitReached where the expansions are too long.
    """
    if e.step or given.step or not set(points_of(given)) <= set(points_of(e)):
        return None
    at_infinity = tuple(ideal)
    names = tableau_order(points_of(e), (), at_infinity)
    count = sum(n in at_infinity for n in names)
    whole, part = (_content(x, names, at_infinity, rank) for x in (e, given))
    if whole is None or part is None or part - whole:
        return None
    letters = tuple(sorted((whole - part).elements()))
    tableaux = [m for m in islice(standard_tableaux(letters, rank), _MOST + 1) if not any(row[-1] < count for row in m)]
    if not tableaux or len(tableaux) > _MOST:
        return None
    bases = [BracketPolynomial(rank, names, {m: 1}, count).to_expr() for m in tableaux]
    rows = list(islice(_values([e, given, *bases], names, at_infinity, rank), len(bases) + _MORE))
    found = kernel([[-value, *(factor * b for b in others)] for value, factor, *others in rows], len(bases) + 1)
    if len(found) != 1 or not found[0][0]:
        return None
    first = Fraction(found[0][0])
    terms = {m: c / first for m, c in zip(tableaux, found[0][1:], strict=True) if c}
    return BracketPolynomial(rank, names, terms, count).to_expr()


def _content(e: Expr, names: tuple[str, ...], ideal: tuple[str, ...], rank: int) -> Counter[int] | None:
    """How often each point occurs in a term; None where terms differ in this, or there are none."""
    poly = expand(e, points=names, ideal=ideal, rank=rank)
    assert isinstance(poly, BracketPolynomial)
    place = {n: i for i, n in enumerate(names)}
    found = {tuple(sorted(place[poly.points[i]] for row in m for i in row)) for m in poly.terms}
    return Counter(found.pop()) if len(found) == 1 else None


def _values(es: list[Expr], names: tuple[str, ...], ideal: tuple[str, ...], rank: int) -> Iterator[Row]:
    """Of scalars, at one position after the other."""
    seed = 0
    while True:
        checkpoint()
        at = Evaluator(random_rational_points(names, rank=rank, ideal=ideal, seed=seed, size=_SIZE), rank)
        yield tuple(at.value(e)[0] for e in es)
        seed += 1
