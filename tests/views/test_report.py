"""The report, the stages and the documents made of them."""

from __future__ import annotations

import re
from base64 import b64decode
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.core.english import in_parts
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.rules.catalog.file import load
from gcrules.views.report.items import Formula
from gcrules.views.report.report import fragment
from gcrules.views.report.stages import stages

PLATFORMS = sorted(EXAMPLES.glob("*.yaml"))
STRUCTURES = ["Aa Ab Bc Cd De Ef", "Aa Ba Ca Db Eb Fb", "ab bc ca ad be cf", "ab bc ca de ef fd", "ab cd ef gh ij kl"]
LONG = gc.analyze(
    "left top, left bottom, right top, right c, middle d, last e", points="left right top bottom middle last"
)


class Balanced(HTMLParser):
    """Every element is closed in turn; nothing is loaded from elsewhere."""

    VOID = ("meta", "br", "hr", "img", "input", "link")

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in self.VOID:
            self.open.append(tag)
        named = [v or "" for k, v in attrs if k in ("src", "href") or (k == "style" and "url(" in (v or ""))]
        self.loaded += [v for v in named if not v.startswith("data:")]
        assert tag not in ("script", "link", "img", "iframe")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def check_page(page: str) -> None:
    parser = Balanced()
    parser.feed(page)
    assert not parser.open
    assert not parser.loaded
    assert "@import" not in page
    assert "url(" not in page


@pytest.mark.parametrize("path", PLATFORMS, ids=[p.stem for p in PLATFORMS])
def test_reports_of_the_examples(path: Path) -> None:
    a = gc.analyze(load_platform(path))
    page = gc.report(a, interactive=False)
    check_page(page)
    assert a.pose is not None
    assert ("Singular:" in page) == (a.pose.verdict == "singular") == path.stem.endswith("-singular")
    assert not a.platform.units or re.search(r" m?m⁹</td>", page)


def test_a_report_carries_the_proofs_of_its_theorems() -> None:
    a = gc.analyze("ab af cb cd ed ef")
    page = gc.report(a, interactive=False)
    carried = re.search(r'download="([^"]+)" href="data:application/json;base64,([^"]+)"', page)
    assert carried is not None
    assert carried[1].endswith(".proof.json")
    assert b64decode(carried[2]).decode() == gc.proof_file(a).json_text()
    assert f"<code>{gc.proof_file(a).digest[:16]}</code>" in page


def test_there_are_examples() -> None:
    assert len(PLATFORMS) > 3


@pytest.mark.parametrize("legs", [*STRUCTURES, *(e.legs for e in load().entries)], ids=str)
def test_reports_of_all_classes(legs: str | tuple[tuple[str, str], ...]) -> None:
    a = gc.analyze(legs)
    page = gc.report(a, interactive=False)
    check_page(page)
    check_page(fragment(a))
    assert page.count("<svg") == 2
    for text in (a.text(), a.text(unicode=True)):
        assert " ".join(a.condition.statement.split()) in " ".join(text.split())
    assert a.text().isascii()
    latex = a.latex()
    assert latex.count("{") - latex.count("\\{") == latex.count("}") - latex.count("\\}")
    assert (
        re.findall(r"\\begin\{(theorem|observation)\}", latex)
        == re.findall(r"\\end\{(theorem|observation)\}", latex)
        != []
    )


@pytest.mark.parametrize("legs", [*STRUCTURES, *(e.legs for e in load().entries)], ids=str)
def test_every_formula_of_a_stage_is_true(legs: str | tuple[tuple[str, str], ...]) -> None:
    """Both sides agree on the exact oracle, so that a reader may take each line as it stands."""
    from gcrules.algebra.evaluate import vanishes
    from gcrules.algebra.expr import ZERO, sub

    found = 0
    for stage in stages(gc.analyze(legs)):
        for item in stage.items:
            if isinstance(item, Formula) and item.left is not None:
                assert vanishes(item.left if item.right == ZERO else sub(item.left, item.right)), (stage.title, item)
                found += 1
    assert found > 1


def test_long_names() -> None:
    page = gc.report(LONG, interactive=False)
    check_page(page)
    assert "left top" in page
    assert "lefttop" not in page


@pytest.mark.browser
def test_report_in_a_browser(run_browser: Callable[..., str], tmp_path: Path) -> None:
    """From file://, with formulas and figures in the document and no text outside them lost."""
    path = tmp_path / "report.html"
    a = gc.analyze(load_platform(PLATFORMS[0]))
    path.write_text(gc.report(a, interactive=False), encoding="utf-8")
    dom = run_browser(path)
    assert all(part in dom for part in in_parts(a.condition.statement))
    assert dom.count("<math") > 10
    assert dom.count("<svg") == 2
