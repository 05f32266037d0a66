"""The exact oracle against other roads to the same numbers, and the facts of the field as identities of values."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import combinations, product
from math import comb
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import RANKS, SHORT_NAMES, coordinates, expressions

from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import evaluate, plucker, random_points, random_rational_points, vanishes
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.syntax import parse, parse_equation
from gcrules.algebra.scalars import bracket
from gcrules.core.errors import InputError, StepError
from gcrules.core.linear_algebra import permutation_sign

SMALL_PRIME = 2**31 - 1
ALL_RANKS = range(2, 9)


def names(count: int, first: str = "a") -> list[str]:
    return [f"{first}{i}" for i in range(count)]


def joined(points: Sequence[str], rank: int) -> Expr:
    return ex.join(*map(Point, points), rank=rank)


def determinant(rows: Sequence[Sequence[Any]]) -> Fraction:
    """By exact elimination: shares nothing with the oracle, which sums over minors."""
    a = [[Fraction(x) for x in row] for row in rows]
    value = Fraction(1)
    for i in range(len(a)):
        pivot = next((r for r in range(i, len(a)) if a[r][i]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != i:
            a[i], a[pivot] = a[pivot], a[i]
            value = -value
        value *= a[i][i]
        for r in range(i + 1, len(a)):
            factor = a[r][i] / a[i][i]
            a[r] = [x - factor * y for x, y in zip(a[r], a[i], strict=True)]
    return value


def columns(points: Sequence[Sequence[Any]]) -> list[list[Any]]:
    return [list(row) for row in zip(*points, strict=True)]


def minors(points: Sequence[Sequence[Any]]) -> tuple[Fraction, ...]:
    """Plücker coordinates by their definition: the minors of the matrix of columns, rows in lexicographic order."""
    matrix = columns(points)
    return tuple(determinant([matrix[r] for r in rows]) for rows in combinations(range(len(matrix)), len(points)))


def null_space(rows: Sequence[Sequence[Any]], width: int) -> list[list[Fraction]]:
    """A basis of the solutions x of rows · x = 0, by elimination."""
    a = [[Fraction(x) for x in row] for row in rows]
    pivots: list[int] = []
    for column in range(width):
        r = len(pivots)
        found = next((i for i in range(r, len(a)) if a[i][column]), None)
        if found is None:
            continue
        a[r], a[found] = a[found], a[r]
        a[r] = [x / a[r][column] for x in a[r]]
        for i in range(len(a)):
            if i != r:
                a[i] = [x - a[i][column] * y for x, y in zip(a[i], a[r], strict=True)]
        pivots.append(column)
    basis = []
    for free in (c for c in range(width) if c not in pivots):
        x = [Fraction(0)] * width
        x[free] = Fraction(1)
        for r, column in enumerate(pivots):
            x[column] = -a[r][free]
        basis.append(x)
    return basis


def meet_of_spans(a: Sequence[Sequence[Any]], b: Sequence[Sequence[Any]]) -> list[list[Fraction]]:
    """A basis of the intersection of two spans: from the solutions of Σ x_i a_i = Σ y_j b_j."""
    found = null_space(columns([*a, *([-x for x in p] for p in b)]), len(a) + len(b))
    return [[sum((x * p[r] for x, p in zip(s, a, strict=False)), Fraction(0)) for r in range(len(a[0]))] for s in found]


def proportional(a: Sequence[Any], b: Sequence[Any]) -> bool:
    return any(a) and any(b) and all(a[i] * b[j] == a[j] * b[i] for i, j in combinations(range(len(a)), 2))


# --- conventions ---------------------------------------------------------------------------------------------------


def test_bracket_is_minus_six_times_the_volume() -> None:
    corner = {"a": (0, 0, 0, 1), "b": (1, 0, 0, 1), "c": (0, 1, 0, 1), "d": (0, 0, 1, 1)}
    assert evaluate(parse("[abcd]"), corner) == -1
    assert evaluate(parse("abcd"), corner) == (-1,)


def test_line_coordinates() -> None:
    at = {"a": (1, 2, 3, 1), "b": (5, 7, 11, 1)}
    a, b = at["a"], at["b"]
    expected = tuple(a[i] * b[j] - a[j] * b[i] for i, j in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)))
    assert plucker(parse("ab"), at) == expected
    f = np.subtract(b[:3], a[:3])
    m = np.cross(a[:3], f)
    assert plucker(parse("ab"), at) == (m[2], -m[1], -f[0], m[0], -f[1], -f[2])


@given(st.data(), st.sampled_from(ALL_RANKS))
def test_bracket_is_the_determinant_of_the_columns(data: st.DataObject, rank: int) -> None:
    at = data.draw(coordinates(tuple(names(rank)), rank))
    expected = determinant(columns(list(at.values())))
    assert evaluate(bracket(*map(Point, at), rank=rank), at) == expected
    assert expected == determinant(list(at.values()))  # the road itself: transposing changes nothing


@pytest.mark.parametrize("rank", ALL_RANKS)
@pytest.mark.parametrize("shape", [(), (7,), (2, 3)], ids=str)
def test_floats_agree_with_numpy(rank: int, shape: tuple[int, ...]) -> None:
    rng = np.random.default_rng(rank)
    at = {n: rng.uniform(-1, 1, (*shape, rank)) for n in names(rank)}
    found = evaluate(bracket(*map(Point, at), rank=rank), at)
    expected = np.linalg.det(np.stack(list(at.values()), axis=-1))
    assert np.shape(found) == shape
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12)


@given(st.data(), st.sampled_from(ALL_RANKS))
def test_join_coordinates_are_minors(data: st.DataObject, rank: int) -> None:
    step = data.draw(st.integers(1, rank))
    at = data.draw(coordinates(tuple(names(step)), rank))
    found = plucker(joined(list(at), rank), at)
    assert len(found) == comb(rank, step)
    assert found == minors(list(at.values()))


# --- the kinds of numbers agree ------------------------------------------------------------------------------------


@given(st.data(), RANKS)
@settings(max_examples=200)
def test_fractions_residues_and_floats_agree(data: st.DataObject, rank: int) -> None:
    e = data.draw(expressions(rank, depth=2))
    at = data.draw(coordinates(SHORT_NAMES, rank, size=3))
    exact = _tuple(evaluate(e, {n: tuple(map(Fraction, c)) for n, c in at.items()}))
    assert _tuple(evaluate(e, at)) == exact
    residues = {n: np.array([[x % SMALL_PRIME for x in c]] * 2, dtype=np.int64) for n, c in at.items()}
    expected = [x.numerator * pow(x.denominator, -1, SMALL_PRIME) % SMALL_PRIME for x in map(Fraction, exact)]
    for value, residue in zip(_tuple(evaluate(e, residues, modulus=SMALL_PRIME)), expected, strict=True):
        assert np.all(np.asarray(value) % SMALL_PRIME == residue)
    floats = _tuple(evaluate(e, {n: np.array([c, c], dtype=float) for n, c in at.items()}))
    if max((abs(x.numerator) for x in map(Fraction, exact)), default=0) < 2**20:
        for value, x in zip(floats, exact, strict=True):
            np.testing.assert_allclose(np.asarray(value, dtype=float), float(x), rtol=1e-3, atol=1e-3)


def _tuple(value: Any) -> tuple[Any, ...]:
    return value if isinstance(value, tuple) else (value,)


@given(st.data(), RANKS)
def test_arrays_are_evaluated_point_by_point(data: st.DataObject, rank: int) -> None:
    e = data.draw(expressions(rank, depth=2))
    many = [random_rational_points(points_of(e), rank=rank, seed=s, size=2) for s in range(3)]
    stacked = {n: np.array([m[n] for m in many], dtype=object) for n in points_of(e)}
    found = _tuple(evaluate(e, stacked)) if stacked else ()
    for i, coordinate in enumerate(found):
        values = np.broadcast_to(np.asarray(coordinate, dtype=object), (3,))
        assert list(values) == [_tuple(evaluate(e, m))[i] for m in many]


def test_missing_and_unlike_coordinates() -> None:
    with pytest.raises(InputError, match="no coordinates given for b, c"):
        evaluate(parse("abc"), {"a": (1, 0, 0, 1)})
    with pytest.raises(InputError, match="different numbers of coordinates"):
        evaluate(parse("ab"), {"a": (1, 0, 0, 1), "b": (1, 0, 1)})
    with pytest.raises(InputError, match="a scalar has no"):
        plucker(parse("[abcd]"), random_rational_points("abcd"))


# --- meets ---------------------------------------------------------------------------------------------------------

PAIRS = [(d, k, h) for d in ALL_RANKS for k in range(1, d + 1) for h in range(1, d + 1) if k + h >= d]
_pairs = pytest.mark.parametrize(("rank", "k", "h"), PAIRS, ids=["-".join(map(str, p)) for p in PAIRS])


def two_extensors(rank: int, k: int, h: int) -> tuple[list[str], list[str], dict[str, tuple[int, ...]]]:
    a, b = names(k, "a"), names(h, "b")
    rng = random.Random(f"{rank} {k} {h}")
    return a, b, {n: tuple(rng.randint(-40, 40) for _ in range(rank)) for n in (*a, *b)}


@_pairs
def test_meet_by_its_definition(rank: int, k: int, h: int) -> None:
    """A ∧ B = Σ sgn · [a_σ(1) … a_σ(d−h) B] a_σ(d−h+1) … a_σ(k), from determinants and minors alone."""
    a, b, at = two_extensors(rank, k, h)
    expected = [Fraction(0)] * comb(rank, k + h - rank)
    for first in combinations(range(k), rank - h):
        rest = [i for i in range(k) if i not in first]
        sign = permutation_sign([*first, *rest])
        scalar = sign * determinant(columns([*(at[a[i]] for i in first), *(at[n] for n in b)]))
        extensor = minors([at[a[i]] for i in rest]) if rest else (Fraction(1),)
        expected = [x + scalar * y for x, y in zip(expected, extensor, strict=True)]
    assert _tuple(evaluate(ex.meet(joined(a, rank), joined(b, rank), rank=rank), at)) == tuple(expected)


@_pairs
def test_meet_changes_sign_by_the_steps(rank: int, k: int, h: int) -> None:
    a, b, at = two_extensors(rank, k, h)
    A, B = joined(a, rank), joined(b, rank)
    sign = (-1) ** ((rank - k) * (rank - h))
    left = _tuple(evaluate(ex.meet(A, B, rank=rank), at))
    right = _tuple(evaluate(ex.meet(B, A, rank=rank), at))
    assert any(left)
    assert left == tuple(sign * x for x in right)


@_pairs
def test_join_changes_sign_by_the_steps(rank: int, k: int, h: int) -> None:
    if k + h > rank:
        with pytest.raises(StepError):
            ex.join(joined(names(k, "a"), rank), joined(names(h, "b"), rank), rank=rank)
        return
    a, b, at = two_extensors(rank, k, h)
    left = evaluate(joined([*a, *b], rank), at)
    assert left == tuple((-1) ** (k * h) * x for x in evaluate(joined([*b, *a], rank), at))


@_pairs
def test_meet_is_the_intersection(rank: int, k: int, h: int) -> None:
    a, b, at = two_extensors(rank, k, h)
    common = meet_of_spans([at[n] for n in a], [at[n] for n in b])
    found = _tuple(evaluate(ex.meet(joined(a, rank), joined(b, rank), rank=rank), at))
    if k + h == rank:
        assert (found[0] == 0) == bool(common)
    else:
        assert len(common) == k + h - rank
        assert proportional(found, minors(common))


TRIPLES = [(d, k, h, l) for d in range(2, 7) for k, h, l in product(range(1, d + 1), repeat=3) if k + h + l > 2 * d]


@pytest.mark.parametrize(("rank", "k", "h", "l"), TRIPLES, ids=["-".join(map(str, t)) for t in TRIPLES])
def test_meet_is_associative(rank: int, k: int, h: int, l: int) -> None:
    """Grouping to the right is computed by way of points that span the inner meet: the parser's own form is flat."""
    rng = random.Random(f"{rank} {k} {h} {l}")
    groups = [names(k, "a"), names(h, "b"), names(l, "c")]
    at = {n: tuple(rng.randint(-40, 40) for _ in range(rank)) for g in groups for n in g}
    A, B, C = (joined(g, rank) for g in groups)
    flat = _tuple(evaluate(ex.meet(A, B, C, rank=rank), at))
    inner = _tuple(evaluate(ex.meet(B, C, rank=rank), at))
    span = meet_of_spans([at[n] for n in groups[1]], [at[n] for n in groups[2]])
    if not any(inner) or len(span) != h + l - rank:
        pytest.fail("the points are too special")
    extensor = minors(span)
    at_of = next(i for i, x in enumerate(extensor) if x)
    scale = inner[at_of] / extensor[at_of]
    own = {f"m{i}": tuple(p) for i, p in enumerate(span)}
    right = _tuple(evaluate(ex.meet(A, joined(list(own), rank), rank=rank), at | own))
    assert flat == tuple(scale * x for x in right)


