r"""Derivations as chains of equal expressions, with the reason below each: text, LaTeX.

>>> from gcrules.algebra.language.syntax import parse
>>> from gcrules.rules.derivation import Derivation, Step
>>> d = Derivation((Step("expansion", parse(r"ab /\ cde"), parse("[acde] b - [bcde] a"), "by shuffles"),))
>>> print(as_text(d))
ab /\ cde
  = [acde] * b - [bcde] * a
      by expansion: by shuffles
>>> print(as_aligned(d))
\begin{aligned}
&ab \wedge cde \\
&= [acde]\,b - [bcde]\,a \\
&\quad\text{by expansion: by shuffles}
\end{aligned}
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from textwrap import wrap

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text, text_terms
from gcrules.rules.derivation import Derivation
from gcrules.views.formulas.latex import latex, latex_lines
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["as_align", "as_aligned", "as_text", "ascii_words", "reasons"]

_WIDTH = 100
_LATEX_WIDTH = 76  # characters of a line of reasons
_ASCII = str.maketrans(
    {"→": "->", "ü": "u", "–": "-", "⁹": "^9", "∧": "/\\", "∨": "\\/", "−": "-", "·": "*", "×": "x", "…": "..."}
)


def as_text(d: Derivation, *, unicode: bool = False, full: bool = False) -> str:
    """The chain, with `full` every single step; the single steps of a longer step stand below its own reason. Formulas
    are text of the language.
    """
    d = d.unfolded() if full else d
    names = d.space.points
    if not d.steps:
        return ""
    lines = _formula(d.before, "", unicode, names)
    words = reasons(d)
    for step in d.steps:
        if step.steps:
            lines += ["", *_filled(f"{step.rule}: {step.why}".split(), "")]
        for single in step.steps or (step,):
            lines += _formula(single.after, "  = ", unicode, names)
            lines += _filled(next(words).split(), "      ")
        for e in step.assumed:
            lines += _filled(["assuming that", text(e, unicode=unicode, names=names), "is not 0"], "      ")
    found = "\n".join(lines)
    return found if unicode else ascii_words(found)


def ascii_words(words: str) -> str:
    """Words with arrows and the signs of the algebra spelled in ASCII."""
    return words.translate(_ASCII)


def reasons(d: Derivation) -> Iterator[str]:
    """ "by sorting: …", "by sorting, read backwards", for each single step; a rule is explained once."""
    explained = set()
    for step in d.steps:
        for single in step.steps or (step,):
            backwards = ", read backwards" if single.upward else ""
            why = f": {single.why}" if single.why and (single.rule, single.why) not in explained else ""
            explained.add((single.rule, single.why))
            yield f"by {single.rule}{backwards}{why}"


def as_align(d: Derivation) -> str:
    """The chain in an `align*` environment, which may break across pages."""
    return f"\\begin{{align*}}\n{_joined(d)}\n\\end{{align*}}"


def as_aligned(d: Derivation, *, full: bool = False) -> str:
    """The chain in an `aligned` environment, for a formula that is one display."""
    return f"\\begin{{aligned}}\n{_joined(d.unfolded() if full else d)}\n\\end{{aligned}}"


def _joined(d: Derivation) -> str:
    return " \\\\\n".join(_latex_rows(d))


def _latex_rows(d: Derivation) -> Iterator[str]:
    if d.steps:
        yield from latex_lines(d.before)
    words = reasons(d)
    for step in d.steps:
        if step.steps:
            yield from _words(f"{step.rule}: {step.why}", "")
        for single in step.steps or (step,):
            first, *others = latex_lines(single.after)
            yield f"&= {first.removeprefix('&')}"
            yield from (f"&\\quad {line.removeprefix('&')}" for line in others)
            yield from _words(next(words), "\\quad")
        for e in step.assumed:
            yield f"&\\quad\\text{{assuming that }} {latex(e)} \\neq 0"


def _words(words: str, indent: str) -> Iterator[str]:
    return (f"&{indent}\\text{{{latex_words(line)}}}" for line in wrap(words, _LATEX_WIDTH))


def _formula(e: Expr, start: str, unicode: bool, names: tuple[str, ...]) -> list[str]:
    """An expression behind `start`, broken between its terms, inside them only where one is too long for a line."""
    room = _WIDTH - 8
    pieces = text_terms(e, unicode=unicode, names=names)
    words = [w for p in pieces for w in ([p] if len(p) <= room else p.split())]
    return _filled(words, start, " " * len(start) + "  ")


def _filled(words: Iterable[str], indent: str, later: str | None = None) -> list[str]:
    lines = [indent]
    empty = True
    for word in words:
        if not empty and len(lines[-1]) + 1 + len(word) > _WIDTH:
            lines.append(indent + "  " if later is None else later)
            empty = True
        lines[-1] += word if empty else f" {word}"
        empty = False
    return lines
