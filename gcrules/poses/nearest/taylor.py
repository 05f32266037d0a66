r"""A cubic in three variables in floats: its value, gradient and second derivatives at many points."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.numbers.cubic import Cubic

__all__ = ["Taylor", "taylor"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Taylor:
    """f(x) = constant + gradient·x + ½ xᵀ hessian x + ⅙ Σ third_ijk x_i x_j x_k."""

    constant: float
    gradient: Floats
    hessian: Floats
    third: Floats

    def value(self, x: Floats) -> Floats:
        """At points (…, 3)."""
        second = x @ self.hessian + self._third(x, x) / 3
        found: Floats = self.constant + x @ self.gradient + (second * x).sum(axis=-1) / 2
        return found

    def slope(self, x: Floats) -> Floats:
        """The gradients at points (…, 3)."""
        found: Floats = self.gradient + x @ self.hessian + self._third(x, x) / 2
        return found

    def curvature(self, x: Floats) -> Floats:
        """The second derivatives at points (…, 3): (…, 3, 3)."""
        found: Floats = self.hessian + np.einsum("ijk,...k->...ij", self.third, x)
        return found

    @property
    def rounding(self) -> float:
        """A bound of the error of `value` in the ball of radius 2, generously."""
        size = abs(self.constant) + 2 * np.abs(self.gradient).sum()
        size += 2 * np.abs(self.hessian).sum() + 2 * np.abs(self.third).sum()
        return 2e-14 * float(size)

    def on_rays(self, directions: Floats) -> Floats:
        """The distances to the first zero along unit directions (N, 3), infinite where there is none; f(0) ≠ 0.

        With s = 1/r the ray's polynomial has the leading coefficient f(0), so the roots always exist; the largest real
        positive one counts. Roots within 1e-6 of being real count too: they may be double.
        """
        c1 = directions @ self.gradient / self.constant
        c2 = (directions @ self.hessian * directions).sum(axis=1) / 2 / self.constant
        c3 = (self._third(directions, directions) * directions).sum(axis=1) / 6 / self.constant
        with np.errstate(divide="ignore"):
            found: Floats = 1 / np.maximum(_largest_real(c1, c2, c3), 0.0)
        return found

    def _third(self, x: Floats, y: Floats) -> Floats:
        found: Floats = np.einsum("ijk,...j,...k->...i", self.third, x, y)
        return found


def taylor(f: Cubic, size: Fraction) -> Taylor:
    """f in units of `size` and divided by f(0) ≠ 0, so that its constant is 1; each coefficient is rounded once."""
    start = f(Fraction(0), Fraction(0), Fraction(0))
    gradient, hessian, third = np.zeros(3), np.zeros((3, 3)), np.zeros((3, 3, 3))
    for exponents, coefficient in f.stretched(size).coefficients.items():
        checkpoint()
        axes = [i for i, e in enumerate(exponents) for _ in range(e)]
        derivative = float(coefficient / start) * math.prod(map(math.factorial, exponents))
        for order in set(permutations(axes)):
            if axes:
                (gradient, hessian, third)[len(axes) - 1][order] = derivative
    return Taylor(1.0, gradient, hessian, third)


def _largest_real(a: Floats, b: Floats, c: Floats) -> Floats:
    """The largest root that is real, or within 1e-6 of it, of each s³ + a s² + b s + c, to some ten digits: a hundred
    times as fast as the eigenvalues of companion matrices.

    One real root by Viète's and Cardano's formulas, after Newton's method; what is left is a quadratic.
    """
    p, q = b / 3 - a * a / 9, (a * b / 3 - c) / 2 - a**3 / 27  # of s = t − a/3: t³ + 3 p t = 2 q
    square = q * q + p**3
    root = np.sqrt(np.abs(square))
    size = np.cbrt(np.abs(q) + root)  # one root is real, of the sign of q
    far = np.sqrt(np.maximum(-p, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        alone = np.where(size > 0, size - p / size, 0.0)
        turned = 2 * far * np.cos(np.arccos(np.clip(np.abs(q) / far**3, -1, 1)) / 3)
    t = np.copysign(np.where(square > 0, alone, np.where(far > 0, turned, 0.0)), q)
    s = t - a / 3
    value = ((s + a) * s + b) * s + c
    for _ in range(3):
        slope = (3 * s + 2 * a) * s + b
        new = s - np.divide(value, slope, out=np.zeros_like(s), where=slope != 0)
        there = ((new + a) * new + b) * new + c
        better = np.abs(there) < np.abs(value)
        s, value = np.where(better, new, s), np.where(better, there, value)
    large = np.abs(s) ** 3 > np.abs(c)  # then the division from the lowest coefficient is the stable one
    with np.errstate(divide="ignore", invalid="ignore"):
        product = np.where(large, -c / s, b + s * (a + s))
        half = np.where(large, (product - b) / s, a + s) / 2  # of the quadratic s² + 2 half s + product
    left = half * half - product
    imaginary = np.sqrt(np.maximum(-left, 0.0))
    other = -half + np.sqrt(np.maximum(left, 0.0))
    is_real = imaginary <= 1e-6 * np.hypot(half, imaginary)
    return np.where(is_real, np.maximum(s, other), s)
