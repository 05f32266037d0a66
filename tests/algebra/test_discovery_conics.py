"""Discoveries about conics that are letters, against conics by symmetric matrices modulo a prime.

Constructions are drawn at random, computed here without the engine, and everything that holds of their points and lines
is counted: each is discovered or trivial, and what is proved holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from random import Random

import pytest
from algebra.conic_figures import Figure, cross
from algebra.quadric_figures import Vector, determinant, dot

import gcrules as gc
from gcrules.algebra.evaluate import PRIME

Names = tuple[str, ...]


def place(v: Sequence[int]) -> Vector:
    """The multiple that begins with 1."""
    lead = pow(next(x for x in v if x % PRIME), -1, PRIME)
    return tuple(x * lead % PRIME for x in v)


def squares(p: Vector) -> Vector:
    x, y, z = p
    return (x * x, y * y, z * z, x * y, x * z, y * z)


class Drawing:
    """Points and lines of a construction, each with its place and, if it is not free, with its text."""

    def __init__(self, seed: int, on: Names = ("a", "b", "c"), free: Names = ("d", "e")) -> None:
        self.rng = Random(seed)
        self.conic = Figure(self.rng, on=on)
        self.points: dict[str, Vector] = {n: place(self.conic.points[n]) for n in (*on, *free)}
        self.lines: dict[str, Vector] = {}
        self.on = list(on)
        self.text = f"rank 3\nconic K\ngiven on_conic({', '.join(on)}, K)\npoints {' '.join(self.points)}\n"

    def add(self, name: str, text: str, value: Sequence[int]) -> None:
        if any(x % PRIME for x in value):
            self.text += f"let {name} = {text}\n"
            (self.lines if name in "lmn" else self.points)[name] = place(value)

    def line(self) -> tuple[str, Vector]:
        """A line that is at hand: a name, or the join of two points."""
        if self.lines and self.rng.random() < 0.5:
            return self.rng.choice(list(self.lines.items()))
        p, q = self.rng.sample(sorted(self.points), 2)
        return f"{p}{q}", cross(self.points[p], self.points[q])

    def step(self, name: str) -> None:
        """One more point, or one more line."""
        rng, K = self.rng, self.conic
        if name in "lmn":
            p = rng.choice(sorted(self.points))
            word = "tangent" if p in self.on else "polar"
            self.add(name, f"{word}({p}, K)", K.polar(self.points[p]))
            return
        kind = rng.choice(["meet", "meet", "second", "pole"])
        (one, s), (other, t) = self.line(), self.line()
        if kind == "meet" and one != other:
            self.add(name, f"{one} /\\ {other}", cross(s, t))
        elif kind == "pole":
            self.add(name, f"pole({one}, K)", K.pole(s))
        elif kind == "second" and (off := sorted({*self.points} - {*self.on})):
            a, p = rng.choice(self.on), rng.choice(off)
            self.add(name, f"second_on_conic({p}, {a}, K)", K.second(self.points[p], self.points[a]))
            self.on += [name] if name in self.points else []


# --- what holds ------------------------------------------------------------------------------------------------------


def counted(at: Drawing) -> dict[str, int]:
    """How many lines, places, conics, … with more on them than everything has."""
    firsts: dict[Vector, str] = {}
    for n, v in at.points.items():
        firsts.setdefault(v, n)
    points = {n: v for v, n in firsts.items()}
    K = at.conic
    through: dict[Vector, set[str]] = {}
    for p, q in combinations(points, 2):
        through.setdefault(place(cross(points[p], points[q])), set()).update((p, q))
    lines = {*through, *at.lines.values()}
    meets: dict[Vector, set[Vector]] = {}
    for one, other in combinations(lines, 2):
        meets.setdefault(place(cross(one, other)), set()).update((one, other))
    conjugate = {p: [q for q in points if q != p and not dot(points[q], K.polar(points[p]))] for p in points}
    on_conic = {n for n in points if not K.form(points[n])}
    touching = [v for v in (*at.lines.values(), *({*through} - {*at.lines.values()})) if not dot(v, K.pole(v))]
    return {
        "collinear": sum(len(names) > 2 for names in through.values()),
        "incident": sum(any(not dot(v, p) for p in points.values()) for v in at.lines.values()),
        "equal": sum(list(at.points.values()).count(v) > 1 for v in firsts),
        "concurrent": sum(len(some) > 2 and v not in firsts for v, some in meets.items()),
        "on_conic": len({*conics(points, through), *([frozenset(on_conic)] if on_conic else [])}),
        "touches": len(touching),
        "polar": sum(place(K.polar(p)) == v for p in points.values() for v in at.lines.values()),
        "conjugate": sum(map(bool, conjugate.values())),
    }


def conics(points: dict[str, Vector], through: dict[Vector, set[str]]) -> Iterator[frozenset[str]]:
    """The points on each conic through six or more of them that is no pair of lines."""
    for five in combinations(points, 5):
        if any(len(names.intersection(five)) > 2 for names in through.values()):
            continue
        rows = [squares(points[n]) for n in five]
        more = {n for n in points if n not in five and not determinant([*rows, squares(points[n])])}
        if more:
            yield frozenset({*five, *more})


# --- what is said ----------------------------------------------------------------------------------------------------


def holds(claim: str, at: Drawing) -> bool:
    """What a discovery says, at the places of a drawing."""
    if claim.endswith(" == 0"):
        return all(len({at.points[n] for n in part.split()[0]}) == 1 for part in claim.split(", "))
    return all(holding(part, at) for part in claim.replace("), incident", ")|incident").split("|"))


def holding(claim: str, at: Drawing) -> bool:
    word, _, rest = claim.removesuffix(")").partition("(")
    args, K = rest.replace("polar(", "").replace(")", "").split(", "), at.conic
    *names, last = args
    if word == "incident" and len(args) == 3:
        value = at.points.get(args[0]) or at.lines[args[0]]
        polar = K.polar(at.points[args[1]])
        return place(polar) == value if args[0] in at.lines else not dot(value, polar)
    if word == "touches":
        return not dot(found_line(args[0], at), K.pole(found_line(args[0], at)))
    if word in ("incident", "on_conic") and last == "K":
        return not any(K.form(at.points[n]) for n in names)
    if word == "incident":
        return not dot(at.points[args[0]], at.lines[last])
    if word == "on_conic":
        rows = [squares(at.points[n]) for n in args]
        return all(not determinant(list(six)) for six in combinations(rows, 6))
    rows = [at.points[n] if word == "collinear" else found_line(n, at) for n in args]
    return all(not determinant(list(three)) for three in combinations(rows, 3))


def found_line(told: str, at: Drawing) -> Vector:
    return at.lines[told] if told in at.lines else cross(*(at.points[n] for n in told))


@pytest.mark.parametrize("seed", range(24))
def test_all_that_holds_is_discovered_or_trivial(seed: int) -> None:
    """Of a random construction, with everything of each kind counted by brute force."""
    at = Drawing(seed)
    for name in at.rng.sample("xyzuvlm", 5):
        at.step(name)
    found = gc.discover(at.text, limit=5_000, seconds=0)
    assert set(found.points) == set(at.points)
    assert set(found.flats) == set(at.lines)
    assert len(found.found) + found.trivial == sum(counted(at).values()), (at.text, counted(at))
    for d in found.found:
        assert holds(d.claim, at), (d.claim, at.text)
