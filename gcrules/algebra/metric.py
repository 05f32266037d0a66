r"""Metric geometry by points at infinity: what midpoints, right angles and circles are in brackets, joins and meets.

Only the points at infinity are known, either the isotropic points i and j of the plane, in which all circles meet the
line at infinity, or orthonormal directions i, j (and k in space). With n of them in rank n + 1, a line L has the
direction Σ ±[L, others] i over all of them, where the others are those beside i.

>>> from gcrules.algebra.language.syntax import parse
>>> plane = Infinity("isotropic", ("i", "j"))
>>> print(midpoint(plane, parse("a", rank=3), parse("b", rank=3)))
[bij] * a + [aij] * b
>>> print(dot(plane, parse("ab", rank=3), parse("cd", rank=3)))
[abi][cdj] + [abj][cdi]
"""

from __future__ import annotations

from collections.abc import Iterable

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number, Point
from gcrules.algebra.scalars import bracket, power
from gcrules.core.dataclass import dataclass

__all__ = [
    "Infinity",
    "bisector",
    "centroid",
    "circumcentre",
    "concyclic",
    "cospherical",
    "direction",
    "dot",
    "equal_distances",
    "equidistant",
    "foot",
    "midpoint",
    "mirror",
    "on_circle_again",
    "orthocentre",
    "parallel",
    "parallel_through",
    "perpendicular",
    "perpendicular_through",
    "reflection",
]


@dataclass(frozen=True, slots=True)
class Infinity:
    """The points at infinity by which lengths and angles are known: their names in rank len(points) + 1.

    `kind` is "isotropic" (two points of the plane), or "orthonormal" (directions at right angles, of one length).
    """

    kind: str
    points: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.kind} {' '.join(self.points)}"

    @property
    def rank(self) -> int:
        return len(self.points) + 1

    @property
    def flat(self) -> Expr:
        """The line (in space the plane) at infinity; it is not zero."""
        return self.join(*map(Point, self.points))

    def join(self, *args: Expr) -> Expr:
        return ex.join(*args, rank=self.rank)

    def meet(self, *args: Expr) -> Expr:
        return ex.meet(*args, rank=self.rank)

    def bracket(self, *args: Expr) -> Expr:
        return bracket(*args, rank=self.rank)

    def weight(self, p: Expr) -> Expr:
        """The last coordinate of a point, up to a factor that all points have in common."""
        return self.bracket(p, *map(Point, self.points))

    def sum(self, *terms: Iterable[Expr]) -> Expr:
        """The sum of products."""
        return ex.add(*(ex.mul(*factors) for factors in terms), rank=self.rank)

    def others(self, name: str) -> tuple[Expr, ...]:
        return tuple(Point(n) for n in self.points if n != name)

    def dual(self, name: str) -> str:
        """The point whose product with this one is 1, where those with all others are 0."""
        return name if self.kind == "orthonormal" else next(n for n in self.points if n != name)

    def normal(self, hyperplane: Expr) -> Expr:
        """The direction at right angles to a line of the plane, or to a plane in space."""
        return self.sum(*((self.bracket(hyperplane, Point(n)), Point(self.dual(n))) for n in self.points))

    def polar(self, line: Expr) -> Expr:
        """All directions at right angles to a line: a point of the plane's line at infinity, in space a line."""
        return self.sum(
            *((self.bracket(line, *self.others(self.dual(n))), self.join(*self.others(n))) for n in self.points)
        )


def direction(at: Infinity, line: Expr) -> Expr:
    """The point at infinity of a line."""
    return at.meet(line, at.flat)


def dot(at: Infinity, one: Expr, other: Expr) -> Expr:
    """The scalar product of the directions of two lines, up to a factor."""
    return at.sum(
        *((at.bracket(one, *at.others(n)), at.bracket(other, *at.others(at.dual(n)))) for n in reversed(at.points))
    )


# --- points, lines and planes --------------------------------------------------------------------------------------


def midpoint(at: Infinity, a: Expr, b: Expr) -> Expr:
    return centroid(at, a, b)


def centroid(at: Infinity, *points: Expr) -> Expr:
    """Each point times the weights of the others."""
    weights = [at.weight(p) for p in points]
    return at.sum(*((*weights[:i], *weights[i + 1 :], p) for i, p in enumerate(points)))


def reflection(at: Infinity, p: Expr, f: Expr) -> Expr:
    return at.sum((Number(2), at.weight(p), f), (Number(-1), at.weight(f), p))


def parallel_through(at: Infinity, c: Expr, line: Expr) -> Expr:
    return at.join(c, direction(at, line))


def perpendicular_through(at: Infinity, c: Expr, flat: Expr) -> Expr:
    """Of a line of the plane a line; in space of a line a plane, and of a plane a line."""
    return at.join(c, at.normal(flat) if flat.step == at.rank - 1 else at.polar(flat))


