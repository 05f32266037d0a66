r"""Closed forms on the tape: turns and slides that satisfy an equation, with the root that is home's.

>>> graph = Graph(1)
>>> roots = Roots(graph)
>>> (x,) = graph.inputs  # 0 at home
>>> cosine, sine = roots.turned(-1, 2, 1 - x)  # 2 sin θ = cos θ − 1 + x, θ = 0 at home
>>> c, s = lower(graph, cosine, sine).exact([0.3])
>>> abs(c * c + s * s - 1) < 1e-15, abs(2 * s - c + 1 - 0.3) < 1e-15, 0 < s < 0.2
(True, True, True)
>>> roots.turned(-1, x, 1)
Traceback (most recent call last):
    ...
gcrules.poses.compiling.roots.NoForm: two roots meet at home
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt, sqrt

from gcrules.core.dataclass import dataclass
from gcrules.poses.compiling.scalars import Graph, Ring, Scalar
from gcrules.poses.compiling.tape import lower

__all__ = ["NoForm", "Roots", "cosine_and_sine", "half_tangent", "inverse", "root"]

_TERMS = 6  # of series: for a sixteenth of π what is left out is below 1e-18

_DOUBLE = 1e-6  # in parts of the coefficients: nearer roots are not told apart


class NoForm(Exception):
    """There is no closed form of the kinds that are known here."""


def root(x: Ring) -> Ring:
    """√x."""
    return x.root() if isinstance(x, Scalar) else Fraction(sqrt(x))


def _root(x: Ring) -> Ring:
    """√x, exact. Raises NoForm for a number that is no square."""
    if isinstance(x, Scalar):
        return x.root()
    x = Fraction(x)
    above, below = isqrt(max(x.numerator, 0)), isqrt(x.denominator)
    if above * above != x.numerator or below * below != x.denominator:
        raise NoForm("the root of a number")
    return Fraction(above, below)


def half_tangent(t: Ring) -> tuple[Ring, Ring]:
    """The cosine and the sine of an angle whose half has the tangent t.

    >>> graph = Graph(1)
    >>> [lower(graph, x).exact([Fraction(1, 2)])[0] for x in half_tangent(graph.inputs[0])]
    [Fraction(3, 5), Fraction(4, 5)]
    """
    part = inverse(t * t + 1)
    return (1 - t * t) * part, t * part * 2


def inverse(x: Ring) -> Ring:
    """1/x."""
    return x.inverse() if isinstance(x, Scalar) else 1 / Fraction(x)


def cosine_and_sine(angle: Ring) -> tuple[Ring, Ring]:
    """Those of an angle from −π to π, within a few roundings: by series for its sixteenth, doubled four times. Of the
    cosine what it lacks of 1 is doubled, so that nothing is lost.

    >>> graph = Graph(1)
    >>> both = lower(graph, *cosine_and_sine(graph.inputs[0]))
    >>> from math import cos, sin
    >>> all(abs(c - cos(x)) + abs(s - sin(x)) < 2e-15 for x in (-3.1, 1e-9, 0.3, 2.0) for c, s in [both.exact([x])])
    True
    """
    small = angle * Fraction(1, 16)
    square = small * small
    s = small * _series(square, 3)
    lack = square * Fraction(1, 2) * _series(square, 4)
    for _ in range(4):
        s, lack = s * (1 - lack) * 2, s * s * 2
    return 1 - lack, s


def _series(square: Ring, first: int) -> Ring:
    """1 − x²/((k − 1) k) (1 − x²/((k + 1)(k + 2)) (…)), from k = first on."""
    found: Ring = 1
    for k in range(first + 2 * _TERMS - 2, first - 1, -2):
        found = 1 - square * Fraction(1, k * (k - 1)) * found
    return found


@dataclass(frozen=True, eq=False)
class Roots:
    """Equations whose solution at home, where all inputs are 0, is 0."""

    graph: Graph

    def at_home(self, x: Ring) -> float:
        """The value there."""
        return float(lower(self.graph, x).exact([0.0] * len(self.graph.inputs))[0])

    def turned(self, a: Ring, b: Ring, c: Ring, n: Ring = 1) -> tuple[Ring, Ring]:
        """cos θ and sin θ/√n with a cos θ + b sin θ/√n + c = 0, n > 0: so a sine may stand for a vector √n as long as
        the cosine's. Raises NoForm where both roots are one at home.
        """
        square = a * a * n + b * b
        rest = _root(square - c * c * n) * -self._sign(b, self.at_home(a))
        part = inverse(square)
        return -(a * c * n + b * rest) * part, (a * rest - b * c) * part

    def slid(self, b: Ring, c: Ring, size: float, n: Ring = 1) -> Ring:
        """s with n s² + 2 b s + c = 0, b like `size`. Raises NoForm where both roots are one at home."""
        return (_root(b * b - c * n) * self._sign(b, size) - b) * inverse(n)

    def _sign(self, b: Ring, beside: float) -> int:
        value = self.at_home(b)
        if abs(value) <= _DOUBLE * (abs(beside) + abs(value)):
            raise NoForm("two roots meet at home")
        return 1 if value > 0 else -1
