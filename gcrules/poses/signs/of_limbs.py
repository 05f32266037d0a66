r"""The signs of a robot of joints in a configuration: the factors of its condition, and the determinant of `closing`.

A factor counts whose zeros are singular, as far as exact members of the family show it, and which is a polynomial in
places that the links carry along. Where it has a cofactor, where the chosen lines of a limb may depend on each other
without a singularity, or where it names something that is solved for, its sign may change in regular configurations.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.expr import ONE, points_of
from gcrules.mechanisms.conditions.factor_causes import FactorCause
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.chains import shape_of
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import ConditionFactor, factor_values, factors
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.pose_report import cause_of
from gcrules.poses.signs.closing import closing_signs
from gcrules.poses.signs.sign import ConditionSign

__all__ = ["DETERMINANT", "one_sign", "signs_of_limbs"]

DETERMINANT = "determinant"
"""The expression of what has no name in points: the determinant of the screws of the undriven joints."""

_SLIDES = ("P", "C")  # joints along whose axes points slide past each other
_SMALL = 1e-9  # of a factor, which is a number of unit scale: below it floats do not tell its sign
_PROVED = ("actuation", "constraint", "mixed")  # kinds of factors whose zeros are singular


def signs_of_limbs(
    m: Limbs, there: Solved, values: Sequence[ConditionFactor] | None = None
) -> tuple[ConditionSign, ...]:
    """Those of the factors that count, and of the determinant if there is one, in a single configuration; 0 for one
    that is 0 within rounding. `values` are those of all factors there, where they are known.
    """
    every = factors(m.analysis, there.values) if values is None else values
    found = []
    turned = _turned(m, there)[:, 0]
    for n, part in enumerate(every[k] for k in _counting(m)):
        known = isfinite(part.value) and abs(part.value) > _SMALL and not turned[n]
        sign = ((part.value > 0) - (part.value < 0)) * known
        found.append(ConditionSign(part.expression, part.value, sign, cause_of(part), proved=False))
    closing = closing_signs(there)
    if closing is not None:
        found.append(ConditionSign(DETERMINANT, float(closing[0]), int(closing[0]), "the robot is singular"))
    return tuple(found)


def one_sign(m: Limbs, there: Solved) -> NDArray[np.int8]:
    """A sign (N,) of configurations that changes at singular ones only: that of the determinant, or where there is none
    of the product of the factors; 0 where it is not known, 1 where there is neither.
    """
    found = closing_signs(there)
    if found is not None:
        return found
    values = factor_values(m.analysis, there.values)[:, _counting(m)]
    known = (np.abs(values) > _SMALL) & ~_turned(m, there).T
    return np.asarray(np.where(known, np.sign(values), 0).prod(axis=1), dtype=np.int8)


def _turned(m: Limbs, there: Solved) -> NDArray[np.bool_]:
    """Where a slide between two points has changed sides that a factor names both, (factors that count, N): their join
    is 0 where they come together, and nothing need be singular.
    """
    counting = [set(points_of(m.analysis.parts[k].expression)) for k in _counting(m)]
    found = np.zeros((len(counting), len(there)), dtype=bool)
    for ends, changed in _changed_sides(m, there):
        for row, names in zip(found, counting, strict=True):
            if ends <= names:
                row |= changed
    return found


def _changed_sides(m: Limbs, there: Solved) -> Iterator[tuple[set[str], NDArray[np.bool_]]]:
    """The two points of each slide along the line through them, and where they have changed sides (N,)."""
    linkage = m.linkage
    sorts = linkage.robot.family.sorts
    for place, limb in enumerate(linkage.robot.limbs):
        motion = 0
        for joint in limb.joints:
            axis = joint.args[-1] if joint.kind in _SLIDES else ()
            names = [n for _, n in axis] if isinstance(axis, tuple) else []
            if len(names) == 2 and all(sorts[n] == "point" for n in names):
                link = linkage.home.chains[place].before[motion]
                before = linkage.home.values[names[1]] - linkage.home.values[names[0]]
                carried = there.links[place][:, link, :3, :3] @ before
                now = there.values[names[1]] - there.values[names[0]]
                yield set(names), (carried * now).sum(axis=-1) < 0
            motion += len(shape_of(joint.kind).motions)


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
