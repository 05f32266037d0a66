r"""Single screws: twists (ω; v), wrenches (f; m), their product, pitch, axis and Plücker coordinates.

A twist is the angular velocity ω and the velocity v of the point of the body that is at the origin; a wrench is the
force f and its moment m about the origin. Both are rows of six numbers, and the same row means a turn about a line as a
twist and a force along it as a wrench; a slide as a twist is a couple as a wrench. Formulas: derived here.

    >>> from fractions import Fraction
    >>> force = revolute((1, 2, 3), (0, 0, 1))
    >>> print(*force, "|", *plucker(force))
    0 0 1 2 -1 0 | 0 1 0 2 0 -1
    >>> print(product(force, revolute((1, 0, 0), (0, 1, 0))), pitch(helical((1, 0, 0), (0, 0, 2), Fraction(1, 2))))
    0 1/2
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.screws.fields import Field, Matrix, Row, Vector, field_of

__all__ = [
    "ScrewAxis",
    "axis",
    "direction",
    "from_plucker",
    "helical",
    "helical_of",
    "join_of",
    "line_through",
    "meet_of",
    "moved",
    "pitch",
    "plucker",
    "prismatic",
    "prismatic_of",
    "product",
    "revolute",
    "revolute_of",
]


def revolute(point: Any, along: Any, field: Field | None = None) -> Any:
    """The unit turn about the line through a point along a direction, or the force along that line: (d; p × d).

    A row of six numbers; for arrays (..., 3) of floats an array (..., 6). Raises InputError for a zero direction.
    """
    field = field or field_of(point, along)
    p, d = field.vector(point, "a point"), direction(along, field)
    field.go_together((p, d), "a turn")
    return field.packed(revolute_of(field, p, d))


def prismatic(along: Any, field: Field | None = None) -> Any:
    """The translation along a direction, or the couple with that moment: (0; d)."""
    field = field or field_of(along)
    return field.packed(prismatic_of(direction(along, field)))


def helical(point: Any, along: Any, pitch: Any, field: Field | None = None) -> Any:
    """The screw on an axis with a pitch, the length of advance for each radian: (d; p × d + pitch · d)."""
    field = field or field_of(point, along, pitch)
    p, d = field.vector(point, "a point"), direction(along, field)
    h = field.number(pitch, "a pitch")
    field.go_together((p, d, h), "a screw")
    return field.packed(helical_of(field, p, d, h))


def direction(value: Any, field: Field, what: str = "a direction") -> Vector:
    """Read a direction. Raises InputError for zero."""
    found = field.vector(value, what)
    if field.are_zero(found):
        raise InputError(f"{what} is zero")
    return found


def revolute_of(field: Field, p: Vector, d: Vector) -> Row:
    """`revolute` of vectors that were read."""
    return (*d, *field.cross(p, d))


def prismatic_of(d: Vector) -> Row:
    """`prismatic` of a vector that was read."""
    return (*(x * 0 for x in d), *d)


def helical_of(field: Field, p: Vector, d: Vector, pitch: Any) -> Row:
    """`helical` of a point, a direction and a pitch that were read."""
    return (*d, *(field.reduced(m + pitch * x) for x, m in zip(d, field.cross(p, d), strict=True)))


def product(a: Any, b: Any, field: Field | None = None) -> Any:
    """The reciprocal product f·v + m·ω: the power of a wrench on a twist, zero for reciprocal screws.

    It is symmetric. For two lines it is zero exactly when they meet (or are parallel): the product of a∨b and c∨d is
    −[abcd]. Arrays (..., 6) of floats give an array of products.
    """
    field = field or field_of(a, b)
    one, two = (field.components(s, 6, "a screw") for s in (a, b))
    field.go_together((one, two), "two screws")
    return field.dot(one, (*two[3:], *two[:3]))


def pitch(screw: Any, field: Field | None = None) -> Any:
    """f·m / f·f, a length (for each radian): zero for a line, inf for a couple. Raises InputError for no screw."""
    field, (f, m) = _halves(screw, field)
    square = field.dot(f, f)
    none = field.is_couple(f, m)
    return field.choose(none, math.inf, field.quotient(field.dot(f, m), field.choose(none, 1, square)))


@dataclass(frozen=True)
class ScrewAxis:
    """Where a screw is: its axis passes through `point`, the one nearest to the origin, along `direction`; `pitch` as
    above. A couple or translation has no axis: its point is None, its pitch inf.
    """

    point: Vector | None
    direction: Vector
    pitch: Any

    def stretched(self, length: Any) -> ScrewAxis:
        """The axis so much further from the origin."""
        if self.point is None:
            return self
        x, y, z = (c * length for c in self.point)
        return ScrewAxis((x, y, z), self.direction, self.pitch * length)


def axis(screw: Any, field: Field | None = None) -> ScrewAxis:
    """The axis of one screw: the point is f × m / f·f. Raises InputError for no screw."""
    field, (f, m) = _halves(screw, field)
    h = pitch(screw, field)
    if getattr(h, "shape", ()):
        raise InputError("the axis of one screw is asked for, not of an array", hint="take the screws one by one")
    if h == math.inf:
        return ScrewAxis(None, m, h)
    square = field.dot(f, f)
    x, y, z = (field.quotient(c, square) for c in field.cross(f, m))
    return ScrewAxis((x, y, z), f, h)


def plucker(wrench: Any, field: Field | None = None) -> Any:
    """The Plücker coordinates (12, 13, 14, 23, 24, 34) of a force or couple, as `evaluate` gives them for a∨b."""
    field, (f, m) = _halves(wrench, field)
    return field.packed(tuple(map(field.reduced, (m[2], -m[1], -f[0], m[0], -f[1], -f[2]))))


def from_plucker(coordinates: Any, field: Field | None = None) -> Any:
    """The wrench (f; m) of Plücker coordinates."""
    field = field or field_of(coordinates)
    p12, p13, p14, p23, p24, p34 = field.components(coordinates, 6, "a line")
    return field.packed(tuple(map(field.reduced, (-p14, -p24, -p34, p23, -p13, p12))))


def line_through(p: Any, q: Any, field: Field | None = None) -> Any:
    """The wrench of the line p∨q of two homogeneous points: for finite ones the force q − p, for ideal ones the couple
    p × q. Raises InputError where they are one point.
    """
    field = field or field_of(p, q)
    one, two = (field.components(x, 4, "a point") for x in (p, q))
    field.go_together((one, two), "two points")
    row = join_of(field, one, two)
    if field.are_zero(row):
        raise InputError("two different points are needed for a line")
    return field.packed(row)


def join_of(field: Field, p: Row, q: Row) -> Row:
    """`line_through` of points that were read."""
    (*a, v), (*b, w) = p, q
    force = tuple(field.reduced(v * y - w * x) for x, y in zip(a, b, strict=True))
    return (*force, *field.cross((a[0], a[1], a[2]), (b[0], b[1], b[2])))


def meet_of(field: Field, p: Row, q: Row) -> Row:
    """The common line of two planes (n; d) and (k; e), n·x + d = 0: the force n × k with moment d k − e n."""
    (*a, d), (*b, e) = p, q
    moment = tuple(field.reduced(d * y - e * x) for x, y in zip(a, b, strict=True))
    return (*field.cross((a[0], a[1], a[2]), (b[0], b[1], b[2])), *moment)


def moved(screws: Any, rotation: Any, shift: Any, field: Field | None = None) -> Matrix:
    """Screws after the motion x → R x + t: (R f; R m + t × R f). Arrays of floats (..., k, 6), (..., 3, 3) and (..., 3)
    move many configurations. Raises InputError where R is no rotation.
    """
    field = field or field_of(screws, rotation, shift)
    turned, t, rows = field.read(rotation, 3), field.vector(shift, "a shift"), field.read(screws)
    if field.height(turned) != 3:
        raise InputError("a rotation needs three rows")
    axes = [field.row(turned, i) for i in range(3)]
    excess = [field.dot(axes[i], axes[j]) - int(i == j) for i in range(3) for j in range(i, 3)]
    if not all(map(field.is_zero, (*excess, field.determinant(turned) - 1))):
        raise InputError("the rotation is not an orthogonal matrix of determinant 1")
    field.go_together((t, axes[0], *(field.row(rows, i) for i in range(field.height(rows)))), "a motion")
    found = []
    for row in (field.row(rows, i) for i in range(field.height(rows))):
        f, m = ([field.dot(axis, half) for axis in axes] for half in (row[:3], row[3:]))
        lever = field.cross(t, (f[0], f[1], f[2]))
        found.append((*f, *(field.reduced(x + y) for x, y in zip(m, lever, strict=True))))
    return field.matrix(found)


def _halves(screw: Any, field: Field | None) -> tuple[Field, tuple[Vector, Vector]]:
    field = field or field_of(screw)
    row: Sequence[Any] = field.components(screw, 6, "a screw")
    if field.are_zero(row):
        raise InputError("six zeros are not a screw")
    return field, ((row[0], row[1], row[2]), (row[3], row[4], row[5]))
