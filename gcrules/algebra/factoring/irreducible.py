r"""Whether a bracket polynomial is irreducible, so that no expression equal to it has a scalar part.

Every factor of a bracket polynomial (without ideal points) is one again: it has a multiple of d letters. After all
brackets have been taken out each factor has at least 2·d letters, so fewer than 4·d letters are irreducible. Else the
polynomial is restricted to a line of positions on which a frame is held, the d points that occur most often: if the
restriction has the full degree and is irreducible over the rationals, so is the polynomial, since a factor that is
constant there is a power of the frame's bracket.
"""

from __future__ import annotations

import random
from collections.abc import Mapping

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import random_rational_points
from gcrules.algebra.factoring.restriction import Position, restricted, value_at

__all__ = ["MOST_LETTERS", "frame_of", "irreducible"]

MOST_LETTERS = 32
"""Polynomials with more letters beside the frame are not restricted: factoring in one unknown takes too long."""

_LINES = 4


def irreducible(poly: BracketPolynomial) -> bool | None:
    """True: irreducible over the rationals. None: not known. The polynomial must have no brackets as factors."""
    if poly.ideal or not poly:
        return None
    degrees = poly.degrees() or {}
    if sum(degrees.values()) < 4 * poly.rank:
        return True
    held = frame_of(degrees, poly.rank)
    if _may_divide(poly, held):
        held = frozenset()
    moving = sum(d for n, d in degrees.items() if n not in held)
    if moving > MOST_LETTERS:
        return None
    return True if any(_irreducible_on_a_line(poly, held, moving, seed) for seed in range(_LINES)) else None


def _may_divide(poly: BracketPolynomial, held: frozenset[str]) -> bool:
    """Whether the frame's bracket may divide the polynomial, which then vanishes where two points of it coincide."""
    at = dict(random_rational_points(poly.points, rank=poly.rank, seed=1, size=3))
    one, other = sorted(held)[:2]
    at[one] = at[other]
    return not value_at(poly, at)


def frame_of(degrees: Mapping[str, int], rank: int) -> frozenset[str]:
    """The points that are held: as many as there are coordinates, those that occur most often."""
    return frozenset(sorted(degrees, key=lambda n: -degrees[n])[:rank])


def _irreducible_on_a_line(poly: BracketPolynomial, held: frozenset[str], degree: int, seed: int) -> bool:
    rng = random.Random(seed)
    # With last coordinates 1 all points were at infinity together, at t = -1, where all brackets are zero.
    one, other = ({n: tuple(rng.randint(-3, 3) for _ in range(poly.rank)) for n in poly.points} for _ in (0, 1))

    def line(t: int) -> Position:
        return {
            n: one[n] if n in held else tuple(a + t * b for a, b in zip(one[n], other[n], strict=True))
            for n in poly.points
        }

    on_line = restricted(poly, line, degree)
    return bool(on_line.degree() == degree and on_line.is_irreducible)
