r"""From a robot's joints to the sentence: wrenches, equivalent lines, condition of the lines, factors told apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.expr import Expr
from gcrules.algebra.scalars import bracket
from gcrules.conditions.analysis import Analysis
from gcrules.core.budget import checkpoint
from gcrules.core.english import listed
from gcrules.core.errors import EngineFault
from gcrules.core.seeds import remark
from gcrules.mechanisms.conditions.cofactors import with_cofactors
from gcrules.mechanisms.conditions.common_factor import common_factor, sees_constraints
from gcrules.mechanisms.conditions.design import is_of_design, rigid_bodies
from gcrules.mechanisms.conditions.factor_causes import at_member, causes_left, tell_apart
from gcrules.mechanisms.conditions.line_conditions import condition_of_lines, factors_at
from gcrules.mechanisms.conditions.lost_wrenches import lines_that_hold
from gcrules.mechanisms.conditions.overlaps import of_several_kinds, without_repetition
from gcrules.mechanisms.conditions.published import MEMBERS, published
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.conditions.robot_statement import robot_statement
from gcrules.mechanisms.conditions.screw_wrenches import with_screws
from gcrules.mechanisms.conditions.words import RobotWords
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.equivalent import Equivalent, equivalent
from gcrules.mechanisms.lines.home import home_wrenches
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.lines.serial import limb_singularities
from gcrules.mechanisms.lines.wrenches import WrenchLine
from gcrules.mechanisms.robot import Robot
from gcrules.rules.condition import Condition
from gcrules.rules.factorization import SECONDS
from gcrules.rules.statement import NOTHING, say

__all__ = ["analyze_robot"]


def analyze_robot(robot: Robot, *, search: float = SECONDS) -> RobotAnalysis:
    """Analyse a robot; `search` as for `gcrules.analyze`. Raises InputError for six lines that are no legs."""
    home = robot.values_at() if robot.home is not None else None
    structure = equivalent(robot.family, robot.limbs, home) if robot.limbs else _given_lines(robot)
    if structure.over and structure.lines is not None and not sees_constraints(robot.family, structure):
        structure = equivalent(robot.family, robot.limbs, home, frame=False)
    structure = lines_that_hold(robot.family, structure, home)
    if structure.lines is None:
        return _without_lines(robot, structure)
    found, condition = condition_of_lines(robot, structure, search)
    family = robot.family
    cofactors, factors = factors_at(robot, structure, condition)
    tell = tell_apart if robot.limbs else causes_left
    several = of_several_kinds(family, structure, factors) if robot.limbs else frozenset()
    parts, told = tell(family, robot.limbs, structure, found.structure.superbracket, factors, several)
    base = tuple(p for limb in robot.limbs for p in limb.joints[0].points if p not in robot.platform)
    words = RobotWords(
        family, structure.lines or (), robot.platform, base, frozenset(structure.ideal) | frozenset(AXES)
    )
    bodies = rigid_bodies(robot) if robot.limbs else ()
    parts = tuple(
        replace(p, meaning=words.clause(p.expression), of_design=is_of_design(bodies, words.ideal, p.expression))
        for p in parts
    )
    parts = with_cofactors(family, structure, without_repetition(family, structure, parts), cofactors)
    common = common_factor(family, structure, found.structure.superbracket, cofactors, parts, words)
    serial = limb_singularities(family, robot.limbs)
    members = _check(robot, structure, found, cofactors, factors)
    return RobotAnalysis(
        robot,
        structure,
        found,
        condition,
        parts,
        serial,
        robot_statement(structure, common, condition, cofactors, parts, serial),
        _certificate(robot, condition, members, told.met),
        cofactors,
        members,
        told.met,
        published(robot, structure, found) if robot.condition else None,
        common,
    )


def _given_lines(robot: Robot) -> Equivalent:
    """The structure of a robot that is given by its lines."""
    sorts = robot.family.sorts
    lines = tuple(
        WrenchLine(ends, "the given lines", all(sorts.get(n) == "direction" for n in ends), "wrench")
        for ends in robot.lines
    )
    names = dict.fromkeys(n for line in lines for n in line.ends)
    ideal = tuple(n for n in names if sorts.get(n) == "direction")
    full = 3 if robot.family.plane else 6
    alone = Equivalent((), lines, 0, 0, 0, full, derived=robot.derived)
    at = [at_member(robot.family, alone, robot.family.member(s)) for s in (1, 2, 3)]
    rank = 3 if robot.family.plane else 4
    given = tuple(
        some
        for some in combinations(names, rank)
        if not set(some) <= set(ideal) and not any(one.value(bracket(*map(ex.Point, some), rank=rank))[0] for one in at)
    )
    return Equivalent((), lines, robot.mobility, 0, 0, full, ideal, given, robot.derived)


def _check(
    robot: Robot, structure: Equivalent, found: Analysis, cofactors: Sequence[Expr], factors: Sequence[Expr]
) -> int:
    """The number of random members at which Π cofactors · superbracket = c · Π factors with one number c, and the joint
    screws have full rank. Raises EngineFault otherwise.
    """
    full = 3 if robot.family.plane else 6
    numbers = set()
    for seed in range(MEMBERS):
        checkpoint()
        values = robot.family.member(("checked", seed))
        at = at_member(robot.family, structure, values)
        if robot.limbs and ranks(robot.family, robot.limbs, values).wrenches != full:
            raise EngineFault(f"the wrenches of {robot.id} do not have full rank at a random member")
        left, right = (at.value(ex.mul(*es))[0] for es in ((*cofactors, found.structure.superbracket), factors))
        numbers.add(left * pow(right, -1, PRIME) % PRIME)
    if len(numbers) > 1:
        raise EngineFault(f"the factors found for {robot.id} are not its superbracket")
    return MEMBERS


def _certificate(robot: Robot, condition: Condition, members: int, met: int) -> str:
    lines = f"the identity of the lines: {condition.certificate.detail}"
    if not robot.limbs:
        return lines
    return (
        f"{lines}; that the lines stand for the joints holds at {members} exact random members of the family, and"
        f" {met} exact singular members were found, all by the ranks of the joint screws (modulo a prime){remark()}"
    )


def _without_lines(robot: Robot, structure: Equivalent) -> RobotAnalysis:
    """Where wrenches of a limb are no lines through the robot's points."""
    kinds: dict[str, list[str]] = {}
    for limb in structure.limbs:
        if limb.lines is None:
            kinds.setdefault(limb.kind, []).append(limb.limb.name)
    if kinds:
        which = "; ".join(f"{listed(names)} ({kind})" for kind, names in kinds.items())
        why = f"no lines through its points, or through meets of its axes and planes, span the wrenches of {which}"
    else:
        why = f"its wrenches have rank {structure.rank} in every configuration"
    meaning = say(
        "No condition in points is given for this robot: {}. {}Margin, pose, path and map need none.",
        why,
        "If such lines have a point that the file can name, give it as `through`. " * bool(kinds),
    )
    of_screws = with_screws(robot, structure) if kinds else NOTHING
    return RobotAnalysis(
        robot,
        structure,
        None,
        None,
        (),
        limb_singularities(robot.family, robot.limbs),
        say("{} {}", meaning, of_screws) if of_screws else meaning,
        f"the ranks hold at exact random members{remark()}",
        wrenches=home_wrenches(robot, structure),
    )
