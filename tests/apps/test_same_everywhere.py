"""An answer is the same text in every process: whatever the seed of Python's hashes is, and whenever it is asked."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = """
import contextlib, io, sys
from gcrules.apps.cli import cli
from gcrules.core.streams import prepare
prepare()
for words in {commands!r}:
    print("$", *words)
    with contextlib.suppress(SystemExit):
        cli([*words, "--json"], prog_name="gcrules")
"""
COMMANDS = (
    ["factor", "[abfc][acde][bdef] + [abfd][acbe][cdef]", "--full"],
    ["factor", "[[Aa,Ab,Bc,Bd,Ca,Dc]]", "--cofactor"],
    ["factor", "[[Aa,Ab,Bc,Bd,Ce,Cf]]", "--full"],
    ["factor", "[abd][ace] - [abe][acd]", "--rank", "3", "--full"],
    ["factor", "(ef /\\ bc /\\ da)([fbe][cga] + 2 [fbc][ega])", "--rank", "3"],
    ["shorten", "[[Aa,Ab,Bc,Bd,Ca,Dc]]"],
    ["shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3"],
    ["straighten", "[afgl][behk][cdij]", "--steps"],
    ["prove", "[abcd][abef] == [abce][abdf]"],
    ["prove", "[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c), collinear(a, b, d)"],
    ["discover", "{examples}/theorems/steiner.gca", "--exceptions", "0"],
    ["discover", "{examples}/figures/halves.gca"],
    ["transversals", "ab bc ca de fg hi", "--full"],
    ["analyze", "ab af cb cd ed ef", "--full"],
    ["analyze", "Aa Ab Bc Bd Ce Cf", "--given", "coplanar(A, B, a, b)"],
    ["analyze", "Aa Bb Cc ij jk ki", "--ideal", "i j k"],
    ["analyze", "3-rps"],
    ["rules", "list"],
    ["catalog", "list"],
    ["locus", "{examples}/platform-6-3.yaml", "--over", "translation"],
    ["pose", "{examples}/octahedral.yaml"],
    ["path", "{examples}/platform-6-3.yaml", "--at", "0 0 0", "--at", "0 0 -3"],
    ["run", "{examples}/plane.gca"],
)


@pytest.fixture(scope="module")
def answers(root: Path) -> list[list[str]]:
    """The answers to the commands in three processes with different seeds of hashes."""
    commands = [[w.replace("{examples}", str(root / "examples")) for w in words] for words in COMMANDS]
    found = []
    for seed in ("1", "2", "31415"):
        done = subprocess.run(
            [sys.executable, "-c", SCRIPT.format(commands=commands)],
            capture_output=True,
            text=True,
            encoding="utf-8",
            timeout=600,
            env=os.environ | {"PYTHONHASHSEED": seed, "PYTHONUTF8": "1"},
        )
        assert done.returncode == 0, done.stderr
        found.append(done.stdout.split("$ ")[1:])
    return found


@pytest.mark.parametrize("number", range(len(COMMANDS)), ids=[" ".join(c) for c in COMMANDS])
def test_an_answer_does_not_depend_on_the_seed_of_hashes(answers: list[list[str]], number: int) -> None:
    first, second, third = (one[number] for one in answers)
    assert "{" in first
    assert first == second == third
