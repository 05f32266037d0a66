"""Positions of the theorems on quadrics, by the matrix of the form: the engine has the corners of a tetrahedron."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from itertools import product

from rules.theorem_positions import Position, Vector, between, cross, dot, drawn, mixed, on_plane, vector

from gcrules.algebra.letters import conic_points

__all__ = ["QUADRICS"]

CORNERS = conic_points("Q", 4)


class Quadric:
    """Y1 Y2 = Y3 Y4, where Y_i are four planes; a point has the value of its form, and a polar plane."""

    def __init__(self, rng: random.Random) -> None:
        self.corners = [drawn(rng, 4) for _ in CORNERS]
        e = self.corners
        faces = [cross(*e[:i], *e[i + 1 :]) for i in range(4)]
        # each face takes the value at its corner that makes it 1 there, times the volume: the engine's brackets
        self.faces = [mixed((1 / dot(face, corner), face)) for face, corner in zip(faces, e, strict=True)]
        self.points = dict(zip(CORNERS, e, strict=True))

    def polar(self, p: Vector) -> Vector:
        y = [dot(face, p) for face in self.faces]
        return mixed(*zip((y[1], y[0], -y[3], -y[2]), self.faces, strict=True))

    def pole(self, plane: Vector) -> Vector:
        """Where the polar planes of three points of the plane meet."""
        units = [vector(*(int(i == k) for k in range(4))) for i in range(4)]
        first, *others = [u for u in units if dot(plane, u)]
        inside = [u for u in units if not dot(plane, u)] + [on_plane(first, u, plane) for u in others]
        return cross(*map(self.polar, inside[:3]))

    def point(self, rng: random.Random) -> Vector:
        """A point of it."""
        return self.at(rng.randint(1, 9), rng.choice((-3, -2, 2, 5, 7)))

    def at(self, s: int, t: int) -> Vector:
        """s t e1 + e2 + s e3 + t e4: one line of the quadric for each s, and of the other family for each t."""
        return mixed(*zip((s * t, 1, s, t), self.corners, strict=True))


def conjugate_edges(rng: random.Random) -> Position:
    """d on the two planes that its polar planes ask for."""
    quadric, a, b, c = Quadric(rng), *(drawn(rng, 4) for _ in range(3))
    A, B, C = map(quadric.polar, (a, b, c))
    planes = [mixed((dot(A, c), B), (-dot(B, c), A)), mixed((dot(A, b), C), (-dot(C, b), A))]
    return quadric.points | {"a": a, "b": b, "c": c, "d": cross(*planes, drawn(rng, 4))}


def polar_tetrahedron(rng: random.Random) -> Position:
    """A line through a point of the first line that meets the two next ones."""
    quadric, corners = Quadric(rng), [drawn(rng, 4) for _ in range(4)]
    a, b, c, d = corners
    p, q, r = (quadric.pole(cross(*face)) for face in ((b, c, d), (c, d, a), (d, a, b)))
    one = mixed((rng.randint(1, 9), a), (rng.randint(1, 9), p))
    other = on_plane(b, q, cross(one, c, r))
    return quadric.points | dict(zip("abcd", corners, strict=True)) | {"L₁": one, "L₂": other}


def polar_plane(rng: random.Random) -> Position:
    """p in the tangent plane at c."""
    quadric = Quadric(rng)
    a, c, u, v = quadric.point(rng), quadric.point(rng), drawn(rng, 4), drawn(rng, 4)
    p = on_plane(drawn(rng, 4), drawn(rng, 4), quadric.polar(c))
    return quadric.points | {"a": a, "c": c, "u": u, "v": v, "p": p}


def three_lines(rng: random.Random) -> Position:
    """Three points on each of three lines of one family, and two on a line of the other."""
    quadric, (s, *others), (t, *places) = Quadric(rng), rng.sample(range(1, 20), 4), rng.sample(range(1, 20), 4)
    points = dict(zip("abcdefghi", (quadric.at(*both) for both in product(others, places)), strict=True))
    return points | {"x": quadric.at(others[0], t), "y": quadric.at(s, t)}


def hexahedron(rng: random.Random) -> Position:
    """The corners as meets of three planes, one of each of three pairs; that opposite to a is made by the theorem."""
    planes = [(drawn(rng, 4), drawn(rng, 4)) for _ in range(3)]
    corners = dict(zip("abcedfgh", (cross(*three) for three in product(*planes)), strict=True))
    return {n: p for n, p in corners.items() if n != "h"} | {"x": drawn(rng, 4), "y": drawn(rng, 4)}


def six_in_a_plane(rng: random.Random) -> Position:
    """Seven points of a plane and three others; test_ten_points.py has positions with six of them."""
    plane = [drawn(rng, 4) for _ in range(3)]
    return {n: between(rng, *plane) for n in "abcdefg"} | {n: drawn(rng, 4) for n in "hij"}


QUADRICS: Mapping[str, Callable[[random.Random], Position]] = {
    "hesse": conjugate_edges,
    "hexahedron": hexahedron,
    "polar-plane": polar_plane,
    "polar-tetrahedron": polar_tetrahedron,
    "six-in-a-plane": six_in_a_plane,
    "ten-points": lambda rng: {n: drawn(rng, 4) for n in "abcdefghij"},
    "three-lines": three_lines,
}
