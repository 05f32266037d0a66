"""Conditions, as text and as LaTeX."""

from __future__ import annotations

from gcrules.algebra.expr import Point, mul
from gcrules.algebra.language.text import text as expression_text
from gcrules.rules.condition import Condition
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text"]

_SUPERBRACKET = Point("superbracket")  # stands for that of the legs, which a condition does not know


def as_text(c: Condition, *, unicode: bool = False, names: tuple[str, ...] = ()) -> str:
    """The kind and the identity in the first line, the sentence in the second."""
    sides = (mul(c.cofactor, _SUPERBRACKET), c.right_side)
    left, right = (expression_text(e, unicode=unicode, names=names) for e in sides)
    return f"{c.kind}: {left} = {right}\n{c.sentence}"


def as_latex(c: Condition) -> str:
    """The identity, without dollar signs."""
    return f"{formulas.latex(mul(c.cofactor, _SUPERBRACKET))} = {formulas.latex(c.right_side)}"
