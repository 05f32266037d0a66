"""Incidences that are discovered, against an enumeration that shares nothing with it: constructions computed here, in
whole numbers, and every set of their points asked by a determinant.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from itertools import combinations
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.discovery.discover import discover
from gcrules.algebra.discovery.figure import Position, figure_of, normalized
from gcrules.algebra.discovery.known import Known
from gcrules.algebra.discovery.limits import RELATIONS
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse_equation
from gcrules.algebra.prove import prove
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import rank

Point = tuple[Any, ...]
Points = dict[str, Point]
Names = frozenset[str]

FOLDER = EXAMPLES / "theorems"

# --- constructions by hand --------------------------------------------------------------------------------------------


def det(rows: Sequence[Sequence[Any]]) -> Any:
    """By Laplace's expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** k * x * det([[*row[:k], *row[k + 1 :]] for row in rows[1:]]) for k, x in enumerate(rows[0]) if x)


def cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def meet(a: Point, b: Point, c: Point, d: Point) -> Point:
    """The meet of the lines ab and cd of the plane."""
    return cross(cross(a, b), cross(c, d))


def pierced(a: Point, b: Point, plane: Sequence[Point]) -> Point:
    """Where the line ab meets a plane of space."""
    s, t = det([b, *plane]), det([a, *plane])
    return tuple(s * x - t * y for x, y in zip(a, b, strict=True))


class Draw:
    """Points drawn at random."""

    def __init__(self, seed: int, rank: int) -> None:
        self.rng, self.rank = random.Random(seed), rank

    def number(self) -> int:
        return self.rng.choice([-1, 1]) * self.rng.randint(1, 40)

    def free(self, names: str) -> Points:
        return {n: tuple(self.number() for _ in range(self.rank)) for n in names.split()}

    def on(self, *through: Point) -> Point:
        """A point of the join of points."""
        weights = [self.number() for _ in through]
        return tuple(sum(w * p[i] for w, p in zip(weights, through, strict=True)) for i in range(self.rank))

    def infinite(self) -> Point:
        return (*(self.number() for _ in range(self.rank - 1)), 0)


def pappus(draw: Draw) -> Points:
    p = draw.free("a b a' b'")
    p["c"], p["c'"] = draw.on(p["a"], p["b"]), draw.on(p["a'"], p["b'"])
    return p | {x: meet(p[u], p[v + "'"], p[u + "'"], p[v]) for x, u, v in ("xbc", "yca", "zab")}


def no_pappus(draw: Draw) -> Points:
    p = draw.free("a b a' b' c'")
    p["c"] = draw.on(p["a"], p["b"])
    return p | {x: meet(p[u], p[v + "'"], p[u + "'"], p[v]) for x, u, v in ("xbc", "yca", "zab")}


def desargues(draw: Draw) -> Points:
    p = draw.free("o a b c")
    p |= {n + "'": draw.on(p["o"], p[n]) for n in "abc"}
    return p | {x: meet(p[u], p[v], p[u + "'"], p[v + "'"]) for x, u, v in ("xbc", "yca", "zab")}


def two_triangles(draw: Draw) -> Points:
    p = draw.free("a b c a' b' c'")
    return p | {x: meet(p[u], p[v], p[u + "'"], p[v + "'"]) for x, u, v in ("xbc", "yca", "zab")}


def quadrangle(draw: Draw) -> Points:
    p = draw.free("a b c d")
    x, y, z = (meet(*(p[n] for n in four)) for four in ("abcd", "acbd", "adbc"))
    side = {n: meet(x, y, p[u], p[v]) for n, u, v in ("pad", "qbc")}
    return p | {"x": x, "y": y, "z": z} | side


def newton_gauss(draw: Draw) -> Points:
    p = draw.free("a b c d")
    i, j = draw.infinite(), draw.infinite()
    e, f = meet(p["a"], p["b"], p["c"], p["d"]), meet(p["b"], p["c"], p["a"], p["d"])

    def middle(u: Point, v: Point) -> Point:
        return tuple(v[-1] * x + u[-1] * y for x, y in zip(u, v, strict=True))

    return {
        **p,
        "i": i,
        "j": j,
        "e": e,
        "f": f,
        "m": middle(p["a"], p["c"]),
        "n": middle(p["b"], p["d"]),
        "l": middle(e, f),
    }


def desargues_in_space(draw: Draw) -> Points:
    p = draw.free("o a b c")
    p |= {n + "'": draw.on(p["o"], p[n]) for n in "abc"}
    second = [p["a'"], p["b'"], p["c'"]]
    return p | {x: pierced(p[u], p[v], second) for x, u, v in ("xbc", "yca", "zab")}


