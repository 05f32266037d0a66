"""The theorems of examples/theorems by another road: positions that are built here of vectors of fractions.

Each position is built from what the theorem is about (a conic from its parameter, a hyperboloid from its two sets of
lines, Möbius' tetrahedra from a null polarity), never by the construction that the proof uses. It must satisfy all
assumptions, none of what the proof assumed not to vanish may vanish there, and all claims must hold.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

import pytest
from places import EXAMPLES

from gcrules.algebra.assumptions.assumed import equations
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import Claim, Script, parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.rules.script import run_script

THEOREMS = sorted((EXAMPLES / "theorems").glob("*.gca"))
NAMES = [p.stem for p in THEOREMS]

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


def conic(rng: random.Random, number: int) -> list[Vector]:
    """Points M (t², t, 1) of the conic with a random matrix M, at different parameters."""
    rows = [drawn(rng, 3) for _ in range(3)]
    return [tuple(dot(r, vector(t * t, t, 1)) for r in rows) for t in rng.sample(range(-9, 10), number)]


def pascal(rng: random.Random) -> Position:
    return dict(zip("abcdef", conic(rng, 6), strict=True))


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


def midpoints(rng: random.Random) -> Position:
    """a, a + u, a + u + v, a + v with any weights."""
    a, u, v = vector(*drawn(rng, 2), 1), vector(*drawn(rng, 2), 0), vector(*drawn(rng, 2), 0)
    corners = {"a": a, "b": mixed((1, a), (1, u)), "c": mixed((1, a), (1, u), (1, v)), "d": mixed((1, a), (1, v))}
    return {n: mixed((rng.randint(1, 5), p)) for n, p in corners.items()} | {"i": u, "j": v}


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


def miquel(rng: random.Random) -> Position:
    found = {n: drawn(rng, 3) for n in "abcmij"}
    return found | {"r": between(rng, found["a"], found["b"])}


POSITIONS: Mapping[str, Callable[[random.Random], Position]] = {
    "brianchon": brianchon,
    "ceva": ceva,
    "conic": maclaurin,
    "desargues": lambda rng: without(perspective(rng, 3), "q"),
    "desargues-converse": desargues_converse,
    "desargues-space": lambda rng: sides(perspective(rng, 4)),
    "desargues-space-converse": desargues_space_converse,
    "double-six": double_six,
    "five-lines": five_lines,
    "gallucci": gallucci,
    "harmonic": harmonic,
    "hyperboloid": hyperboloid,
    "menelaus": menelaus,
    "midpoints": midpoints,
    "miquel": miquel,
    "moebius": moebius,
    "pappus": pappus,
    "pascal": pascal,
    "pencil": pencil,
    "pencil-converse": pencil_converse,
    "quadrangle": any_points("a b c d", 3),
    "quadrilateral-set": quadrilateral_set,
    "relations-3": any_points("a b c d e f", 3),
    "relations-4": any_points("a b c d e f g h", 4),
    "relations-5": any_points("a b c d e f g h i j", 5),
}


# --- the theorems there ---------------------------------------------------------------------------------------------


def script_of(name: str) -> Script:
    (path,) = (p for p in THEOREMS if p.stem == name)
    return parse_script(path.read_text(encoding="utf-8"), str(path))


def claims_of(script: Script) -> list[Claim]:
    return [s for s in script.statements if isinstance(s, Claim)]


def value(e: Expr, points: Position, rank: int) -> tuple[Fraction, ...]:
    return tuple(Fraction(c) for c in Evaluator(points, rank).value(e))


def open_points(e: Expr, points: Position, rank: int) -> Iterator[Position]:
    """Points that stand for all points run through a basis."""
    others = [n for n in points_of(e) if n not in points]
    basis = [vector(*(int(i == j) for j in range(rank))) for i in range(rank)]
    for chosen in combinations(basis, len(others)):
        yield points | dict(zip(others, chosen, strict=True))


def test_every_theorem_has_a_position() -> None:
    assert sorted(POSITIONS) == sorted(NAMES)


def holds_there(claim: Claim, assumed: Sequence[str], points: Position) -> bool:
    """Whether a claim was looked at: not where a finite point lies at infinity or what was assumed vanishes."""
    at = claim.context
    used = {n for a in at.given for e in a.args for n in points_of(e)} | {*points_of(claim.left, claim.right)}
    assert used <= set(points)
    for e in (e for a in at.given for e in equations(a, at.rank)):
        assert all(not any(value(e, p, at.rank)) for p in open_points(e, points, at.rank)), str(e)
    if any((points[n][-1] == 0) != (n in at.ideal) for n in used):
        return False
    if not all(any(value(parse(text, context=at), points, at.rank)) for text in assumed):
        return False
    left, right = value(claim.left, points, at.rank), value(claim.right, points, at.rank)
    assert left == right or not any((*left, *right))
    return True


@pytest.mark.parametrize("name", NAMES)
def test_theorem_at_positions_built_otherwise(name: str) -> None:
    script = script_of(name)
    results = run_script(script).claims
    for claim, result in zip(claims_of(script), results, strict=True):
        assert result.proof is not None
        drawn_from = (POSITIONS[name](random.Random(f"{name} {seed}")) for seed in range(8))
        assert sum(holds_there(claim, result.proof.assumed, points) for points in drawn_from) > 4


@pytest.mark.parametrize("name", ["brianchon", "pascal", "quadrangle", "five-lines", "conic", "desargues", "miquel"])
def test_first_claims_are_not_zero_on_both_sides_everywhere(name: str) -> None:
    """The identities that say "exactly if": in general position neither side is zero."""
    script = script_of(name)
    claim = claims_of(script)[0]
    assert not claim.context.given
    rng = random.Random(name)
    points = {n: drawn(rng, claim.context.rank) for n in points_of(claim.left, claim.right)}
    left, right = value(claim.left, points, claim.context.rank), value(claim.right, points, claim.context.rank)
    assert left == right
    assert any(left)


# --- what the scripts write out -------------------------------------------------------------------------------------


def test_a_conic_through_six_points_has_a_determinant_zero() -> None:
    """The bracket polynomial is the determinant of the six rows x², xy, xz, y², yz, z², up to its sign."""
    claim = claims_of(script_of("pascal"))[0]
    order = tableau_order(points_of(claim.right), (), ())
    ratios = set()
    for seed in range(5):
        points = {n: drawn(random.Random(f"{n}{seed}"), 3) for n in order}
        rows = [tuple(v[i] * v[j] for i in range(3) for j in range(i, 3)) for v in points.values()]
        (polynomial,) = value(claim.right, points, 3)
        ratios.add(polynomial / det(rows))
    assert len(ratios) == 1
    assert ratios <= {1, -1}


@pytest.mark.parametrize("name", ["five-lines", "false/five-lines"])
def test_determinants_of_moments(name: str) -> None:
    path = THEOREMS[0].parent / f"{name}.gca"
    script = parse_script(path.read_text(encoding="utf-8"))
    number = 5 if name == "five-lines" else 4
    points = {f"{n}{i}": drawn(random.Random(f"{n}{i}"), 4) for n in "ab" for i in range(1, number + 1)}
    lines = [(points[f"a{i}"], points[f"b{i}"]) for i in range(1, number + 1)]
    moments = [tuple(det([*k, *m]) for m in lines) for k in lines]
    assert value(script.context.bound["det"], points, 4) == (det(moments),)


def rank_of(rows: list[list[int]], modulus: int) -> int:
    rows, rank = [list(r) for r in rows], 0
    for j in range(len(rows[0])):
        at = next((i for i in range(rank, len(rows)) if rows[i][j] % modulus), None)
        if at is None:
            continue
        rows[rank], rows[at] = rows[at], rows[rank]
        inverse = pow(rows[rank][j], -1, modulus)
        for i in range(rank + 1, len(rows)):
            if rows[i][j] % modulus:
                factor = rows[i][j] * inverse
                rows[i] = [(x - factor * y) % modulus for x, y in zip(rows[i], rows[rank], strict=True)]
        rank += 1
    return rank


def test_of_sixteen_incidences_fifteen_force_the_last_and_fewer_force_none() -> None:
    """The gradients of the sixteen conditions [aa'bb'] = 0 at eight lines of a hyperboloid have one dependency, in
    which all take part: any fifteen are independent and span the last, any fourteen leave the other two free."""
    at = grid(random.Random(1))
    ones = [(at(i, 20), at(i, 30)) for i in range(4)]
    others = [(at(20, j), at(30, j)) for j in range(4)]
    gradients = []
    for i in range(4):
        for j in range(4):
            row = [0] * 64
            four = [*ones[i], *others[j]]
            for k in range(4):
                rest = cross(*(v for m, v in enumerate(four) if m != k))
                place = 8 * ([i, 4 + j][k // 2]) + 4 * (k % 2)
                row[place : place + 4] = [(-1) ** k * int(c) for c in rest]
            gradients.append(row)
    assert rank_of(gradients, PRIME) == 15
    assert all(rank_of([r for r in gradients if r is not g], PRIME) == 15 for g in gradients)
    for g, h in combinations(gradients, 2):
        assert rank_of([r for r in gradients if r is not g and r is not h], PRIME) == 14
