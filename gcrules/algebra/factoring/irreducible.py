r"""Whether a bracket polynomial is irreducible, so that no expression equal to it has a scalar part.

Every factor of a bracket polynomial (without ideal points) is one again: it has a multiple of d letters. After all
brackets have been taken out each factor has at least 2·d letters, so fewer than 4·d letters are irreducible. Else the
polynomial is restricted to a line of positions: if the restriction has the full degree and is irreducible over the
rationals, so is the polynomial.
"""

from __future__ import annotations

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import random_rational_points
from gcrules.algebra.factoring.restriction import Position, restricted

__all__ = ["MOST_LETTERS", "irreducible"]

MOST_LETTERS = 32
"""Polynomials of more letters are not restricted: factoring in one unknown takes too long."""

_LINES = 2


def irreducible(poly: BracketPolynomial) -> bool | None:
    """True: irreducible over the rationals. None: not known. The polynomial must have no brackets as factors."""
    if poly.ideal or not poly:
        return None
    letters = sum((poly.degrees() or {}).values())
    if letters < 4 * poly.rank:
        return True
    if letters > MOST_LETTERS:
        return None
    return True if any(_irreducible_on_a_line(poly, letters, seed) for seed in range(_LINES)) else None


def _irreducible_on_a_line(poly: BracketPolynomial, degree: int, seed: int) -> bool:
    one, other = (random_rational_points(poly.points, rank=poly.rank, seed=2 * seed + n, size=3) for n in (0, 1))

    def line(t: int) -> Position:
        return {n: tuple(a + t * b for a, b in zip(one[n], other[n], strict=True)) for n in poly.points}

    on_line = restricted(poly, line, degree)
    return bool(on_line.degree() == degree and on_line.is_irreducible)