def moebius(draw: Draw) -> Points:
    p = draw.free("a b c d")
    p["p"] = draw.on(p["b"], p["c"], p["d"])
    p["q"] = draw.on(p["a"], p["c"], p["d"])
    p["r"] = draw.on(p["d"], pierced(p["a"], p["b"], [p["d"], p["p"], p["q"]]))
    planes = [[p["a"], p["q"], p["r"]], [p["b"], p["p"], p["r"]], [p["c"], p["p"], p["q"]]]
    unknown = [[(-1) ** k * det([[*v[:k], *v[k + 1 :]] for v in plane]) for k in range(4)] for plane in planes]
    p["s"] = tuple((-1) ** k * det([[*row[:k], *row[k + 1 :]] for row in unknown]) for k in range(4))
    return p


CROSS = r"let x = bc' /\ b'c  let y = ca' /\ c'a  let z = ab' /\ a'b"
SIDES = r"let x = bc /\ b'c'  let y = ca /\ c'a'  let z = ab /\ a'b'"
CROSSED = ("bc'x", "b'cx", "ca'y", "c'ay", "ab'z", "a'bz")
PLANES = "coplanar(b, c, d, p), coplanar(a, c, d, q), coplanar(a, b, d, r)"
INNER = "coplanar(a, q, r, s), coplanar(b, p, r, s), coplanar(c, p, q, s), coplanar(d, p, q, r)"

# Text, rank, how its points are computed, the lines and planes that are trivial, and what is to be discovered.
CASES: dict[str, tuple[str, int, Callable[[Draw], Points], tuple[str, ...], set[str]]] = {
    "Pappus": (
        f"rank 3 given collinear(a, b, c), collinear(a', b', c') {CROSS}",
        3,
        pappus,
        ("abc", "a'b'c'", *CROSSED),
        {"collinear(x, y, z)"},
    ),
    "six points, three of them on a line": (
        f"rank 3 given collinear(a, b, c) {CROSS}",
        3,
        no_pappus,
        ("abc", *CROSSED),
        {"on_conic(a', b', c', x, y, z)"},
    ),
    "Desargues": (
        f"rank 3 points o a b c a' b' c' given incident(o, aa'), incident(o, bb'), incident(o, cc') {SIDES}",
        3,
        desargues,
        ("oaa'", "obb'", "occ'", "bcx", "cay", "abz", "b'c'x", "c'a'y", "a'b'z"),
        {"collinear(x, y, z)"},
    ),
    "two triangles": (
        f"rank 3 {SIDES}",
        3,
        two_triangles,
        ("bcx", "cay", "abz", "b'c'x", "c'a'y", "a'b'z"),
        set(),
    ),
    "quadrangle": (
        r"rank 3 let x = ab /\ cd let y = ac /\ bd let z = ad /\ bc let p = xy /\ ad let q = xy /\ bc",
        3,
        quadrangle,
        ("abx", "cdx", "acy", "bdy", "adzp", "bczq", "xypq"),
        {"concurrent(aq, bp, yz)", "concurrent(aq, cp, xz)", "concurrent(bp, dq, xz)", "concurrent(cp, dq, yz)"},
    ),
    "Newton and Gauss": (
        r"rank 3 ideal i j let e = ab /\ cd let f = bc /\ ad let m = [cij] a + [aij] c let n = [dij] b + [bij] d"
        r" let l = [fij] e + [eij] f",
        3,
        newton_gauss,
        ("abe", "cde", "bcf", "adf", "acm", "bdn", "efl"),
        {"collinear(m, n, l)"},
    ),
    "Desargues in space": (
        "points o a b c a' b' c' given incident(o, aa'), incident(o, bb'), incident(o, cc')"
        r" let x = bc /\ a'b'c' let y = ca /\ a'b'c' let z = ab /\ a'b'c'",
        4,
        desargues_in_space,
        ("oaa'", "obb'", "occ'", "bcx", "cay", "abz", "abcxyz", "a'b'c'xyz", "oaa'bb'zz", "obb'cc'x", "oaa'cc'y"),
        {"collinear(x, y, z)", "collinear(b', c', x)", "collinear(a', c', y)", "collinear(a', b', z)"},
    ),
    "Moebius": (
        f"given {PLANES}, {INNER}",
        4,
        moebius,
        ("bcdp", "acdq", "abdr", "aqrs", "bprs", "cpqs", "dpqr"),
        {"coplanar(a, b, c, s)"},
    ),
}


