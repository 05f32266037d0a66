r"""Colours while typing: a text as runs of one kind each.

>>> list(tokens("let p = 2ab"))
[('keyword', 'let'), ('', ' '), ('point', 'p'), ('', ' '), ('operator', '='), ('', ' '),
 ('number', '2'), ('point', 'ab')]
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from gcrules.apps.repl.reading import first_word, split_command
from gcrules.apps.repl.tables import COMMANDS, RELATIONS, RULE_WORDS, STATEMENTS, WORDS, meant

__all__ = ["KINDS", "tokens"]

KINDS = (
    "command",
    "keyword",
    "relation",
    "name",
    "point",
    "number",
    "string",
    "comment",
    "operator",
    "result",
    "fault",
)

_TOKEN = re.compile(
    r"""(?P<comment>\#[^\n]*)
      | (?P<string>"[^"\n]*"?)
      | (?P<word>[^\W\d_](?:\w|['\u0307])*)
      | (?P<number>[0-9]+(?:/[0-9]+)?)
      | (?P<operator>==|=>|!=|/\\|\\/|\*\*|\.\.\.|\\[A-Za-z]+|[-−+*^=∧∨·×<:,.…])
      | (?P<result>%+)
      | (?P<other>[\s()\[\]]+)
      | (?P<fault>.)""",
    re.VERBOSE,
)


def tokens(text: str, names: Collection[str] = ()) -> Iterator[tuple[str, str]]:
    """Kind (one of KINDS, or nothing) and text of each run; `names` are those bound by `let`."""
    called = split_command(text)
    statement = first_word(text) in STATEMENTS
    at = 0
    if called is not None:
        at = called[1]
        names = meant(called[0])
        yield "command" if names or called[0] == "?" else "fault", text[:at]
        if names and COMMANDS[names[0]].takes not in ("expression", "equation", "legs", "latex"):
            yield "", text[at:]
            return
    for found in _TOKEN.finditer(text, at):
        kind = found.lastgroup or ""
        if kind == "word":
            kind = _kind(found[0], statement, names, text.startswith("(", found.end()) and found[0] in WORDS)
        yield "" if kind == "other" else kind, found[0]


def _kind(word: str, statement: bool, names: Collection[str], called: bool) -> str:
    if statement and (word in STATEMENTS or word in RULE_WORDS):
        return "keyword"
    if (statement and word in RELATIONS) or called:
        return "relation"
    return "name" if word in names else "point"
