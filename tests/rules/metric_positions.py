"""Positions of the theorems on midpoints, right angles and circles, in the plane with its line at infinity.

Points i and j at infinity that are not named otherwise are the isotropic ones, in coordinates in which they are
(1, 0, 0) and (0, 1, 0): there (u, v) is perpendicular to (u, -v), and circles are x y + p x + q y + r = 0. Complex
x + y √-1 and x - y √-1 in place of x and y make these the coordinates of Euclid's plane.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from rules.theorem_positions import (
    Position,
    Vector,
    between,
    conic,
    conic_with_tangents,
    cross,
    det,
    drawn,
    mixed,
    vector,
)

from gcrules.algebra.letters import conic_points, names_of

__all__ = ["METRIC"]

HIDDEN = conic_points("K")
ISOTROPIC = {"i": vector(1, 0, 0), "j": vector(0, 1, 0)}


def weighted(rng: random.Random, points: Mapping[str, Vector]) -> Position:
    return {n: mixed((rng.randint(1, 5), p)) for n, p in points.items()}


def at_infinity(rng: random.Random) -> Vector:
    return vector(*drawn(rng, 2), 0)


def finite(rng: random.Random) -> Vector:
    return vector(*drawn(rng, 2), 1)


def affine(names: str) -> Callable[[random.Random], Position]:
    """Any points, and any two at infinity."""
    return lambda rng: (
        weighted(rng, {n: finite(rng) for n in names.split()}) | {"i": at_infinity(rng), "j": at_infinity(rng)}
    )


def euclidean(names: str) -> Callable[[random.Random], Position]:
    return lambda rng: weighted(rng, {n: finite(rng) for n in names.split()}) | ISOTROPIC


def midpoints(rng: random.Random) -> Position:
    """a, a + u, a + u + v, a + v with any weights."""
    a, u, v = vector(*drawn(rng, 2), 1), vector(*drawn(rng, 2), 0), vector(*drawn(rng, 2), 0)
    corners = {"a": a, "b": mixed((1, a), (1, u)), "c": mixed((1, a), (1, u), (1, v)), "d": mixed((1, a), (1, v))}
    return {n: mixed((rng.randint(1, 5), p)) for n, p in corners.items()} | {"i": u, "j": v}


def trapezium(rng: random.Random) -> Position:
    a, d, u = finite(rng), finite(rng), at_infinity(rng)
    corners = {"a": a, "b": mixed((1, a), (rng.randint(1, 9), u)), "c": mixed((1, d), (rng.randint(1, 9), u)), "d": d}
    return weighted(rng, corners) | {"i": u, "j": at_infinity(rng)}


def thomsen(rng: random.Random) -> Position:
    found = affine("a b c")(rng)
    share = Fraction(rng.randint(1, 9), 11)
    return found | {"p": mixed((share / found["b"][2], found["b"]), ((1 - share) / found["c"][2], found["c"]))}


def parallel_pappus(rng: random.Random) -> Position:
    """b, b' and the directions i, j; the other points are where these lead on two lines."""
    one, other = (cross(finite(rng), finite(rng)) for _ in range(2))
    b, b_ = (cross(line, at_infinity(rng)) for line in (one, other))
    i, j = at_infinity(rng), at_infinity(rng)
    others = {"a": (b_, i, one), "a'": (b, i, other), "c": (b_, j, one), "c'": (b, j, other)}
    found = {"b": b, "b'": b_} | {n: cross(cross(p, d), line) for n, (p, d, line) in others.items()}
    return found | {"i": i, "j": j}


def space(names: str) -> Callable[[random.Random], Position]:
    """Any points in space, and any three directions, which a linear map makes orthonormal."""
    return lambda rng: (
        weighted(rng, {n: vector(*drawn(rng, 3), 1) for n in names.split()})
        | {n: vector(*drawn(rng, 3), 0) for n in "ijk"}
    )


def monge(rng: random.Random) -> Position:
    """Radii in one direction, of any lengths."""
    centres, u = {n: finite(rng) for n in "abc"}, at_infinity(rng)
    ends = {e: mixed((1, centres[n]), (rng.randint(1, 9), u)) for e, n in zip("pqr", "abc", strict=True)}
    return weighted(rng, centres | ends) | {"i": at_infinity(rng), "j": at_infinity(rng)}


def miquel_triangle(rng: random.Random) -> Position:
    points = {n: finite(rng) for n in "abcm"}
    share = Fraction(rng.randint(1, 9), 11)
    return weighted(rng, points | {"d": mixed((share, points["b"]), (1 - share, points["c"]))}) | ISOTROPIC


def circle(rng: random.Random) -> Position:
    """Four points of a circle."""
    one = Circle.drawn(rng)
    points = {n: one.at(t) for n, t in zip("abcd", rng.sample(range(1, 20), 4), strict=True)}
    return weighted(rng, points) | ISOTROPIC


def butterfly(rng: random.Random) -> Position:
    """In an affine frame x² + s x y + t y² + u y = 1 is a conic in which m = (0, 0) halves the chord of p = (-1, 0) and
    q = (1, 0); a and b are on x = k y, c and d on x = l y. With a, b and c one has s, t and u, then d as a second root.
    The script makes q and d itself, and has to make these.
    """
    k, l = (Fraction(n, 7) for n in rng.sample(range(-20, 20), 2))
    ya, yb, yc = (Fraction(n, 5) for n in rng.sample([n for n in range(-20, 20) if n], 3))
    rows = [(slope * y * y, y * y, y, 1 - (slope * y) ** 2) for slope, y in ((k, ya), (k, yb), (l, yc))]
    s, t, _ = (det([r[:n] + r[3:] + r[n + 1 : 3] for r in rows]) / det([r[:3] for r in rows]) for n in range(3))
    yd = -1 / (yc * (l * l + s * l + t))
    frame = finite(rng), at_infinity(rng), at_infinity(rng)
    ends = {"p": (-1, 0), "q": (1, 0), "m": (0, 0)}
    places = ends | {"a": (k * ya, ya), "b": (k * yb, yb), "c": (l * yc, yc), "d": (l * yd, yd)}
    points = {n: mixed((1, frame[0]), (x, frame[1]), (y, frame[2])) for n, (x, y) in places.items()}
    return weighted(rng, points) | {"i": at_infinity(rng), "j": at_infinity(rng)}


