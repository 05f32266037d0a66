"""Axes of joints on one body that coincide, meet in one point, or lie in one plane: exactly, or within a tolerance.

>>> lines = {"Au": ((0, 0, 0), (1, 0, 0)), "Bv": ((0, 2, 0), (0, 1, 0)), "Cw": ((3, 0, 0), (2, 0, 0))}
>>> for fact in axis_facts(lines | {"Dn": ((0, 0, 5), (0, 0, 1))}, "base"):
...     print(fact.sentence)
the axes Au and Cw of the base coincide (exactly)
the axes Au, Cw, Bv and Dn of the base meet in one point (exactly)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

from gcrules.conditions.dimensions.facts import TOLERANCE, Fact
from gcrules.conditions.dimensions.measures import (
    Vector,
    classes,
    inner,
    length,
    minus,
    off_parallel,
    off_perpendicular,
    part,
    size_of,
)
from gcrules.core.linear_algebra import cross

__all__ = ["Line", "axis_facts"]

Line = tuple[Vector, Vector]
"""A point of it and its direction."""
Lines = Mapping[str, Line]


def axis_facts(lines: Lines, body: str, tolerance: float = TOLERANCE, size: float = 0.0) -> tuple[Fact, ...]:
    """The facts of the axes of a body of that size (that of their points where none is told). Axes that coincide count
    once in all others, and are named together; that two axes of one plane meet is no news.
    """
    size = size or size_of([p for p, _ in lines.values()])
    together = classes(lines, lambda m, n: _apart(lines[m], lines[n], size), tolerance)
    found = [
        Fact("same axis", names, body, max(_apart(lines[names[0]], lines[n], size) for n in names))
        for names in together
        if len(names) > 1
    ]
    first = {names[0]: names for names in together}
    flats = list(_flats(lines, [*first], size, tolerance))
    meets = [
        (some, off)
        for some, off in _meets(lines, [*first], size, tolerance)
        if len(some) > 2 or not any(set(some) <= set(flat) for flat, _ in flats)
    ]
    for kind, sets in (("meet", meets), ("flat axes", flats)):
        found += [Fact(kind, tuple(n for one in some for n in first[one]), body, off) for some, off in sets]
    return tuple(found)


def _apart(m: Line, n: Line, size: float) -> float:
    """How far two lines are from being one: by their angle, and by the distance of the point of the second."""
    return max(off_parallel(m[1], n[1]), part(_distance(n[0], m), size))


def _distance(p: Vector, line: Line) -> float:
    """The distance of a point from a line."""
    return part(length(cross(minus(p, line[0]), line[1])), length(line[1]))


def _meets(
    lines: Lines, names: Sequence[str], size: float, tolerance: float
) -> Iterator[tuple[tuple[str, ...], float]]:
    """The largest sets of axes through one point, which two of them have in common."""
    known: list[frozenset[str]] = []
    for m, n in combinations(names, 2):
        if any({m, n} <= some for some in known) or off_parallel(lines[m][1], lines[n][1]) <= tolerance:
            continue
        point = _nearest(lines[m], lines[n])
        offs = {o: part(_distance(point, lines[o]), size) for o in names}
        some = tuple(o for o in names if offs[o] <= tolerance)
        if m in some and n in some:
            known.append(frozenset(some))
            yield some, max(offs[o] for o in some)


def _nearest(m: Line, n: Line) -> tuple[Fraction, ...]:
    """The middle of the points at which two lines are nearest: where they meet, if they do."""
    (p, d), (q, e) = m, n
    normal = cross(d, e)
    square, between = Fraction(inner(normal, normal)), minus(q, p)
    s, t = inner(cross(between, e), normal) / square, inner(cross(between, d), normal) / square
    return tuple((a + s * u + b + t * v) / 2 for a, u, b, v in zip(p, d, q, e, strict=True))


def _flats(
    lines: Lines, names: Sequence[str], size: float, tolerance: float
) -> Iterator[tuple[tuple[str, ...], float]]:
    """The largest sets of three or more axes in one plane, that of two of them."""
    known: list[frozenset[str]] = []
    for m, n in combinations(names, 2):
        if any({m, n} <= some for some in known):
            continue
        (p, d), (q, e) = lines[m], lines[n]
        normal = cross(d, e) if off_parallel(d, e) > tolerance else cross(d, minus(q, p))
        offs = {o: _from_plane(lines[o], p, normal, size) for o in names}
        some = tuple(o for o in names if offs[o] <= tolerance)
        if len(some) > 2 and {m, n} <= set(some):
            known.append(frozenset(some))
            yield some, max(offs[o] for o in some)


def _from_plane(line: Line, p: Vector, normal: Vector, size: float) -> float:
    """How far a line is from a plane: by its angle, and by the distance of its point."""
    return max(off_perpendicular(line[1], normal), part(inner(minus(line[0], p), normal), length(normal) * size))
