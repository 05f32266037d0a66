"""The examples in the documents are true: commands print what stands there, Python answers what stands there.

`python tools/document_outputs.py` writes the output of every command and Python example into the documents.
"""

from __future__ import annotations

import doctest
import re
from pathlib import Path
from typing import Any

import pytest
from documents import BLOCKS, DOCUMENTS, Block, fenced, invoked, of, session
from places import ROOT

# Blocks that no test runs, by document and first line, with the reason.
NOT_RUN = {
    (
        "README.md",
        "make demo                                        # makes .venv, installs, writes the report of a platform",
    ): ("a target of make; the tests run both commands"),
    (
        "docs/boxes.md",
        "gcrules map refine range.zarr -o finer.zarr                      # four times as many boxes",
    ): ("tests/poses/test_boxes.py refines stores"),
    (
        "docs/boxes.md",
        'gcrules map boxes 6-rus --over "x -0.4:0.4" --over "y -0.4:0.4" --over "z -0.4:0.4" \\',
    ): ("it takes a quarter of an hour"),
    ("docs/paper.md", "gcrules paper examples/octahedral.yaml -o paper"): ("tests/views/test_paper.py writes papers"),
    ("docs/certify.md", "gcrules checkers"): ("tests/project/test_check_certificate.py checks certificates"),
    ("docs/proofs.md", 'gcrules analyze "ab af cb cd ed ef" --certificate octahedral.json'): (
        "tests/project/test_check_proof.py checks proofs"
    ),
    (
        "docs/proofs.md",
        "proved, called 'condition: four-planes' in the file:",
    ): ("tests/project/test_check_proof.py reads what it prints"),
    (
        "docs/proofs.md",
        'gcrules shorten "[[Aa, Bb, Cc, Dd, Ee, Ff]]" --certificate shortest.json',
    ): "tests/project/test_recompute.py recomputes absences",
    (
        "docs/proofs.md",
        "recomputed, called 'at least 16 terms are needed' in the file, of the right side of 'shortest form':",
    ): "tests/project/test_recompute.py reads what it prints",
    (
        "docs/proofs.md",
        'gcrules prove "[bde][bcd] == 0" --rank 3 --given "collinear(a, b, d), [bcd][abe] == [abd][bce]" '
        "--certificate kinds.json",
    ): "tests/project/test_check_proof.py checks proofs",
    (
        "docs/proofs.md",
        'gcrules prove "[acd] == 0" --rank 3 --given "[abd] == [abc], [abd] == 2 [abc]" --certificate together.json',
    ): "tests/project/test_check_proof.py checks proofs",
    ("docs/proofs.md", 'gcrules prove "[pab] == 0" --rank 3 --given "p == ab /\\ cd" --certificate meet.json'): (
        "tests/project/test_check_proof.py checks proofs"
    ),
    (
        "docs/proofs.md",
        'gcrules prove --letters "screw S" --given "S \\/ ab == 0" "collinear(a, b, S /\\ abc)" '
        "--certificate screw.json",
    ): "tests/project/test_check_proof.py checks proofs",
    ("docs/proofs.md", "proved, called 'claim' in the file:"): (
        "tests/project/test_check_proof.py reads what it prints"
    ),
    (
        "docs/proofs.md",
        "robots: 5-RPUR robot with three translations and two turns: there is no proof to write: condition:"
        " linear-complex: it holds by …",
    ): "make proofs, which takes minutes",
    (
        "docs/map.md",
        'gcrules map examples/octahedral.yaml --over "x -300:300:31" --over "z -500:100:41" --certificate cells.json',
    ): "tests/project/test_check_map.py checks maps",
    (
        "docs/map.md",
        'gcrules map 3-rps --over "roll -60:60:13 deg" --over "pitch -60:60:13 deg" --certificate cells.json',
    ): "tests/project/test_check_map_joints.py checks such maps",
    (
        "docs/map.md",
        'gcrules map 6-pus --over "q1 -0.2:0.2:9" --over "q2 -0.2:0.2:9" --certificate cells.json',
    ): "tests/project/test_check_map_actuators.py checks such maps",
    ("docs/map.md", "recomputed: 1,110 cells free, 90 crossed, undecided: none"): (
        "tests/project/test_check_map.py reads what it prints"
    ),
    (
        "docs/boxes.md",
        'gcrules map boxes 3-rpr --over "x -0.5:0.5" --over "yaw -60:80 deg" --limits "actuators -0.6..0.6" --tiles 2'
        " --boxes 63 --certificate boxes.json",
    ): "tests/project/test_check_boxes.py checks such maps",
    (
        "docs/boxes.md",
        "proved again: 40 boxes free, 1 boxes outside, 13 boxes crossed, undecided: 18 boxes, 5.2734% of the ranges",
    ): ("tests/project/test_check_boxes.py reads what it prints"),
    (
        "docs/free.md",
        'gcrules free examples/octahedral.yaml --over "rx, ry, rz" --ball --certificate region.json',
    ): "tests/project/test_check_free.py checks regions",
    ("docs/free.md", "proved: no pose of this ball is singular (1,108 boxes)"): (
        "tests/project/test_check_free.py reads what it prints"
    ),
    (
        "docs/plan.md",
        'gcrules plan examples/octahedral.yaml --from home --to "0 0 -490" --certificate plan.json',
    ): "tests/project/test_check_plan.py checks plans",
    (
        "docs/plan.md",
        "proved: every way from the start to the goal passes a singular pose, since the determinant of the legs is",
    ): "tests/project/test_check_plan.py reads what it prints",
    ("docs/map.md", 'gcrules map refine map.zarr -o wider.zarr --over "x -200:400"'): (
        "tests/poses/test_map_extended.py extends stores"
    ),
    (
        "docs/map.md",
        'gcrules map robot.yaml --over "x -200:200:2001" --over "y -200:200:2001" -o map.zarr --workers 8',
    ): ("it takes long; tests/poses/test_tiles.py and test_tile_kills.py run such maps"),
    ("docs/map.md", "#!/bin/sh"): "a job array; tests/poses/test_tile_kills.py computes parts",
    ("docs/rules.md", '[project.entry-points."gcrules.plugins"]'): "tests/outside is a package with such a table",
    ("docs/index.md", "make demo     # makes .venv, installs, analyses a platform and writes its report"): (
        "a target of make"
    ),
}


