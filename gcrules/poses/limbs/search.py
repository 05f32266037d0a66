r"""The first singular configuration along a straight course of coordinates or actuators, from home.

Samples are taken along the course. Where a factor of the condition changes its sign between two of them, or the
margin σ has a least value, the place is narrowed down, solving the loops anew each time. What lies
between two samples without showing is not found: this is a search, not a proof of absence.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import Solution, goal
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.limbs.factors import factors
from gcrules.screws.verdict import SOLVED

__all__ = ["SAMPLES", "SampledSolution", "first_singular"]

SAMPLES = 32
_MOST = 60  # solutions for one place
_TINY = 1e-15
_GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, eq=False)
class SampledSolution:
    """A solution at a part of the course, and the number of samples taken before it."""

    solution: Solution
    part: float
    samples: int


def first_singular(
    m: Linkage, analysis: RobotAnalysis, wanted: Target, samples: int = SAMPLES
) -> SampledSolution | None:
    """The first one that is found, or None. Raises InputError where the course does not assemble before it.

    What is wanted has passed `check_target`.
    """
    course = Course(m, wanted)
    way = [Solution(m.home, wanted)]

    def signed(s: Solution) -> list[float]:
        return [f.value for f in factors(analysis, s.configuration.values) if f.live]

    def sigma(s: Solution) -> float:
        return margin(m, s.configuration).sigma

    signs, sizes = [signed(way[0])], [sigma(way[0])]
    for k in range(1, samples + 1):
        checkpoint()
        way.append(goal(course, way[-1], (k - 1) / samples, k / samples))
        signs.append(signed(way[-1]))
        sizes.append(sigma(way[-1]))
        changed = [n for n, (a, b) in enumerate(zip(signs[-2], signs[-1], strict=True)) if a * b < 0]
        found: list[SampledSolution] = []
        for n in changed:
            ends = ((k - 1) / samples, way[-2]), (k / samples, way[-1])
            part, s = _zero(course, *ends, lambda s, n=n: signed(s)[n])  # type: ignore[misc]
            found.append(SampledSolution(s, part, k))
        if k > 1 and not found and sizes[-2] < min(sizes[-1], sizes[-3]):
            part, s = _least(course, way[-3], (k - 2) / samples, k / samples, sigma)
            found += [SampledSolution(s, part, k)] if sigma(s) <= SOLVED else []
        true = [one for one in found if sigma(one.solution) <= SOLVED]
        if true:
            part = min(one.part for one in true)
            return SampledSolution(goal(course, Solution(m.home, wanted), 0.0, part), part, k)
    return None


def _zero(
    course: Course, one: tuple[float, Solution], two: tuple[float, Solution], value: Callable[[Solution], float]
) -> tuple[float, Solution]:
    """Where a value changes its sign between two solutions: the Illinois variant of the rule of false position, each
    solution starting from the first one.
    """
    (start, first), (b, best) = one, two
    a, at_a, at_b = start, value(first), value(best)
    for _ in range(_MOST):
        checkpoint()
        part = b - at_b * (b - a) / (at_b - at_a)
        try:
            there = goal(course, first, start, part)
        except InputError:  # the equations themselves are singular at the place that is sought
            break
        found = value(there)
        if found * at_b < 0:
            a, at_a = b, at_b
        else:
            at_a /= 2
        moved, b, at_b, best = abs(part - b), part, found, there
        if abs(at_b) < _TINY or moved < _TINY:
            break
    return b, best


def _least(
    course: Course, start: Solution, low: float, high: float, value: Callable[[Solution], float]
) -> tuple[float, Solution]:
    """Where a value is least, by golden section."""
    first = low

    def at(part: float) -> Solution:
        return goal(course, start, first, part)

    a, b = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    one, two = at(a), at(b)
    at_a, at_b = value(one), value(two)
    for _ in range(_MOST):
        checkpoint()
        if at_a < at_b:
            high, b, two, at_b = b, a, one, at_a
            a = high - _GOLDEN * (high - low)
            one = at(a)
            at_a = value(one)
        else:
            low, a, one, at_a = a, b, two, at_b
            b = low + _GOLDEN * (high - low)
            two = at(b)
            at_b = value(two)
    return (a, one) if at_a < at_b else (b, two)
