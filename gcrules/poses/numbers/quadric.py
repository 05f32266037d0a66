r"""Polynomials of degree ≤ 2 that never change sign, exactly; and the factors of a cubic that repeat or split off."""

from __future__ import annotations

from fractions import Fraction

from gcrules.core.linear_algebra import kernel
from gcrules.poses.numbers.cubic import Cubic, Exponents
from gcrules.poses.numbers.variety import signature

__all__ = ["one_sign", "split", "touching"]

Vector = tuple[Fraction, Fraction, Fraction]

_MAX_BITS = 4000  # of the longest coefficient; longer ones come from rounded turns, in which nothing splits


def _derivatives(f: Cubic) -> tuple[list[list[Fraction]], list[Fraction], Fraction]:
    """The matrix of second derivatives at 0, the gradient there and the value."""
    c = f.coefficients

    def at(*axes: int) -> Fraction:
        x, y, z = (axes.count(i) for i in range(3))
        return c.get((x, y, z), Fraction(0))

    hessian = [[at(i, j) * (2 if i == j else 1) for j in range(3)] for i in range(3)]
    return hessian, [at(i) for i in range(3)], at()


def one_sign(f: Cubic) -> bool:
    """Whether a polynomial of degree ≤ 2 with f(0) ≠ 0 has no real zero, or touches zero without changing sign.

    The 4×4 matrix of the homogeneous form tells: it is semidefinite.
    """
    hessian, gradient, value = _derivatives(f)
    form = [[*row, g] for row, g in zip(hessian, gradient, strict=True)] + [[*gradient, 2 * value]]
    positive, negative, _ = signature(form)
    return f.degree <= 2 and 0 in (positive, negative)


def touching(f: Cubic) -> Vector | None:
    """The zero nearest to 0 of a polynomial with `one_sign`; None if it has none. Exact.

    The zeros are the extrema, H x = −g, if the value there is 0; the nearest is the x = H y with H H y = −g.
    """
    hessian, gradient, _ = _derivatives(f)
    squared = [[sum((a * b for a, b in zip(r, c, strict=True)), Fraction(0)) for c in hessian] for r in hessian]
    solutions = [v for v in kernel([[*row, g] for row, g in zip(squared, gradient, strict=True)], 4) if v[3]]
    if not solutions:
        return None
    y = [c / solutions[0][3] for c in solutions[0][:3]]
    x1, x2, x3 = (sum((a * b for a, b in zip(row, y, strict=True)), Fraction(0)) for row in hessian)
    return None if f(x1, x2, x3) else (x1, x2, x3)


def split(f: Cubic) -> tuple[Cubic, ...]:
    """The irreducible factors of f over the rationals, each once; f itself where its numbers are very long."""
    longest = max((c.numerator.bit_length() + c.denominator.bit_length() for c in f.coefficients.values()), default=0)
    if longest > _MAX_BITS:
        return (f,)
    from sympy import Poly, Rational, symbols  # for the few polynomials that are degenerate

    terms: dict[Exponents, object] = {e: Rational(c.numerator, c.denominator) for e, c in f.coefficients.items()}
    _, factors = Poly(terms, *symbols("x y z")).factor_list()
    return tuple(
        Cubic({e: Fraction(int(c.p), int(c.q)) for e, c in factor.terms()})
        for factor, _ in factors
        if factor.degree_list()
    )