def split(word: str) -> list[str]:
    """The names of one letter that stand in a word, with their primes."""
    found: list[str] = []
    for letter in word:
        found = [*found[:-1], found[-1] + letter] if letter == "'" else [*found, letter]
    return found


def largest(sets: Iterable[Names]) -> set[Names]:
    found = set(sets)
    return {s for s in found if not any(s < other for other in found)}


def dependent(positions: Sequence[Points], names: Iterable[str], step: int) -> bool:
    """Whether points have rank `step` or less at all positions: all minors of this size and one more vanish."""
    rows = sorted(names)
    rank = len(positions[0][rows[0]])
    return all(
        not det([[p[n][c] for c in columns] for n in some])
        for p in positions
        for some in combinations(rows, step + 1)
        for columns in combinations(range(rank), step + 1)
    )


def by_hand(positions: Sequence[Points], step: int) -> set[Names]:
    """The largest sets of points that lie on one line (step 2) or plane (step 3), for each base of such a set."""
    names = sorted(positions[0])
    found = set()
    for base in combinations(names, step):
        if not dependent(positions, base, step - 1):
            on = frozenset(n for n in names if n in base or dependent(positions, (*base, n), step))
            if len(on) > step:
                found.add(on)
    return found


def on_conics(positions: Sequence[Points]) -> set[Names]:
    """The largest sets of points on a conic, of which no three are on a line."""
    names = sorted(positions[0])

    def squares(p: Point) -> list[int]:
        return [p[i] * p[k] for i in range(3) for k in range(i, 3)]

    def on_one(six: Iterable[str]) -> bool:
        return all(not det([squares(p[n]) for n in six]) for p in positions)

    def smooth(five: Iterable[str]) -> bool:
        return not any(dependent(positions, three, 2) for three in combinations(five, 3))

    fives = [f for f in combinations(names, 5) if smooth(f)]
    return largest(frozenset({*f, *(n for n in names if n not in f and on_one((*f, n)))}) for f in fives)


@cache
def drawn(name: str) -> tuple[Points, ...]:
    _, rank, placed, _, _ = CASES[name]
    return tuple(placed(Draw(seed, rank)) for seed in range(2))


@cache
def found(name: str) -> gc.Discoveries:
    return gc.discover(CASES[name][0])


@pytest.mark.parametrize("name", CASES)
def test_what_is_discovered(name: str) -> None:
    answer = found(name)
    assert {d.claim for d in answer.found} == CASES[name][-1]
    assert all(d.verdict == "proved" for d in answer.found)


@pytest.mark.parametrize("name", CASES)
def test_lines_as_by_hand(name: str) -> None:
    """What is discovered and what is trivial are all lines that there are."""
    told = {frozenset(d.names) for d in found(name).found if d.relation == "collinear"}
    trivial = {frozenset(split(word)) for word in CASES[name][3]}
    lines = by_hand(drawn(name), 2)
    assert lines == {s for s in told | trivial if dependent(drawn(name), s, 2)}
    assert not told & trivial


@pytest.mark.parametrize("name", [n for n, case in CASES.items() if case[1] == 4])
def test_planes_as_by_hand(name: str) -> None:
    told = {frozenset(d.names) for d in found(name).found if d.relation == "coplanar"}
    trivial = {frozenset(split(word)) for word in CASES[name][3]}
    lines = by_hand(drawn(name), 2)
    planes = {s for s in by_hand(drawn(name), 3) if not any(len(s & line) >= len(s) - 1 for line in lines)}
    assert planes == {s for s in told | trivial if not dependent(drawn(name), s, 2)}


@pytest.mark.parametrize("name", [n for n, case in CASES.items() if case[1] == 3])
def test_concurrent_lines_as_by_hand(name: str) -> None:
    """Lines through two points each, by the determinants of three of them; none of these has a trivial point."""
    positions = drawn(name)
    points = sorted(positions[0])
    lines = largest({*by_hand(positions, 2), *map(frozenset, combinations(points, 2))})
    pairs = {tuple(sorted(line)[:2]) for line in lines}
    told = {
        frozenset(next(line for line in lines if line.issuperset(split(text))) for text in d.claim[11:-1].split(", "))
        for d in found(name).found
        if d.relation == "concurrent"
    }

    def through(some: Iterable[tuple[str, ...]]) -> bool:
        return all(not det([cross(p[a], p[b]) for a, b in some]) for p in positions)

    def whole(pair: tuple[str, ...]) -> Names:
        return next(line for line in lines if line.issuperset(pair))

    threes = [some for some in combinations(sorted(pairs), 3) if through(some)]
    unnamed = {frozenset(map(whole, some)) for some in threes if not frozenset.intersection(*map(whole, some))}
    assert unnamed == {frozenset(three) for lines in told for three in combinations(lines, 3)}


