r"""Proofs that there is no way: what has opposite signs at the start and at the goal is 0 somewhere on every way.

For a platform on six legs the superbracket and, where the condition is a product, its factors are exact numbers at a
pose, and all poses hang together. For a robot of joints the sign is that of `closing_sign`, between configurations.
"""

from __future__ import annotations

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import ONE
from gcrules.algebra.language.text import text
from gcrules.conditions.gained_motion import factors
from gcrules.core.floats import as_float
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.factors import factors as robot_factors
from gcrules.poses.limbs.pose_report import cause_of
from gcrules.poses.numbers.causes import factor_words
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.poses.plans.closing_sign import closing_signs
from gcrules.poses.plans.report import OpposedSign
from gcrules.screws.pose import Pose

__all__ = ["DETERMINANT", "opposed_legs", "opposed_limbs"]

DETERMINANT = "determinant"
"""The expression of what has no name in points: the determinant of the screws of the undriven joints."""

_COMPLEX = "the six legs belong to one linear complex"


def opposed_legs(m: SixLegs, start: Pose, goal: Pose) -> tuple[OpposedSign, ...]:
    """The factors of the condition with opposite signs, or the superbracket where it has them and the factors do not
    tell; exact.
    """
    condition = m.analysis.condition
    names = m.analysis.structure.names
    one, other = (m.rig.exact(p) for p in (start, goal))
    parts = factors(condition.expression) if condition.cofactor == ONE else ()
    found = []
    for part in parts:
        a, b = (evaluate(part, points) for points in (one, other))
        if a * b < 0:
            words = " and ".join(factor_words(part, condition, tuple(names))) or _COMPLEX
            found.append(OpposedSign(text(part, names=names), as_float(a), as_float(b), words))
    if found:
        return tuple(found)
    a, b = (superbracket_at(m.analysis.structure.oriented, points) for points in (one, other))
    return (OpposedSign("superbracket", as_float(a), as_float(b), _COMPLEX),) if a * b < 0 else ()


def opposed_limbs(m: Limbs, start: Configuration, goal: Configuration) -> tuple[OpposedSign, ...]:
    """The factors of the condition with opposite signs, where the determinant has them, or else the determinant alone;
    none where the determinant has one sign, or there is none. The quotient of a factor and a cofactor may change its
    sign where the cofactor vanishes, so it does not count.
    """
    a, b = closing_signs(m.linkage, Configurations.of([start, goal])).tolist()
    if a * b >= 0:
        return ()
    pairs = zip(robot_factors(m.analysis, start.values), robot_factors(m.analysis, goal.values), strict=True)
    plain = ((p, q) for p, q in pairs if p.live and not p.cofactor)
    found = [OpposedSign(p.expression, p.value, q.value, cause_of(p)) for p, q in plain if p.value * q.value < 0]
    return tuple(found) or (OpposedSign(DETERMINANT, float(a), float(b), "the robot is singular"),)
