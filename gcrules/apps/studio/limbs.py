"""Robots with limbs: what does not change with the configuration, and the two steps to the equivalent lines."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import leg_text
from gcrules.algebra.language.text import text
from gcrules.apps.studio.items import fact, formula, sentence
from gcrules.apps.studio.protocol.study_views import Item, RobotView
from gcrules.mechanisms.conditions.factor_causes import KINDS, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.equivalent import FRAME
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.formulas.latex import latex
from gcrules.views.results.at_infinity import at_infinity
from gcrules.views.results.robot import factor_kind, leading_sentences
from gcrules.views.robots.limb_views import Values, limb_views
from gcrules.views.robots.robot_drawing import draw_robot

__all__ = ["limb_stages", "part_items", "robot_drawing", "robot_view"]


def robot_view(robot: RobotAnalysis, mobility: int, home: Values) -> RobotView:
    """What does not change with the configuration, with the limbs at home."""
    found: RobotView = {
        "mobility": mobility,
        "statement": " ".join(leading_sentences(robot)),
        "limbs": limb_views(robot, home),
        "parts": [
            {"text": _words(p.expression, robot), "tex": latex(p.expression), "kind": p.kind, "statement": _told(p)}
            for p in robot.parts
        ],
    }
    if robot.structure.limbs:
        found["figure"] = robot_drawing(robot, home).svg()
    return found


def robot_drawing(robot: RobotAnalysis, values: Values) -> Drawing:
    """The robot with its wrenches beside the lines that stand for them."""
    exact = {n: (Fraction(x), Fraction(y), Fraction(z)) for n, (x, y, z) in values.items()}
    return draw_robot(robot, exact)


def _words(e: Expr, robot: RobotAnalysis) -> str:
    return text(e, unicode=True, names=robot.lines.structure.names if robot.lines else ())


def _told(part: FactorCause) -> str:
    said = part.statement or part.reason or KINDS[part.kind]
    return f"{said}; {part.remark}" if part.of_design else said


def limb_stages(robot: RobotAnalysis) -> Iterator[tuple[str, list[Item]]]:
    """The limbs with their wrenches, then the lines that stand for them."""
    s = robot.structure
    if not s.limbs:
        return
    numbers = [
        fact("limbs", robot.robot.chain),
        fact("mobility of the platform", str(s.mobility)),
        *([fact("overconstraints", str(s.overconstraints))] if s.overconstraints else []),
        *([fact("idle freedoms", str(s.idle))] if s.idle else []),
        *([fact("actuators beyond the freedoms", str(s.redundant))] if s.redundant else []),
    ]
    words: list[Item] = [fact(f"{one.limb.name}, {one.limb.chain}", one.kind) for one in s.limbs]
    serial: list[Item] = [
        sentence(f"{one.limb} by itself is singular where {c.statement}.")
        for one in robot.limbs
        for c in one.conditions
    ]
    yield "limbs", [*numbers, *words, *serial]
    yield "equivalent", list(_equivalent(robot))


def _of(limb: str) -> str:
    return "all limbs together" if limb == FRAME else limb


def _equivalent(robot: RobotAnalysis) -> Iterator[Item]:
    s = robot.structure
    if s.lines is None:
        yield sentence(robot.statement)
        return
    for line in s.lines:
        role = "constraint " if line.role == "constraint" else ""
        yield fact(leg_text(line.ends), f"{role}{'couple' if line.couple else 'force'} of {_of(line.limb)}")
    if s.ideal:
        names = robot.lines.structure.names if robot.lines else ()
        yield fact("at infinity", at_infinity(s.ideal, robot.condition, names, AXES))
    for name, what in s.named:
        yield fact(name, what)
    if s.incidences:
        yield fact("known of the points", ", ".join(map(str, s.incidences)))


def part_items(robot: RobotAnalysis) -> Iterator[Item]:
    """The factors of the condition, each with what it means for this robot."""
    if not robot.parts:
        return
    yield sentence("Its factors, told apart by the ranks of the joint screws at exact singular members of the family:")
    for part in robot.parts:
        yield formula(None, part.expression)
        yield fact(factor_kind(part), _told(part))
