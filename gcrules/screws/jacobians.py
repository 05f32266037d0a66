r"""The Jacobian of actuations and constraints: all wrenches on the platform, as rows.

>>> from gcrules.screws.joints import joint
>>> from gcrules.screws.limbs import limb
>>> x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
>>> slider = limb(joint("P", direction=x, actuated=True), joint("P", direction=y, actuated=True), name="table")
>>> for label, row in zip((j := jacobian([slider])).labels, j.matrix):
...     print(label, *row)
table: actuation 0 1 0 0 0 0 0
table: actuation 1 0 1 0 0 0 0
table: constraint 0 0 0 1 0 0 0
table: constraint 1 0 0 0 1 0 0
table: constraint 2 0 0 0 0 1 0
table: constraint 3 0 0 0 0 0 1
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.screws.fields import Field, Matrix, field_of
from gcrules.screws.limbs import Limb

__all__ = ["LimbJacobian", "RowLabel", "common_field", "jacobian"]


@dataclass(frozen=True)
class RowLabel:
    """Which wrench a row is: the limb (its name, or its place from 1), `kind` actuation | constraint, and the place of
    the actuator or of the basis wrench, from 0.
    """

    limb: str
    kind: str
    place: int

    def __str__(self) -> str:
        return f"{self.limb}: {self.kind} {self.place}"


@dataclass(frozen=True)
class LimbJacobian:
    """Rows (f; m), first the actuations of all limbs, then the constraints; for floats `matrix` is (..., rows, 6).

    The reciprocal products of the rows with a twist of the platform are the rates of the actuators, and 0 for the
    constraints. The robot is singular where the rank is below 6. Actuations are determined up to constraints (see
    `Limb.actuations`), constraints up to their basis; whether the determinant of six rows vanishes does not depend on
    that. In floats the basis is orthonormal, so the determinant is continuous up to its sign.
    """

    field: Field
    matrix: Matrix
    labels: tuple[RowLabel, ...]

    def rank(self) -> Any:
        """The rank; for many configurations an array. Rows are made comparable first."""
        return self.field.rank(self.field.comparable(self.matrix))

    def determinant(self) -> Any:
        """The determinant. Raises InputError unless there are six rows."""
        if len(self.labels) != 6:
            raise InputError(
                f"the Jacobian has {len(self.labels)} rows, and only six rows have a determinant",
                hint="ask for its rank",
            )
        return self.field.determinant(self.matrix)


def jacobian(limbs: Iterable[Limb], field: Field | None = None) -> LimbJacobian:
    """The actuations and constraints of all limbs at one configuration, or at all for which they hold floats.

    The construction is known as that of Joshi and Tsai, cited in SinguLab2008 and not read; derived here.
    Raises InputError for no limbs, and for an actuator that applies no wrench.
    """
    chain = tuple(limbs)
    field = field or common_field(chain)
    names = [one.name or str(n + 1) for n, one in enumerate(chain)]
    parts, labels = [], []
    for kind, rows_of in (("actuation", Limb.actuations), ("constraint", Limb.constraints)):
        for name, one in zip(names, chain, strict=True):
            rows = rows_of(one, field)
            if field.height(rows):
                parts.append(rows)
                labels += [RowLabel(name, kind, place) for place in range(field.height(rows))]
    return LimbJacobian(field, field.joined(parts) if parts else field.matrix(()), tuple(labels))


def common_field(limbs: Iterable[Limb]) -> Field:
    """Floats if any limb has floats, else fractions. Raises InputError for no limbs, and for what is no limb."""
    chain = tuple(limbs)
    if not chain:
        raise InputError("there are no limbs", hint="a robot has at least one")
    for one in chain:
        if not isinstance(one, Limb):
            raise InputError(f"{one!r} is not a limb", hint="write limb(joint(…), joint(…))")
    return next((one.field for one in chain if one.field.floating), field_of())
