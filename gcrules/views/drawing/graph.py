"""The leg graph as a schematic: joints of the base below, joints of the platform above."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations, permutations
from math import cos, pi, sin

from gcrules.algebra.language.legs_text import legs_text
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Run, Shape, Stroke, Text, name_runs, text_width
from gcrules.views.drawing.labels import Label, place_labels
from gcrules.views.drawing.legend import ROW, EntityLike, entity_entries, legend, legend_width, rounded
from gcrules.views.drawing.palette import entity_role

__all__ = [
    "Legs",
    "count_crossings",
    "draw_graph",
    "layered_order",
    "ring_order",
    "shortened",
    "widest_name",
]

Legs = Sequence[tuple[str, str]]

_SPACING = 74.0
_LEAST_WIDTH = 230.0
_HEIGHT = 150.0
_MARGIN = 42.0
_JOINT = 5.5
_AREA = 15.0
_LONGEST = 15  # letters of a name
_APART = 14.0  # names beside each other
_NAMES = 15.0  # their size


def draw_graph(
    legs: Legs,
    base: Sequence[str],
    platform: Sequence[str],
    entities: Sequence[EntityLike] = (),
    *,
    key: bool = True,
    bodies: bool = True,
) -> Drawing:
    """A schematic of the legs; the order within each row is chosen for few crossings.

    `base` and `platform` hold the points of the two bodies; where a leg does not run from one to the other (or both are
    empty) the points stand on a circle instead. Each entity is an area around its points, a line is dashed. Entities
    with other points are left out of the picture but not of the legend (`key`). Without `bodies` the two rows are no
    more than rows, as of lines that stand for the limbs of a robot: they have no names, and all points look alike.
    """
    layered = bool(legs) and all((a in base) != (b in base) and (a in platform) != (b in platform) for a, b in legs)
    at = _rows(legs, base, platform) if layered else _circle(legs)
    xs, ys = [x for x, _ in at.values()], [y for _, y in at.values()]
    margin = max(_MARGIN, widest_name(at) / 2 + 6)
    named = layered and bodies
    left = margin + (46 if named else 0)
    shift = (left - min(xs), _MARGIN - min(ys))
    at = {name: (x + shift[0], y + shift[1]) for name, (x, y) in at.items()}
    entries = entity_entries(entities) if key else []
    side = legend_width(entries)
    width = left + max(xs) - min(xs) + margin + (side + 16 if entries else 0)
    height = max(max(ys) - min(ys) + 2 * _MARGIN, ROW * len(entries) + 24)
    shapes = [
        *_areas(at, entities),
        *_strokes(at, legs, entities),
        *_joints(at, platform if bodies else ()),
        *_labels(at, legs, layered, bool(entities)),
        *(_row_names(at, base, platform) if named else ()),
        *legend(entries, width - side - 12, 12),
    ]
    return Drawing(width, height, tuple(shapes), f"Leg graph: {legs_text(legs)}")


def layered_order(legs: Legs, base: Sequence[str], platform: Sequence[str]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Orders of the points of both bodies with few crossings of legs.

    Every order of the smaller side is tried (up to six points, the order as given beyond), the other side follows by
    the mean place of its neighbours and by exchanging neighbours while that helps. Among equals the first in order of
    the names as given wins.
    """
    used = {name for leg in legs for name in leg}
    low, high = [p for p in base if p in used], [p for p in platform if p in used]
    if len(low) > len(high):
        upper, lower = layered_order(legs, high, low)
        return lower, upper
    candidates = permutations(low) if len(low) <= 6 else iter([tuple(low)])
    best: tuple[int, tuple[str, ...], tuple[str, ...]] | None = None
    for order in candidates:
        other = _follow(legs, order, high)
        crossings = count_crossings(legs, order, other)
        if best is None or crossings < best[0]:
            best = crossings, order, other
            if crossings == 0:
                break
    return (best[1], best[2]) if best else ((), ())


def count_crossings(legs: Legs, lower: Sequence[str], upper: Sequence[str]) -> int:
    """How many pairs of legs cross when both rows are drawn in these orders."""
    low = {name: i for i, name in enumerate(lower)}
    high = {name: i for i, name in enumerate(upper)}
    ends = [(low[a], high[b]) if a in low else (low[b], high[a]) for a, b in legs]
    return sum((p[0] - q[0]) * (p[1] - q[1]) < 0 for p, q in combinations(ends, 2))


def ring_order(legs: Legs) -> list[str]:
    """All points of the legs in an order that follows the legs, for a circle."""
    names = list(dict.fromkeys(name for leg in legs for name in leg))
    order: list[str] = []
    for start in names:
        stack = [start]
        while stack:
            name = stack.pop()
            if name not in order:
                order.append(name)
                near = [b if a == name else a for a, b in legs if name in (a, b)]
                stack += [n for n in reversed(near) if n not in order]
    return order


