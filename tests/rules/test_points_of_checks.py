"""Nobody can foresee the points of checks, and how sure they make an answer is said."""

from __future__ import annotations

import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from commands import invoke
from hypothesis import given
from hypothesis import strategies as st
from rules.attacks import ATTACKS, EACH_ATTACK, LEGS, MERSENNE, guessed

import gcrules as gc
from gcrules.algebra import claims
from gcrules.algebra.assumptions.assumed import resolve
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.evaluate import PRIME, evaluate, random_points, vanishes
from gcrules.algebra.expr import Expr, sub
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.prove import prove
from gcrules.conditions.manual.automatic import automatic
from gcrules.core import seeds
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.step import Step

# --- points and primes ---------------------------------------------------------------------------------------------


def test_the_attacks_are_false_and_would_have_passed() -> None:
    """At the points that were the same in every run, and modulo the prime that was."""
    s = read_legs(LEGS)
    for what, expression in ATTACKS.items():
        assert prove(s.superbracket, expression).verdict == "refuted"
        if what in ("first", "two-points", "one-multiple", "two-multiples"):
            for points in guessed(s.names, (1, 2)):
                assert evaluate(sub(s.superbracket, expression), points, modulus=MERSENNE) == 0


@EACH_ATTACK
def test_no_check_takes_a_false_identity_for_true(false: Expr) -> None:
    s = read_legs(LEGS)
    difference = sub(s.superbracket, false)
    assert not vanishes(difference)
    assert not s.construction.vanishes(difference)
    assert not RandomWitness(s).zero(difference)
    assert RandomWitness(s).coefficient(false) is None
    assert not Step("a rule", s.superbracket, false, "because").check()
    assert not prove(s.superbracket, false).proved
    assert invoke("prove", f"{s.superbracket} == {false}").exit_code == 1


SCRIPT = """
import gcrules.core.seeds as s
from gcrules.algebra.evaluate import PRIME, random_points
from gcrules.algebra.language.legs_text import read_legs
from gcrules.screws import RESIDUES
print(PRIME, s.seed("claim"), random_points("ab", seed=1), read_legs("ab bc ca de fg hi").construction.random_points(1))
"""


def test_nobody_can_foresee_points_and_prime(root: Path) -> None:
    found = {
        subprocess.run([sys.executable, "-c", SCRIPT], cwd=root, capture_output=True, text=True, check=True).stdout
        for _ in range(3)
    }
    columns = [set(words) for words in zip(*(line.split() for line in found), strict=True)]
    assert len(found) == 3
    assert min(map(len, columns[:2])) == 3


def test_the_prime() -> None:
    assert 2**60 < PRIME < 2**61
    assert PRIME % 4 == 3
    assert all(pow(a, PRIME - 1, PRIME) == 1 for a in (2, 3, 5, 7, 1234567))
    drawn = {seeds._fresh_prime() for _ in range(20)}
    assert len(drawn) == 20
    sympy = pytest.importorskip("sympy")
    assert all(sympy.isprime(p) for p in drawn)
    assert [n for n in range(3, 300, 2) if seeds._is_prime(n)] == list(sympy.primerange(3, 300))


def test_points_depend_on_the_claim_and_on_the_seed() -> None:
    assert seeds.seed("a", "b") != seeds.seed("ab") != seeds.seed("a")
    assert random_points("ab", seed=1) == random_points("ab", seed=1) != random_points("ab", seed=2)
    with gc.seeded(7):
        first = random_points("ab", seed=1)
        with gc.seeded(8):
            assert random_points("ab", seed=1) != first
    with gc.seeded(7):
        assert random_points("ab", seed=1) == first
    assert random_points("ab", seed=1) != first
    assert seeds.remark() == ""
    for wrong in (None, "7", 7.0, True):
        with pytest.raises(InputError, match="`seed` must be a whole number"):
            gc.seeded(wrong)


