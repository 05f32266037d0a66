"""Factorization and transversals of all classes, and one search beside the same search in plain Python."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
import yaml

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.factorize import factor
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.scalars import bracket
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.transversals import find

DATA = Path(__file__).resolve().parent.parent / "tests" / "data" / "gsp_classes.yaml"
REGULAR = [c for c in yaml.safe_load(DATA.read_text(encoding="utf-8"))["classes"] if c["regular"]]
LEGS = {c["id"]: [(a, b) for a, b in c["legs"]] for c in REGULAR}


def superbracket(class_id: str) -> BracketPolynomial:
    return superbracket_form(LEGS[class_id]).polynomial


def one_after_the_other(poly: BracketPolynomial) -> bool:
    """Lines of six letters against six, in integers, one product at a time; twelve letters without brackets only."""
    normal = straighten(poly)
    assert isinstance(normal, BracketPolynomial)
    degrees = normal.degrees() or {}
    letters = tuple(n for n in normal.points for _ in range(degrees[n]))
    at = [Evaluator(random_points(normal.points, seed=n), 4, PRIME) for n in (1, 2)]
    values = [a.value(normal.to_expr())[0] for a in at]

    @cache
    def lines(six: tuple[str, ...]) -> list[Expr]:
        found: dict[Any, Expr] = {}
        for three in set(combinations(six, 3)):
            rest = without(six, three)
            add(found, ex.meet(joined(three), joined(rest)))
            for n in set(rest):
                two = without(rest, (n,))
                add(found, ex.join(ex.meet(joined(three), joined(two)), ex.Point(n)))
        return list(found.values())

    def add(found: dict[Any, Expr], e: Expr) -> None:
        v = at[0].value(e)
        lead = next((x for x in v if x), 0)
        if lead:
            scale = pow(lead, -1, PRIME)
            found.setdefault(tuple(x * scale % PRIME for x in v), e)

    for six in set(combinations(letters, 6)):
        for one in lines(six):
            for other in lines(without(letters, six)):
                e = bracket(one, other)
                v, w = (a.value(e)[0] for a in at)
                if v and (v * values[1] - w * values[0]) % PRIME == 0:
                    return True
    return False


def joined(names: tuple[str, ...]) -> Expr:
    return ex.join(*map(ex.Point, names))


def without(names: tuple[str, ...], some: tuple[str, ...]) -> tuple[str, ...]:
    rest = list(names)
    for n in some:
        rest.remove(n)
    return tuple(rest)


@pytest.mark.parametrize("class_id", ["4-4.7", "4-4.5"])
def test_search(ratio: Callable[..., Any], class_id: str) -> None:
    """Every expression tested, none found: matrices modulo a prime against a loop in Python."""
    poly = superbracket(class_id)
    ratio(
        lambda: factor(poly).exists,
        {"loop": lambda: one_after_the_other(poly)},
        agree=lambda a, b: a == b,
        within=0.5,
        at_least={"loop": 10},
        rounds=3,
        others_rounds=1,
    )


@pytest.mark.parametrize("class_id", list(LEGS))
def test_class(ratio: Callable[..., Any], class_id: str) -> None:
    poly = superbracket(class_id)
    ratio(lambda: factor(poly).exists, {}, within=1, rounds=3)


def test_all_classes(ratio: Callable[..., Any]) -> None:
    """The 24 that are one expression, and the ten that are not."""
    polynomials = [superbracket(c) for c in LEGS]
    ratio(lambda: sum(bool(factor(p).exists) for p in polynomials), {}, within=6, rounds=2)


NO_INCIDENCE = [c["id"] for c in REGULAR if not c["incidence"] and c["id"] != "6-6"]


@pytest.mark.parametrize("class_id", NO_INCIDENCE)
def test_cofactor(ratio: Callable[..., Any], class_id: str) -> None:
    """One incidence with a cofactor, the smaller cofactors excluded."""
    poly = superbracket(class_id)
    ratio(lambda: bool(factor(poly, cofactor=True).rational), {}, within=10, rounds=1)


def test_transversals(ratio: Callable[..., Any]) -> None:
    """The transversal conditions of all classes, found and tested."""

    def found() -> int:
        structures = [Structure(tuple(map(tuple, LEGS[c]))) for c in LEGS]
        return sum(bool(find(s, RandomWitness(s))) for s in structures)

    ratio(found, {}, within=6, rounds=2)
