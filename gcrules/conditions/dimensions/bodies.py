"""Joints of one body that coincide, or lie on a line, a plane, a circle or a conic: exactly, or within a tolerance.

>>> square = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (1, 1, 0), "D": (0, 1, 0), "E": (0, 1, 0)}
>>> for fact in body_facts(square, "base"):
...     print(fact.sentence)
D and E of the base coincide (exactly)
A, B, C, D and E of the base are in one plane (exactly)
A, B, C, D and E of the base are on one circle (exactly)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.conditions.dimensions.facts import TOLERANCE, Fact
from gcrules.conditions.dimensions.measures import LEAST, Vector, classes, distance, minus, part, size_of
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import cross, rank

__all__ = ["body_facts", "deviation"]

Places = Mapping[str, Vector]


def body_facts(places: Places, body: str, tolerance: float = TOLERANCE) -> tuple[Fact, ...]:
    """The facts of the joints of one body. Joints that coincide count once in all others, and are named together."""
    size = size_of(places.values())
    together = classes(places, lambda m, n: part(distance(places[m], places[n]), size), tolerance)
    found = [
        Fact("coincident", names, body, part(_spread([places[n] for n in names]), size))
        for names in together
        if len(names) > 1
    ]
    first = {names[0]: places[names[0]] for names in together}
    family = {names[0]: names for names in together}
    lines = list(_flats(first, 2, (), size, tolerance))
    planes = list(_flats(first, 3, [set(names) for names, _ in lines], size, tolerance))
    for kind, flats in (("collinear", lines), ("coplanar", planes)):
        found += [Fact(kind, _all(names, family), body, off) for names, off in flats]
        for names, off in planes if kind == "coplanar" else ():
            found += [
                replace(fact, members=_all(fact.members, family))
                for fact in _curves(names, off, first, body, size, tolerance)
            ]
    return tuple(found)


def _all(names: Sequence[str], family: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    return tuple(one for name in names for one in family[name])


def _spread(places: Sequence[Vector]) -> float:
    """The largest distance from the first."""
    return max(distance(places[0], p) for p in places)


# --- lines and planes ---


def _flats(
    places: Places, span: int, lines: Sequence[set[str]], size: float, tolerance: float
) -> Iterator[tuple[tuple[str, ...], float]]:
    """The largest sets of more joints than span a flat (a line by 2, a plane by 3) that lie on one, with the
    deviation. In a plane, joints that are on one line but for one are no news.
    """
    known: list[frozenset[str]] = []
    for chosen in combinations(places, span):
        checkpoint()
        if any(set(chosen) <= flat for flat in known):
            continue
        off = _distance_from_flat([places[n] for n in chosen], size * tolerance)
        if off is None:
            continue
        within = frozenset(n for n in places if n in chosen or off(places[n]) <= size * tolerance)
        if len(within) > span and not any(within <= flat for flat in known):
            known.append(within)
    for flat in known:
        if any(flat < other for other in known) or any(len(flat - line) <= 1 for line in lines):
            continue
        names = tuple(n for n in places if n in flat)
        yield names, deviation([places[n] for n in names], span, size)


def _distance_from_flat(chosen: Sequence[Vector], least: float) -> Callable[[Vector], float] | None:
    """The distance from the line or the plane of some places; None where they span none."""
    p, *others = [tuple(map(float, c)) for c in chosen]
    along = minus(others[0], p)
    if len(chosen) == 2:
        length = math.hypot(*along)
        return lambda q: math.hypot(*cross(minus(tuple(map(float, q)), p), along)) / length
    normal = cross(along, minus(others[1], p))
    length = math.hypot(*normal)
    if length <= least * max(math.hypot(*along), math.dist(p, others[1]), math.dist(*others)):
        return None  # nearly on one line
    return lambda q: abs(sum(n * c for n, c in zip(normal, minus(tuple(map(float, q)), p), strict=True))) / length


def deviation(places: Sequence[Vector], span: int, size: float) -> float:
    """The largest distance from the line or the plane of those of the places that span it best; 0 exactly where the
    rank of the places says so.
    """
    if rank([minus(p, places[0]) for p in places[1:]]) < span:
        return 0.0
    best = max(combinations(places, span), key=_extent)
    off = _distance_from_flat(best, 0.0)
    return part(max(map(off, places)) or LEAST, size) if off else LEAST


def _extent(places: Sequence[Vector]) -> float:
    p, q, *more = [tuple(map(float, c)) for c in places]
    return math.hypot(*cross(minus(q, p), minus(more[0], p))) if more else math.dist(p, q)


# --- circles and conics ---


def _curves(
    names: tuple[str, ...], flat: float, places: Places, body: str, size: float, tolerance: float
) -> Iterator[Fact]:
    """Whether four or more joints of a plane are all on a circle, or else six or more on a conic (asked exactly)."""
    at = [places[n] for n in names]
    if len(names) > 3:
        exact = not flat and rank([(1, *p, sum(c * c for c in p)) for p in at]) == 3
        off = 0.0 if exact else max(_off_circle(at) / size, flat, LEAST)
        if off <= tolerance:
            yield Fact("circle", names, body, off)
            return
    if len(names) > 5 and not flat:
        u, v = _seen_along([minus(p, at[0]) for p in at])
        if rank([(1, p[u], p[v], p[u] * p[u], p[u] * p[v], p[v] * p[v]) for p in at]) < 6:
            yield Fact("conic", names, body)


def _seen_along(places: Sequence[Vector]) -> tuple[int, int]:
    """Two axes so that no two places of a plane coincide when they are seen along the third."""
    return next((u, v) for u, v in ((0, 1), (0, 2), (1, 2)) if rank([(p[u], p[v]) for p in places]) == 2)


def _off_circle(places: Sequence[Vector]) -> float:
    """How far the places are from the circle through three of them: by the differences of their distances from its
    centre.
    """
    p, q, r = max(combinations([tuple(map(float, c)) for c in places], 3), key=_extent)
    u, v = minus(q, p), minus(r, p)
    normal = cross(u, v)
    uu, vv, nn = (sum(c * c for c in w) for w in (u, v, normal))
    first, second = cross(v, normal), cross(normal, u)
    centre = tuple(c + (uu * a + vv * b) / (2 * nn) for c, a, b in zip(p, first, second, strict=True))
    radius = math.dist(p, centre)
    return max(abs(distance(s, centre) - radius) for s in places)
