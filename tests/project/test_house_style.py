"""No page and no answer has a phrase that docs/house-style.md has replaced."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from itertools import chain
from pathlib import Path

import pytest
from places import ROOT

PAGE = ROOT / "docs" / "house-style.md"
ROW = re.compile(r"^\| .+ \| (.+) \|$", re.MULTILINE)
PHRASES = ROW.findall(PAGE.read_text(encoding="utf-8").partition("## Phrases")[2])[1:]


def words(text: str) -> str:
    return " ".join(text.split())


@pytest.fixture(scope="module")
def everything() -> dict[str, str]:
    """All pages, the code with its answers, and the studio's page, with line ends as spaces."""
    found = chain(
        ROOT.glob("*.md"),
        (ROOT / "docs").rglob("*.md"),
        (ROOT / "gcrules").rglob("*.py"),
        (ROOT / "studio-ui" / "src").rglob("*.ts*"),
        (ROOT / "plugins").rglob("*.yaml"),
    )
    return {str(path.relative_to(ROOT)): words(path.read_text(encoding="utf-8")) for path in found if path != PAGE}


def test_the_page_has_phrases() -> None:
    assert len(PHRASES) > 8
    assert "knows neither frame nor unit" in PHRASES


@pytest.mark.parametrize("phrase", PHRASES)
def test_phrases_are_gone(phrase: str, everything: dict[str, str]) -> None:
    assert [name for name, text in everything.items() if phrase in text] == []


IS_NO = re.compile(r"(?<!here )\b(?:is|are) no (?!longer\b|more\b)[a-z]")


def messages(path: Path) -> Iterator[str]:
    """The strings of a module that are not docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    documented = {id(one.value) for one in ast.walk(tree) if isinstance(one, ast.Expr)}
    for one in ast.walk(tree):
        if isinstance(one, ast.Constant) and isinstance(one.value, str) and id(one) not in documented:
            yield words(one.value)


def test_messages_say_what_a_thing_is_not() -> None:
    """ "x is not a joint", not "x is no joint"; "there is no joint" is another statement."""
    assert [m for m in ("it is no joint", "these are no data") if not IS_NO.search(m)] == []
    found = [(path.name, m) for path in (ROOT / "gcrules").rglob("*.py") for m in messages(path) if IS_NO.search(m)]
    assert found == []
