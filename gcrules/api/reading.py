"""What public functions read expressions by."""

from __future__ import annotations

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.statements import parse_letters
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.language.text import Names, split_names
from gcrules.algebra.language.words import METRICS, with_infinity

__all__ = ["expression_of", "where"]


def where(
    rank: int | None, points: Names, ideal: Names, isotropic: Names, orthonormal: Names, letters: str = ""
) -> Context:
    """Where expressions are read."""
    at = Context(rank or 4, split_names(points), split_names(ideal))
    for kind, names in zip(METRICS, (isotropic, orthonormal), strict=True):
        at = with_infinity(at, kind, found) if (found := split_names(names)) else at
    return parse_letters(letters, at) if letters else at


def expression_of(e: str | Expr, at: Context) -> Expr:
    return e if isinstance(e, Expr) else parse(e, context=at)
