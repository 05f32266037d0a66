"""Which of the conditions of a robot's lines says something of the robot, and its factors where the axes are fixed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import ONE, Expr, Sum
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.conditions.at_infinity import separated
from gcrules.mechanisms.conditions.cofactors import sturdiest
from gcrules.mechanisms.conditions.factor_causes import at_member
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.rules.condition import Condition
from gcrules.rules.sentences import factors_of

__all__ = ["condition_of_lines", "factors_at"]


def condition_of_lines(robot: Robot, structure: Equivalent, search: float) -> tuple[Analysis, Condition]:
    """The analysis of the lines with their points in general position, which holds for all positions; where that gives
    no condition that says something of the robot, with the incidences of its family.
    """
    found = analyze(structure.legs, ideal=structure.ideal, rank=3 if robot.family.plane else 4, search=search)
    if found.condition.kind == "always-singular":
        why = found.condition.meaning.of_forces
        raise InputError(f"the equivalent lines are dependent in every configuration: {why}")
    condition = _usable(robot, structure, found)
    if (condition is None or _weak(condition)) and structure.given:
        try:
            special = analyze(replace(found.structure, given=structure.incidences), search=search)
            better = _usable(robot, structure, special)
        except (InputError, LimitReached):  # assumptions that are not resolved
            better = None
        if better is not None and (condition is None or not _weak(better)):
            return special, better
    if condition is None:
        lines = ", ".join("".join(leg) for leg in structure.legs)
        raise InputError(
            f"no condition of the lines {lines} says something of this robot",
            hint="its points are in a position in which both sides of every identity that was found vanish",
        )
    return found, condition


def _weak(condition: Condition) -> bool:
    """Whether it takes a cofactor, is a sum, or is no incidence."""
    weak = ("linear-complex", "bracket-factors")
    return condition.cofactor != ONE or condition.kind in weak or isinstance(condition.expression, Sum)


def _usable(robot: Robot, structure: Equivalent, found: Analysis) -> Condition | None:
    """The first reading whose cofactor and expression do not vanish in the whole family, or one like it whose cofactor
    is farther from 0 at home.
    """
    at = at_member(robot.family, structure, robot.family.member("usable"))
    usable = [c for c in (found.condition, *found.readings) if at.value(c.cofactor)[0] and at.value(c.expression)[0]]
    return sturdiest(robot, structure, usable) if usable else None


_Factors = tuple[tuple[Expr, ...], tuple[Expr, ...]]


def factors_at(robot: Robot, structure: Equivalent, condition: Condition) -> _Factors:
    """Factors of the cofactor and of the expression: planes at infinity taken out, and what both share cancelled."""
    e = condition.expression
    factors = tuple(factors_of(e)) or (e,)
    cofactors = tuple(factors_of(condition.cofactor))
    if not structure.ideal or robot.family.plane:
        return cofactors, factors
    finite = next((n for leg in structure.legs for n in leg if n not in structure.ideal), None)
    if finite is None:
        return cofactors, factors
    at = [at_member(robot.family, structure, robot.family.member(("far", seed))) for seed in (1, 2)]
    last = {step: [3 in rows for rows in combinations(range(4), step)] for step in (1, 2, 3)}

    def far(a: Expr) -> bool:
        return not any(c for one in at for c, here in zip(one.value(a), last[a.step], strict=True) if here)

    found = [f for factor in factors for f in separated(factor, far, finite)]
    left = []
    for cofactor in (c for one in cofactors for c in separated(one, far, finite)):
        equal = next((f for f in found if _proportional(at, f, cofactor)), None)
        if equal is None:
            left.append(cofactor)
        else:
            found.remove(equal)
    return tuple(left), tuple(found)


def _proportional(at: Sequence[Evaluator], a: Expr, b: Expr) -> bool:
    (p, q), (r, s) = ((one.value(a)[0], one.value(b)[0]) for one in at)
    return bool(p and q and (p * s - q * r) % PRIME == 0)
