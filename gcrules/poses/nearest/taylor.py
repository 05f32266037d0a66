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
        companion = np.zeros((len(directions), 3, 3))
        companion[:, 0] = -np.stack([c1, c2, c3], axis=1)
        companion[:, 1, 0] = companion[:, 2, 1] = 1.0
        roots = np.linalg.eigvals(companion)
        real = (np.abs(roots.imag) <= 1e-6 * np.abs(roots)) & (roots.real > 0)
        largest = np.where(real, roots.real, 0.0).max(axis=1)
        with np.errstate(divide="ignore"):
            found: Floats = 1 / largest
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
