"""Discoveries about quadrics that are letters, against quadrics by symmetric matrices modulo a prime.

As for conics, constructions are drawn at random, and everything that holds of their points, lines and planes is counted
here: each is discovered or trivial, and what is proved holds.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import combinations
from random import Random
from typing import Any

import pytest
from algebra.discovery_claims import check_all, place
from algebra.quadric_figures import Figure, Vector, combined, determinant, dot, plane_through

import gcrules as gc
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.letters import marks_in
from gcrules.core.errors import InputError

Line = tuple[Vector, Vector]


def plucker(line: Line) -> Vector:
    p, q = line
    return tuple((p[i] * q[j] - p[j] * q[i]) % PRIME for i, j in combinations(range(4), 2))


def pierced(line: Line, plane: Vector) -> Vector:
    p, q = line
    return combined(dot(plane, q), p, -dot(plane, p), q)


def coplanar(*four: Vector) -> bool:
    return not determinant(list(four))


class Drawing:
    """Points, lines and planes of a construction, each with its place."""

    def __init__(self, seed: int) -> None:
        self.rng = Random(seed)
        self.quadric = Figure(self.rng, on=("a", "b", "c"), square=bool(seed % 2))
        self.points: dict[str, Vector] = {n: place(self.quadric.points[n]) for n in "abcd"}
        self.lines: dict[str, Line] = {}
        self.planes: dict[str, Vector] = {}
        self.on = ["a", "b", "c"]
        self.text = "quadric Q\ngiven on_quadric(a, b, c, Q)\npoints a b c d\n"

    def add(self, name: str, text: str, value: Any) -> None:
        if not any(x % PRIME for x in (plucker(value) if name in "lmn" else value)):
            return
        self.text += f"let {name} = {text}\n"
        if name in "lmn":
            self.lines[name] = value
        else:
            (self.planes if name in "PRS" else self.points)[name] = place(value)

    def some(self, number: int) -> tuple[str, list[Vector]]:
        names = self.rng.sample(sorted(self.points), number)
        return "".join(names), [self.points[n] for n in names]

    def plane(self) -> tuple[str, Vector]:
        if self.planes and self.rng.random() < 0.6:
            return self.rng.choice(sorted(self.planes.items()))
        text, three = self.some(3)
        return text, plane_through(*three)

    def met(self, one: Vector, other: Vector) -> Line:
        """Two points of the line of two planes: with planes of random points, by the rule for three planes."""
        p, q = (plane_through(one, other, self.quadric.random()) for _ in range(2))
        return p, q

    def step(self, name: str) -> None:
        rng, Q = self.rng, self.quadric
        if name in "PRS":
            p = rng.choice(sorted(self.points))
            self.add(name, f"{'tangent' if p in self.on else 'polar'}({p}, Q)", Q.polar(self.points[p]))
        elif name in "lmn":
            if rng.random() < 0.5:
                text, two = self.some(2)
                polars = (Q.polar(p) for p in two)
                self.add(name, f"polar({text}, Q)", self.met(*polars))
            else:
                (one, P), (other, R) = self.plane(), self.plane()
                self.add(name, f"{one} /\\ {other}", self.met(P, R))
        else:
            self.point(name)

    def point(self, name: str) -> None:
        rng, Q = self.rng, self.quadric
        kind = rng.choice(["meet", "second", "pole", "meet"])
        if kind == "meet":
            (one, line), (other, plane) = self.some(2), self.plane()
            self.add(name, f"{one} /\\ {other}", pierced((line[0], line[1]), plane))
        elif kind == "pole":
            one, plane = self.plane()
            self.add(name, f"pole({one}, Q)", Q.pole(plane))
        else:
            a, p = rng.choice(self.on), rng.choice(sorted({*self.points} - {*self.on}))
            self.add(name, f"second_on_quadric({p}, {a}, Q)", Q.second(self.points[p], self.points[a]))
            self.on += [name] if name in self.points else []


# --- what holds ------------------------------------------------------------------------------------------------------


def touches(line: Line, at: Drawing) -> bool:
    """Where the form has a double zero on a line."""
    p, q = line
    Q = at.quadric
    return not (dot(p, Q.polar(q)) ** 2 - Q.form(p) * Q.form(q)) % PRIME


def counted(at: Drawing) -> dict[str, int]:
    firsts: dict[Vector, str] = {}
    for n, v in at.points.items():
        firsts.setdefault(v, n)
    points, Q = {n: v for v, n in firsts.items()}, at.quadric
    through: dict[Vector, Line] = {}
    members: dict[Vector, set[str]] = {}
    for p, q in combinations(points, 2):
        key = place(plucker((points[p], points[q])))
        through.setdefault(key, (points[p], points[q]))
        members.setdefault(key, set()).update((p, q))
    lines = through | {place(plucker(line)): line for line in at.lines.values()}
    meets: dict[Vector, set[Vector]] = {}
    for (k, one), (h, other) in combinations(lines.items(), 2):
        if coplanar(*one, *other):
            meets.setdefault(common(one, other, at), set()).update((k, h))
    planes: set[frozenset[str]] = set()
    for three in combinations(points, 3):
        if any(len(on.intersection(three)) > 2 for on in members.values()):
            continue
        inside = frozenset(n for n in points if coplanar(*(points[m] for m in three), points[n]))
        if len(inside) > 3 and not any(len(on & inside) >= len(inside) - 1 and len(on) > 2 for on in members.values()):
            planes.add(inside)
    on_line = [any(coplanar_line(line, v) for v in points.values()) for line in at.lines.values()]
    conjugate = [any(q != p and not dot(points[q], Q.polar(points[p])) for q in points) for p in points]
    return {
        "collinear": sum(len(on) > 2 for on in members.values()),
        "incident": sum(on_line) + sum(any(not dot(P, v) for v in points.values()) for P in at.planes.values()),
        "equal": sum([*at.points.values()].count(v) > 1 for v in firsts),
        "concurrent": sum(len(some) > 2 and v not in firsts for v, some in meets.items()),
        "coplanar": len(planes),
        "on_quadric": int(any(not Q.form(v) for v in points.values())),
        "touches": sum(not dot(P, Q.pole(P)) for P in at.planes.values())
        + sum(touches(line, at) for line in at.lines.values()),
        "polar": sum(place(Q.polar(v)) == P for v in points.values() for P in at.planes.values()),
        "conjugate": sum(conjugate),
    }


def coplanar_line(line: Line, p: Vector) -> bool:
    """Whether a point is on a line."""
    rows = (*line, p)
    return not any(x % PRIME for x in plane_through(*rows))


def common(one: Line, other: Line, at: Drawing) -> Vector:
    """The point of two lines that are in a plane."""
    return place(pierced(one, plane_through(*other, at.quadric.random())))


def holding(at: Drawing, word: str, args: Sequence[str]) -> bool:
    """What one word says, of the names in it."""
    Q = at.quadric
    first, last = args[0], args[-1]
    if word == "touches":
        plane = at.planes.get(first)
        return not dot(plane, Q.pole(plane)) if plane else touches(at.lines[first], at)
    if word == "incident" and len(args) == 3:
        polar = Q.polar(at.points[args[1]])
        return place(polar) == at.planes[first] if first in at.planes else not dot(polar, at.points[first])
    if last == "Q":
        return not any(Q.form(at.points[n]) for n in args[:-1])
    if word == "incident":
        on = at.planes.get(last)
        return not dot(on, at.points[first]) if on else coplanar_line(at.lines[last], at.points[first])
    if word == "coplanar":
        return all(coplanar(*(at.points[n] for n in four)) for four in combinations(args, 4))
    if word == "collinear":
        p, q, *others = (at.points[n] for n in args)
        return all(coplanar_line((p, q), r) for r in others)
    lines = [at.lines[n] if n in at.lines else (at.points[n[0]], at.points[n[1]]) for n in args]
    return len({common(lines[0], line, at) for line in lines[1:]}) == 1


@pytest.mark.parametrize("seed", range(24))
def test_all_that_holds_is_discovered_or_trivial(seed: int) -> None:
    """Of a random construction, with everything of each kind counted by brute force."""
    at = Drawing(seed)
    for name in at.rng.sample("xyzuPRlm", 5):
        at.step(name)
    check_all(at.text, counted(at), at.points, (*at.lines, *at.planes), partial(holding, at))


# --- theorems --------------------------------------------------------------------------------------------------------

SECANTS = r"""quadric Q
given on_quadric(a, b, Q)
let c = second_on_quadric(p, a, Q)
let d = second_on_quadric(p, b, Q)
let x = ab /\ cdq
let P = polar(p, Q)
"""
TRIVIAL = r"""quadric Q
plane P R
given touches(P, Q), touches(R, Q), on_quadric(a, b, Q), incident(b, polar(a, Q)), incident(c, ab)
let l = P /\ R
let p = pole(P, Q)
let r = pole(R, Q)
let m = polar(pr, Q)
let t = tangent(a, Q)
let u = polar(c, Q)
let n = t /\ cde
let s = pole(u, Q)
"""
HESSE = r"""quadric Q
given [ab polar(cd, Q)] == 0, [ac polar(bd, Q)] == 0
let x = pole(bcd, Q)
let y = pole(acd, Q)
"""


def test_secants_through_a_point() -> None:
    """The lines ab and cd meet in a point of the polar plane of p."""
    found = gc.discover(SECANTS)
    assert [d.claim for d in found.found] == ["collinear(c, d, x)", "incident(x, P)"]
    assert found.verdict == "proved"
    assert found.conics == ("Q",)
    assert all("second_on_quadric" in e for e in found.kinds[0].assumed)


def test_what_follows_from_polarity_is_trivial() -> None:
    found = gc.discover(TRIVIAL)
    assert found.found == ()
    assert set(found.flats) == {*"PRlmtun"}
    assert found.trivial > 15


def test_what_cannot_be_said_without_the_corners_is_undecided() -> None:
    found = gc.discover(HESSE, limit=20_000, seconds=0)
    assert [(d.claim, d.verdict) for d in found.found] == [("coplanar(a, b, x, y)", "undecided")]
    assert found.found[0].reason.endswith("that cannot be said without the corners of Q")
    assert found.verdict == "undecided"
    assert not marks_in(str(found.to_json()))


def test_assumptions_that_are_not_resolved_name_the_letter() -> None:
    given = "on_quadric(a, b, c, d, Q), coplanar(a, b, c, d), on_quadric(e, f, g, Q), coplanar(d, e, f, g)"
    with pytest.raises(InputError) as raised:
        gc.discover(f"quadric Q given {given}")
    assert not marks_in(raised.value.message)