@pytest.mark.parametrize("name", [n for n, case in CASES.items() if case[1] == 3])
def test_conics_as_by_hand(name: str) -> None:
    told = {frozenset(d.names) for d in found(name).found if d.relation == "on_conic"}
    assert told == {s for s in on_conics(drawn(name)) if len(s) > 5}


# --- the answers ------------------------------------------------------------------------------------------------------

THEOREMS = (
    *("brianchon", "bundle", "circumcentre", "desargues", "desargues-converse", "desargues-space-converse"),
    *("euler-line", "harmonic", "medians", "miquel", "moebius", "newton-gauss", "nine-points", "pappus"),
    *("pappus-dual", "steiner", "thales", "trapezium", "varignon"),
)


@pytest.mark.parametrize("name", THEOREMS)
def test_the_prover_agrees(name: str) -> None:
    """What was discovered in a theorem of the guide is proved, as a claim of its own, for the same kinds or more."""
    at = parse_script((FOLDER / f"{name}.gca").read_text()).context
    answer = discover(at, seconds=0)
    assert {d.verdict for d in answer.found} <= {"proved"}
    for e in dict.fromkeys(e for d in answer.found for e in d.equations):
        left, right = parse_equation(f"{e} == 0", context=at)
        assert prove(left, right, points=at.points, ideal=at.ideal, rank=at.rank, given=at.given).proved, e


EXPECTED = {
    "bundle": "concurrent(aa', bb', cc', dd')",
    "desargues-converse": "concurrent(aa', bb', cc')",
    "euler-line": "collinear(h, g, o)",
    "harmonic": "concurrent(aa', bb', cc', dd')",
    "miquel": "on_conic(c, m, i, j, q, p)",
    "nine-points": "concyclic(p, q, r, f, m)",
    "simson": "collinear(x, y, z)",
    "steiner": "concurrent(p, q, r)",
    "varignon": "concurrent(ij, ac, pq, rs)",
}


@pytest.mark.parametrize(("name", "claim"), EXPECTED.items())
def test_known_theorems_are_discovered(name: str, claim: str) -> None:
    at = parse_script((FOLDER / f"{name}.gca").read_text()).context
    assert claim in {d.claim for d in discover(at, seconds=0).found}


def test_kinds_of_positions() -> None:
    """Each kind has its verdict."""
    answer = gc.discover(
        f"rank 3 points a b c a' b' c' d given collinear(a, b, c), [a'b'c'][a'b'd] == 0 {CROSS}", seconds=0
    )
    assert [k.where for k in answer.kinds] == [("[a'b'c']",), ("[a'b'd]",)]
    assert {d.claim: (d.verdict, d.verdicts) for d in answer.found} == {
        "collinear(x, y, z)": ("partly proved", ("proved", "refuted")),
        "on_conic(a', b', c', x, y, z)": ("proved", ("proved", "proved")),
    }
    (line,) = (d for d in answer.found if d.relation == "collinear")
    (equation,) = line.equations
    given = ["collinear(a, b, c)"]
    assert gc.prove(f"{equation} == 0", rank=3, given=[*given, "[a'b'c'] == 0"]).proved
    assert gc.prove(f"{equation} == 0", rank=3, given=[*given, "[a'b'd] == 0"]).verdict == "refuted"


def test_where_it_fails() -> None:
    """There are positions that satisfy the assumptions, where what is assumed vanishes, and the claim is false."""
    at = parse_script((FOLDER / "desargues-converse.gca").read_text()).context
    (found,) = discover(at, seconds=60).found
    assert found.fails
    (equation,) = found.equations
    for e in found.fails:
        proof = gc.prove(
            f"{equation} == 0", rank=3, given=[*(a.text for a in at.given), f"{e} == 0"], points=[*at.points]
        )
        assert proof.verdict == "refuted"
        assert proof.counterexample is not None
        at_these = {n: tuple(c) for n, c in proof.counterexample.items()}
        sides = [cross(at_these[n], at_these[n + "'"]) for n in "abc"]
        assert det(sides)
        assert not det([at_these[n] for n in "xyz"])


