"""The factors of a robot's condition at a configuration: numbers with a sign that know neither unit nor scale."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import isfinite, nan, prod
from typing import Any

import numpy as np

from gcrules.algebra.expr import ONE, Expr, Product, points_of
from gcrules.algebra.language.text import text
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.relations import Term
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.numbers.extensors import coordinates

__all__ = ["ConditionFactor", "factors", "superbracket_value"]

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
    if not analysis.parts or analysis.lines is None:
        return ()
    used = dict.fromkeys(n for part in analysis.parts for n in points_of(part.expression))  # in one order: sums round
    at = _unit_scale(analysis, values, used)
    names = analysis.lines.structure.names
    return tuple(
        _factor(part, at, names) if part.over == ONE else _quotient(analysis, part, values) for part in analysis.parts
    )


def _quotient(analysis: RobotAnalysis, part: FactorCause, values: Mapping[str, Floats]) -> ConditionFactor:
    """A factor by its cofactor. Where it is the only one, the quotient is the superbracket up to a number, which is
    known also where both vanish.
    """
    assert analysis.lines is not None
    structure = analysis.lines.structure
    at = _unit_scale(analysis, values, dict.fromkeys((*structure.names, *points_of(part.over))))
    below = prod(_value(e, at) for e in (part.over.factors if isinstance(part.over, Product) else (part.over,)))
    if len(analysis.parts) == 1:
        value = _value(structure.superbracket, at)
    else:
        raw = float(coordinates(part.over, at)[0, 0])
        value = float(coordinates(part.expression, at)[0, 0]) / raw if abs(below) > _SMALL else nan
    return ConditionFactor(
        text(part.expression, names=structure.names),
        part.kind,
        value,
        part.statement,
        text(part.over, names=structure.names),
        below,
    )


def superbracket_value(analysis: RobotAnalysis, values: Mapping[str, Floats]) -> float | None:
    """The value of the superbracket of the equivalent lines, made a number as those of `factors`; None where the
    robot's wrenches are no lines of its points.
    """
    if analysis.lines is None:
        return None
    structure = analysis.lines.structure
    return _value(structure.superbracket, _unit_scale(analysis, values, dict.fromkeys(structure.names)))


def _factor(part: FactorCause, at: Mapping[str, Floats], names: tuple[str, ...]) -> ConditionFactor:
    return ConditionFactor(text(part.expression, names=names), part.kind, _value(part.expression, at), part.statement)


def _value(e: Expr, at: Mapping[str, Floats]) -> float:
    found = float(coordinates(e, at)[0, 0])
    for child in e.children if e.children and e.children[0].step else ():
        size = float(np.linalg.norm(coordinates(child, at)))
        found = found / size if size else 0.0
    return found


def _unit_scale(analysis: RobotAnalysis, values: Mapping[str, Floats], used: Collection[str]) -> dict[str, Floats]:
    """Homogeneous coordinates (1, 4) of the names that are used, (1, 3) in the plane."""
    sorts = analysis.robot.family.sorts
    derived: dict[str, Floats] = {}
    for n, u, v in analysis.structure.derived:  # each may be made from those before it
        derived[n] = np.cross(_of(u, {**values, **derived}), _of(v, {**values, **derived}))
    points = {n: values[n] for n in used if n not in derived and sorts[n] == "point"}
    places = np.array(list(points.values())) if points else np.zeros((1, 3))
    centre = places.mean(axis=0)
    size = float(np.sqrt(((places - centre) ** 2).sum(axis=1).mean())) or 1.0
    found = {}
    for n in used:
        if n in points:
            row = np.array([*((points[n] - centre) / size), 1.0])
        else:
            direction = derived[n] if n in derived else values[n]
            row = np.array([*(direction / (np.linalg.norm(direction) or 1.0)), 0.0])
        found[n] = (row[[0, 1, 3]] if analysis.robot.family.plane else row)[None]
    return found


def _of(term: Term, values: Mapping[str, Floats]) -> Floats:
    return np.asarray(sum((float(c) * values[n] for c, n in term), np.zeros(3)))
