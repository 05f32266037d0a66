"""Factorization: planted expressions are found again, what is found equals the input on two roads, what is denied is
denied by two algorithms, and the classes of platforms agree with their data.
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from functools import cache, reduce
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from planting import plant
from platform_classes import REGULAR

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import Evaluator, vanishes
from gcrules.algebra.expr import Expr, sub
from gcrules.algebra.factoring import search as search_module
from gcrules.algebra.factoring.brackets import bracket_factors
from gcrules.algebra.factoring.certify import proved
from gcrules.algebra.factoring.cofactor import line_cofactors
from gcrules.algebra.factoring.coincidences import Coincidences, coinciding
from gcrules.algebra.factoring.extensors import Extensors
from gcrules.algebra.factoring.factorize import factor
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.factoring.multilinear import factor_multilinear
from gcrules.algebra.factoring.residues import residues, values
from gcrules.algebra.factoring.search import middles
from gcrules.algebra.factoring.splitting import split
from gcrules.algebra.factoring.symmetry import Symmetries, moved_row
from gcrules.algebra.factoring.tree_letters import Letters, extensor
from gcrules.algebra.factoring.trees import simplest
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.parts import substitute
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.errors import InputError, LimitReached


def normal(e: str | Expr, rank: int = 4, **space: Any) -> BracketPolynomial:
    p = straighten(parse(e, rank=rank) if isinstance(e, str) else e, rank=rank, **space)
    assert isinstance(p, BracketPolynomial)
    return p


@st.composite
def planted(draw: st.DrawFn, sizes: dict[int, list[int]], *, once: bool = False) -> tuple[int, Expr]:
    """The rank and an expression that is not zero, of so many letters for each rank."""
    rank = draw(st.sampled_from(sorted(sizes)))
    number = draw(st.sampled_from(sizes[rank]))
    rng = random.Random(draw(st.integers(0, 2**32)))
    while True:
        names = "abcdefghijklmnop"[: number if once else rng.randint(max(rank, number // 2), min(12, number))]
        letters = list(names) if once else [rng.choice(names) for _ in range(number)]
        e = plant(rng, rank, letters)
        if e is not None and not vanishes(e, rank=rank):
            return rank, e


def test_the_classes_of_platforms() -> None:
    """24 are brackets times one expression, ten are not; all in one run, without the catalog."""
    found = {}
    for c in REGULAR:
        e = parse(f"[[{', '.join(c['legs'])}]]")
        f = found[c["id"]] = factor(e)
        assert f.exists == c["incidence"], c["id"]
        assert sorted(str(b).strip("[]") for b in f.factors) == sorted(c["factors"])
        if f.exists:
            assert f.certificate.method == "normal-form"
            whole = f.to_expr()
            assert whole is not None
            assert vanishes(sub(e, whole))
        else:
            assert f.remainder is not None
            left = ex.mul(ex.Number(f.coefficient), *f.factors, f.remainder.to_expr())
            assert vanishes(sub(e, left))
            assert c["id"] == "6-6" or f.certificate.data["irreducible"] is True
    assert Counter(f.exists for f in found.values()) == {True: 24, False: 10}
    assert str(found["3-3.3"].expression) == "ABC /\\ Aab /\\ Bac /\\ Cbc"
    assert "catalog" not in " ".join(m for m in sys.modules if m.startswith("gcrules.algebra.factoring"))


@settings(max_examples=60)
@given(planted({2: [2], 3: [3, 6, 9, 12], 4: [4, 8, 12], 5: [5, 10, 15], 6: [12]}))
def test_planted_expressions_are_found(case: tuple[int, Expr]) -> None:
    rank, e = case
    p = normal(e, rank)
    f = factor(p * Fraction(-7, 3))
    whole = f.to_expr()
    assert whole is not None, str(e)
    assert vanishes(sub(ex.mul(ex.Number(Fraction(-7, 3)), e), whole, rank), rank=rank)


@settings(max_examples=5)
@given(planted({3: [15], 4: [16]}))
def test_longer_planted_expressions_are_found(case: tuple[int, Expr]) -> None:
    rank, e = case
    assert factor(normal(e, rank)).exists


@settings(max_examples=40)
@given(planted({3: [6, 9, 12], 4: [8, 12], 5: [10]}, once=True))
def test_planted_multilinear_expressions(case: tuple[int, Expr]) -> None:
    """The algorithm finds the very tree that was planted, and the search finds no other."""
    rank, e = case
    p = normal(e, rank)
    found = factor_multilinear(p)
    assert found.complete
    f = factor(p)
    if not f.factors:
        written, _ = search(p, Effort())
        assert [str(w) for w in written] == [str(f.expression)]


@settings(max_examples=40)
@given(st.integers(0, 2**32), st.sampled_from([(3, 6), (3, 9), (4, 8)]))
def test_two_algorithms_agree_on_multilinear_sums(seed: int, shape: tuple[int, int]) -> None:
    rank, n = shape
    rng = random.Random(seed)
    p = normal("[ab]", 2)
    while not p or p.rank == 2:
        terms: Any = {}
        for _ in range(rng.randint(1, 3)):
            order = rng.sample(range(n), n)
            m = tuple(sorted(tuple(sorted(order[i : i + rank])) for i in range(0, n, rank)))
            terms[m] = rng.choice((1, -1, 2))
        poly = BracketPolynomial(rank, tuple("abcdefghi"[:n]), terms)
        p = straighten(poly)  # type: ignore[assignment]
    rows, left = bracket_factors(p, limit=10**6)
    f = factor(p)
    assert len(rows) == len(f.factors)
    if left.degrees():
        written, _ = search(left, Effort())
        assert bool(written) == f.exists


@pytest.mark.parametrize("rank", [2, 3, 4, 5, 6])
def test_vectors_agree_with_the_oracle(rank: int) -> None:
    """Every extensor of the levels, at the positions of the search, up to one constant for all positions."""
    names = tuple("abcdefg"[: rank + 1])
    extensors = Extensors(Letters(names, (2,) * len(names), rank))
    p = extensors.field.p
    rng = random.Random(rank)
    for n in range(1, rank + 3):
        if n % rank == 0:
            continue
        level = extensors.level(n)
        for place in rng.sample(range(len(level)), min(40, len(level))):
            for tree in list(zip(range(3), extensors.forms(n, place), strict=False)):
                e = extensor(tree[1], rank)
                ratios = set()
                for k, position in enumerate(extensors.positions):
                    at = Evaluator({m: x.tolist() for m, x in zip(names, position, strict=True)}, rank, p)
                    for mine, other in zip(level.vectors[:, k, place], at.value(e), strict=True):
                        assert (int(mine) % p == 0) == (other == 0)
                        if other:
                            ratios.add(int(mine) * pow(other, -1, p) % p)
                assert len(ratios) == 1


def hung_by_a_leaf(rank: int, letters: tuple[str, ...]) -> set[str]:
    """All expressions of different letters without a scalar part: every tree, hung by its last letter."""

    def tied(kind: str, a: Any, b: Any) -> Any:
        """Joins of joins and meets of meets made flat: a kind and the set of the parts."""
        return kind, frozenset().union(*(t[1] if t[0] == kind else {t} for t in (a, b)))

    @cache
    def extensors(some: tuple[str, ...]) -> set[Any]:
        if len(some) == 1:
            return {("point", some[0])}
        found = set()
        for size in range(1, len(some)):
            for one in combinations(some, size):
                other = tuple(n for n in some if n not in one)
                if some[0] in one and size % rank and len(other) % rank:
                    kind = "join" if size % rank + len(other) % rank < rank else "meet"
                    found |= {tied(kind, a, b) for a in extensors(one) for b in extensors(other)}
        return found

    def binary(t: Any) -> Any:
        return t[1] if t[0] == "point" else reduce(lambda a, b: (t[0], a, b), map(binary, t[1]))

    *others, last = letters
    return {str(simplest(binary(t), last, rank=rank)) for t in extensors(tuple(others))}


def met(rank: int, letters: tuple[str, ...]) -> Counter[str]:
    """How often the search meets each expression of different letters."""
    extensors = Extensors(Letters(letters, (1,) * len(letters), rank))

    def everything(self: Any, low: int, high: int, weighted: Any, dual: Any) -> Any:
        i, j = np.nonzero(np.ones((high - low, dual.shape[2]), dtype=bool))
        return i + low, j

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(search_module._Test, "passed", everything)
        found = list(search_module.candidates(extensors, (1, 1, 1)))
    pairs = (next(c.trees(extensors)) for c in found)
    return Counter(str(simplest(*pair, rank=rank, order=letters)) for pair in pairs)


@pytest.mark.parametrize(("rank", "number", "trees"), [(3, 6, 15), (3, 9, 2835), (4, 8, 280), (5, 10, 3675)])
def test_every_tree_is_met(rank: int, number: int, trees: int) -> None:
    """Met in the middle, without any test of values: the same expressions as hung by a leaf."""
    letters = tuple("abcdefghij"[:number])
    found = met(rank, letters)
    assert set(found) == hung_by_a_leaf(rank, letters)
    assert len(found) == trees == found.total()


def test_twelve_letters() -> None:
    """The three shapes of twelve different letters in rank 4, and how many expressions of each there are."""
    p = normal("[[ab,cd,ef,gh,ij,kl]]")
    effort = Effort()
    extensors = Extensors(Letters(p.points, (1,) * 12, 4), effort=effort)
    at = values(p, extensors.positions, extensors.field.p).tolist()
    assert not list(search_module.candidates(extensors, at))
    assert sum(map(len, extensors.levels.values())) == 12 + 66 + 220 + 792 * 10 + 924 * 70
    assert effort.products == 924 // 2 * 70 * 70
    assert [middles(n, 4) for n in (8, 12)] == [((3, 3, 2),), ((6, 6),)]


@settings(max_examples=30)
@given(st.integers(0, 2**32), st.integers(2, 5), st.integers(1, 3))
def test_brackets_come_out(seed: int, rank: int, number: int) -> None:
    """A product of brackets with multiplicities, a constant and a rest that no bracket divides."""
    rng = random.Random(seed)
    names = tuple("abcdefgh"[: rank + 2])
    rows = [tuple(sorted(rng.sample(range(len(names)), rank))) for _ in range(number)]
    p = straighten(BracketPolynomial(rank, names, {tuple(sorted(rows)): 6}))
    assert isinstance(p, BracketPolynomial)
    found, left = bracket_factors(p, limit=10**6)
    assert Counter(found) == Counter(rows)
    assert dict(left.terms) == {(): 6}


@pytest.mark.parametrize(
    ("text", "rank", "ideal", "expected"),
    [
        ("[abd][ace] - [abe][acd]", 3, "", "[abc][ade]"),
        ("ab /\\ cd", 4, "", "[abcd]"),
        ("-2/3 [abcd]**2", 4, "", "-2/3[abcd][abcd]"),
        ("5", 4, "", "5"),
        ("[ab][cd] - [ac][bd]", 2, "", "-[ad][bc]"),
        ("[ijka][abcd]", 4, "i j k", "[ijka][abcd]"),
        ("ab /\\ icd /\\ jef", 4, "i j", "icd /\\ jef /\\ ab"),
        ("[iabc][jdef] - [idef][jabc]", 4, "i j", "abc /\\ def /\\ ij"),
        ("[iabc][ijde][jafg]", 4, "i j", "[ijde][iabc][jafg]"),
        ("(ab /\\ cd /\\ ef)(gh /\\ ij /\\ kl)", 3, "", "(ab /\\ cd /\\ ef)(gh /\\ ij /\\ kl)"),
        ("[[Aa,Ab,Bc,Bd,Ce,Cf]]", 4, "", "(ABC /\\ Aab /\\ Bcd /\\ Cef)"),
    ],
)
def test_examples(text: str, rank: int, ideal: str, expected: str) -> None:
    f = gc.factor(text, rank=rank, ideal=ideal)
    assert f.exists
    assert f.certificate.method == "normal-form"
    whole, wanted = f.to_expr(), parse(expected, rank=rank)
    assert whole is not None
    assert vanishes(sub(whole, wanted, rank), rank=rank, ideal=ideal.split())
    assert vanishes(sub(parse(text, rank=rank), whole, rank), rank=rank, ideal=ideal.split())
    assert len(f.text()) >= len(expected)


def test_pascal() -> None:
    """The conic through six points, each of degree two, in the plane."""
    f = gc.factor("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", rank=3, all=True)
    assert f.exists
    assert len(f.alternatives) > 10
    for form in f.alternatives[:5]:
        p = parse("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", rank=3)
        assert vanishes(sub(p, form.product(), 3), rank=3)
    pascal = parse("[ab /\\ de, bc /\\ ef, cd /\\ af]", rank=3)
    same = [sub(ex.mul(ex.Number(sign), pascal), form.expression, 3) for form in f.alternatives for sign in (1, -1)]
    assert any(vanishes(e, rank=3) for e in same)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[abcd] - [abcd]", "zero"),
        ("ab /\\ ab", "zero"),
        ("[abcd] + [abce]", "not homogeneous in the points"),
        ("[abcd] + [abcd][efgh]", "not homogeneous in the points"),
        ("ab /\\ cde", "only scalars"),
    ],
)
def test_input_at_fault(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        gc.factor(text)


def test_terms_that_cancel_do_not_matter() -> None:
    f = gc.factor("[abcd][efgh] + [abce][dfgh]*2 - 2[abce][dfgh]")
    assert str(f.to_expr()) == "[abcd][efgh]"


def test_large_coefficients() -> None:
    big = "7" * 1000
    f = gc.factor(f"{big}[abcd][efgh] - {big}[abce][dfgh]")
    assert abs(f.coefficient) == int(big)
    assert str(f.expression) == "abc /\\ fgh /\\ de"
    assert json.loads(json.dumps(f.to_json()))["coefficient"] == f.coefficient
    assert not gc.factor(f"{big}[abcd][efgh] - {big[:-1]}8[abce][dfgh]").exists


def test_forty_points() -> None:
    """Multilinear polynomials need values only; what is too large is refused, and says why."""
    names = [f"p{i}" for i in range(40)]
    rows = [names[i : i + 4] for i in range(0, 40, 4)]
    product = "".join(f"[{''.join(r)}]" for r in rows)
    swapped = product.replace("p3]", "p4]", 1).replace("[p4p5", "[p3p5", 1)
    f = gc.factor(f"{product} - {swapped}")
    assert f.exists
    assert len(f.factors) == 8
    assert str(f.expression) == "p0p1p2 /\\ p5p6p7 /\\ p3p4"
    f = gc.factor(f"({product} - {swapped}) [p0p1p4p8] (p8p12p16 /\\ p9p13p17 /\\ p10p14)")
    assert f.exists
    assert len(f.factors) == 9
    f = gc.factor(f"({product} - {swapped}) [[p0p4, p1p5, p2p6, p8p12, p9p13, p10p14]]", seconds=3)
    assert f.exists is None
    assert "more than" in f.certificate.detail


def test_limits_are_stated() -> None:
    e = parse("[[Aa,Ab,Ba,Bc,Cb,Cc]]")
    f = factor(e, limit=100)
    assert f.exists is None
    assert "more than 100" in f.certificate.detail
    assert "--limit" in f.text()
    with pytest.raises(LimitReached, match="seconds") as reached:
        factor(e, seconds=0)
    assert "--seconds" in str(reached.value.hint)
    told: list[str] = []
    factor(e, progress=told.append)
    assert any("expressions" in t for t in told)


def test_results_do_not_depend_on_the_positions() -> None:
    """The same candidates pass for every choice of random positions, since none passes by chance."""
    p = normal("[[Aa,Ab,Ba,Bc,Cb,Cc]]")
    names = p.points
    degrees = p.degrees() or {}
    texts = []
    for seed in range(4):
        extensors = Extensors(Letters(names, tuple(degrees[n] for n in names), 4), seed=seed)
        at = values(p, extensors.positions, extensors.field.p).tolist()
        pairs = [next(c.trees(extensors)) for c in search_module.candidates(extensors, at)]
        texts.append({str(simplest(*pair, rank=4, order=names)) for pair in pairs})
    assert len(texts[0]) > 20
    assert all(t == texts[0] for t in texts)


def test_arithmetic_is_exact() -> None:
    for rank in range(2, 9):
        field = residues(rank)
        x = np.array([0, 1, field.p, -field.p, field.p * (2**53 // field.p), 12345 * field.p + 1], dtype=np.float64)
        assert field.reduced(x.copy()).tolist() == [0, 1, 0, 0, 0, 1]
        y = np.arange(1, 200, dtype=np.float64)
        assert (field.reduced(field.inverse(y) * y) == 1).all()


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("[[Aa,Bb,Cc,Dd,Ee,Ff]]", True),
        ("(abc /\\ def /\\ gh)(ace /\\ bdg /\\ fh)", None),
        ("[[Aa,Ab,Bc,Cd,De,Ef]] * [ABCD] + [[Aa,Ab,Bc,Cd,De,Ef]] * [ABCD]", None),
    ],
)
def test_irreducible(text: str, answer: bool | None) -> None:
    assert irreducible(normal(text)) == answer


def test_symmetry_classes() -> None:
    """For six free legs the brackets fall into three kinds: two whole legs, one, none."""
    p = normal("[[Aa,Bb,Cc,Dd,Ee,Ff]]")
    found = Symmetries(p, limit=10**6).orbits([tuple(r) for r in combinations(range(12), 4)], moved_row)
    assert sorted(map(len, found)) == [15, 240, 240]


@pytest.mark.parametrize(
    ("legs", "first"),
    [("Aa Ab Bc Bd Ca Dc", "ABCc"), ("Aa Ab Ba Bc Cb Dd", "ADbd")],
    ids=["4-4.7", "4-4.5"],
)
def test_one_incidence_with_a_bracket(legs: str, first: str) -> None:
    """These classes are one incidence times a bracket; those before the first one that works are excluded."""
    e = parse(f"[[{', '.join(legs.split())}]]")
    f = factor(e, cofactor=True)
    assert not f.exists
    (form,) = f.rational
    assert str(form.cofactor) == f"[{first}]"
    assert vanishes(sub(ex.mul(form.cofactor, e), form.product()))
    assert f.to_json()["rational"][0]["cofactor"] == f"[{first}]"
    assert "excluded" in f.to_json()


@pytest.mark.parametrize(
    ("polynomial", "cofactor"),
    [
        pytest.param("[abc][ade][cde] + [acd][ade][bce]", "[ace]", id="a bracket that divides stands inside"),
        pytest.param("[acf][acf][def] - 2 [acf][adf][cef]", "[acd]", id="so does one of two"),
        pytest.param("([cef][abc][abd] + [bcd][abf][ace]) (gh /\\ ij /\\ kl)", "[acf]", id="beside an expression"),
    ],
)
def test_cofactors_of_reducible_polynomials(polynomial: str, cofactor: str) -> None:
    """What is excluded must hold for the whole input, and not only for what its factors leave."""
    f = gc.factor(polynomial, rank=3, cofactor=True)
    (form,) = f.rational
    assert not f.exists
    assert str(form.cofactor) == cofactor
    assert vanishes(sub(ex.mul(form.cofactor, gc.parse(polynomial, rank=3)), form.product()), rank=3)
    assert not any(cofactor in words for words in f.excluded)


@pytest.mark.parametrize(
    ("legs", "cofactor"),
    [
        ("Aa Ab Bc Bd Ce Df", "ACe /\\ ADf /\\ ab"),
        ("Aa Ab Ba Bc Cd De", "ACd /\\ ADe /\\ ab"),
        ("Aa Ab Ba Cc Dd Ee", "[AEae](ACc /\\ ADd /\\ ab)"),
        ("Aa Ab Bc Cd De Ef", "(ABc /\\ ACd /\\ ab)(ADe /\\ AEf /\\ ab)"),
    ],
    ids=["6-4.2", "5-4.3", "5-5.1", "6-5"],
)
def test_one_incidence_with_constructed_lines(legs: str, cofactor: str) -> None:
    p = normal(f"[[{', '.join(legs.split())}]]")
    found = next(line_cofactors(p, Effort(), Symmetries(p, limit=10**6)))
    assert str(found.cofactor) == cofactor
    multiple = normal(ex.mul(found.cofactor, p.to_expr()))
    for e in found.expressions[:3]:
        assert proved(multiple, e, 10**6)


def test_one_incidence_for_the_whole_polynomial() -> None:
    """4-4.4: with its bracket taken out there is no such expression, with the bracket left in there is."""
    e = parse("[[Aa, Ab, Ba, Bb, Cc, Dd]]")
    f = factor(e, cofactor=True)
    (form,) = f.rational
    assert str(form.cofactor) == "ACc /\\ ADd /\\ ab"
    assert form.factors == ()
    assert vanishes(sub(ex.mul(form.cofactor, e), form.product()))
    assert "(70 in all)" in f.excluded[0]


@pytest.mark.parametrize(
    ("text", "factors", "expressions"),
    [
        ("(abc /\\ def /\\ gh)(ace /\\ bdg /\\ fh)", 0, 2),
        ("3[abcd](abc /\\ def /\\ gh)**2", 1, 2),
        ("(ABa /\\ bcd /\\ Ce) [[Aa,Ab,Bc,Bd,Ce,Cf]]", 0, 2),
    ],
)
def test_products_of_several_expressions(text: str, factors: int, expressions: int) -> None:
    """Points repeat, so that neither the multilinear algorithm nor one expression does; the product is proved."""
    e = parse(text)
    f = factor(e)
    assert f.certificate.method == "normal-form"
    assert len(f.factors) == factors
    assert isinstance(f.expression, ex.Product)
    assert len(f.expression.factors) == expressions
    whole = f.to_expr()
    assert whole is not None
    assert vanishes(sub(e, whole))


@settings(max_examples=5)
@given(st.randoms(use_true_random=False), st.integers(2, 3))
def test_planted_products(rng: random.Random, number: int) -> None:
    """Three lines of the plane in a point, several times, points shared: as many expressions as were planted."""
    groups = [rng.sample("abcdefgh", 6) for _ in range(number)]
    planted = [f"({a}{b} /\\ {c}{d} /\\ {e}{f})" for a, b, c, d, e, f in groups]
    f = factor(normal(" ".join(planted), rank=3))
    assert isinstance(f.expression, ex.Product)
    assert len(f.expression.factors) == number
    whole = f.to_expr()
    assert whole is not None
    assert vanishes(sub(parse(" ".join(planted), rank=3), whole, 3), rank=3)


def test_irreducible_factors() -> None:
    """Three of degree eight, one of them twice; an irreducible polynomial does not split."""
    texts = ["abc /\\ def /\\ gh", "abd /\\ ceg /\\ fh", "abc /\\ def /\\ gh"]
    p = normal("".join(f"({t})" for t in texts))
    parts = split(p, limit=10**6)
    assert parts is not None
    assert sorted(map(str, parts)) == sorted(str(normal(t)) for t in texts)
    assert split(normal("[[Aa,Ab,Ba,Cc,Dd,Ee]]"), limit=10**6) is None


def test_coincidences_exclude_what_the_search_excludes() -> None:
    """Where points coincide there are no more expressions than before: what is excluded there is excluded by the search
    over all expressions, and a bracket that is a cofactor never is.
    """
    p = normal("[[Aa,Ab,Bc,Bd,Ca,Dc]]")
    coincidences = Coincidences(p, Effort())
    excluded = 0
    for orbit in Symmetries(p, limit=10**6).orbits([tuple(r) for r in combinations(range(8), 4)], moved_row):
        if coincidences.exclude(orbit):
            excluded += 1
            assert not search(p * p.with_terms({(orbit[0],): 1}), Effort())[0]
        if excluded > 3:
            break
    assert excluded > 2
    works = tuple(sorted(p.points.index(n) for n in "ABCc"))
    assert not coincidences.exclude([works])


@settings(max_examples=20)
@given(st.sampled_from([c["legs"] for c in REGULAR]), st.randoms(use_true_random=False))
def test_coinciding_points(legs: list[str], rng: random.Random) -> None:
    """The polynomial after a coincidence has the values of the polynomial at positions where the points coincide."""
    p = normal(f"[[{', '.join(legs)}]]")
    kept, gone = sorted(rng.sample(range(len(p.points)), 2))
    names: dict[str, Expr] = {p.points[gone]: ex.Point(p.points[kept])}
    merged = coinciding(p, kept, gone)
    assert vanishes(sub(substitute(p.to_expr(), names), merged.to_expr()))


@pytest.mark.parametrize("legs", ["Aa Ab Ba Bb Cc Dd", "Aa Ab Bc Cc Dd Ee"], ids=["4-4.4", "5-5.2"])
def test_no_bracket_is_a_cofactor(legs: str) -> None:
    """Every bracket is excluded, whole orbits at a time, by few searches."""
    f = factor(parse(f"[[{', '.join(legs.split())}]]"), cofactor=True)
    number = {8: 70, 10: 210}[len(set(legs) - {" "})]
    assert f"({number} in all)" in f.excluded[0]
    (form,) = f.rational
    assert not isinstance(form.cofactor, ex.Bracket)


def test_values_show_themselves() -> None:
    f = gc.factor("[[ab,af,cb,cd,ed,ef]]")
    data = f.to_json()
    assert list(data) == ["coefficient", "factors", "expression", "alternatives", "more", "family", "certificate"]
    assert data["expression"] == "abc /\\ aef /\\ bdf /\\ cde"
    assert data["factors"] == []
    assert data["certificate"]["method"] == "normal-form"
    assert "∧" in f.text(unicode=True)
    assert "\\wedge" in f.latex()
    assert f._repr_latex_().startswith("$")
    with pytest.raises(AttributeError):
        f.coefficient = 2
    every = gc.factor("[[ab,af,cb,cd,ed,ef]]", all=True)
    assert len(every.alternatives) == f.more
    assert str(every.alternatives[0].expression) == "abf /\\ ace /\\ bcd /\\ def"
    none = gc.factor("[[Aa,Bb,Cc,Dd,Ee,Ff]]")
    assert none.to_json()["expression"] is None
    assert none.to_json()["remainder"] == str(none.remainder)
    assert none.to_expr() is None
    assert none.latex()


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["[abd][ace] - [abe][acd]", "--rank", "3"], 0, "[abc][ade]"),
        (["-[abcd][efgh]", "--json"], 0, '"coefficient": -1'),
        (["[[Aa,Bb,Cc,Dd,Ee,Ff]]"], 1, "none exists in the family"),
        (["[abcd] + [abce]"], 2, "not homogeneous"),
        (["[[Aa,Ab,Ba,Bc,Cb,Cc]]", "--limit", "100"], 3, "--limit"),
        (["[[Aa,Ab,Bc,Cd,De,Ef]]", "--seconds", "0"], 3, "more than 0 seconds"),
    ],
)
def test_command(arguments: list[str], code: int, words: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "gcrules", "factor", *arguments], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == code, done.stderr
    assert words in done.stdout + done.stderr


@pytest.mark.parametrize("decide", [gc.factor, gc.shorten])
def test_extensors_are_refused(decide: Callable[[Any], Any]) -> None:
    with pytest.raises(InputError, match="only scalars are"):
        decide(gc.expand("ab /\\ cde"))
