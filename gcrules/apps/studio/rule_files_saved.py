"""Files of rules that a page has opened, as files that the lines which repeat an answer name."""

from __future__ import annotations

import re
from collections.abc import Sequence

from gcrules.apps.studio.catalog_files import CatalogRead, catalogs_read, is_catalog
from gcrules.apps.studio.protocol.answer_views import RepeatedFile
from gcrules.apps.studio.protocol.requests import RuleFile
from gcrules.apps.studio.rule_files import RuleFileRead, all_read
from gcrules.core.errors import FileError
from gcrules.rules.catalog.file import read_text

__all__ = ["saved", "saved_catalogs"]

_STEMS = {".gca": "rules", ".yaml": "catalog"}
"""What files are called whose names leave nothing."""


def saved(files: Sequence[RuleFile]) -> list[RepeatedFile]:
    r"""The files of rules that lines name, those without a rule that is used left out; in the others rules that are
    wrong or switched off are comments.

    >>> text = "rule one: ab /\\ cd => [abcd] rule two: ab /\\ cde => [acde] b - [bcde] a\n  silent [abcd]\n"
    >>> (found,) = saved([{"name": "x", "text": text, "off": ["one"]}])
    >>> print(found["name"], found["text"], sep="\n")
    x.gca
    # rule one: ab /\ cd => [abcd]
     rule two: ab /\ cde => [acde] b - [bcde] a
      silent [abcd]
    <BLANKLINE>
    """
    files = [file for file in files if not is_catalog(file)]
    texts = (_used(file, read) for file, read in zip(files, all_read(files), strict=True))
    return [{"name": name, "text": text} for name, text in zip(_names(files), texts, strict=True) if text]


def saved_catalogs(files: Sequence[RuleFile]) -> list[RepeatedFile]:
    r"""The catalogs that lines name, likewise.

    >>> one = "- id: {0}\n  legs: ab af cb cd ed ef\n  condition: {{kind: four-planes, expression: {1}}}\n"
    >>> right, wrong = r"ace /\ abf /\ cbd /\ edf", r"abc /\ bde /\ bcd /\ edf"
    >>> text = "classes:\n" + one.format("a", right) + one.format("b", wrong)
    >>> (found,) = saved_catalogs([{"name": "Mine.YML", "text": text, "off": []}])
    >>> print(found["name"], *found["text"].split("\n")[3:], sep="\n")
    Mine.yaml
      condition: {kind: four-planes, expression: ace /\ abf /\ cbd /\ edf}
    # - id: b
    #   legs: ab af cb cd ed ef
    #   condition: {kind: four-planes, expression: abc /\ bde /\ bcd /\ edf}
    <BLANKLINE>
    """
    files = [file for file in files if is_catalog(file)]
    texts = (_used_classes(file, read) for file, read in zip(files, catalogs_read(files), strict=True))
    return [{"name": name, "text": text} for name, text in zip(_names(files, ".yaml"), texts, strict=True) if text]


def _used_classes(file: RuleFile, read: CatalogRead) -> str:
    """The text of a catalog whose classes that are wrong or switched off are comments; "" where none is left, and where
    the classes do not stand in lines of their own.
    """
    off = [c for c in read.checks if not c.used or c.entry.id in file["off"]]
    left = [c.entry.id for c in read.checks if c not in off]
    if not off or not left:
        return file["text"] if left else ""
    lines, starts = file["text"].split("\n"), [c.line - 1 for c in read.checks]
    for check in off:
        begin = check.line - 1
        after = (n for n in range(begin + 1, len(lines)) if n in starts or re.match(r"[^\s#-]", lines[n]))
        own = slice(begin, next(after, len(lines)))
        lines[own] = [f"# {line}" if line.strip() else line for line in lines[own]]
    text = "\n".join(lines)
    try:
        return text if [e.id for e in read_text(text, file["name"]).entries] == left else ""
    except FileError:
        return ""


def _names(files: Sequence[RuleFile], ending: str = ".gca") -> list[str]:
    """A name for each file that any shell and any disk takes and that ends as such files do; all different.

    >>> _names([{"name": n, "text": "", "off": []} for n in ("mine.gca", "../-a b$(x).gca", "Mine.gca", "…")])
    ['mine.gca', 'a-b-x.gca', 'Mine-2.gca', 'rules.gca']
    """
    found: list[str] = []
    for file in files:
        stem = re.sub(r"\.(gca|ya?ml)$", "", file["name"].rpartition("/")[2], flags=re.IGNORECASE)
        stem = re.sub(r"[^A-Za-z0-9_]+", "-", stem).strip("-") or _STEMS[ending]
        taken = {name.casefold() for name in found}
        number = next(n for n in range(1, len(files) + 2) if _numbered(stem, n, ending).casefold() not in taken)
        found.append(_numbered(stem, number, ending))
    return found


def _numbered(stem: str, number: int, ending: str) -> str:
    return f"{stem}{ending}" if number == 1 else f"{stem}-{number}{ending}"


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
