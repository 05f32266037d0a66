"""Claims that are sums of multiples of what is given, and the identities that proof files then state."""

from __future__ import annotations

import pytest
from places import EXAMPLES

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Expr, Number, mul, sub
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse, parse_equation
from gcrules.algebra.language.text import text
from gcrules.algebra.proofs.multiples import multipliers
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
