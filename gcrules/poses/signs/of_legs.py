r"""The signs of a platform on six legs: the factors of its condition, or the superbracket, exact at a pose."""

from __future__ import annotations

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import ONE
from gcrules.algebra.language.text import text
from gcrules.conditions.gained_motion import factors
from gcrules.core.floats import as_float
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.numbers.causes import factor_words
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.poses.signs.sign import ConditionSign
from gcrules.screws.pose import Pose

__all__ = ["signs_of_legs"]

_COMPLEX = "the six legs belong to one linear complex"


def signs_of_legs(m: SixLegs, pose: Pose) -> tuple[ConditionSign, ...]:
    """Those of the factors, whose product is the superbracket up to a number. Where the condition has a cofactor its
    factors may vanish in regular poses, and the superbracket is told alone.
    """
    condition, structure = m.analysis.condition, m.analysis.structure
    points = m.rig.exact(pose)
    if condition.cofactor != ONE:
        value = superbracket_at(structure.oriented, points)
        return (ConditionSign("superbracket", as_float(value), (value > 0) - (value < 0), _COMPLEX),)
    found = []
    for part in factors(condition.expression):
        value = evaluate(part, points)
        words = " and ".join(factor_words(part, condition, tuple(structure.names))) or _COMPLEX
        sign = (value > 0) - (value < 0)
        found.append(ConditionSign(text(part, names=structure.names), as_float(value), sign, words))
    return tuple(found)
