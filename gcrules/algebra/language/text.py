r"""Expressions as text of the language, in plain ASCII (parses back to the same value) or in Unicode mathematics."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gcrules.algebra.expr import MAX_COEFFICIENT_BITS, Expr
from gcrules.algebra.language.notation import Digits, Mark, Raised, Row, Sign, Term, signs, terms
from gcrules.algebra.letters import marked
from gcrules.core.dataclass import dataclass

__all__ = ["SHORT_NAME", "Names", "number_text", "split_names", "text", "text_terms"]

SHORT_NAME = re.compile(r"[A-Za-z](?:_?[0-9]+)?'*")
"""Names that need no declaration: a letter, digits (after an underscore if you like), primes."""


@dataclass(frozen=True, slots=True)
class _Style:
    """How `marks` are written, whether dots stand above letters, whether points are set apart by spaces."""

    marks: Mapping[str, str]
    accents: bool
    spaced: bool


_UNICODE = {"∨": " ∨ ", "∧": " ∧ ", "+": " + ", "−": " − ", "negative": "−", ",": ", ", "times": " · ", "space": " · "}
_ASCII = _UNICODE | {"∨": " \\/ ", "∧": " /\\ ", "−": " - ", "negative": "-", "times": " * ", "space": " * "}

Names = str | Iterable[str]


def split_names(names: Names) -> tuple[str, ...]:
    """Names of points from text ("left right", commas allowed) or from a sequence.

    >>> split_names("left, right"), split_names(["a", "b"])
    (('left', 'right'), ('a', 'b'))
    """
    return tuple(names.replace(",", " ").split() if isinstance(names, str) else names)


def text(e: Expr, *, unicode: bool = False, names: Iterable[str] = ()) -> str:
    r"""The text of an expression.

    `names` are the declared points: if one of them is longer than a letter with digits, points are set apart by
    spaces, so that the text parses back under the same declarations.

    >>> from gcrules.algebra.language.syntax import parse
    >>> print(text(parse("-2[abcd](ab ∧ cde)f")))
    -2[abcd] * ((ab /\ cde) \/ f)
    >>> print(text(parse(r"ab /\ cde"), unicode=True))
    ab ∧ cde
    """
    return _spelled(signs(e), _style(unicode, names))


def text_terms(e: Expr, *, unicode: bool = False, names: Iterable[str] = ()) -> list[str]:
    """The terms of a sum, each later one with its sign in front and a space behind that; else the whole.

    >>> from gcrules.algebra.language.syntax import parse
    >>> text_terms(parse("-[abcd] - 2[abce] + [abcf]"))
    ['-[abcd]', '- 2[abce]', '+ [abcf]']
    """
    style = _style(unicode, names)
    return [_spelled(term, style).strip() for term in terms(e)]


def _style(unicode: bool, names: Iterable[str]) -> _Style:
    return _Style(
        _UNICODE if unicode else _ASCII, unicode, not all(SHORT_NAME.fullmatch(n) or marked(n) for n in names)
    )


def _spelled(term: Term, style: _Style) -> str:
    out: list[str] = []
    opened = False  # just now: [[ begins a superbracket, so a bracket in a bracket stands apart
    for sign in term:
        piece = _sign(sign, style)
        out.append(f" {piece}" if opened and piece[0] == "[" else piece)
        opened = piece == "["
    return "".join(out)


def _sign(sign: Sign, style: _Style) -> str:
    match sign:
        case Row(names=names, dots=dots):
            return _dotted(sign, style) if dots else _side_by_side(names, style.spaced)
        case Digits(value=value):
            return str(value)
        case Raised(base=base, exponent=exponent):
            return f"{_spelled(base, style)}**{exponent}"
        case Mark(sign=mark):
            return style.marks.get(mark, mark)


def _side_by_side(names: Sequence[str], spaced: bool) -> str:
    return (" " if spaced or not all(map(SHORT_NAME.fullmatch, names)) else "").join(names)


def _dotted(row: Row, style: _Style) -> str:
    """A dot before the letter, or above it in Unicode."""
    if not style.accents or not all(map(SHORT_NAME.fullmatch, row.names)):
        return " ".join("." * d + n for n, d in row.dotted)
    words = [unicodedata.normalize("NFC", f"{n[0]}\u0307{n[1:]}") if d else n for n, d in row.dotted]
    return (" " if style.spaced else "").join(words)


def number_text(value: Any) -> str:
    """A number, or a tuple of them; of one that is very long only its size."""
    if isinstance(value, tuple):
        return f"({', '.join(map(number_text, value))})"
    bits = max(abs(value.numerator), value.denominator).bit_length()
    return str(value) if bits <= MAX_COEFFICIENT_BITS else f"a number of {bits:,} bits"
