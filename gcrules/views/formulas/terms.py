"""Formulas as MathML, each term an element of its own, so that long ones break between terms."""

from __future__ import annotations

from gcrules.views.formulas.mathml import mathml_terms
from gcrules.views.report.items import Formula

__all__ = ["formula_html"]


def formula_html(item: Formula) -> str:
    """A paragraph with the formula."""
    left = [*mathml_terms(item.left), '<span class="gc-term"><math><mo>=</mo></math></span>'] if item.left else []
    return f'<p class="formula">{" ".join([*left, *mathml_terms(item.right)])}</p>'
