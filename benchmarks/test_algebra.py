"""Straightening, the shortest superbracket and the whole analysis in a warm process, each beside a naive form."""

from __future__ import annotations

import random
from collections.abc import Callable
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
import yaml

from gcrules.algebra.bracket import BracketPolynomial, Monomial
from gcrules.algebra.expand import expand
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.straightening import diagonal
from gcrules.algebra.straightening import syzygies as two_rows
from gcrules.algebra.straightening.order import orders, reordered
from gcrules.algebra.straightening.straighten import is_zero, straighten, straighten_steps, straighten_terms
from gcrules.algebra.superbrackets.shortest import _table, shortest_forms, superbracket_form
from gcrules.mechanisms.platform_analysis import analyze_legs

DATA = Path(__file__).resolve().parent.parent / "tests" / "data" / "gsp_classes.yaml"
CLASSES = yaml.safe_load(DATA.read_text(encoding="utf-8"))["classes"]
LEGS = {c["id"]: [(a, b) for a, b in c["legs"]] for c in CLASSES}
POINTS = tuple("abcdefghijkl")


def cubic(monomial: Monomial) -> BracketPolynomial:
    return BracketPolynomial(4, POINTS, {monomial: 1})


def random_cubics(number: int, seed: int = 1) -> list[BracketPolynomial]:
    rng, found = random.Random(seed), []
    for _ in range(number):
        p = rng.sample(range(12), 12)
        found.append(cubic(tuple(sorted(tuple(sorted(p[i : i + 4])) for i in (0, 4, 8)))))
    return found


def single_syzygies(p: BracketPolynomial) -> BracketPolynomial:
    """The textbook method: one syzygy at a time, nothing kept."""
    return straighten_steps(p, limit=100_000)[0]


def cold(function: Callable[[], Any]) -> Callable[[], Any]:
    """The function with nothing kept of earlier calls."""

    def run() -> Any:
        two_rows.two_rows.cache_clear()
        two_rows.two_row_pattern.cache_clear()
        diagonal._basis.cache_clear()
        return function()

    return run


@pytest.mark.parametrize(
    "monomial", ["[afgl][behk][cdij]", "[aghl][bcij][defk]", "[ajkl][bghi][cdef]", "[ahil][bgjk][cdef]"]
)
def test_straighten_one(ratio: Callable[..., Any], monomial: str) -> None:
    p = expand(parse(monomial))
    assert isinstance(p, BracketPolynomial)
    others = {
        "single syzygies": lambda: single_syzygies(p),
        "diagonal monomials": cold(lambda: diagonal.normal_form(p)),
        "nothing kept": cold(lambda: straighten(p)),
    }
    ratio(lambda: straighten(p), others, agree=lambda a, b: a == b, within=0.06, others_rounds=2)


def test_straighten_worst(ratio: Callable[..., Any]) -> None:
    """The monomial with most terms in its normal form among 2,000 random ones."""
    worst = max(random_cubics(2_000, seed=5), key=lambda p: len(straighten(p)))
    ratio(
        lambda: straighten(worst),
        {"single syzygies": lambda: single_syzygies(worst)},
        agree=lambda a, b: a == b,
        within=0.06,
        others_rounds=2,
    )


def test_straighten_thousand(ratio: Callable[..., Any]) -> None:
    """1,000 random cubic monomials; the naive form does a tenth of them, so multiply its ratio by ten."""
    many = random_cubics(1_000)
    ratio(
        cold(lambda: [straighten(p) for p in many]),
        {"single syzygies, a tenth": lambda: [single_syzygies(p) for p in many[:100]]},
        agree=lambda a, b: a[:100] == b,
        within=3,
        rounds=2,
        others_rounds=1,
    )


def shortest_by_loop(legs: list[tuple[str, str]]) -> int:
    """Fewest terms, one order after the other."""
    orders = permutations(range(6))
    return min(len(superbracket_form(legs, order, form).polynomial) for order in orders for form in (24, 16))


@pytest.mark.parametrize("class_id", ["6-6", "6-5", "3-3.3"])
def test_shortest(ratio: Callable[..., Any], class_id: str) -> None:
    """All 720 orders and both forms: arrays against a loop over the orders."""
    legs = LEGS[class_id]

    def arrays() -> int:
        _table.cache_clear()
        return len(shortest_forms(legs)[0].polynomial)

    ratio(
        arrays,
        {"loop": lambda: shortest_by_loop(legs)},
        agree=lambda a, b: a == b,
        within=0.1,
        at_least={"loop": 5},
        others_rounds=1,
    )


@pytest.mark.parametrize("class_id", list(LEGS))
def test_analyze_warm(ratio: Callable[..., Any], class_id: str) -> None:
    """A class in a warm process, shortest form included, beside the loop over orders alone."""
    legs = LEGS[class_id]

    def fresh() -> str:
        _table.cache_clear()
        return str(analyze_legs(legs).condition.expression)

    others = {"loop over orders alone": lambda: shortest_by_loop(legs)}
    ratio(fresh, others, within=0.1, rounds=3, others_rounds=1)


def test_a_relation_times_five_brackets(ratio: Callable[..., Any]) -> None:
    """An exchange of points in rank 4, times five brackets, in 21 points: beside straightening all of it."""
    rng = random.Random(8)
    names = tuple(f"p{i}" for i in range(1, 22))
    sets = [rng.sample(names, 4) for _ in range(7)]
    times = " ".join(f"[{' '.join(s)}]" for s in sets[:5])
    a, b = sets[5:]
    moved = [f"[{' '.join((*a[:i], b[0], *a[i + 1 :]))}][{' '.join((a[i], *b[1:]))}]" for i in range(4)]
    p = expand(parse(f"{times} ([{' '.join(a)}][{' '.join(b)}] - {' - '.join(moved)})"))
    assert isinstance(p, BracketPolynomial)
    ratio(
        lambda: is_zero(p),
        {"all of it": lambda: not straighten_terms(reordered(p.terms, orders(p.terms, 21, 0)[0]))},
        agree=lambda one, other: one == other,
        within=1,
        others_rounds=1,
    )
