r"""Screw systems: spans of twists or wrenches, and those reciprocal to them.

>>> from gcrules.screws.screw import revolute
>>> pencil = ScrewSystem.span([revolute((0, 0, 0), (1, 0, 0)), revolute((0, 0, 0), (0, 1, 0))])
>>> pencil.dimension, pencil.reciprocal().dimension, pencil.reciprocal().reciprocal() == pencil
(2, 4, True)
>>> pencil.classify().kind, pencil.reciprocal().classify().kind
('planar pencil', 'bundle and plane field')
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.screws.fields import Field, Matrix, Row, field_of
from gcrules.screws.kinds import Classification, classify

__all__ = ["ScrewSystem", "Shares", "actuation", "reciprocal", "reciprocal_and_rank"]


Shares = Sequence[Sequence[int]]
"""For each twist of a limb with which sign it counts in the platform's twist, and then in each of the limb's own loops;
none for a chain, whose twists add up to the platform's.
"""


def reciprocal(screws: Any, field: Field | None = None, shares: Shares = ()) -> Matrix:
    """A basis of the screws reciprocal to all rows: of the wrenches for twists, of the twists for wrenches.

    Rows (..., k, 6) to (..., 6 − rank, 6). For floats of many configurations the largest rank counts, so that all get
    as many rows; `Field.rank` tells where it is smaller. Of a limb with loops a wrench on the platform is taken if some
    wrenches in its loops balance it: no twist does work on all of them together.
    """
    field = field or field_of(screws)
    return reciprocal_and_rank(field.read(screws), field, shares)[0]


def reciprocal_and_rank(screws: Matrix, field: Field, shares: Shares = ()) -> tuple[Matrix, int]:
    """`reciprocal` of rows that were read, and their rank as the platform and the loops together have them."""
    rows = field.comparable(screws)
    if not shares:
        found = field.kernel(swapped(rows, field))
        return field.unscaled(found), 6 - field.height(found)
    width = 6 * len(shares[0])
    balanced, rank = field.kernel_part(swapped(field.spread(rows, shares), field), width)
    return field.unscaled(balanced), rank


def swapped(rows: Matrix, field: Field) -> Matrix:
    """The rows (m; f) of rows (f; m), of six numbers or several sixes: the reciprocal product with one is the scalar
    product with the other.
    """
    if field.floating:
        sixes = rows.reshape(*rows.shape[:-1], rows.shape[-1] // 6, 6)
        return sixes[..., [3, 4, 5, 0, 1, 2]].reshape(rows.shape)
    return tuple(
        tuple([x for k in range(0, len(row), 6) for x in (*row[k + 3 : k + 6], *row[k : k + 3])]) for row in rows
    )


def actuation(twists: Matrix, place: int, field: Field, shares: Shares = ()) -> Row | None:
    """The shortest wrench with product 1 with one twist and 0 with all others; None (floats: nan) where there is none.

    With d the twist's (v; ω), it is the projection of d to the screws reciprocal to the others, divided by its scalar
    product with d: so it is orthogonal to the wrenches that are reciprocal to all twists. With loops (see `reciprocal`)
    that holds of all wrenches together; from that on the platform its part along these wrenches is taken off. Derived
    here.
    """
    places = [i for i in range(field.height(twists)) if i != place]
    others, driven_row = field.comparable(field.chosen(twists, places)), field.scaled(twists)
    if shares:
        others, driven_row = field.spread(others, [shares[i] for i in places]), field.spread(driven_row, shares)
    free = field.kernel(swapped(others, field), 6 * len(shares[0]) if shares else 6)
    driven = field.row(swapped(driven_row, field), place)
    shadow = field.projection(free, driven)
    power = field.dot(shadow, driven)
    lost = field.vanishes(power, field.dot(driven, driven))
    if not field.floating and lost:
        return None
    scale = field.quotient(1, field.choose(lost, field.nothing, power * field.length))
    if shares:
        constraints = field.basis(field.scaled(reciprocal(twists, field, shares)))
        own = shadow[:6]
        shadow = tuple(x - y for x, y in zip(own, field.projection(constraints, own), strict=True))
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