def at_random(letters: str, seed: int = 0, size: int = 9) -> dict[str, tuple[int, ...]]:
    return random_rational_points(letters, seed=seed, size=size)


@pytest.mark.parametrize("seed", range(5))
def test_plane_through_points(seed: int) -> None:
    at = at_random("abc", seed)
    (normal,) = null_space([at[n] for n in "abc"], 4)
    p = plucker(parse("abc"), at)  # minors of the rows 123, 124, 134, 234
    assert proportional([-p[3], p[2], -p[1], p[0]], normal)


@pytest.mark.parametrize("seed", range(5))
def test_planes_meet_in_a_line_of_both(seed: int) -> None:
    at = at_random("abcdef", seed)
    line = meet_of_spans([at[n] for n in "abc"], [at[n] for n in "def"])
    assert proportional(plucker(parse(r"abc /\ def"), at), minors(line))
    on = at | {"x": line[0], "y": line[1]}
    for plane in ("abc", "def"):
        assert evaluate(parse(f"[{plane}x]"), on) == evaluate(parse(f"[{plane}y]"), on) == 0


@pytest.mark.parametrize("seed", range(5))
def test_plane_and_line_meet_in_a_point_of_both(seed: int) -> None:
    at = at_random("abcde", seed)
    x = evaluate(parse(r"abc /\ de"), at)
    on = at | {"x": x}
    assert any(x)
    assert evaluate(parse("[abcx]"), on) == 0
    assert evaluate(parse("dex"), on) == (0, 0, 0, 0)
    d, e = (evaluate(parse(f"[abc{n}]"), at) for n in "de")
    assert x == tuple(e * p - d * q for p, q in zip(at["d"], at["e"], strict=True))


