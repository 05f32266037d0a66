"""Directions of one body that are parallel, perpendicular, or parallel to one plane: exactly, or within a tolerance.

>>> at = {"u": (1, 0, 0), "v": (2, 0, 0), "w": (0, 3, 0), "n": (1, 1, 0)}
>>> for fact in direction_facts(at, "base"):
...     print(fact.sentence)
the directions u and v of the base are parallel (exactly)
the directions u and w of the base are perpendicular to each other (exactly)
the directions v and w of the base are perpendicular to each other (exactly)
the directions u, v, w and n of the base are parallel to one plane (exactly)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any

from gcrules.conditions.dimensions.facts import LEAST, TOLERANCE, Fact
from gcrules.core.linear_algebra import cross

__all__ = ["classes", "direction_facts", "inner", "off_parallel"]

Vector = Sequence[Any]  # whole numbers or fractions
Vectors = Mapping[str, Vector]


def direction_facts(at: Vectors, body: str, tolerance: float = TOLERANCE) -> tuple[Fact, ...]:
    """The facts of the directions of a body, none of which is 0; deviations are sines of angles. Perpendicular ones are
    told pair by pair.
    """
    return (*_parallel(at, body, tolerance), *_perpendicular(at, body, tolerance), *_level(at, body, tolerance))


def _parallel(at: Vectors, body: str, tolerance: float) -> Iterator[Fact]:
    for names in classes(at, lambda p, q: off_parallel(at[p], at[q]), tolerance):
        if len(names) > 1:
            yield Fact("parallel", names, body, max(off_parallel(at[names[0]], at[n]) for n in names))


def classes(names: Iterable[str], off: Callable[[str, str], float], within: float) -> list[tuple[str, ...]]:
    """The names in classes, each with those that miss being the same as its first one by so much at most."""
    found: list[list[str]] = []
    for name in names:
        own = next((c for c in found if off(c[0], name) <= within), None)
        if own is None:
            found.append([name])
        else:
            own.append(name)
    return [tuple(c) for c in found]


def _perpendicular(at: Vectors, body: str, tolerance: float) -> Iterator[Fact]:
    for p, q in combinations(at, 2):
        off = _part(inner(at[p], at[q]), math.hypot(*map(float, at[p])) * math.hypot(*map(float, at[q])))
        if off <= tolerance:
            yield Fact("perpendicular", (p, q), body, off)


def _level(at: Vectors, body: str, tolerance: float) -> Iterator[Fact]:
    """The largest sets of three or more directions, no two of them parallel, that are parallel to one plane."""
    several = classes(at, lambda p, q: off_parallel(at[p], at[q]), tolerance)
    known: list[frozenset[str]] = []
    for p, q in combinations([c[0] for c in several], 2):
        if any({p, q} <= flat for flat in known):
            continue
        normal = cross(at[p], at[q])
        offs = {c[0]: _from_plane(at[c[0]], normal) for c in several}
        flat = [c for c in several if offs[c[0]] <= tolerance or c[0] in (p, q)]
        if len(flat) > 2:
            known.append(frozenset(c[0] for c in flat))
            yield Fact("level", tuple(n for c in flat for n in c), body, max(offs[c[0]] for c in flat))


def _from_plane(u: Vector, normal: Vector) -> float:
    return _part(inner(u, normal), math.hypot(*map(float, u)) * math.hypot(*map(float, normal)))


def off_parallel(u: Vector, v: Vector) -> float:
    """The sine of the angle between two directions, 0 exactly where they are parallel."""
    turned = cross(u, v)
    if not any(turned):
        return 0.0
    size = math.hypot(*map(float, u)) * math.hypot(*map(float, v))
    return max(math.hypot(*map(float, turned)) / size, LEAST)


def inner(u: Vector, v: Vector) -> Any:
    """The inner product."""
    return sum(a * b for a, b in zip(u, v, strict=True))


def _part(value: Any, whole: float) -> float:
    return max(abs(float(value)) / whole, LEAST) if value else 0.0
