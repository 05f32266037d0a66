r"""Running text, quantities and whole documents as LaTeX.

Everything that is not mathematics of the algebra passes through here: words of sentences and of files, numbers with
their units. What comes out is ASCII, whatever went in, so that it needs no input encoding and every engine takes it.

>>> print(latex_words("50% of −3 mm⁹, S_1 ∧ ü"), latex_quantity(-3.08392e23, "mm", 9))
50\% of $-$3 mm$^{9}$, S\_1 $\wedge$ \"{u} $-3.084 \cdot 10^{23}\,\mathrm{mm}^{9}$
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import groupby

from gcrules.core.floats import decimal

__all__ = ["latex_document", "latex_quantity", "latex_ruled", "latex_table", "latex_words"]

_TEXT = {
    **{"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\~{}", **{c: f"\\{c}" for c in "{}_&#%$"}},
    **{"Æ": r"\AE{}", "æ": r"\ae{}", "Œ": r"\OE{}", "œ": r"\oe{}", "Ø": r"\O{}", "ø": r"\o{}", "ß": r"\ss{}"},
    **{"Ł": r"\L{}", "ł": r"\l{}", "Đ": r"\DJ{}", "đ": r"\dj{}", "Ð": r"\DH{}", "ð": r"\dh{}", "Þ": r"\TH{}"},
    **{"þ": r"\th{}", "ı": r"\i{}", "§": r"\S{}", "©": r"\copyright{}", "…": r"\ldots{}", "–": "--", "—": "---"},
    **{"‐": "-", "‑": "-", "‘": "`", "’": "'", "“": "``", "”": "''", "„": ",,", "«": "<<", "»": ">>"},
}
_SIGNS = {
    **{"→": r"\to", "←": r"\leftarrow", "↔": r"\leftrightarrow", "↦": r"\mapsto", "⇒": r"\Rightarrow", "∩": r"\cap"},
    **{"∧": r"\wedge", "∨": r"\vee", "∪": r"\cup", "∈": r"\in", "∅": r"\emptyset", "⟦": r"[\![", "⟧": r"]\!]"},
    **{"−": "-", "·": r"\cdot", "×": r"\times", "÷": r"\div", "±": r"\pm", "√": r"\surd", "°": r"^{\circ}"},
    **{"≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "≈": r"\approx", "≡": r"\equiv", "∥": r"\parallel", "⊥": r"\perp"},
    **{"⟂": r"\perp", "∞": r"\infty", "∂": r"\partial", "∇": r"\nabla", "∑": r"\sum", "∏": r"\prod", "′": "'"},
    **{"″": "''", "½": r"\frac{1}{2}", "¼": r"\frac{1}{4}", "¾": r"\frac{3}{4}", "⅙": r"\frac{1}{6}"},
}
_GREEK = (
    " alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma varsigma tau upsilon phi"
    " chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega "
)
_LIKE_LATIN = {
    **{"alpha": "A", "beta": "B", "epsilon": "E", "zeta": "Z", "eta": "H", "iota": "I", "kappa": "K", "mu": "M"},
    **{"nu": "N", "omicron": "O", "rho": "P", "tau": "T", "chi": "X"},
}
_ACCENTS = dict(zip(
    "\u0300\u0301\u0302\u0303\u0304\u0306\u0307\u0308\u030a\u030b\u030c\u0323\u0327\u0328\u0331\u0332",
    "`'^~=u.\"rHvdckbb",
    strict=True,
))  # fmt: skip
_LIGATURES = {"--", "<<", ">>", ",,", "''", "``", "?`", "!`"}  # two signs that T1 would print as one
_PREAMBLE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{amsmath}
\allowdisplaybreaks
\setlength{\parindent}{0pt}
\begin{document}
\sloppy"""


def latex_words(words: str) -> str:
    """Running text in ASCII: commands escaped, signs and accents spelled; what LaTeX has no sign for as its code."""
    out = ""
    for level, run in groupby(re.findall(r".[\u0300-\u036f]*", unicodedata.normalize("NFD", words), re.DOTALL), _level):
        if level:
            out += f"${level}{{{''.join(map(_raised, run))}}}$"
            continue
        for c in run:
            out += ("{}" if out[-1:] + c in _LIGATURES else "") + _character(c)
    return out