# --- superbracket --------------------------------------------------------------------------------------------------

LINES = ["ab", "cd", "ef", "gh", "ij", "kl"]
SB = "[[ab, cd, ef, gh, ij, kl]]"


@pytest.mark.parametrize("seed", range(5))
def test_superbracket_is_the_determinant_of_the_rows(seed: int) -> None:
    at = at_random("abcdefghijkl", seed)
    rows = [plucker(parse(line), at) for line in LINES]
    value = evaluate(parse(SB), at)
    assert value == determinant(rows) != 0
    forces = []
    for a, b in map(tuple, LINES):
        f = np.subtract(at[b][:3], at[a][:3])
        forces.append([int(x) for x in (*f, *np.cross(at[a][:3], f))])
    assert value == -determinant(forces)


def test_superbracket_over_arrays() -> None:
    rng = np.random.default_rng(0)
    at = {n: rng.uniform(-1, 1, (5, 4)) for n in "abcdefghijkl"}
    rows = np.stack([np.stack(plucker(parse(line), at), axis=-1) for line in LINES], axis=-2)
    np.testing.assert_allclose(evaluate(parse(SB), at), np.linalg.det(rows), rtol=1e-9)


# --- facts ---------------------------------------------------------------------------------------------------------

FORM_24 = (
    "-[abcd][efgi][hjkl]+[abcd][efhi][gjkl]+[abcd][efgj][hikl]-[abcd][efhj][gikl]+[abce][dfgh][ijkl]-[abde][cfgh][ijkl]"
    "-[abcf][degh][ijkl]+[abdf][cegh][ijkl]-[abce][dghi][fjkl]+[abde][cghi][fjkl]+[abcf][dghi][ejkl]+[abce][dghj][fikl]"
    "-[abdf][cghi][ejkl]-[abde][cghj][fikl]-[abcf][dghj][eikl]+[abdf][cghj][eikl]+[abcg][defi][hjkl]-[abdg][cefi][hjkl]"
    "-[abch][defi][gjkl]-[abcg][defj][hikl]+[abdh][cefi][gjkl]+[abdg][cefj][hikl]+[abch][defj][gikl]-[abdh][cefj][gikl]"
)


