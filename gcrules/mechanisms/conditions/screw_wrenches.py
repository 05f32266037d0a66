"""The condition of a robot some of whose wrenches are screws, which letters stand for."""

from __future__ import annotations

from dataclasses import replace

from gcrules.algebra.expr import ONE, Expr, mul, subexpressions
from gcrules.algebra.screw_letters import screw
from gcrules.algebra.structure import Structure
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.core.english import listed
from gcrules.mechanisms.conditions.factor_causes import tell_apart
from gcrules.mechanisms.conditions.robot_statement import only_pulling
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.rules.catalog.catalog import FIVE_LEG_SCREW
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.screw_readings import meaning_with_screws
from gcrules.rules.screw_words import has_screw
from gcrules.rules.sentences import factors_of
from gcrules.rules.statement import NOTHING, Statement, say

__all__ = ["with_screws"]

_LINES = 6
_PLANE = 3
_MOST = 4  # screws: with more of them there are no incidences
_STEMS = "WVTXYZ"
_SINGULAR, _DROPPED = ("actuation", "constraint", "mixed"), ("never", "limb")
"""Kinds of factors without screws that are told, and that are left out."""

_SCREWS = ("a screw that spans", "screws that span")


def with_screws(robot: Robot, structure: Equivalent) -> Statement:
    """The condition in which letters stand for wrenches that span those of limbs without lines.

    Nothing where constraints are there twice, where lines go through points that the file does not name, where no
    condition without a cofactor is found, and where it cannot be told what its factors say of the robot: an identity
    that holds for all lines and screws holds for the robot's.
    """
    limbs = structure.limbs
    own = sum(limb.dimension for limb in limbs if limb.lines is None)
    if structure.rank != _LINES or sum(limb.dimension for limb in limbs) != _LINES or not 0 < own <= _MOST:
        return NOTHING
    if any(limb.derived for limb in limbs) or robot.family.plane:
        return NOTHING
    names = robot.family.sorts
    stem = next((c for c in _STEMS if not any(n.startswith(c) for n in names)), None)
    if stem is None:
        return NOTHING
    legs: list[tuple[str, str]] = []
    stand_ins: list[tuple[tuple[str, str], Expr]] = []
    told = []
    for limb in limbs:
        if limb.lines is not None:
            legs += [line.ends for line in limb.lines]
            continue
        letters = [f"{stem}{len(stand_ins) + i}" for i in range(1, limb.dimension + 1)]
        stand_ins += [((f"{n}_1", f"{n}_2"), screw(n)) for n in letters]
        legs += [ends for ends, _ in stand_ins[-limb.dimension :]]
        told.append(f"{listed(letters)} be {_SCREWS[limb.dimension > 1]} the wrenches of {limb.limb.name}")
    used = {n for leg in legs for n in leg}
    ideal = tuple(n for n, sort in names.items() if sort == "direction" and n in used)
    found = analyze(Structure(tuple(legs), ideal=ideal, stand_ins=tuple(stand_ins)), search=0)
    meaning = _meaning(robot, structure, found)
    if not meaning:
        return NOTHING
    words = "Let {}. {} This holds unless a limb is singular by itself.{}"
    return say(words, listed(told), meaning.of_forces, only_pulling(structure))


def _meaning(robot: Robot, structure: Equivalent, found: Analysis) -> Statement:
    """What the condition says of the robot: without factors that never vanish, or only where a limb is singular by
    itself. Nothing where that is not known of a factor, and where planes at infinity are met, which three directions
    need not be.
    """
    condition = found.condition
    if condition.kind in (FIVE_LEG_SCREW, "always-singular", "linear-complex") or condition.cofactor != ONE:
        return NOTHING
    factors, oracle = tuple(factors_of(condition.expression)), RandomWitness(found.structure)
    planes = (part for f in factors if has_screw(f) for part in subexpressions(f) if part.step == _PLANE)
    if any(map(oracle.at_infinity, planes)):
        return NOTHING
    plain = tuple(f for f in factors if not has_screw(f))
    if not plain:
        return condition.meaning
    parts, _ = tell_apart(robot.family, robot.limbs, structure, mul(*plain), plain)
    if any(p.kind not in (*_SINGULAR, *_DROPPED) or p.chosen for p in parts):
        return NOTHING
    dropped = [p.expression for p in parts if p.kind in _DROPPED]
    if not dropped:
        return condition.meaning
    left = mul(*(f for f in factors if f not in dropped))
    return meaning_with_screws(replace(condition, expression=left), found.structure, oracle)
