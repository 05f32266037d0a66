"""The tests themselves: files by room, none too long, and a table of slow ones that names what is there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from choice import COSTS, spread, table
from places import ROOT

TESTS = ROOT / "tests"
FILES = sorted(TESTS.rglob("test_*.py"))
ROOMS = {p.name for p in (ROOT / "gcrules").iterdir() if (p / "__init__.py").exists()}


def test_files_stand_in_rooms() -> None:
    folders = {path.relative_to(TESTS).parts[0] for path in FILES}
    assert len(ROOMS) > 8
    assert folders - ROOMS == {"project", "fuzz"}
    assert folders >= ROOMS


@pytest.mark.parametrize("path", FILES, ids=[p.relative_to(TESTS).as_posix() for p in FILES])
def test_no_file_is_too_long(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 600


def test_tests_that_cost_much_are_there() -> None:
    gone = []
    for one in COSTS:
        file, _, name = one.partition("::")
        path = TESTS / file
        if not path.is_file() or not re.search(
            rf"^ *def {name.rpartition('::')[2]}\b", path.read_text(encoding="utf-8"), re.MULTILINE
        ):
            gone.append(one)
    assert not gone


@pytest.mark.parametrize(
    ("seconds", "number", "tried"),
    [(0.25, 4, [0, 1, 2, 3]), (0.25, 11, [0, 3, 7, 10]), (9.0, 5, [0, 4]), (0.5, 1, [0])],
)
def test_cases_are_spread_evenly(
    seconds: float, number: int, tried: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(COSTS, "room/test_a.py::test_b", seconds)
    cases: list[object] = list(range(number))
    assert spread("room/test_a.py::test_b", cases) == tried
    assert spread("room/test_a.py::test_c", cases) == cases


def test_costs_are_of_one_case_and_the_small_ones_left_out() -> None:
    measured = [
        ("tests/a.py::b[1]", 0.4),
        ("tests/a.py::b[2]", 0.5),
        ("tests/a.py::b[3]", 9.0),
        ("tests/a.py::c", 0.2),
        ("gcrules/a.py::d", 9.0),
    ]
    assert table(measured).splitlines()[1:] == ["  0.500 a.py::b"]
    assert table([(f"tests/a.py::b[{n}]", 0.1) for n in range(70)]).splitlines()[1:] == ["  0.100 a.py::b"]


def test_a_run_says_how_many_cases_it_left_out(tmp_path: Path) -> None:
    """In a project of its own, with the choice of this one, by workers too."""
    (tmp_path / "tests" / "data").mkdir(parents=True)
    (tmp_path / "tests" / "data" / "costs.txt").write_text("2.0 test_a.py::test_b\n", encoding="utf-8")
    for name in ("choice.py", "conftest.py", "places.py"):
        (tmp_path / "tests" / name).write_text((TESTS / name).read_text(encoding="utf-8"), encoding="utf-8")
    many = "import pytest\n@pytest.mark.parametrize('n', range(9))\ndef test_b(n): assert n % 4 == 0\n"
    (tmp_path / "tests" / "test_a.py").write_text(many, encoding="utf-8")
    for workers in ("0", "1"):
        run = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--spread", "-n", workers, "tests"]
        done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout
        assert "7 x more cases of tests that cost much" in done.stdout
