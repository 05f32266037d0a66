r"""The dimensions of a platform on six legs: facts of its bodies, its architecture, and its own condition.

>>> from gcrules.conditions.analysis import analyze
>>> a = analyze("Aa Bb Cc Dd Ee Ff")
>>> at = {"A": (0, 0, 0), "B": (2, 0, 0), "C": (3, 2, 0), "D": (2, 4, 0), "E": (0, 4, 0), "F": (-1, 2, 0)}
>>> at |= {n.lower(): (x + y + 7, x - y, 3) for n, (x, y, _) in at.items()}
>>> found = dimensions_of(a.structure, at)
>>> [fact.kind for fact in found.facts], found.architecture.verdict
(['coplanar', 'conic', 'coplanar', 'conic', 'similar', 'rotation', 'mirror', 'mirror'], 'singular')
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

from gcrules.algebra.language.legs_text import Leg, Structure, leg_text
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.dimensions.bodies import body_facts
from gcrules.conditions.dimensions.facts import TOLERANCE, Architecture, Dimensions, check_tolerance
from gcrules.conditions.dimensions.own import own_condition
from gcrules.conditions.dimensions.reasons import architecture_of
from gcrules.conditions.dimensions.related import relations
from gcrules.conditions.dimensions.symmetries import symmetries

__all__ = ["architecture_at", "dimensions_of", "with_own_condition"]

Vector = tuple[Fraction, Fraction, Fraction]
Points = Mapping[str, Vector]


def dimensions_of(structure: Structure, points: Points, tolerance: float = TOLERANCE) -> Dimensions | None:
    """The facts and the architecture of a platform whose joints are at these exact places in one pose; None for legs
    that do not tell base from platform. Raises InputError for a tolerance that is none.
    """
    check_tolerance(tolerance)
    if structure.rank != 4 or len(structure.joined) != 6 or len(structure.sides) < len(structure.names):
        return None
    return _found(structure.oriented, tuple((n, points[n]) for n in structure.names), tolerance)


def architecture_at(structure: Structure, points: Points, tolerance: float = TOLERANCE) -> Architecture | None:
    """The architecture alone, made once; None as for `dimensions_of`."""
    found = dimensions_of(structure, points, tolerance)
    return None if found is None else found.architecture


@lru_cache(maxsize=64)
def _found(legs: tuple[Leg, ...], places: tuple[tuple[str, Vector], ...], tolerance: float) -> Dimensions:
    points = dict(places)
    sides = [tuple(dict.fromkeys(leg[side] for leg in legs)) for side in (0, 1)]
    words = tuple(map(leg_text, legs))
    base, platform = ([points[leg[side]] for leg in legs] for side in (0, 1))
    facts = [
        fact
        for names, body in zip(sides, ("base", "platform"), strict=True)
        for fact in body_facts({n: points[n] for n in names}, body, tolerance)
    ]
    facts += relations(base, platform, words, tolerance)
    holds = [[((leg[side],), ()) for leg in legs] for side in (0, 1)]
    facts += symmetries(words, (0,) * len(words), holds, points, tolerance)
    return Dimensions(tolerance, tuple(facts), architecture_of(base, platform, words, facts, tolerance))


def with_own_condition(analysis: Analysis, found: Dimensions, points: Points) -> Dimensions:
    """With the condition that this robot has beyond that of its legs in general position; none of a robot that is
    singular in every pose.
    """
    if found.architecture.singular or analysis.structure.special:
        return found
    own, note = own_condition(analysis, points, found.facts)
    return replace(found, own=own, note=note)