def t_form(x: Sequence[str], y: Sequence[str]) -> str:
    """T(X1, X2, X3; Y12, Y13, Y23) = Σ (−1)^(i+j+k) [X1 Y12_i Y13_j][Y12_(1−i) X2 Y23_k][Y13_(1−j) Y23_(1−k) X3]."""
    terms = []
    for i, j, k in product((0, 1), repeat=3):
        sign = "-" if (i + j + k) % 2 else "+"
        first = f"[{x[0]}{y[0][i]}{y[1][j]}]"
        second = f"[{y[0][1 - i]}{x[1]}{y[2][k]}]"
        third = f"[{y[1][1 - j]}{y[2][1 - k]}{x[2]}]"
        terms.append(f"{sign}{first}{second}{third}")
    return "".join(terms)


FORM_16 = f"{t_form(LINES[:3], LINES[3:])} - ({t_form(LINES[3:], LINES[:3])})"

IDENTITIES = {
    "24-term form": f"{SB} == {FORM_24}",
    "16-term form": f"{SB} == {FORM_16}",
    "line and line": r"ab /\ cd == [abcd]",
    "line and plane": r"ab /\ cde == [acde] b - [bcde] a",
    "octahedron": "[[ab,af,cb,cd,ed,ef]] == [abfc][acde][bdef] + [abfd][acbe][cdef]",
    "octahedron, alternate faces": r"[[ab,af,cb,cd,ed,ef]] == ace /\ abf /\ cbd /\ edf",
    "octahedron, the other faces": r"[[ab,af,cb,cd,ed,ef]] == bdf /\ acb /\ ced /\ eaf",
    "6-3 with three pairs": r"[[Aa,Ab,Bc,Bd,Ce,Cf]] == -(Aab /\ Bcd /\ Cef /\ ABC)",
    "three tetrahedra": "[[Aa,Ab,Ac,Bd,Be,Cf]] == [Aabc][ABde][ABCf]",
    "tetrahedron and planes": "[[Aa,Ab,Ac,Bd,Ce,Df]] == -[Aabc]([ABdC][AeDf] - [ABde][ACDf])",
    "tetrahedron and lines": r"[[Aa,Ab,Ba,Bb,Cc,Dd]] == -[ABab]((AB /\ Cc)(ab /\ Dd) - (AB /\ Dd)(ab /\ Cc))",
    "4-4.7": r"[ABCc] [[Aa,Ab,Bc,Bd,Ca,Dc]] == -(Aab /\ Bcd /\ ABC /\ ((ACc /\ BDc) a))",
    "4-4.5": r"[ADbd] [[Aa,Ab,Ba,Bc,Cb,Dd]] == -(ADd /\ ACb /\ Bac /\ ((Aab /\ Dbd) B))",
    "5-4.4": r"[ADae] [[Aa,Ab,Bc,Bd,Ca,De]] == -(ADe /\ ACa /\ Bcd /\ ((Aab /\ Dae) B))",
    "four degrees of freedom": "[[S1A1,S1B1,S1C1,S2A2,S3A3,S3B3]] == [S1A1B1C1][S1S3A3B3][S1S3S2A2]",
    "dotted points are shared out": "[.a d e f][.b g h i] == [adef][bghi] - [bdef][aghi]",
    "Grassmann-Pluecker relation": "[.a .b .c .d][.e f g h] == 0",
    "planes are anticommutative": r"abc /\ def == -(def /\ abc)",
}


