"""Link the first use of each term on a page of the guide to its entry of the glossary.

>>> link("# Meet\\n\\nThe brackets of `bracket`, and brackets again.\\n", "course/meet.md").splitlines()[2][:46]
'The [brackets](../glossary.md#bracket "The det'
"""

from __future__ import annotations

import posixpath
import re

from gcrules.views.glossary import EVERYDAY, GLOSSARY, anchor

__all__ = ["PAGE", "link"]

PAGE = "glossary.md"

ENTRIES = {name.lower(): e for e in GLOSSARY for name in [e["term"], *filter(None, e["forms"].split("|"))]}


def _names(*, everyday: bool) -> str:
    """Longest first; the words of a name may stand on two lines, a sign is no letter of the other case."""
    names = sorted((n for n, e in ENTRIES.items() if (e["term"] in EVERYDAY) == everyday), key=len, reverse=True)
    patterns = [re.escape(n).replace(r"\ ", r"(?: |\n *)") for n in names]
    return "|".join(f"(?i:{p})" if len(n) > 1 else p for n, p in zip(names, patterns, strict=True))


NAMED = re.compile(
    rf"(?<![\w-])(?P<plain>{_names(everyday=False)})(?![\w-])|(?<=\*)(?P<put>{_names(everyday=True)})(?=\*)"
)

# What is no running text, in the sequence in which it is looked for.
OTHER = tuple(
    re.compile(pattern, re.MULTILINE | re.DOTALL)
    for pattern in (
        r"\A---\n.*?^---$",  # front matter
        r"^( *)(```+|~~~+).*?^\1\2",
        r"(?<=\n\n)(?: {4,}[^\n]*\n+)+",  # indented code
        r"<!--.*?-->",
        r"^:::.*?(?=^\S|\Z)",  # what is written about the code
        r"\$\$.*?\$\$|\\\[.*?\\\]|\\\(.*?\\\)|(?<![\\\w])\$(?=\S)[^$\n]*(?<=\S)\$",
        r"(?<!`)(`+)(?!`)(?:(?!\n\n).)+?(?<!`)\1(?!`)",
        r"^#+ [^\n]*",
        r"^\|[^\n]*(?=\n\|[ :|-]*$)",  # the head of a table
        r"^(?:!!!|\?\?\?)[^\n]*",
        r"^\[[^\]\n]+\]:[^\n]*",
        r"!?\[(?:[^\[\]]|\[[^\[\]]*\])*\](?:\([^()]*(?:\([^()]*\)[^()]*)*\)|\[[^\]]*\])",
        r"<summary>.*?</summary>|<a\b.*?</a>",
        r"<[a-zA-Z/][^<>]*>",
        r"\{:?[^{}\n]*\}",
    )
)


def _blank(match: re.Match[str]) -> str:
    return re.sub(r"[^\n]", "\0", match[0])


def link(text: str, page: str) -> str:
    """The Markdown of a page (its place below docs/), with the links."""
    if page == PAGE:
        return text
    prose = text
    for pattern in OTHER:
        prose = pattern.sub(_blank, prose)
    place = posixpath.relpath(PAGE, posixpath.dirname(page) or ".")
    made, end, seen = [], 0, set()
    for match in NAMED.finditer(prose):
        entry = ENTRIES[" ".join(match[0].lower().split())]
        if entry["term"] not in seen:
            seen.add(entry["term"])
            words = text[match.start() : match.end()]
            made += [text[end : match.start()], f'[{words}]({place}#{anchor(entry["term"])} "{entry["meaning"]}")']
            made.append("{ .gc-term }")
            end = match.end()
    return "".join([*made, text[end:]])
