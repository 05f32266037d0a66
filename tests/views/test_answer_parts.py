"""Long answers in parts: the same sentences in the shell and in a report."""

from __future__ import annotations

from pathlib import Path

import pytest
from commands import invoke

import gcrules as gc
from gcrules.core.english import in_parts
from gcrules.views.report.parts import answer_html


@pytest.mark.parametrize("robot", ["4-upu", "quadrupteron", "h4"])
def test_the_shell_and_a_report_list_the_sentences(robot: str, tmp_path: Path) -> None:
    statement = gc.analyze(robot).statement
    parts = in_parts(statement)
    assert len(parts) > 1
    assert " ".join(parts) == statement
    top = invoke("robot", "analyze", robot).stdout.split("\n\n")[0]
    assert " ".join(top.split()) == " ".join(f"- {part}" for part in parts)
    assert top.count("\n- ") == len(parts) - 1
    page = tmp_path / "report.html"
    assert not invoke("report", robot, "-o", str(page)).exit_code
    assert page.read_text(encoding="utf-8").count("<li>") >= len(parts)
    assert answer_html(parts).count("<li>") == len(parts)


def test_one_sentence_stands_by_itself() -> None:
    assert not invoke("robot", "analyze", "3-rps").stdout.startswith("- ")
    assert answer_html(["So it is."]) == "<p>So it is.</p>"
