r"""The superbracket of six lines as a polynomial in brackets: the 24-term and the 16-term form.

Both forms are polynomials in the twelve end points a b | c d | e f | g h | i j | k l of the lines, written here with
the positions 0 … 11. The 24 terms are standard tableaux (McMillan and White, as printed by Ben-Horin et al., 2008), so
for twelve different points in this order they are the normal form; the 16 terms are derived here.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import product

from gcrules.algebra.bracket import Monomial, sorted_row
from gcrules.core.errors import InputError

__all__ = ["FORMS", "form_terms"]

_24 = """
-abcd efgi hjkl +abcd efhi gjkl +abcd efgj hikl -abcd efhj gikl +abce dfgh ijkl -abde cfgh ijkl
-abcf degh ijkl +abdf cegh ijkl -abce dghi fjkl +abde cghi fjkl +abcf dghi ejkl +abce dghj fikl
-abdf cghi ejkl -abde cghj fikl -abcf dghj eikl +abdf cghj eikl +abcg defi hjkl -abdg cefi hjkl
-abch defi gjkl -abcg defj hikl +abdh cefi gjkl +abdg cefj hikl +abch defj gikl -abdh cefj gikl
"""

FORMS = (24, 16)


@cache
def form_terms(form: int) -> tuple[tuple[int, Monomial], ...]:
    """The (sign, three brackets) of the 24-term or 16-term form; brackets hold end-point positions 0 … 11.

    Raises InputError for any other form.
    """
    if form not in FORMS:
        raise InputError(f"there is no {form!r}-term form", hint="the superbracket has a 24-term and a 16-term form")
    found = []
    for sign, rows in _terms24() if form == 24 else _terms16():
        brackets = []
        for row in rows:
            s, r = sorted_row(row)
            sign *= s
            brackets.append(r)
        found.append((sign, tuple(sorted(brackets))))
    return tuple(found)


def _terms24() -> Iterator[tuple[int, Monomial]]:
    words = iter(_24.split())
    for first, second, third in zip(words, words, words, strict=True):
        rows = tuple(tuple(ord(c) - ord("a") for c in w) for w in (first[1:], second, third))
        yield (-1 if first[0] == "-" else 1), rows


def _terms16() -> Iterator[tuple[int, Monomial]]:
    """T(ab, cd, ef; gh, ij, kl) − T(gh, ij, kl; ab, cd, ef), where for whole lines X and split lines Y
    T = Σ (−1)^(i+j+k) [X1 Y12_i Y13_j][Y12_(1−i) X2 Y23_k][Y13_(1−j) Y23_(1−k) X3] over i, j, k in {0, 1}.
    """
    for outer, whole, split in ((1, (0, 2, 4), (6, 8, 10)), (-1, (6, 8, 10), (0, 2, 4))):
        x1, x2, x3 = ((x, x + 1) for x in whole)
        y12, y13, y23 = split
        for i, j, k in product((0, 1), repeat=3):
            rows = ((*x1, y12 + i, y13 + j), (y12 + 1 - i, *x2, y23 + k), (y13 + 1 - j, y23 + 1 - k, *x3))
            yield outer * (-1) ** (i + j + k), rows
