"""No page and no answer has a phrase that docs/house-style.md has replaced."""

from __future__ import annotations

import re
from itertools import chain

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
