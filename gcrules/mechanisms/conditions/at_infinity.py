r"""The plane at infinity in an expression: planes that lie there become xyz, and what is left of each is a factor.

A plane P at infinity is a multiple of xyz, the directions of the frame: [xyzA]·P = [P A]·xyz for each finite point A,
and [xyzA] = 1. So a condition in which directions stand for planes falls apart: "the directions are parallel to one
plane" is one factor, what else must happen at infinity the other. Derived here.
"""

from __future__ import annotations

from collections.abc import Callable

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Product
from gcrules.algebra.scalars import bracket

__all__ = ["INFINITY", "separated"]

INFINITY = ex.join(*map(Point, "xyz"))
"""The plane at infinity as the join of the axes' directions."""


def separated(e: Expr, far: Callable[[Expr], bool], finite: str) -> tuple[Expr, ...]:
    """Scalar factors whose product is the expression where x, y, z are the axes and `finite` a finite point.

    `far` tells whether an extensor lies at infinity.
    """
    factors = e.factors if isinstance(e, Product) else (e,)
    found: list[Expr] = []
    for factor in factors:
        pulled: list[Expr] = []
        rest = _rebuilt(factor, far, finite, pulled)
        found += [*pulled, rest]
    return tuple(found)


def _rebuilt(e: Expr, far: Callable[[Expr], bool], finite: str, pulled: list[Expr]) -> Expr:
    if e.step == 3 and isinstance(e, Join | Meet) and e != INFINITY and far(e):
        args = e.args if isinstance(e, Join) else (e,)
        pulled.append(bracket(*(_rebuilt(a, far, finite, pulled) for a in args), Point(finite)))
        return INFINITY
    match e:
        case Meet(args=args):
            return ex.meet(*(_rebuilt(a, far, finite, pulled) for a in args))
        case Join(args=args):
            return ex.join(*(_rebuilt(a, far, finite, pulled) for a in args))
        case Bracket():
            return e
    return e
