"""Bracket polynomials from texts."""

from __future__ import annotations

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expand import expand
from gcrules.algebra.language.syntax import parse

__all__ = ["polynomial"]


def polynomial(text: str) -> BracketPolynomial:
    """Expanded, not straightened."""
    found = expand(parse(text))
    assert isinstance(found, BracketPolynomial)
    return found
