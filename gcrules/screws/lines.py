r"""Linear families of lines: pencils, bundles and plane fields, which are the spans of screws that are all lines.

Such a span is totally isotropic: the reciprocal product of any two of its screws is zero. Its dimension is at most
3, and the points that all of its lines pass through and the planes that all of them lie in say which one it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.screws.field import Field, Row

__all__ = ["LineFamily", "common_planes", "common_points", "family", "number_text", "vector_text"]


@dataclass(frozen=True)
class LineFamily:
    """Lines, as forces: `kind` is force | couple | planar pencil | parallel pencil | two couples | bundle |
    parallel bundle | plane field | all couples; `rows` is a basis (f; m).

    `point` (x, y, z, w) is on all lines: the vertex of a pencil or bundle (w = 0 for parallel lines), for a force its
    point nearest to the origin. `plane` (a, b, c, d), ax + by + cz + d = 0, holds all lines of a pencil or plane field;
    couples are lines in the plane (0, 0, 0, 1) at infinity. Both are None where they are not determined.
    """

    kind: str
    rows: tuple[Row, ...]
    point: Row | None = None
    plane: Row | None = None

    @property
    def direction(self) -> Row | None:
        """That of a force or of parallel lines, the moment of a couple, the normal of two couples; else None."""
        if len(self.rows) == 1:
            force, moment = self.rows[0][:3], self.rows[0][3:]
            return moment if self.kind == "couple" else force
        return self.point[:3] if self.point and not self.point[3] else None

    def stretched(self, length: Any) -> LineFamily:
        """The family with all points so much further from the origin."""
        rows = self.rows if self.kind == "couple" else tuple((*r[:3], *(x * length for x in r[3:])) for r in self.rows)
        point = (*(x * length for x in self.point[:3]), 1.0) if self.point and self.point[3] else self.point
        plane = (*self.plane[:3], self.plane[3] * length) if self.plane and any(self.plane[:3]) else self.plane
        return LineFamily(self.kind, rows, point, plane)

    def __str__(self) -> str:
        parts = [self.kind]
        if self.direction:
            parts.append(f"{'normal to' if self.kind == 'two couples' else 'along'} {vector_text(self.direction)}")
        if self.point and self.point[3]:
            parts.append(f"{'at' if len(self.rows) > 1 else 'through'} {vector_text(self.point[:3])}")
        if self.plane and any(self.plane[:3]):
            parts.append(f"in the plane {_equation(self.plane)}")
        return " ".join(parts)


def family(field: Field, rows: Sequence[Row]) -> LineFamily:
    """The family of a totally isotropic span: independent rows, for floats of unit size. Raises LimitReached for floats
    that are isotropic by the tolerance, but hold no such family.
    """
    points, planes = common_points(field, rows), common_planes(field, rows)
    if len(rows) == 1:
        f, m = (rows[0][0], rows[0][1], rows[0][2]), (rows[0][3], rows[0][4], rows[0][5])
        rows = [(*(x * 0 for x in f), *field.simplest(m)) if field.is_couple(f, m) else field.simplest(rows[0], 3)]
    basis = tuple(map(tuple, rows))
    match len(rows), len(points), len(planes):
        case 1, _, _:
            point = _foot(field, rows[0], points)
            return LineFamily("force" if point else "couple", basis, point)
        case 2, 1, 1:
            point, plane = points[0], planes[0]
            parallel = "parallel pencil" if any(plane[:3]) else "two couples"
            kind = "planar pencil" if point[3] else parallel
            return LineFamily(kind, basis, point, plane)
        case 3, 1, 0:
            kind = "bundle" if points[0][3] else "parallel bundle"
            return LineFamily(kind, basis, points[0])
        case 3, 0, 1:
            kind = "plane field" if any(planes[0][:3]) else "all couples"
            return LineFamily(kind, basis, None, planes[0])
    raise undecided()


def undecided() -> LimitReached:
    """The error for floats whose lines are neither apart nor together."""
    return LimitReached(
        "some numbers are so close to the tolerance that it cannot be decided which lines meet",
        hint="use another tolerance, Floats(tolerance=…), or exact numbers",
    )


def common_points(field: Field, rows: Sequence[Row]) -> tuple[Row, ...]:
    """A basis of the homogeneous points (x; w) on all lines (f; m): x × f = w m and m·x = 0."""
    equations = [
        equation
        for a, b, c, u, v, w in rows
        for equation in ((a * 0, c, -b, -u), (-c, a * 0, a, -v), (b, -a, a * 0, -w), (u, v, w, a * 0))
    ]
    return tuple(_point(field, v) for v in field.rows(field.kernel(field.read(equations, 4))))


def common_planes(field: Field, rows: Sequence[Row]) -> tuple[Row, ...]:
    """A basis of the planes (n; d) that contain all lines (f; m): n × m = d f and n·f = 0."""
    equations = [
        equation
        for a, b, c, u, v, w in rows
        for equation in ((a * 0, w, -v, -a), (-w, a * 0, u, -b), (v, -u, a * 0, -c), (a, b, c, a * 0))
    ]
    return tuple(_plane(field, v) for v in field.rows(field.kernel(field.read(equations, 4))))


def _point(field: Field, v: Row) -> Row:
    """The multiple with w = 1, or with w exactly 0."""
    head, last = v[:3], v[3]
    if field.is_zero(last):
        return (*field.simplest(head), head[0] * 0)
    return (*(field.quotient(x, last) for x in head), field.number(1))


def _plane(field: Field, v: Row) -> Row:
    """The simplest multiple, exactly (0, 0, 0, 1) for the plane at infinity."""
    if all(map(field.is_zero, v[:3])):
        return (*(x * 0 for x in v[:3]), field.number(1))
    return field.simplest(v, 3)


def _foot(field: Field, row: Row, points: Sequence[Row]) -> Row | None:
    """The point nearest to the origin, or None for a couple. On an isotropic line of residues one of its `points`."""
    f, m = (row[0], row[1], row[2]), (row[3], row[4], row[5])
    if field.is_couple(f, m):
        return None
    square = field.dot(f, f)
    if field.is_zero(square):
        return next(p for p in points if p[3])
    return (*(field.quotient(x, square) for x in field.cross(f, m)), field.number(1))


def vector_text(vector: Sequence[Any]) -> str:
    """(1, 2/3, 0.25): floats with six digits."""
    return f"({', '.join(map(number_text, vector))})"


def number_text(x: Any) -> str:
    """A fraction or residue as it is, a float with six digits."""
    return f"{x + 0.0:.6g}" if isinstance(x, float) else str(x)


def _equation(plane: Row) -> str:
    """x + 2*y = 3."""
    text = ""
    for c, name in zip(plane[:3], "xyz", strict=True):
        if c:
            negative = isinstance(c, float | Fraction) and c < 0
            size = "" if abs(c) == 1 else f"{number_text(abs(c))}*"
            text += f"{' - ' if negative else ' + '}{size}{name}" if text else f"{'-' if negative else ''}{size}{name}"
    return f"{text} = {number_text(-plane[3])}"
