"""The tests themselves: files by room, none too long, and a table of slow ones that names what is there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from fast import SLOW
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


@pytest.mark.parametrize("slow", SLOW)
def test_slow_tests_are_there(slow: str) -> None:
    file, _, name = slow.partition("::")
    assert re.search(rf"^def {name}\b" if name else "", (TESTS / file).read_text(encoding="utf-8"), re.MULTILINE)
