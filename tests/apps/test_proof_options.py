"""--certificate, --coq and --lean: the files that they write, and what is said where there is nothing to write."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from commands import invoke
from places import ROOT

import gcrules as gc


@pytest.mark.parametrize(
    ("command", "theorems"),
    [
        (["prove", r"ab /\ cd == [abcd]"], 1),
        (["analyze", "ab af cb cd ed ef"], 2),
        (["analyze", "3-rps"], 1),
        (["robot", "analyze", "3-rps"], 1),
        (["factor", "[abfc][acde][bdef] + [abfd][acbe][cdef]"], 1),
        (["shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3"], 1),
        (["transversals", "Aa Ab Bc Cd De Ef"], 1),
    ],
)
def test_the_proofs_of_an_answer_are_written(command: list[str], theorems: int, tmp_path: Path) -> None:
    names = {"--certificate": "proof.json", "--coq": "proof.v", "--lean": "proof.lean"}
    done = invoke(*[*command, *(word for option, name in names.items() for word in (option, str(tmp_path / name)))])
    assert done.exit_code == 0, done
    data = json.loads((tmp_path / "proof.json").read_text(encoding="utf-8"))
    assert len(data["theorems"]) == theorems
    assert (tmp_path / "proof.v").read_text(encoding="utf-8").count("\nPrint Assumptions ") == theorems
    assert (tmp_path / "proof.lean").read_text(encoding="utf-8").count("\ntheorem ") == theorems
    assert f"{theorems} theorem{'s' * (theorems > 1)}, digest {data['digest'][:12]}" in done.stderr


def test_claims_and_rules_of_scripts_are_theorems(tmp_path: Path) -> None:
    script, file = tmp_path / "some.gca", tmp_path / "proof.json"
    rules = (ROOT / "plugins" / "plucker" / "plucker.gca").read_text(encoding="utf-8")
    script.write_text(f"claim [abcd] == [bcda] * -1 show [abcd] {rules}", encoding="utf-8")
    done = invoke("run", str(script), "--certificate", str(file))
    assert done.exit_code == 0, done.output
    names = [t["name"] for t in json.loads(file.read_text(encoding="utf-8"))["theorems"]]
    assert names[0].startswith("line 1: ")
    assert any("rule exchange in rank 5" in name for name in names)


def test_what_is_refuted_has_no_file(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("prove", "[abcd] == [abdc]", "--certificate", str(file))
    assert done.exit_code == 1
    assert "is not written, since the answer is refuted" in done.stderr
    assert not file.exists()


def test_where_nothing_can_be_written_it_is_said_and_nothing_appears(tmp_path: Path) -> None:
    file = tmp_path / "proof.v"
    done = invoke("prove", "[abcde] == [bcdea]", "--rank", "5", "--coq", str(file))
    assert done.exit_code == 2
    assert "no theorem can be written for Coq: claim: it is in rank 5" in " ".join(done.stderr.split())
    assert not file.exists()


def test_what_is_left_out_is_named(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3", "--certificate", str(file))
    (one,) = json.loads(file.read_text(encoding="utf-8"))["left_out"]
    assert one["name"] == "that at least 1 term is needed"
    assert f"note: without a proof in the file: {one['name']}: {one['reason']}" in " ".join(done.stderr.split())


def test_other_values_have_no_proofs() -> None:
    with pytest.raises(gc.InputError, match="no proofs can be written of a str"):
        gc.proof_file("[abcd] == 0")
