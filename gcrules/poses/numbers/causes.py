r"""Why a pose is singular, or nearly so, in words: the entities of the condition that are incident there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Bracket, Expr, Meet
from gcrules.algebra.language.text import text
from gcrules.conditions.gained_motion import common_point, factors, vanishing
from gcrules.core.english import listed, of_kind
from gcrules.poses.numbers.extensors import Points as Arrays
from gcrules.poses.numbers.extensors import normalised
from gcrules.poses.numbers.incidence_measures import NEAR_ZERO
from gcrules.rules.condition import Condition

__all__ = ["causes", "factor_words", "near_causes", "nearest_cause"]

Points = Mapping[str, Sequence[Fraction]]

_ROUNDING = 1e-9


def causes(conditions: Sequence[Condition], points: Points, names: Sequence[str], unit: str = "") -> tuple[str, ...]:
    """Sentences about the factors that vanish at an exact pose, of the conditions whose cofactor does not.

    Where a cofactor vanishes the condition says nothing, and neither do its sentences. `names` is the tableau order.
    """
    found: dict[str, None] = {}
    for condition in conditions:
        if condition.kind == "always-singular":
            found.setdefault(condition.sentence)
        elif evaluate(condition.cofactor, points) != 0:
            for part in vanishing(condition.expression, points):
                words = factor_words(part, condition, tuple(names))
                found |= dict.fromkeys(f"{w[0].upper()}{w[1:]}{_place(part, points, unit)}." for w in words)
    return tuple(found)


def near_causes(conditions: Sequence[Condition], points: Arrays, names: Sequence[str]) -> tuple[str, ...]:
    """The same in floats, at the first of some poses: sentences about the parts that are incident within rounding."""
    parts = _sizes(conditions, points, names)
    return tuple(dict.fromkeys(f"{w[0].upper()}{w[1:]}." for size, w in parts if size <= _ROUNDING))


def nearest_cause(conditions: Sequence[Condition], points: Arrays, names: Sequence[str]) -> tuple[str, ...]:
    """A sentence about the part of the first valid condition that is nearest to an incidence, if there is one."""
    parts = next((p for c in conditions if (p := _sizes([c], points, names))), [])
    return tuple(f"Nearly: {words}." for _, words in sorted(parts)[:1])


def _sizes(conditions: Sequence[Condition], points: Arrays, names: Sequence[str]) -> list[tuple[float, str]]:
    """The normalised value and the words of each part of the conditions that are valid."""
    return [
        (float(normalised(part, points)[0]), words)
        for condition in conditions
        if float(normalised(condition.cofactor, points)[0]) >= NEAR_ZERO
        for part in factors(condition.expression)
        for words in factor_words(part, condition, tuple(names))
    ]


def factor_words(part: Expr, condition: Condition, names: tuple[str, ...]) -> Iterator[str]:
    """What it means that a factor vanishes, without a full stop; nothing for a superbracket."""
    if isinstance(part, Bracket):
        corners = " ".join(text(p, names=names) for p in part.children)
        yield f"the tetrahedron {corners} is flat: its four points lie in one plane"
    elif isinstance(part, Meet):
        kinds = (
            of_kind(word, [text(e, unicode=True, names=names) for e in part.children if e.step == step])
            for word, step in (("plane", 3), ("line", 2), ("point", 1))
        )
        yield f"{listed([some for some in kinds if some])} meet in a point"
    elif condition.lines:
        p, q = (f"{name} = {text(line, unicode=True, names=names)}" for name, line in condition.lines[:2])
        yield f"the two remaining legs allow the turns about {p} and {q} in the same ratio"


def _place(part: Expr, points: Points, unit: str) -> str:
    """Where the parts of a meet that vanishes have their common point."""
    if not isinstance(part, Meet):
        return ""
    point = common_point(part, points)
    if point is None:
        return ", and in more than one"
    place = "(" + ", ".join(f"{float(c / (point[3] or 1)):.6g}" for c in point[:3]) + ")"
    return f": {place}{f' {unit}' if unit else ''}" if point[3] else f" at infinity, in the direction {place}"
