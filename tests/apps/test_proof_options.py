"""--certificate, --coq and --lean: the files that they write, and what is said where there is nothing to write."""

from __future__ import annotations

import json
import subprocess
import sys
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
    assert f"{theorems} theorem{'s' * (theorems > 1)}, digest {data['digest'][:16]}" in done.stderr


def test_latex_names_the_digest_of_the_proofs(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("prove", r"ab /\ cd == [abcd]", "--latex", "--certificate", str(file))
    digest = json.loads(file.read_text(encoding="utf-8"))["digest"]
    assert done.stdout.splitlines()[-1] == f"% proofs that a program checks: SHA-256 digest {digest}"
    assert "SHA-256" not in invoke("prove", r"ab /\ cd == [abcd]", "--latex").stdout


def test_claims_and_rules_of_scripts_are_theorems(tmp_path: Path) -> None:
    script, file = tmp_path / "some.gca", tmp_path / "proof.json"
    rules = (ROOT / "plugins" / "plucker" / "plucker.gca").read_text(encoding="utf-8")
    script.write_text(f"claim [abcd] == [bcda] * -1 show [abcd] {rules}", encoding="utf-8")
    done = invoke("run", str(script), "--certificate", str(file))
    assert done.exit_code == 0, done.output
    names = [t["name"] for t in json.loads(file.read_text(encoding="utf-8"))["theorems"]]
    assert names[0].startswith("line 1: ")
    assert any("rule exchange in rank 5" in name for name in names)


def test_claims_of_several_scripts_are_named_by_their_files(tmp_path: Path) -> None:
    files = [tmp_path / name for name in ("one.gca", "two.gca")]
    for file in files:
        file.write_text("claim [abcd] == [bcda] * -1", encoding="utf-8")
    proofs, script = tmp_path / "proof.json", tmp_path / "proof.v"
    done = invoke("run", *map(str, files), "--certificate", str(proofs), "--coq", str(script))
    assert done.exit_code == 0, done.output
    written = json.loads(proofs.read_text(encoding="utf-8"))
    assert written["title"] == "2 scripts"
    assert [t["name"].partition(", line 1: ")[0] for t in written["theorems"]] == [str(file) for file in files]
    assert script.read_text(encoding="utf-8").count("\nPrint Assumptions ") == 2


def test_what_is_refuted_has_no_file(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("prove", "[abcd] == [abdc]", "--certificate", str(file))
    assert done.exit_code == 1
    assert "is not written, since the answer is refuted" in done.stderr
    assert not file.exists()


def test_where_nothing_can_be_written_it_is_said_and_nothing_appears(tmp_path: Path) -> None:
    file = tmp_path / "proof.v"
    assumed = ["--given", "collinear(a, b, c)"]
    done = invoke("prove", "[abcde] == 0", "--rank", "5", *assumed, "--coq", str(file))
    assert done.exit_code == 2
    said = " ".join(done.stderr.split())
    assert "no theorem can be written for Coq: claim: it holds under assumptions in rank 5" in said
    assert not file.exists()


def test_what_is_left_out_is_named(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("factor", "[[Aa, Ab, Bc, Bd, Ca, Dc]]", "--cofactor", "--certificate", str(file))
    (one,) = json.loads(file.read_text(encoding="utf-8"))["left_out"]
    assert one["name"].startswith("that there is no expression with the cofactor [ABCD]")
    assert f"note: without a proof in the file: {one['name']}: {one['reason']}" in " ".join(done.stderr.split())


def test_what_is_not_there_is_stated_in_the_file(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3", "--certificate", str(file))
    (one,) = json.loads(file.read_text(encoding="utf-8"))["absences"]
    assert one["claim"] == "at least 1 term is needed"
    said = " ".join(done.stderr.split())
    assert "states what was enumerated: that at least 1 term is needed" in said
    assert f"python checkers/recompute.py {file} computes this again without gcrules" in said


def test_what_is_not_there_is_told_where_the_file_states_it(tmp_path: Path) -> None:
    done = invoke("shorten", "[abcd][abef]", "--coq", str(tmp_path / "proof.v"))
    assert "recompute" not in done.stderr


def test_other_values_have_no_proofs() -> None:
    with pytest.raises(gc.InputError, match="no proofs can be written of a str"):
        gc.proof_file("[abcd] == 0")


def test_the_checkers_are_written_and_check(tmp_path: Path) -> None:
    file, folder = tmp_path / "proof.json", tmp_path / "new" / "checkers"
    done = invoke("checkers", str(folder))
    assert done.exit_code == 0, done.output
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == {
        path.name: path.read_bytes() for path in (ROOT / "checkers").iterdir() if path.is_file()
    }
    invoke("shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3", "--certificate", str(file))
    for program in ("check_proof.py", "recompute.py"):
        command = [sys.executable, str(folder / program), str(file)]
        assert subprocess.run(command, cwd=tmp_path, capture_output=True, check=False).returncode == 0


def test_no_checkers_are_written_into_a_file(tmp_path: Path) -> None:
    (tmp_path / "checkers").write_text("", encoding="utf-8")
    done = invoke("checkers", str(tmp_path / "checkers"))
    assert done.exit_code == 2
    assert "cannot be made" in done.output