def test_what_was_found_with_a_seed_is_no_answer_for_those_who_chose_none() -> None:
    """Answers about a robot are kept; each goes with the seed it was found with."""
    robot, structure = gc.load("4-upu"), read_legs(LEGS)
    with gc.seeded(7):
        assert "seed 7" in gc.analyze(robot).text()
        assert automatic(structure).notes
    assert "seed" not in gc.analyze(robot).text()
    assert not automatic(structure).notes
    assert analyze_robot(robot) is analyze_robot(robot)
    with gc.seeded(7):
        assert "seed 7" in gc.analyze(robot).text()


# --- the bound -----------------------------------------------------------------------------------------------------


@given(st.integers(0, 10**6), st.integers(0, 59), st.integers(1, 4))
def test_the_bound_is_that_of_schwartz_and_zippel(degree: int, bits: int, samples: int) -> None:
    assert seeds.bound(degree, bits, samples) == pytest.approx(float(Fraction(degree, 2**60) ** samples))
    assert seeds.bound(degree, bits + 60, samples) >= 1e-16


def test_the_bound_in_words() -> None:
    assert seeds.error_below(0, 0, 2) == "error below 1e-299"
    assert seeds.error_below(2**61, 0, 2) == "error below 1"
    assert seeds.error_below(12, 600, 3) == "error below 1e-14"  # ten primes may divide all coefficients
    with gc.seeded(5):
        assert "points chosen with the seed 5" in seeds.error_below(12, 0, 2)


SIZES = ["[abcd]", "ab /\\ cde", "3 [abcd]**4 - 7/5 [abce]", "[[ab, cd, ef, gh, ij, kl]]", "(ab /\\ cde) \\/ f \\/ gh"]


@pytest.mark.parametrize("text", SIZES)
def test_sizes_are_not_too_small(text: str) -> None:
    """The degree is that along a line, and no coefficient there is larger than the size says."""
    sympy = pytest.importorskip("sympy")
    e = gc.parse(text)
    e = e if not e.step else gc.parse(f"[({text}) x y z]" if e.step == 1 else f"[{text}]")
    names = sorted({p for p in text if p.islower()} | set("xyz"))
    t = sympy.Symbol("t")
    at = {n: tuple(sympy.Integer((7 * i + 3 * k) % 3 - 1) * t for k in range(4)) for i, n in enumerate(names)}
    value = sympy.Poly(evaluate(e, at), t)
    found = claims.size(e)
    assert value.is_zero or value.degree() <= found.degree
    assert max((abs(c) for c in value.coeffs()), default=0) <= 2**found.bits


DOTTED = ["[.a b][c .d]", "[.a b][.c d][e .f]", "[.a b][.c d][.e f][.g h]", "[.x y][.z w][.p q][.r s][.t u]"]


@pytest.mark.parametrize("one", DOTTED)
@pytest.mark.parametrize("other", DOTTED)
def test_sizes_of_what_is_written_out_on_the_way(one: str, other: str) -> None:
    """Dotted brackets stand for expressions that live only while they are looked at."""
    sizes = [claims.size(gc.parse(t, rank=2)) for t in (one, other)]
    for _ in range(5):
        assert claims.size(gc.parse(f"{one} * {other}", rank=2)).degree == sum(s.degree for s in sizes)
        assert claims.size(gc.parse(f"{one} + 2 {other}", rank=2)).degree == max(s.degree for s in sizes)


def test_denominators_of_constructed_points_count() -> None:
    """The point s (2^90 a + b) + t (c / 2^90 + d) is, without denominators, one with coefficients of 90 bits."""
    part = 2**90
    given = f"incident(p, ({part} a + b) \\/ (1/{part} c + d))"
    found = resolve(parse_assumption(given, Context(rank=3)))._sizes["p"]
    assert found.bits >= 90


def test_constructed_points_count_with_their_degree() -> None:
    s = read_legs(LEGS, given=["collinear(a, d, f)", "incident(h, abc)"])
    plain = read_legs(LEGS).construction
    assert isinstance(s.construction, Construction)
    sizes = s.construction._sizes
    assert sizes
    assert all(size.degree > 1 for size in sizes.values())
    assert s.construction.error_below(s.superbracket, 1) >= plain.error_below(s.superbracket, 1)
