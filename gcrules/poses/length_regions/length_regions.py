r"""The regions of the lengths of a robot's legs, in each of which the number of assembly modes is the same.

>>> found = length_regions("3-rpr")
>>> found.decided, found.counts
(True, {0: 1, 2: 1, 4: 2})
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.core.english import lettered
from gcrules.core.errors import InputError
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.length_regions.asked import Asked
from gcrules.poses.length_regions.drawn_strips import drawn_strips
from gcrules.poses.length_regions.integer_polynomials import root_of
from gcrules.poses.length_regions.report import LengthRange, LengthRegion, LengthRegions
from gcrules.poses.length_regions.sections import Part, Section
from gcrules.poses.length_regions.solid import solid
from gcrules.poses.length_regions.three_legs import ThreeLegs, three_legs

__all__ = ["SLICES", "length_regions"]

SLICES = 12
_CUSP = 3  # the order of a critical line through one
_CROSSING = (2, 2)  # branches left and right of it


def length_regions(
    source: Source,
    *,
    over: str | None = None,
    held: str | None = None,
    slices: int = SLICES,
    plugins: Folders = (),
) -> LengthRegions:
    """Into how many regions singular lengths cut the lengths of two or three legs, and how many modes each has.

    `source` is what `load` takes: a planar robot on three legs of variable length, R(A, z) P*(A B) R(B, z). Legs are
    named by their actuators; numbers are lengths, not amounts from home. `over` gives the ranges that are looked at,
    "q2 0.1..4, q3 ..4"; ends that are left out are 0 and what cannot be reached, which no range goes beyond. One leg is
    `held`, at home's length or at one that is given, "q1=1"; by default it is the first one without a range. Numbers
    are exact as written, ends of ranges to 15 digits, and those with many digits take long.

    Over two lengths the number of regions is exact; for special dimensions it may be an interval, from `least` to
    `most`. With ranges of all three legs the regions are those that so many `slices` meet, joined by proved drives.

    Raises InputError for what is asked for wrongly, for other robots, and for dimensions whose singular lengths are no
    curve without multiple parts.
    """
    legs = three_legs(mechanism(source, plugins=plugins))
    asked = Asked.of(legs, over, held)
    if asked.held is None:
        if not 2 <= slices <= 1000:
            raise InputError(f"{slices} slices, expected 2 to 1000")
        return _of_solid(legs, asked, slices)
    return _of_plane(legs, asked)


def _of_plane(legs: ThreeLegs, asked: Asked) -> LengthRegions:
    first, second = asked.free
    assert asked.held is not None
    section = Section.of(legs, (first, second), asked.held, asked.square, asked.ranges)
    parts = section.parts
    names = _names([p.modes for p in parts])
    of_cells = {cell: names[n] for n, p in enumerate(parts) for cell in p.cells}
    beside = section.neighbours
    scale = section.scale
    cusps, crossings = [], []
    for point in section.plane.double:
        line = section.plane.lines[point.number]
        place = root_of((line.low + line.high) / 2, scale), root_of(point.middle, scale)
        if line.order == _CUSP:
            cusps.append(place)
        elif point.ends == _CROSSING:
            crossings.append(place)
    home = [legs.squares[k] * scale for k in asked.free]
    at_home = legs.squares[asked.held] == asked.square and section.holds(*home)
    cell = section.plane.cell_at(*home) if at_home else None
    return LengthRegions(
        title=legs.title,
        names=legs.names,
        over=_ranges(legs, asked),
        held=((legs.names[asked.held], root_of(asked.square, 1)),),
        regions=_regions(legs, names, parts, {n: [names[k] for k in own] for n, own in beside.items()}),
        least=len(section.plane.parts(unsure=True)),
        cusps=tuple(cusps),
        crossings=tuple(crossings),
        home=of_cells.get(cell, "") if cell else "",
        strips=drawn_strips(section.plane, scale, of_cells),
    )


def _of_solid(legs: ThreeLegs, asked: Asked, slices: int) -> LengthRegions:
    found = solid(legs, asked.ranges, slices)
    names = _names([p.modes for p in found.parts])
    beside = {n: [names[k] for k in own] for n, own in found.neighbours.items()}
    return LengthRegions(
        title=legs.title,
        names=legs.names,
        over=_ranges(legs, asked),
        held=(),
        regions=_regions(legs, names, found.parts, beside),
        least=len({p.modes for p in found.parts}),
        slices=found.slices,
    )


def _names(modes: Sequence[int]) -> list[str]:
    """A for the first with the fewest modes, and so on."""
    order = sorted(range(len(modes)), key=lambda n: modes[n])
    return [lettered(order.index(n)) for n in range(len(modes))]


def _ranges(legs: ThreeLegs, asked: Asked) -> tuple[LengthRange, ...]:
    both = zip(asked.free, asked.ranges, strict=True)
    return tuple(LengthRange(legs.names[k], float(low), float(high)) for k, (low, high) in both)


def _regions(
    legs: ThreeLegs, names: Sequence[str], parts: Sequence[Part], beside: Mapping[int, Sequence[str]]
) -> tuple[LengthRegion, ...]:
    home = [root_of(s, 1) for s in legs.squares]
    order = {name: k for k, name in enumerate(sorted(names, key=lambda w: (len(w), w)))}
    found = []
    for n, part in enumerate(parts):
        lengths = [root_of(s, 1) for s in part.squares]
        amounts = [way * (a - b) for way, a, b in zip(legs.forward, lengths, home, strict=True)]
        others = tuple(sorted(beside.get(n, ()), key=order.__getitem__))
        found.append(LengthRegion(names[n], part.modes, tuple(lengths), tuple(amounts), others))
    return tuple(sorted(found, key=lambda r: order[r.name]))
