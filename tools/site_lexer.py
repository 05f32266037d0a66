"""Colours for scripts of gcrules in the guide (Pygments); the words of statements are read from the grammar."""

from __future__ import annotations

import re
from pathlib import Path

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Whitespace

__all__ = ["GcaLexer"]

_GRAMMAR = Path(__file__).resolve().parent.parent / "gcrules" / "grammar.lark"
KEYWORDS = tuple(sorted(set(re.findall(r'"([a-z]{2,})"', _GRAMMAR.read_text(encoding="utf-8")))))


class GcaLexer(RegexLexer):  # type: ignore[misc]
    """`.gca` scripts."""

    name = "gcrules script"
    aliases = ("gca",)
    filenames = ("*.gca",)
    url = ""
    tokens = {  # noqa: RUF012  # the form that Pygments asks for
        "root": [
            (r"\s+", Whitespace),
            (r"#.*", Comment.Single),
            (r'"[^"\n]*"', String),
            (words(KEYWORDS, prefix=r"(?<![\w'])", suffix=r"(?![\w'])"), Keyword),
            (r"\d+(/\d+)?", Number),
            (r"==|=>|!=|/\\|\\/|\*\*|[-+*^=∧∨·−<:]|\\[a-z]+", Operator),
            (r"[\[\](),.]", Punctuation),
            (r"[^\W\d_][\w'̇]*(\.\.\.|…)?", Name),
            (r".", Name),
        ]
    }