def foot(at: Infinity, c: Expr, flat: Expr) -> Expr:
    return at.meet(flat, perpendicular_through(at, c, flat))


def mirror(at: Infinity, p: Expr, flat: Expr) -> Expr:
    return reflection(at, p, foot(at, p, flat))


def bisector(at: Infinity, a: Expr, b: Expr) -> Expr:
    return at.join(midpoint(at, a, b), at.polar(at.join(a, b)))


def circumcentre(at: Infinity, first: Expr, *others: Expr) -> Expr:
    return at.meet(*(bisector(at, first, p) for p in others))


def orthocentre(at: Infinity, a: Expr, b: Expr, c: Expr) -> Expr:
    one, other = (perpendicular_through(at, p, at.join(q, r)) for p, q, r in ((a, b, c), (b, c, a)))
    return at.meet(one, other)


def on_circle_again(at: Infinity, p: Expr, a: Expr, b: Expr, c: Expr) -> Expr:
    """The second point of the line pa on the circle through a, b and c: s a + t p, where the angles at it and at c over
    ab are equal (see `concyclic`), which is linear in s and t.
    """
    seen = dot(at, at.join(a, c), at.join(b, c))
    line, across = at.join(a, p), at.bracket(a, b, p)

    def factor(x: Expr, sight: Expr) -> Expr:
        return at.sum(
            (at.bracket(a, b, c), at.weight(c), dot(at, line, sight)), (Number(-1), across, at.weight(x), seen)
        )

    return at.sum((factor(p, at.join(b, p)), a), (Number(-1), factor(a, at.join(b, a)), p))


# --- relations: scalars, and joins and meets, that vanish ----------------------------------------------------------


def parallel(at: Infinity, one: Expr, other: Expr) -> Expr:
    """Of a line, its direction is on the other; two planes meet at infinity."""
    small, large = sorted((one, other), key=lambda e: e.step)
    if small.step == 2:
        joined = at.bracket if large.step == at.rank - 1 else at.join
        return joined(large, direction(at, small))
    return at.meet(one, other, at.flat)


def perpendicular(at: Infinity, one: Expr, other: Expr) -> Expr:
    small, large = sorted((one, other), key=lambda e: e.step)
    if large.step == 2:
        return dot(at, one, other)
    if small.step == 2:
        return at.join(small, at.normal(large))
    return at.sum(*((at.bracket(one, Point(n)), at.bracket(other, Point(n))) for n in at.points))


def concyclic(at: Infinity, a: Expr, b: Expr, c: Expr, d: Expr) -> Expr:
    """At c and d the line ab is seen at equal angles (of lines); it also holds where a, b, c, d are on a line. With
    isotropic points i and j half of this is shorter: a, b, c, d, i and j are on a conic.
    """
    if at.kind == "isotropic":
        i, j = map(Point, at.points)
        one = (at.bracket(a, b, c), at.bracket(a, d, i), at.bracket(b, d, j), at.weight(c))
        return at.sum(one, (Number(-1), at.bracket(a, b, d), at.bracket(a, c, i), at.bracket(b, c, j), at.weight(d)))
    sights = [dot(at, at.join(a, x), at.join(b, x)) for x in (c, d)]
    return at.sum(
        (at.bracket(a, b, c), at.weight(c), sights[1]), (Number(-1), at.bracket(a, b, d), at.weight(d), sights[0])
    )


def cospherical(at: Infinity, a: Expr, b: Expr, *others: Expr) -> Expr:
    """Three more points on a sphere through a and b: the spheres through these are that with the diameter ab and all
    pairs of the plane at infinity and a plane through ab. It also holds where all five points are in a plane.
    """
    terms = []
    for i, x in enumerate(others):
        y, z = others[i - 2], others[i - 1]
        sight = dot(at, at.join(a, x), at.join(b, x))
        terms.append((at.bracket(a, b, y, z), at.weight(y), at.weight(z), sight))
    return at.sum(*terms)


def equidistant(at: Infinity, o: Expr, a: Expr, b: Expr) -> Expr:
    """The line from o to the midpoint of a and b is at right angles to ab. The difference of the squared distances is
    this times the weights of o, a and b.
    """
    return dot(at, at.join(a, b), at.join(o, midpoint(at, a, b)))


def equal_distances(at: Infinity, one: tuple[Expr, Expr], other: tuple[Expr, Expr]) -> Expr:
    """The squared distances are equal; where both begin or end in one point, that is equidistant from the others."""
    for p in one:
        if p in other:
            (a,), (b,) = ([q for q in pair if q != p] or [p] for pair in (one, other))
            return equidistant(at, p, a, b)

    def squared(pair: tuple[Expr, Expr], beside: tuple[Expr, Expr]) -> Expr:
        line = at.join(*pair)
        return ex.mul(dot(at, line, line), *(power(at.weight(p), 2, at.rank) for p in beside))

    return at.sum((squared(one, other),), (Number(-1), squared(other, one)))
