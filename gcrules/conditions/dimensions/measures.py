r"""How far points, directions and lengths of bodies are from a fact.

Coordinates are exact: whole numbers or fractions. A deviation is a float that is 0 where the fact holds exactly, and
nowhere else, however small it is.

>>> from fractions import Fraction
>>> near = Fraction(1, 10**400)
>>> distance((0, 0, 0), (3, 4, 0)), distance((1, 0, 0), (1, 0, near)), off_parallel((1, 0, 0), (2, 0, 0))
(5.0, 1e-300, 0.0)
>>> unequal(2, 2 + near, 1.0), unequal(0, near**2, 1.0)
(1e-300, 1e-300)
>>> classes("abc", lambda m, n: 0.0 if {m, n} == {"a", "c"} else 1.0, 0.5)
[('a', 'c'), ('b',)]
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import combinations
from typing import Any, TypeVar

from gcrules.core.linear_algebra import cross

__all__ = [
    "LEAST",
    "Vector",
    "classes",
    "distance",
    "inner",
    "length",
    "minus",
    "off_parallel",
    "off_perpendicular",
    "part",
    "size_of",
    "square",
    "unequal",
]

Vector = Sequence[Any]
Name = TypeVar("Name")

LEAST = 1e-300
"""The deviation of what does not hold exactly, where floats cannot tell it from 0."""


def minus(p: Vector, q: Vector) -> tuple[Any, ...]:
    return tuple(a - b for a, b in zip(p, q, strict=True))


def inner(u: Vector, v: Vector) -> Any:
    """The inner product."""
    return sum(a * b for a, b in zip(u, v, strict=True))


def square(p: Vector, q: Vector) -> Any:
    """The square of the distance of two points, exactly."""
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def length(u: Vector) -> float:
    """The length of a vector."""
    return max(math.hypot(*map(float, u)), LEAST) if any(u) else 0.0


def distance(p: Vector, q: Vector) -> float:
    """The distance of two points."""
    return length(minus(p, q))


def size_of(places: Iterable[Vector]) -> float:
    """The largest distance between two of the points; 1 for one point."""
    return max((distance(p, q) for p, q in combinations(list(places), 2)), default=0.0) or 1.0


def part(value: Any, whole: float) -> float:
    """The size of a number as a part of a whole."""
    return max(abs(float(value)) / whole, LEAST) if value else 0.0


def unequal(one: Any, other: Any, whole: float) -> float:
    """By how much two lengths differ whose exact squares are known, as a part of a whole."""
    return part(one - other, max(math.sqrt(one) + math.sqrt(other), LEAST) * whole)


def off_parallel(u: Vector, v: Vector) -> float:
    """The sine of the angle between two directions."""
    return part(length(cross(u, v)), length(u) * length(v))


def off_perpendicular(u: Vector, v: Vector) -> float:
    """The cosine of the angle between two directions, or the sine of that between one and the plane normal to the
    other.
    """
    return part(inner(u, v), length(u) * length(v))


def classes(names: Iterable[Name], off: Callable[[Name, Name], float], within: float) -> list[tuple[Name, ...]]:
    """The names in classes, each with those that miss being the same as its first one by so much at most."""
    found: list[list[Name]] = []
    for name in names:
        own = next((c for c in found if off(c[0], name) <= within), None)
        if own is None:
            found.append([name])
        else:
            own.append(name)
    return [tuple(c) for c in found]
