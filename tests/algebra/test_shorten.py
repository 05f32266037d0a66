"""Shortest bracket forms: equal to what was given, no longer than needed, and lower bounds that hold."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, product
from math import comb
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result
from hypothesis import given, settings
from hypothesis import strategies as st
from platform_classes import REGULAR

import gcrules as gc
from gcrules.algebra.bracket import BracketPolynomial, Monomial, sorted_row
from gcrules.algebra.evaluate import Evaluator, random_points, random_rational_points, vanishes
from gcrules.algebra.expr import sub
from gcrules.algebra.factoring.modular import MODULUS, PRIMES, determinants, inverse, minor, reduced
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.shortening.exact import combination
from gcrules.algebra.shortening.exhaustive import certain, combinations_of, spans
from gcrules.algebra.shortening.linear_program import maximized
from gcrules.algebra.shortening.merging import MergingBound, merging_bound
from gcrules.algebra.shortening.monomials import Monomials, canonical
from gcrules.algebra.shortening.shorten import shorten
from gcrules.algebra.shortening.symmetry import Action, orbits, symmetry
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.apps.cli import cli
from gcrules.conditions.catalog_check import check_entry
from gcrules.core.budget import Count
from gcrules.core.errors import InputError
from gcrules.rules.catalog.file import load

LETTERS = "abcdefghijklmnop"


def work() -> Count:
    return Count(10**12, "the search handles", "residues")


def normal(poly: BracketPolynomial) -> BracketPolynomial:
    found = straighten(poly)
    assert isinstance(found, BracketPolynomial)
    return found


def superbracket(c: dict[str, Any]) -> BracketPolynomial:
    return superbracket_form([tuple(leg) for leg in c["legs"]]).polynomial


def by_id(class_id: str) -> dict[str, Any]:
    return next(c for c in REGULAR if c["id"] == class_id)


# --- another road: all products of brackets, exact values, all sets of them ----------------------------------------


def all_products(degrees: tuple[int, ...], rank: int, ideal: int) -> list[Monomial]:
    """By trying all ways to cut all arrangements; for few letters only."""
    letters = [i for i, d in enumerate(degrees) for _ in range(d)]

    def cut(left: tuple[int, ...]) -> Iterator[Monomial]:
        if not left:
            yield ()
            return
        for others in set(combinations(left[1:], rank - 1)):
            row = (left[0], *others)
            if len(set(row)) < rank or row[-1] < ideal:
                continue
            rest = list(left)
            for i in row:
                rest.remove(i)
            for more in cut(tuple(rest)):
                yield tuple(sorted((row, *more)))

    return sorted(set(cut(tuple(letters))))


def exact_values(poly: BracketPolynomial, samples: int) -> list[Fraction]:
    e = poly.to_expr()
    found = []
    for seed in range(samples):
        at = random_rational_points(poly.points, rank=poly.rank, seed=seed, size=20)
        at = {n: (*c[:-1], 0) if i < poly.ideal else c for i, (n, c) in enumerate(at.items())}
        found.append(Fraction(Evaluator(at, poly.rank).value(e)[0]))
    return found


def rank_of(rows: list[list[Fraction]]) -> int:
    rows, rank = [list(r) for r in rows], 0
    for column in range(len(rows[0])):
        pivot = next((i for i in range(rank, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        for i in range(rank + 1, len(rows)):
            factor = rows[i][column] / rows[rank][column]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[rank], strict=True)]
        rank += 1
        if rank == len(rows):
            break
    return rank


def fewest_terms(poly: BracketPolynomial, most: int) -> int | None:
    """The least size of a set of products in whose span the polynomial is, up to `most`; None where it is none of the
    sizes for which there are few sets.
    """
    degrees = tuple(sum(i in row for row in next(iter(poly.terms))) for i in range(len(poly.points)))
    products = [poly.with_terms({m: 1}) for m in all_products(degrees, poly.rank, poly.ideal)]
    vectors = [exact_values(p, most + 3) for p in products]
    target = exact_values(poly, most + 3)
    for size in range(1, most + 1):
        if comb(len(vectors), size) > 600:
            break
        for chosen in combinations(vectors, size):
            if rank_of([*chosen, target]) == rank_of(list(chosen)):
                return size
    return None


SHAPES = {
    "rank 2": (2, (1, 1, 1, 1, 1, 1)),
    "rank 2, points repeated": (2, (2, 2, 2, 2)),
    "rank 2, unequal": (2, (3, 1, 1, 1, 2)),
    "rank 3": (3, (1, 1, 1, 1, 1, 1)),
    "rank 3, points repeated": (3, (2, 2, 2, 1, 1, 1)),
    "rank 3, nine letters": (3, (2, 2, 1, 1, 1, 1, 1)),
    "rank 4": (4, (1,) * 8),
    "rank 4, points repeated": (4, (2, 2, 2, 2, 2, 1, 1)),
}


@st.composite
def polynomials(draw: st.DrawFn, *, ideal: bool = False) -> BracketPolynomial:
    """A sum of a few products with small coefficients, written in a longer way (its normal form) or as it is."""
    rank, degrees = SHAPES[draw(st.sampled_from(sorted(SHAPES)))]
    at_infinity = draw(st.integers(1, rank)) if ideal else 0
    products = all_products(degrees, rank, at_infinity)
    if not products:
        return BracketPolynomial(rank, tuple(LETTERS[: len(degrees)]), {}, at_infinity)
    chosen = draw(st.lists(st.sampled_from(products), min_size=1, max_size=4, unique=True))
    coefficients: st.SearchStrategy[int | Fraction] = st.sampled_from([1, -1, 2, Fraction(-3, 2), 5])
    poly = BracketPolynomial(rank, tuple(LETTERS[: len(degrees)]), {m: draw(coefficients) for m in chosen}, at_infinity)
    return normal(poly) if draw(st.booleans()) else poly


@settings(max_examples=60)
@given(polynomials())
def test_agrees_with_trying_all_sets(poly: BracketPolynomial) -> None:
    found = shorten(poly)
    assert vanishes(sub(poly.to_expr(), found.polynomial.to_expr(), rank=poly.rank), rank=poly.rank)
    assert found.lower <= found.terms <= len(normal(poly))
    assert found.minimal
    if found.terms:
        least = fewest_terms(poly, found.terms)
        assert least in (found.terms, None)


@settings(max_examples=25)
@given(polynomials(ideal=True))
def test_agrees_with_trying_all_sets_with_ideal_points(poly: BracketPolynomial) -> None:
    found = shorten(poly)
    assert found.polynomial.ideal == poly.ideal
    assert normal(found.polynomial - poly).terms == {}
    assert found.lower <= found.terms
    if found.terms:
        least = fewest_terms(poly, found.terms)
        assert least is None or found.lower <= least
        assert least in (found.terms, None) or not found.minimal


@settings(max_examples=30)
@given(polynomials(), st.integers(0, 2**32))
def test_bounds_by_merging_hold(poly: BracketPolynomial, seed: int) -> None:
    """The bound never exceeds the length of any form, such as sums with a syzygy added."""
    target = normal(poly)
    if not target:
        return
    monomials = Monomials.of(target, 5_000)
    found = symmetry(target, 10_000)
    bound = merging_bound(target, monomials, orbits(monomials, found), work(), 99)
    assert bound is not None
    assert bound.lower <= min(len(poly), len(target))
    assert bound.lower == -(-sum(c.weight * c.least for c in bound.conditions) // 1)


# --- the classes ---------------------------------------------------------------------------------------------------

BEYOND_BRACKETS = {"6-6": "merging", "6-5": "merging", "5-5.1": "merging"}


@pytest.mark.parametrize("c", REGULAR, ids=lambda c: c["id"])
def test_classes(c: dict[str, Any]) -> None:
    """No bracket polynomial is shorter than the shortest of the 24-term and 16-term forms, for any class."""
    e = parse(f"[[{', '.join(c['legs'])}]]")
    found = shorten(e)
    assert found.minimal
    assert found.terms == found.lower == min(c["terms24"], c["terms16"])
    assert vanishes(sub(e, found.polynomial.to_expr()))
    assert found.bound.method == BEYOND_BRACKETS.get(c["id"], found.bound.method)
    assert not found.notes


@pytest.mark.parametrize("class_id", ["6-5", "5-5.1", "6-4.2", "5-4.4", "4-4.5", "3-3.3"])
def test_classes_from_their_normal_forms(class_id: str) -> None:
    """The short form is found again from the many terms of the normal form."""
    c = by_id(class_id)
    found = shorten(normal(superbracket(c)))
    assert (found.terms, found.minimal) == (min(c["terms24"], c["terms16"]), True)


def replayed(bound: MergingBound, poly: BracketPolynomial) -> Fraction:
    """The bound by another road: images of each merging under all symmetries, brackets as sets of names.

    What is returned is Σ weight · least divided by the most that one monomial counts for.
    """
    found = symmetry(normal(poly), 10**6)
    names = poly.points
    monomials = [
        [frozenset(names[i] for i in row) for row in m] for m in Monomials.of(poly, 10_000).all[:: 1 + len(names) // 12]
    ]
    most = Fraction(0)
    elements = [dict(zip(names, (names[i] for i in g), strict=True)) for g in found.elements.tolist()]
    for m in random.Random(3).sample(monomials, min(12, len(monomials))):
        total = Fraction(0)
        for c in bound.conditions:
            assert c.blocks
            left = 0
            for g in elements:
                images = [{g[n] for n in block} for block in c.blocks]
                left += all(len(row & block) < 2 for row in m for block in images)
            total += c.weight * Fraction(left, len(elements))
        most = max(most, total)
    assert most <= 1
    return sum((c.weight * c.least for c in bound.conditions), Fraction(0))


@pytest.mark.parametrize("class_id", ["6-5", "5-5.1", "6-4.2", "5-4.3"])
def test_certificates_of_mergings(class_id: str) -> None:
    c = by_id(class_id)
    target = normal(superbracket(c))
    monomials = Monomials.of(target, 10_000)
    found = symmetry(target, 10**6)
    bound = merging_bound(target, monomials, orbits(monomials, found), work(), 99)
    assert bound is not None
    assert bound.lower == min(c["terms24"], c["terms16"])
    assert replayed(bound, target) > bound.lower - 1
    for condition in bound.conditions:
        home = {n: block[0] for block in condition.blocks for n in block}
        merged = [tuple(home.get(n, n) for n in leg) for leg in c["legs"]]
        left = normal(superbracket_form(merged).polynomial)
        assert len(left) >= 1
        if condition.least > 1:
            assert shorten(left).terms >= condition.least


def test_the_general_platform_needs_sixteen_terms() -> None:
    """The one merging: three blocks of three joints and three single ones leave at most 1/15 of the images of any
    monomial, so 15 terms are needed, and 15 would all lie where the signs cancel.
    """
    c = by_id("6-6")
    blocks = ["ABC", "DEa", "Fbd"]
    home = {n: block[0] for block in blocks for n in block}
    merged = superbracket_form([tuple(home.get(n, n) for n in leg) for leg in c["legs"]]).polynomial
    assert len(normal(merged)) >= 1
    target = normal(superbracket(c))
    monomials = Monomials.of(target, 6_000)
    found = symmetry(target, 10**6)
    classes = orbits(monomials, found)
    assert (len(monomials), found.order) == (5775, 46080)
    place = {n: i for i, n in enumerate(target.points)}
    where = np.zeros(12, dtype=np.int64)
    for n, block in enumerate(blocks, 1):
        where[[place[x] for x in block]] = n
    shares = {}
    for label in np.unique(classes.label).tolist():
        at = where[found.elements[:, monomials.rows[label]]]  # (symmetry, bracket, point): the block or 0
        left = [((at == n).sum(axis=-1) < 2).all(axis=-1) for n in (1, 2, 3)]
        shares[label] = Fraction(int(np.logical_and.reduce(left).sum()), len(found.elements))
    assert max(shares.values()) == Fraction(1, 15)
    tight = [label for label, share in shares.items() if share == Fraction(1, 15)]
    assert all(classes.cancels[label] for label in tight)


@pytest.mark.parametrize("class_id", ["6-5", "3-3.3", "6-3.1"])
def test_the_catalog_check_proves_the_number(class_id: str) -> None:
    entry = load()[class_id]
    assert entry.shortest is not None
    assert check_entry(entry).ok
    wrong = check_entry(replace(entry, shortest=entry.shortest + 1))
    assert wrong.faults == (f"shortest {entry.shortest + 1}, computed {entry.shortest}",)


# --- the parts -----------------------------------------------------------------------------------------------------


@given(st.lists(st.integers(0, MODULUS - 1), min_size=1, max_size=9))
def test_residues(numbers: list[int]) -> None:
    x = np.array(numbers, dtype=np.int64)
    assert [int(v) * n % MODULUS for v, n in zip(inverse(x), numbers, strict=True)] == [n != 0 for n in numbers]
    y = x[::-1].copy()
    assert reduced(x * y).tolist() == [a * b % MODULUS for a, b in zip(numbers, reversed(numbers), strict=True)]
    assert minor(x, y, y, y).tolist() == [
        (a * b - b * b) % MODULUS for a, b in zip(numbers, numbers[::-1], strict=True)
    ]


@pytest.mark.parametrize("rank", [2, 3, 4, 5])
def test_determinants(rank: int) -> None:
    at = random_positions(3, rank + 1, rank, MODULUS, seed=4)
    rows = [tuple(c) for c in combinations(range(rank + 1), rank)]
    names = tuple(LETTERS[: rank + 1])
    expected = [values(BracketPolynomial(rank, names, {(row,): 1}), at, MODULUS).tolist() for row in rows]
    assert determinants(at, np.array(rows)).tolist() == expected


@pytest.mark.parametrize(("rank", "degrees"), SHAPES.values(), ids=SHAPES)
@pytest.mark.parametrize("ideal", [0, 2, 3])
def test_all_monomials(rank: int, degrees: tuple[int, ...], ideal: int) -> None:
    """Those of the other road, one of those that are equal as functions."""
    products = all_products(degrees, rank, ideal)
    if not products:
        return
    poly = BracketPolynomial(rank, tuple(LETTERS[: len(degrees)]), {products[0]: 1}, ideal)
    monomials = Monomials.of(poly, 10_000)
    assert set(monomials.all) == {canonical(m, ideal) for m in products}
    at = random_positions(3, len(degrees), rank, MODULUS, ideal=ideal, seed=9)
    found = [tuple(v) for v in monomials.values(at).tolist()]
    assert len(set(found)) == len(found)
    assert {tuple(values(poly.with_terms({m: 1}), at, MODULUS).tolist()) for m in products} == set(found)


@pytest.mark.parametrize("class_id", ["6-4.2", "5-4.4", "3-3.3"])
def test_symmetries_and_orbits(class_id: str) -> None:
    target = normal(superbracket(by_id(class_id)))
    monomials = Monomials.of(target, 10_000)
    found = symmetry(target, 10**6)
    names = target.points
    classes = orbits(monomials, found)
    action = Action(monomials)
    for g, sign in zip(found.generators, found.signs, strict=True):
        moved = BracketPolynomial(4, tuple(names[i] for i in g), target.terms).over(names)
        assert normal(moved) == target * int(sign)
        for i, j in enumerate(action.image(g).tolist()):
            s = 1
            rows: list[tuple[int, ...]] = []
            for row in monomials.all[i]:
                t, r = sorted_row(int(g[k]) for k in row)
                s, rows = s * t, [*rows, r]
            assert monomials.all[j] == tuple(sorted(rows))
            assert action.signs(g)[i] == s
            assert classes.label[i] == classes.label[j]
    assert len(np.unique(found.elements, axis=0)) == found.order


@pytest.mark.parametrize("class_id", ["4-4.5", "5-3.4", "3-3.3", "4-4.4"])
@pytest.mark.parametrize("terms", [2, 3, 4])
def test_the_complete_search_misses_nothing(class_id: str, terms: int) -> None:
    """Beside all pairs and triples (and fours, with one of them given) by elimination; symmetries may be used or not.

    The targets are random sums of so many monomials that no shorter form has.
    """
    target = normal(superbracket(by_id(class_id)))
    monomials = Monomials.of(target, 10_000)
    action = Action(monomials)
    at = random_positions(10, len(target.points), 4, MODULUS, seed=2)
    value = monomials.values(at)
    rng = random.Random(terms)
    chosen = rng.sample(range(len(monomials)), min(terms, len(monomials) - 1))
    poly = target.with_terms({monomials.all[i]: 7 * n + 2 for n, i in enumerate(chosen)})
    aim = values(poly, at, MODULUS)
    identity = np.arange(len(target.points))[None, :]
    for fewer in range(1, len(chosen) + 1):
        found = set(combinations_of(fewer, value, aim, action, identity, work()))
        if found:
            break
    if fewer <= 3 and len(monomials) < 50:
        brute = {s for s in combinations(range(len(monomials)), fewer) if spans(value[list(s)], aim)}
        assert found <= brute
        assert bool(found) == bool(brute)
        assert len(brute) > 30 or found == brute
    for places in list(found)[:5]:
        written = combination(normal(poly), [monomials.all[i] for i in places], 10_000)
        assert written is not None
        assert normal(written) == normal(poly)
        assert len(written) == fewer


def test_certain_only_while_coefficients_are_small() -> None:
    """Four points stand at the unit vectors, one at (1, 1, 1, 1), three are left; with more primes more is certain."""
    monomials = Monomials(4, (3,) * 8, 0, ())
    assert monomials.coefficient_bound() == 6**3
    assert certain(monomials, 3)
    assert not certain(monomials, 4)
    assert certain(monomials, 4, PRIMES[:2])
    assert Monomials(4, (2,) * 4 + (3,) * 4, 4, ()).coefficient_bound() == 2 * 6**3


def test_linear_program_against_its_corners() -> None:
    """The best of all corners of small random programs."""
    rng = np.random.default_rng(8)
    for _ in range(40):
        use = rng.integers(0, 5, (4, 3)).astype(float)
        use[:, use.sum(axis=0) == 0] = 1
        gain = rng.integers(1, 6, 3).astype(float)
        found = maximized(gain, use)
        assert (use @ found <= 1 + 1e-9).all()
        rows = np.vstack([use, np.eye(3)])
        right = np.concatenate([np.ones(4), np.zeros(3)])
        best = 0.0
        for chosen in combinations(range(7), 3):
            part = rows[list(chosen)]
            if abs(np.linalg.det(part)) > 1e-9:
                corner = np.linalg.solve(part, right[list(chosen)])
                if (corner > -1e-9).all() and (use @ corner < 1 + 1e-9).all():
                    best = max(best, float(gain @ corner))
        assert abs(gain @ found - best) < 1e-6


def test_combinations_are_solved_exactly() -> None:
    p = gc.expand(f"[abcd][efgh] * {10**400} - [abce][dfgh] * 3 + 1/7 * [abcf][degh]")
    assert isinstance(p, BracketPolynomial)
    p = normal(p)
    assert combination(p, p.terms, 100) == p
    assert combination(p, list(p.terms)[:2], 100) is None


# --- input and output ----------------------------------------------------------------------------------------------


def run(*arguments: str, stdin: str | None = None) -> Result:
    result = CliRunner().invoke(cli, ["shorten", *arguments], input=stdin, prog_name="gcrules")
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


@pytest.mark.parametrize(
    ("text", "rank", "terms"),
    [
        ("[abcd] - [abcd]", 4, 0),
        ("[abc][def] - [abd][cef] + [abe][cdf] - [abf][cde]", 3, 0),
        ("0", 4, 0),
        ("7", 4, 1),
        ("[abcd] + 1", 4, 2),
        ("[abcd][efgh] + [abce][dfgh] + [abcd]", 4, 3),
        ("[ab][cd] - [ac][bd] + [ef]", 2, 2),
        ("([ab][cd] - [ac][bd]) [ef]", 2, 1),
        (r"(abc /\ de) \/ fg", 4, None),
    ],
)
def test_any_input(text: str, rank: int, terms: int | None) -> None:
    if terms is None:
        with pytest.raises(InputError, match="only scalars"):
            gc.shorten(r"abc /\ def")
        return
    found = gc.shorten(text, rank=rank)
    assert (found.terms, found.minimal) == (terms, True)


def test_long_coefficients() -> None:
    big = 10**999 + 7
    found = gc.shorten(f"{big}*[abcd][efgh] - {big}*[abce][dfgh] + [abcf][degh]")
    assert (found.terms, found.minimal) == (3, True)
    multiple = gc.shorten(f"{big}*([abc][def] - [abd][cef] + [abe][cdf])", rank=3)
    assert str(multiple.polynomial) == f"{big}[abf][cde]"


def test_forty_points() -> None:
    names = [f"p{i}" for i in range(40)]
    rows = ["".join(names[i : i + 4]) for i in range(0, 40, 4)]
    one = "".join(f"[{row}]" for row in rows)
    assert gc.shorten(one).minimal
    swapped = one.replace("p3]", "p4]").replace("[p4p", "[p3p")
    three = gc.shorten(f"{one} + {swapped} + 2 {swapped.replace('p7]', 'p8]').replace('[p8p', '[p7p')}", limit=2_000)
    assert three.undecided
    assert (three.terms, three.lower) == (3, 2)


def test_limits() -> None:
    many = gc.shorten("[[Aa, Bb, Cc, Dd, Ee, Ff]]", limit=100)
    assert "more than 100 bracket monomials" in many.undecided
    assert (many.terms, many.lower, many.minimal) == (16, 2, False)
    assert "--limit raises the limit" in many.text()
    assert many.to_json()["undecided"] == many.undecided
    hurried = gc.shorten("[[Aa, Bb, Cc, Dd, Ee, Ff]]", seconds=0)
    assert (hurried.terms, hurried.minimal) == (16, False)
    assert hurried.lower >= 2
    assert any("0 seconds" in note for note in hurried.notes)
    assert "the fewest that were found" in str(hurried)


def test_the_same_answer_every_time() -> None:
    e = "[[Aa, Ab, Bc, Bd, Ca, De]]"
    first = gc.shorten(e)
    assert first == gc.shorten(e)
    assert hash(first) == hash(gc.shorten(e))


@pytest.mark.parametrize("ideal", ["D E F", "A B C D E F", "A"])
def test_ideal_points(ideal: str) -> None:
    e = parse("[[Aa, Ba, Cb, Db, Ec, Fc]]")
    found = gc.shorten(e, ideal=ideal)
    assert vanishes(sub(e, found.polynomial.to_expr()), ideal=ideal.split())
    assert found.minimal


def test_command() -> None:
    found = json.loads(run("[[Aa,Ab,Ba,Bc,Cb,Dd]]", "--json").stdout)
    assert list(found) == [
        "polynomial",
        "terms",
        "given",
        "lower",
        "minimal",
        "monomials",
        "symmetries",
        "bound",
        "certificate",
        "notes",
    ]
    assert (found["terms"], found["lower"], found["minimal"], found["monomials"]) == (3, 3, True, 107)
    assert vanishes(sub(parse("[[Aa,Ab,Ba,Bc,Cb,Dd]]"), parse(found["polynomial"])))
    assert run("-", "--rank", "2", stdin="[ab][cd] - [ac][bd]").stdout.startswith("−[ad][bc]\n")
    assert run("-[ab][cd]", "--rank", "2", "--latex").stdout == "-[ab][cd]\n"
    assert run("--ascii", "[ab][cd] + [ac][bd]", "--rank", "2").stdout.splitlines()[1] == (
        "2 terms of 2, proved minimal"
    )


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["ab"], 2, "only scalars are shortened, this is a line (step 2)"),
        (["[abc"], 2, "error: <input>:1:"),
        (["[[Aa,Bb,Cc,Dd,Ee,Ff]]", "--limit", "50"], 3, "more than 50 bracket monomials"),
        (["[abcd]", "--limit", "0"], 2, "--limit"),
        (["[abcd]", "--rank", "9"], 2, "rank 9"),
    ],
)
def test_exit_codes(arguments: list[str], code: int, message: str) -> None:
    result = run(*arguments)
    assert (result.exit_code, message in result.stdout + result.stderr) == (code, True), result.output


def test_all_signs_of_three_terms() -> None:
    """Three products of two brackets in rank 2 are dependent with one choice of signs, up to a common one."""
    found = [gc.shorten(f"{s}[ab][cd] {t}[ac][bd] {u}[ad][bc]", rank=2).terms for s, t, u in product("+-", repeat=3)]
    assert sorted(found) == [0, 0, 1, 1, 1, 1, 1, 1]


def test_evaluations_agree_at_random_points() -> None:
    e = parse("[[Aa, Bb, Cc, Dd, Ee, Ff]]")
    p = shorten(e).polynomial
    at = random_points(p.points, seed=12)
    assert gc.evaluate(e, at, modulus=2**61 - 1) == gc.evaluate(p.to_expr(), at, modulus=2**61 - 1)
