"""An analysis as a LaTeX document."""

from __future__ import annotations

from gcrules.algebra.language.text import text
from gcrules.conditions.analysis import Analysis
from gcrules.views.formulas.latex import latex, latex_lines
from gcrules.views.formulas.latex_text import latex_document, latex_words
from gcrules.views.report.items import Formula, Item, KeyValue
from gcrules.views.report.stages import stages
from gcrules.views.results.derivation import as_align

__all__ = ["as_latex"]

_WIDTH = 75


def as_latex(a: Analysis, *, full: bool = False) -> str:
    """A document for the article class with amsmath; `full` adds every single step of the derivation."""
    body = []
    for stage in stages(a):
        body.append(f"\\section*{{{latex_words(stage.title)}}}")
        if stage.why:
            body.append(latex_words(stage.why) + "\\par")
        body += map(_item, stage.items)
    if full:
        body += ["\\section*{Derivation}", as_align(a.unfolded())]
    return latex_document(body)


def _item(item: Item) -> str:
    match item:
        case Formula():
            return _formula(item)
        case KeyValue(key=key, value=value):
            return f"{latex_words(key)}: {latex_words(value)}\\par"
    return f"{latex_words(item)}\\par"


def _formula(item: Formula) -> str:
    lines = latex_lines(item.right)
    if item.left is not None:
        left = latex(item.left)
        short = len(lines) == 1 and len(text(item.left)) + len(text(item.right)) < _WIDTH
        lines = [f"{left} ={{}}& {lines[0].lstrip('&')}"] if short else [f"&{left} = ", *lines]
    return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"