# --- nothing is left out --------------------------------------------------------------------------------------------

RUN = ("console", "python", "gca", "yaml")


@pytest.mark.parametrize("block", [b for b in BLOCKS if b.title], ids=lambda b: b.title)
def test_copies_of_files_are_true(block: Block) -> None:
    assert block.text == (ROOT / block.title).read_text(encoding="utf-8")


@pytest.mark.parametrize("block", [b for b in BLOCKS if b.language not in RUN], ids=lambda b: b.name)
def test_other_blocks_are_known(block: Block) -> None:
    assert (block.document, block.first) in NOT_RUN, (
        f"{block.name}: a block in {block.language!r} is tested by nothing; "
        f"write it in one of {', '.join(RUN)}, or give the reason in NOT_RUN"
    )


def test_the_table_of_other_blocks_is_up_to_date() -> None:
    assert set(NOT_RUN) == {(b.document, b.first) for b in BLOCKS if b.language not in RUN}


DURATION = re.compile(r"\b([0-9.,]+) ?(?:[mµn]?s|sec|seconds?|minutes?)\b")


@pytest.mark.parametrize("block", of("console") + of("python"), ids=lambda b: b.name)
def test_no_output_depends_on_the_speed_of_a_machine(block: Block) -> None:
    """Times differ from run to run: an output that is compared must not tell any but the limit that was asked for."""
    lines = block.text.splitlines()
    typed = [line for line in lines if line.startswith(("$ ", ">>> ", "... "))]
    asked = set(re.findall(r"\bseconds[= ]([0-9.]+)", "\n".join(typed)))
    told = ((line, DURATION.findall(line)) for line in lines if line not in typed)
    assert not [line for line, times in told if not asked.issuperset(times)]


def test_there_is_something_to_run() -> None:
    assert all(len(of(language)) > 1 for language in RUN)
    assert len(DOCUMENTS) > 10


# A block inside a list or a fence that is not closed would not be found, and so not be tested.
@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_fence_is_found(document: str) -> None:
    text = (ROOT / document).read_text(encoding="utf-8")
    assert len(re.findall(r"^[ \t>]*(?:```|~~~)", text, re.MULTILINE)) == 2 * len(fenced(document))


# --- console --------------------------------------------------------------------------------------------------------


COMMANDS = [(b.document, c, out) for b in of("console") for c, out in session(b.text)]


@pytest.mark.parametrize(("document", "command", "output"), COMMANDS, ids=[f"{d}: {c}" for d, c, _ in COMMANDS])
def test_command_prints_what_the_document_says(
    document: str, command: str, output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    assert invoked(command, tmp_path).rstrip("\n") == output.rstrip("\n")


@pytest.mark.parametrize("block", of("console"), ids=lambda b: b.name)
def test_console_blocks_have_commands(block: Block) -> None:
    assert block.text.startswith("$ ")


# --- Python: the blocks of a document are one session ---------------------------------------------------------------

SESSIONS = {d: [b for b in of("python") if b.document == d] for d in dict.fromkeys(b.document for b in of("python"))}


@pytest.mark.parametrize("document", SESSIONS)
def test_python_answers_what_the_document_says(document: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    names: dict[str, Any] = {}
    for block in SESSIONS[document]:
        test = doctest.DocTestParser().get_doctest(block.text, names, block.name, document, block.line)
        test.globs = names  # doctest copies what it is given
        runner = doctest.DocTestRunner()
        runner.run(test, clear_globs=False)
        assert runner.tries, block.name
        assert not runner.failures, block.name


# --- scripts and files ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("block", of("gca"), ids=lambda b: b.name)
def test_scripts_say_what_is_true(block: Block) -> None:
    from gcrules.algebra.language.statements import parse_script
    from gcrules.rules.script import run_script

    result = run_script(parse_script(block.text, block.name))
    assert result.results or "rule" in block.text.split()
    assert result.verdict == "proved", result.text()


@pytest.mark.parametrize("block", of("yaml"), ids=[f"{b.name}: {b.text.split(':')[0]}" for b in of("yaml")])
def test_files_are_what_the_document_says(block: Block, tmp_path: Path) -> None:
    import gcrules as gc
    from gcrules.conditions.catalog_check import check_entry
    from gcrules.rules.catalog.file import load_file

    path = tmp_path / "file.yaml"
    path.write_text(block.text, encoding="utf-8")
    if "limbs:" in block.text:
        assert gc.analyze(path).condition is not None
    elif "points:" in block.text:
        assert gc.analyze(path).pose is not None
    else:
        checked = [check_entry(e) for e in load_file(path).entries]
        assert checked
        assert all(c.ok for c in checked), checked
