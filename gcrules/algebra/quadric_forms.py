r"""Quadrics of space: those that are no cones, by a letter, and the quadric through nine points.

A quadric that is no cone is y1 y2 = y3 y4 in the coordinates of a tetrahedron that lies on it.
Over the complex numbers such a quadric has lines of two families. Two points e1, e2 of it whose line is not on it, and
the two points e3, e4 in which the lines through them meet, are the corners of a tetrahedron four of whose edges are on
the quadric; multiples of the corners bring the form to y1 y2 - y3 y4, where y_i is the bracket of the corners with x
in the place of e_i. Conversely this is no cone where the corners span the space. So a polynomial with rational
coefficients that is zero for all tetrahedra is zero for all these quadrics, real ones without real lines too.

>>> from gcrules.algebra.language.syntax import parse
>>> print(value(parse("p"), *map(parse, "abcd")))
[pbcd][apcd] - [abpd][abcp]
>>> print(on_quadric(*map(parse, "abcdefghij")).children[0])
[abjh][bcfi][cdgj][dehf][eaig]
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, permutations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.scalars import bracket

__all__ = ["discriminant", "on_quadric", "polar", "polar_line", "pole", "second_of", "touching", "value"]

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


# --- of a quadric through points -------------------------------------------------------------------------------------


def on_quadric(*ten: Expr) -> Expr:
    """The form of the quadric through nine points at the tenth: zero where ten points are on a quadric.

    Five pairs of points are taken, a1 b1 to a5 b5, the ten being a1, …, a5, b1, …, b5. Each order of the pairs round a
    pentagon gives a product of five brackets, one for each side: [a1 a2 b5 b3] for the side 1 2 between 5 and 3. The
    sum of the twelve products is the determinant of ten rows, which hold the products x x, x y, x z, x w, y y, …, w w
    of the coordinates of a point each. Derived here.
    """
    a, b = ten[:5], ten[5:]
    rounds = [(0, *rest) for rest in permutations(range(1, 5)) if rest[0] < rest[-1]]
    return _sum(*(ex.mul(*(_side(a, b, order, i) for i in range(5))) for order in rounds))


def _side(a: Sequence[Expr], b: Sequence[Expr], order: Sequence[int], i: int) -> Expr:
    before, one, other, after = (order[(i + k) % 5] for k in (-1, 0, 1, 2))
    return bracket(a[one], a[other], b[before], b[after], rank=_SPACE)
