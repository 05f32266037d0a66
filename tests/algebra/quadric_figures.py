"""Quadrics by symmetric matrices modulo a prime, and claims about them with the truth.

Half of the quadrics have no lines with coordinates in the field: their determinants are no squares.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from random import Random
from typing import Any, ClassVar

from gcrules.algebra.evaluate import PRIME

__all__ = [
    "Figure",
    "SymmetricMatrix",
    "Vector",
    "combined",
    "determinant",
    "dot",
    "drawn_claim",
    "plane_through",
    "tower",
    "truths",
]

Vector = tuple[int, ...]


def dot(p: Sequence[int], q: Sequence[int]) -> int:
    return sum(x * y for x, y in zip(p, q, strict=True)) % PRIME


def determinant(rows: Sequence[Sequence[int]]) -> int:
    if len(rows) == 1:
        return rows[0][0] % PRIME
    minors = ([row[:i] + row[i + 1 :] for row in map(list, rows[1:])] for i in range(len(rows)))
    return sum((-1) ** i * rows[0][i] * determinant(m) for i, m in enumerate(minors)) % PRIME


def plane_through(*points: Sequence[int]) -> Vector:
    """The covector of the plane through three points."""
    return tuple((-1) ** i * determinant([[*p[:i], *p[i + 1 :]] for p in points]) % PRIME for i in range(4))


def combined(s: int, p: Sequence[int], t: int, q: Sequence[int]) -> Vector:
    return tuple((s * x + t * y) % PRIME for x, y in zip(p, q, strict=True))


@dataclass
class SymmetricMatrix:
    """A conic or a quadric by its matrix, which subclasses make; points have as many coordinates."""

    rng: Random
    matrix: list[list[int]] = field(init=False)
    size: ClassVar[int]

    def random(self) -> Vector:
        return tuple(self.rng.randrange(1, PRIME) for _ in range(self.size))

    def polar(self, p: Sequence[int]) -> Vector:
        return tuple(dot(row, p) for row in self.matrix)

    def form(self, p: Sequence[int]) -> int:
        return dot(p, self.polar(p))

    def second(self, p: Vector, a: Vector) -> Vector:
        """The second point of a line through a point that is on it."""
        return combined(2 * dot(p, self.polar(a)), p, -self.form(p), a)


@dataclass
class Figure(SymmetricMatrix):
    """A quadric and points; `on` are those on the quadric, `conjugate` those on the polar plane of another one."""

    on: tuple[str, ...] = ()
    conjugate: dict[str, str] = field(default_factory=dict)
    square: bool = True
    size = 4

    def __post_init__(self) -> None:
        self.matrix = self._symmetric()
        while (pow(determinant(self.matrix), (PRIME - 1) // 2, PRIME) == 1) is not self.square:
            self.matrix = self._symmetric()
        self.points: dict[str, Vector] = {}
        for name in "abcdef":
            if name in self.on:
                self.points[name] = self.on_it()
            elif name in self.conjugate:
                h = self.polar(self.points[self.conjugate[name]])
                p, q = self.random(), self.random()
                self.points[name] = combined(dot(h, q), p, -dot(h, p), q)
            else:
                self.points[name] = self.random()

    def _symmetric(self) -> list[list[int]]:
        """With a point that is on the quadric."""
        m = [[self.rng.randrange(PRIME) for _ in range(4)] for _ in range(4)]
        m = [[(m[i][j] + m[j][i]) % PRIME for j in range(4)] for i in range(4)]
        self._start = self.random()
        rest = dot(self._start, [dot(row, self._start) for row in m]) - m[0][0] * self._start[0] ** 2
        m[0][0] = -rest * pow(self._start[0] ** 2, -1, PRIME) % PRIME
        return m

    def pole(self, plane: Sequence[int]) -> Vector:
        """By the adjugate of the matrix."""
        return tuple(sum((-1) ** (i + j) * plane[j] * self._minor(j, i) for j in range(4)) % PRIME for i in range(4))

    def _minor(self, i: int, j: int) -> int:
        return determinant([[*row[:j], *row[j + 1 :]] for k, row in enumerate(self.matrix) if k != i])

    def on_it(self) -> Vector:
        """A point of the quadric."""
        return self.second(self.random(), self._start)


Thing = tuple[str, Any]  # text, and how it is made: a name, or a word and things


def point_of(thing: Thing, at: Figure) -> Vector:
    """The coordinates of a point."""
    _, how = thing
    if isinstance(how, str):
        return at.points[how]
    word, *parts = how
    if word == "pole":
        return at.pole(plane_of(parts[0], at))
    if word == "second":
        return at.second(point_of(parts[0], at), at.points[parts[1]])
    p, q, plane = point_of(parts[0], at), point_of(parts[1], at), plane_of(parts[2], at)
    return combined(dot(plane, q), p, -dot(plane, p), q)


def plane_of(thing: Thing, at: Figure) -> Vector:
    """The covector of a plane."""
    _, (word, *parts) = thing
    points = [point_of(part, at) for part in parts]
    return plane_through(*points) if word == "join" else at.polar(points[0])


def _name(rng: Random, names: str) -> Thing:
    found = rng.choice(names)
    return found, found


def point(rng: Random, names: str, on: tuple[str, ...], depth: int) -> Thing:
    kind = rng.randrange(4) if depth else 0
    if kind == 1:
        face = plane(rng, names, on, depth - 1)
        return f"pole({face[0]}, Q)", ("pole", face)
    if kind == 2:
        (p, q), face = rng.sample(names, 2), plane(rng, names, on, depth - 1)
        return f"({p}{q} /\\ {face[0]})", ("meet", (p, p), (q, q), face)
    if kind == 3 and on:
        other, a = point(rng, names, on, depth - 1), rng.choice(on)
        return f"second_on_quadric({other[0]}, {a}, Q)", ("second", other, a)
    return _name(rng, names)


def plane(rng: Random, names: str, on: tuple[str, ...], depth: int) -> Thing:
    kind = rng.randrange(3)
    if kind == 0 and on:
        a = rng.choice(on)
        return f"tangent({a}, Q)", ("tangent", (a, a))
    if kind == 1 or len(names) < 3:
        p = point(rng, names, on, depth)
        return f"polar({p[0]}, Q)", ("polar", p)
    some = rng.sample(names, 3)
    return f"({''.join(some)})", ("join", *((n, n) for n in some))


def meets_polar(at: Figure, one: str, other: str) -> bool:
    """Whether a line meets the polar line of another one: it has a point on the polar planes of two points of that."""
    return determinant([[dot(at.points[p], at.polar(at.points[q])) for p in other] for q in one]) == 0


def drawn_claim(rng: Random, names: str, on: tuple[str, ...]) -> tuple[str, Callable[[Figure], bool]]:
    """A claim, and whether it holds in a figure."""
    kind = rng.randrange(5)
    if kind == 0:
        thing = point(rng, names, on, 1)
        return f"incident({thing[0]}, Q)", lambda at: at.form(point_of(thing, at)) == 0
    if kind == 1:
        one, face = point(rng, names, on, 1), plane(rng, names, on, 1)
        return f"incident({one[0]}, {face[0]})", lambda at: dot(point_of(one, at), plane_of(face, at)) == 0
    if kind == 2:
        four = [point(rng, names, on, 1) for _ in range(4)]
        text = f"[{', '.join(t[0] for t in four)}] == 0"
        return text, lambda at: determinant([point_of(t, at) for t in four]) == 0
    if kind == 3:
        side = plane(rng, names, on, 1)
        return f"touches({side[0]}, Q)", lambda at: dot(at.pole(plane_of(side, at)), plane_of(side, at)) == 0
    pq, rs = ("".join(rng.sample(names, 2)) for _ in range(2))
    if rng.randrange(3) == 0:
        return f"touches({pq}, Q)", lambda at: meets_polar(at, pq, pq)
    return f"[{rs} polar({pq}, Q)] == 0", lambda at: meets_polar(at, pq, rs)


# --- points one after the other --------------------------------------------------------------------------------------

WORDS: Mapping[str, str] = {
    "free": "",
    "on": "incident({x}, Q)",
    "on a line of Q": "incident({x}, Q), incident({x}, polar({0}, Q))",
    "polar": "incident({x}, polar({0}, Q))",
    "line": "incident({x}, {0}{1})",
    "polar line": "incident({x}, polar({0}{1}, Q))",
    "plane": "incident({x}, {0}{1}{2})",
}
Tower = Mapping[str, tuple[str, Sequence[str]]]


def tower(rng: Random) -> Tower:
    """What is given of each point, by those before it."""
    found: dict[str, tuple[str, Sequence[str]]] = {}
    for i, name in enumerate("abcde"[: rng.randrange(3, 6)]):
        before = "abcde"[:i]
        on = [n for n in before if found[n][0].startswith("on")]
        words = ["free", "on", "on", *["on a line of Q"] * bool(on), *["polar"] * bool(i)]
        words += [*["line", "line", "polar line"] * (i > 1), *["plane"] * (i > 2)]
        word = rng.choice(words)
        number = sum(f"{{{k}}}" in WORDS[word] for k in range(3))
        found[name] = word, rng.sample(on if word == "on a line of Q" else before, number)
    return found


def placed(given: Tower, rng: Random, square: bool) -> Figure:
    """A quadric and points for which a tower holds; square where there are lines."""
    at = Figure(rng, square=square or any(word == "on a line of Q" for word, _ in given.values()))
    at.points = {}
    for name, (word, names) in given.items():
        others = [at.points[n] for n in names]
        at.points[name] = _PLACES[word](at, others)
    return at


def _any_of(at: Figure, points: Sequence[Vector]) -> Vector:
    found: Vector = (0, 0, 0, 0)
    for p in points:
        found = combined(1, found, at.rng.randrange(1, PRIME), p)
    return found


def _in_plane(at: Figure, plane: Sequence[int]) -> Vector:
    p, q = at.random(), at.random()
    return combined(dot(plane, q), p, -dot(plane, p), q)


def _on_line_of_quadric(at: Figure, a: Vector) -> Vector:
    """Where a line of the tangent plane at a meets one of the two lines through a."""
    u, v = _in_plane(at, at.polar(a)), _in_plane(at, at.polar(a))
    one, both, other = at.form(u), dot(u, at.polar(v)), at.form(v)
    root = pow(both * both - one * other, (PRIME + 1) // 4, PRIME)
    return combined((root - both) * pow(one, -1, PRIME) % PRIME, u, 1, v)


_PLACES: Mapping[str, Callable[[Figure, Sequence[Vector]], Vector]] = {
    "free": lambda at, _: at.random(),
    "on": lambda at, _: at.on_it(),
    "on a line of Q": lambda at, others: _on_line_of_quadric(at, others[0]),
    "polar": lambda at, others: _in_plane(at, at.polar(others[0])),
    "line": _any_of,
    "polar line": lambda at, others: plane_through(*map(at.polar, others), at.random()),
    "plane": _any_of,
}


def truths(given: Tower, holds: Callable[[Figure], bool], rng: Random) -> list[bool]:
    """Whether a claim holds at some positions, of quadrics with lines and of others."""
    return [holds(placed(given, rng, square)) for square in (True, False, True, False)]
