"""Home of a sheet as numbers: turned about z, and moved to where the relations put it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import atan2, cos, hypot, pi, radians, sin

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.family import Definition, Family
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.editing.sheet import Place, Sheet
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS

__all__ = [
    "Vector",
    "coordinate",
    "evenly_turned",
    "fitted",
    "on_axis",
    "place_of",
    "quarter",
    "size_of",
    "turned",
    "vector_of",
]

Vector = tuple[float, float, float]

_DIGITS = 9
_NEAR = 1e-7
_START = 0.7  # of the robot's size: how far from z a point is put of which nothing is known


def vector_of(at: Place) -> Vector:
    """The coordinates as floats; 0 for what is no number, or is not there."""

    def number(text: str) -> float:
        try:
            return float(Fraction(text))
        except (ValueError, ZeroDivisionError, OverflowError):
            return 0.0

    x, y, z = map(number, at)
    return x, y, z


def place_of(v: Sequence[float]) -> Place:
    """The coordinates as they are written."""
    x, y, z = map(coordinate, v)
    return x, y, z


def coordinate(value: float) -> str:
    """A number as the file has it, with as many decimals as it needs.

    >>> coordinate(1.2000000001), coordinate(-0.0), coordinate(1500.0)
    ('1.2', '0', '1500')
    """
    text = f"{value:.{_DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def size_of(sheet: Sheet) -> float:
    """The largest distance of a point from z, or its height; 1 where there is nothing."""
    points = [vector_of(at) for n, at in sheet.home.items() if (row := sheet.row(n)) and row.sort == "point"]
    return max((max(hypot(x, y), abs(z)) for x, y, z in points), default=0.0) or 1.0


def turned(v: Sequence[float], degrees: float) -> Vector:
    """Turned about z."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    x, y, z = v
    return c * x - s * y, s * x + c * y, z


def on_axis(v: Sequence[float], size: float) -> bool:
    """Whether a point lies on z, or a direction is along it."""
    return hypot(v[0], v[1]) <= _NEAR * size


def evenly_turned(sheet: Sheet) -> bool:
    """Whether copies are at home where the first one comes when it is turned about z, evenly."""
    size = size_of(sheet)
    for row in sheet.names:
        places = [vector_of(sheet.home[n]) for n in sheet.numbers(row.name) if n in sheet.home]
        for k, place in enumerate(places):
            wanted = turned(places[0], 360.0 / max(1, sheet.copies) * k)
            if max(abs(a - b) for a, b in zip(place, wanted, strict=True)) > 1e-6 * size:
                return False
    return True


def quarter(v: Sequence[float]) -> Vector:
    """A horizontal direction across that to a point: along y for a point on x."""
    angle = atan2(v[1], v[0]) + pi / 2
    return cos(angle), sin(angle), 0.0


def fitted(robot: Robot, home: Mapping[str, Place], size: float) -> Mapping[str, Place]:
    """Home with what violates its relation moved to the nearest place that does not, and what is missing put somewhere;
    what relations determine is left out where it violates them.
    """
    family = robot.family
    values: dict[str, Vector] = {n: (float(a), float(b), float(c)) for n, (a, b, c) in AXES.items()}
    found = {n: at for n, at in home.items() if n not in family.sorts}
    for count, d in enumerate(family.definitions):
        given = home.get(d.name)
        if given and _satisfied(d, values, vector_of(given)):
            values[d.name], found[d.name] = vector_of(given), given
            continue
        values[d.name] = _nearest(d, values, vector_of(given) if given else _somewhere(family, count, size))
        if d.parameters:
            found[d.name] = place_of(values[d.name])
            values[d.name] = vector_of(found[d.name])
    order = {n: k for k, n in enumerate(dict.fromkeys([*home, *found]))}
    return FrozenMap(sorted(found.items(), key=lambda entry: order[entry[0]]))


def _somewhere(family: Family, count: int, size: float) -> Vector:
    angle = 2.4 * count
    lift = 0.0 if family.plane else size * _START * (count % 3) / 2
    return size * _START * cos(angle), size * _START * sin(angle), lift


def _satisfied(d: Definition, values: Mapping[str, Vector], own: Vector) -> bool:
    residual = d.relation.residual(d.sort, FLOATS, values, own)
    largest = max((abs(c) for v in (*values.values(), own) for c in v), default=1.0) or 1.0
    return all(abs(float(r)) <= 1e-8 * largest**3 for r in residual) and (d.sort == "point" or any(own))


def _nearest(d: Definition, values: Mapping[str, Vector], wish: Vector) -> Vector:
    """The value of the relation that is nearest to a wish; values are affine in the parameters."""
    count = d.parameters
    units = [[float(i == k) for i in range(count)] for k in range(count)]
    try:
        origin, *ends = (
            tuple(map(float, d.relation.value(d.sort, FLOATS, values, t))) for t in ([0.0] * count, *units)
        )
    except InputError:
        return wish
    span: list[Vector] = []
    for end in ends:
        v = _less(end, origin)
        length = _dot(v, v) ** 0.5
        for u in span:
            v = _less(v, _times(u, _dot(u, v)))
        if _dot(v, v) ** 0.5 > _NEAR * length:
            span.append(_times(v, _dot(v, v) ** -0.5))
    found: Vector = (origin[0], origin[1], origin[2])
    gap = _less(wish, found)
    for u in span:
        found = _less(found, _times(u, -_dot(u, gap)))
    return span[0] if d.sort == "direction" and span and _dot(found, found) ** 0.5 < _NEAR else found


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(p * q for p, q in zip(a, b, strict=True))


def _less(a: Sequence[float], b: Sequence[float]) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _times(a: Sequence[float], factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor
