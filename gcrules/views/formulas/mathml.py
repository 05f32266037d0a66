r"""Expressions as presentation MathML for HTML5.

>>> from gcrules.algebra.language.syntax import parse
>>> mathml(parse("a"))
'<math><mrow><mi>a</mi></mrow></math>'
"""

from __future__ import annotations

from fractions import Fraction
from html import escape

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.notation import Digits, Mark, Raised, Row, Sign, Term, signs, split_name, terms

__all__ = ["mathml", "mathml_terms"]

_MARKS = {
    "∨": "<mo>∨</mo>",
    "∧": "<mo>∧</mo>",
    "+": '<mo form="infix">+</mo>',
    "−": '<mo form="infix">−</mo>',
    "negative": '<mo form="prefix">−</mo>',
    ",": '<mo separator="true">,</mo>',
    "space": '<mspace width="0.17em"></mspace>',
    "times": "",
    "[[": '<mo fence="true" stretchy="false" form="prefix">⟦</mo>',
    "]]": '<mo fence="true" stretchy="false" form="postfix">⟧</mo>',
    "[": '<mo fence="true" stretchy="false" form="prefix">[</mo>',
    "]": '<mo fence="true" stretchy="false" form="postfix">]</mo>',
    "(": '<mo fence="true" stretchy="false" form="prefix">(</mo>',
    ")": '<mo fence="true" stretchy="false" form="postfix">)</mo>',
}


def mathml(e: Expr, display: bool = False) -> str:
    """One `<math>` element; `display` asks for a block of its own. It does not break across lines."""
    opening = '<math display="block">' if display else "<math>"
    return f"{opening}{_row(signs(e))}</math>"


def mathml_terms(e: Expr) -> list[str]:
    """A sum as inline pieces, one for each term with its sign, that a narrow column can wrap between.

    Join them with a space. Each piece is `<span class="gc-term"><math>…</math></span>`.
    """
    return [f'<span class="gc-term"><math>{_row(term)}</math></span>' for term in terms(e)]


def _row(term: Term) -> str:
    return f"<mrow>{''.join(map(_sign, term))}</mrow>"


def _sign(sign: Sign) -> str:
    match sign:
        case Row():
            return (_MARKS["space"] if sign.words else "").join(_name(n, d) for n, d in sign.dotted)
        case Digits(value=Fraction(numerator=above, denominator=below)) if below != 1:
            return f"<mfrac><mn>{above}</mn><mn>{below}</mn></mfrac>"
        case Digits(value=value):
            return f"<mn>{value}</mn>"
        case Raised(base=base, exponent=exponent):
            return f"<msup>{_row(base)}<mn>{exponent}</mn></msup>"
        case Mark(sign=mark):
            return _MARKS[mark]


def _name(name: str, dotted: bool) -> str:
    stem, digits, primes = split_name(name)
    out = f"<mi>{escape(stem)}</mi>"
    if dotted:
        out = f'<mover accent="true">{out}<mo stretchy="false">˙</mo></mover>'
    prime = f"<mo>{'′' * len(primes)}</mo>"
    if digits and primes:
        return f"<msubsup>{out}<mn>{digits}</mn>{prime}</msubsup>"
    if digits:
        return f"<msub>{out}<mn>{digits}</mn></msub>"
    return f"<msup>{out}{prime}</msup>" if primes else out
