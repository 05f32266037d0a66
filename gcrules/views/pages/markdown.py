r"""Text from catalogs as Markdown that shows just this text, in a page, a table or a heading."""

from __future__ import annotations

import re

__all__ = ["block", "inline", "reference"]

_SPECIAL = re.compile(r"[&<>\\`*_\[\]{}|$~]")
_AT_START = re.compile(r"(?=[#+=!:;\"-]|\d+[.)])")
_URL = re.compile(r"https?://[^\s<>\"`|\\]+")


def inline(text: str) -> str:
    """One line of Markdown that reads as the text: no emphasis, link, formula, table cell, tag or list arises from it.

    Characters are written as entities, which all dialects of Markdown agree on.
    """
    line = _SPECIAL.sub(_entity, " ".join(text.split()))
    return f"&#{ord(line[0])};{line[1:]}" if _AT_START.match(line) else line


def _entity(found: re.Match[str]) -> str:
    return f"&#{ord(found[0])};"


def reference(text: str) -> str:
    """Like `inline`, but a whole address becomes a link."""
    return f"<{text}>" if _URL.fullmatch(text) else inline(text)


def block(*lines: str) -> list[str]:
    """Lines of formulas, as they stand."""
    fence = "`" * max(3, 1 + max((len(run) for line in lines for run in re.findall("`+", line)), default=0))
    return [f"{fence}text", *lines, fence, ""]