def holds(equation: str, rank: int = 4, ideal: Sequence[str] = (), seeds: int = 3) -> bool:
    left, right = parse_equation(equation, rank=rank)
    return agree(left, right, rank, ideal, seeds)


def agree(left: Expr, right: Expr, rank: int = 4, ideal: Sequence[str] = (), seeds: int = 3) -> bool:
    """At exact whole points; both sides must not vanish there unless one of them is the number 0."""
    for seed in range(seeds):
        at = random_rational_points(points_of(left, right), rank=rank, ideal=ideal, seed=seed)
        values = [_tuple(evaluate(e, at)) for e in (left, right)]
        if right == ex.ZERO or left == ex.ZERO:
            if any(map(any, values)):
                return False
        elif values[0] != values[1] or not any(values[0]):
            return False
    return True


@pytest.mark.parametrize("equation", IDENTITIES.values(), ids=IDENTITIES.keys())
def test_identity(equation: str) -> None:
    assert holds(equation)


@pytest.mark.parametrize("equation", IDENTITIES.values(), ids=IDENTITIES.keys())
def test_identity_with_a_wrong_sign_is_noticed(equation: str) -> None:
    left, right = parse_equation(equation)
    assert right == ex.ZERO or not agree(left, ex.neg(right))


def test_forms_have_as_many_terms_as_they_are_named_for() -> None:
    assert len(parse(FORM_24).children) == 24
    assert FORM_16.count("[") == 3 * 16


