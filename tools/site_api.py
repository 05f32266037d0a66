"""The page on Python: for each public name a line that says what it is; the guide has all that its docstring says.

``python tools/site_api.py`` writes the lines into docs/api.md, from the directives that stand below them.

>>> print(directives("* `gc.load`: What stands there.\\n  <!-- ::: gcrules.api.functions.load -->"))
<BLANKLINE>
::: gcrules.api.functions.load
<BLANKLINE>
"""

from __future__ import annotations

import importlib
import inspect
import re
import textwrap
from pathlib import Path

__all__ = ["PAGE", "directives", "listed"]

ROOT = Path(__file__).resolve().parent.parent
PAGE = "api.md"

WIDTH = 140
ENTRY = re.compile(r"^\* [^\n]*(?:\n  (?!<!-- :::)[^\n]*)*\n  <!-- ::: ([\w.]+) -->$", re.MULTILINE)


def directives(text: str) -> str:
    """The page with the directive of mkdocstrings in place of each line."""
    return ENTRY.sub(r"\n::: \1\n", text)


def listed(text: str) -> str:
    """The page with each line as the docstring has it now."""
    return ENTRY.sub(lambda match: entry(match[1]), text)


def entry(path: str) -> str:
    """The name as it is written in Python, and the first sentence of its docstring, above the directive."""
    import gcrules

    module, _, name = path.rpartition(".")
    said = inspect.cleandoc(getattr(importlib.import_module(module), name).__doc__ or "").partition("\n\n")[0]
    sentence = re.split(r"(?<=\w[.:)])\s(?=[A-Z`])", " ".join(said.split()), maxsplit=1)[0].rstrip(".:")
    shown = f"gc.{name}" if name in gcrules.__all__ else name
    lines = textwrap.wrap(f"* `{shown}`: {sentence}.", WIDTH, subsequent_indent="  ", break_long_words=False)
    return "\n".join([*lines, f"  <!-- ::: {path} -->"])


def main() -> None:
    page = ROOT / "docs" / PAGE
    page.write_text(listed(page.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
