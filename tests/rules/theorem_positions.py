"""Positions that satisfy the assumptions of the theorems of examples/theorems, of vectors of fractions.

Each is built from what the theorem is about (a conic from its parameter, a hyperboloid from its two sets of lines,
Möbius' tetrahedra from a null polarity), never by the construction that the proof uses.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

__all__ = [
    "POSITIONS",
    "Position",
    "Vector",
    "between",
    "cross",
    "det",
    "dot",
    "drawn",
    "grid",
    "met",
    "mixed",
    "on_plane",
    "vector",
]

Vector = tuple[Fraction, ...]
Position = dict[str, Vector]


# --- vectors --------------------------------------------------------------------------------------------------------


def vector(*entries: Fraction | int) -> Vector:
    return tuple(map(Fraction, entries))


def drawn(rng: random.Random, rank: int) -> Vector:
    return vector(*(rng.choice((-1, 1)) * rng.randint(1, 30) for _ in range(rank)))


def mixed(*terms: tuple[Fraction | int, Vector]) -> Vector:
    """Σ c v."""
    return tuple(sum((c * v[i] for c, v in terms), Fraction(0)) for i in range(len(terms[0][1])))


def between(rng: random.Random, *points: Vector) -> Vector:
    """A point of the line or plane of the given points."""
    return mixed(*((rng.choice((-1, 1)) * rng.randint(1, 9), p) for p in points))


def dot(u: Vector, v: Vector) -> Fraction:
    return sum((a * b for a, b in zip(u, v, strict=True)), Fraction(0))


def det(rows: Sequence[Vector]) -> Fraction:
    if not rows:
        return Fraction(1)
    first, *rest = rows
    return sum(((-1) ** j * c * det([r[:j] + r[j + 1 :] for r in rest]) for j, c in enumerate(first) if c), Fraction(0))


def cross(*vectors: Vector) -> Vector:
    """The line through two points of the plane or the meet of two lines; the plane through three points of space."""
    n = len(vectors[0])
    return tuple((-1) ** i * det([v[:i] + v[i + 1 :] for v in vectors]) for i in range(n))


def met(a: Vector, b: Vector, c: Vector, d: Vector) -> Vector:
    """The common point of the lines ab and cd of the plane."""
    return cross(cross(a, b), cross(c, d))


def on_plane(a: Vector, b: Vector, plane: Vector) -> Vector:
    """The point of the line ab on a plane, or in the plane on a line."""
    return mixed((dot(plane, b), a), (-dot(plane, a), b))


# --- positions ------------------------------------------------------------------------------------------------------


def any_points(names: str, rank: int) -> Callable[[random.Random], Position]:
    return lambda rng: {n: drawn(rng, rank) for n in names.split()}


def perspective(rng: random.Random, rank: int, letters: str = "abc") -> Position:
    """Each a' on the line of a and q."""
    found = {n: drawn(rng, rank) for n in (*letters, "q")}
    return found | {f"{n}'": between(rng, found[n], found["q"]) for n in letters}


def crossing(p: Position, u: str, v: str) -> Vector:
    """The meet of uv and u'v' for triangles in perspective: u' = k u + l q, so that l(v) u' − l(u) v' is free of q."""
    a, b, c, d = (p[n] for n in (u, v, f"{u}'", f"{v}'"))
    plane = cross(c, d) if len(a) == 3 else cross(c, d, tuple(x + i * i for i, x in enumerate(p["q"])))
    return on_plane(a, b, plane)


def sides(p: Position) -> Position:
    return p | {"x": crossing(p, "b", "c"), "y": crossing(p, "c", "a"), "z": crossing(p, "a", "b")}


def without(p: Position, *names: str) -> Position:
    return {n: v for n, v in p.items() if n not in names}


