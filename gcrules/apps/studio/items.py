"""What a stage is made of."""

from __future__ import annotations

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Expr
from gcrules.apps.studio.formulas import monomials, pieces
from gcrules.apps.studio.protocol.study_views import FactItem, FormulaItem, MonomialsItem, TextItem
from gcrules.views.numerals import in_prose

__all__ = ["fact", "formula", "sentence", "table"]


def sentence(words: str) -> TextItem:
    """A sentence."""
    return {"kind": "text", "text": words}


def fact(key: str, value: str) -> FactItem:
    """A key and its value, with numbers as pages show them."""
    return {"kind": "fact", "key": key, "value": in_prose(value)}


def formula(left: Expr | None, right: Expr) -> FormulaItem:
    """left = right, in pieces."""
    return {"kind": "formula", "left": [] if left is None else pieces(left), "right": pieces(right)}


def table(poly: BracketPolynomial, sign: int = 1) -> MonomialsItem:
    """The terms of a polynomial."""
    return {"kind": "monomials", "monomials": monomials(poly, sign)}
