"""Files that a report carries with it, as links that save them, and the certificates of its answers among them."""

from __future__ import annotations

from base64 import b64encode
from html import escape
from typing import Any

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.files import file_name
from gcrules.views.report.account_html import words_html
from gcrules.views.results.checkers import certified, check_of, kind_of

__all__ = ["carried_html", "checking_html"]

_certificate_bytes = deferred("gcrules.poses.certificate_files:certificate_bytes")

_MOST = 3_000_000
"""Bytes of a file that a page carries."""


def carried_html(name: str, mime: str, data: bytes, writes: str = "--certificate FILE", most: int = _MOST) -> str:
    """A sentence with the size of a file and the link that saves it; of one of more bytes than `most`, what `writes` it
    in the shell.
    """
    if len(data) > most:
        return f"The file is too large to be a part of this page; <code>{escape(writes)}</code> writes it."
    shown = escape(name)
    href = f"data:{mime};base64,{b64encode(data).decode()}"
    return f'This page carries it, {len(data) / 1000:.3g} kB: <a download="{shown}" href="{href}">{shown}</a>'


def checking_html(answer: Any, title: str) -> str:
    """The certificate of an answer about what has this title, and how it is checked again, or why no program checks it;
    "" for answers that have none.
    """
    if not certified(answer):
        return ""
    try:
        data: bytes = _certificate_bytes(answer, packed=True)
    except (InputError, LimitReached) as fault:
        return f"<h3>Checking it again</h3><p>{words_html(fault.message)}.</p>"
    file = carried_html(file_name(f"{title} {kind_of(answer)}", "json.gz"), "application/gzip", data)
    return f"<h3>Checking it again</h3><p>{words_html(check_of(answer))}</p><p>{file}</p>"
