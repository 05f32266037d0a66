"""Claims that are sums of multiples of what is given, and the identities that proof files then state."""

from __future__ import annotations

import random
from collections.abc import Iterable
from fractions import Fraction

import pytest
from hypothesis import given as drawn
from hypothesis import settings
from hypothesis import strategies as st
from places import EXAMPLES

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import ZERO, Bracket, Expr, Number, Point, Sum, add, mul, sub
from gcrules.algebra.language.statements import parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.language.text import text
from gcrules.algebra.proofs.combination import by_multiples
from gcrules.algebra.proofs.multiples import multipliers
from gcrules.algebra.proofs.theorem import Theorem, has_part
from gcrules.algebra.prove import difference_of
from gcrules.mechanisms.proofs import proof_file
from gcrules.rules.script import ClaimResult, run_script

SIX = "[abc][ade][bdf][cef] - [abd][ace][bcf][def]"
THEOREMS = EXAMPLES / "theorems"


def claim(name: str) -> tuple[Expr, Expr, tuple[str, ...]]:
    """The difference of the sides of a claim, what is given, and the points at infinity."""
    source = (THEOREMS / f"{name}.gca").read_text(encoding="utf-8")
    (found,) = run_script(parse_script(source, name)).results
    assert isinstance(found, ClaimResult)
    assert found.proof is not None
    proof = found.proof
    return difference_of(proof.left, proof.right, 3), proof.given[0].args[0], proof.ideal


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("pencils", "1"),
        ("thales", "4 [ija][ija][ijb][ijb][ijc][abc]"),
        ("steiner", "[abe][bce][def][def] + [ace][bde][bef][def] - [ade][bde][bef][cef]"),
    ],
)
def test_what_is_given_divides_a_claim(name: str, says: str) -> None:
    """The oracle compares both sides, and sees where the factor is another one."""
    difference, given, ideal = claim(name)
    (found,) = multipliers(difference, [given], 3, ideal) or ()
    assert text(found) == text(parse(says, rank=3))
    assert vanishes(sub(difference, mul(found, given), rank=3), rank=3, ideal=ideal)
    assert not vanishes(sub(difference, mul(Number(2), found, given), rank=3), rank=3, ideal=ideal)


@pytest.mark.parametrize("name", ["false/thales", "false/steiner"])
def test_of_false_claims_it_is_no_factor(name: str) -> None:
    difference, given, ideal = claim(name)
    assert multipliers(difference, [given], 3, ideal) is None


@pytest.mark.parametrize(
    ("e", "given"),
    [
        ("[abc]", SIX),
        ("[abc][abc][ade][def] - [abd][ace][bcf][def]", SIX),
        ("ab", "[abc]"),
        ("[abc] - [abd]", "[abc]"),
        ("[abc][def]", "[abg]"),
        ("[abc][abd] - [abd][abc]", "[abc]"),
    ],
    ids=["too small", "no multiple", "no scalar", "of no one degree", "other points", "zero"],
)
def test_other_expressions_have_no_multiplier(e: str, given: str) -> None:
    assert multipliers(parse(e, rank=3), [parse(given, rank=3)], 3) is None


def test_a_proof_file_states_the_identity_and_names_it() -> None:
    source = (THEOREMS / "pencils.gca").read_text(encoding="utf-8")
    (found,) = proof_file(run_script(parse_script(source))).theorems
    assert found.name == "line 5: equal cross ratios, up to a multiple of what is given"
    assert not found.given
    left, right = parse_equation(f"[eab][ecd][fac][fbd] == [eac][ebd][fab][fcd] + ({SIX})", rank=3)
    assert (found.left, found.right) == (left, right)


# --- several things that are given together --------------------------------------------------------------------------

TOGETHER = {
    "scalars": ("[acd] == 0", ("[abd] == [abc]", "[abd] == 2 [abc]"), ("ab",), 3),
    "points": ("a == c", ("a + b == c + d", "2 a - (b + c) == c - d"), (), 3),
    "a square": ("[abc] == 0", ("[abc]**2 == [abd][abe]", "[abd] == 0"), (), 3),
    "a line": ("ab == 0", ("[abc] == 0", "[abd] == 0"), ("[cde]", "cd"), 3),
    "a pole": ("[abcd] == 0", (r"c \/ (S /\ abd) == 0",), (r"S /\ abd",), 4),
}


def together(claim: str, given: Iterable[str], nonzero: Iterable[str], rank: int) -> Theorem | None:
    at = parse_letters("screw S", Context(rank=4)) if rank == 4 else Context(rank=rank)
    zero = [difference_of(*parse_equation(e, context=at), rank) for e in given]
    return by_multiples(
        "claim", *parse_equation(claim, context=at), zero, [parse(e, context=at) for e in nonzero], rank
    )


@pytest.mark.parametrize("name", ["scalars", "points", "a square", "a pole"])
def test_what_follows_from_several_equations(name: str) -> None:
    """The oracle sees the identity, and that each of its terms has a part that is given."""
    claim, given, nonzero, rank = TOGETHER[name]
    found = together(claim, given, nonzero, rank)
    assert found is not None
    (lemma,) = found.cases
    assert vanishes(difference_of(lemma.left, lemma.right, rank), rank=rank)
    assert not vanishes(lemma.right, rank=rank)
    assert all(has_part(t, found.given) for t in (lemma.left.terms if isinstance(lemma.left, Sum) else [lemma.left]))


def test_where_something_may_vanish_nothing_follows() -> None:
    claim, given, _, rank = TOGETHER["scalars"]
    assert together(claim, given, (), rank) is None
    assert together(*TOGETHER["a line"]) is None, "the line cd may meet ab in any point"


@settings(max_examples=40)
@drawn(st.randoms(use_true_random=False), st.integers(2, 4))
def test_multipliers_of_sums_of_products(rng: random.Random, rank: int) -> None:
    """What was made of multiples is found again, and what was not is not, as random points tell."""
    names = "abcdef"[: rank + 2]

    def brackets(count: int) -> Expr:
        some = (Bracket(tuple(map(Point, rng.sample(names, rank)))) for _ in range(count))
        return mul(Number(rng.choice((1, -1, 2, Fraction(1, 2)))), *some)

    given = [add(brackets(1), brackets(1), rank=rank) for _ in range(rng.randint(1, 3))]
    given = [g for g in given if g != ZERO]
    e = add(*(mul(brackets(rng.randint(0, 1)), g) for g in given), rank=rank) if given else ZERO
    found = multipliers(e, given, rank) if given else None
    if found is None:
        assert not given or vanishes(e, rank=rank)
        return
    assert vanishes(sub(e, add(*map(mul, found, given), rank=rank), rank=rank), rank=rank)
    other = add(e, brackets(2), rank=rank)
    again = multipliers(other, given, rank)
    assert again is None or vanishes(sub(other, add(*map(mul, again, given), rank=rank), rank=rank), rank=rank)
