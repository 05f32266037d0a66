r"""Formulas and sentences for columns of any width: TeX breaks them where a line may end.

>>> from gcrules.algebra.language.syntax import parse
>>> print(breakable(parse(r"abc /\ ade - [abcd]ef")))
abc\gclessbreak{}\wedge ade\gcbreak{}-[abcd]\gclessbreak\,ef
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from gcrules.algebra.expr import Expr, Meet
from gcrules.rules.statement import Flat, Statement
from gcrules.views.formulas.latex import latex_name, latex_parts
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["MACROS", "breakable", "displayed", "equation", "inline", "itemized", "named_words", "sentence"]

MACROS = r"""\providecommand{\gcbreak}{\penalty0\relax}
\providecommand{\gclessbreak}{\penalty300\relax}
\providecommand{\gcraggedright}{\raggedright\hangindent=1.5em\hangafter=1\binoppenalty=10000\relpenalty=10000\relax}
\providecommand{\gcformula}[1]{% in one line, or broken where it is wider than the column
  \setbox0=\hbox{$#1$}%
  \ifdim\wd0<0.86\linewidth\copy0\else\parbox{0.86\linewidth}{\gcraggedright$#1$}\fi}
\providecommand{\gclong}[1]{\par{\gcraggedright\leftskip=1em\noindent$#1$\par}}"""
"""Definitions that a section begins with; an author may define them otherwise before."""


def breakable(e: Expr) -> str:
    """An expression, without dollar signs, with the places where a line may end."""
    parts = [part for part, _ in latex_parts(e)]
    joined = "".join(("" if not n else _place(part)) + part for n, part in enumerate(parts))
    return _spaced(joined)


def _place(part: str) -> str:
    """The place before a part: rather before + and − than before a meet."""
    return r"\gclessbreak" if part.startswith(r"{}\wedge") else r"\gcbreak"


def _spaced(code: str) -> str:
    """A line may end between long names and between the lines of a superbracket, and, rather not, before a bracket."""
    code = code.replace(r",\, ", r",\gcbreak\, ")
    code = re.sub(r"(?<!,)(?<!,\\gcbreak)\\,", r"\\gclessbreak\\,", code)
    return re.sub(r"(?<=\])(?=\[)", r"\\gclessbreak{}", code)


def equation(left: Expr, right: Expr, label: str) -> str:
    """A numbered identity."""
    code = f"{breakable(left)}\\gcbreak{{}}={breakable(right)}"
    return f"\\begin{{equation}}\\label{{{label}}}\n\\gcformula{{{code}}}\n\\end{{equation}}"


def displayed(before: str, e: Expr) -> str:
    """A formula of any length, over several lines and pages if need be."""
    return f"\\gclong{{{before}{breakable(e)}}}"


def inline(e: Expr) -> str:
    """A formula in a sentence; a meet that is a flat stands in parentheses."""
    code = breakable(e)
    return f"$({code})$" if isinstance(e, Meet) and e.step else f"${code}$"


def sentence(s: Statement, names: Iterable[str] = ()) -> str:
    """A statement; its flats, and the `names` of lines that it gives, are mathematics."""
    named = [n for n in names if n]
    pieces = [inline(p.expression) if isinstance(p, Flat) else _words(str(p), named) for p in s.pieces]
    return "".join(pieces)


def _words(words: str, names: Sequence[str]) -> str:
    if not names:
        return latex_words(words)
    parts = re.split(rf"\b({'|'.join(map(re.escape, names))})\b", words)
    return "".join(f"${part}$" if part in names else latex_words(part) for part in parts)


def named_words(words: str, names: Sequence[str]) -> str:
    r"""Running text in which names of points with digits, one or several side by side, are mathematics.

    >>> print(named_words("the line O1A1 and 2 of 3", ["O1", "A1"]))
    the line $O_{1}A_{1}$ and 2 of 3
    """
    numbered = sorted((n for n in names if re.fullmatch(r"[A-Za-z]+\d+", n)), key=len, reverse=True)
    if not numbered:
        return latex_words(words)
    one = "|".join(numbered)
    parts = re.split(rf"(?<!\w)((?:{one})+)(?!\w)", words)
    return "".join(
        f"${''.join(map(latex_name, re.findall(one, part)))}$" if n % 2 else latex_words(part)
        for n, part in enumerate(parts)
    )


def itemized(items: Iterable[str]) -> str:
    """A list of points, nothing of none."""
    rows = [rf"\item {item}" for item in items]
    return "\n".join([r"\begin{itemize}\itemsep0pt \parskip0pt", *rows, r"\end{itemize}"]) if rows else ""
