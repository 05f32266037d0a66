"""What there is to say of a result as HTML: the same sentences, facts and tables that its text has."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from typing import Any

from gcrules.views.forms import shown
from gcrules.views.numerals import in_prose
from gcrules.views.results.result_account import Block, Facts, Grid, ResultAccount, Sentences
from gcrules.views.results.robot_pose import signed

__all__ = [
    "NO_PICTURE",
    "account_section",
    "blocks_html",
    "facts_html",
    "figure_card",
    "inline_svg",
    "latex_html",
    "map_figure",
    "section_html",
    "words_html",
]


_STYLE = re.compile(r"<style\b.*?</style>", re.DOTALL)
_CODE = re.compile("`([^`]*)`")


def account_section(result: Any, title: str, *further: str, last: str = "") -> str:
    """A section with the whole account of a result; what is `further` stands after the answer, what is `last` after the
    account.
    """
    told: ResultAccount = shown(result, "account")
    return section_html(title, told.verdict, *further, blocks_html(told.blocks), last, latex_html(result))


def section_html(title: str, verdict: str, *parts: str, kind: str = "") -> str:
    """A section with its heading and its answer; `kind` is a class that colours it."""
    head = f'<h2>{escape(title)}</h2><p class="proof">{words_html(verdict)}</p>'
    return f'<section class="{f"motion {kind}".strip()}">{head}{"".join(parts)}</section>'


def blocks_html(blocks: Iterable[Block]) -> str:
    """One after the other, each with its title."""
    return "".join(_block(one) for one in blocks)


def _block(one: Block) -> str:
    title = f"<h3>{escape(one.title)}</h3>" if one.title else ""
    if isinstance(one, Facts):
        return title + facts_html(one.rows)
    return title + (_grid(one) if isinstance(one, Grid) else _sentences(one))


def facts_html(rows: Iterable[tuple[str, str]]) -> str:
    """A table of names with what is said of each."""
    return f'<table class="facts"><tbody>{"".join(_rows(rows))}</tbody></table>'


def _rows(rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    before = ""
    for name, value in rows:
        yield f'<tr><th scope="row">{"" if name == before else escape(name)}</th><td>{words_html(value)}</td></tr>'
        before = name


def _grid(grid: Grid) -> str:
    """A table; columns without a name are left out."""
    kept = [k for k, name in enumerate(grid.head) if name]
    head = "".join(f'<th scope="col">{escape(grid.head[k])}</th>' for k in kept)
    body = "".join(_row([row[k] for k in kept]) for row in grid.rows)
    table = f'<table class="grid"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>'
    return f'<div class="wide">{table}</div>'


def _row(cells: Sequence[str]) -> str:
    others = "".join(f"<td>{words_html(cell)}</td>" for cell in cells[1:])
    return f'<tr><th scope="row">{escape(cells[0])}</th>{others}</tr>'


def _sentences(one: Sentences) -> str:
    if one.numbered:
        return f'<ol class="steps" start="0">{"".join(f"<li><code>{escape(s)}</code></li>" for s in one.lines)}</ol>'
    return "".join(f"<p>{words_html(s)}</p>" for s in one.lines)


def words_html(text: str) -> str:
    """Words with the signs of join and meet, numbers as pages show them; what stands between backticks is code."""
    return _CODE.sub(r"<code>\1</code>", escape(in_prose(signed(text))))


def latex_html(result: Any) -> str:
    """Its LaTeX, folded away, to be copied into a paper."""
    return f'<details class="latex"><summary>LaTeX</summary><pre>{escape(shown(result, "latex"))}</pre></details>'


def inline_svg(drawing: str, words: str) -> str:
    """A picture of matplotlib as a part of the page, with `words` for those who do not see it. Its rule of style would
    hold for all drawings of the page; it is inherited instead.
    """
    alone = _STYLE.sub("", drawing[drawing.index("<svg") + 4 :], count=1)
    return f'<svg role="img" aria-label="{escape(words)}" stroke-linejoin="round" stroke-linecap="butt"{alone}'


def map_figure(drawn: str, words: str) -> str:
    """A picture of a map with what is said below it."""
    return f'<figure class="plot map">{drawn}<figcaption>{escape(words)}</figcaption></figure>'


NO_PICTURE = '<p class="note">There is no picture: pictures of maps need matplotlib, gcrules[maps].</p>'


def figure_card(drawing: str, heading: str, *words: str, step: int | None = None) -> str:
    """A small picture of the robot with what is said of it; with a `step` of the section's 3D view a button to it."""
    told = "".join(f"<span>{escape(one)}</span>" for one in words if one)
    button = ""
    if step is not None:
        name = f"Show {escape(heading)} in 3D"
        button = f'<button type="button" data-step="{step}" aria-label="{name}" hidden>Show in 3D</button>'
    caption = f"<figcaption><b>{escape(heading)}</b>{told}{button}</figcaption>"
    return f'<figure class="card">{drawing}{caption}</figure>'
