"""Shortest forms: a complete search beside trying all pairs by exact elimination, and the proofs for all classes."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.factoring.modular import MODULUS
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.shortening.exhaustive import combinations_of
from gcrules.algebra.shortening.monomials import Monomials
from gcrules.algebra.shortening.shorten import shorten
from gcrules.algebra.shortening.symmetry import Action
from gcrules.algebra.straightening.straighten import straighten, straighten_terms
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.core.budget import Count

DATA = Path(__file__).resolve().parent.parent / "tests" / "data" / "gsp_classes.yaml"
REGULAR = [c for c in yaml.safe_load(DATA.read_text(encoding="utf-8"))["classes"] if c["regular"]]


def superbracket(class_id: str) -> BracketPolynomial:
    legs = next([(a, b) for a, b in c["legs"]] for c in REGULAR if c["id"] == class_id)
    normal = straighten(superbracket_form(legs).polynomial)
    assert isinstance(normal, BracketPolynomial)
    return normal


def all_pairs(poly: BracketPolynomial) -> bool:
    """Whether two bracket monomials have the polynomial in their span: every pair, by the normal forms."""
    monomials = Monomials.of(poly, 10_000)
    forms = [straighten_terms({m: 1}) for m in monomials.all]
    tableaux = sorted({t for form in (*forms, poly.terms) for t in form})
    columns = [[Fraction(form.get(t, 0)) for t in tableaux] for form in forms]
    target = [Fraction(poly.terms.get(t, 0)) for t in tableaux]
    return any(in_span([a, b], target) for a, b in combinations(columns, 2))


def in_span(vectors: list[list[Fraction]], target: list[Fraction]) -> bool:
    while vectors:
        one, *vectors = vectors
        at = next((i for i, x in enumerate(one) if x), None)
        if at is not None:
            target, *vectors = [reduced(v, one, at) for v in (target, *vectors)]
    return not any(target)


def reduced(vector: list[Fraction], one: list[Fraction], at: int) -> list[Fraction]:
    factor = vector[at] / one[at]
    return [x - factor * y for x, y in zip(vector, one, strict=True)] if factor else vector


def hashed(poly: BracketPolynomial) -> bool:
    """The same by the complete search modulo a prime, without symmetries."""
    monomials = Monomials.of(poly, 10_000)
    at = random_positions(14, len(poly.points), 4, MODULUS, seed=0)
    identity = np.arange(len(poly.points))[None, :]
    value, target = monomials.values(at), values(poly, at, MODULUS)
    work = Count(10**12, "the search handles", "residues")
    return any(True for _ in combinations_of(2, value, target, Action(monomials), identity, work))


def test_two_terms(ratio: Callable[..., Any]) -> None:
    """All pairs of 107 monomials, of which none will do."""
    poly = superbracket("4-4.5")
    ratio(
        lambda: hashed(poly),
        {"all pairs, exact elimination": lambda: all_pairs(poly)},
        agree=lambda a, b: a == b,
        at_least={"all pairs, exact elimination": 10},
        rounds=3,
        others_rounds=1,
    )


def test_all_classes(ratio: Callable[..., Any]) -> None:
    """The shortest form of each of the 34 classes, proved minimal."""
    texts = [f"[[{', '.join(c['legs'])}]]" for c in REGULAR]

    def every() -> int:
        found = [shorten(parse(text)) for text in texts]
        assert all(f.minimal for f in found)
        return sum(f.terms for f in found)

    ratio(every, {}, within=5, rounds=2)


def test_the_general_platform_from_its_normal_form(ratio: Callable[..., Any]) -> None:
    """From 214 terms to the 16 that are needed."""
    poly = superbracket("6-6")
    found = shorten(poly)
    at = random_points(poly.points, seed=1)
    one, other = (Evaluator(at, 4, PRIME).value(p.to_expr()) for p in (poly, found.polynomial))
    assert one == other
    ratio(lambda: shorten(poly), {}, within=5, rounds=2)
