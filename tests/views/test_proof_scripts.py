"""Theorems as scripts of Coq and Lean; Coq replays them where it is there."""

import re
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from gcrules.algebra.language.syntax import parse_equation
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.theorem import Theorem, theorem
from gcrules.core.errors import InputError
from gcrules.views.proofs import coq, lean

OCTAHEDRON = r"[[ab,af,cb,cd,ed,ef]] == (ace /\ abf /\ cbd /\ edf)"


def coq_script(theorems: Sequence[Theorem], title: str) -> str:
    return coq.script(ProofFile(title, tuple(theorems)))


def proved(name: str, equation: str, rank: int = 4, ideal: tuple[str, ...] = ()) -> Theorem:
    return theorem(name, *parse_equation(equation, rank=rank), rank=rank, ideal=ideal)


def theorems() -> list[Theorem]:
    return [
        proved("octahedral", OCTAHEDRON),
        proved("a line in a plane", r"ab /\ cde == [acde] * b - [bcde] * a"),
        proved("with halves", r"(1/2) * [abc] * [ade] == (1/2) * [abd] * [ace] - (1/2) * [abe] * [acd]", rank=3),
        proved("at infinity", r"ij /\ kab == [ikab] * j - [jkab] * i", ideal=("i", "j")),
    ]


def statement(script: str, name: str) -> str:
    return re.search(rf"Theorem {name} : (.*?)Proof\.", script, re.DOTALL)[1]


def run(script: str, folder: Path) -> subprocess.CompletedProcess[str]:
    file = folder / "theorems.v"
    file.write_text(script, encoding="utf-8")
    return subprocess.run(["coqc", file.name], cwd=folder, capture_output=True, text=True, check=False)


def test_statements_are_read_as_they_were_written() -> None:
    script = coq_script(theorems(), "Four theorems")
    assert script.startswith("(* Four theorems *)")
    assert "superbracket (a ∨ b) (a ∨ f) (c ∨ b) (c ∨ d) (e ∨ d) (e ∨ f)" in statement(script, "octahedral")
    assert "infinite space i ->\n  infinite space j ->" in statement(script, "at_infinity")
    assert "multiplied by 2" in script
    assert "/" not in statement(script, "with_halves")
    assert "Axiom" not in script
    assert "Admitted" not in script


def test_names_that_coq_cannot_have_are_others() -> None:
    script = coq_script([proved("forall", "[abcd] == [cdab]"), proved("forall", "[abcd] == [cdab]")], "(* x *)")
    assert "Theorem forall_2 :" in script
    assert "Theorem forall_3 :" in script
    assert script.startswith("(* ( * x * ) *)")


def test_other_ranks_are_refused() -> None:
    with pytest.raises(InputError, match="rank 2"):
        coq_script([proved("on a line", "[ab] * [cd] - [ac] * [bd] + [ad] * [bc] == 0", rank=2)], "On a line")


def test_lean_has_the_relations_as_hypotheses() -> None:
    exchange = proved("exchange", "[abc] * [ade] - [abd] * [ace] + [abe] * [acd] == 0", rank=3)
    text = lean.script(ProofFile("Exchange", (exchange,)))
    assert "not checked" in text
    assert "linear_combination" in text
    assert text.count("theorem ") == 1


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_without_axioms(tmp_path: Path) -> None:
    done = run(coq_script(theorems(), "Four theorems"), tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("Closed under the global context") == 4


@pytest.mark.needs("coqc")
def test_coq_refuses_a_claim_with_another_sign(tmp_path: Path) -> None:
    script = coq_script([proved("octahedral", OCTAHEDRON)], "Octahedron")
    sides = re.search(r"Definition octahedral_right := (.*)\.\n", script)[1]
    wrong = script.replace(sides, f"(Join (Number (-1)) {sides})").replace("\n  = ((", "\n  = ((number space (-1)) · (")
    done = run(wrong, tmp_path)
    assert done.returncode != 0
    assert "theorems.v" in done.stderr
    assert "Closed" not in done.stdout
