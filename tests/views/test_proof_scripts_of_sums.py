"""Scripts of Coq for sums of multiples of what is given."""

from __future__ import annotations

from pathlib import Path

import pytest
from views.test_proof_scripts import coq_script, refused_otherwise, replayed, statement

import gcrules as gc
from gcrules.algebra.proofs.theorem import Theorem

CEVA = "incident(d, bc), incident(e, ca), incident(f, ab), [abd][bce][caf] == [adc][bea][cfb]"


def sums() -> list[Theorem]:
    """With no, one and two things that do not vanish, each closed by points of its own."""
    claims = [
        ("[acd] == 0", "[abd] == [abc], [abd] == 2 [abc]", {"rank": 3}),
        (r"ad /\ be /\ cf == 0", CEVA, {"rank": 3}),
        (r"S \/ ad == 0", r"S \/ ab == 0, incident(d, a \/ (S /\ abc))", {"letters": "screw S"}),
        ("coplanar(a, b, c, d)", r"incident(c, S /\ abd)", {"letters": "screw S"}),
    ]
    files = [gc.proof_file(gc.prove(claim, given=given, **more)) for claim, given, more in claims]
    return [t for file in files for t in file.theorems]


def test_what_does_not_vanish_is_a_hypothesis_and_further_points_are_not() -> None:
    script = coq_script(sums()[:1], "Sums")
    said = statement(script, "claim")
    assert said.split("\n")[0] == "forall a b c d : vector plane,"
    assert "  (a ∨ b) <> number plane 0 ->" in said.split("\n")
    assert "y1" not in said


def test_fractions_have_no_script() -> None:
    found = gc.proof_file(gc.prove("a == c", rank=3, given="a + b == c + d, 2 a - (b + c) == c - d"))
    with pytest.raises(gc.InputError, match="sum of multiples of what is given, with fractions"):
        found.coq()


@pytest.mark.needs("coqc")
def test_coq_replays_sums_of_multiples(tmp_path: Path) -> None:
    replayed(sums(), "Sums", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        ("(a ∨ b) <> number plane 0 ->", "(a ∨ c) <> number plane 0 ->"),
        ("(number plane (-2))", "(number plane (-1))"),
        ("  (bracket (a ∨ c ∨ d))\n", "  (bracket (a ∨ c ∨ b ∨ d))\n"),
    ],
    ids=["what may vanish is another", "another assumption", "another claim"],
)
def test_coq_refuses_another_sum(said: str, instead: str, tmp_path: Path) -> None:
    refused_otherwise(sums()[:1], "Sums", "Theorem claim :", said, instead, tmp_path)
