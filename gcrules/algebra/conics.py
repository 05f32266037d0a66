r"""Conics through five points of the plane: six points on one, tangents, poles and polars, second intersections.

The conic through a, b, c, d, e is the form [abc][ade][xbd][xce] − [abd][ace][xbc][xde] in x.

>>> from gcrules.algebra.language.syntax import parse
>>> five = [parse(n, rank=3) for n in "abcde"]
>>> print(polar(parse("p", rank=3), *five))
[abc][ade][bdp] * ce + [abc][ade][cep] * bd - [abd][ace][bcp] * de - [abd][ace][dep] * bc
"""

from __future__ import annotations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.scalars import bracket

__all__ = ["on_conic", "on_conic_again", "polar", "pole", "tangent"]

_PLANE = 3


def _pairs(a: Expr, b: Expr, c: Expr, d: Expr, e: Expr) -> list[tuple[Expr, Expr, Expr]]:
    """The pairs of lines of which the form is made, with their coefficients."""
    one = ex.mul(_b(a, b, c), _b(a, d, e))
    other = ex.mul(Number(-1), _b(a, b, d), _b(a, c, e))
    return [(one, _j(b, d), _j(c, e)), (other, _j(b, c), _j(d, e))]


def _b(*args: Expr) -> Expr:
    return bracket(*args, rank=_PLANE)


def _j(*args: Expr) -> Expr:
    return ex.join(*args, rank=_PLANE)


def _sum(*terms: Expr) -> Expr:
    return ex.add(*terms, rank=_PLANE)


def on_conic(a: Expr, b: Expr, c: Expr, d: Expr, e: Expr, x: Expr) -> Expr:
    """The form of the conic through a, b, c, d, e at x: zero where six points are on a conic."""
    return _sum(*(ex.mul(k, _b(L, x), _b(M, x)) for k, L, M in _pairs(a, b, c, d, e)))


def polar(p: Expr, *five: Expr) -> Expr:
    """The line of all points conjugate to p: [x polar] is the bilinear form of p and x, and 2 on_conic at x = p."""
    return _sum(*(ex.mul(k, _b(one, p), other) for k, L, M in _pairs(*five) for one, other in ((L, M), (M, L))))


def tangent(a: Expr, b: Expr, c: Expr, d: Expr, e: Expr) -> Expr:
    """At the first of the five points."""
    return polar(a, a, b, c, d, e)


def pole(ends: tuple[Expr, Expr], *five: Expr) -> Expr:
    """Of the line through two points, where their polars meet."""
    return ex.meet(*(polar(p, *five) for p in ends), rank=_PLANE)


def on_conic_again(p: Expr, a: Expr, b: Expr, c: Expr, d: Expr, e: Expr) -> Expr:
    """The second point of the line pa on the conic through a, b, c, d, e. At s a + t p the form is t (s B + t Q), where
    B is the bilinear form at a and p, and Q the form at p.
    """
    both, alone = _b(p, polar(a, a, b, c, d, e)), on_conic(a, b, c, d, e, p)
    return _sum(ex.mul(both, p), ex.mul(Number(-1), alone, a))
