"""Discoveries about lines and planes as letters, against lines that are drawn here, in whole numbers."""

from __future__ import annotations

import random
from itertools import combinations

import pytest

import gcrules as gc
from gcrules.core.errors import LimitReached

Vector = tuple[int, ...]

DUAL_PAPPUS = r"""rank 3
line A B C A' B' C'
given concurrent(A, B, C), concurrent(A', B', C')
let x = (B /\ C') (B' /\ C)
let y = (C /\ A') (C' /\ A)
let z = (A /\ B') (A' /\ B)
"""
TRANSVERSAL = r"""rank 3
line L
let x = ab /\ L
let y = bc /\ L
let z = ac /\ L
let p = ay /\ bz
let q = ay /\ cx
let r = bz /\ cx
"""
IN_A_PLANE = r"""rank 4
plane P
line L M
given incident(a, L), incident(a, M), concurrent(L, bc)
let l = L /\ P
let m = M /\ P
let n = bc /\ P
"""


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def det(a: Vector, b: Vector, c: Vector) -> int:
    return sum(x * y for x, y in zip(a, cross(b, c), strict=True))


def vector(seed: random.Random) -> Vector:
    return tuple(seed.randint(-99, 99) for _ in range(3))


def pencil(seed: random.Random) -> list[Vector]:
    """Three lines through a point: dependent rows."""
    a, b = vector(seed), vector(seed)
    return [a, b, tuple(3 * x - 5 * y for x, y in zip(a, b, strict=True))]


def concurrent_by_hand(lines: dict[str, Vector]) -> set[frozenset[str]]:
    return {frozenset(some) for some in combinations(lines, 3) if not det(*(lines[n] for n in some))}


def claims(found: gc.Discoveries, relation: str) -> list[frozenset[str]]:
    return [frozenset(d.names) for d in found.found if d.relation == relation]


def test_dual_of_pappus() -> None:
    """All triples of the nine lines: those that are not given or meant are discovered, and no other."""
    found = gc.discover(DUAL_PAPPUS)
    assert found.points == ()
    assert set(found.flats) == {*"ABCxyz", "A'", "B'", "C'"}
    for round_ in range(3):
        seed = random.Random(round_)
        lines = dict(zip(["A", "B", "C", "A'", "B'", "C'"], [*pencil(seed), *pencil(seed)], strict=True))
        for name, (one, other) in {"x": "BC", "y": "CA", "z": "AB"}.items():
            p, q = cross(lines[one], lines[f"{other}'"]), cross(lines[f"{one}'"], lines[other])
            lines[name] = cross(p, q)
        meant = {frozenset({name, one, f"{other}'"}) for name, pair in zip("xyz", ("BC", "CA", "AB"), strict=True)
                 for one, other in (pair, pair[::-1])}  # fmt: skip
        given = {frozenset("ABC"), frozenset({"A'", "B'", "C'"})}
        assert concurrent_by_hand(lines) - given - meant == set(claims(found, "concurrent"))
    (discovery,) = found.found
    assert (discovery.claim, discovery.verdict) == ("concurrent(x, y, z)", "proved")


def test_what_is_assumed_names_letters_only() -> None:
    """The points that a letter joins have no name that anybody could read."""
    found = gc.discover(DUAL_PAPPUS)
    assert found.kinds[0].assumed == ("A' /\\ B'", "A /\\ B")
    assert not any(mark in str(found.to_json()) for mark in "₁₂₃")


def test_what_a_choice_of_the_points_of_a_letter_avoids_is_not_assumed() -> None:
    """Of two planes through c two points each can be chosen that are not on a line with c."""
    found = gc.discover(
        r"rank 4  plane P Q R  given incident(c, Q), incident(c, P)"
        r"  let m = P /\ Q  let n = Q /\ R  let k = P /\ R"
    )
    assert [d.claim for d in found.found] == ["concurrent(m, n, k)"]
    assert found.kinds[0].assumed == ()


def test_a_line_through_the_sides_of_a_triangle() -> None:
    """Each discovery holds in a drawing; the points of the letter are not among what is looked at."""
    found = gc.discover(TRANSVERSAL)
    assert found.points == tuple("abcxyzpqr")
    assert found.flats == ("L",)
    for round_ in range(3):
        seed = random.Random(round_)
        at = {n: vector(seed) for n in "abc"}
        line = vector(seed)
        for name, (s, t) in {"x": "ab", "y": "bc", "z": "ac"}.items():
            at[name] = cross(cross(at[s], at[t]), line)
        for name, (s, t, u, v) in {"p": "aybz", "q": "aycx", "r": "bzcx"}.items():
            at[name] = cross(cross(at[s], at[t]), cross(at[u], at[v]))
        three = {
            frozenset({frozenset(s + t) for s, t in some})
            for some in combinations(combinations(sorted(at), 2), 3)
            if len({n for pair in some for n in pair}) == 6 and not det(*(cross(at[s], at[t]) for s, t in some))
        }
        told = {
            frozenset(frozenset(line) for line in d.claim.removeprefix("concurrent(")[:-1].split(", "))
            for d in found.found
        }
        assert told <= three
        assert len(told) == 4


def test_in_space() -> None:
    """The lines through a, and bc, meet the plane in points; nothing more holds but what is given."""
    found = gc.discover(IN_A_PLANE)
    assert set(found.points) == set("abclmn")
    assert set(found.flats) == {"P", "L", "M"}
    assert found.found == ()
    assert found.trivial > 0


def test_points_of_letters_are_not_counted() -> None:
    """Four lines are four lines, not eight points more."""
    with pytest.raises(LimitReached, match="4 points and 2 named lines and planes"):
        gc.discover("rank 3  line L M  given collinear(a, b, c), incident(d, L)", candidates=10)
    assert gc.discover("rank 3  line L M  given collinear(a, b, c)").candidates < 20
