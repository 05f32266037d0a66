r"""A claim as a sum of numbers times what is given: then it holds wherever that vanishes, without exceptions.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> at = parse_assumption("[abcd] == [abce], [abcf] == [abce]")
>>> from gcrules.algebra.language.syntax import parse
>>> print(given_part(parse("[abcd] - [abcf]"), at))
[abcd] - [abce] - ([abcf] - [abce])
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from random import Random

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.evaluate import Evaluator, random_rational_points
from gcrules.algebra.expr import Expr, Number, points_of
from gcrules.algebra.space import Space
from gcrules.core.linear_algebra import kernel

__all__ = ["given_part"]

_MORE = 4  # positions beyond as many as there are numbers
_SIZE = 50  # of coordinates


def given_part(e: Expr, at: Space) -> Expr | None:
    """Numbers times what is given that a scalar equals at some positions more than it takes to find them; that it does
    everywhere is left to be proved. None where there are no such numbers.
    """
    given = [g for a in at.given for g in equations(a, at.rank) if not g.step]
    if e.step or not given:
        return None
    rows = list(islice(_values([e, *given], at), len(given) + _MORE))
    found = next((v for v in kernel(rows, len(given) + 1) if v[0]), None)
    if found is None:
        return None
    shares = [-Fraction(k) / Fraction(found[0]) for k in found[1:]]
    return ex.add(*(ex.mul(Number(k), g) for k, g in zip(shares, given, strict=True) if k), rank=at.rank)


def _values(es: list[Expr], at: Space) -> Iterator[tuple[Fraction, ...]]:
    """Of scalars, at one position after the other, of points of any weight."""
    names, seed = points_of(*es), 0
    while True:
        places = random_rational_points(names, rank=at.rank, ideal=at.ideal, seed=seed, size=_SIZE)
        weight = Random(seed)
        points = Evaluator({n: _times(weight.randint(1, _SIZE), p) for n, p in places.items()}, at.rank)
        yield tuple(Fraction(points.value(e)[0]) for e in es)
        seed += 1


def _times(weight: int, place: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(weight * c for c in place)
