"""What a report of a robot as it stands shows beside the analysis: the view, notes, and what repeats it."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from gcrules.conditions.pose_value import PoseValue
from gcrules.core.english import as_sentence
from gcrules.core.errors import EngineFault
from gcrules.views.report.pose_section import pose_html
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.report.standing import Answered, Repetition, Standing
from gcrules.views.report.value_section import value_html

__all__ = ["bench_html", "notes_html", "numbers_here_html", "repeating_html", "started", "view_html"]

_LONGEST = 600
"""Characters of a link that is written out for paper; longer ones are pressed only."""


def view_html(s: Standing | None, title: str) -> str:
    """The picture of the view as it stood."""
    if s is None or not s.picture:
        return ""
    if not s.picture.startswith("data:image/"):
        raise EngineFault("the picture of a report is not a data address of an image")
    image = f'<img alt="{escape(title)}, as it stood in the view" src="{escape(s.picture)}">'
    return f'<figure class="view">{image}<figcaption>The view, as it stood.</figcaption></figure>'


def notes_html(s: Standing | None) -> str:
    """Notes with their titles."""
    if s is None or not s.notes:
        return ""
    rows = "".join(
        f"<h3>{escape(title)}</h3>{''.join(f'<p>{escape(line)}</p>' for line in text.splitlines() if line.strip())}"
        for title, text in s.notes
    )
    return f'<section class="notes"><h2>Notes</h2>{rows}</section>'


def numbers_here_html(s: Standing) -> str:
    """The numbers in the pose in which the robot stands, or why there are none."""
    if s.numbers is None:
        why = f'<p class="verdict">No numbers</p><p class="why">{escape(as_sentence(s.unset))}</p>'
        return f'<section class="motion close"><h2>{escape(TITLES["pose"])}</h2>{why}</section>' if s.unset else ""
    return value_html(s.numbers) if isinstance(s.numbers, PoseValue) else pose_html(s.numbers, s.mechanism)


def bench_html(s: Standing | None) -> str:
    """The text of the bench, each statement with its answers."""
    if s is None or not s.bench:
        return ""
    return f'<section class="bench"><h2>On the bench</h2>{"".join(map(_answered, s.bench))}</section>'


def _answered(one: Answered) -> str:
    answers = "".join(
        f"<li>{f'<strong>{escape(sure)}</strong>' if sure else ''}<pre>{escape(text)}</pre></li>"
        for sure, text in one.answers
    )
    return f"<pre>{escape(one.text)}</pre>" + (f"<ul>{answers}</ul>" if answers else "")


def repeating_html(s: Standing | None) -> str:
    """The link to the same state, and the lines that repeat what the page shows."""
    if s is None or not (s.link or s.repetitions):
        return ""
    return f'<section class="repeating"><h2>Repeat it</h2>{_link(s.link)}{_lines(s)}</section>'


def _link(link: str) -> str:
    if not link:
        return ""
    words = (
        "Opens this state again, where a studio runs at this address; in another one add what begins with # to its own"
    )
    spelt = f"<pre>{escape(link)}</pre>" if len(link) <= _LONGEST else ""
    return f'<p><a href="{escape(link)}">Open it in the studio</a>. {words}.</p>{spelt}'


def _lines(s: Standing) -> str:
    files = {name: text for one in s.repetitions for name, text in one.files}
    texts = "".join(
        f"<details><summary>{escape(name)}, the file that lines below read</summary><pre>{escape(text)}</pre></details>"
        for name, text in files.items()
    )
    return texts + "".join(map(_repetition, s.repetitions))


def _repetition(one: Repetition) -> str:
    shell = f"<pre>{escape(one.shell)}</pre>"
    python = f"<details><summary>In Python</summary><pre>{escape(one.python)}</pre></details>" if one.python else ""
    return f"<h3>{escape(one.title)}</h3>{shell}{python}"


def started(scene: Mapping[str, Any] | None, s: Standing | None) -> Mapping[str, Any] | None:
    """The scene of a page, which a view begins where the robot stands."""
    return scene if scene is None or s is None or s.start is None else {**scene, "start": dict(s.start)}
