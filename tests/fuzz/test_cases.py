"""What fuzzers found, again; and a few inputs of every family, so that the campaign itself stays sound."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from fuzz.campaign import tried
from fuzz.case import Case, from_yaml, to_yaml
from fuzz.families import FAMILIES
from fuzz.jail import Jail, jailed
from fuzz.judging import judged
from fuzz.running import Outcome, run_call
from fuzz.shrinking import shrunk

CASES = sorted((Path(__file__).parent / "cases").glob("*.yaml"))

SEED = 12


@pytest.fixture
def jail() -> Iterator[Jail]:
    with jailed() as found:
        yield found


@pytest.mark.parametrize("path", CASES, ids=[path.stem for path in CASES])
def test_case(jail: Jail, path: Path) -> None:
    case, more = from_yaml(path.read_text(encoding="utf-8"))
    faults, outcome = tried(FAMILIES[case.family], case, jail)
    assert not faults
    assert outcome.code == more.get("expected", outcome.code)


@pytest.mark.parametrize("name", FAMILIES)
def test_some_inputs(jail: Jail, name: str) -> None:
    family = FAMILIES[name]
    for index in range(family.few):
        case = family.case(SEED, index)
        faults, _ = tried(family, case, jail)
        assert not faults, to_yaml(case)


@pytest.mark.parametrize("name", FAMILIES)
def test_inputs_are_the_same_each_time_and_can_be_kept(name: str) -> None:
    for index in range(10):
        case = FAMILIES[name].case(SEED, index)
        assert case == FAMILIES[name].case(SEED, index)
        assert from_yaml(to_yaml(case, expected=2)) == (case, {"expected": 2})
    assert len({to_yaml(FAMILIES[name].case(SEED, index)) for index in range(10)}) > 5


# --- what is wrong is noticed --------------------------------------------------------------------------------------

GOOD = Outcome(0, "[abcd]\n")
COMMAND = Case("expressions", ("expand", "[abcd]"))
WRONG = {
    "traceback": (
        COMMAND,
        Outcome(None, trace="…", frame="ValueError at gcrules/algebra/language/legs_text.py:read_legs"),
        "ValueError at",
    ),
    "exit code": (COMMAND, Outcome(70, "", "…"), "exit code 70"),
    "file left": (COMMAND, Outcome(2, "", "error: …", left=(".out.txt.1",)), "files left"),
    "output on refusal": (Case("e", ("expand", "x", "-o", "o")), Outcome(2, "", "error: …", left=("o",)), "files left"),
    "file of another name": (COMMAND, Outcome(0, "x", left=("o",)), "files left"),
    "warning": (COMMAND, Outcome(0, "x", noise=("RuntimeWarning: overflow",)), "RuntimeWarning"),
    "no message": (COMMAND, Outcome(2), "exit code 2 without an error"),
    "answer and error": (COMMAND, Outcome(2, "[abcd]", "error: …"), "an answer and an error"),
    "error and success": (COMMAND, Outcome(0, "[abcd]", "error: …"), "an error with exit code 0"),
    "not JSON": (Case("e", ("expand", "x", "--json")), Outcome(0, '{"x": NaN}'), "not one JSON document"),
    "two documents": (Case("e", ("expand", "x", "--json")), Outcome(0, "{}\n{}"), "not one JSON document"),
    "the interpreter's words": (COMMAND, Outcome(2, "", "error: 'NoneType' …"), "words of the interpreter"),
    "control characters": (COMMAND, Outcome(2, "", "error: \x1b[2J"), "control characters"),
}


def test_a_good_outcome() -> None:
    assert not judged(COMMAND, GOOD)
    assert not judged(Case("e", ("expand", "x", "-o", "out")), Outcome(0, left=("out",)))


@pytest.mark.parametrize(("case", "outcome", "words"), WRONG.values(), ids=WRONG)
def test_wrong_outcomes(case: Case, outcome: Outcome, words: str) -> None:
    assert any(words in name for name, _ in judged(case, outcome))


def test_nothing_is_written_elsewhere(jail: Jail, tmp_path: Path) -> None:
    def write() -> list[str]:
        (tmp_path / "x").write_text("")
        return []

    found = run_call(Case("calls"), jail, write)
    assert found.frame
    assert any("outside the folder" in n for n in found.noise)
    assert not (tmp_path / "x").exists()


def test_what_is_left_out_does_not_matter() -> None:
    case = Case("scripts", ("run", "s.gca", "--limit", "20"), {"s.gca": "rank 3\nshow ab\nclaim [abc] == 7\n", "t": ""})
    small = shrunk(case, lambda c: "7" in c.files.get("s.gca", ""), seconds=60)
    assert (small.argv, small.files, small.stdin) == (("run",), {"s.gca": "7"}, "")
