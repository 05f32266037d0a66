"""Irreducible factors, and the form of each."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from typing import Any

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Terms, primitive
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, vanishes
from gcrules.algebra.factoring.blocks import blocks_apart
from gcrules.algebra.factoring.decomposition import decomposed
from gcrules.algebra.factoring.forms import IrreducibleFactor
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.two_lines import compared, two_lines
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.straightening.straighten import straighten
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError, LimitReached


def normal(text: str, rank: int = 4) -> BracketPolynomial:
    found = straighten(parse(text, rank=rank))
    assert isinstance(found, BracketPolynomial)
    return found


def random_polynomial(rng: random.Random, rank: int, names: str, rows: int) -> BracketPolynomial:
    """A random combination of two or three products of brackets with the same letters, not zero."""
    while True:
        letters = list(rng.choices(names, k=rank * rows))
        terms: Terms = {}
        for _ in range(60):
            rng.shuffle(letters)
            cut = [tuple(sorted(map(names.index, letters[i::rows]))) for i in range(rows)]
            if all(len(set(row)) == rank for row in cut) and len(terms) < 3:
                terms[tuple(sorted(cut))] = rng.choice([-3, -1, 1, 2])
        if len(terms) > 1 and (found := straighten(BracketPolynomial(rank, tuple(names), terms))):
            assert isinstance(found, BracketPolynomial)
            return found


def written(p: BracketPolynomial) -> str:
    """The normal form, up to a constant."""
    found = straighten(p)
    assert isinstance(found, BracketPolynomial)
    _, one = primitive(found)
    return str(one * (-1 if next(iter(one.terms.values())) < 0 else 1))


def value(e: Any, rank: int, seed: int) -> int:
    """At a random position modulo a large prime."""
    at = random_points("abcdefghABCDEF", rank=rank, seed=("factors", seed))
    return int(Evaluator(at, rank, PRIME).value(e)[0])


def agrees(f: IrreducibleFactor, rank: int, seed: int) -> bool:
    """cofactor · polynomial = coefficient · expression at that position."""
    assert f.expression is not None
    c = Fraction(f.coefficient)
    left = value(f.cofactor, rank, seed) * value(f.polynomial.to_expr(), rank, seed) * c.denominator
    return (left - c.numerator * value(f.expression, rank, seed)) % PRIME == 0


@pytest.mark.parametrize(
    ("seed", "rank", "names", "rows"),
    [(0, 2, "abcde", 3), (1, 2, "abcdef", 2), (7, 3, "abcdef", 2), (3, 3, "abcdefg", 2), (4, 4, "abcdefg", 2)],
)
def test_products_of_random_polynomials_split_into_what_they_were_made_of(
    seed: int, rank: int, names: str, rows: int
) -> None:
    rng = random.Random(seed)
    one, other = (random_polynomial(rng, rank, names, rows) for _ in range(2))
    whole = decomposed(one * other, 10**6)
    apart = [decomposed(p, 10**6) for p in (one, other)]
    assert whole.irreducible
    assert sorted(map(written, whole.parts)) == sorted(written(p) for d in apart for p in d.parts)
    assert sorted(whole.rows) == sorted(row for d in apart for row in d.rows)
    found = gc.factors(one * other, seconds=20)
    assert value((one * other).to_expr(), rank, seed) == value(found.product(), rank, seed)
    assert value((one * other).to_expr(), rank, seed) == value(found.to_expr(), rank, seed)
    assert all(agrees(f, rank, seed) for f in found.factors if f.expression is not None)


FORMS = {
    "[[Aa,Ab,Ba,Bb,Cc,Dd]]": ["bracket", "transversals"],
    "[[Aa,Ab,Ac,Bd,Be,Cf]]": ["bracket", "bracket", "bracket"],
    "[[Aa,Ab,Bc,Bd,Ce,Cf]]**2": ["expression"],
    "[abcd][efgh] + 3[abce][dfgh]": ["two terms"],
}


@pytest.mark.parametrize("text", FORMS)
def test_the_form_of_each_factor(text: str) -> None:
    found = gc.factors(text)
    assert [f.form for f in found.factors] == FORMS[text]
    assert found.complete
    assert found.decided
    assert vanishes(ex.sub(parse(text), found.to_expr(), 4))
    assert vanishes(ex.sub(parse(text), found.product(), 4))
    assert all(f.proved and f.irreducible and agrees(f, 4, 1) for f in found.factors)


def test_multiplicities_and_degrees() -> None:
    found = gc.factors("-4 [abc]**3 ([abd][cef] + 2[abe][cdf])**2", rank=3)
    bracket, other = found.factors
    assert (bracket.times, bracket.degrees) == (3, {"a": 1, "b": 1, "c": 1})
    assert (other.times, other.form, other.degrees) == (2, "two terms", dict.fromkeys("abcdef", 1))
    assert found.coefficient == -4
    assert "[abc], 3 times" in found.text()
    assert json.loads(json.dumps(found.to_json()))["factors"][1]["degrees"]["f"] == 1


def test_none_is_certain_and_says_what_was_excluded() -> None:
    (found,) = gc.factors("[abc][def] + 2[abd][cef] + 3[abe][cdf]", rank=3).factors
    assert (found.form, found.expression, found.proved) == ("none", None, True)
    assert found.certificate.method == "multilinear-algorithm"
    assert found.excluded[0] == "no bracket polynomial with fewer than 3 terms"
    assert found.excluded[1].startswith("no expression with the cofactor [abc]")
    assert not found.undecided


def test_a_cofactor() -> None:
    (found,) = gc.factors("[[Aa,Ab,Ba,Cc,Dd,Ee]]", seconds=60).factors
    assert (found.form, found.proved, found.closed) == ("cofactor", True, False)
    assert agrees(found, 4, 3)
    assert found.excluded[1] == "no bracket polynomial with fewer than 6 terms"
    assert len(found.polynomial) == 6


@pytest.mark.parametrize(
    ("legs", "words"),
    [
        ("Aa Ab Bc Bd Ce Df", "(AB /\\ Ce)(Aab /\\ Bcd /\\ Df) - (AB /\\ Df)(Aab /\\ Bcd /\\ Ce)"),
        ("Aa Ab Ba Bc Cd De", "(AB /\\ Cd)(Aab /\\ Bac /\\ De) - (AB /\\ De)(Aab /\\ Bac /\\ Cd)"),
        ("Aa Bb Cc Dd Ee Ff", None),
    ],
)
def test_two_lines(legs: str, words: str | None) -> None:
    found = two_lines(normal(f"[[{', '.join(legs.split())}]]"), Effort())
    assert (found and str(found)) == words


def test_two_lines_that_were_planted() -> None:
    """Lines of two and of six letters, at a random choice of points."""
    rng = random.Random(2)
    for _ in range(1):
        n = rng.sample("abcdefghijkl", 12)
        p, g, h = (parse("".join(n[i : i + 2])) for i in (0, 2, 4))
        q = parse(f"{''.join(n[6:9])} /\\ {''.join(n[9:12])}")
        planted = compared(p, q, g, h)
        found = two_lines(normal(str(planted)), Effort())
        assert found is not None
        assert {frozenset(ex.points_of(found))} == {frozenset(n)}


def test_factors_in_points_of_their_own() -> None:
    names = "abcdefghijklmnopqrstuvwx"
    made = [names[i : i + 8] for i in range(0, 24, 8)]
    text = "*".join(f"([{m[:4]}][{m[4:]}] + {k}[{m[:3]}{m[4]}][{m[3]}{m[5:]}])" for k, m in enumerate(made, 2))
    parts = blocks_apart(normal(text), limit=10**6)
    assert parts is not None
    assert [set(p.degrees() or {}) for p in parts] == [set(m) for m in made]


def test_equal_factors_of_several_pieces_are_counted_together() -> None:
    one = "([abc][def] + 2[abd][cef])"
    text = f"(expanded) {one}".replace("(expanded)", f"({one[1:-1]})")
    found = gc.factors(ex.mul(parse(text, rank=3), gc.expand(text, rank=3).to_expr()), rank=3)
    assert [f.times for f in found.factors] == [4]
    found = gc.factors("([abc][adf] + 2[abd][acf])([bcd][aef] - [bce][adf])**2 [abd]", rank=3)
    assert sum(f.times for f in found.factors) == len(set(map(str, found.factors))) + 1


def test_what_is_in_one_factor_does_not_fall_apart() -> None:
    p = normal("[abc][def] + 2[abd][cef] + 3[abe][cdf]", 3)
    assert blocks_apart(p, limit=1000) == [p]


def test_a_bracket_that_stays_is_no_proof() -> None:
    """The frame that is held may be a factor; then nothing is held."""
    assert irreducible(normal("([ab][cd] + 2[ac][bd]) [ab][ab]", 2)) is None


def test_a_limit_keeps_the_factors() -> None:
    found = gc.factors("[ghij]**2 [[Aa,Bb,Cc,Dd,Ee,Ff]]", seconds=1.5)
    assert [f.times for f in found.factors] == [2, 1]
    assert found.factors[1].form == "undecided"
    assert found.factors[1].undecided
    assert not found.decided
    assert "undecided: a limit was reached" in found.text()


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["[[Aa,Ab,Ba,Bb,Cc,Dd]]"], 0, "transversals"),
        (["[abc][def] + 2[abd][cef] + 3[abe][cdf]", "--rank", "3"], 1, "none (multilinear-algorithm"),
        (["[[Aa,Bb,Cc,Dd,Ee,Ff]]", "--seconds", "1"], 3, "undecided"),
        (["[abcd][efgh] + 3[abce][dfgh]", "--latex"], 0, "3"),
        (["ab"], 2, "only scalars are factored"),
        (["0"], 2, "the polynomial is zero"),
        (["[abcd] + [abce]"], 2, "not homogeneous"),
        (["[abcd]", "--seconds", "0"], 3, "more than 0 seconds"),
    ],
)
def test_command(arguments: list[str], code: int, words: str) -> None:
    done = CliRunner().invoke(cli, ["factors", *arguments])
    assert done.exit_code == code, done.output
    assert words in done.output


def test_input_at_fault() -> None:
    with pytest.raises(InputError, match="the polynomial is zero"):
        gc.factors("ab /\\ ab")
    with pytest.raises(LimitReached):
        gc.factors("[abcd]", seconds=0)


def test_the_proof_file_has_the_product_and_each_form() -> None:
    file = gc.proof_file(gc.factors("[abcd]([abef][cdgh] + 3[abeg][cdfh])"))
    assert [t.name for t in file.theorems] == ["factors", "factor 1", "factor 2"]
    assert [left.name for left in file.left_out] == ["that the factors are irreducible"]
