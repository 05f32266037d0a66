"""Faults of text that the grammar does not accept, in words, with what was expected and advice."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from difflib import get_close_matches
from typing import Any

from gcrules.algebra.space import shortened
from gcrules.core.english import listed
from gcrules.core.errors import Span, SyntaxFault

__all__ = ["call_hint", "syntax_fault", "words_of"]

_TERMINALS = {
    "WORD": "a point",
    "NUMBER": "a number",
    "STRING": "a label in quotes",
    "LPAR": "(",
    "RPAR": ")",
    "LSQB": "[",
    "RSQB": "]",
    "_MEET": "/\\",
    "_JOIN": "\\/",
    "PLUS": "+",
    "MINUS": "-",
    "STAR": "*",
    "_TIMES": "*",
    "COMMA": ",",
    "EQUAL": "=",
    "DOT": ".",
    "RUN": "a run of points (R...)",
    "RELATION": "a relation such as collinear(a, b, c)",
    "CONSTRUCTION": "a word such as midpoint(a, b)",
    "LETTERS": "line, plane, hyperplane, conic, quadric or screw",
    "$END": "the end",
}
_STARTERS = {"WORD", "NUMBER", "LPAR", "LSQB", "DOT", "RUN"}
_HINTS: tuple[tuple[re.Pattern[str], str], ...] = (
    (re.compile(r"=(?!=)"), "equality is written =="),
    (re.compile(r"\\(?!/)"), "join is \\/ (or ∨, \\vee), meet is /\\ (or ∧, ^, \\wedge)"),
    (re.compile(r"/(?!\\)"), "meet is /\\ ; fractions are written 1/2 without spaces"),
    (re.compile("[₀-₉¹²³⁴⁵ᵃᵇᶜᵈ]"), "the points of letters have no names that can be written"),
    (re.compile(r"[|&]"), "join is \\/ , meet is /\\"),
    (re.compile(r"[{}]"), "group with ( ) ; brackets of points are [ ]"),
    (re.compile(r"(?<=[0-9]\.)[0-9]"), "fractions are written 3/2"),
    (
        re.compile(r"==|!=|<|>"),
        "one == stands between two expressions, for `prove`, for `claim`, or alone at the prompt",
    ),
)
_NO_LETTER = re.compile(r"\s*(circle|sphere)\s+[A-Za-z]")
_CALL = re.compile(r"(?<![A-Za-z0-9_'])([A-Za-z_]+)\s*\(")
_INFIX = {
    **dict.fromkeys(("meet", "cap", "intersect", "intersection", "regressive", "wedge"), (" /\\ ", "the meet")),
    **dict.fromkeys(("join", "span", "cup", "vee", "outer"), (" \\/ ", "the join")),
}
_BETWEEN = {
    **dict.fromkeys(("det", "bracket", "determinant", "volume"), ("[{}]", "a bracket")),
    **dict.fromkeys(("superbracket", "pure"), ("[[{}]]", "the superbracket")),
}
"""Functions of other notations, and how their values are written."""
_NO_EXPRESSION = "{}(…) is a relation, not an expression: `prove` and `claim` decide it, `given` assumes it"
_LAST_WORD = re.compile(r"(?<![A-Za-z0-9_'])[A-Za-z][A-Za-z0-9_']*\Z")
_LONGEST = 30  # characters of a word that may be a relation misspelt


def syntax_fault(found: object, text: str, literals: Mapping[str, str], relations: Collection[str]) -> SyntaxFault:
    """The fault for an exception of lark; `literals` spells the terminals of the grammar, `relations` are those that
    may stand in this text.
    """
    from lark.exceptions import UnexpectedCharacters, UnexpectedToken

    if isinstance(found, UnexpectedToken) and found.token.type != "$END":
        token: Any = found.token
        span = Span(token.start_pos or 0, (token.start_pos or 0) + len(token))
        accepted = set(found.accepts or ())
        what = f"unexpected {shortened(found.token)!r}"
    elif isinstance(found, UnexpectedCharacters):
        at: Any = found.pos_in_stream
        span = Span(at, at + 1)
        accepted = set(found.allowed or ())
        what = f"unexpected character {text[span.start]!r}"
    else:
        span = Span(len(text.rstrip()), len(text.rstrip()))
        accepted = set(getattr(found, "accepts", None) or ())
        what = "the input ends too early" if text.strip() else "the input is empty"
    hint = _equated(text, span.start, relations)
    hint = hint or next((h for pattern, h in _HINTS if pattern.match(text, span.start)), None)
    hint = hint or _no_letter(text, span.start)
    hint = hint or _misspelt(text, span.start, words_of(literals["CONSTRUCTION"]), relations)
    if hint is None and "RPAR" in accepted and _unclosed(text[: span.start], "()"):
        hint = "a parenthesis is not closed"
    elif hint is None and "RSQB" in accepted and _unclosed(text[: span.start], "[]"):
        hint = "a bracket is not closed"
    return SyntaxFault(f"{what}; expected {_expected(accepted, literals)}", span=span, hint=hint)


def _no_letter(text: str, at: int) -> str | None:
    """What takes the place of letters that there are not, where the line up to a place declares one."""
    if not _NO_LETTER.match(text, text.rfind("\n", 0, at) + 1):
        return None
    of = "letters stand for lines, planes, screws, conics and quadrics"
    return f"{of}; a circle is a conic through the isotropic points"


def words_of(pattern: str) -> list[str]:
    """The words of a terminal of the grammar, which is one of several."""
    return pattern.partition(")")[0].lstrip("(").split("|")


def call_hint(text: str, at: int, relations: Collection[str]) -> str | None:
    """How a function of another notation is written whose name or arguments stand at a place: meet(ab, cde).

    `relations` are the names of those such as collinear(a, b, c), where they may not stand.
    """
    for found in _CALL.finditer(text, 0, at + 40):
        word, begin = found[1].lower(), found.end()
        if found.start() > at or word not in (*_INFIX, *_BETWEEN, *relations):
            continue
        end = _closing(text, begin)
        if at > end:
            continue
        arguments = [a.strip() for a in _apart(text[begin:end])]
        if word in relations:
            return _NO_EXPRESSION.format(word)
        if word in _BETWEEN:
            form, what = _BETWEEN[word]
            return f"{what} is written {form.format(', '.join(arguments) if all(arguments) else '…')}"
        operator, what = _INFIX[word]
        shown = [a if a.isalnum() else f"({a})" for a in arguments]
        written = operator.join(shown) if len(arguments) > 1 and all(arguments) else f"A{operator}B"
        return f"{what} is an operator between its parts: {written}"
    return None


def _closing(text: str, begin: int) -> int:
    """Where the parenthesis is closed that is open at `begin`, or the end of the text."""
    depth = 1
    for i in range(begin, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if not depth:
            return i
    return len(text)


def _apart(arguments: str) -> list[str]:
    """Arguments between commas that stand in no parenthesis or bracket."""
    parts, depth = [""], 0
    for c in arguments:
        depth += (c in "([") - (c in ")]")
        if c == "," and not depth:
            parts.append("")
        else:
            parts[-1] += c
    return parts


def _misspelt(text: str, at: int, constructions: Collection[str], relations: Collection[str]) -> str | None:
    """The word that is meant where a comma stands in parentheses behind one like it: colinear(a, b, c)."""
    word = _called(text, at) if text.startswith(",", at) else None
    if word is None or len(word) > _LONGEST:
        return None
    known = [*relations, *constructions]
    near = get_close_matches(word.lower(), known, n=1, cutoff=0.7)
    if word in known:
        return None
    if near:
        return f"did you mean {near[0]}(…)?"
    return f"{word}(…) is not a relation; the relations are {listed(list(relations))}" if relations else None


def _equated(text: str, at: int, relations: Collection[str]) -> str | None:
    """Advice where == stands behind a relation."""
    before = text[:at].rstrip()
    if not text.startswith("==", at) or not before.endswith(")"):
        return None
    word = _called(text, len(before) - 1)
    return _NO_EXPRESSION.format(word) if word in relations else None


def _called(text: str, at: int) -> str | None:
    """The word before the parenthesis that is open at a place."""
    open_at, depth = at, 1
    while depth and open_at:
        open_at -= 1
        depth += (text[open_at] == ")") - (text[open_at] == "(")
    before = _LAST_WORD.search(text[:open_at].rstrip())
    return None if depth or before is None else before[0]


def _unclosed(text: str, pair: str) -> bool:
    return text.count(pair[0]) > text.count(pair[1])


def _expected(accepted: set[str], literals: Mapping[str, str]) -> str:
    """The accepted terminals in words; the many ways to begin an expression become one."""
    names = []
    if accepted >= _STARTERS:
        names.append("an expression")
        accepted = accepted - _STARTERS - {"LSQB", "PLUS", "MINUS", "CONSTRUCTION"}
    names += sorted({_TERMINALS.get(t, literals.get(t, t.lower())) for t in accepted})
    return " or ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names) or "nothing more"
