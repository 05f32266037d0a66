r"""Cofactors of a robot's condition: which factor each of them divides, and which pairing keeps it far from 0 at home.

Cofactor · superbracket = factors of the expression: where a cofactor vanishes so does the factor that it divides,
whether or not the robot is singular. What says something of the robot is the quotient.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from math import hypot

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import ONE, Expr
from gcrules.core.errors import GcrulesError, LimitReached
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.conditions.factor_causes import FactorCause, at_member
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.singular import Poly, divided, interpolated
from gcrules.mechanisms.robot import Robot
from gcrules.rules.condition import Condition
from gcrules.screws import RATIONALS

__all__ = ["sturdiest", "with_cofactors"]

_WEAK = 0.3  # of the largest cofactor among alike readings: below it the first reading gives way


def sturdiest(robot: Robot, structure: Equivalent, readings: Sequence[Condition]) -> Condition:
    """The first of the readings, or another one of its kind whose cofactor is much farther from 0 at home."""
    first = readings[0]
    if first.cofactor == ONE or robot.home is None:
        return first
    alike = [c for c in readings if c.kind == first.kind and c.cofactor != ONE]
    try:
        sizes = [_size(robot, structure, c.cofactor) for c in alike]
    except GcrulesError:  # home lacks coordinates; whoever asks for numbers there is told
        return first
    best = max(sizes)
    return first if sizes[0] >= _WEAK * best else alike[sizes.index(best)]


def _size(robot: Robot, structure: Equivalent, cofactor: Expr) -> float:
    """The product of its factors at home, each divided by the lengths of what it meets or joins, with points about
    their centroid.
    """
    values = home_values(robot)
    points = [d.name for d in robot.family.definitions if d.sort == "point"]
    centre = [sum((values[n][k] for n in points), Fraction(0)) / len(points) for k in range(3)]
    moved = {n: tuple(a - b for a, b in zip(v, centre, strict=True)) if n in points else v for n, v in values.items()}
    at = at_member(robot.family, structure, moved, RATIONALS)
    found = 1.0
    for e in cofactor.factors if isinstance(cofactor, ex.Product) else (cofactor,):
        size = abs(float(at.value(e)[0]))
        for part in e.children if e.children and e.children[0].step else ():
            size /= hypot(*map(float, at.value(part))) or 1.0
        found *= size
    return found


def with_cofactors(
    family: Family, structure: Equivalent, parts: Sequence[FactorCause], cofactors: Sequence[Expr]
) -> tuple[FactorCause, ...]:
    """The parts, each with the product of the cofactors that divide it, as polynomials on a random line in the
    parameters of the family; where there is one part alone, all divide it.
    """
    if not cofactors:
        return tuple(parts)
    if len(parts) == 1:
        return (replace(parts[0], over=ex.mul(*cofactors)),)
    member = cache(family.across("cofactors"))

    def polynomial(e: Expr) -> Poly:
        return interpolated(lambda t: int(at_member(family, structure, member(t)).value(e)[0])) or []

    try:
        left = {p.expression: polynomial(p.expression) for p in parts}
        over: dict[Expr, list[Expr]] = {p.expression: [] for p in parts}
        for cofactor in cofactors:
            own = polynomial(cofactor)
            for e, f in left.items():
                quotient, rest = divided(f, own) if own and f else (f, [1])
                if not rest:
                    left[e] = quotient
                    over[e].append(cofactor)
                    break
    except LimitReached:  # of too high a degree
        return tuple(parts)
    return tuple(replace(p, over=ex.mul(*over[p.expression])) if over[p.expression] else p for p in parts)
