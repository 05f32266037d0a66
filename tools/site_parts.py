"""An extension of Python-Markdown that puts drawings and other parts into a page, where its text names their files.

A part is named ``@@gcrules:NAME@@`` in the text and is a file of the folder that `parts` gives. Scripts of gcrules are
coloured as well.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pygments.lexers
import site_lexer
from markdown import Markdown
from markdown.extensions import Extension
from markdown.postprocessors import Postprocessor

__all__ = ["PLACE", "Parts", "makeExtension"]

PLACE = "@@gcrules:{}@@"
PLACES = re.compile(PLACE.format(r"([\w.-]+)"))

pygments.lexers.LEXERS["GcaLexer"] = (site_lexer.__name__, "gcrules script", ("gca",), ("*.gca",), ())


class _Fill(Postprocessor):  # type: ignore[misc]
    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def run(self, text: str) -> str:
        return PLACES.sub(lambda place: (self.folder / place[1]).read_text(encoding="utf-8"), text)


class Parts(Extension):  # type: ignore[misc]
    def __init__(self, **given: Any) -> None:
        self.config = {"parts": ["", "the folder with the parts"]}
        super().__init__(**given)

    def extendMarkdown(self, md: Markdown) -> None:
        md.postprocessors.register(_Fill(Path(self.getConfig("parts"))), "gcrules-parts", 0)


def makeExtension(**given: Any) -> Parts:
    return Parts(**given)
