"""Thousands of equal factors and powers: exact, quick, and shown in short."""

from __future__ import annotations

import pytest
from algebra.polynomials import polynomial
from hypothesis import given
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.bracket import MANY_EQUAL, BracketPolynomial
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expand import MAX_BRACKETS, expand
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import LimitReached

POWERS = "[abcd]**64 " * 9_000


# --- equal factors ---------------------------------------------------------------------------------------------------

FACTORS = (
    "[abcd]",
    "2[abce]",
    "([abcd] - [acde])",
    "(ab /\\ cd)",
    "[abcd]**2",
    "3",
    "1/2",
    "-1",
    "[(ab /\\ cde), a, bc]",
)


@given(st.lists(st.sampled_from(FACTORS), min_size=1, max_size=8))
def test_products_with_equal_factors(factors: list[str]) -> None:
    """The product of equal factors is what one gets by one multiplication after the other, and at exact points."""
    e = parse(" * ".join(factors))
    one_by_one = polynomial("1")
    for f in factors:
        one_by_one = one_by_one * polynomial(f)
    found = expand(e)
    assert isinstance(found, BracketPolynomial)
    there = random_rational_points("abcde", seed=len(factors))
    value = 1
    for f in factors:
        value = value * evaluate(parse(f), there)
    assert evaluate(e, there) == value
    assert evaluate(found.to_expr(), there) == value
    assert (found - one_by_one).terms == {}


@given(st.integers(1, 40), st.integers(2, 64))
def test_powers_at_exact_points(value: int, exponent: int) -> None:
    there = {**random_rational_points("abd", seed=value), "c": (value, 0, 0, 1)}
    e = parse(f"[abcd]**{exponent}")
    assert evaluate(e, there) == evaluate(parse("[abcd]"), there) ** exponent
    assert evaluate(e, there, modulus=10_007) == pow(evaluate(parse("[abcd]"), there), exponent, 10_007)


def test_thousands_of_equal_factors() -> None:
    found = gc.straighten(POWERS)
    assert isinstance(found, BracketPolynomial)
    ((monomial, c),) = found.terms.items()
    assert (len(monomial), set(monomial), c) == (64 * 9_000, {(0, 1, 2, 3)}, 1)
    assert found.text(short=True) == "[abcd]**576000"
    half = "[abcd]**64 " * 4_000
    assert gc.prove(f"{half} == {half}").verdict == "proved"


NESTED = [
    ("[abcd]", f"monomials of more than {MAX_BRACKETS:,} brackets"),
    ("(2[abcd])", "a coefficient has more than"),
    ("([abcd] + [abce])", "products of terms"),
]


@pytest.mark.parametrize(("base", "words"), NESTED, ids=[n[0] for n in NESTED])
def test_powers_of_powers_are_bounded(base: str, words: str) -> None:
    text = base
    for _ in range(20):
        text = f"({text}**64)"
    with pytest.raises(gc.GcrulesError, match=words):
        gc.expand(text, limit=2_000)
    with pytest.raises(LimitReached, match="a value has more than"):
        evaluate(parse(text), random_rational_points("abcde", seed=2))


SHOWN = [
    ("[abcd]**9", "[abcd]" * 9),
    ("[abcd]**10", "[abcd]**10"),
    ("2[abcd]**12[abce]", "2 * [abcd]**12 * [abce]"),
    ("[abcd]**64[abcd] + [abcd]", "[abcd] + [abcd]**65"),
]


@pytest.mark.parametrize(("text", "short"), SHOWN, ids=[s[0] for s in SHOWN])
def test_many_equal_brackets_are_shown_in_short_where_asked(text: str, short: str) -> None:
    found = polynomial(text)
    assert set(found.text(short=True).split(" + ")) == set(short.split(" + "))
    assert "**" not in found.text()
    assert "**" not in found.to_json()["polynomial"]
    assert MANY_EQUAL == 10
    if "65" not in short:
        assert expand(parse(found.text(short=True))) == found


def test_a_line_times_many_brackets_is_shown_in_short() -> None:
    found = gc.expand("[abcd]**20 ab")
    assert found.text(short=True) == "[abcd]**20 * ab"


def test_a_shortening_of_many_brackets_is_shown_in_short() -> None:
    found = gc.shorten("[abcd]**20 [abce]")
    assert found.text(short=True).startswith("[abcd]**20 * [abce]\n")
    assert "**" not in found.text().splitlines()[0]


def test_a_shortening_names_the_seconds_that_were_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gcrules.algebra.shortening.shorten._PREPARATION", 0.3)
    with pytest.raises(LimitReached, match=r"more than 0\.25 seconds"):
        gc.shorten("[[ab, cd, ef, gh, ij, kl]]**12", seconds=0.25)
