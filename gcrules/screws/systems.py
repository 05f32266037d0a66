r"""Screw systems: spans of twists or wrenches, and those reciprocal to them.

>>> from gcrules.screws.screw import revolute
>>> pencil = ScrewSystem.span([revolute((0, 0, 0), (1, 0, 0)), revolute((0, 0, 0), (0, 1, 0))])
>>> pencil.dimension, pencil.reciprocal().dimension, pencil.reciprocal().reciprocal() == pencil
(2, 4, True)
>>> pencil.classify().kind, pencil.reciprocal().classify().kind
('planar pencil', 'bundle and plane field')
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gcrules.screws.fields import Field, Matrix, Row, field_of
from gcrules.screws.kinds import Classification, classify

__all__ = ["ScrewSystem", "actuation", "reciprocal"]


def reciprocal(screws: Any, field: Field | None = None) -> Matrix:
    """A basis of the screws reciprocal to all rows: of the wrenches for twists, of the twists for wrenches.

    Rows (..., k, 6) to (..., 6 − rank, 6). For floats of many configurations the largest rank counts, so that all get
    as many rows; `Field.rank` tells where it is smaller.
    """
    field = field or field_of(screws)
    rows = field.comparable(field.read(screws))
    return field.unscaled(field.kernel(swapped(rows, field)))


def swapped(rows: Matrix, field: Field) -> Matrix:
    """The rows (m; f) of rows (f; m): the reciprocal product with one is the scalar product with the other."""
    if field.floating:
        return rows[..., [3, 4, 5, 0, 1, 2]]
    return tuple((*row[3:], *row[:3]) for row in rows)


def actuation(twists: Matrix, place: int, field: Field) -> Row | None:
    """The shortest wrench with product 1 with one twist and 0 with all others; None (floats: nan) where there is none.

    With d the twist's (v; ω), it is the projection of d to the screws reciprocal to the others, divided by its scalar
    product with d: so it is orthogonal to the wrenches that are reciprocal to all twists. Derived here.
    """
    others = field.chosen(twists, [i for i in range(field.height(twists)) if i != place])
    free = field.kernel(swapped(field.comparable(others), field))
    driven = field.row(swapped(field.scaled(twists), field), place)
    shadow = field.projection(free, driven)
    power = field.dot(shadow, driven)
    lost = field.vanishes(power, field.dot(driven, driven))
    if not field.floating and lost:
        return None
    scale = field.quotient(1, field.choose(lost, field.nothing, power * field.length))
    unit = (1, 1, 1, field.length, field.length, field.length)
    return tuple(field.reduced(x * scale * u) for x, u in zip(shadow, unit, strict=True))


@dataclass(frozen=True)
class ScrewSystem:
    """The span of screws at one configuration; `basis` are independent rows.

    The basis of exact numbers is the reduced echelon form, so that equal systems are equal values; that of floats is
    orthonormal (with moments divided by the field's length): compare them with `same`.
    """

    field: Field
    basis: tuple[Row, ...]

    @classmethod
    def span(cls, screws: Any, field: Field | None = None) -> ScrewSystem:
        """The span of rows of six numbers. Raises InputError for other rows, and for rows that are not finite."""
        field = field or field_of(screws)
        rows = field.comparable(field.read(screws))
        return cls(field, field.rows(field.unscaled(field.basis(rows))))

    @property
    def dimension(self) -> int:
        """The number of independent screws, 0 to 6."""
        return len(self.basis)

    def reciprocal(self) -> ScrewSystem:
        """All screws that are reciprocal to all of these, of dimension 6 − `dimension`."""
        return self.span(reciprocal(self.basis, self.field), self.field)

    def __contains__(self, screw: Any) -> bool:
        """Whether a row of six numbers lies in the system (for floats: within the tolerance)."""
        return (self | ScrewSystem.span([screw], self.field)).dimension == self.dimension

    def __or__(self, other: ScrewSystem) -> ScrewSystem:
        """The span of both."""
        return self.span((*self.basis, *other.basis), self.field)

    def __and__(self, other: ScrewSystem) -> ScrewSystem:
        """What both have in common."""
        return (self.reciprocal() | other.reciprocal()).reciprocal()

    def same(self, other: ScrewSystem) -> bool:
        """Whether both are one system (for floats: within the tolerance)."""
        return self.dimension == other.dimension == (self | other).dimension

    def classify(self) -> Classification:
        """What kind of system it is, and which lines (screws of pitch zero or inf) it has.

        Raises LimitReached for floats that are so close to the tolerance that this cannot be decided.
        """
        return classify(self.basis, self.field)

    def __str__(self) -> str:
        return f"{self.dimension}-system: {self.classify()}"
