r"""Formulas and sentences for columns of any width: TeX breaks them where a line may end.

>>> from gcrules.algebra.language.syntax import parse
>>> print(breakable(parse(r"abc /\ ade - [abcd]ef")))
abc\gclessbreak{}\wedge ade\gcbreak{}-[abcd]\gctimes\,ef
>>> print(breakable(parse("[abcd]([aefg] + [befg])")))
[abcd]\gctimes{}\gcgroup{(}{[aefg]\gcbreak{}+[befg]}{)}
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from gcrules.algebra.expr import Expr, Meet
from gcrules.algebra.language.notation import Digits, Mark, Row, Sign
from gcrules.rules.statement import Flat, Piece, Quantity, Statement
from gcrules.views.formulas.latex import latex_name, latex_signs
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["MACROS", "breakable", "displayed", "equation", "inline", "itemized", "named_words", "sentence"]

MACROS = r"""% Lines of a formula end before + and -, rather not before a meet or join, nor between factors, with a dot.
% Parentheses and brackets stay whole; one that is wider than the column has its parts below each other.
\providecommand{\gcbreak}{\gcafterwide\penalty0\relax}
\providecommand{\gclessbreak}{\gcafterwide\penalty300\relax}
\providecommand{\gctimes}{\ifx\gcafterwide\relax\discretionary{}{\hbox{$\cdot\,$}}{}\else\gcafterwide\cdot\,\fi}
\providecommand{\gcgroup}[3]{\setbox0=\hbox{$#1#2#3$}\ifdim\wd0<0.25\linewidth{#1#2#3}\else#1#2#3\fi}
\providecommand{\gcwide}[3]{%
  \setbox0=\hbox{$#1#2#3$}\dimen0=\linewidth\advance\dimen0 by-\gclead\relax
  \ifdim\wd0<\dimen0{#1#2#3}\else
    \setbox0=\hbox{$#1$}\advance\dimen0 by-\wd0\relax
    {#1}\parbox[t]{\dimen0}{\gcraggedright\hangindent=0pt\def\gclead{1.6em}$#2\gcafterwide#3$}%
    \def\gcafterwide{\let\gcafterwide\relax\penalty-10000\relax}\fi}
\providecommand{\gcraggedright}{\raggedright\hangindent=1.5em\hangafter=1%
  \binoppenalty=10000\relpenalty=10000\exhyphenpenalty=300\let\gcafterwide\relax\let\gcgroup\gcwide\def\gclead{4.2em}}
\let\gcafterwide\relax
\providecommand{\gcformula}[1]{% in one line, or broken where it is wider than the column
  \setbox0=\hbox{$#1$}%
  \ifdim\wd0<0.86\linewidth\copy0\else\parbox{0.86\linewidth}{\gcraggedright$#1$}\fi}
\providecommand{\gctable}[1]{% as it is, or made smaller where it is wider than the column
  \setbox0=\hbox{#1}\ifdim\wd0>\linewidth\resizebox{\linewidth}{!}{\copy0}\else\copy0\fi}
\providecommand{\gcheading}{\advance\rightskip by 0pt plus 8em\relax}
\providecommand{\gccell}{\raggedright\let\\\tabularnewline\relax}
\providecommand{\gclong}[1]{\par{\gcraggedright\noindent\hspace*{1em}$#1$\par}}"""
"""Definitions that a section begins with; an author may define them otherwise before."""


def breakable(e: Expr) -> str:
    """An expression, without dollar signs, with the places where a line may end."""
    signs = latex_signs(e)
    return "".join(_broken(signs))


_CLOSING = {"(": ")", "[": "]", "[[": "]]"}
_PLACES = {
    "+": r"\gcbreak{}+",
    "−": r"\gcbreak{}-",
    ",": r",\gcbreak\, ",
    "∧": r"\gclessbreak{}\wedge ",
    "∨": r"\gclessbreak{}\vee ",
    "space": r"\gctimes\,",
    "times": r"\gctimes{}",
}


def _broken(signs: Iterator[tuple[Sign, str]], closing: str = "") -> Iterator[str]:
    """The signs up to a closing one, which is taken too."""
    after_factor = False
    for sign, code in signs:
        mark = sign.sign if isinstance(sign, Mark) else ""
        if mark and mark == closing:
            return
        factor = mark in _CLOSING or not mark
        if factor and after_factor:
            yield r"\gctimes{}"
        if mark in _CLOSING:
            yield _group(code, "".join(_broken(signs, _CLOSING[mark])), _SPELLED[_CLOSING[mark]])
        else:
            yield _PLACES.get(mark) or (code.replace(r"\,", r"\gclessbreak\,") if isinstance(sign, Row) else code)
        after_factor = factor and not isinstance(sign, Digits)


_SPELLED = {")": ")", "]": "]", "]]": r"]\!]"}


def _group(opening: str, inside: str, closing: str) -> str:
    """What stands in parentheses or brackets, as one piece where it has places to break."""
    whole = not any(place in inside for place in (r"\gcbreak", r"\gclessbreak", r"\gctimes"))
    return f"{opening}{inside}{closing}" if whole else rf"\gcgroup{{{opening}}}{{{inside}}}{{{closing}}}"


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
    return f"${_group('(', code, ')') if isinstance(e, Meet) and e.step else code}$"


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
