"""The generated parts of the page on grammar and messages: railroad diagrams of the grammar, and every tested fault.

Everything is read: rules, terminals and comments from `gcrules/grammar.lark` (with lark's own grammar of grammars), the
faults from the table that the tests use. A new rule or case appears by itself.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from html import escape
from itertools import pairwise
from pathlib import Path
from typing import Any

import yaml
from lark import Lark, Token, Tree

from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import GcrulesError

ROOT = Path(__file__).resolve().parent.parent
GRAMMAR = ROOT / "gcrules" / "grammar.lark"
FAULTS = ROOT / "tests" / "data" / "faults.yaml"


# --- reading the grammar -------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Definition:
    """A rule or a terminal of the grammar, with the comment above it."""

    name: str
    body: Tree[Any] | Token
    comment: str

    @property
    def label(self) -> str:
        return self.name.lstrip("_?!")

    @property
    def terminal(self) -> bool:
        return self.label.isupper()


@cache
def definitions() -> tuple[Definition, ...]:
    """What the grammar defines, in its sequence."""
    text = GRAMMAR.read_text(encoding="utf-8")
    grammars = Lark.open_from_package(
        "lark", "lark.lark", ["grammars"], parser="lalr", maybe_placeholders=False, propagate_positions=True
    )
    found = []
    lines = text.splitlines()
    for tree in grammars.parse(text + "\n").children:
        if not isinstance(tree, Tree) or tree.data not in ("rule", "token"):
            continue
        name, *_, body = tree.children
        found.append(Definition(str(name), body, _comment_above(lines, tree.meta.line - 1)))
    return tuple(found)


def _comment_above(lines: Sequence[str], index: int) -> str:
    """The comment lines directly above a definition, without those that open the file."""
    words: list[str] = []
    while index > 0 and lines[index - 1].startswith("//"):
        index -= 1
        words.insert(0, lines[index].lstrip("/ "))
    return " ".join(words) if index else ""


# --- railroad diagrams ---------------------------------------------------------------------------------------------

_CHAR = 8.4  # the advance of the code face at 14 px
_GAP = 12.0
_ROW = 30.0
_R = 8.0


@dataclass(frozen=True)
class Rail:
    """A piece of a diagram: it runs from (x, y) to (x + width, y) and needs room above and below its track."""

    width: float
    up: float
    down: float
    svg: Callable[[float, float], str]


def _n(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")


def _track(*path: object) -> str:
    words = " ".join(p if isinstance(p, str) else _n(float(p)) for p in path)  # type: ignore[arg-type]
    return f'<path class="track" d="{words}"/>'


def _box(text: str, kind: str, link: str = "") -> Rail:
    width = max(len(text) * _CHAR + 18, 28)

    def svg(x: float, y: float) -> str:
        radius = 11 if kind == "literal" else 3
        body = (
            f'<rect class="{kind}" x="{_n(x)}" y="{_n(y - 11)}" width="{_n(width)}" height="22" rx="{radius}"/>'
            f'<text class="{kind}" x="{_n(x + width / 2)}" y="{_n(y + 4.6)}">{escape(text)}</text>'
        )
        return f'<a href="{link}">{body}</a>' if link else body

    return Rail(width, 13, 13, svg)


def _sequence(parts: Sequence[Rail]) -> Rail:
    def svg(x: float, y: float) -> str:
        out = []
        for i, part in enumerate(parts):
            if i:
                out.append(_track("M", x, y, "h", _GAP))
                x += _GAP
            out.append(part.svg(x, y))
            x += part.width
        return "".join(out)

    width = sum(p.width for p in parts) + _GAP * (len(parts) - 1)
    return Rail(width, max(p.up for p in parts), max(p.down for p in parts), svg)


def _skip() -> Rail:
    return Rail(0.0, 0.0, 0.0, lambda x, y: "")


def _choice(parts: Sequence[Rail]) -> Rail:
    """The first on the track, the others below it."""
    inner = max(p.width for p in parts)
    drops = [0.0]
    for before, part in pairwise(parts):
        drops.append(drops[-1] + max(before.down, 4.0) + max(part.up, 4.0) + 4.0)
    side = 2 * _R + 4

    def svg(x: float, y: float) -> str:
        out = []
        for part, drop in zip(parts, drops, strict=True):
            end = x + side + inner
            if drop == 0:
                out.append(_track("M", x, y, "h", side))
                out.append(_track("M", x + side + part.width, y, "H", end + side))
            else:
                fall = drop - 2 * _R
                out.append(
                    _track("M", x, y, "h", 4, "q", _R, 0, _R, _R, "v", fall, "q", 0, _R, _R, _R)
                    + _track(
                        "M",
                        x + side + part.width,
                        y + drop,
                        "H",
                        end,
                        "q",
                        _R,
                        0,
                        _R,
                        -_R,
                        "v",
                        -fall,
                        "q",
                        0,
                        -_R,
                        _R,
                        -_R,
                    )
                    + _track("M", end + 2 * _R, y, "h", 4)
                )
            out.append(part.svg(x + side, y + drop))
        return "".join(out)

    return Rail(inner + 2 * side, parts[0].up, drops[-1] + parts[-1].down, svg)


def _loop(part: Rail, back: Rail | None) -> Rail:
    """The part once or more; on the way back stands what comes between."""
    back = back or _skip()
    inner = max(part.width, back.width)
    drop = part.down + max(back.up, 4.0) + 4.0
    side = _R + 6

    def svg(x: float, y: float) -> str:
        left, right = x + side, x + side + inner
        first = left + (inner - part.width) / 2
        second = left + (inner - back.width) / 2
        fall = drop - 2 * _R
        return (
            _track("M", x, y, "H", first)
            + part.svg(first, y)
            + _track("M", first + part.width, y, "H", right + side)
            + _track("M", right, y, "q", _R, 0, _R, _R, "v", fall, "q", 0, _R, -_R, _R, "H", second + back.width)
            + back.svg(second, y + drop)
            + _track("M", second, y + drop, "H", left, "q", -_R, 0, -_R, -_R, "v", -fall, "q", 0, -_R, _R, -_R)
        )

    return Rail(inner + 2 * side, part.up, drop + max(back.down, 4.0), svg)


def _rail(node: Tree[Any] | Token) -> Rail:
    if isinstance(node, Token):
        raise TypeError(f"a bare token {node!r} in the grammar of grammars")
    match node.data:
        case "literal" | "literal_range":
            return _box(_spelling(node.children[0]), "literal")
        case "name":
            name = str(node.children[0]).lstrip("_?!")
            return _box(name, "terminal" if name.isupper() else "rule", f"#{_anchor(name)}")
        case "alias":
            return _rail(node.children[0])
        case "expansions":
            return _choice([_rail(c) for c in node.children if isinstance(c, Tree)])
        case "expansion":
            return _expansion([c for c in node.children if isinstance(c, Tree)])
        case "maybe":
            return _choice([_skip(), _rail(node.children[0])])
        case "expr":
            body, operator = node.children[0], str(node.children[1])
            inner = _rail(body)
            return {
                "?": lambda: _choice([_skip(), inner]),
                "*": lambda: _choice([_skip(), _loop(inner, None)]),
                "+": lambda: _loop(inner, None),
            }[operator]()
    raise TypeError(f"cannot draw {node.data} of the grammar of grammars")


def _expansion(parts: list[Tree[Any]]) -> Rail:
    """A sequence; `x (s x)*` becomes a loop through x with s on the way back."""
    if not parts:
        return _skip()
    rails: list[Rail] = []
    for part in parts:
        body = part.children[0] if part.data == "expr" and str(part.children[1]) == "*" else None
        if isinstance(body, Tree) and body.data == "expansion" and len(body.children) == 2 and rails:
            separator, again = body.children
            before = parts[parts.index(part) - 1]
            if again == before:
                rails[-1] = _loop(rails[-1], _rail(separator))
                continue
        rails.append(_rail(part))
    return _sequence(rails)


def _spelling(token: Token | Tree[Any]) -> str:
    text = str(token)
    if text.startswith("/"):
        return text if len(text) <= 60 else text[:57] + "…"
    return text[1:-1].replace("\\\\", "\\").replace('\\"', '"')


def _anchor(label: str) -> str:
    return f"{'terminal' if label.isupper() else 'rule'}-{label.lower().replace('_', '-')}"


def railroad(definition: Definition) -> str:
    """The diagram of a rule as SVG; the colours are those of the page."""
    rail = _rail(definition.body)
    pad, lead = 8.0, 16.0
    width = rail.width + 2 * (pad + lead)
    y = pad + max(rail.up, 13.0)
    height = y + max(rail.down, 13.0) + pad
    start, end = pad + lead, pad + lead + rail.width
    body = (
        "".join(f'<circle class="stop" cx="{_n(x)}" cy="{_n(y)}" r="4"/>' for x in (pad, end + lead))
        + _track("M", pad + 4, y, "H", start)
        + rail.svg(start, y)
        + _track("M", end, y, "H", end + lead - 4)
    )
    return (
        f'<svg class="gc-rail" viewBox="0 0 {_n(width)} {_n(height)}" width="{_n(width)}" height="{_n(height)}" '
        f'role="img" aria-label="Diagram of the rule {escape(definition.label)}">{body}</svg>'
    )


# --- the parts of the page -----------------------------------------------------------------------------------------


def rules_html() -> str:
    """A heading and a diagram for each rule."""
    out = []
    for d in definitions():
        if d.terminal or _renames_itself(d):
            continue
        out.append(f'<h3 id="{_anchor(d.label)}"><code>{escape(d.label)}</code></h3>')
        if d.comment:
            out.append(f"<p>{_code(d.comment)}</p>")
        out.append(f'<div class="gc-rule">{railroad(d)}</div>')
    return "\n".join(out)


def _renames_itself(d: Definition) -> bool:
    """Whether a rule only stands for one with the same label, as `_item: item` does."""
    body = d.body
    return isinstance(body, Tree) and body.data == "name" and str(body.children[0]).lstrip("_?!") == d.label


def terminals_html() -> str:
    """The table of terminals: their spellings, or the pattern they match."""
    rows = []
    for d in definitions():
        if not d.terminal:
            continue
        literals = d.body.find_data("literal") if isinstance(d.body, Tree) else ()
        spellings = " ".join(f"<code>{escape(_spelling(t.children[0]))}</code>" for t in literals)
        cells = "".join(f"<td>{cell}</td>" for cell in (f"<code>{d.label}</code>", spellings, _code(d.comment)))
        rows.append(f'<tr id="{_anchor(d.label)}">{cells}</tr>')
    head = "<thead><tr><th>name</th><th>written</th><th>note</th></tr></thead>"
    return f"<table>{head}<tbody>" + "\n".join(rows) + "</tbody></table>"


def _code(text: str) -> str:
    """A comment of the grammar as HTML: what stands between backticks or looks like [R... a b] is code."""
    return re.sub(r"`([^`]+)`|(\[R\.\.\.[^\]]*\])", lambda m: f"<code>{m[1] or m[2]}</code>", escape(text))


def faults_html(part: str) -> str:
    """The table of tested faults: what is typed, and the whole message with place, caret and hint."""
    readers: dict[str, Callable[[str], object]] = {
        "expressions": parse,
        "scripts": lambda source: parse_script(source, "file.gca"),
    }
    reader = readers[part]
    rows = []
    for case in yaml.safe_load(FAULTS.read_text(encoding="utf-8"))[part]:
        source = case["source"]
        text = source if isinstance(source, str) else source.get("before", "") + source["repeat"] * source["times"]
        try:
            reader(text)
        except GcrulesError as fault:
            message = fault.render()
        else:
            raise ValueError(f"the case {case['id']!r} of {FAULTS.name} is no fault")
        shown = text if len(text) <= 80 else f"{text[:24]}… ({len(text):,} characters)"
        shown = "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in shown) or "(nothing)"
        typed, said = (f"<pre><code>{escape(part)}</code></pre>" for part in (shown, message))
        rows.append(f"<tr><td>{escape(case['id'])}{typed}</td><td>{said}</td></tr>")
    head = "<thead><tr><th>typed</th><th>what gcrules says</th></tr></thead>"
    return f'<div class="gc-faults"><table>{head}<tbody>' + "\n".join(rows) + "</tbody></table></div>"


PARTS: dict[str, Callable[[], str]] = {
    "grammar-rules": rules_html,
    "grammar-terminals": terminals_html,
    "faults-expressions": lambda: faults_html("expressions"),
    "faults-scripts": lambda: faults_html("scripts"),
}
"""Name in the pages (`<!-- generated: NAME -->`): function that makes the HTML."""
