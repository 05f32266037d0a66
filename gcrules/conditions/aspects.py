r"""How many aspects every generic platform of a class has at least, from the signs of its condition far away.

A factor of the condition is a polynomial in the translation of the platform. On a straight line of translations its
sign far away is that of its leading form, and at the other end it is the opposite one where the degree is odd. So

* factors of degree 1 with independent gradients take all patterns of signs, in one orientation already;
* a factor of degree 2 whose leading form vanishes along a line of the base or of the platform, and does not keep its
  sign there, has both signs far away; turning the translation round keeps it and changes those of degree 1;
* one factor of degree 3 has both signs.

What vanishes identically is seen at exact random platforms in random orientations, what does not is proved by one.
Derived here.

>>> from gcrules.conditions.analysis import analyze
>>> found = least_aspects(analyze("Aa Ab Ac Bd Be Cf"))
>>> found.degrees, found.number
((1, 1, 1), 8)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import factors
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import rank
from gcrules.core.seeds import drawn

__all__ = ["LeastAspects", "least_aspects"]

Vector = Sequence[int]

_PLATFORMS = 8  # exact random ones
_RANGE = 10**6  # of their coordinates
_DEGREE = 3  # of the superbracket in the translation
_AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@dataclass(frozen=True)
class LeastAspects:
    """The `factors` of a condition with their `degrees` in the translation of the platform, and the least `number` of
    aspects that follows for a generic platform of the class; `line` is that along which the leading form of the factor
    of degree 2 vanishes. Seen at so many exact random `platforms`.
    """

    factors: tuple[Expr, ...]
    degrees: tuple[int, ...]
    number: int
    line: tuple[str, str] | None
    platforms: int


def least_aspects(a: Analysis) -> LeastAspects | None:
    """What the condition of legs tells; None for legs that are always singular, and where nothing follows."""
    condition, structure = a.condition, a.structure
    if not a.typed.polynomial:
        return None
    parts = factors(condition.expression) if condition.cofactor == ONE else (structure.superbracket,)
    some = [_Translated.random(structure, n) for n in range(_PLATFORMS)]
    degrees = tuple(max(one.degree(f) for one in some) for f in parts)
    linear = [f for f, d in zip(parts, degrees, strict=True) if d == 1]
    others = [(f, d) for f, d in zip(parts, degrees, strict=True) if d != 1]
    independent = rank([[some[0].leading(f, 1, axis) for axis in _AXES] for f in linear]) == len(linear)
    if not others and independent:
        return LeastAspects(parts, degrees, 2 ** len(linear), None, _PLATFORMS)
    if len(others) == 1 and others[0][1] == 2 and len(linear) == 1:
        line = _isotropic(structure, some, others[0][0])
        return LeastAspects(parts, degrees, 4, line, _PLATFORMS) if line else None
    if len(parts) == 1 and degrees[0] % 2:
        return LeastAspects(parts, degrees, 2, None, _PLATFORMS)
    return None


@dataclass(frozen=True)
class _Translated:
    """A platform in an orientation, both at random: coordinates of all joints, of which those of one body move."""

    points: Mapping[str, Vector]
    moving: frozenset[str]

    @classmethod
    def random(cls, structure: Structure, number: int) -> _Translated:
        rng = drawn("least aspects", structure.legs, number)
        points = {n: tuple(rng.randrange(-_RANGE, _RANGE) for _ in range(3)) for n in structure.names}
        return cls(points, frozenset(structure.names) - set(structure.base))

    def leading(self, f: Expr, degree: int, direction: Vector) -> int:
        """The leading form of a factor of this degree in a direction, times degree!: the difference of that order."""
        values = [self._value(f, [s * c for c in direction]) for s in range(degree + 1)]
        for _ in range(degree):
            values = [b - a for a, b in pairwise(values)]
        return values[0]

    def degree(self, f: Expr) -> int:
        """Along a direction at random."""
        along = self.points[min(self.moving)]  # a random vector as good as any
        return next((d for d in range(_DEGREE, 0, -1) if self.leading(f, d, along)), 0)

    def direction(self, x: str, y: str) -> Vector:
        return tuple(b - a for a, b in zip(self.points[x], self.points[y], strict=True))

    def _value(self, f: Expr, shift: Vector) -> int:
        still = (0, 0, 0)
        there = {
            n: (*(c + s for c, s in zip(p, shift if n in self.moving else still, strict=True)), 1)
            for n, p in self.points.items()
        }
        return int(evaluate(f, there))


def _isotropic(structure: Structure, some: Sequence[_Translated], f: Expr) -> tuple[str, str] | None:
    """The first line of two joints of one body along which the leading form of degree 2 vanishes and changes sign."""
    for body in (structure.base, structure.platform):
        for x, y in combinations(body, 2):
            if any(one.leading(f, 2, one.direction(x, y)) for one in some):
                continue
            along, one = some[0].direction(x, y), some[0]
            sums = (tuple(a + b for a, b in zip(along, axis, strict=True)) for axis in _AXES)
            if any(one.leading(f, 2, s) != one.leading(f, 2, axis) for s, axis in zip(sums, _AXES, strict=True)):
                return x, y  # the gradient there is not 0
    return None
