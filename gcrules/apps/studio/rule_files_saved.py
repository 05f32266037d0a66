"""Files of rules that a page has opened, as files that the lines which repeat an answer name."""

from __future__ import annotations

import re
from collections.abc import Sequence

from gcrules.apps.studio.protocol.answer_views import RepeatedFile
from gcrules.apps.studio.protocol.requests import RuleFile
from gcrules.apps.studio.rule_files import RuleFileRead, all_read

__all__ = ["saved"]


def saved(files: Sequence[RuleFile]) -> list[RepeatedFile]:
    r"""The files that lines name, those without a rule that is used left out; in the others rules that are wrong or
    switched off are comments.

    >>> text = "rule one: ab /\\ cd => [abcd] rule two: ab /\\ cde => [acde] b - [bcde] a\n  silent [abcd]\n"
    >>> (found,) = saved([{"name": "x", "text": text, "off": ["one"]}])
    >>> print(found["name"], found["text"], sep="\n")
    x.gca
    # rule one: ab /\ cd => [abcd]
     rule two: ab /\ cde => [acde] b - [bcde] a
      silent [abcd]
    <BLANKLINE>
    """
    texts = (_used(file, read) for file, read in zip(files, all_read(files), strict=True))
    return [{"name": name, "text": text} for name, text in zip(_names(files), texts, strict=True) if text]


def _names(files: Sequence[RuleFile]) -> list[str]:
    """A name for each file that any shell and any disk takes and that ends as files of rules do; all different.

    >>> _names([{"name": n, "text": "", "off": []} for n in ("mine.gca", "../-a b$(x).gca", "Mine.gca", "…")])
    ['mine.gca', 'a-b-x.gca', 'Mine-2.gca', 'rules.gca']
    """
    found: list[str] = []
    for file in files:
        stem = file["name"].rpartition("/")[2].removesuffix(".gca")
        stem = re.sub(r"[^A-Za-z0-9_]+", "-", stem).strip("-") or "rules"
        taken = {name.casefold() for name in found}
        number = next(n for n in range(1, len(files) + 2) if _numbered(stem, n).casefold() not in taken)
        found.append(_numbered(stem, number))
    return found


def _numbered(stem: str, number: int) -> str:
    return f"{stem}.gca" if number == 1 else f"{stem}-{number}.gca"


def _used(file: RuleFile, read: RuleFileRead) -> str:
    """The text of a file whose rules that are wrong or switched off are comments; "" where none is left."""
    if read.script is None:
        return ""
    wrong = {c.rule.id for c in read.checks if not c.ok} | {*file["off"]}
    text = file["text"]
    left = [rule for rule in read.script.rules if rule.id not in wrong]
    for rule in reversed(read.script.rules):
        if rule.id in wrong:
            before, body, after = text[: rule.span.start], text[rule.span.start : rule.span.end], text[rule.span.end :]
            begin = "" if not before or before.endswith("\n") else "\n"
            end = "" if not after or after.startswith("\n") else "\n"
            text = f"{before}{begin}" + "\n".join(f"# {line}" for line in body.split("\n")) + end + after
    return text if left else ""
