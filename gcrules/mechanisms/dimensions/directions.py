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

from collections.abc import Iterator, Mapping
from itertools import combinations

from gcrules.conditions.dimensions.facts import TOLERANCE, Fact
from gcrules.conditions.dimensions.measures import Vector, classes, off_parallel, off_perpendicular
from gcrules.core.linear_algebra import cross

__all__ = ["direction_facts"]

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


def _perpendicular(at: Vectors, body: str, tolerance: float) -> Iterator[Fact]:
    for p, q in combinations(at, 2):
        off = off_perpendicular(at[p], at[q])
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
        offs = {c[0]: off_perpendicular(at[c[0]], normal) for c in several}
        flat = [c for c in several if offs[c[0]] <= tolerance or c[0] in (p, q)]
        if len(flat) > 2:
            known.append(frozenset(c[0] for c in flat))
            yield Fact("level", tuple(n for c in flat for n in c), body, max(offs[c[0]] for c in flat))
