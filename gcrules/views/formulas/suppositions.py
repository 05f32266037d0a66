r"""What an analysis of lines assumes, as a sentence that stands before its condition.

>>> from gcrules.conditions.analysis import analyze
>>> print(supposed(analyze("Aa Ab Bc Bd Ce Cf", given="coplanar(A, B, a, b)").structure))
Suppose that A, B, a and b lie in a plane.
>>> print(supposed(analyze("Aa Bb Cc Dd Ee Ff", given="coplanar(A, B, C, D), coplanar(A, B, C, E)").structure))
Suppose that A, B, C and D lie in a plane; A, B, C and E lie in a plane; and A, B and C are not on a line.
>>> print(supposed(analyze("ab af cb cd ed ef").structure))
<BLANKLINE>
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.space import Assumption
from gcrules.algebra.structure import Structure
from gcrules.core.english import listed

__all__ = ["supposed"]


def supposed(s: Structure, shown: Callable[[Expr], str] | None = None, words: Callable[[str], str] = str) -> str:
    """The assumptions of lines, and what must not vanish for them to say this, in one sentence; "" where nothing is
    assumed. Formulas are written by `shown`, by default as text, and words by `words`.
    """

    def plain(e: Expr) -> str:
        return text(e, names=s.names)

    parts = list(_parts(s, shown or plain, words))
    if not parts:
        return ""
    if len(parts) == 1:
        return f"Suppose that {parts[0]}."
    return f"Suppose that {'; '.join(parts[:-1])}; and {parts[-1]}."


def _parts(s: Structure, shown: Callable[[Expr], str], words: Callable[[str], str]) -> Iterator[str]:
    for assumption in s.given:
        yield _ASSUMED[assumption.kind](assumption, shown)
    for expression, meaning in s.assumed:
        yield words(meaning or f"{expression} is not 0")


def _all(a: Assumption, shown: Callable[[Expr], str]) -> str:
    return listed([shown(e) for e in a.args])


_ASSUMED: dict[str, Callable[[Assumption, Callable[[Expr], str]], str]] = {
    "collinear": lambda a, shown: f"{_all(a, shown)} lie on a line",
    "coplanar": lambda a, shown: f"{_all(a, shown)} lie in a plane",
    "concurrent": lambda a, shown: f"{_all(a, shown)} have a point in common, possibly at infinity",
    "incident": lambda a, shown: f"{shown(a.args[0])} lies in {shown(a.args[1])}",
    "zero": lambda a, shown: f"{shown(a.args[0])} is 0",
}
