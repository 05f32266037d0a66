r"""Formulas and sentences for columns of any width: TeX breaks them where a line may end.

>>> from gcrules.algebra.language.syntax import parse
>>> print(breakable(parse(r"abc /\ ade - [abcd]ef")))
abc\gclessbreak{}\wedge ade\gcbreak{}-[abcd]\gclessbreak\,ef
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from gcrules.algebra.expr import Expr, Meet
from gcrules.rules.statement import Flat, Piece, Quantity, Statement
from gcrules.views.formulas.latex import latex_name, latex_parts
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["MACROS", "breakable", "displayed", "equation", "inline", "itemized", "named_words", "sentence"]

MACROS = r"""\providecommand{\gcbreak}{\penalty0\relax}
\providecommand{\gclessbreak}{\penalty300\relax}
\providecommand{\gcraggedright}{\raggedright\hangindent=1.5em\hangafter=1\binoppenalty=10000\relpenalty=10000\relax}
\providecommand{\gcformula}[1]{% in one line, or broken where it is wider than the column
  \setbox0=\hbox{$#1$}%
  \ifdim\wd0<0.86\linewidth\copy0\else\parbox{0.86\linewidth}{\gcraggedright$#1$}\fi}
\providecommand{\gccell}{\raggedright\let\\\tabularnewline\relax}
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


def sentence(s: Statement, lines: Iterable[str] = (), names: Sequence[str] = ()) -> str:
    """A statement; its flats, the names of `lines` that it gives, and those of points with digits are mathematics."""
    given = [n for n in lines if n]

    def written(piece: Piece) -> str:
        if isinstance(piece, Quantity):
            return f"${piece.latex or piece}$"
        return inline(piece.expression) if isinstance(piece, Flat) else _words(str(piece), given, names)

    return "".join(map(written, s.pieces))


def _words(words: str, lines: Sequence[str], names: Sequence[str]) -> str:
    if not lines:
        return named_words(words, names)
    parts = re.split(rf"\b({'|'.join(map(re.escape, lines))})\b", words)
    return "".join(f"${part}$" if part in lines else named_words(part, names) for part in parts)


def named_words(words: str, names: Sequence[str]) -> str:
    r"""Running text in which names of points with digits, one or several side by side, and axes are mathematics.

    >>> print(named_words("the line O1A1, the plane zp1p2' and 2 of 3", ["O1", "A1", "z", "p1", "p2'"]))
    the line $O_{1}A_{1}$, the plane $zp_{1}p_{2}'$ and 2 of 3
    """
    short = sorted((n for n in names if re.fullmatch(r"[A-Za-z]+\d*'*", n)), key=len, reverse=True)
    if not any(re.search(r"\d", n) for n in short):
        return latex_words(words)
    one = "|".join(map(re.escape, short))
    parts = re.split(rf"(?<![\w'])((?:{one})+)(?![\w'])", words)
    return "".join(
        f"${''.join(map(latex_name, re.findall(one, part)))}$" if n % 2 and _is_name(part) else latex_words(part)
        for n, part in enumerate(parts)
    )


def _is_name(word: str) -> bool:
    """Whether a word that names make is no word of English."""
    return bool(re.search(r"\d", word)) or word in ("x", "y", "z")


def itemized(items: Iterable[str]) -> str:
    """A list of points, nothing of none."""
    rows = [rf"\item {item}" for item in items]
    return "\n".join([r"\begin{itemize}\itemsep0pt \parskip0pt", *rows, r"\end{itemize}"]) if rows else ""
