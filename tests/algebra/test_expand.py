"""Expansion against the exact oracle, which shares no code with it: every pair of steps in every rank."""

from __future__ import annotations

import random
from collections.abc import Iterable
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator, evaluate, random_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, Point, join, meet, points_of
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.scalars import bracket
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import permutation_sign

LETTERS = "abcdefghijklmnopqrstuvwxyz"
RANKS = range(2, 9)
MEETS = [(d, k, h) for d in RANKS for k, h in product(range(1, d), repeat=2) if k + h >= d]


def extensor(step: int, at: int = 0) -> Expr:
    return join(*(Point(n) for n in LETTERS[at : at + step]), rank=8)


def agrees(e: Expr, rank: int, ideal: Iterable[str] = (), seed: int = 0) -> bool:
    """Whether expression and expansion have one value at random points, and that value is not just 0 = 0."""
    points = random_points(points_of(e), rank=rank, ideal=ideal, seed=seed)
    value = Evaluator(points, rank, PRIME).value(e)
    expanded = expand(e, rank=rank, ideal=ideal)
    if not expanded:
        return not any(value)
    return any(value) and Evaluator(points, rank, PRIME).value(expanded.to_expr()) == value


def equal(a: Expr, b: Expr, rank: int) -> bool:
    points = Evaluator(random_points(points_of(a, b), rank=rank), rank, PRIME)
    return points.value(a) == points.value(b)


@pytest.mark.parametrize(("rank", "k", "h"), MEETS)
def test_meet(rank: int, k: int, h: int) -> None:
    a, b = extensor(k), extensor(h, k)
    assert agrees(meet(a, b, rank=rank), rank)
    assert expand(meet(a, b, rank=rank)).step == k + h - rank


@pytest.mark.parametrize(("rank", "k", "h"), MEETS)
def test_meet_changes_sign_by_the_rule(rank: int, k: int, h: int) -> None:
    a, b = extensor(k), extensor(h, k)
    sign = (-1) ** ((rank - k) * (rank - h))
    flipped = ex.mul(ex.Number(sign), meet(b, a, rank=rank))
    assert equal(meet(a, b, rank=rank), flipped, rank)
    assert equal(expand(meet(a, b, rank=rank)).to_expr(), expand(flipped, rank=rank).to_expr(), rank)


@pytest.mark.parametrize(("rank", "k", "h"), MEETS)
def test_meet_with_shared_points(rank: int, k: int, h: int) -> None:
    checked = 0
    for shared in range(1, min(k, h) + 1):
        e = meet(extensor(k), extensor(h, k - shared), rank=rank)
        if k + h - shared < rank:  # they span less than the whole space, so the meet is zero
            assert not expand(e)
        assert agrees(e, rank)
        checked += 1
    assert checked


TRIPLES = [
    (d, *steps)
    for d in range(2, 7)
    for steps in product(range(1, d), repeat=3)
    if steps[0] + steps[1] > d and sum(steps) >= 2 * d and steps[1] + steps[2] >= d
]


@pytest.mark.parametrize(("rank", "k", "h", "m"), TRIPLES)
def test_meet_of_three_is_associative(rank: int, k: int, h: int, m: int) -> None:
    a, b, c = extensor(k), extensor(h, k), extensor(m, k + h)
    one = meet(meet(a, b, rank=rank), c, rank=rank)
    # The language flattens meets, so the other grouping is made through the expansion of its inner meet.
    inner = expand(meet(b, c, rank=rank)).to_expr()
    assert agrees(one, rank)
    if inner.step:
        assert equal(one, meet(a, inner, rank=rank), rank)


@pytest.mark.parametrize(("rank", "k", "h"), [case for case in MEETS if case[0] <= 5])
def test_meet_is_bilinear(rank: int, k: int, h: int) -> None:
    a, b, c = extensor(k), extensor(k, k), extensor(h, 2 * k)
    mixed = ex.add(ex.mul(ex.Number(2), a), ex.mul(ex.Number(-3), b), rank=rank)
    apart = [ex.mul(ex.Number(n), meet(x, c, rank=rank)) for n, x in ((2, a), (-3, b))]
    assert agrees(meet(mixed, c, rank=rank), rank)
    assert equal(meet(mixed, c, rank=rank), ex.add(*apart, rank=rank), rank)


@pytest.mark.parametrize("rank", RANKS)
def test_a_point_of_both_lies_in_the_meet(rank: int) -> None:
    """x on both extensors is on their meet: x joined with the meet is zero."""
    found = 0
    for k, h in product(range(2, rank), repeat=2):
        if 1 < k + h - rank + 1 <= rank:
            x = Point("x")
            a, b = join(x, extensor(k - 1), rank=8), join(x, extensor(h - 1, k), rank=8)
            if k + h > rank:
                e = join(meet(a, b, rank=rank), x, rank=rank)
                assert not any(Evaluator(random_points(points_of(e), rank=rank), rank, PRIME).value(e))
                assert not any(
                    Evaluator(random_points(points_of(e), rank=rank), rank, PRIME).value(expand(e, rank=rank).to_expr())
                )
                found += 1
    assert found or rank == 2