@dataclass(frozen=True)
class Circle:
    """(x - p)(y - q) = r, with a point for each number t but 0."""

    p: Fraction
    q: Fraction
    r: Fraction

    @staticmethod
    def drawn(rng: random.Random) -> Circle:
        p, q = drawn(rng, 2)
        return Circle(p, q, Fraction(rng.randint(1, 30)))

    def at(self, t: Fraction | int) -> Vector:
        return vector(self.p + t, self.q + self.r / t, 1)

    def beside(self, a: Vector, b: Vector, share: Fraction) -> Circle:
        """Another one through two of its points: x y - q x - p y + p q - r and a share of the equation of the line."""
        u, v, w = cross(a, b)
        p, q = self.p - share * v, self.q - share * u
        return Circle(p, q, p * q - (self.p * self.q - self.r + share * w))

    def again(self, a: Vector, x: Vector) -> Vector:
        """Where the line through x and a point a of the circle meets it again; last coordinates are 1."""
        t, u, v = a[0] - self.p, x[0] - self.p, x[1] - self.q
        return self.at(self.r * (t - u) / (v * t - self.r))


def thales(rng: random.Random) -> Position:
    c, (u, v) = finite(rng), drawn(rng, 2)
    sides = {"a": vector(u, v, 0), "b": vector(u, -v, 0)}
    points = {n: mixed((1, c), (rng.randint(1, 9), side)) for n, side in sides.items()}
    return weighted(rng, points | {"c": c}) | ISOTROPIC


def radical_axes(rng: random.Random) -> Position:
    one = Circle.drawn(rng)
    a, b, c = (one.at(t) for t in rng.sample(range(1, 9), 3))
    other = one.beside(a, b, Fraction(rng.randint(1, 9), 50))
    share = Fraction(rng.randint(2, 9), 11)
    x = mixed((share, a), (1 - share, b))
    e = other.at(Fraction(rng.randint(1, 9), 7))
    points = {"a": a, "b": b, "x": x, "c": c, "d": one.again(c, x), "e": e, "f": other.again(e, x)}
    return weighted(rng, points) | ISOTROPIC


def reim(rng: random.Random) -> Position:
    one = Circle.drawn(rng)
    a, b, c, d = (one.at(t) for t in rng.sample(range(1, 9), 4))
    other = one.beside(a, b, Fraction(rng.randint(1, 9), 50))
    points = {"a": a, "b": b, "c": c, "d": d, "e": other.again(a, c), "f": other.again(b, d)}
    return weighted(rng, points) | ISOTROPIC


def tangents(names: str) -> Callable[[random.Random], Position]:
    """Five points of a conic, and lines, each by two points, that touch it in points called t_aK and so on."""

    def position(rng: random.Random) -> Position:
        found, places = conic_with_tangents(rng, len(HIDDEN), len(names))
        points = dict(zip(HIDDEN, found, strict=True))
        for name, (at, beside) in zip(names, places, strict=True):
            ends = (mixed((rng.randint(1, 9), at), (rng.randint(1, 9), beside)) for _ in range(2))
            points |= dict(zip(names_of(name, 2), ends, strict=True)) | {f"t_{name}K": at}
        return points

    return position


def miquel(rng: random.Random) -> Position:
    found = {n: drawn(rng, 3) for n in "abcmij"}
    return found | {"r": between(rng, found["a"], found["b"])}


METRIC: Mapping[str, Callable[[random.Random], Position]] = {
    "bimedians": affine("a b c d"),
    "bisectors": euclidean("a b c"),
    "butterfly": butterfly,
    "circumcentre": circle,
    "polar-triangle": lambda rng: dict(zip(HIDDEN, conic(rng, 5), strict=True)) | {n: drawn(rng, 3) for n in "abc"},
    "tangent-hexagon": tangents("abcdef"),
    "tangent-triangle": lambda rng: dict(zip((*HIDDEN, *"abc"), conic(rng, 8), strict=True)),
    "diagonal-triangle": lambda rng: {n: drawn(rng, 3) for n in "abcde"},
    "euler-line": euclidean("a b c"),
    "feet": euclidean("a b c"),
    "feuerbach": euclidean("d e f"),
    "medians": affine("a b c"),
    "midpoints": midpoints,
    "newton-gauss": affine("a b c d"),
    "miquel": miquel,
    "miquel-triangle": miquel_triangle,
    "monge": monge,
    "nine-points": euclidean("a b c"),
    "opposite-on-sphere": space("a b c d"),
    "orthocentre": euclidean("a b c"),
    "orthocentric": euclidean("a b c"),
    "orthologic": euclidean("a b c a' b' c'"),
    "ortholine": euclidean("a b c d"),
    "pappus-parallel": parallel_pappus,
    "radical-axes": radical_axes,
    "reflected-orthocentre": euclidean("a b c"),
    "reim": reim,
    "simson": circle,
    "tetrahedron-bimedians": space("a b c d"),
    "tetrahedron-medians": space("a b c d"),
    "thales": thales,
    "thomsen": thomsen,
    "three-perpendiculars": space("a b c p"),
    "trapezium": trapezium,
    "varignon": affine("a b c d"),
}
