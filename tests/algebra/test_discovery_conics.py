"""Discoveries about conics that are letters, against conics by symmetric matrices modulo a prime.

Constructions are drawn at random, computed here without the engine, and everything that holds of their points and lines
is counted: each is discovered or trivial, and what is proved holds.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations
from random import Random

import pytest
from algebra.conic_figures import Figure, cross
from algebra.discovery_claims import check_all, place
from algebra.quadric_figures import Vector, determinant, dot
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.decide import decide
from gcrules.algebra.discovery.discover import discover
from gcrules.algebra.discovery.tangents import tangents
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.letters import marks_in

Names = tuple[str, ...]


def squares(p: Vector) -> Vector:
    x, y, z = p
    return (x * x, y * y, z * z, x * y, x * z, y * z)


class Drawing:
    """Points and lines of a construction, each with its place and, if it is not free, with its text."""

    def __init__(self, seed: int, on: Names, free: Names) -> None:
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
    """The points on each conic through six or more of them that is not a pair of lines."""
    for five in combinations(points, 5):
        if any(len(names.intersection(five)) > 2 for names in through.values()):
            continue
        rows = [squares(points[n]) for n in five]
        more = {n for n in points if n not in five and not determinant([*rows, squares(points[n])])}
        if more:
            yield frozenset({*five, *more})


# --- what is said ----------------------------------------------------------------------------------------------------


def holding(at: Drawing, word: str, args: Sequence[str]) -> bool:
    """What one word says, of the names in it."""
    K = at.conic
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


@pytest.mark.parametrize("seed", range(32))
def test_all_that_holds_is_discovered_or_trivial(seed: int) -> None:
    """Of a random construction, with everything of each kind counted by brute force."""
    at = Drawing(seed, ("a", "b", "c"), ("d",)) if seed % 2 else Drawing(seed, ("a", "b", "c", "d"), ())
    for name in at.rng.sample("xyzuvlm", 6):
        at.step(name)
    check_all(at.text, counted(at), at.points, at.lines, partial(holding, at))


# --- theorems --------------------------------------------------------------------------------------------------------

HEXAGON = r"let x = ab /\ de  let y = bc /\ ef  let z = cd /\ fa"
DIAGONALS = r"let p = (A /\ B) \/ (D /\ E)  let q = (B /\ C) \/ (E /\ F)  let r = (C /\ D) \/ (F /\ A)"
THEOREMS = {
    "Pascal": (f"given on_conic(a, b, c, d, e, f, K) {HEXAGON}", ["collinear(x, y, z)"]),
    "Braikenridge and Maclaurin": (
        r"given on_conic(a, b, c, d, e, K)  let x = ab /\ de  let y = bc /\ pe  let z = cd /\ xy  let f = az /\ ep",
        ["incident(f, K)"],
    ),
    "Brianchon": (
        f"line A B C D E F  given {', '.join(f'touches({n}, K)' for n in 'ABCDEF')} {DIAGONALS}",
        ["concurrent(p, q, r)"],
    ),
    "the diagonal triangle": (
        r"given on_conic(a, b, c, d, K)  let x = ab /\ cd  let y = ac /\ bd  let z = ad /\ bc",
        ["incident(y, polar(x, K)), incident(z, polar(x, K))", "incident(z, polar(y, K))"],
    ),
    "Chasles": (
        "let p = pole(bc, K)  let q = pole(ca, K)  let r = pole(ab, K)",
        ["concurrent(ap, bq, cr)"],
    ),
    "von Staudt": (
        r"given on_conic(a, b, c, K)  let p = pole(bc, K)  let x = dp /\ ab  let y = dp /\ ac",
        ["incident(y, polar(x, K))"],
    ),
    "a triangle and its tangents": (
        r"given on_conic(a, b, c, K)  let x = bc /\ tangent(a, K)  let y = ca /\ tangent(b, K)"
        r"  let z = ab /\ tangent(c, K)",
        ["collinear(x, y, z)"],
    ),
    "a self-polar triangle": (
        r"given incident(b, polar(a, K))  let c = polar(a, K) /\ polar(b, K)  let p = polar(c, K)",
        [],
    ),
}


@pytest.mark.parametrize(("text", "claims"), THEOREMS.values(), ids=THEOREMS)
def test_theorems(text: str, claims: list[str]) -> None:
    """Each is found once, proved, and has no other beside it."""
    found = gc.discover(f"rank 3 conic K {text}")
    assert [d.claim for d in found.found] == claims
    assert {d.verdict for d in found.found} <= {"proved"}
    assert found.conics == ("K",)
    assert not marks_in(str(found.to_json()))
    assert "~" not in str(found.to_json())


TRIVIAL = r"""rank 3 conic K line L given on_conic(a, b, K), touches(L, K)
let t = tangent(a, K)  let u = tangent(b, K)  let p = pole(ab, K)  let q = t /\ u  let s = pole(L, K)
let l = polar(c, K)  let m = polar(d, K)  let x = pole(cd, K)  let y = l /\ m  let z = pole(l, K)
"""


def test_what_follows_from_polarity_is_trivial() -> None:
    found = gc.discover(TRIVIAL)
    assert found.found == ()
    assert found.trivial > 20


@pytest.mark.parametrize(("text", "claims"), THEOREMS.values(), ids=THEOREMS)
def test_what_is_discovered_can_be_claimed(text: str, claims: list[str]) -> None:
    """Under the same assumptions, as it is written, and by its equations."""
    at = parse_script(f"rank 3 conic K {text}").context
    for d in discover(at).found:
        written = [f"{c})".replace("))", ")") if "polar" not in c else c for c in re.split(r"(?<=\)), ", d.claim)]
        for claim in (*written, *(f"{e} == 0" for e in d.equations)):
            assert decide(parse_claim(claim, at), at).proved, claim


def test_equations_vanish_where_a_conic_is_drawn() -> None:
    """Equations are in names; those of six points are their polynomial."""
    (found,) = gc.discover(f"rank 3 conic K given on_conic(a, b, c, d, e, f, K) {HEXAGON}").found
    assert found.equations == ("[xyz]",)
    (found,) = gc.discover(THEOREMS["von Staudt"][0].join(["rank 3 conic K ", ""])).found
    assert found.equations == ("[y, polar(x, K)]",)


def test_a_conic_with_which_nothing_has_to_do_changes_nothing() -> None:
    """Neither what is found nor what is assumed, nor where it fails."""
    for name in ("desargues-converse", "pappus", "quadrangle"):
        text = (EXAMPLES / "theorems" / f"{name}.gca").read_text()
        one, other = gc.discover(text), gc.discover(text.replace("rank 3", "rank 3\nconic K0"))
        assert [replace(d, equations=()) for d in other.found] == [replace(d, equations=()) for d in one.found]
        assert other.kinds == one.kinds
        assert other.trivial == one.trivial


def test_several_kinds_of_positions() -> None:
    """Which are said in words about the conic; what they say is trivial there."""
    found = gc.discover(
        "rank 3 conic K given [p polar(q, K)][p polar(s, K)] == 0, on_conic(a, b, K)"
        "  let x = pole(pq, K)  let y = pole(ps, K)  let z = pole(qs, K)"
    )
    assert [k.where for k in found.kinds] == [("[p, polar(q, K)]",), ("[p, polar(s, K)]",)]
    assert found.found == ()


def test_a_discovery_at_some_kinds_of_positions() -> None:
    """p is on the polar of a diagonal point where it is on the line of the two others."""
    diagonals = r"let x = ab /\ cd  let y = ac /\ bd  let z = ad /\ bc"
    found = gc.discover(f"rank 3 conic K given on_conic(a, b, c, d, K) {diagonals} given [p y z][p a b] == 0")
    assert found.kinds[0].where == ("[abp]",)
    assert [(d.claim, d.verdicts) for d in found.found if d.verdict == "partly proved"] == [
        ("incident(x, polar(p, K))", ("refuted", "proved"))
    ]


def test_two_conics() -> None:
    """Points of both, and poles for one of polars for the other, come to an end."""
    found = gc.discover(
        "rank 3 conic K M given on_conic(a, b, c, d, K), on_conic(a, b, c, d, M)"
        "  let e = second_on_conic(p, a, K)  let f = second_on_conic(p, a, M)"
    )
    assert (found.found, found.conics) == ((), ("K", "M"))


def test_a_circle() -> None:
    """The polar of a point at infinity is a diameter: the pole of the line at infinity is its middle."""
    found = gc.discover(
        "rank 3 isotropic i j conic K given on_conic(i, j, a, b, K) let o = pole(ij, K) let m = midpoint(a, b)"
    )
    assert all(d.verdict == "proved" for d in found.found)
    assert "incident(j, polar(o, K))" not in {d.claim for d in found.found}


def test_relations_of_letters() -> None:
    text = f"rank 3 conic K {THEOREMS['the diagonal triangle'][0]}"
    assert [d.relation for d in gc.discover(text, relations="conjugate").found] == ["conjugate"] * 2
    assert gc.discover(text, relations=("touches", "polar")).found == ()


def test_numbers_that_a_letter_is_multiplied_by_make_a_difference() -> None:
    """x is any point of ab, since L is any multiple of the polar of its point."""
    at = parse_script("rank 3 conic K line L given touches(L, K) let x = [bL] a + b let y = [bL] a - [aL] b").context
    assert [*tangents(at, [at.bound["y"]])] == ["L"]
    assert [*tangents(at, [at.bound["x"]])] == []
