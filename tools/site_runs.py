"""Which examples of the guide run in its pages, and how: what the engine of site_engine.py answers.

A block of a console gets the attribute `data-run` with its command lines, a script of statements `data-script` and an
example of Python `data-session` with its text, from which docs/assets/try/try.js makes a button. A block that does not
run here has `data-why`, which says why not. Whether commands run is known from their words; examples of Python have
been tried in the engine.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterable
from html import escape, unescape

__all__ = ["EXAMPLES", "command_lines", "marked", "sessions", "why_not", "why_not_session"]

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
    "discover",
    "expand",
    "factor",
    "factors",
    "prove",
    "rewrite",
    "rules",
    "run",
    "straighten",
    "transversals",
}
ROBOT = {"analyze", "list", "new", "show"}
WITHOUT = {"3-upu", "4-rpr"}
"""Robots whose analysis computes with numbers too."""

ELSEWHERE = ": run it on your machine."
NUMPY = f"Needs NumPy{ELSEWHERE}"
SHELL = f"Needs a shell{ELSEWHERE}"
SYMPY = f"Needs SymPy{ELSEWHERE}"
LONG = f"Takes a minute here{ELSEWHERE}"
NOTEBOOK = f"Needs a notebook{ELSEWHERE}"
EARLIER = f"Goes on from an example that does not run here{ELSEWHERE}"
TEN_POINTS = {"factor": SYMPY, "shorten": LONG}
"""Why commands about ten points on a quadric do not run, which take longer than about others."""
NAMES = {"numpy": "NumPy", "networkx": "NetworkX", "sympy": "SymPy", "scipy": "SciPy"}

CONSOLE = re.compile(r'<div class="language-console highlight">(<pre.*?</pre>)</div>', re.DOTALL)
SHELLS = re.compile(r'<div class="language-sh highlight">')
PYTHON = re.compile(r'<div class="language-pycon highlight">(<pre.*?</pre>)</div>', re.DOTALL)
SCRIPT = re.compile(
    r'<div class="language-gca highlight">((?:<span class="filename">[^<]*</span>)?)(<pre.*?</pre>)</div>', re.DOTALL
)
TAG = re.compile(r"<[^>]*>")


def command_lines(text: str) -> list[str]:
    """The commands of a console's text, without the prompt; those that go on in the next line are joined."""
    return [line[2:] for line in text.replace("\\\n", "").splitlines() if line.startswith("$ ")]


def why_not(line: str) -> str:
    """Why the engine of the pages does not answer a command line; empty if it does."""
    if re.search(r"[|<>&;]", re.sub(r"\"[^\"]*\"|'[^']*'", "", line)):
        return SHELL
    try:
        first, command, *rest = shlex.split(line)
    except ValueError:  # no command, or an open quotation mark
        return SHELL
    if first != "gcrules":
        return SHELL
    if "--cofactor" in rest:
        return LONG
    if command in TEN_POINTS and any(word.startswith("quadric(") for word in rest):
        return TEN_POINTS[command]
    return "" if "--help" in rest or _algebra(command, rest) else NUMPY


def _algebra(command: str, rest: list[str]) -> bool:
    """Whether a command computes with symbols and exact numbers alone."""
    if WITHOUT & {*rest}:
        return False
    beside = {"robot": bool(ROBOT & {*rest[:1]}), "repl": "-e" in rest, "report": "--no-3d" in rest}
    return command in COMMANDS or beside.get(command, False)


def why_not_session(code: int, printed: str) -> str:
    """Why an example of Python does not run in a page, from its exit code and what it printed there; empty if it does.
    Raises ValueError where it should.
    """
    if code == 0:
        return ""
    if found := re.search(r"error: this answer needs (\w+),", printed):
        return f"Needs {NAMES[found[1]]}{ELSEWHERE}"
    if "No module named 'gcrules.apps.notebook'" in printed:
        return NOTEBOOK
    if re.search(r"^NameError: ", printed, re.MULTILINE):
        return EARLIER
    raise ValueError(f"an example fails in the engine of the guide's pages:\n{printed}")


def sessions(html: str) -> list[str]:
    """The examples of Python of a page, which are one session."""
    return [_text(match[1]).strip("\n") for match in PYTHON.finditer(html)]


def marked(html: str, reasons: Iterable[str] = ()) -> str:
    """A page whose examples say how they run. The reasons why its examples of Python do not are in their order."""
    left = iter(reasons)

    def console(match: re.Match[str]) -> str:
        lines = command_lines(_text(match[1]))
        why = next(filter(None, map(why_not, lines)), "")
        attribute = f'data-why="{why}"' if why else f'data-run="{_attribute(lines)}"'
        return f'<div class="language-console highlight" {attribute}>{match[1]}</div>' if lines else match[0]

    def python(match: re.Match[str]) -> str:
        why = next(left)
        attribute = f' data-why="{why}"' if why else ""
        text = _attribute([_text(match[1]).strip("\n")])
        return f'<div class="language-pycon highlight" data-session="{text}"{attribute}>{match[1]}</div>'

    def script(match: re.Match[str]) -> str:
        text = _attribute([_text(match[2]).strip("\n")])
        return f'<div class="language-gca highlight" data-script="{text}">{match[1]}{match[2]}</div>'

    examples = json.dumps([{"title": title, "text": text} for title, text in EXAMPLES]).replace("<", "\\u003c")
    start = f'<div id="gc-try"><script type="application/json">{examples}</script>'
    html = SHELLS.sub(f'<div class="language-sh highlight" data-why="{SHELL}">', html)
    html = PYTHON.sub(python, SCRIPT.sub(script, CONSOLE.sub(console, html)))
    return html.replace('<div id="gc-try">', start)


def _text(html: str) -> str:
    return unescape(TAG.sub("", html))


def _attribute(lines: list[str]) -> str:
    return escape("\n".join(lines)).replace("\n", "&#10;")
