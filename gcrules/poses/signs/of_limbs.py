r"""The signs of a robot of joints in a configuration: the factors of its condition, and the determinant of `closing`.

A factor counts whose zeros are singular, as far as exact members of the family show it, and which is a polynomial in
places that the links carry along. Where it has a cofactor, where the chosen lines of a limb may depend on each other
without a singularity, or where it names something that is solved for, its sign may change in regular configurations.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.expr import ONE, points_of
from gcrules.mechanisms.conditions.factor_causes import FactorCause
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import factor_values, factors
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.pose_report import cause_of
from gcrules.poses.signs.closing import closing_signs
from gcrules.poses.signs.sign import ConditionSign

__all__ = ["DETERMINANT", "one_sign", "signs_of_limbs"]

DETERMINANT = "determinant"
"""The expression of what has no name in points: the determinant of the screws of the undriven joints."""

_SMALL = 1e-9  # of a factor, which is a number of unit scale: below it floats do not tell its sign
_PROVED = ("actuation", "constraint", "mixed")  # kinds of factors whose zeros are singular


def signs_of_limbs(m: Limbs, there: Solved) -> tuple[ConditionSign, ...]:
    """Those of the factors that count, and of the determinant if there is one, in a single configuration; 0 for one
    that is 0 within rounding.
    """
    every = factors(m.analysis, there.values)
    found = []
    for part in (every[k] for k in _counting(m)):
        known = isfinite(part.value) and abs(part.value) > _SMALL
        sign = ((part.value > 0) - (part.value < 0)) * known
        found.append(ConditionSign(part.expression, part.value, sign, cause_of(part)))
    closing = closing_signs(m.linkage, there.here)
    if closing is not None:
        found.append(ConditionSign(DETERMINANT, float(closing[0]), int(closing[0]), "the robot is singular"))
    return tuple(found)


def one_sign(m: Limbs, there: Solved) -> NDArray[np.int8]:
    """A sign (N,) of configurations that changes at singular ones only: that of the determinant, or where there is none
    of the product of the factors; 0 where it is not known, 1 where there is neither.
    """
    found = closing_signs(m.linkage, there.here)
    if found is not None:
        return found
    values = factor_values(m.analysis, there.values)[:, _counting(m)]
    return np.asarray(np.where(np.abs(values) > _SMALL, np.sign(values), 0).prod(axis=1), dtype=np.int8)


def _counting(m: Limbs) -> list[int]:
    """The places of the factors that count."""
    parts = m.analysis.parts if m.analysis.lines is not None else ()
    return [k for k, part in enumerate(parts) if _counts(part) and _carried(m, points_of(part.expression))]


def _counts(part: FactorCause) -> bool:
    """Whether all members at which the factor vanishes are singular, and it does not keep its value in all poses."""
    return part.kind in _PROVED and part.over == ONE and not (part.of_design or part.chosen)


def _carried(m: Limbs, names: Iterable[str]) -> bool:
    """Whether links carry all names along, or what they are made from by polynomials (`derived`)."""
    linkage = m.linkage
    made = {d.name: d.names for d in m.analysis.structure.derived}
    fixed = {d.name for d in linkage.robot.family.definitions if d.parameters}
    return all(
        _carried(m, made[n]) if n in made else n in linkage.attachments or n in AXES or n in fixed for n in names
    )
