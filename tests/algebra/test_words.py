"""Words of metric geometry and of conics beside their definitions in ordinary coordinates.

Positions have whole coordinates; the isotropic points (1, ±√−1, 0) have a root modulo a prime, and so values are
compared modulo that prime.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations

import pytest
from places import ROOT

from gcrules.algebra.decide import decide
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.letter_words import CONSTRUCTION_NAMES, CONSTRUCTIONS_OF_LETTERS, RELATIONS_OF_LETTERS
from gcrules.algebra.language.relation_words import RELATION_NAMES, RELATIONS
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.language.statements import Claim, parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.language.words import CONSTRUCTIONS
from gcrules.core.errors import GcrulesError, InputError

PRIME = 10**18 + 9
UNIT = next(r for g in range(2, 20) if (r := pow(g, (PRIME - 1) // 4, PRIME)) ** 2 % PRIME == PRIME - 1)

Vector = tuple[Fraction, ...]
Position = dict[str, tuple[int, ...]]

INFINITIES: dict[str, tuple[Context, Position]] = {
    "isotropic": (
        parse_assumption("isotropic i j", Context(rank=3)),
        {"i": (1, UNIT, 0), "j": (1, PRIME - UNIT, 0)},
    ),
    "orthonormal": (parse_assumption("orthonormal i j", Context(rank=3)), {"i": (3, 4, 0), "j": (-4, 3, 0)}),
    "space": (
        parse_assumption("orthonormal i j k", Context(rank=4)),
        {"i": (1, 2, 2, 0), "j": (2, 1, -2, 0), "k": (2, -2, 1, 0)},
    ),
}
PLANE, BOTH = ["isotropic", "orthonormal"], [*INFINITIES]


# --- ordinary coordinates -------------------------------------------------------------------------------------------


def vector(*v: int | Fraction) -> Vector:
    return tuple(map(Fraction, v))


def dot(u: Sequence[Fraction], v: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(u, v, strict=True)), Fraction(0))


def minus(u: Vector, v: Vector) -> Vector:
    return tuple(x - y for x, y in zip(u, v, strict=True))


def along(p: Vector, t: Fraction, u: Vector) -> Vector:
    return tuple(x + t * y for x, y in zip(p, u, strict=True))


def squared(a: Vector, b: Vector) -> Fraction:
    return dot(minus(a, b), minus(a, b))


def nullspace(rows: Sequence[Sequence[Fraction]]) -> list[Vector]:
    """A basis of all vectors with the product 0 with every row."""
    width, left, pivots = len(rows[0]), [list(r) for r in rows], list[int]()
    for column in range(width):
        at = next((r for r in range(len(pivots), len(left)) if left[r][column]), None)
        if at is None:
            continue
        k = len(pivots)
        left[k], left[at] = left[at], left[k]
        left[k] = [x / left[k][column] for x in left[k]]
        for r in range(len(left)):
            if r != k:
                left[r] = [x - left[r][column] * y for x, y in zip(left[r], left[k], strict=True)]
        pivots.append(column)
    found = []
    for free in (c for c in range(width) if c not in pivots):
        v = [Fraction(int(c == free)) for c in range(width)]
        for k, c in enumerate(pivots):
            v[c] = -left[k][free]
        found.append(tuple(v))
    return found


def meeting(hyperplanes: Sequence[tuple[Vector, Fraction]]) -> Vector:
    """The point x with n · x = c for each (n, c)."""
    (found,) = nullspace([[*n, -c] for n, c in hyperplanes])
    return tuple(x / found[-1] for x in found[:-1])


def equally_far(*points: Vector) -> Vector:
    a, *others = points
    return meeting([(minus(p, a), (dot(p, p) - dot(a, a)) / 2) for p in others])


def foot(c: Vector, a: Vector, b: Vector) -> Vector:
    u = minus(b, a)
    return along(a, dot(minus(c, a), u) / dot(u, u), u)


def normal(*points: Vector) -> Vector:
    """Perpendicular to the line or plane of the points."""
    (found,) = nullspace([minus(p, points[0]) for p in points[1:]])
    return found


def foot_on_plane(p: Vector, a: Vector, b: Vector, c: Vector) -> Vector:
    n = normal(a, b, c)
    return along(p, dot(minus(a, p), n) / dot(n, n), n)


def orthocentre(a: Vector, b: Vector, c: Vector) -> Vector:
    return meeting([(minus(c, b), dot(minus(c, b), a)), (minus(c, a), dot(minus(c, a), b))])


# --- evaluation -----------------------------------------------------------------------------------------------------


def placed(x: Vector, weight: int = 1) -> tuple[int, ...]:
    """Whole homogeneous coordinates of a finite point."""
    return whole((*x, Fraction(1)), weight)


def whole(v: Sequence[Fraction], weight: int = 1) -> tuple[int, ...]:
    common = 1
    for x in v:
        common *= x.denominator
    return tuple(int(x * common * weight) for x in v)


def value(e: Expr, points: Position, rank: int) -> tuple[int, ...]:
    return tuple(int(v) % PRIME for v in Evaluator(points, rank).value(e))


def same(u: Sequence[int], v: Sequence[int]) -> bool:
    """One point, line or plane, none of them zero."""
    return (
        any(u) and any(v) and all((u[i] * v[j] - u[j] * v[i]) % PRIME == 0 for i, j in combinations(range(len(u)), 2))
    )


def drawn(rng: random.Random, dimension: int, size: int = 9) -> Vector:
    return vector(*(rng.randint(-size, size) for _ in range(dimension)))


def positions(
    name: str, letters: str, *, size: int = 9, number: int = 6
) -> Iterator[tuple[dict[str, Vector], Position]]:
    """Points drawn at random, in ordinary coordinates, and in homogeneous ones of any weight."""
    at, infinity = INFINITIES[name]
    rng = random.Random(f"{name} {letters}")
    for _ in range(number):
        points = {n: drawn(rng, at.rank - 1, size) for n in letters}
        yield points, {n: placed(p, rng.choice((1, 2, -3))) for n, p in points.items()} | infinity


# --- constructions ---------------------------------------------------------------------------------------------------

P = dict[str, Vector]


def at_infinity(u: Vector) -> tuple[int, ...]:
    return whole((*u, Fraction(0)))


POINTS: dict[str, tuple[list[str], str, Callable[[P], tuple[int, ...]]]] = {
    "midpoint(a, b)": (BOTH, "ab", lambda p: placed(along(p["a"], Fraction(1, 2), minus(p["b"], p["a"])))),
    "centroid(a, b, c, d)": (
        BOTH,
        "abcd",
        lambda p: placed(tuple(sum(x, Fraction(0)) / 4 for x in zip(*p.values(), strict=True))),
    ),
    "reflection(a, b)": (BOTH, "ab", lambda p: placed(along(p["b"], Fraction(1), minus(p["b"], p["a"])))),
    "direction(ab)": (BOTH, "ab", lambda p: at_infinity(minus(p["b"], p["a"]))),
    "foot(c, ab)": (BOTH, "abc", lambda p: placed(foot(p["c"], p["a"], p["b"]))),
    "foot(d, abc)": (["space"], "abcd", lambda p: placed(foot_on_plane(p["d"], p["a"], p["b"], p["c"]))),
    "mirror(c, ab)": (
        BOTH,
        "abc",
        lambda p: placed(along(p["c"], Fraction(2), minus(foot(p["c"], p["a"], p["b"]), p["c"]))),
    ),
    "mirror(d, abc)": (
        ["space"],
        "abcd",
        lambda p: placed(along(p["d"], Fraction(2), minus(foot_on_plane(p["d"], p["a"], p["b"], p["c"]), p["d"]))),
    ),
    "circumcentre(a, b, c)": (PLANE, "abc", lambda p: placed(equally_far(*p.values()))),
    "circumcentre(a, b, c, d)": (["space"], "abcd", lambda p: placed(equally_far(*p.values()))),
    "orthocentre(a, b, c)": (PLANE, "abc", lambda p: placed(orthocentre(*p.values()))),
    "second_on_circle(p, a, b, c)": (
        PLANE,
        "abcp",
        lambda p: placed(
            along(p["a"], Fraction(2), minus(foot(equally_far(p["a"], p["b"], p["c"]), p["a"], p["p"]), p["a"]))
        ),
    ),
}


def turned(p: P) -> tuple[int, ...]:
    return at_infinity(normal(p["a"], p["b"]))


LINES: dict[str, tuple[list[str], str, str, Callable[[P], Position]]] = {
    "parallel_through(c, ab)": (BOTH, "abc", "cu", lambda p: {"u": at_infinity(minus(p["b"], p["a"]))}),
    "perpendicular_through(c, ab)": (PLANE, "abc", "cu", lambda p: {"u": turned(p)}),
    "bisector(a, b)": (
        PLANE,
        "ab",
        "mu",
        lambda p: {"u": turned(p), "m": placed(along(p["a"], Fraction(1, 2), minus(p["b"], p["a"])))},
    ),
    "perpendicular_through(d, abc)": (
        ["space"],
        "abcd",
        "du",
        lambda p: {"u": at_infinity(normal(p["a"], p["b"], p["c"]))},
    ),
    "perpendicular_through(c, a \\/ b)": (["space"], "abc", "cuv", lambda p: across(p)),
    "bisector(b, a)": (
        ["space"],
        "ab",
        "muv",
        lambda p: across(p) | {"m": placed(along(p["a"], Fraction(1, 2), minus(p["b"], p["a"])))},
    ),
}


def across(p: P) -> Position:
    """Two directions perpendicular to ab."""
    return dict(zip("uv", map(at_infinity, nullspace([minus(p["b"], p["a"])])), strict=True))


def cases(table: dict[str, tuple[list[str], *tuple[object, ...]]]) -> list[tuple[str, str]]:
    return [(text, where) for text, (wheres, *_) in table.items() for where in wheres]


@pytest.mark.parametrize(("text", "where"), cases(POINTS))
def test_a_point_is_that_of_its_definition(text: str, where: str) -> None:
    at, _ = INFINITIES[where]
    _, letters, definition = POINTS[text]
    for points, placed_points in positions(where, letters):
        assert same(value(parse(text, context=at), placed_points, at.rank), definition(points)), points


@pytest.mark.parametrize(("text", "where"), cases(LINES))
def test_a_line_or_plane_is_that_of_its_definition(text: str, where: str) -> None:
    at, _ = INFINITIES[where]
    _, letters, span, definition = LINES[text]
    for points, placed_points in positions(where, letters):
        placed_points |= definition(points)
        expected = value(parse(span, context=Context(at.rank)), placed_points, at.rank)
        assert same(value(parse(text, context=at), placed_points, at.rank), expected), points


def test_every_construction_is_compared() -> None:
    """Those of conics below, that of quadrics in test_ten_points.py."""
    compared = {text.partition("(")[0] for text in (*POINTS, *LINES)}
    conics = {"conic", "tangent", "polar", "pole", "second_on_conic"}
    assert compared | conics | {"quadric"} == set(CONSTRUCTIONS)


# --- conics ----------------------------------------------------------------------------------------------------------

FIVE = "a, b, c, d, e"
_SQUARES = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]


def matrix(points: Sequence[Vector]) -> list[list[Fraction]]:
    """The symmetric matrix of the conic through five points, given by homogeneous coordinates."""
    (found,) = nullspace([[p[i] * p[j] for i, j in _SQUARES] for p in points])
    m = [[Fraction(0)] * 3 for _ in range(3)]
    for (i, j), x in zip(_SQUARES, found, strict=True):
        m[i][j] = m[j][i] = x if i == j else x / 2
    return m


def times(m: Sequence[Sequence[Fraction]], p: Sequence[Fraction]) -> Vector:
    return tuple(dot(row, p) for row in m)


def coefficients(line: Sequence[int]) -> tuple[int, ...]:
    """Those of its equation, from the coordinates 12, 13, 23 of a line of the plane."""
    return line[2], -line[1], line[0]


def five_and(rng: random.Random, others: str) -> dict[str, Vector]:
    return {n: vector(*(rng.randint(-5, 5) for _ in range(3))) for n in f"abcde{others}"}


@pytest.mark.parametrize("seed", range(6))
def test_tangents_poles_and_polars(seed: int) -> None:
    points = five_and(random.Random(seed), "pq")
    m = matrix([points[n] for n in "abcde"])
    position = {n: whole(p) for n, p in points.items()}

    def of(text: str) -> tuple[int, ...]:
        return value(parse(text, rank=3), position, 3)

    assert same(coefficients(of(f"tangent({FIVE})")), whole(times(m, points["a"])))
    assert same(coefficients(of(f"polar(p, {FIVE})")), whole(times(m, points["p"])))
    line = vector(*coefficients(tuple(int(v) for v in Evaluator(position, 3).value(parse("pq", rank=3)))))
    (pole,) = nullspace([[*row, -x] for row, x in zip(m, line, strict=True)])
    assert same(of(f"pole(pq, {FIVE})"), whole(pole[:3]))
    both, alone = dot(points["a"], times(m, points["p"])), dot(points["p"], times(m, points["p"]))
    second = tuple(2 * both * p - alone * a for p, a in zip(points["p"], points["a"], strict=True))
    assert dot(second, times(m, second)) == 0
    assert same(of(f"second_on_conic(p, {FIVE})"), whole(second))


def test_six_points_on_a_conic() -> None:
    on = {n: vector(t, t * t, 1) for n, t in zip("abcdef", (-3, -1, 0, 2, 4, 7), strict=True)}
    at = Context(rank=3)
    for f, expected in ((on["f"], True), (vector(5, 26, 1), False)):
        position = {n: whole(p) for n, p in (on | {"f": f}).items()}
        assert holds("on_conic(a, b, c, d, e, f)", at, position) is expected
        assert (value(parse(f"conic({FIVE}, f)", rank=3), position, 3) == (0,)) is expected
    seven = {n: whole(p) for n, p in (on | {"g": vector(9, 81, 1)}).items()}
    assert holds("on_conic(a, b, c, d, e, f, g)", at, seven)
    assert not holds("on_conic(a, b, c, d, e, f, g)", at, seven | {"a": (1, 2, 1)})


# --- relations -------------------------------------------------------------------------------------------------------


def holds(text: str, at: Context, position: Position) -> bool:
    claimed = parse_claim(text, at)
    return not any(any(value(left, position, at.rank)) for left, _ in claimed.equations)


def dependent(rows: Sequence[Sequence[Fraction]]) -> bool:
    return bool(nullspace(list(zip(*rows, strict=True))))


def on_one_sphere(points: Sequence[Vector]) -> bool:
    """On a circle or a line, a sphere or a plane: a (x · x) + b · x + c = 0 for some a, b, c that are not all 0."""
    return len(nullspace([[dot(p, p), *p, Fraction(1)] for p in points])) > 0


def parallel_to_plane(p: P) -> bool:
    return dot(minus(p["e"], p["d"]), normal(p["a"], p["b"], p["c"])) == 0


TRUTHS: dict[str, tuple[list[str], str, Callable[[P], bool]]] = {
    "parallel(ab, cd)": (BOTH, "abcd", lambda p: dependent([minus(p["b"], p["a"]), minus(p["d"], p["c"])])),
    "perpendicular(ab, cd)": (BOTH, "abcd", lambda p: dot(minus(p["b"], p["a"]), minus(p["d"], p["c"])) == 0),
    "equidistant(a, b, c)": (BOTH, "abc", lambda p: squared(p["a"], p["b"]) == squared(p["a"], p["c"])),
    "equidistant(a, b, c, d)": (
        BOTH,
        "abcd",
        lambda p: squared(p["a"], p["b"]) == squared(p["a"], p["c"]) == squared(p["a"], p["d"]),
    ),
    "equal_distance(ab, cd)": (BOTH, "abcd", lambda p: squared(p["a"], p["b"]) == squared(p["c"], p["d"])),
    "equal_distance(ab, ca)": (BOTH, "abc", lambda p: squared(p["a"], p["b"]) == squared(p["c"], p["a"])),
    "concyclic(a, b, c, d)": (PLANE, "abcd", lambda p: on_one_sphere([*p.values()])),
    "concyclic(a, b, c, d, e)": (PLANE, "abcde", lambda p: on_one_sphere([*p.values()])),
    "cospherical(a, b, c, d, e)": (["space"], "abcde", lambda p: on_one_sphere([*p.values()])),
    "parallel(abc, de)": (["space"], "abcde", parallel_to_plane),
    "parallel(abc, def)": (
        ["space"],
        "abcdef",
        lambda p: dependent([normal(p["a"], p["b"], p["c"]), normal(p["d"], p["e"], p["f"])]),
    ),
    "perpendicular(abc, de)": (
        ["space"],
        "abcde",
        lambda p: dependent([normal(p["a"], p["b"], p["c"]), minus(p["e"], p["d"])]),
    ),
    "perpendicular(abc, def)": (
        ["space"],
        "abcdef",
        lambda p: dot(normal(p["a"], p["b"], p["c"]), normal(p["d"], p["e"], p["f"])) == 0,
    ),
}


@pytest.mark.parametrize(("text", "where"), cases(TRUTHS))
def test_a_relation_holds_where_its_definition_does(text: str, where: str) -> None:
    """Among positions of small coordinates both kinds occur, so that nothing holds always or never."""
    at, _ = INFINITIES[where]
    _, letters, definition = TRUTHS[text]
    found = set[bool]()
    for size, number in ((1, 150), (6, 10)):
        for points, position in positions(where, letters, size=size, number=number):
            planes = [[points[n] for n in part] for part in ("abc", "def") if part in text]
            if any(len(nullspace([minus(p, plane[0]) for p in plane[1:]])) > 1 for plane in planes):
                continue  # three points of a plane are on a line
            found.add(definition(points))
            assert holds(text, at, position) is definition(points), points
    assert found == {True, False}


def test_every_relation_is_compared() -> None:
    assert {text.partition("(")[0] for text in TRUTHS} | {"on_conic", "on_quadric"} == set(RELATIONS)


def test_the_page_and_the_grammar_list_every_word() -> None:
    page = (ROOT / "docs" / "language.md").read_text(encoding="utf-8")
    tables = (*CONSTRUCTIONS_OF_LETTERS.values(), *RELATIONS_OF_LETTERS.values())
    of_letters = [word for words in tables for word in words.values()]
    for word in (*CONSTRUCTIONS.values(), *RELATIONS.values(), *of_letters):
        assert f"| `{word.usage}` | {word.meaning} |" in page
    grammar = (ROOT / "gcrules" / "grammar.lark").read_text(encoding="utf-8")
    for terminal, names in (("CONSTRUCTION", [*CONSTRUCTION_NAMES]), ("RELATION", [*RELATION_NAMES])):
        found = re.search(rf"^{terminal}\.1: /\(([a-z_|]+)\)", grammar, re.MULTILINE)
        assert found is not None
        assert found[1].split("|") == names


# --- proofs ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("declared", "given", "claim", "verdict"),
    [
        ("isotropic i j", "", "perpendicular(a \\/ orthocentre(a, b, c), bc)", "proved"),
        ("orthonormal i j", "", "perpendicular(a \\/ orthocentre(a, b, c), bc)", "proved"),
        ("orthonormal i j", "", "perpendicular(a \\/ orthocentre(a, b, c), ab)", "refuted"),
        ("isotropic i j", "", "equidistant(circumcentre(a, b, c), a, b, c)", "proved"),
        ("isotropic i j", "parallel(ab, cd)", "parallel(cd, ab)", "proved"),
        ("isotropic i j", "parallel(ab, cd), parallel(cd, ef)", "parallel(ab, ef)", "proved"),
        ("isotropic i j", "perpendicular(ab, cd), perpendicular(cd, ef)", "parallel(ab, ef)", "proved"),
        ("orthonormal i j", "perpendicular(ab, cd), perpendicular(cd, ef)", "parallel(ab, ef)", "proved"),
        ("isotropic i j", "perpendicular(ab, cd)", "parallel(ab, cd)", "refuted"),
        ("isotropic i j", "equidistant(o, a, b), equidistant(o, b, c)", "equidistant(o, a, c)", "proved"),
        ("isotropic i j", "concyclic(a, b, c, d)", "concyclic(d, b, c, a)", "proved"),
        ("isotropic i j", "concyclic(a, b, c, d, e)", "concyclic(a, b, d, e)", "proved"),
        ("isotropic i j", "concyclic(a, b, c, d)", "equidistant(circumcentre(a, b, c), a, d)", "proved"),
        ("isotropic i j", "concyclic(a, b, c, d)", "perpendicular(ab, cd)", "refuted"),
        ("orthonormal i j k", "perpendicular(ab, cd), perpendicular(ac, bd)", "perpendicular(ad, bc)", "proved"),
        ("orthonormal i j k", "perpendicular(pq, ab), perpendicular(pq, ac)", "perpendicular(pq, bc)", "proved"),
        ("orthonormal i j k", "parallel(ab, cd)", "coplanar(a, b, c, d)", "proved"),
        ("orthonormal i j k", "", "cospherical(a, b, c, d, reflection(a, circumcentre(a, b, c, d)))", "proved"),
    ],
)
def test_claims_are_decided(declared: str, given: str, claim: str, verdict: str) -> None:
    at = parse_assumption(declared, Context(rank=len(declared.split())))
    at = parse_assumption(given, at) if given else at
    assert decide(parse_claim(claim, at), at).verdict == verdict


def test_what_words_make_is_assumed_to_exist() -> None:
    at, _ = INFINITIES["isotropic"]
    found = decide(parse_claim("parallel(a \\/ foot(c, ab), midpoint(a, orthocentre(a, b, c)) \\/ b)", at), at)
    assert found.verdict == "refuted"
    assert found.counterexample is not None
    found = decide(parse_claim("perpendicular(c \\/ foot(c, ab), ab)", at), at)
    assert (found.assumed, found.meanings) == (("foot(c, ab)",), ("the point exists",))
    found = decide(parse_claim("collinear(midpoint(a, b), a, b)", at), at)
    assert (found.verdict, found.assumed) == ("proved", ())
    found = decide(parse_claim("parallel(c \\/ midpoint(a, foot(c, ab)), c \\/ midpoint(foot(c, ab), a))", at), at)
    assert (found.verdict, found.assumed) == ("proved", ("[foot(c, ab), i, j]",))


def test_a_name_carries_what_its_words_require() -> None:
    script = parse_script("rank 3 isotropic i j let h = orthocentre(a, b, c) claim perpendicular(ch, ab)")
    (claim,) = script.statements
    assert isinstance(claim, Claim)
    found = decide(claim.claimed, claim.context)
    assert found.assumed == ("orthocentre(a, b, c)",)
    script = parse_script("rank 3 isotropic i j let h = orthocentre(a, b, c) claim collinear(h, b, midpoint(h, b))")
    (claim,) = script.statements
    assert isinstance(claim, Claim)
    found = decide(claim.claimed, claim.context)
    assert found.assumed == ("[h, i, j]",)


def test_a_counterexample_is_no_degenerate_position() -> None:
    """The isotropic points differ there, lines are lines, and what is made exists."""
    at = parse_assumption("isotropic i j, parallel(ab, cd)", Context(rank=3))
    found = decide(parse_claim("collinear(a, b, c)", at), at)
    assert found.verdict == "refuted"
    points = found.counterexample
    assert points is not None
    for pair in ("ij", "ab", "cd"):
        assert not same(points[pair[0]], points[pair[1]])


def test_what_exists_nowhere_is_refused() -> None:
    at, _ = INFINITIES["isotropic"]
    with pytest.raises(InputError, match=r"orthocentre\(a, a, b\) vanishes at all positions"):
        decide(parse_claim("perpendicular(c \\/ orthocentre(a, a, b), ab)", at), at)


# --- faults ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "message", "hint"),
    [
        ("rank 3 claim parallel(ab, cd)", "needs to know the points at infinity", "`isotropic i j`"),
        ("show foot(a, bc)", "needs to know the points at infinity", "`orthonormal i j k`"),
        ("rank 3 isotropic i j k", "isotropic declares 2 points in rank 3, found 3", "`isotropic i j`"),
        ("isotropic i j", "isotropic points are points of the plane (rank 3); this is rank 4", "`orthonormal i j k`"),
        ("orthonormal i j", "orthonormal declares 3 points in rank 4, found 2", "`orthonormal i j k`"),
        ("rank 5 orthonormal i j k l", "this is rank 5", "`rank 3`"),
        ("rank 3 isotropic i j orthonormal i j", "isotropic i j is declared already", "by one of both only"),
        ("rank 3 isotropic i j show midpoint(a, b, c)", "midpoint(a, b) takes 2 arguments, found 3", None),
        ("rank 3 isotropic i j show midpoint(ab)", "midpoint(a, b) takes 2 arguments, found 1", "with commas"),
        ("rank 3 isotropic i j show midpoint(a, bc)", "a line (step 2) where a point is expected", "with commas"),
        ("rank 3 isotropic i j show foot(a, b)", "a point (step 1) where a line or a plane is expected", None),
        ("rank 3 isotropic i j show midpoint(a, i)", "i is at infinity, and midpoint(…) is about finite points", None),
        ("rank 3 isotropic i j claim perpendicular(ab, ij)", "i is at infinity, and perpendicular(…)", None),
        ("rank 3 isotropic i j claim cospherical(a, b, c, d, e)", "is a word of space (rank 4)", "`rank 4`"),
        ("claim on_conic(a, b, c, d, e, f)", "is a word of the plane (rank 3); this is rank 4", "`rank 3`"),
        ("rank 3 claim on_conic(a, b, c, d, e)", "takes at least 6 arguments, found 5", None),
        ("rank 3 isotropic i j claim equal_distance(ab, cd /\\ ef)", "where a line of two points is expected", None),
        ("rank 3 isotropic i j show midpiont(a, b)", "unexpected ','", "did you mean midpoint(…)?"),
        ("rank 3 isotropic i j claim parralel(ab, cd)", "unexpected ','", "did you mean parallel(…)?"),
        ("rank 3 isotropic i j show parallel(ab, cd)", "unexpected ','", None),
        ("rank 3 isotropic ij", "isotropic declares 2 points in rank 3, found 1", "`isotropic i j`"),
        ("rank 3 isotropic i j rule r: [abc] => -[bac] if perpendicular(ab, bc)", "a rule cannot ask for", None),
    ],
)
def test_faults_have_a_place_and_advice(source: str, message: str, hint: str | None) -> None:
    with pytest.raises(GcrulesError) as caught:
        parse_script(source)
    assert message in caught.value.message
    assert caught.value.span is not None
    if hint is not None:
        assert hint in str(caught.value.hint)


def test_words_without_parentheses_are_points() -> None:
    assert parse("pole", rank=4).step == 4
    with pytest.raises(GcrulesError):
        parse("midpoint", rank=3)
