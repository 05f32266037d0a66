r"""Conics through five points of the plane: six points on one, tangents, poles and polars, second intersections.

The conic through a, b, c, d, e is the form [abc][ade][xbd][xce] − [abd][ace][xbc][xde] in x.

>>> from gcrules.algebra.language.syntax import parse
>>> five = [parse(n, rank=3) for n in "abcde"]
>>> print(polar(parse("p", rank=3), *five))
[abc][ade][bdp] * ce + [abc][ade][cep] * bd - [abd][ace][bcp] * de - [abd][ace][dep] * bc
"""

from __future__ import annotations

from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.scalars import bracket

__all__ = [
    "discriminant",
    "on_conic",
    "on_conic_again",
    "polar",
    "pole",
    "pole_of",
    "second_of",
    "tangent",
    "touching",
    "value",
]

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


def _m(*args: Expr) -> Expr:
    return ex.meet(*args, rank=_PLANE)


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
    """The second point of the line pa on the conic through a, b, c, d, e."""
    return second_of(p, a, a, b, c, d, e)


# --- of a conic that is given by five points of its own --------------------------------------------------------------


def value(p: Expr, *five: Expr) -> Expr:
    """The form of the conic through five points at p."""
    a, b, c, d, e = five
    return on_conic(a, b, c, d, e, p)


def discriminant(*five: Expr) -> Expr:
    """The product of the brackets of five points: not zero exactly where one conic runs through them which is not two
    lines. It is, up to a number, the determinant of the form.
    """
    return ex.mul(*(_b(*three) for three in combinations(five, _PLANE)))


def pole_of(line: Expr, *five: Expr) -> Expr:
    """The pole of any line. As the polar of p is the sum of [f p] g over pairs of lines f, g with coefficients, the
    meet of two polars is a sum of [f /\\ f', line] g /\\ g' over two such pairs.
    """
    pairs = [(k, *pair) for k, L, M in _pairs(*five) for pair in ((L, M), (M, L))]
    return _sum(
        *(
            ex.mul(k, other, _b(_m(f, f_other), line), _m(g, g_other))
            for (k, f, g), (other, f_other, g_other) in combinations(pairs, 2)
        )
    )


def touching(line: Expr, *five: Expr) -> Expr:
    """The scalar that is zero where a line is a tangent: its pole is on it."""
    return _b(pole_of(line, *five), line)


def second_of(p: Expr, a: Expr, *five: Expr) -> Expr:
    """The second point of the line pa on the conic through five points, of which a is one more point. At s a + t p the
    form is t (s B + t Q), where B is the bilinear form at a and p, and Q the form at p.
    """
    both, alone = _b(p, polar(a, *five)), value(p, *five)
    return _sum(ex.mul(both, p), ex.mul(Number(-1), alone, a))
