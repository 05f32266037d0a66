r"""Expressions as text of the language, in plain ASCII (parses back to the same value) or in Unicode mathematics."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby

from gcrules.algebra.expr import (
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    neg,
)
from gcrules.core.budget import watched

__all__ = ["SHORT_NAME", "Names", "split_names", "text"]

SHORT_NAME = re.compile(r"[A-Za-z](?:_?[0-9]+)?'*")
"""Names that need no declaration: a letter, digits (after an underscore if you like), primes."""


@dataclass(frozen=True, slots=True)
class _Style:
    join: str
    meet: str
    minus: str
    times: str
    spaced: bool


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
    spaced = not all(SHORT_NAME.fullmatch(n) for n in names)
    style = _Style(" ∨ ", " ∧ ", "−", " · ", spaced) if unicode else _Style(" \\/ ", " /\\ ", "-", " * ", spaced)
    return _text(e, style)


def _text(e: Expr, style: _Style) -> str:
    match e:
        case Number(value=value):
            return str(value).replace("-", style.minus)
        case Point(name=name):
            return name
        case Join(args=args):
            if all(isinstance(a, Point) for a in args):
                return _points([_text(a, style) for a in args], style)
            return style.join.join(_runs(args, style))
        case Meet(args=args):
            return style.meet.join(_wrapped(a, style, Point, *([Join] if _plain(a) else [])) for a in args)
        case Bracket(args=args):
            if all(isinstance(a, Point) for a in args):
                return f"[{_points([_text(a, style) for a in args], style)}]"
            inner = ", ".join(_text(a, style) for a in args)
            return f"[ {inner}]" if inner.startswith("[") else f"[{inner}]"  # [[ begins a superbracket
        case Dotted(brackets=brackets):
            return "".join(f"[{_dotted(entries, style)}]" for entries in brackets)
        case Superbracket(lines=lines):
            return f"[[{', '.join(_text(a, style) for a in lines)}]]"
        case Power(base=base, exponent=exponent):
            return f"{_wrapped(base, style, Bracket, Superbracket)}**{exponent}"
        case Product(factors=factors):
            return _product(factors, style)
        case Sum(terms=terms):
            rest = (
                f" {style.minus} {_wrapped_sum(neg(t), style)}" if _negative(t) else f" + {_text(t, style)}"
                for t in watched(terms[1:])
            )
            return "".join((_text(terms[0], style), *rest))
    raise TypeError(f"not an expression: {e!r}")


def _points(names: list[str], style: _Style) -> str:
    spaced = style.spaced or not all(SHORT_NAME.fullmatch(n) for n in names)
    return (" " if spaced else "").join(names)


def _runs(args: tuple[Expr, ...], style: _Style) -> list[str]:
    """Arguments of a join as text, neighbouring points side by side."""
    found = []
    for is_point, run in groupby(args, lambda a: isinstance(a, Point)):
        words = [_text(a, style) if is_point else f"({_text(a, style)})" for a in run]
        found += [_points(words, style)] if is_point else words
    return found


def _plain(e: Expr) -> bool:
    return isinstance(e, Join) and all(isinstance(a, Point) for a in e.args)


def _dotted(entries: tuple[tuple[str, bool], ...], style: _Style) -> str:
    """A dot before the letter, or above it in Unicode."""
    if style.minus == "-" or not all(SHORT_NAME.fullmatch(n) for n, _ in entries):
        return " ".join("." * d + n for n, d in entries)
    words = [unicodedata.normalize("NFC", f"{n[0]}\u0307{n[1:]}") if d else n for n, d in entries]
    return (" " if style.spaced else "").join(words)


def _wrapped(e: Expr, style: _Style, *bare: type[Expr]) -> str:
    return _text(e, style) if isinstance(e, bare) else f"({_text(e, style)})"


def _wrapped_sum(e: Expr, style: _Style) -> str:
    return f"({_text(e, style)})" if isinstance(e, Sum) else _text(e, style)


def _negative(e: Expr) -> bool:
    first = e.factors[0] if isinstance(e, Product) else e
    return isinstance(first, Number) and first.value < 0


def _product(factors: tuple[Expr, ...], style: _Style) -> str:
    """Brackets stand side by side, a number in front of them; anything else is set apart by a product sign."""
    out = ""
    previous: Expr | None = None
    for f in watched(factors):
        match f:
            case Number(value=value):
                piece = style.minus if value == -1 else _text(f, style)
            case Bracket() | Superbracket() | Dotted() | Power() | Point():
                piece = _text(f, style)
            case Join() if _plain(f):
                piece = _text(f, style)
            case _:
                piece = f"({_text(f, style)})"
        tight = previous is None or previous == Number(-1)
        tight = tight or (isinstance(f, (Bracket, Superbracket, Meet, Sum)) and _closed(previous) and f.step == 0)
        out += piece if tight else style.times + piece
        previous = f
    return out


def _closed(e: Expr | None) -> bool:
    return isinstance(e, (Number, Bracket, Superbracket, Meet, Sum)) and e.step == 0