TABLE = [
    pytest.param(r"ab /\ cd", "[abcd]", id="two lines"),
    pytest.param(r"ab /\ cde", "[acde] b - [bcde] a", id="line and plane"),
    pytest.param(r"abc /\ def", "[adef] bc - [bdef] ac + [cdef] ab", id="two planes"),
    pytest.param(r"abc /\ d", "[abcd]", id="plane and point"),
    pytest.param(r"a /\ bcd", "[abcd]", id="point and plane"),
    pytest.param(r"abc /\ abd", "[abcd] ab", id="planes with a common line"),
    pytest.param(r"abc /\ abc", "0", id="a plane with itself"),
    pytest.param(r"[ab /\ cde, f, g, h]", "[acde][bfgh] - [bcde][afgh]", id="bracket with an extensor entry"),
    pytest.param(r"[ab, cd]", "[abcd]", id="bracket of two lines"),
    pytest.param("[.a c d e][.b f g h]", "[acde][bfgh] - [bcde][afgh]", id="dotted"),
    pytest.param("[a b c .d][.e f g h]", "[abcd][efgh] - [abce][dfgh]", id="dotted at other places"),
    pytest.param("[.a.b c d][.e f g h]", "[abcd][efgh] - [aecd][bfgh] + [becd][afgh]", id="two dots in one bracket"),
    pytest.param("[[ab, ab, cd, ef, gh, ij]]", "0", id="superbracket with equal lines"),
    pytest.param("([abcd] - [abcd]) ** 3", "0", id="power of zero"),
    pytest.param("1/2 [abcd] + 1/2 [abcd]", "[abcd]", id="fractions"),
]


@pytest.mark.parametrize(("text", "expected"), TABLE)
def test_table(text: str, expected: str) -> None:
    e, right = parse(text), parse(expected)
    assert agrees(e, 4)
    if expected == "0":
        assert not expand(e)
    else:
        assert equal(e, right, 4)
        assert equal(expand(e).to_expr(), right, 4)


NESTED = [
    r"((ab /\ cde) \/ f \/ g) /\ ((hij /\ klm) \/ n)",
    r"((ab /\ cde) f - 2 (ab /\ fgh) c) /\ ij",
    r"(abc /\ def /\ ghi) \/ (jkl /\ mno)",
    r"[[abc /\ def, ghi /\ jkl, ab, cd, (e \/ fg) /\ hij, kl]]",
    r"[[ab, cd - 3 ef, gh, ij, kl, am]]",
    r"((abc /\ ade) \/ f) /\ ((ab /\ cdf) \/ de)",
    r"([abcd] + 2 [abce])**3 * (ab /\ cd)",
    "[.a.b c d][.e f g h][.i j k l]",
]


@pytest.mark.parametrize("text", NESTED)
@pytest.mark.parametrize("ideal", ["", "a", "adg", "abc"])
def test_nested(text: str, ideal: str) -> None:
    assert agrees(parse(text), 4, ideal)


@pytest.mark.parametrize("rank", RANKS)
def test_random_nests(rank: int) -> None:
    """Meets of joins of meets, with points drawn from few letters so that many are shared."""
    rng = random.Random(rank)
    nonzero = 0
    for _ in range(12):
        k = rng.randrange(1, rank)
        letters = LETTERS[: rank + 3]
        names = [rng.sample(letters, n) for n in (k, rank - k, 1, rank - 1)]
        a, b, c, d = (join(*map(Point, n), rank=8) for n in names)
        inner = meet(join(a, b, rank=rank), d, rank=rank) if rank > 2 else c
        e = meet(ex.add(inner, inner if rng.random() < 0.5 else d, rank=rank), join(c, rank=rank), rank=rank)
        assert agrees(e, rank, seed=rng.randrange(99))
        nonzero += bool(expand(e, rank=rank))
    assert nonzero


def test_ideal_points() -> None:
    assert not expand(parse("[ijkl]"), ideal="ijkl")
    assert not expand(parse(r"ijk /\ l"), ideal="ijkl")
    assert expand(parse("[ijka]"), ideal="ijk")
    assert expand(parse("[abij]"), points="ba", ideal="ji").points == ("j", "i", "b", "a")


def test_types_and_order() -> None:
    scalar, line = expand(parse("[dcba]"), points="dcba"), expand(parse("ba"))
    assert isinstance(scalar, BracketPolynomial)
    assert (str(scalar), scalar.points) == ("[dcba]", ("d", "c", "b", "a"))
    assert isinstance(line, ExtensorPolynomial)
    assert str(line) == "-ab"


SUM = "(" + " + ".join(f"ax{i}" for i in range(12)) + ")"
LARGE = [
    pytest.param("[[" + ", ".join([SUM] * 6) + "]]", id="superbracket of sums through one point"),
    pytest.param("(" + " + ".join(f"[abcx{i}]" for i in range(20)) + ")**20", id="power"),
    pytest.param("[.a.b.c.d][.e.f.g.h][.i.j.k.l][.m.n.o.p]", id="sixteen dots"),
]


@pytest.mark.parametrize("text", LARGE)
def test_limits(text: str) -> None:
    with pytest.raises(LimitReached):
        expand(parse(text), limit=20_000)


@given(st.integers(2, 8).flatmap(lambda d: st.tuples(st.just(d), st.permutations(range(d)))))
def test_bracket_is_alternating(case: tuple[int, list[int]]) -> None:
    rank, order = case
    names = LETTERS[:rank]
    one = expand(bracket(*(Point(names[i]) for i in order), rank=rank))
    assert one.to_expr() == ex.mul(ex.Number(permutation_sign(order)), bracket(*map(Point, names), rank=rank))
    assert not expand(bracket(*(Point(names[i]) for i in (*order[:-1], order[0])), rank=rank))


def test_oracle_knows_the_determinant() -> None:
    """The oracle itself against numbers done by hand: the unit corner, and Plücker coordinates of an axis."""
    corner = {"a": (0, 0, 0, 1), "b": (1, 0, 0, 1), "c": (0, 1, 0, 1), "d": (0, 0, 1, 1)}
    assert evaluate(parse("[abcd]"), corner) == -1
    assert evaluate(parse(r"ab /\ cd"), corner) == -1
    assert evaluate(parse(r"abc /\ abd"), corner) == tuple(-c for c in evaluate(parse("ab"), corner))
