"""What is known of a polynomial where a limit ends the search for an expression."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction
from math import prod

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.algebra.evaluate import Evaluator, random_rational_points
from gcrules.algebra.factoring import decomposition, factorize, products, rational
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import cli
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import LimitReached
from gcrules.views.detail import without_options

TEN = "quadric(a, b, c, d, e, f, g, h, i, j)"
TWO = f"{TEN} [abcd] (abc /\\ def /\\ gh)"


def product_at(found: Factorization, seed: int) -> tuple[Fraction, Fraction]:
    """The input, and what the answer says that it is, at a random position."""
    assert found.input is not None
    at = Evaluator(random_rational_points(found.points, rank=found.rank, seed=seed, size=9), found.rank)
    values = [at.value(e)[0] for e in found.factors]
    values += [at.value(p.polynomial.to_expr())[0] ** p.times for p in found.parts]
    return Fraction(at.value(found.input)[0]), Fraction(found.coefficient * prod(values))


@pytest.fixture(scope="module")
def ten() -> Factorization:
    return gc.factor(TEN)


@pytest.fixture(scope="module")
def two() -> Factorization:
    return gc.factor(TWO)


def test_ten_points_on_a_quadric(ten: Factorization) -> None:
    assert ten.exists is None
    assert not ten.proved
    assert ten.to_expr() is None
    assert ten.factors == ()
    assert not ten.more_brackets
    (part,) = ten.parts
    assert part.irreducible
    assert len(part.polynomial) == 12
    assert part.undecided == ten.certificate.detail == "the search would hold more than 4,000,000 extensors"
    assert ten.exchangeable == ((tuple("abcdefghij"), -1),)


def test_it_is_shown(ten: Factorization) -> None:
    shown = ten.text()
    assert shown.startswith("not decided whether one expression equals it\n")
    for row in (
        "none divides it",
        ": not decided, irreducible",
        "any two of a, b, c, d, e, f, g, h, i and j changes its sign",
        "(raise the limit with --limit",
    ):
        assert row in shown
    assert "searched" not in shown
    with without_options():
        assert "--limit" not in ten.text()
    assert ten.latex().count("[") == 60


@pytest.mark.parametrize("seed", range(3))
def test_the_factors_multiply_to_the_input(seed: int, ten: Factorization, two: Factorization) -> None:
    for found in (ten, two):
        value, product = product_at(found, seed)
        assert value == product != 0


def test_the_other_factors_are_decided(two: Factorization) -> None:
    assert [str(f) for f in two.factors] == ["[abcd]"]
    assert two.remainder is None
    known = {len(p.polynomial) > 10: p for p in two.parts}
    assert str(known[False].expression) == "abc /\\ def /\\ gh"
    assert not known[False].undecided
    assert known[True].undecided
    assert "[abcd] divides; no others divide" in two.text()
    assert "a polynomial of 138 terms (shown with --full)" in two.text()


def test_parts_are_decided_one_by_one() -> None:
    """Of two factors the first has no expression: the second one is sought all the same."""
    found = gc.factor("([abcd][efgh] + 3[abce][dfgh])([abcd][efgh] - [abce][dfgh])(abc /\\ def /\\ gk)")
    assert found.exists is False
    assert Counter(p.expression is None for p in found.parts) == {True: 1, False: 2}


def test_the_proof_file_has_what_is_known(ten: Factorization) -> None:
    file = gc.proof_file(ten)
    assert [t.name for t in file.theorems] == ["expansion"]
    assert [left.name for left in file.left_out] == ["whether it is a product of expressions"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([TEN, "--json", "--limit", "1000"], "the search would hold more than 1,000 extensors"),
        (["[[Aa,Ab,Ba,Bc,Cb,Cc]]", "--limit", "100"], "none divides it"),
        (
            ["[[Aa,Ab,Bc,Bd,Ca,Dc]]", "--limit", "100", "--cofactor"],
            "a cofactor: it is sought where there is certainly",
        ),
    ],
)
def test_the_exit_code_is_that_of_what_is_undecided(arguments: list[str], words: str) -> None:
    done = CliRunner().invoke(cli, ["factor", *arguments])
    assert done.exit_code == 3
    assert words in done.stdout
    if "--json" in arguments:
        found = json.loads(done.stdout)
        assert found["certificate"]["method"] == "undecided"
        assert found["expression"] is None
        assert found["exchangeable"] == [{"points": list("abcdefghij"), "sign": -1}]
        assert [part["irreducible"] for part in found["parts"]] == [True]


def test_the_prompt_says_that_it_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def limited(*_: object, **__: object) -> None:
        raise LimitReached("this takes more than 1 second")

    monkeypatch.setattr(products, "search", limited)
    answers = list(Interpreter().feed(":factor [[Aa,Ab,Ba,Bc,Cb,Cc]]"))
    assert [a.verdict for a in answers] == ["undecided"]
    assert "this takes more than 1 second" in answers[0].text


def test_brackets_that_were_not_sought_are_not_excluded(monkeypatch: pytest.MonkeyPatch) -> None:
    def limited(*_: object, **__: object) -> None:
        raise LimitReached("straightening takes more than 10 terms")

    text = "[abcd]([abce][dfgh][cdgk] + 3[abcf][degh][cdgk] - [abcg][defh][cdgk])"
    monkeypatch.setattr(decomposition, "normal", limited)
    found = gc.factor(text)
    assert found.exists is None
    assert found.more_brackets
    assert "[abcd] and [cdgk] divide; whether others divide is not known" in found.text()
    assert "not known to be irreducible" in found.text()
    value, product = product_at(found, 1)
    assert value == product != 0
    syzygy = "[abef][cdgh] - [abeg][cdfh] + [abeh][cdfg] + [abfg][cdeh] - [abfh][cdeg] + [abgh][cdef] - [abcd][efgh]"
    with pytest.raises(LimitReached):
        gc.factor(f"[abcd]({syzygy})")


def test_no_time_is_left_to_know_anything() -> None:
    with pytest.raises(LimitReached, match="more than 0 seconds"):
        gc.factor(parse("[[Aa,Ab,Ba,Bc,Cb,Cc]]"), seconds=0)


def test_points_that_occur_once(monkeypatch: pytest.MonkeyPatch) -> None:
    def limited(*_: object, **__: object) -> None:
        raise LimitReached("this takes more than 1 second")

    monkeypatch.setattr(factorize, "each_once", limited)
    found = gc.factor("[abcd]([efgh][ijkl] - 2[efgi][hjkl])")
    assert found.exists is None
    assert [str(f) for f in found.factors] == ["[abcd]"]
    value, product = product_at(found, 2)
    assert value == product != 0


def test_what_is_left_may_be_too_long_to_multiply() -> None:
    found = gc.factor("[[Aa,Bb,Cc,Dd,Ee,Ff]]**2 [[Aa,Bb,Cc,Dd,Ee,Ff]]", limit=4000, cofactor=True)
    assert found.exists is False
    assert found.remainder is None
    assert [p.times for p in found.parts] == [3]
    assert found.undecided == ("a cofactor: what is left has more than 200,000 terms",)


def test_the_limit_of_one_search_leaves_the_others() -> None:
    """Irreducible factors of which the brackets are not known are left as they are written."""
    found = gc.factors("[abcd]([abce][dfgh][cdgk] + 3[abcf][degh][cdgk])", limit=100)
    assert found.irreducible
    assert [str(f.expression) for f in found.factors if f.form == "bracket"] == ["[abcd]", "[cdgk]"]


def test_factors_that_are_not_known(monkeypatch: pytest.MonkeyPatch) -> None:
    def limited(*_: object, **__: object) -> None:
        raise LimitReached("straightening takes more than 10 terms")

    monkeypatch.setattr(decomposition, "normal", limited)
    found = gc.factors("2[abcd]([abce][dfgh][cdgk] + 3[abcf][degh][cdgk])")
    *brackets, left = found.factors
    assert [str(f.expression) for f in brackets] == ["[abcd]", "[cdgk]"]
    assert (left.form, left.irreducible, found.decided) == ("undecided", False, False)
    assert left.undecided == ("its factors: straightening takes more than 10 terms",)
    assert str(found.product()) == "2[abcd][cdgk]([abce][dfgh] + 3[abcf][degh])"


def test_what_was_proved_stands_where_the_search_for_a_cofactor_ends_early(monkeypatch: pytest.MonkeyPatch) -> None:
    def limited(*_: object) -> None:
        raise LimitReached("this takes more than 1.5 seconds")

    monkeypatch.setattr(rational, "bracket_cofactors", limited)
    f = gc.factor("[[Aa, Ab, Bc, Cd, De, Ef]]", cofactor=True)
    assert not f.exists
    assert not f.rational
    assert f.undecided
    assert "undecided" in f.text()
    assert f.to_json()["undecided"] == list(f.undecided)
