"""The factors of a robot's condition at a configuration: numbers with a sign that know neither unit nor scale."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import isfinite, nan, prod
from typing import Any

import numpy as np

from gcrules.algebra.expr import ONE, Product, points_of
from gcrules.algebra.language.text import text
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.poses.numbers.extensors import coordinates, relative
from gcrules.screws import FLOATS

__all__ = ["ConditionFactor", "factor_values", "factors", "superbracket_value"]

_SMALL = 1e-6  # of a cofactor: below it nothing is divided by it


@dataclass(frozen=True)
class ConditionFactor:
    """A factor of the condition: its value is the expression, with its points at unit scale about their centroid and
    directions of length 1, divided by the lengths of the coordinates of the lines and planes that it joins or meets.
    That of a bracket or a meet lies between −1 and 1. `statement` says when it vanishes, `kind` is that of the part.

    Where the condition has a `cofactor` that divides it, the value is that of the quotient, which vanishes where the
    robot is singular and not where the cofactor does; `cofactor_value` is that of the cofactor alone.
    """

    expression: str
    kind: str
    value: float
    statement: str
    cofactor: str = ""
    cofactor_value: float = 1.0

    @property
    def live(self) -> bool:
        """Whether its zeros are singularities of the robot."""
        return self.kind not in ASIDE

    def to_json(self) -> dict[str, Any]:
        return {
            "expression": self.expression,
            "kind": self.kind,
            "value": self.value if isfinite(self.value) else None,
            "statement": self.statement,
            "cofactor": {"expression": self.cofactor, "value": self.cofactor_value} if self.cofactor else None,
        }


def factors(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> tuple[ConditionFactor, ...]:
    """The values of all factors; none where the robot's wrenches are no lines of its points."""
    if analysis.lines is None:
        return ()
    names = analysis.lines.structure.names
    return tuple(
        ConditionFactor(
            text(part.expression, names=names),
            part.kind,
            float(value[0]),
            part.statement,
            "" if part.over == ONE else text(part.over, names=names),
            float(below[0]),
        )
        for part, (value, below) in zip(analysis.parts, _numbers(analysis, values), strict=True)
    )


def factor_values(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> Floats:
    """The values of all factors in many configurations, (N, factors), where names have places (N, 3)."""
    number = max(v.size // 3 for v in values.values())
    found = [] if analysis.lines is None else [value for value, _ in _numbers(analysis, values)]
    return np.stack([np.broadcast_to(v, number) for v in found], axis=1) if found else np.zeros((number, 0))


def _numbers(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> list[tuple[Floats, Floats]]:
    """Of each factor the value and that of its cofactor, (N,) each."""
    used = dict.fromkeys(n for part in analysis.parts for n in points_of(part.expression))  # in one order: sums round
    at = _unit_scale(analysis, values, used)
    return [
        (relative(part.expression, at), np.ones(1)) if part.over == ONE else _quotient(analysis, part, values)
        for part in analysis.parts
    ]


def _quotient(analysis: RobotAnalysis, part: FactorCause, values: Mapping[str, Floats]) -> tuple[Floats, Floats]:
    """A factor by its cofactor. Where it is the only one, the quotient is the superbracket up to a number, which is
    known also where both vanish.
    """
    assert analysis.lines is not None
    structure = analysis.lines.structure
    at = _unit_scale(analysis, values, dict.fromkeys((*structure.names, *points_of(part.over))))
    every = part.over.factors if isinstance(part.over, Product) else (part.over,)
    below = np.asarray(prod(relative(e, at) for e in every))
    if len(analysis.parts) == 1:
        return relative(structure.superbracket, at), below
    above, raw = (coordinates(e, at)[:, 0] for e in (part.expression, part.over))
    known = np.abs(below) > _SMALL
    return np.where(known, above / np.where(known, raw, 1.0), nan), below


def superbracket_value(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> float | None:
    """The value of the superbracket of the equivalent lines, made a number as those of `factors`; None where the
    robot's wrenches are no lines of its points.
    """
    if analysis.lines is None:
        return None
    structure = analysis.lines.structure
    return float(relative(structure.superbracket, _unit_scale(analysis, values, dict.fromkeys(structure.names)))[0])


def _unit_scale(analysis: RobotAnalysis, values: Mapping[str, Floats], used: Collection[str]) -> dict[str, Floats]:
    """Homogeneous coordinates (N, 4) of the names that are used, (N, 3) in the plane."""
    sorts = analysis.robot.family.sorts
    derived = _derived(analysis, values)
    points = {n: values[n] for n in used if n not in derived and sorts[n] == "point"}
    places = np.stack(np.broadcast_arrays(*points.values())) if points else np.zeros((1, 3))
    centre = places.mean(axis=0)
    size = np.sqrt(((places - centre) ** 2).sum(axis=-1).mean(axis=0))[..., None]
    size = np.where(size > 0, size, 1.0)
    found = {}
    for n in used:
        row = derived.get(n)
        if row is None:
            row = np.concatenate([values[n], np.full((*values[n].shape[:-1], 1), float(n in points))], axis=-1)
        below = row[..., 3:]
        vector = (row[..., :3] - below * centre) / np.where(below, size, 1.0)
        row = np.concatenate([vector, np.broadcast_to(below, (*vector.shape[:-1], 1))], axis=-1)
        row = np.atleast_2d(row if n in points else _unit(row))
        found[n] = row[:, [0, 1, 3]] if analysis.robot.family.plane else row
    return found


def _derived(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> dict[str, Floats]:
    """Homogeneous coordinates (N, 4) of derived names."""
    derived = analysis.structure.derived
    own = {n: FLOATS.vector(values[n]) for d in derived for n in d.names if n in values}
    rows = with_derived(derived, own, FLOATS)
    return {n: np.stack(np.broadcast_arrays(*row), axis=-1) for n, row in rows.items()}


def _unit(direction: Floats) -> Floats:
    size = np.linalg.norm(direction, axis=-1, keepdims=True)
    return np.asarray(direction / np.where(size > 0, size, 1.0))
