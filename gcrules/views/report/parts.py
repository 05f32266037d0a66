"""An answer of several sentences as a list, in the shell and in a report."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

__all__ = ["answer_html", "in_shell"]


def in_shell(sentences: Sequence[str]) -> list[str]:
    """Sentences that make a list with dashes before them; one stands by itself.

    >>> in_shell(["So it is."]), in_shell(["So it is.", "Always."])
    (['So it is.'], ['- So it is.', '- Always.'])
    """
    return [f"- {s}" for s in sentences] if len(sentences) > 1 else list(sentences)


def answer_html(sentences: Sequence[str]) -> str:
    """Sentences as a list, one as a paragraph."""
    if len(sentences) == 1:
        return f"<p>{escape(sentences[0])}</p>"
    return f"<ul>{''.join(f'<li>{escape(s)}</li>' for s in sentences)}</ul>"