def desargues_converse(rng: random.Random) -> Position:
    """Triangles whose sides turn about three points x, y, z of a line."""
    x, y = drawn(rng, 3), drawn(rng, 3)
    found = {"x": x, "y": y, "z": between(rng, x, y)}
    for prime in ("", "'"):
        a = drawn(rng, 3)
        b = between(rng, a, found["z"])
        found |= {f"a{prime}": a, f"b{prime}": b, f"c{prime}": met(b, x, a, y)}
    return found


def desargues_space_converse(rng: random.Random) -> Position:
    """Triangles in two planes whose sides turn about three points of the line of these planes."""
    x, y = drawn(rng, 4), drawn(rng, 4)
    found = {"o": drawn(rng, 4)}
    z = between(rng, x, y)
    for prime in ("", "'"):
        a = drawn(rng, 4)
        b = between(rng, a, z)
        c = on_plane(b, x, cross(a, y, drawn(rng, 4)))
        found |= {f"a{prime}": a, f"b{prime}": b, f"c{prime}": c}
    return found


def pappus(rng: random.Random) -> Position:
    ends = {n: drawn(rng, 3) for n in ("a", "b", "a'", "b'")}
    return ends | {"c": between(rng, ends["a"], ends["b"]), "c'": between(rng, ends["a'"], ends["b'"])}


Tangent = tuple[Vector, Vector]


def conic(rng: random.Random, number: int) -> list[Vector]:
    """Points M (t², t, 1) of the conic with a random matrix M, at different parameters."""
    return conic_with_tangents(rng, number, 0)[0]


def conic_with_tangents(rng: random.Random, number: int, tangents: int) -> tuple[list[Vector], list[Tangent]]:
    """Points of a conic as above, and of tangents at others these and M (2 t, 1, 0), the derivative."""
    rows = [drawn(rng, 3) for _ in range(3)]

    def at(*p: int) -> Vector:
        return tuple(dot(r, vector(*p)) for r in rows)

    places = rng.sample(range(-9, 10), number + tangents)
    return [at(t * t, t, 1) for t in places[:number]], [(at(t * t, t, 1), at(2 * t, 1, 0)) for t in places[number:]]


def brianchon(rng: random.Random) -> Position:
    """Two points on each of six tangents: as vectors, tangents of a conic are points of a conic."""
    lines = dict(zip("abcdef", conic(rng, 6), strict=True))
    return {f"{n}{prime}": cross(line, drawn(rng, 3)) for n, line in lines.items() for prime in ("", "'")}


def maclaurin(rng: random.Random) -> Position:
    """Nine points of a conic; m and n are where the lines from a and b to x cross two lines through c."""
    found = dict(zip(("a", "b", "c", "d", "e", "f", "x1", "x2", "x3"), conic(rng, 9), strict=True))
    found |= {"g": drawn(rng, 3), "h": drawn(rng, 3)}
    a, b, c, g, h = (found[n] for n in "abcgh")
    for i in "123":
        found |= {f"m{i}": met(a, found[f"x{i}"], c, g), f"n{i}": met(b, found[f"x{i}"], c, h)}
    return found | {"o": met(found["m1"], found["n1"], found["m2"], found["n2"])}


def harmonic(rng: random.Random) -> Position:
    """x = p + k q and y = p − k q; quadrangles with ab, cd through p, with ad, bc through q, and with ac through x."""
    p, q, k = drawn(rng, 3), drawn(rng, 3), rng.randint(2, 9)
    found = {"p": p, "q": q, "x": mixed((1, p), (k, q)), "y": mixed((1, p), (-k, q)), "o": drawn(rng, 3)}
    for prime in ("", "'"):
        a = drawn(rng, 3)
        c = between(rng, a, found["x"])
        corners = {"a": a, "b": met(a, p, c, q), "c": c, "d": met(a, q, c, p)}
        found |= {f"{n}{prime}": v for n, v in corners.items()}
    return found


