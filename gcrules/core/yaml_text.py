"""Texts as YAML reads them back."""

from __future__ import annotations

import re

__all__ = ["quoted"]

_PLAIN = re.compile(r"[A-Za-z][^:#\"'{}\[\]&*!|>%@`\n]*")
_WORDS = ("true", "false", "null", "yes", "no")
_CONTROLS = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029\ufeff]+")


def quoted(text: str) -> str:
    """A text on one line, plain where it can be.

    >>> print(quoted("Delta robot"), quoted("a: b"))
    Delta robot "a: b"
    """
    if _PLAIN.fullmatch(text) and text == text.strip() and text.lower() not in _WORDS:
        return text
    inner = _CONTROLS.sub(" ", text).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{inner}"'