def latex_quantity(x: float | Fraction, unit: str = "", power: int = 1) -> str:
    r"""A number with its unit (a length, "rad", "deg"; "" for none) in dollar signs; in words where it is no number.

    >>> print(latex_quantity(2.5, "deg"), latex_quantity(float("inf"), "mm"))
    $2.5{}^{\circ}$ $\infty$
    >>> print(latex_quantity(Fraction(10) ** 400, "mm", 9))
    $1 \cdot 10^{400}\,\mathrm{mm}^{9}$
    """
    if isinstance(x, float) and not math.isfinite(x):
        return "not defined" if math.isnan(x) else r"$-\infty$" if x < 0 else r"$\infty$"
    digits, _, tens = (decimal(x, 4) if isinstance(x, Fraction) else f"{x:.4g}").partition("e")
    shown = digits + (rf" \cdot 10^{{{int(tens)}}}" if tens else "")
    if unit == "deg":
        return rf"${shown}{{}}^{{\circ}}$"
    raised = f"^{{{power}}}" if power != 1 else ""
    return rf"${shown}\,\mathrm{{{latex_words(unit)}}}{raised}$" if unit else f"${shown}$"


def latex_table(rows: Iterable[tuple[str, str]]) -> str:
    """A tabular of names and values, both LaTeX; it needs no package."""
    return _ruled("ll", [[*rows]])


def latex_ruled(columns: str, *parts: tuple[Sequence[str], Iterable[Sequence[str]]]) -> str:
    """A tabular of parts, each with a head of its own, ruled as books do it; it needs no package."""
    return _ruled(columns, [block for head, rows in parts for block in ([head], rows)])


def _ruled(columns: str, blocks: Iterable[Iterable[Sequence[str]]]) -> str:
    """A line above each block and at the end, with some room below it."""
    lines = [rf"\begin{{tabular}}{{{columns}}}"]
    for block in blocks:
        body = [f"  {' & '.join(row)} \\\\" for row in block]
        lines += [r"\hline\rule{0pt}{2.5ex}%", *body]
    return "\n".join([*lines, r"\hline", r"\end{tabular}"])


def latex_document(body: Iterable[str]) -> str:
    """A document for the article class; it needs no package beyond amsmath."""
    return "\n".join([_PREAMBLE, *body, r"\end{document}", ""])


def _level(c: str) -> str:
    """ "^" or "_" for a sign above or below the line (a run of them is set as one), else ""."""
    shape = unicodedata.decomposition(c[0])
    return "^" if shape.startswith("<super>") else "_" if shape.startswith("<sub>") else ""


def _raised(c: str) -> str:
    plain = unicodedata.normalize("NFKC", c)
    return "-" if plain == "−" else plain if plain.isascii() and plain.isalnum() else rf"\text{{{latex_words(plain)}}}"


def _character(c: str) -> str:
    """One character with the accents that follow it."""
    if (whole := unicodedata.normalize("NFC", c)) in _SIGNS:
        return f"${_SIGNS[whole]}$"
    out = _letter(c[0])
    for mark in c[1:]:
        out = rf"\{_ACCENTS[mark]}{{{out}}}" if mark in _ACCENTS else out + _code(mark)
    return out


def _letter(c: str) -> str:
    if c in _TEXT:
        return _TEXT[c]
    if c.isascii() and c.isprintable():
        return c
    kind = unicodedata.category(c)
    if c.isspace() or kind[0] in "CZ":
        return "" if kind == "Cf" else _code(c) if kind in ("Cs", "Co", "Cn") else " "
    alphabet, _, name = unicodedata.name(c, "").partition(" LETTER ")
    if alphabet.startswith("GREEK "):
        small = alphabet.endswith("SMALL")
        name = {"lamda": "lambda", "final sigma": "varsigma"}.get(name.lower(), name.lower())
        command = name if small else name.title()
        like = "o" if small and name == "omicron" else None if small else _LIKE_LATIN.get(name)
        return rf"$\{command}$" if f" {command} " in _GREEK else like or _code(c)
    plain = unicodedata.normalize("NFKC", c)
    return latex_words(plain) if plain != c else _code(c)


def _code(c: str) -> str:
    return f"[U+{ord(c):04X}]"