def test_limits() -> None:
    text = CASES["Pappus"][0]
    with pytest.raises(LimitReached, match=r"9 points and 0 named lines and planes give 840 candidates, more than 839"):
        gc.discover(text, candidates=839)
    assert gc.discover(text, candidates=840).candidates == 840
    (undecided,) = gc.discover(text, limit=1).found
    assert (undecided.verdict, undecided.verdicts) == ("undecided", ("undecided",))
    assert "more than 1 terms" in undecided.reason


@pytest.mark.parametrize("number", [2, 5])
def test_other_ranks(number: int) -> None:
    with pytest.raises(InputError, match=f"not looked for in rank {number}"):
        gc.discover(f"rank {number}")


def test_some_relations() -> None:
    text = (FOLDER / "nine-points.gca").read_text()
    some = gc.discover(text, relations="on_conic", seconds=0)
    assert {d.relation for d in some.found} == {"on_conic"}
    whole = gc.discover(text, relations=RELATIONS, seconds=0)
    assert some.found == tuple(d for d in whole.found if d.relation == "on_conic")
    with pytest.raises(InputError, match="'colinear' is not a relation") as fault:
        gc.discover(text, relations=["colinear"])
    assert fault.value.hint == "did you mean collinear or coplanar?"


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        (r"rank 3 let x = ab /\ cd let y = cd /\ ab", set()),
        (r"rank 3 given concurrent(aa', bb', cc') let p = aa' /\ bb' let q = bb' /\ cc'", set()),
        (r"rank 3 let l = (ab /\ cd) \/ (ac /\ bd) let x = l /\ ad", set()),
        (r"rank 3 let m = a + b given collinear(a, b, c)", set()),
        (r"rank 3 given [abc] == 0, ab /\ cd /\ ef == 0", set()),
        (r"given incident(p, abc), incident(q, abc) let l = pq", set()),
        (r"given collinear(a, b, c), collinear(c, d, e)", set()),
        (r"let l = abc /\ def let x = l /\ agh let y = l /\ bgh", {"concurrent(ax, by, gh)"}),
        (f"rank 3 given collinear(a, b, c), collinear(a', b', c') {CROSS} let u = xy /\\ ab let v = xz /\\ ab",
         {"collinear(x, y, z, u)"}),
        (f"rank 3 given collinear(a, b, c), collinear(a', b', c') {CROSS} let l = xy", {"collinear(x, y, z)"}),
        (f"rank 3 given collinear(a, b, c), collinear(a', b', c') {CROSS} let l = (xy /\\ ab) \\/ (xy /\\ a'b')",
         {"collinear(x, y, z)"}),
    ],
)  # fmt: skip
def test_what_is_trivial(text: str, claims: set[str]) -> None:
    """What follows at once is left out; a line is told once, with all its points."""
    told = {d.claim for d in gc.discover(text, seconds=0).found}
    assert told == claims


def test_names_that_stand_for_zero() -> None:
    """Two lines that are one have no meet."""
    answer = gc.discover(r"rank 3 given collinear(a, b, c, d) let x = ab /\ cd")
    assert answer.kinds[0].vanishing == ("x",)
    assert answer.found == ()
    assert "left out" not in answer.text()


def test_what_words_make_is_assumed_to_exist() -> None:
    """Of a circle, that its points are finite; midpoints of finite points are."""
    altitudes = "let h = orthocentre(a, b, c) let x = foot(a, bc) let y = foot(b, ca)"
    text = f"rank 3 isotropic i j {altitudes} let m = midpoint(a, b)"
    answer = gc.discover(text, seconds=0)
    assert {d.claim for d in answer.found} == {"concyclic(a, b, x, y)", "concyclic(c, h, x, y)"}
    (kind,) = answer.kinds
    assert dict(zip(kind.assumed, kind.meanings, strict=True)) == {f"[{n}, i, j]": f"{n} is finite" for n in "hxy"}
    (kind,) = gc.discover(text, relations="collinear", seconds=0).kinds
    assert kind.assumed == ()


def test_known_is_true() -> None:
    """What is taken to be known at once holds at the position: no discovery is left out for a false reason."""
    looked_at = 0
    for text in (*(case[0] for case in CASES.values()), *((FOLDER / f"{n}.gca").read_text() for n in THEOREMS)):
        at = parse_script(text).context
        figure = figure_of(at)
        for kind in kinds(at, figure.own):
            known = Known(Position(figure, kind.construction.random_points("known")))
            known.begin(at.given, kind.where)
            for f in known.flats:
                assert rank([*f.span, *(known.vectors[n] for n in f.members)], PRIME) == f.step
                looked_at += 1
            for one, other in known.same.items():
                assert normalized(known.vectors[one]) == normalized(known.vectors[other])
    assert looked_at > 200
