r"""Quadrics of space that are no cones: each is y1 y2 = y3 y4 in the coordinates of a tetrahedron that lies on it.

Over the complex numbers such a quadric has lines of two families. Two points e1, e2 of it whose line is not on it, and
the two points e3, e4 in which the lines through them meet, are the corners of a tetrahedron four of whose edges are on
the quadric; multiples of the corners bring the form to y1 y2 - y3 y4, where y_i is the bracket of the corners with x
in the place of e_i. Conversely this is no cone where the corners span the space. So a polynomial with rational
coefficients that is zero for all tetrahedra is zero for all these quadrics, real ones without real lines too.

>>> from gcrules.algebra.language.syntax import parse
>>> print(value(parse("p"), *map(parse, "abcd")))
[pbcd][apcd] - [abpd][abcp]
"""

from __future__ import annotations

from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.scalars import bracket

__all__ = ["discriminant", "polar", "polar_line", "pole", "second_of", "touching", "value"]

_SPACE = 4
_PARTNERS = ((1, 1), (0, 1), (3, -1), (2, -1))
"""Of each corner that to which it is not conjugate, and the sign of the product of their coordinates."""


def _coordinate(p: Expr, i: int, corners: tuple[Expr, ...]) -> Expr:
    return bracket(*corners[:i], p, *corners[i + 1 :], rank=_SPACE)


def _face(i: int, corners: tuple[Expr, ...]) -> Expr:
    """The plane H of the other corners, with the sign by which [x H] is the coordinate of x."""
    face = ex.join(*corners[:i], *corners[i + 1 :], rank=_SPACE)
    return ex.neg(face) if i % 2 else face


def _sum(*terms: Expr) -> Expr:
    return ex.add(*terms, rank=_SPACE)


def value(p: Expr, *corners: Expr) -> Expr:
    """The form at p: zero where p is on the quadric."""
    y = [_coordinate(p, i, corners) for i in range(_SPACE)]
    return _sum(ex.mul(y[0], y[1]), ex.mul(Number(-1), y[2], y[3]))


def polar(p: Expr, *corners: Expr) -> Expr:
    """The plane of all points conjugate to p: [x polar] is the bilinear form of p and x, and 2 value at x = p."""
    return _sum(
        *(ex.mul(Number(sign), _coordinate(p, i, corners), _face(j, corners)) for i, (j, sign) in enumerate(_PARTNERS))
    )


def pole(plane: Expr, *corners: Expr) -> Expr:
    """The point whose polar is the plane."""
    return _sum(
        *(
            ex.mul(Number(sign), bracket(corners[i], plane, rank=_SPACE), corners[j])
            for i, (j, sign) in enumerate(_PARTNERS)
        )
    )


def polar_line(line: Expr, *corners: Expr) -> Expr:
    """The line of all points conjugate to those of a line: it joins the poles of planes through that."""
    terms = []
    for i, k in combinations(range(_SPACE), 2):
        (j, sign), (m, other) = _PARTNERS[i], _PARTNERS[k]
        edge = ex.join(corners[j], corners[m], rank=_SPACE)
        terms.append(ex.mul(Number(sign * other), bracket(corners[i], corners[k], line, rank=_SPACE), edge))
    return _sum(*terms)


def touching(flat: Expr, *corners: Expr) -> Expr:
    """The scalar that is zero where a plane has its pole on it, or a line meets its polar: where they touch."""
    if flat.step == _SPACE - 1:
        at = [bracket(e, flat, rank=_SPACE) for e in corners]
        return _sum(ex.mul(at[0], at[1]), ex.mul(Number(-1), at[2], at[3]))
    return bracket(flat, polar_line(flat, *corners), rank=_SPACE)


def second_of(p: Expr, a: Expr, *corners: Expr) -> Expr:
    """The second point of the line pa on the quadric, of which a is a point."""
    both, alone = bracket(p, polar(a, *corners), rank=_SPACE), value(p, *corners)
    return _sum(ex.mul(both, p), ex.mul(Number(-1), alone, a))


def discriminant(*corners: Expr) -> Expr:
    """Not zero exactly where the quadric is no cone: the determinant of the form is a power of it, up to a number."""
    return bracket(*corners, rank=_SPACE)
