"""Growth with the points: normal forms beside Macaulay2 and other methods, and factorization; sympy's determinant."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from math import inf
from typing import Any

import pytest
from measurement import Over
from products import PLANTED, products
from scale import FORMS, by_gcrules, by_macaulay2, macaulay2

from gcrules.algebra.bracket import BracketPolynomial, Terms
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expand import expand
from gcrules.algebra.factoring.factorize import factor
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.straightening import diagonal
from gcrules.algebra.straightening import straighten as module
from gcrules.algebra.straightening.straighten import straighten, straighten_terms
from gcrules.algebra.straightening.work import Work
from gcrules.rules.catalog.file import load
from gcrules.rules.condition import Condition

SIZES = [(3, 6), (3, 9), (3, 12), (3, 15), (4, 8), (4, 9), (4, 10), (4, 12), (4, 14), (4, 16)]
PEER = {3: 11, 4: 10}  # rank: the most points for which Macaulay2 needs seconds only


@pytest.mark.parametrize(("rank", "points"), SIZES)
def test_normal_forms(timed: Callable[..., Any], rank: int, points: int) -> None:
    """Twenty random products that hold all points, in fresh processes, which time themselves (processor time)."""
    monomials = products(rank, points, FORMS)
    ours, forms = min((by_gcrules(monomials) for _ in range(3)), key=lambda found: found[0])
    others: dict[str, float | None] = {}
    if points <= PEER[rank]:
        basis = at_hand = None
        if macaulay2() is not None:
            found = by_macaulay2(rank, monomials)
            assert found is not None
            assert found[2] == forms
            basis, at_hand = found[0] + found[1], found[1]
        others = {"Macaulay2, its Gröbner basis included": basis, "Macaulay2, the basis at hand": at_hand}
    at_least = {name: 1.0 for name in others if "included" in name}
    timed(ours, others, within=2, at_least=at_least)


@pytest.mark.parametrize(("rank", "points", "number"), [(3, 15, 1), (4, 12, 20), (4, 16, 1), (4, 16, 100)])
def test_methods(ratio: Callable[..., Any], rank: int, points: int, number: int) -> None:
    """A sum of products whose points are all different: arrays, one monomial at a time, the triangular system."""
    terms: Terms = dict.fromkeys(products(rank, points, number), 1)
    poly = BracketPolynomial(rank, tuple(f"p{i}" for i in range(points)), terms)
    others = {
        "one monomial at a time": lambda: module._largest_first(dict(terms), 0, Work(10**6), inf),
        "triangular system": lambda: dict(diagonal.normal_form(poly).terms),
    }

    def alike(a: Terms, b: Terms) -> bool:
        return {m: c for m, c in a.items() if c} == {m: c for m, c in b.items() if c}

    ratio(lambda: straighten_terms(terms), others, agree=alike, within=2, rounds=3, others_rounds=1)


def test_the_proof_of_6_5(ratio: Callable[..., Any]) -> None:
    """One incidence with its cofactor: 86 terms of seven brackets that add up to zero, in two orders of the points."""
    entry = load()["6-5"]
    (reading,) = (r for r in entry.readings if r.kind == "one-incidence")
    superbracket = entry.structure.superbracket
    claim = Certificate("none", "to be proved")
    condition = Condition(
        reading.kind, reading.expression, reading.meaning, claim, reading.cofactor, reading.coefficient
    )
    poly = expand(condition.identity(superbracket))
    assert isinstance(poly, BracketPolynomial)
    ratio(
        lambda: module.is_zero(poly),
        {"in the order of the names": lambda: not straighten(poly)},
        agree=lambda a, b: a is b is True,
        within=0.3,
        rounds=3,
        others_rounds=1,
    )


@pytest.mark.parametrize(("rank", "expression"), PLANTED)
def test_factor(ratio: Callable[..., Any], rank: int, expression: str) -> None:
    """6 to 16 points: an expression is found again from its normal form."""
    poly = straighten(parse(expression, rank=rank))
    assert isinstance(poly, BracketPolynomial)
    assert factor(poly).exists
    ratio(lambda: factor(poly).exists, {}, within=1, rounds=3)


OCTAHEDRON = "ab af cb cd ed ef"
FRAMES = {"any points": "", "the base in a frame": "a1=a2=a3=c2=c3=e3=0"}
STOP = 60  # seconds that sympy gets for the determinant, multiplied out, and factored

SYMPY = """
import json, sys, time
import sympy
legs, zero = sys.argv[1].split(), sys.argv[2].split("=")
points = {n: [0 if f"{n}{i}" in zero else sympy.Symbol(f"{n}{i}") for i in (1, 2, 3)] + [1] for n in "abcdef"}
rows = [[a[i] * b[j] - a[j] * b[i] for i in range(4) for j in range(i + 1, 4)]
        for a, b in ((points[p], points[q]) for p, q in legs)]
start = time.perf_counter()
value = sympy.Matrix(rows).det(method="berkowitz")
print("determinant", time.perf_counter() - start, flush=True)
value = sympy.expand(value)
print("multiplied out", time.perf_counter() - start, flush=True)
sympy.factor(value)
print("factored", time.perf_counter() - start, flush=True)
"""


def by_sympy(frame: str) -> dict[str, float]:
    """Seconds until each stage was reached; those that were not are over the limit."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", SYMPY, OCTAHEDRON, frame], capture_output=True, text=True, timeout=STOP, check=True
        )
        lines = done.stdout
    except subprocess.TimeoutExpired as stopped:
        lines = (stopped.stdout or b"").decode()
    reached = dict(line.rsplit(" ", 1) for line in lines.splitlines())
    stages = ("determinant", "multiplied out", "factored")
    return {f"sympy, {stage}": float(reached[stage]) if stage in reached else Over(STOP) for stage in stages}


ANALYZE = """
import sys, time
from gcrules.mechanisms.platform_analysis import analyze
start = time.perf_counter()
analyze(sys.argv[1])
print(time.perf_counter() - start)
"""


@pytest.mark.parametrize("frame", FRAMES.values(), ids=FRAMES)
def test_the_octahedral_platform(timed: Callable[..., Any], frame: str) -> None:
    """The condition of the octahedral platform, in fresh processes: `analyze` beside sympy in coordinates."""
    done = subprocess.run([sys.executable, "-c", ANALYZE, OCTAHEDRON], capture_output=True, text=True, check=True)
    timed(float(done.stdout), by_sympy(frame), within=1, at_least={"sympy, factored": 5})
