"""Straightening: three methods that share no code agree, results are standard, and equal functions have equal forms."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from math import factorial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gcrules.algebra import diagonal
from gcrules.algebra.bracket import BracketPolynomial, Terms
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import sub
from gcrules.algebra.straighten import is_standard, straighten, straighten_steps
from gcrules.algebra.superbracket import form_terms
from gcrules.algebra.syntax import parse
from gcrules.errors import LimitReached


@st.composite
def polynomials(draw: st.DrawFn, most_rows: int = 3) -> BracketPolynomial:
    """Homogeneous or not, points repeated, rational coefficients, the first few points ideal."""
    rank = draw(st.integers(2, 5))
    names = tuple("abcdefghijkl"[: draw(st.integers(rank + 1, 2 * rank + 2))])
    row = st.lists(st.integers(0, len(names) - 1), min_size=rank, max_size=rank, unique=True).map(
        lambda r: tuple(sorted(r))
    )
    monomial = st.lists(row, min_size=1, max_size=most_rows).map(lambda m: tuple(sorted(m)))
    coefficient = st.integers(-5, 5) | st.fractions(-3, 3, max_denominator=7)
    terms = draw(st.dictionaries(monomial, coefficient, max_size=4))
    return BracketPolynomial(rank, names, terms, draw(st.integers(0, 3)))


def value(p: BracketPolynomial, seed: int = 0) -> int:
    points = random_points(p.points, rank=p.rank, ideal=p.points[: p.ideal], seed=seed)
    return int(Evaluator(points, p.rank, PRIME).value(p.to_expr())[0])


@settings(max_examples=150)
@given(polynomials())
def test_three_methods_agree(p: BracketPolynomial) -> None:
    fast = straighten(p)
    assert isinstance(fast, BracketPolynomial)
    slow, steps = straighten_steps(p)
    assert fast == slow == diagonal.normal_form(p)
    assert all(is_standard(m) for m in fast.terms)
    assert straighten(fast) == fast
    assert value(p) == value(fast)
    for step in steps:
        assert vanishes(step.identity, rank=p.rank, ideal=p.points[: p.ideal], samples=1)


@settings(max_examples=60)
@given(polynomials(2), polynomials(2))
def test_the_form_is_linear(p: BracketPolynomial, q: BracketPolynomial) -> None:
    if p.rank == q.rank and p.ideal == q.ideal:
        q = q.over(p.points, p.ideal) if len(q.points) <= len(p.points) else q
        p = p.over(q.points, p.ideal)
        assert straighten(p + q) == straighten(p) + straighten(q)
        assert straighten(p * Fraction(2, 3)) == straighten(p) * Fraction(2, 3)


def hook_count(rows: int, columns: int) -> int:
    hooks = 1
    for i in range(rows):
        for j in range(columns):
            hooks *= rows - i + columns - j - 1
    return factorial(rows * columns) // hooks


@pytest.mark.parametrize(
    ("rank", "rows"), [(2, 2), (2, 5), (3, 2), (3, 3), (3, 4), (4, 2), (4, 3), (5, 2), (6, 2), (8, 2)]
)
def test_number_of_standard_tableaux(rank: int, rows: int) -> None:
    found = list(diagonal.standard_tableaux(tuple(range(rank * rows)), rank))
    assert len(found) == len(set(found)) == hook_count(rows, rank)
    assert all(is_standard(m) for m in found)


def test_standard_tableaux_with_repeated_points() -> None:
    content = (0, 0, 1, 1, 2, 2, 3, 4, 5)
    rows = list(diagonal.standard_tableaux(content, 3))
    assert rows
    assert all(Counter(i for row in m for i in row) == Counter(content) and is_standard(m) for m in rows)


@pytest.mark.parametrize(
    "monomial", ["[afgl][behk][cdij]", "[adgj][behk][cfil]", "[ahij][bgkl][cdef]", "[abkl][cdij][efgh]"]
)
def test_twelve_points(monomial: str) -> None:
    p = expand(parse(monomial))
    assert straighten(p) == diagonal.normal_form(p)


def test_the_rank_3_fact() -> None:
    form = straighten(parse("[p1p4p5][p1p5p6][p2p3p4]", rank=3))
    expected = "[p2p5p6][p1p4p5][p1p3p4] - [p3p5p6][p1p4p5][p1p2p4] + [p4p5p6][p1p4p5][p1p2p3]"
    assert form == expand(parse(expected, rank=3))


FOUR_IDEAL = "[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] - [jkla][ibcd]"


@pytest.mark.parametrize("declared", ["", "abcdijkl", "dlckbjai"])
def test_four_ideal_points(declared: str) -> None:
    """Zero for ideal i, j, k, l whatever order is declared, since ideal points come first; not zero for others."""
    assert not straighten(parse(FOUR_IDEAL), ideal="ijkl", points=declared)
    assert straighten(parse(FOUR_IDEAL), points=declared)
    assert straighten(parse(FOUR_IDEAL), ideal="ijk", points=declared)


def test_the_24_terms_are_a_normal_form() -> None:
    terms: Terms = {m: s for s, m in form_terms(24)}
    p = BracketPolynomial(4, tuple("abcdefghijkl"), terms)
    assert len(p) == 24
    assert straighten(p) == p == expand(parse("[[ab, cd, ef, gh, ij, kl]]"))


def test_the_16_terms_straighten_to_the_24() -> None:
    p = BracketPolynomial(4, tuple("abcdefghijkl"), {m: s for s, m in form_terms(16)})
    assert len(p) == 16
    assert straighten(p) == straighten(parse("[[ab, cd, ef, gh, ij, kl]]"))


EXTENSORS = [
    pytest.param(r"ab /\ cde", r"cde /\ ab", id="line and plane"),
    pytest.param(r"abc /\ def", r"-def /\ abc", id="two planes"),
    pytest.param(r"abc /\ def", "[abcd] ef - [abce] df + [abcf] de", id="split on the other side"),
    pytest.param(r"abc /\ def /\ ghi", r"ghi /\ abc /\ def", id="three planes"),
    pytest.param("[abcd] e", "[ebcd] a + [aecd] b + [abed] c + [abce] d", id="Cramer's rule"),
    pytest.param("[abcd] efgh", "[efgh] abcd", id="whole space"),
    pytest.param("[abcd] efgh", "[ebcd] afgh + [fbcd] eagh + [gbcd] efah + [hbcd] efga", id="whole space, Cramer"),
    pytest.param(r"(ab /\ cde) \/ (abc /\ fgh)", r"(cde /\ ab) \/ (abc /\ fgh)", id="join of meets"),
]


@pytest.mark.parametrize(("left", "right"), EXTENSORS)
def test_extensors_have_one_form(left: str, right: str) -> None:
    a, b = parse(left), parse(right)
    assert vanishes(sub(a, b))
    names = sorted("abcdefgh")
    one, other = straighten(a, points=names), straighten(b, points=names)
    assert straighten(one) == one
    if one.points == other.points:
        assert one == other
    assert not straighten(sub(a, b))


def test_a_sign_apart_is_seen() -> None:
    assert straighten(parse(r"(ab /\ cde) + (cde /\ ab)"))
    assert straighten(parse("[abcd] efgh + [efgh] abcd"))


BIG = "7" * 1000


def test_thousand_digits() -> None:
    one = straighten(parse("[afgl][behk][cdij]"))
    many = straighten(parse(f"{BIG} [afgl][behk][cdij]"))
    assert dict(many.terms) == {m: c * int(BIG) for m, c in one.terms.items()}
    assert str(many).startswith(str(int(BIG) * next(iter(one.terms.values())))[:50])


@pytest.mark.parametrize("text", ["0", "[abca]", "[abcd] - [abcd]", "([abcd] + [bacd])**4", r"abc /\ abc"])
def test_zero(text: str) -> None:
    form = straighten(parse(text))
    assert not form
    assert str(form) == "0"


SCRAMBLED = "".join(f"[p{i}p{19 - i}p{20 + i}p{39 - i}]" for i in range(10))
HARD = [
    pytest.param(SCRAMBLED, 4, id="forty points"),
    pytest.param("([afgl][behk][cdij])**6", 4, id="power"),
    pytest.param("[ahbgcfde][ipjoknlm][qxrwsvtu]".replace("h", "y"), 8, id="rank 8"),
]


@pytest.mark.parametrize(("text", "rank"), HARD)
def test_an_answer_or_a_limit(text: str, rank: int) -> None:
    e = parse(text, rank=rank)
    try:
        form = straighten(e, limit=2_000)
    except LimitReached:
        return
    assert vanishes(sub(e, form.to_expr(), rank=rank), rank=rank)


def test_forty_points_reach_the_limit() -> None:
    with pytest.raises(LimitReached):
        straighten(parse(SCRAMBLED), limit=2_000)


def test_steps_have_a_limit() -> None:
    with pytest.raises(LimitReached):
        straighten_steps(expand(parse("[afgl][behk][cdij]")), limit=3)


@pytest.mark.parametrize("seed", range(6))
def test_random_twelve_points(seed: int) -> None:
    order = random.Random(seed).sample(range(12), 12)
    m = tuple(sorted(tuple(sorted(order[i : i + 4])) for i in (0, 4, 8)))
    p = BracketPolynomial(4, tuple("abcdefghijkl"), {m: 1})
    slow, steps = straighten_steps(p, limit=20_000)
    assert straighten(p) == slow == diagonal.normal_form(p)
    assert steps or is_standard(m)