def test_straightening_in_rank_3() -> None:
    assert holds(
        "[p1p4p5][p1p5p6][p2p3p4] == [p2p5p6][p1p4p5][p1p3p4] - [p3p5p6][p1p4p5][p1p2p4] + [p4p5p6][p1p4p5][p1p2p3]",
        rank=3,
    )


def test_four_ideal_points() -> None:
    assert holds("[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] - [jkla][ibcd] == 0", ideal="ijkl")
    assert holds("[ijkl] == 0", ideal="ijkl")
    assert not holds("[ijka] == 0", ideal="ijkl")


CONSTRUCTIONS = {
    "5-5.1": (
        {"t1": r"ADd /\ AEe"},
        {"left": r"[ACac] (t1 /\ ab)", "right": r"(a (Cc /\ Aab)) /\ (Dd (Ee /\ Aab)) /\ ((Cc /\ aAB) t1)"},
        "[[Aa,Ab,Ba,Cc,Dd,Ee]]",
        1,
    ),
    "6-5": (
        {"p1": r"ABc /\ ACd", "t1": r"ADe /\ AEf", "q1": r"(Bc /\ Aab) (Cd /\ Aab)"},
        {"left": r"(p1 /\ ab)(t1 /\ ab)", "right": r"q1 /\ (De (Ef /\ Aab)) /\ (p1 (De /\ AEf))"},
        "[[Aa,Ab,Bc,Cd,De,Ef]]",
        -1,
    ),
}


@pytest.mark.parametrize("name", CONSTRUCTIONS)
def test_incidence_with_a_cofactor(name: str) -> None:
    bound, sides, superbracket, sign = CONSTRUCTIONS[name]
    cofactor, right = (replaced(sides[key], bound) for key in ("left", "right"))
    assert agree(ex.mul(parse(cofactor), parse(superbracket)), ex.mul(ex.Number(sign), parse(right)))


