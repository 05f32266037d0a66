"""What the sections of a report say, in plain words, and whether it is what a result says."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

from gcrules.views.forms import shown
from gcrules.views.numerals import in_prose
from gcrules.views.results.result_account import Facts, Grid, ResultAccount


def plain(page: str) -> str:
    """The words of the sections, spaces between them."""
    sections = re.findall(r'<section class="motion.*?</section>', page, re.DOTALL)
    assert sections
    without_drawings = re.sub(r"<(svg|script|style)\b.*?</\1>", " ", " ".join(sections), flags=re.DOTALL)
    return " ".join(unescape(re.sub(r"<[^>]+>", " ", without_drawings)).split())


def agrees(page: str, result: Any) -> None:
    """Whatever a result says is in the page, in the same words, with numbers as pages show them."""
    told: ResultAccount = shown(result, "account")
    words = plain(page)

    def seen(text: str) -> bool:
        wanted = in_prose(text.replace("/\\", "∧")).replace("`", " ")
        return " ".join(wanted.split()) in words

    def copied(line: str) -> bool:
        """What is to be copied is as it is written."""
        return " ".join(line.split()) in words

    assert seen(told.verdict)
    for block in told.blocks:
        if isinstance(block, Facts):
            assert all(seen(value) for _, value in block.rows)
        elif isinstance(block, Grid):
            assert all(seen(cell) for row in block.rows for cell in row)
        else:
            assert all(map(copied if block.numbered else seen, block.lines))
    assert " ".join(result.latex().split()) in words
