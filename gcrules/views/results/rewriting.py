"""Rewritten expressions, as text and as LaTeX."""

from __future__ import annotations

from gcrules.algebra.language.text import text as expression_text
from gcrules.rules.rewriting import Rewriting
from gcrules.views.formulas import latex as formulas
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["as_latex", "as_text"]


def as_text(r: Rewriting, *, unicode: bool = False) -> str:
    """The chain of equal expressions, with the rule that made each of them."""
    names = r.space.points
    lines = [expression_text(r.before, unicode=unicode, names=names)]
    for step in r.steps:
        why = f": {step.why}" if step.why else ""
        lines += [f"  = {expression_text(step.after, unicode=unicode, names=names)}", f"      by {step.rule}{why}"]
        if step.assumed:
            shown = ", ".join(expression_text(e, unicode=unicode, names=names) for e in step.assumed)
            lines.append(f"      assumed not to vanish: {shown}")
    return "\n".join(lines if r.steps else [*lines, "  no rule fires"])


def as_latex(r: Rewriting) -> str:
    """The chain in an `aligned` environment (package amsmath), without dollar signs."""
    lines = [f"&{formulas.latex(r.before)}"]
    lines += [f"&={{}} {formulas.latex(s.after)} && \\text{{{latex_words(s.rule)}}}" for s in r.steps]
    return "\n".join(["\\begin{aligned}", " \\\\\n".join(lines), "\\end{aligned}"])
