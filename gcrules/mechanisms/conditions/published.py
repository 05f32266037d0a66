"""Published conditions of robots, compared with the superbracket of the equivalent lines."""

from __future__ import annotations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.straightening.straighten import straighten
from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.conditions.factor_causes import at_member, constant
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot

__all__ = ["MEMBERS", "Published", "published"]

MEMBERS = 20
"""Random exact members on which an analysis is checked."""


@dataclass(frozen=True)
class Published:
    """A published condition compared: `verdict` is proved | holds | refuted, `detail` in words."""

    condition: str
    verdict: str
    detail: str


def published(robot: Robot, structure: Equivalent, found: Analysis) -> Published:
    """Compare the published condition with the superbracket of the lines."""
    try:
        e = parse(robot.condition, context=Context(found.structure.rank, (), structure.ideal))
        if e.step:
            raise InputError("a condition is a scalar")
        unknown = [n for n in points_of(e) if n not in structure.points(robot.family, robot.family.member(0))]
        if unknown:
            raise InputError(f"{unknown[0]} is not defined")
        at = [at_member(robot.family, structure, robot.family.member(("published", n))) for n in range(MEMBERS)]
    except GcrulesError as fault:
        raise InputError(
            f"the published condition: {fault.message}", hint=fault.hint, filename=robot.filename
        ) from None
    superbracket = found.structure.superbracket
    c = constant(robot.family, structure, superbracket, e, at)
    if c is None:
        return Published(robot.condition, "refuted", "it is not a multiple of the superbracket at exact random members")
    held = f"the superbracket is {c} times it"
    try:
        difference = ex.sub(ex.mul(ex.Number(c.denominator), superbracket), ex.mul(ex.Number(c.numerator), e))
        if not straighten(difference, ideal=structure.ideal):
            return Published(robot.condition, "proved", f"{held}: both sides have the same normal form")
    except GcrulesError:
        pass
    return Published(robot.condition, "holds", f"{held} at {MEMBERS} exact random members of the family")