def _follow(legs: Legs, order: tuple[str, ...], others: Sequence[str]) -> tuple[str, ...]:
    place = {name: i for i, name in enumerate(order)}
    mean = {}
    for name in others:
        near = [place[a if b == name else b] for a, b in legs if name in (a, b)]
        mean[name] = sum(near) / len(near)
    found = sorted(others, key=lambda name: mean[name])
    crossings = count_crossings(legs, order, found)
    improved = True
    while improved and crossings:
        improved = False
        for i in range(len(found) - 1):
            swapped = [*found[:i], found[i + 1], found[i], *found[i + 2 :]]
            fewer = count_crossings(legs, order, swapped)
            if fewer < crossings:
                found, crossings, improved = swapped, fewer, True
    return tuple(found)


def _rows(legs: Legs, base: Sequence[str], platform: Sequence[str]) -> dict[str, XY]:
    lower, upper = layered_order(legs, base, platform)
    count = max(len(lower), len(upper))
    width = max(max(_SPACING, widest_name((*lower, *upper)) + _APART) * count, _LEAST_WIDTH)
    at = {}
    for row, y in ((lower, _HEIGHT), (upper, 0.0)):
        gap = width / len(row)
        for i, name in enumerate(row):
            at[name] = (gap * (i + 0.5), y)
    return at


def widest_name(names: Iterable[str]) -> float:
    """The width of the longest of the names, as they are drawn: each without its middle if it is long."""
    return max((text_width(Text((0, 0), name_runs(shortened(name)), _NAMES)) for name in names), default=0.0)


def shortened(name: str) -> str:
    """A long name without its middle.

    >>> shortened("left_front_corner_of_the_base")
    'left_fr…e_base'
    """
    half = _LONGEST // 2
    return name if len(name) <= _LONGEST else f"{name[:half]}…{name[1 - half :]}"


def _circle(legs: Legs) -> dict[str, XY]:
    names = ring_order(legs)
    radius = max(80.0, len(names) * 19.0)
    angles = [2 * pi * i / len(names) - pi / 2 for i in range(len(names))]
    return {name: (radius * cos(a), radius * sin(a)) for name, a in zip(names, angles, strict=True)}


def _areas(at: Mapping[str, XY], entities: Sequence[EntityLike]) -> list[Shape]:
    shapes: list[Shape] = []
    for i, e in enumerate(entities):
        if e.kind != "line" and all(name in at for name in e.points):
            outline = rounded([at[name] for name in e.points], _AREA - 1.5 * (i % 4))
            shapes.append(Polygon(outline, entity_role(i), entity_role(i), fill_opacity=0.16, width=1.5))
    return shapes


def _strokes(at: Mapping[str, XY], legs: Legs, entities: Sequence[EntityLike]) -> list[Shape]:
    """Legs, and lines of entities; a leg that is such a line is drawn in its colour."""
    lines = {frozenset(e.points): entity_role(i) for i, e in enumerate(entities) if e.kind == "line"}
    strokes = [Stroke(at[a], at[b], "leg", 2.6) for a, b in legs if frozenset((a, b)) not in lines]
    for names, role in lines.items():
        if len(names) == 2 and all(name in at for name in names):
            first, second = sorted(names)
            strokes.append(Stroke(at[first], at[second], role, 3.0, dash=(7, 4)))
    return list(strokes)


def _joints(at: Mapping[str, XY], platform: Sequence[str]) -> list[Shape]:
    return [Circle(xy, _JOINT, "paper" if name in platform else "ink", "ink", 1.6) for name, xy in at.items()]


def _labels(at: Mapping[str, XY], legs: Legs, layered: bool, areas: bool) -> list[Text]:
    middle = (sum(x for x, _ in at.values()) / len(at), sum(y for _, y in at.values()) / len(at))
    labels = []
    for name, (x, y) in at.items():
        toward = (0.0, y - middle[1]) if layered else (x - middle[0], y - middle[1])
        labels.append(Label(name_runs(shortened(name)), (x, y), toward, _AREA if areas else _JOINT + 2, _NAMES))
    return place_labels(labels, discs=[(xy, _JOINT) for xy in at.values()], strokes=[(at[a], at[b]) for a, b in legs])


def _row_names(at: Mapping[str, XY], base: Sequence[str], platform: Sequence[str]) -> list[Shape]:
    rows = (("platform", platform), ("base", base))
    return [
        Text((8, next(at[n][1] for n in names if n in at) + 4), (Run(word),), 12, fill="muted") for word, names in rows
    ]
