r"""Structures that are singular in every pose, and why: the line that all six legs meet, or the legs that depend."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations

from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr, join, meet
from gcrules.legs import Leg, Structure, leg_text
from gcrules.rules.state import extensor

__all__ = ["Degeneracy", "explain"]


@dataclass(frozen=True)
class Degeneracy:
    """Why the superbracket is zero identically. `line` is a line that all legs meet, where there is one that the joints
    determine; `legs` are the dependent legs.
    """

    reason: str
    legs: tuple[Leg, ...]
    line: Expr | None = None


def explain(structure: Structure) -> Degeneracy:
    """The simplest reason, for a structure whose superbracket is identically zero."""
    for rule in _RULES:
        found = rule(structure)
        if found:
            return found
    raise AssertionError("the superbracket vanishes identically without dependent legs")


def _equal_legs(s: Structure) -> Degeneracy | None:
    for i, j in combinations(range(len(s.legs)), 2):
        if set(s.legs[i]) == set(s.legs[j]):
            same = f"legs {i + 1} and {j + 1} lie on one line {leg_text(s.legs[i])}"
            reason = f"{same}, so at most five of the six are independent"
            return Degeneracy(reason, (s.legs[i], s.legs[j]))
    return None


def _common_line(s: Structure) -> Degeneracy | None:
    """A line that meets all six legs: through two joints, through a joint across two legs, in planes of legs."""
    points = Evaluator(random_points(s.names, ideal=s.ideal, seed=4), 4, PRIME)
    legs = [extensor(leg) for leg in s.oriented]
    for line, words, why in _candidates(s):
        if any(points.value(line)) and not any(points.value(meet(line, leg))[0] for leg in legs):
            reason = f"{why}all six legs meet {words}, so the platform can always turn, to first order, about this line"
            return Degeneracy(reason, s.legs, line)
    return None


def _candidates(s: Structure) -> Iterator[tuple[Expr, str, str]]:
    """Lines that the joints and legs determine, with their description and what else there is to say."""
    joints = _busiest(s)
    for a, b in combinations(joints, 2):
        yield extensor((a, b)), f"the line {leg_text((a, b))} through the joints {a} and {b}", ""
    number = Counter(n for leg in s.legs for n in leg)
    for a in joints:
        if number[a] < 4:
            break
        point = extensor((a,))
        why = f"{_WORDS[number[a]]} legs meet in the joint {a}, where at most three lines are independent; "
        for g, h in combinations([leg for leg in s.oriented if a not in leg], 2):
            line = meet(join(point, extensor(g)), join(point, extensor(h)))
            yield line, f"the line through {a} that crosses {leg_text(g)} and {leg_text(h)}", why
    planes = sorted({tuple(sorted({*g, *h})) for g, h in combinations(s.legs, 2) if len({*g, *h}) == 3})
    for x, y in combinations(planes, 2):
        yield meet(extensor(x), extensor(y)), f"the common line of the planes {extensor(x)} and {extensor(y)}", ""
    for x in planes:
        for a in x:
            for g in s.oriented:
                line = join(extensor((a,)), meet(extensor(g), extensor(x)))
                yield line, f"the line through {a} in the plane {extensor(x)} that crosses {leg_text(g)}", ""


_WORDS = {4: "four", 5: "five", 6: "six"}


def _crowded_joint(s: Structure) -> Degeneracy | None:
    for name in _busiest(s):
        here = s.legs_at(name)
        if len(here) >= 4:
            reason = f"{_WORDS[len(here)]} legs meet in the joint {name}, where at most three lines are independent"
            return Degeneracy(reason, here)
    return None


def _dependent_legs(s: Structure) -> Degeneracy | None:
    points = Evaluator(random_points(s.names, ideal=s.ideal, seed=3), 4, PRIME)
    rows = {leg: points.value(extensor(leg)) for leg in dict.fromkeys(s.oriented)}
    for size in range(1, 7):
        for chosen in combinations(rows, size):
            if _rank([list(rows[leg]) for leg in chosen]) < size:
                names = ", ".join(map(leg_text, chosen))
                if size == 1:
                    reason = f"the leg {names} is no line: its ends coincide"
                else:
                    reason = f"the {size} legs {names} are dependent for all positions of their joints"
                return Degeneracy(reason, chosen)
    return None


_RULES: tuple[Callable[[Structure], Degeneracy | None], ...] = (
    _equal_legs,
    _common_line,
    _crowded_joint,
    _dependent_legs,
)


def _busiest(s: Structure) -> list[str]:
    """Joints with the most legs first."""
    number = Counter(n for leg in s.legs for n in leg)
    return sorted(s.names, key=lambda n: (-number[n], s.names.index(n)))


def _rank(rows: list[list[int]]) -> int:
    """Rank modulo the oracle's prime."""
    rank = 0
    for column in range(len(rows[0])):
        pivot = next((i for i in range(rank, len(rows)) if rows[i][column] % PRIME), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        inverse = pow(rows[rank][column], -1, PRIME)
        for i in range(rank + 1, len(rows)):
            factor = rows[i][column] * inverse % PRIME
            rows[i] = [(x - factor * y) % PRIME for x, y in zip(rows[i], rows[rank], strict=True)]
        rank += 1
    return rank