def replaced(source: str, bound: dict[str, str]) -> str:
    """The names p1, q1, t1 written out."""
    for name, value in bound.items():
        source = source.replace(name, f"({value})")
    return source


# The seven classes with two pencils of legs (A; a, b), (B; c, d) without a common leg, and the remaining legs g, h.
# The superbracket is written with the legs in this sequence: Aa, Ab, Bc, Bd, g, h.
TRANSVERSALS = {
    "6-4.2": ("A", "ab", "B", "cd", "Ce", "Df"),
    "5-5.2": ("A", "ab", "c", "BC", "Dd", "Ee"),
    "5-4.3": ("A", "ab", "c", "BC", "Ba", "Dd"),
    "5-4.4": ("A", "ab", "B", "cd", "Ca", "De"),
    "4-4.4": ("A", "ab", "B", "ab", "Cc", "Dd"),
    "4-4.5": ("A", "ab", "B", "ac", "Cb", "Dd"),
    "4-4.7": ("A", "ab", "B", "cd", "Ca", "Dc"),
}


def pencils(name: str) -> tuple[Expr, dict[str, str]]:
    A, ab, B, cd, g, h = TRANSVERSALS[name]
    (a, b), (c, d) = tuple(ab), tuple(cd)
    legs = ", ".join([A + a, A + b, B + c, B + d, g, h])
    words = {"A": A, "B": B, "a": a, "b": b, "c": c, "d": d, "g": g, "h": h}
    return parse(f"[[{legs}]]"), words


@pytest.mark.parametrize("name", TRANSVERSALS)
def test_two_transversals(name: str) -> None:
    superbracket, w = pencils(name)
    A, B, a, b, c, d, g, h = (w[n] for n in "ABabcdgh")
    p, q = f"{A}{B}", rf"({A}{a}{b} /\ {B}{c}{d})"
    expression = parse(rf"({p} /\ {g})({q} /\ {h}) - ({p} /\ {h})({q} /\ {g})")
    assert agree(superbracket, expression) or agree(superbracket, ex.neg(expression))


@pytest.mark.parametrize("name", TRANSVERSALS)
def test_one_incidence_of_two_pencils(name: str) -> None:
    superbracket, w = pencils(name)
    A, B, a, b, c, d, g, h = (w[n] for n in "ABabcdgh")
    t = rf"({A}{g} /\ {A}{h})"
    s = rf"(({g} /\ {A}{a}{b}) ({h} /\ {A}{a}{b}))"
    left = ex.mul(parse(rf"{t} /\ {a}{b}"), superbracket)
    right = parse(rf"-({s} /\ {B}{c}{d} /\ ({t} {B}))")
    assert agree(left, right)


# --- random points and vanishing -----------------------------------------------------------------------------------


def test_random_points_at_infinity() -> None:
    for at in (random_points("abi", ideal="i"), random_rational_points("abi", ideal="i")):
        last = {n: np.asarray(c)[..., -1] for n, c in at.items()}
        assert not np.any(last["i"])
        assert np.all(last["a"])


def test_random_points_depend_on_the_seed_alone() -> None:
    make: list[Callable[[int], Any]] = [
        lambda s: random_rational_points("abcd", seed=s),
        lambda s: {n: np.asarray(c).tolist() for n, c in random_points("abcd", seed=s).items()},
    ]
    for points in make:
        assert points(1) == points(1)
        assert points(1) != points(2)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("0", True),
        ("1", False),
        ("[abcd] + [bacd]", True),
        ("[abcd] - [bacd]", False),
        ("ab + ba", True),
        ("ab - ba", False),
        ("[abca]", True),
        (r"ab /\ cd - [abcd]", True),
        (r"(ab /\ cde) - [acde] b + [bcde] a", True),
        (f"{SB} - ({FORM_24})", True),
        (f"{SB} - ({FORM_24}) + [abcd][efgh][ijkl]", False),
        ("1/3 [abcd] - [abcd] * 2/6", True),
    ],
)
def test_vanishes(source: str, expected: bool) -> None:
    assert vanishes(parse(source)) is expected
