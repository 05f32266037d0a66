r"""Expressions as LaTeX mathematics, in the notation of the papers.

>>> from gcrules.algebra.language.syntax import parse
>>> print(latex(parse(r"-2[abcd][.e f g S1][.h A' i j] - (ab /\ cd)")))
-2[abcd][\dot{e}fgS_{1}][\dot{h}A'ij] - ab \wedge cd
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.notation import Digits, Mark, Raised, Row, Sign, Term, parts, signs, split_name, terms

__all__ = ["latex", "latex_lines", "latex_name", "latex_parts", "latex_signs"]

_MARKS = {
    "∨": r" \vee ",
    "∧": r" \wedge ",
    "+": " + ",
    "−": " - ",
    "negative": "-",
    ",": r",\, ",
    "space": r"\,",
    "times": "",
    "[[": r"[\![",
    "]]": r"]\!]",
}


def latex(e: Expr) -> str:
    """The LaTeX of an expression, without dollar signs; it needs no package beyond the mathematics of LaTeX itself."""
    return _spelled(signs(e))


def latex_signs(e: Expr) -> Iterator[tuple[Sign, str]]:
    """The signs of an expression, each with its LaTeX."""
    return ((sign, _sign(sign)) for sign in signs(e))


def latex_parts(e: Expr) -> Iterator[tuple[str, Expr]]:
    """The LaTeX in pieces after which a line may end, each with the expression that it shows; signs between operands
    stand at the beginning of a piece.
    """
    for term, part in parts(e):
        first = term[0].sign if isinstance(term[0], Mark) else ""
        yield (_LEADS[first] + _spelled(term[1:]) if first in _LEADS else _spelled(term)), part


_LEADS = {"+": "{}+", "−": "{}-", "∧": r"{}\wedge ", "∨": r"{}\vee "}


def latex_lines(e: Expr, width: int = 60) -> list[str]:
    r"""A sum broken into lines for an `aligned` environment, each starting with `&`.

    `width` is the number of printed signs to a line (a bracket of four points has 6). A single term that is wider is
    broken before ∧, ∨ and parentheses; what cannot be broken may stay wider.
    Join the lines with `\\`. An expression that is no sum is one line.
    """
    lines: list[str] = []
    used = 0
    for term in terms(e):
        size = _width(term)
        if not lines or used + size > width:
            lines.append("&" + ("{}" if lines else "") + _spelled(term).lstrip())
            used = size
        else:
            lines[-1] += _spelled(term)
            used += size
    return [part for line in lines for part in _broken(line, width)]


_BREAKS = re.compile(r"(?= \\(?:wedge|vee)(?![A-Za-z]))|(?<=\))(?=[(\[])|(?<=\])(?=\()")
_COMMANDS = re.compile(r"\\[A-Za-z]+|\\.|[{}&_^]")


def _broken(line: str, width: int) -> Iterator[str]:
    """A line and its continuations, each about as wide as allowed."""
    now, used = "", 0
    for piece in _BREAKS.split(line):
        size = len(_COMMANDS.sub(lambda m: "+++" if m[0] in (r"\wedge", r"\vee") else "", piece).replace(" ", ""))
        outside = now.count("{") == now.count("}")  # a group of braces stays on its line
        if now and outside and used + size > width * 5 // 4:
            yield now
            now, used = r"&\quad{}", 2
        now += piece
        used += size
    yield now


def latex_name(name: str, dotted: bool = False) -> str:
    r"""The LaTeX of the name of a point.

    >>> latex_name("S_2"), latex_name("a1'", dotted=True), latex_name("top_left")
    ('S_{2}', "\\dot{a}_{1}'", '\\mathit{top\\_left}')
    """
    stem, digits, primes = split_name(name)
    if len(stem) > 1:
        stem = rf"\mathit{{{stem}}}".replace("_", r"\_")
    if dotted:
        stem = rf"\dot{{{stem}}}"
    return stem + (f"_{{{digits}}}" if digits else "") + primes


def _spelled(term: Term) -> str:
    return "".join(map(_sign, term))


def _sign(sign: Sign) -> str:
    match sign:
        case Row():
            return (r"\," if sign.words else "").join(latex_name(n, d) for n, d in sign.dotted)
        case Digits(value=Fraction(numerator=above, denominator=below)) if below != 1:
            return rf"\frac{{{above}}}{{{below}}}"
        case Digits(value=value):
            return str(value)
        case Raised(base=base, exponent=exponent):
            return f"{{{_spelled(base)}}}^{{{exponent}}}"
        case Mark(sign=mark):
            return _MARKS.get(mark, mark)


def _width(term: Term) -> int:
    """Printed signs, a fraction counted by its longer part."""
    return sum(_sign_width(s) for s in term)


def _sign_width(sign: Sign) -> int:
    match sign:
        case Row(names=names):
            return sum(map(len, names)) + sign.words * (len(names) - 1)
        case Digits(value=value):
            return max(len(str(value.numerator)), len(str(value.denominator)))
        case Raised(base=base):
            return _width(base) + 1
        case Mark(sign=mark):
            return 3 if mark in "∨∧+−" else int(mark != "times")
