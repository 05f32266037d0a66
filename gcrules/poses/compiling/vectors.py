r"""Brackets and superbrackets of finite points by differences: few multiplications, and shared ones.

Everything is a polynomial in the coordinates of the joints, traced through `scalars`; the coordinates of fixed joints
are numbers, so what depends on them only is folded. Scalars of brackets do not change when all points are shifted, so
one joint may be the origin. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Superbracket
from gcrules.algebra.language.line_text import Leg
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import cross, permutation_sign
from gcrules.poses.compiling.scalars import Ring, Scalar

__all__ = [
    "Places",
    "Turn",
    "Vector",
    "add",
    "cross",
    "dot",
    "exact",
    "fractions",
    "of_expression",
    "of_legs",
    "of_polynomial",
    "scaled",
    "sub",
    "total",
    "turned",
    "vector",
]

Vector = tuple[Ring, Ring, Ring]
Turn = tuple[Vector, Vector, Vector]
"""The rows of a rotation matrix."""


def add(u: Vector, v: Vector) -> Vector:
    return u[0] + v[0], u[1] + v[1], u[2] + v[2]


def sub(u: Vector, v: Vector) -> Vector:
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def dot(u: Vector, v: Vector) -> Ring:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def scaled(v: Vector, by: Ring) -> Vector:
    return v[0] * by, v[1] * by, v[2] * by


def turned(turn: Turn, v: Vector) -> Vector:
    return dot(turn[0], v), dot(turn[1], v), dot(turn[2], v)


def total(terms: Iterable[Ring]) -> Ring:
    found: Ring = 0
    for term in terms:
        found = found + term
    return found


def exact(v: Iterable[Any]) -> Vector:
    """Three floats as the numbers that they are."""
    return vector(fractions(v))


def fractions(v: Iterable[Any]) -> list[Fraction]:
    """Floats as the numbers that they are."""
    return [Fraction(float(c)) for c in v]


def vector(v: Sequence[Ring]) -> Vector:
    x, y, z = v
    return x, y, z


@dataclass(frozen=True)
class Places:
    """Where the joints are: `at` from the origin; `arms`, where given, from one joint of the body that moves."""

    at: Mapping[str, Vector]
    arms: Mapping[str, Vector]

    def difference(self, p: str, q: str) -> Vector:
        """q − p."""
        of = self.arms if p in self.arms and q in self.arms else self.at
        return sub(of[q], of[p])

    def moves(self, p: str) -> bool:
        return any(isinstance(c, Scalar) for c in self.at[p])

    def bracket(self, names: Sequence[str]) -> Ring:
        """The bracket of four joints, −det of the differences, by how many of them move."""
        if len(set(names)) < 4:
            return 0
        order = sorted(range(4), key=lambda i: (self.moves(names[i]), names[i]))
        p, q, r, s = (names[i] for i in order)
        match sum(map(self.moves, names)):
            case 0 | 1:  # the plane of three fixed points
                normal = cross(self.difference(p, q), self.difference(p, r))
                volume = dot(normal, self.at[s]) - dot(normal, self.at[p])
            case 2:  # the moment of two lines, with Plücker coordinates about the origin
                force, moment = self.difference(p, q), cross(self.at[p], self.at[q])
                line = cross(self.at[r], self.at[s])
                volume = dot(force, line) + dot(moment, self.difference(r, s))
            case 3:  # the plane of three points that move
                normal = cross(self.difference(q, r), self.difference(q, s))
                volume = dot(normal, self.at[q]) - dot(normal, self.at[p])
            case _:
                normal = cross(self.difference(p, q), self.difference(p, r))
                volume = dot(normal, self.difference(p, s))
        return volume * -permutation_sign(order)


def of_legs(legs: Sequence[Leg], places: Places) -> Ring:
    """The superbracket of six legs by Laplace expansion: Σ ± [forces of three] [moments of the other three].

    A leg through the origin has no moment, so the terms without its force are 0.
    """
    forces = [places.difference(a, b) for a, b in legs]
    moments = [cross(places.at[a], force) for (a, _), force in zip(legs, forces, strict=True)]
    total: Ring = 0
    for chosen in combinations(range(6), 3):
        rest = tuple(i for i in range(6) if i not in chosen)
        if all(any(moments[i]) for i in rest):
            term = _triple(forces, chosen) * _triple(moments, rest)
            total = total - term * permutation_sign(chosen + rest)
    return total


def _triple(vectors: Sequence[Vector], rows: tuple[int, ...]) -> Ring:
    """The determinant of three of six vectors. The product of two of the same half is taken: six such pairs do for
    all twenty determinants.
    """
    i, j, k = rows
    if (i < 3) == (j < 3):
        return dot(cross(vectors[i], vectors[j]), vectors[k])
    return dot(vectors[i], cross(vectors[j], vectors[k]))


Term = tuple[tuple[tuple[str, ...], ...], Any]


def of_polynomial(p: BracketPolynomial, places: Places) -> Ring:
    """A bracket polynomial; brackets that several terms share are factored out, the commonest first."""
    return _horner([(tuple(tuple(p.points[i] for i in row) for row in m), c) for m, c in p.terms.items()], places)


def _horner(terms: Sequence[Term], places: Places) -> Ring:
    if not terms:
        return 0
    brackets = list(dict.fromkeys(b for m, _ in terms for b in m))
    commonest = max(brackets, key=lambda b: sum(b in m for m, _ in terms), default=None)
    if commonest is None:
        return sum((c for _, c in terms), Fraction(0))
    inside = [(_without(m, commonest), c) for m, c in terms if commonest in m]
    others = [(m, c) for m, c in terms if commonest not in m]
    return places.bracket(commonest) * _horner(inside, places) + _horner(others, places)


def _without(m: tuple[tuple[str, ...], ...], b: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
    n = m.index(b)
    return m[:n] + m[n + 1 :]


def of_expression(e: Expr, places: Places) -> Ring:
    """Any scalar expression in rank 4; brackets of joints and superbrackets of legs by differences."""
    return _Tracer({n: (*place, 1) for n, place in places.at.items()}, places).value(e)[0]  # type: ignore[no-any-return]


class _Tracer(Evaluator):
    def __init__(self, points: Mapping[str, Any], places: Places) -> None:
        super().__init__(points, rank=4)
        self.places = places

    def _value(self, e: Expr) -> list[Any]:
        match e:
            case Bracket(args=args) | Meet(args=[_, _] as args) if e.step == 0:
                names = _joints(args)
                if names is not None:
                    return [self.places.bracket(names)]
            case Superbracket(lines=lines):
                legs = [_joints([line]) for line in lines]
                if all(leg is not None for leg in legs):
                    return [of_legs([(leg[0], leg[1]) for leg in legs if leg], self.places)]
        return super()._value(e)


def _joints(args: Iterable[Expr]) -> list[str] | None:
    """The names of the points that all these are joins of, one after the other; None where there are others."""
    names: list[str] = []
    for a in args:
        parts = a.args if isinstance(a, Join) else (a,)
        if not all(isinstance(p, Point) for p in parts):
            return None
        names += [p.name for p in parts if isinstance(p, Point)]
    return names
