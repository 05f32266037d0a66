"""`gcrules discover`, and the same question at the prompt and on the studio's bench."""

from __future__ import annotations

import json

import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.studio.bench import bench

HALVES = EXAMPLES / "figures" / "halves.gca"
PAPPUS = EXAMPLES / "theorems" / "pappus.gca"


def test_the_shell_says_what_python_says() -> None:
    done = invoke("discover", str(HALVES), "--json")
    assert done.exit_code == 0
    answer = json.loads(done.stdout)
    assert answer == gc.discover(str(HALVES)).to_json()
    assert [(d["claim"], d["verdict"]) for d in answer["found"]] == [
        ("collinear(x, y, z)", "partly proved"),
        ("on_conic(a', b', c', x, y, z)", "proved"),
    ]


def test_standard_input_and_relations() -> None:
    text = HALVES.read_text()
    done = invoke("discover", "-", "--relation", "on_conic", input=text)
    assert "on_conic(a', b', c', x, y, z)" in done.stdout
    assert "collinear" not in done.stdout


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        ((str(PAPPUS),), 0, "proved: collinear(x, y, z)"),
        ((str(PAPPUS), "--limit", "1"), 3, "undecided: collinear(x, y, z)"),
        ((str(PAPPUS), "--candidates", "5"), 3, "840 candidates, more than 5"),
        ((str(PAPPUS), "--relation", "parallel"), 2, "'parallel' is not one of"),
        ((str(EXAMPLES / "theorems" / "relations-5.gca"),), 2, "incidences are not looked for in rank 5"),
        (("missing.gca",), 2, "there is no such file"),
    ],
)
def test_exit_codes(words: tuple[str, ...], code: int, said: str) -> None:
    done = invoke("discover", *words)
    assert done.exit_code == code
    assert said in done.stdout + done.stderr


def test_assumptions_that_are_not_resolved_have_their_place() -> None:
    done = invoke("discover", "-", input="rank 3\ngiven [abc] == 1\n")
    assert done.exit_code == 2
    assert "error: <stdin>:2:7: the assumption [abc] == 1 cannot be resolved" in done.stderr


@pytest.mark.parametrize("word", ["", " collinear"])
def test_the_bench_asks_what_stands_before(word: str) -> None:
    text = PAPPUS.read_text()
    found = bench(f"{text}:discover{word}", None, None)
    last = found["results"][-1]
    assert found["fault"] is None
    assert (last["command"], last["verdict"]) == ("discover", "value")
    assert "proved: collinear(x, y, z)" in last["text"]
    repeat = last["repeat"]
    assert repeat is not None
    first, *lines, _ = repeat["shell"].split("\n")
    assert invoke(*first.split(" <<")[0].split()[1:], input="\n".join(lines)).stdout.strip() == last["text"]
    printed = repeat["python"].partition("print(")[2].removesuffix(")")
    assert printed.startswith("gc.discover(")


def test_the_bench_says_what_is_no_relation() -> None:
    fault = bench("rank 3\n:discover colinear", None, None)["fault"]
    assert fault is not None
    assert fault["place"] == {"start": 17, "end": 25, "line": 2, "column": 11}
