r"""Claims that hold only if finite points are written with last coordinate 1.

A claim is about all homogeneous coordinates of its points, so each of them counts in every weight. An equation between
terms in which a point occurs unequally often, such as [aij] == [bij] for i, j at infinity in the plane, is then false.
It may hold, as this one does, where the last coordinate of every finite point is 1.

>>> from gcrules.algebra.language.syntax import parse
>>> plane = Construction(3, ("i", "j", "a", "b"), ("i", "j"))
>>> unit_weights(parse("[aij] - [bij]", rank=3), plane), unit_weights(parse("[abi] - [abj]", rank=3), plane)
(True, False)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.expr import Bracket, Expr, Number, Point
from gcrules.algebra.scalars import bracket, power
from gcrules.core.seeds import seed

__all__ = ["unit_weights"]

_Degrees = tuple[tuple[str, int], ...]


def unit_weights(e: Expr, construction: Construction, *, limit: int = MAX_TERMS) -> bool:
    """Whether an expression vanishes wherever the construction leads once each finite point is divided by its last
    coordinate; so it does at all such positions whose finite points have last coordinate 1.

    True is proved by normal forms. Raises LimitReached where they have more than `limit` terms.
    """
    if not _at_random_points(e, construction):
        return False
    rank = construction.rank
    new = [Point(f"new:{i}") for i in range(rank - e.step)] if e.step else []
    at_infinity = [Point(f"infinity:{i}") for i in range(rank - 1)]
    names = tuple(p.name for p in (*at_infinity, *new))
    wider = replace(
        construction,
        free=(*construction.free, *names),
        ideal=(*construction.ideal, *(p.name for p in at_infinity)),
    )
    scalar = bracket(e, *new, rank=rank) if e.step else e
    poly = expand(scalar, ideal=construction.ideal, rank=rank, limit=limit)
    assert isinstance(poly, BracketPolynomial)
    return all(wider.is_zero(part, limit=limit) for part in _made_even(poly, at_infinity))


def _at_random_points(e: Expr, construction: Construction) -> bool:
    points = construction.random_points(seed("weights", str(e), construction))
    for n, value in points.items():
        if n not in construction.ideal and value[-1]:
            inverse = pow(value[-1], -1, PRIME)
            points[n] = tuple(c * inverse % PRIME for c in value)
    return not any(Evaluator(points, construction.rank, PRIME).value(e))


def _made_even(poly: BracketPolynomial, at_infinity: list[Point]) -> Iterator[Expr]:
    """Polynomials that vanish for all weights if this one does with weights 1: powers of the weights are added to its
    terms until each finite point occurs equally often.

    The weight of p is [I p] up to a factor, where I spans the points at infinity. Stretching space by a linear map, or
    a point at infinity by a number, multiplies a term by a power that its number of brackets, or how often the point
    occurs, determines. So terms that differ in these vanish by themselves.
    """
    ideal = set(poly.points[: poly.ideal])
    groups: dict[tuple[int, _Degrees], list[tuple[Expr, Counter[str]]]] = {}
    for c, rows in poly.named():
        often = Counter(n for row in rows for n in row)
        fixed = tuple(sorted((n, k) for n, k in often.items() if n in ideal))
        term = ex.mul(Number(c), *(Bracket(tuple(map(Point, row))) for row in rows))
        groups.setdefault((len(rows), fixed), []).append((term, often))
    for terms in groups.values():
        most: Counter[str] = Counter()
        for _, often in terms:
            most |= often
        yield ex.add(
            *(
                ex.mul(
                    term,
                    *(
                        power(Bracket((*at_infinity, Point(n))), k - often[n])
                        for n, k in sorted(most.items())
                        if k > often[n] and n not in ideal
                    ),
                )
                for term, often in terms
            ),
            rank=poly.rank,
        )
