"""Factorization and shortest forms of whole families: many equal factors, common brackets, many points, limits."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from collections.abc import Callable
from itertools import combinations
from typing import Any

import pytest
from click.testing import CliRunner
from planting import plant

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.factoring import certify
from gcrules.algebra.factoring.extensors import Extensors
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.factoring.residues import values
from gcrules.algebra.factoring.search import candidates
from gcrules.algebra.factoring.tree_letters import Letters
from gcrules.algebra.factoring.trees import simplest
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.straightening.order import easy_order
from gcrules.algebra.straightening.straighten import is_zero, straighten
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import rank
from gcrules.core.seeds import repeated

LONG = {
    "powers": ("[abcd]**64 " * 40, "[abcd]**2560"),
    "equal brackets": ("[abcd]" * 700, "[abcd]**700"),
    "brackets of meets": ("[(ab /\\ cde), f, gh]" * 300, "(cde /\\ fgh /\\ ab)**300"),
    "sums": ("([abcd][efgh] - [abce][dfgh])" * 200, "(abc /\\ fgh /\\ de)**200"),
    "equal terms": ("[abcd]" * 300 + " + " + "[abcd]" * 300, "2 * [abcd]**300"),
    "powers in a sum": ("[abcd]**60[efgh] - 3[abcd]**60[efgh]", "-2 * [abcd]**60 * [efgh]"),
    "powers of powers": ("(([abcd]**64)**64 [efgh])**16", "[abcd]**65536 * [efgh]**16"),
}


@pytest.mark.parametrize("name", LONG)
def test_equal_factors_are_counted(name: str) -> None:
    text, shown = LONG[name]
    f = gc.factor(text)
    assert str(f).splitlines()[0] == shown
    assert f.proved
    assert len(f.factors) + text.count("[(") + 200 * (name == "sums") >= 60
    assert "**" not in json.dumps(f.to_json())


@pytest.mark.parametrize("name", LONG)
def test_no_time_at_all(name: str) -> None:
    with pytest.raises(LimitReached, match="more than 0 seconds"):
        gc.factor(LONG[name][0], seconds=0)


@pytest.mark.parametrize("name", ["powers", "equal brackets", "equal terms", "powers in a sum", "powers of powers"])
def test_one_long_term_is_shortest(name: str) -> None:
    found = gc.shorten(LONG[name][0], seconds=0)
    assert (found.terms, found.minimal) == (1, True)


def named(seed: int, relation: str) -> str:
    """A polynomial in a … f times five brackets of other points, all names exchanged at random."""
    names = list("abcdefghijklmnopqrstu")
    random.Random(seed).shuffle(names)
    text = f"({relation})[ghi][jkl][mno][pqr][stu]"
    return "".join(names[ord(c) - ord("a")] if c.isalpha() else c for c in text)


RELATION = "[abc][def] - [abd][cef] + [abe][cdf] - [abf][cde]"


@pytest.mark.parametrize("multiplied", [False, True], ids=["as a product", "multiplied out"])
@pytest.mark.parametrize("seed", range(3))
def test_a_relation_times_five_brackets(seed: int, multiplied: bool) -> None:
    def given(relation: str) -> Any:
        e = parse(named(seed, relation), rank=3)
        return expand(e) if multiplied else e

    with pytest.raises(InputError, match="the polynomial is zero"):
        gc.factor(given(RELATION))
    assert gc.shorten(given(RELATION)).terms == 0
    half = "[abc][def] - [abd][cef]"
    f = gc.factor(given(half))
    assert f.certificate.method == "normal-form"
    assert (len(f.factors), str(f.expression).count("/\\")) == (5, 2)
    found = gc.shorten(given(half))
    assert (found.terms, found.minimal) == (2, True)


@pytest.mark.parametrize(("rank", "points"), [(3, 21), (4, 20), (5, 20), (6, 24)])
def test_many_points_are_proved(rank: int, points: int) -> None:
    """Every point once: the normal form is short in an order that keeps the points of brackets together."""
    rng = random.Random(points)
    e = None
    while e is None:
        e = plant(rng, rank, rng.sample("abcdefghijklmnopqrstuvwxyz"[:points], points))
    f = gc.factor(e, rank=rank)
    assert f.certificate.method == "normal-form"
    whole = f.to_expr()
    assert whole is not None
    assert vanishes(ex.sub(e, whole, rank), rank=rank)


@pytest.mark.parametrize("seed", range(3))
def test_two_of_fourteen_points_occur_twice(seed: int) -> None:
    rng = random.Random(seed)
    e = None
    while e is None or vanishes(e):
        e = plant(rng, 4, [*"abcdefghijklmn", *rng.sample("abcdefghijklmn", 2)])
    f = gc.factor(e)
    assert f.certificate.method == "normal-form"
    assert f.family.extensors < 10_000


@pytest.mark.parametrize(
    ("text", "rank"),
    [
        ("[abfc][acde][bdef] + [abfd][acbe][cdef]", 4),
        ("[[Aa,Ab,Ba,Bc,Cb,Cc]]", 4),
        ("[[Aa,Ab,Bc,Bd,Ca,Dc]]", 4),
        ("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", 3),
        ("[ab /\\ cd, ae /\\ bf, df /\\ ce]", 3),
    ],
)
def test_points_apart_exclude_no_expression(text: str, rank: int) -> None:
    """The search finds what it finds where joins of any two points are formed."""
    p = straighten(parse(text, rank=rank))
    assert isinstance(p, BracketPolynomial)
    found, built = search(p, Effort())
    degrees = p.degrees() or {}
    extensors = Extensors(Letters(p.points, tuple(degrees[n] for n in p.points), rank))
    at = values(p, extensors.positions, extensors.field.p).tolist()
    pairs = [next(c.trees(extensors)) for c in candidates(extensors, at)]
    assert {str(simplest(*pair, rank=rank, order=p.points)) for pair in pairs} == {str(w) for w in found}
    assert built <= sum(map(len, extensors.levels.values()))


def test_all_irreducible_factors_are_shown() -> None:
    text = "(ef /\\ bc /\\ da)([fbe][cga] + 2 [fbc][ega])"
    f = gc.factor(text, rank=3)
    assert not f.exists
    assert [str(part.expression) for part in f.parts] == ["ad /\\ bc /\\ ef", "None"]
    assert all(part.irreducible and part.times == 1 for part in f.parts)
    assert "  factor       ad /\\ bc /\\ ef\n" in f.text()
    assert f.text().count("no expression") == 1
    assert [part["expression"] for part in f.to_json()["parts"]] == ["ad /\\ bc /\\ ef", None]
    product = ex.mul(ex.Number(f.coefficient), *f.factors, *(part.polynomial.to_expr() for part in f.parts))
    assert vanishes(ex.sub(parse(text, rank=3), product, 3), rank=3)
    assert f.remainder is not None
    assert f.latex().count("(") >= 2


@pytest.mark.parametrize("text", ["[abcd][efgh] - [abce][dfgh]", "[[Aa,Ab,Ba,Bc,Cb,Cc]]"], ids=["once", "repeated"])
def test_what_is_not_proved_says_so(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def too_long(*_: Any) -> None:
        raise LimitReached("straightening takes too long")

    monkeypatch.setattr(certify, "proved", too_long)
    with repeated(7):
        f = gc.factor(text)
    assert f.exists
    assert not f.proved
    assert f.certificate.method == "random-points"
    assert "not proved" in f.certificate.detail
    assert "seed 7" in f.certificate.detail
    done = CliRunner().invoke(cli, ["factor", text])
    assert done.exit_code == 3
    assert "found, not proved" in done.stdout


@pytest.mark.parametrize("arguments", [["[[Aa,Ab,Ba,Bc,Cb,Cc]]", "--full"], ["[[Aa,Ab,Bc,Bd,Ca,Dc]]", "--cofactor"]])
def test_the_same_under_every_hash_seed(arguments: list[str]) -> None:
    def run(seed: str) -> Any:
        command = [sys.executable, "-m", "gcrules", "factor", *arguments, "--json"]
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, env=os.environ | {"PYTHONHASHSEED": seed}, timeout=120
        )
        return json.loads(done.stdout)

    assert run("1") == run("2")


@pytest.mark.parametrize("seed", range(5))
def test_zero_in_an_easy_order_is_zero(seed: int) -> None:
    """Equal polynomials in other forms are the same function; with one coefficient changed they are not."""
    rng = random.Random(seed)
    names = rng.sample("abcdefghi", 9)
    e = plant(rng, 3, names)
    while e is None:
        e = plant(rng, 3, names)
    p = expand(e)
    assert isinstance(p, BracketPolynomial)
    q = straighten(p)
    assert isinstance(q, BracketPolynomial)
    assert sorted(easy_order(p)) == sorted(p.points)
    assert is_zero(p - q, limit=10**6)
    assert not is_zero(p - q - q.with_terms(dict(list(q.terms.items())[:1])), limit=10**6)


def spanned_by(number: int, poly: BracketPolynomial, forms: list[BracketPolynomial]) -> bool:
    """Whether so many (2 or 3) of the forms have the polynomial in their span, over the rationals: every choice of
    all but one, and for the last the determinants of values at whole positions, in Python's whole numbers.
    """
    from gcrules.algebra.evaluate import random_rational_points
    from gcrules.algebra.factoring.restriction import value_at

    rows = number + 1
    at = [random_rational_points(poly.points, rank=poly.rank, seed=50 + n, size=50) for n in range(rows)]
    target = [int(value_at(poly, x)) for x in at]
    vectors = [[int(value_at(f, x)) for x in at] for f in forms]

    def determinant(columns: list[list[int]]) -> int:
        if len(columns) == 1:
            return columns[0][0]
        first, *others = columns
        return sum((-1) ** i * v * determinant([c[:i] + c[i + 1 :] for c in others]) for i, v in enumerate(first) if v)

    for chosen in combinations(range(len(vectors)), number - 1):
        some = [target, *(vectors[i] for i in chosen)]
        cofactors = [(-1) ** i * determinant([c[:i] + c[i + 1 :] for c in some]) for i in range(rows)]
        for k in range(chosen[-1] + 1, len(vectors)):
            if not sum(c * v for c, v in zip(cofactors, vectors[k], strict=True)):
                all_of = [*(vectors[i] for i in chosen), vectors[k]]
                if rank(all_of) == number == rank([*all_of, target]):  # else they depend on each other without it
                    return True
    return False


REPEATED = [
    (
        "[abc][abd][abe][cdf][cef] - 3 [abd][abf][acf][bce][cde]",
        "[abe][acf][aef][bcd][bcd] - [abc][ade][aef][bcd][bcf]",
    ),
    ("[abc][abc][def][def] - 2 [abd][abe][cdf][cef]", "[abd][acf][bce][def]"),
]


@pytest.mark.parametrize(("text", "lower"), [(f"{a} + {b}", n) for (a, b), n in zip(REPEATED, (4, 3), strict=True)])
def test_what_is_excluded_where_points_repeat(text: str, lower: int) -> None:
    """The slow search in whole numbers excludes what the search modulo a prime does, and the answer says so."""
    from gcrules.algebra.shortening.monomials import Monomials

    p = straighten(parse(text, rank=3))
    assert isinstance(p, BracketPolynomial)
    found = gc.shorten(text, rank=3)
    assert (found.terms, found.lower, found.minimal) == (lower, lower, True)
    forms = [p.with_terms({m: 1}) for m in Monomials.of(p, 1_000).all]
    assert not any(spanned_by(number, p, forms) for number in range(2, lower))


@pytest.mark.parametrize("decide", [gc.factor, gc.shorten])
@pytest.mark.parametrize("zero", ["0", "0[abcd]", "ab /\\ ab", "[aabc]", "[abcd]**3 - [abcd]**3"])
def test_zero(decide: Callable[[Any], Any], zero: str) -> None:
    if decide is gc.shorten:
        assert decide(zero).terms == 0
    else:
        with pytest.raises(InputError, match="zero"):
            decide(zero)