def quadrilateral_set(rng: random.Random) -> Position:
    """Involutory pairs p s, q t, r u on a line: parameters with product k."""
    x, y, k = drawn(rng, 3), drawn(rng, 3), rng.choice((-7, -5, 11))
    first = rng.sample(range(2, 12), 3)
    found = {n: mixed((1, x), (t, y)) for n, t in zip("pqr", first, strict=True)}
    found |= {n: mixed((1, x), (Fraction(k, t), y)) for n, t in zip("stu", first, strict=True)}
    found["o"] = drawn(rng, 3)
    for prime in ("", "'"):
        a = drawn(rng, 3)
        c = between(rng, a, found["q"])
        d = met(a, found["r"], c, found["s"])
        b = met(a, found["p"], d, found["t"])
        found |= {f"{n}{prime}": v for n, v in zip("abcd", (a, b, c, d), strict=True)}
    return found


def ceva(rng: random.Random) -> Position:
    """The feet of a point u a + v b + w c."""
    p = {n: drawn(rng, 3) for n in "abc"}
    u, v, w = rng.sample(range(1, 9), 3)
    feet = {"d": ((v, "b"), (w, "c")), "e": ((u, "a"), (w, "c")), "f": ((u, "a"), (v, "b"))}
    return p | {n: mixed(*((c, p[m]) for c, m in terms)) for n, terms in feet.items()}


def menelaus(rng: random.Random) -> Position:
    p, line = {n: drawn(rng, 3) for n in "abc"}, drawn(rng, 3)
    return p | {n: on_plane(p[u], p[v], line) for n, u, v in (("d", "b", "c"), ("e", "c", "a"), ("f", "a", "b"))}


def moebius(rng: random.Random) -> Position:
    """b1 … b4 are the poles of the faces of a1 … a4 in a null polarity, in which each point is on its own plane."""
    f = {pair: Fraction(rng.randint(1, 9)) for pair in combinations(range(4), 2)}
    polarity = [vector(*(f.get((i, j), -f.get((j, i), Fraction(0))) for j in range(4))) for i in range(4)]
    a = [drawn(rng, 4) for _ in range(4)]
    found = {f"a{i + 1}": v for i, v in enumerate(a)}
    for i in range(4):
        # The pole of the plane of three points is the meet of their three polar planes.
        found[f"b{i + 1}"] = cross(*(tuple(dot(row, v) for row in polarity) for j, v in enumerate(a) if j != i))
    return found


def grid(rng: random.Random) -> Callable[[int, int], Vector]:
    """The points of a hyperboloid: i numbers the lines of one set, j those of the other."""
    rows = [drawn(rng, 4) for _ in range(4)]
    return lambda i, j: tuple(dot(r, vector(1, i, j, i * j)) for r in rows)


def gallucci(rng: random.Random) -> Position:
    at = grid(rng)
    found = {n: at(i, j) for i, pair in enumerate(("kk'", "ll'", "mm'")) for j, n in ((20, pair[0]), (30, pair[1:]))}
    for j in range(4):
        found |= {f"p{j + 1}": at(0, j), f"q{j + 1}": at(1, j)}
    return found | {"x": at(7, 0), "y": at(7, 1)}


