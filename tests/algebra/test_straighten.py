"""Straightening: three methods that share no code agree, results are standard, and equal functions have equal forms."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from math import factorial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Terms
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import sub
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import text
from gcrules.algebra.straightening import batch as levels
from gcrules.algebra.straightening import diagonal
from gcrules.algebra.straightening import straighten as module
from gcrules.algebra.straightening.straighten import (
    is_standard,
    is_zero,
    straighten,
    straighten_steps,
    straighten_terms,
)
from gcrules.algebra.straightening.syzygies import exchange, offending_column, syzygy
from gcrules.algebra.straightening.work import Work
from gcrules.algebra.superbrackets.superbracket import form_terms
from gcrules.core.errors import LimitReached


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


@settings(max_examples=150)
@given(polynomials())
def test_many_at_a_time_gives_the_same(p: BracketPolynomial) -> None:
    """The arrays, which take over in long computations, from the start."""
    terms = {m: c for m, c in p.terms.items() if not any(row[-1] < p.ideal for row in m)}
    assert levels.straighten_levels(terms, p.ideal, Work(10_000)) == straighten(p).terms


@settings(max_examples=60)
@given(polynomials(), st.integers(-2, 2), st.booleans(), st.booleans())
def test_polynomials_read_like_expressions(p: BracketPolynomial, number: int, long: bool, unicode: bool) -> None:
    """The text is made without an expression of many parts, but is the same."""
    names = tuple(f"point_{n}" if long else n for n in p.points)
    p = BracketPolynomial(p.rank, names, {**p.terms, (): number})
    assert p.text(unicode=unicode) == text(p.to_expr(), unicode=unicode, names=names)


@settings(max_examples=60)
@given(polynomials())
def test_zero_is_seen_in_any_order(p: BracketPolynomial) -> None:
    form = straighten(p)
    assert is_zero(p) == (not form)
    assert is_zero(p - form)


@settings(max_examples=60)
@given(polynomials(), st.integers(0, 5))
def test_brackets_that_divide_change_nothing(p: BracketPolynomial, first: int) -> None:
    """Unless they are zero: those of points at infinity are."""
    one = tuple(i % len(p.points) for i in range(first, first + p.rank))
    row = tuple(sorted(one))
    product = p.with_terms({tuple(sorted((*m, row, row))): c for m, c in p.terms.items()})
    assert is_zero(product) == (is_zero(p) or row[-1] < p.ideal)


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


def products(points: int, rank: int, number: int, seed: int) -> dict[Monomial, int]:
    """A random sum of products of brackets in which each point occurs once."""
    rng, found = random.Random(seed), {}
    for _ in range(number):
        order = rng.sample(range(points), points)
        rows = sorted(tuple(sorted(order[i : i + rank])) for i in range(0, points, rank))
        found[tuple(rows)] = rng.choice((-2, -1, 1, 2))
    return found


LARGE = [
    pytest.param(16, 4, 1, 5771, id="four brackets of 16 points"),
    pytest.param(16, 4, 20, 14616, id="twenty such products"),
    pytest.param(15, 3, 10, 3081, id="15 points in the plane"),
]


@pytest.mark.parametrize(("points", "rank", "number", "terms"), LARGE)
def test_many_points(points: int, rank: int, number: int, terms: int) -> None:
    """Up to 24,024 standard tableaux: rewriting and the triangular system agree within the usual limit."""
    found = products(points, rank, number, seed=7)
    p = BracketPolynomial(rank, tuple(f"p{i}" for i in range(points)), found)
    form = straighten_terms(found)
    assert len(form) == terms
    assert diagonal.normal_form(p).terms == form


TOO_LARGE = [
    pytest.param("MAX_TABLEAUX", 400, products(12, 4, 1, seed=1), "more than 400 standard tableaux", id="12 points"),
    pytest.param("MAX_WORDS", 100, {tuple((i, i + 2, i + 4) for i in range(4)): 1}, "100 ways", id="points twice"),
    pytest.param("MAX_WORDS", 10**6, {8 * ((0, 2),) + 8 * ((2, 4),): 1}, "5,000 ways", id="a point sixteen times"),
]


@pytest.mark.parametrize(("name", "limit", "terms", "words"), TOO_LARGE)
def test_the_triangular_system_has_limits(
    monkeypatch: pytest.MonkeyPatch, name: str, limit: int, terms: Terms, words: str
) -> None:
    monkeypatch.setattr(diagonal, name, limit)
    (monomial,) = terms
    diagonal._basis.cache_clear()
    with pytest.raises(LimitReached, match=words):
        diagonal.normal_form(BracketPolynomial(len(monomial[0]), tuple("abcdefghijkl"), terms))


def test_large_coefficients_do_not_overflow() -> None:
    one = products(12, 4, 40, seed=1)
    for factor in (2**61, 2**63, Fraction(10**30, 7)):
        many = {m: c * factor for m, c in one.items()}
        expected = {m: c * factor for m, c in straighten_terms(one).items()}
        assert levels.straighten_levels(many, 0, Work(10_000)) == expected
        p = BracketPolynomial(4, tuple("abcdefghijkl"), many)
        assert dict(diagonal.normal_form(p).terms) == expected


@pytest.mark.parametrize("extra", [(), ((0, 1, 2, 4), (11, 13, 14, 15))], ids=["one word", "two words"])
def test_arrays_take_over(monkeypatch: pytest.MonkeyPatch, extra: Monomial) -> None:
    """The same form wherever the arrays take over; with more possible rows than they number they never do.

    With 16 points the number of a product of more than five brackets does not fit into one word.
    """
    found = {tuple(sorted((*m, *extra))): c for m, c in products(16, 4, 1, seed=2).items()}
    form = straighten_terms(found)
    monkeypatch.setattr(module, "_FEW", 500)
    assert straighten_terms(found) == form
    monkeypatch.setattr(module, "_MOST_ROWS", 1_000)
    monkeypatch.setattr(levels, "straighten_levels", None)
    assert straighten_terms(found) == form


def test_the_work_counts_in_arrays_too() -> None:
    nearly_done = Work(2_000)
    nearly_done.replacements.spend(45_000)
    with pytest.raises(LimitReached, match="2,000 terms"):
        levels.straighten_levels(products(16, 4, 50, seed=7), 0, Work(2_000))
    with pytest.raises(LimitReached, match="replacements"):
        levels.straighten_levels(products(16, 4, 1, seed=7), 0, nearly_done)


PAIRS = st.integers(2, 6).flatmap(
    lambda rank: st.tuples(*2 * [st.sets(st.integers(0, 2 * rank), min_size=rank, max_size=rank)])
)


@settings(max_examples=60)
@given(PAIRS)
def test_two_rows(pair: tuple[set[int], set[int]]) -> None:
    """Syzygies and exchanges are identities, and make the first row smaller."""
    one, other = sorted(tuple(sorted(row)) for row in pair)
    rank, names = len(one), tuple("abcdefghijklm"[: 2 * len(one) + 1])
    column = offending_column(one, other)
    if column is None:
        assert is_standard((one, other))
        return
    for found in (list(syzygy(one, other, column)), list(exchange(one, other, column))):
        assert all(rows[0] < one for _, rows in found)
        terms: Terms = {(one, other): -1}
        for c, rows in found:
            terms[rows] = terms.get(rows, 0) + c
        assert vanishes(BracketPolynomial(rank, names, terms).to_expr(), rank=rank)


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


@pytest.mark.parametrize("zero", ["0", "[abca]", "[abcd] - [abcd]", "([abcd] + [bacd])**4", r"abc /\ abc"])
def test_zero(zero: str) -> None:
    form = straighten(parse(zero))
    assert not form
    assert str(form) == "0"


SCRAMBLED = "".join(f"[p{i}p{19 - i}p{20 + i}p{39 - i}]" for i in range(10))
HARD = [
    pytest.param(SCRAMBLED, 4, id="forty points"),
    pytest.param("([afgl][behk][cdij])**6", 4, id="power"),
    pytest.param("[ahbgcfde][ipjoknlm][qxrwsvtu]".replace("h", "y"), 8, id="rank 8"),
]


@pytest.mark.parametrize(("hard", "rank"), HARD)
def test_an_answer_or_a_limit(hard: str, rank: int) -> None:
    e = parse(hard, rank=rank)
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


def test_a_cheap_order_is_found_from_any_other() -> None:
    """Five lines: by the frequency of points alone, some orders took more than 200,000 terms at a time."""
    source = (EXAMPLES / "theorems" / "five-lines.gca").read_text(encoding="utf-8")
    claim = next(s for s in parse_script(source).statements if isinstance(s, Claim))
    ((left, right),) = claim.claimed.equations
    difference = expand(sub(left, right))
    assert isinstance(difference, BracketPolynomial)
    rng = random.Random(1)
    for _ in range(4):
        shuffled = difference.over(tuple(rng.sample(difference.points, len(difference.points))))
        assert is_zero(shuffled, limit=20_000)
