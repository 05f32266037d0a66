r"""The lengths of all three legs: the regions that slices at some lengths of the first one meet, and drives between.

In each slice the regions are exact. Two of slices that follow each other belong together where a drive from the one to
the other passes no singular lengths: on it the squares of the lengths change evenly, and an exact polynomial of degree
12 has no zero on the way.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import lcm

import networkx as nx

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.core.dataclass import dataclass
from gcrules.poses.length_regions.asked import Range
from gcrules.poses.length_regions.integer_polynomials import interpolated, root_of, roots_between
from gcrules.poses.length_regions.sections import Part, Section
from gcrules.poses.length_regions.three_legs import ThreeLegs

__all__ = ["Solid", "solid"]

_DEGREE = 12

_TRIES = 6  # drives between two regions

Node = tuple[int, int]
Squares = tuple[Fraction, ...]


@dataclass(frozen=True)
class Solid:
    """The `slices` by their first length, and the regions that they meet, with those on the other side of a curve in
    some slice.
    """

    slices: tuple[float, ...]
    parts: tuple[Part, ...]
    neighbours: dict[int, set[int]]


def solid(legs: ThreeLegs, ranges: Sequence[Range], number: int) -> Solid:
    """Of so many slices, evenly between the ends of the first range."""
    low, high = ranges[0]
    at = [low + (high - low) * Fraction(2 * n + 1, 2 * number) for n in range(number)]
    sections = []
    for n, length in enumerate(at):
        report_progress(f"slice {n + 1} of {number}")
        sections.append(Section.of(legs, (1, 2), 0, length**2, ranges[1:]))
    graph: nx.Graph[Node] = nx.Graph()
    graph.add_nodes_from((n, k) for n, s in enumerate(sections) for k in range(len(s.parts)))
    for n in range(number - 1):
        report_progress(f"drives between slices {n + 1} and {n + 2}")
        _join(legs, sections, graph, n)
    groups = sorted(map(sorted, nx.connected_components(graph)))
    group_of = {node: g for g, own in enumerate(groups) for node in own}
    beside: dict[int, set[int]] = {g: set() for g in range(len(groups))}
    for n, s in enumerate(sections):
        for k, others in s.neighbours.items():
            beside[group_of[n, k]] |= {group_of[n, o] for o in others}
    parts = []
    for own in groups:
        best = max(own, key=lambda node: len(sections[node[0]].parts[node[1]].cells))
        parts.append(sections[best[0]].parts[best[1]])
    return Solid(tuple(map(float, at)), tuple(parts), beside)


def _join(legs: ThreeLegs, sections: Sequence[Section], graph: nx.Graph[Node], n: int) -> None:
    """Drives from regions of slice n to those of the next one with as many modes, where no drives join them yet."""
    one, other = sections[n], sections[n + 1]
    pairs = [(a, b) for a in range(len(one.parts)) for b in range(len(other.parts))]
    for a, b in pairs:
        first, second = one.parts[a], other.parts[b]
        if first.modes != second.modes:
            continue
        ends = [
            [(s.square, *(c * c for c in s.witness(cell))) for cell in p.cells]
            for s, p in ((one, first), (other, second))
        ]
        for start, end in _nearest(*ends):
            checkpoint()
            if nx.has_path(graph, (n, a), (n + 1, b)):
                break
            if _regular(legs, start, end):
                graph.add_edge((n, a), (n + 1, b))


def _nearest(one: Sequence[Squares], other: Sequence[Squares]) -> list[tuple[Squares, Squares]]:
    """The pairs of places that are nearest to each other in lengths, each with another first place."""
    found = []
    lengths = [[tuple(root_of(c, 1) for c in p) for p in places] for places in (one, other)]
    for start, here in zip(one, lengths[0], strict=True):
        far = [sum((a - b) ** 2 for a, b in zip(here, there, strict=True)) for there in lengths[1]]
        best = min(range(len(other)), key=far.__getitem__)
        found.append((far[best], start, other[best]))
    return [(start, end) for _, start, end in sorted(found)[:_TRIES]]


def _regular(legs: ThreeLegs, start: Squares, end: Squares) -> bool:
    """Whether no lengths are singular whose squares lie on the straight line from the one place to the other; exact."""
    closing, scale = legs.closing(lcm(_DEGREE, *(c.denominator for c in (*start, *end))))
    times = scale * scale  # a multiple of 12
    places, values = [], []
    for k in range(4 * _DEGREE):
        found = closing.singular(
            [int(a * times + (b - a) * (times // _DEGREE) * k) for a, b in zip(start, end, strict=True)]
        )
        if found is not None:
            places.append(k)
            values.append(found)
        if len(places) == _DEGREE + 3:
            break
    p = interpolated(places, values)
    return 1 <= len(p) <= _DEGREE + 1 and not roots_between(p, Fraction(0), Fraction(_DEGREE))
