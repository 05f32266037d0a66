r"""The lengths of all three legs: the regions that slices at some lengths of the first one meet, and drives between.

In each slice the regions are exact. Two of slices that follow each other belong together where a drive of the first
leg from the one to the other, the lengths of the other two held, passes no singular lengths: an exact polynomial in the
square of the first length has no zero on the way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import lcm

import networkx as nx

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.poses.length_regions.asked import Range
from gcrules.poses.length_regions.integer_polynomials import interpolated, roots_between
from gcrules.poses.length_regions.sections import Part, Section
from gcrules.poses.length_regions.three_legs import ThreeLegs

__all__ = ["Solid", "solid"]

_DEGREE = 12

Node = tuple[int, int]


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
    for n, (one, other) in enumerate(pairwise(sections)):
        report_progress(f"drives between slices {n + 1} and {n + 2}")
        graph.add_edges_from(((n, a), (n + 1, b)) for a, b in _drives(legs, one, other))
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


def _drives(legs: ThreeLegs, one: Section, other: Section) -> Iterator[tuple[int, int]]:
    """The numbers of regions of two slices that a drive joins."""
    joined: set[tuple[int, int]] = set()
    numbers = [{cell: n for n, p in enumerate(s.parts) for cell in p.cells} for s in (one, other)]
    for here, there, back in ((one, other, False), (other, one, True)):
        own, others = numbers[::-1] if back else numbers
        for cell, a in own.items():
            checkpoint()
            lengths = here.witness(cell)
            reached = there.plane.cell_at(*(c**2 * there.scale for c in lengths))
            b = others.get(reached) if reached is not None else None
            if b is None or here.parts[a].modes != there.parts[b].modes:
                continue
            pair = (b, a) if back else (a, b)
            if pair not in joined and _regular(legs, lengths, one.square, other.square):
                joined.add(pair)
                yield pair


def _regular(legs: ThreeLegs, lengths: Sequence[Fraction], low: Fraction, high: Fraction) -> bool:
    """Whether no first length between those with these squares is singular; exact."""
    second, third = (c**2 for c in lengths)
    closing, scale = legs.closing(lcm(*(c.denominator for c in (low, high, second, third))))
    times = scale * scale
    a, b, y, z = (int(c * times) for c in (low, high, second, third))
    places, values = [], []
    for n in range(4 * _DEGREE):
        x = a + (b - a) * n // _DEGREE
        found = closing.singular((x, y, z))
        if found is not None:
            places.append(x)
            values.append(found)
        if len(places) == _DEGREE + 3:
            break
    p = interpolated(places, values)
    return 1 <= len(p) <= _DEGREE + 1 and not roots_between(p, Fraction(a), Fraction(b))
