r"""Whether a bracket polynomial is irreducible, so that no expression equal to it has a scalar part.

Every factor of a bracket polynomial (without ideal points) is one again: it has a multiple of d letters. After all
brackets have been taken out each factor has at least 2·d letters, so fewer than 4·d letters are irreducible. Else the
polynomial is restricted to a line of positions: if the restriction has the full degree and is irreducible over the
rationals, so is the polynomial.
"""

from __future__ import annotations

from fractions import Fraction

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import Evaluator, random_rational_points

__all__ = ["irreducible"]

_LINES = 3


def irreducible(poly: BracketPolynomial) -> bool | None:
    """True: irreducible over the rationals. None: not known. The polynomial must have no brackets as factors."""
    if poly.ideal or not poly:
        return None
    letters = sum((poly.degrees() or {}).values())
    if letters < 4 * poly.rank:
        return True
    return True if any(_irreducible_on_a_line(poly, letters, seed) for seed in range(_LINES)) else None


def _irreducible_on_a_line(poly: BracketPolynomial, degree: int, seed: int) -> bool:
    import sympy  # heavy, and needed for large polynomials only

    e = poly.to_expr()
    one, other = (random_rational_points(poly.points, rank=poly.rank, seed=2 * seed + n, size=3) for n in (0, 1))
    t = sympy.Symbol("t")
    samples = []
    for x in range(degree + 1):
        at = {n: tuple(a + x * b for a, b in zip(one[n], other[n], strict=True)) for n in poly.points}
        samples.append((x, Evaluator(at, poly.rank).value(e)[0]))
    restricted = sympy.Poly(sympy.interpolate([(x, sympy.Rational(Fraction(v))) for x, v in samples], t), t)
    return bool(restricted.degree() == degree and restricted.is_irreducible)
