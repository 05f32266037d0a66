"""An analysis as a LaTeX document."""

from __future__ import annotations

from gcrules.analysis import Analysis
from gcrules.render.latex import latex, latex_lines
from gcrules.render.stages import Fact, Formula, Item, stages

__all__ = ["as_latex"]


def as_latex(a: Analysis) -> str:
    """A document for the article class with amsmath."""
    body = []
    for stage in stages(a):
        body.append(f"\\section*{{{_escaped(stage.title)}}}")
        if stage.why:
            body.append(_escaped(stage.why) + "\\par")
        body += map(_item, stage.items)
    preamble = [
        "\\documentclass{article}",
        "\\usepackage[T1]{fontenc}",
        "\\usepackage[utf8]{inputenc}",
        "\\usepackage{amsmath}",
        "\\allowdisplaybreaks",
        "\\setlength{\\parindent}{0pt}",
    ]
    return "\n".join([*preamble, "\\begin{document}", *body, "\\end{document}", ""])


def _item(item: Item) -> str:
    match item:
        case Formula():
            return _formula(item)
        case Fact(key=key, value=value):
            return f"{_escaped(key)}: {_escaped(value)}\\par"
    return f"{_escaped(item)}\\par"


def _formula(item: Formula) -> str:
    lines = latex_lines(item.right)
    if item.left is not None:
        left = latex(item.left)
        lines = [f"{left} ={{}}& {lines[0].lstrip('&')}", *lines[1:]] if len(lines) == 1 else [f"&{left} = ", *lines]
    return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"


_LATEX = {
    "\\": "\\textbackslash{}",
    "{": "\\{",
    "}": "\\}",
    "_": "\\_",
    "^": "\\^{}",
    "&": "\\&",
    "#": "\\#",
    "%": "\\%",
    "$": "\\$",
    "→": "$\\to$",
    "∧": "$\\wedge$",
    "∨": "$\\vee$",
}


def _escaped(words: str) -> str:
    return "".join(_LATEX.get(c, c) for c in words)
