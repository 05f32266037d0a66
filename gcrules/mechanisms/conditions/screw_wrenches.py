"""The condition of a robot some of whose wrenches are screws, which letters stand for."""

from __future__ import annotations

from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.screw_letters import screw
from gcrules.algebra.structure import Structure
from gcrules.conditions.analysis import analyze
from gcrules.core.english import listed
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.rules.catalog.catalog import FIVE_LEG_SCREW
from gcrules.rules.statement import NOTHING, Statement, say

__all__ = ["with_screws"]

_LINES = 6
_MOST = 4  # screws: with more of them there are no incidences
_STEMS = "WVTXYZ"
_SCREWS = ("a screw that spans", "screws that span")


def with_screws(robot: Robot, structure: Equivalent) -> Statement:
    """The condition in which letters stand for wrenches that span those of limbs without lines.

    Nothing where constraints are there twice, where lines go through points that the file does not name, and where no
    condition without a cofactor is found: an identity that holds for all lines and screws holds for the robot's.
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
    condition = analyze(Structure(tuple(legs), ideal=ideal, stand_ins=tuple(stand_ins)), search=0).condition
    if condition.kind in (FIVE_LEG_SCREW, "always-singular", "linear-complex") or condition.cofactor != ONE:
        return NOTHING
    return say("Let {}. {} This holds unless a limb is singular by itself.", listed(told), condition.meaning.of_forces)