def hyperboloid(rng: random.Random) -> Position:
    at = grid(rng)
    return {n: at((k + 1) // 2 % 4, k // 2) for k, n in enumerate("abcdefgh")}


def skew_hexagon(rng: random.Random) -> Position:
    at = grid(rng)
    return {n: at((k + 1) // 2 % 3, k // 2) for k, n in enumerate("abcdef")}


def skew_quadrangle(rng: random.Random) -> Position:
    p = {n: drawn(rng, 4) for n in "abcd"}
    return p | {n: between(rng, p[u], p[v]) for n, u, v in zip("pqrs", "abcd", "bcda", strict=True)}


def pencil(rng: random.Random) -> Position:
    x, y = drawn(rng, 4), drawn(rng, 4)
    found = {"x": x, "y": y}
    for a, b, c in ("abc", "def", "ghk"):
        found[a] = drawn(rng, 4)
        found |= {b: between(rng, found[a], x, y), c: between(rng, found[a], x, y)}
    return found


def pencil_converse(rng: random.Random) -> Position:
    found = pencil(rng)
    return without(found, "x", "y") | {"p": between(rng, found["x"], found["y"])}


def five_lines(rng: random.Random) -> Position:
    found = {n: drawn(rng, 4) for n in "xypqrs"}
    for i in "12345":
        a = drawn(rng, 4)
        found |= {f"a{i}": a, f"b{i}": between(rng, a, between(rng, found["x"], found["y"]))}
    return found


def double_six(rng: random.Random) -> Position:
    """On the cubic surface of the cubics through six points of the plane: the a's stand for the directions at these
    points, the b's for the conics through five of them.
    """
    six = {i: drawn(rng, 3) for i in range(1, 7)}
    line = {(i, j): cross(six[i], six[j]) for i in six for j in six if i != j}
    cubics = [((1, 2), (3, 4), (5, 6)), ((1, 3), (2, 5), (4, 6)), ((1, 4), (2, 6), (3, 5)), ((1, 5), (2, 4), (3, 6))]

    def tangent(i: int, without: int) -> Vector:
        """At a point, of the conic through it and all others but one: a combination of two pairs of lines."""
        b, c, d, e = (n for n in six if n not in (i, without))
        one = dot(line[i, c], six[e]) * dot(line[b, d], six[e]) * dot(line[c, d], six[i])
        other = dot(line[i, b], six[e]) * dot(line[c, d], six[e]) * dot(line[b, d], six[i])
        return mixed((one, line[i, b]), (-other, line[i, c]))

    def at(i: int, j: int) -> Vector:
        """Where ai and bj meet: the derivatives of the cubics, each three lines, along the tangent."""
        along = cross(tangent(i, j), drawn(rng, 3))
        found = []
        for cubic in cubics:
            ((_, other),) = (pair if pair[0] == i else pair[::-1] for pair in cubic if i in pair)
            rest = [dot(line[pair], six[i]) for pair in cubic if i not in pair]
            sign = 1 if (i, other) in cubic else -1
            found.append(sign * dot(line[i, other], along) * rest[0] * rest[1])
        return tuple(found)

    found = {f"p{j}": at(1, j) for j in range(3, 7)} | {f"q{j}": at(2, j) for j in range(3, 7)}
    return found | {f"u{i}": at(i, 6) for i in range(3, 6)}


def conic_points(letters: str) -> Callable[[random.Random], Position]:
    names = letters.split()
    return lambda rng: dict(zip(names, conic(rng, len(names)), strict=True))


def transformed(rng: random.Random, points: Mapping[str, Sequence[Fraction | int]]) -> Position:
    """The same points by a random matrix, with random weights."""
    rank = len(next(iter(points.values())))
    rows = [drawn(rng, rank) for _ in range(rank)]
    return {n: mixed((rng.randint(1, 5), tuple(dot(r, vector(*p)) for r in rows))) for n, p in points.items()}


def twice_in_perspective(rng: random.Random) -> Position:
    """From (1, 1, 1), and since s t u = 1 from (s, s t, 1) too."""
    s, t = Fraction(rng.randint(2, 9)), Fraction(rng.randint(2, 9), 11)
    triangles = {
        "a": (1, 0, 0),
        "b": (0, 1, 0),
        "c": (0, 0, 1),
        "a'": (s, 1, 1),
        "b'": (1, t, 1),
        "c'": (1, 1, 1 / s / t),
    }
    return transformed(rng, triangles)


def three_triangles(rng: random.Random) -> Position:
    p = perspective(rng, 3)
    return without(p, "q") | {"o": p["q"]} | {f"{n}''": between(rng, p[n], p["q"]) for n in "abc"}


def involution(rng: random.Random) -> Position:
    """A line that meets a conic through a, b, c, d in p and p'."""
    a, b, c, d, p, q = conic(rng, 6)
    found = {"a": a, "b": b, "c": c, "d": d, "p": p, "p'": q, "o": drawn(rng, 3)}
    return found | {"q": met(a, b, p, q), "q'": met(c, d, p, q), "r": met(a, d, p, q), "r'": met(b, c, p, q)}


def carnot(rng: random.Random) -> Position:
    p = {n: drawn(rng, 3) for n in "abc"}
    sides = {"p": "bc", "q": "ca", "r": "ab"}
    return p | {f"{n}{prime}": between(rng, *(p[m] for m in side)) for n, side in sides.items() for prime in ("", "'")}


def desmic(rng: random.Random) -> Position:
    """The corners of the frame, (1, ±1, ±1, ±1) with an even number of minus signs, and three with an odd one."""
    points = {n: [int(i == k) for i in range(4)] for k, n in enumerate("abcd")}
    points |= {"a'": [1, 1, 1, 1], "b'": [1, 1, -1, -1], "c'": [1, -1, 1, -1], "d'": [1, -1, -1, 1]}
    return transformed(rng, points | {"p": [-1, 1, 1, 1], "q": [1, -1, 1, 1], "r": [1, 1, -1, 1]})


def bundle(rng: random.Random) -> Position:
    """Four lines through a point."""
    o, found = drawn(rng, 4), {n: drawn(rng, 4) for n in "abcd"}
    return found | {f"{n}'": between(rng, found[n], o) for n in "abcd"}


def cox(rng: random.Random) -> Position:
    """Four planes through o, as normal vectors, and a point on each line of two of them."""
    o = drawn(rng, 4)
    planes = [cross(o, drawn(rng, 4), drawn(rng, 4)) for _ in range(4)]
    lines = zip("abcdef", combinations(planes, 2), strict=True)
    return {"o": o} | {n: between(rng, o, cross(*both, drawn(rng, 4))) for n, both in lines}


def twisted_cubic(rng: random.Random) -> Position:
    """Seven points M (t³, t², t, 1), and a point of each plane through the last one and two of the first three."""
    rows = [drawn(rng, 4) for _ in range(4)]
    curve = [tuple(dot(r, vector(t**3, t * t, t, 1)) for r in rows) for t in rng.sample(range(-9, 10), 7)]
    a, b, c, *_, g = curve
    planes = {"p": (a, b, g), "q": (b, c, g), "r": (c, a, g)}
    return dict(zip("abcdef", curve[:6], strict=True)) | {n: between(rng, *plane) for n, plane in planes.items()}


POSITIONS: Mapping[str, Callable[[random.Random], Position]] = {
    "brianchon": brianchon,
    "bundle": bundle,
    "carnot": carnot,
    "ceva": ceva,
    "conic": maclaurin,
    "cox": cox,
    "dandelin": skew_hexagon,
    "desargues": lambda rng: without(perspective(rng, 3), "q"),
    "desargues-converse": desargues_converse,
    "desargues-space": lambda rng: sides(perspective(rng, 4)),
    "desargues-space-converse": desargues_space_converse,
    "desmic": desmic,
    "double-six": double_six,
    "five-lines": five_lines,
    "gallucci": gallucci,
    "harmonic": harmonic,
    "hyperboloid": hyperboloid,
    "involution": involution,
    "menelaus": menelaus,
    "moebius": moebius,
    "pappus": pappus,
    "pappus-dual": any_points("a b c d e f o o'", 3),
    "pascal": conic_points("a b c d e f"),
    "pencil": pencil,
    "pencil-converse": pencil_converse,
    "pencils": conic_points("a b c d e f"),
    "quadrangle": any_points("a b c d", 3),
    "quadrilateral-set": quadrilateral_set,
    "relations-3": any_points("a b c d e f", 3),
    "relations-4": any_points("a b c d e f g h", 4),
    "relations-5": any_points("a b c d e f g h i j", 5),
    "skew-quadrangle": skew_quadrangle,
    "steiner": conic_points("a b c d e f"),
    "three-triangles": three_triangles,
    "triple-perspective": twice_in_perspective,
    "twisted-cubic": twisted_cubic,
}
