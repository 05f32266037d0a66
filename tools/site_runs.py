"""Which examples of the guide run in its pages, and how: the commands that the engine of site_engine.py answers.

A block of a console, or a script of statements, gets the attribute `data-run` with its command lines or `data-script`
with its text, from which docs/assets/try/try.js makes a button.
"""

from __future__ import annotations

import json
import re
import shlex
from html import escape, unescape

__all__ = ["EXAMPLES", "command_lines", "marked", "runs"]

EXAMPLES = (
    ("The octahedral platform", 'gcrules analyze "ab af cb cd ed ef"'),
    ("A robot of joints", "gcrules robot analyze 3-rps"),
    ("An identity, proved", 'gcrules prove "ab /\\ cde == [acde] b - [bcde] a"'),
    ("An identity, refuted", 'gcrules prove "ab /\\ cde == [acde] b + [bcde] a"'),
    ("A condition with an assumption", 'gcrules prove "[abcd] == 0" --given "coplanar(a, b, c, d)"'),
    ("A superbracket in brackets", 'gcrules expand "[[ab, af, cb, cd, ed, ef]]"'),
    ("A factorization", 'gcrules factor "[abfc][acde][bdef] + [abfd][acbe][cdef]"'),
    ("The theorem of Desargues", "gcrules run examples/theorems/desargues.gca"),
    (
        "A script of statements",
        "# Brackets of the plane: rank 3\nrank 3\n\n"
        'claim "three-term relation": [abc][ade] - [abd][ace] + [abe][acd] == 0\n'
        'claim "a meet": ab /\\ cd == [acd] b - [bcd] a\n',
    ),
    ("A page of the catalog", "gcrules catalog show 6-5"),
)
"""Titles and texts of the page "Try it here"."""

COMMANDS = {
    "analyze",
    "catalog",
    "cite",
    "expand",
    "factor",
    "prove",
    "rewrite",
    "rules",
    "run",
    "straighten",
    "transversals",
}
ROBOT = {"analyze", "list", "show"}
WITHOUT = {"--cofactor", "3-upu", "4-rpr"}
"""Words with which a command needs what a page does not have: numbers beside the algebra, or more speed."""

CONSOLE = re.compile(r'<div class="language-console highlight">(<pre.*?</pre>)</div>', re.DOTALL)
SCRIPT = re.compile(
    r'<div class="language-gca highlight">((?:<span class="filename">[^<]*</span>)?)(<pre.*?</pre>)</div>', re.DOTALL
)
TAG = re.compile(r"<[^>]*>")


def command_lines(text: str) -> list[str]:
    """The commands of a console's text, without the prompt; those that go on in the next line are joined."""
    return [line[2:] for line in text.replace("\\\n", "").splitlines() if line.startswith("$ ")]


def runs(line: str) -> bool:
    """Whether the engine of the pages answers a command line."""
    if re.search(r"[|<>&;]", re.sub(r"\"[^\"]*\"|'[^']*'", "", line)):
        return False
    try:
        first, command, *rest = shlex.split(line)
    except ValueError:  # no command, or an open quotation mark
        return False
    if first != "gcrules" or WITHOUT & {command, *rest}:
        return False
    return command in COMMANDS or (command == "robot" and rest[:1] != [] and rest[0] in ROBOT)


def marked(html: str) -> str:
    """A page whose examples say how they run."""

    def console(match: re.Match[str]) -> str:
        lines = command_lines(_text(match[1]))
        if not lines or not all(map(runs, lines)):
            return match[0]
        return f'<div class="language-console highlight" data-run="{_attribute(lines)}">{match[1]}</div>'

    def script(match: re.Match[str]) -> str:
        text = _attribute([_text(match[2]).strip("\n")])
        return f'<div class="language-gca highlight" data-script="{text}">{match[1]}{match[2]}</div>'

    examples = json.dumps([{"title": title, "text": text} for title, text in EXAMPLES]).replace("<", "\\u003c")
    start = f'<div id="gc-try"><script type="application/json">{examples}</script>'
    return SCRIPT.sub(script, CONSOLE.sub(console, html)).replace('<div id="gc-try">', start)


def _text(html: str) -> str:
    return unescape(TAG.sub("", html))


def _attribute(lines: list[str]) -> str:
    return escape("\n".join(lines)).replace("\n", "&#10;")
