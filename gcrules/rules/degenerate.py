r"""Structures that are singular in every pose, and why: the line that all six legs meet, or the legs that depend."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import combinations

from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point, join, meet
from gcrules.algebra.language.legs_text import Leg, Structure, leg_text
from gcrules.algebra.screw_letters import Screw
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import rank
from gcrules.rules.common_lines import line_of_joints
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor
from gcrules.rules.screw_words import has_screw
from gcrules.rules.statement import Part, Statement, listing, say

__all__ = ["Degeneracy", "explain"]


@dataclass(frozen=True)
class Degeneracy:
    """Why the superbracket is zero identically. `line` is a line that all legs meet, where there is one that the joints
    determine; `legs` are the dependent legs.
    """

    reason: Statement
    legs: tuple[Leg, ...]
    line: Expr | None = None


def explain(structure: Structure) -> Degeneracy:
    """The simplest reason, for a structure whose superbracket is identically zero."""
    for rule in _RULES if structure.rank == 4 else _OTHER_RANKS:
        found = rule(structure)
        if found:
            return found
    raise AssertionError("the superbracket vanishes identically without dependent legs")


def _equal_legs(s: Structure) -> Degeneracy | None:
    for i, j in combinations(range(len(s.legs)), 2):
        if set(s.legs[i]) == set(s.legs[j]):
            return _one_line(s, i, j)
    return None


def _one_line(s: Structure, i: int, j: int) -> Degeneracy:
    some = [_WORDS.get(n, str(n)) for n in (len(s.legs) - 1, len(s.legs))]
    what = "are one screw" if isinstance(s.lines[i], Screw) else "lie on one line"
    same = say("legs {} and {} {} {}", str(i + 1), str(j + 1), what, s.words[i])
    return Degeneracy(say("{}, so at most {} of the {} are independent", same, *some), (s.legs[i], s.legs[j]))


def _same_line(s: Structure) -> Degeneracy | None:
    """Legs that the assumptions put on one line."""
    points = _evaluator(s)
    for i, j in combinations(range(len(s.legs)), 2):
        if s.special and rank([points.value(s.lines[i]), points.value(s.lines[j])], PRIME) < 2:
            return _one_line(s, i, j)
    return None


def _few_dimensions(s: Structure) -> Degeneracy | None:
    """Legs that the assumptions, or places at infinity, put in a flat pencil or in one plane."""
    points = _evaluator(s)
    if not s.special:
        return None
    for a in _busiest(s):
        there = [i for i, leg in enumerate(s.legs) if a in leg]
        for three in combinations(there, 3):
            if rank([points.value(s.lines[i]) for i in three], PRIME) < 3:
                words = "the legs {} meet in {} and lie in one plane, where at most two lines are independent"
                reason = say(words, listing(s.words[i] for i in three), Point(a))
                return Degeneracy(reason, tuple(s.legs[i] for i in three))
    oracle = RandomWitness(s)
    joined = [i for i, leg in enumerate(s.oriented) if leg in s.joined]
    for some in combinations(joined, 4):
        checkpoint()
        ends = [points.value(Point(n)) for i in some for n in s.legs[i]]
        if rank(ends, PRIME) < 4:
            couples = all(oracle.at_infinity(s.lines[i]) for i in some)
            where = "are couples (lines at infinity)" if couples else "lie in one plane"
            legs = listing(s.words[i] for i in some)
            reason = say("the legs {} {}, of which at most three are independent", legs, where)
            return Degeneracy(reason, tuple(s.legs[i] for i in some))
    return None


def _common_line(s: Structure) -> Degeneracy | None:
    """A line that meets all six legs: through two joints, through a joint across two legs, in planes of legs."""
    points = _evaluator(s)
    for line, words, why in _candidates(s):
        if any(points.value(line)) and not any(points.value(meet(line, leg))[0] for leg in s.lines):
            motion = "turn, to first order, about this line"
            if s.ideal and RandomWitness(s).at_infinity(line):
                motion = "shift, to first order, at right angles to the directions in this line at infinity"
            do = "are reciprocal to" if has_screw(*s.lines) else "meet"
            reason = say("{}all six legs {} {}, so the platform can always {}", why, do, words, motion)
            return Degeneracy(reason, s.legs, line)
    return None


def _evaluator(s: Structure) -> Evaluator:
    return Evaluator(s.construction.random_points(("degenerate", s.text())), s.rank, PRIME)


def _candidates(s: Structure) -> Iterator[tuple[Expr, Statement, Part]]:
    """Lines that the joints and legs determine, with their description and what else there is to say."""
    joints = _busiest(s)
    lines = {leg: dict(s.stand_ins).get(leg) or extensor(leg) for leg in s.oriented}
    for a, b in combinations(joints, 2):
        yield extensor((a, b)), line_of_joints(a, b, s.ideal), ""
    number = Counter(n for leg in s.legs for n in leg)
    for a in joints:
        if number[a] < 4:
            break
        point = Point(a)
        words = "{} legs meet in the joint {}, where at most three lines are independent; "
        why = say(words, _WORDS[number[a]], point)
        for g, h in combinations([leg for leg in s.oriented if a not in leg], 2):
            line = meet(join(point, lines[g]), join(point, lines[h]))
            yield line, say("the line through {} {} {} and {}", point, _crossing(s), lines[g], lines[h]), why
    planes = sorted({tuple(sorted({*g, *h})) for g, h in combinations(s.legs, 2) if len({*g, *h}) == 3})
    for two in combinations(planes, 2):
        x, y = map(extensor, two)
        yield meet(x, y), say("the common line of the planes {} and {}", x, y), ""
    for plane in planes:
        x = extensor(plane)
        for a in plane:
            for g in s.oriented:
                line = join(Point(a), meet(lines[g], x))
                yield line, say("the line through {} in the plane {} {} {}", Point(a), x, _crossing(s), lines[g]), ""


def _crossing(s: Structure) -> str:
    """A line that crosses others is reciprocal to them, and to screws it is nothing more."""
    return "that is reciprocal to" if has_screw(*s.lines) else "that crosses"


_WORDS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six"}


def _crowded_joint(s: Structure) -> Degeneracy | None:
    for name in _busiest(s):
        here = s.legs_at(name)
        if len(here) >= 4:
            words = "{} legs meet in the joint {}, where at most three lines are independent"
            return Degeneracy(say(words, _WORDS[len(here)], Point(name)), here)
    return None


def _dependent_legs(s: Structure) -> Degeneracy | None:
    points = _evaluator(s)
    rows = [points.value(line) for line in s.lines]
    where = "all positions of their joints"
    where += " that satisfy the assumptions" if s.given else ""
    for size in range(2, len(rows) + 1):
        for chosen in combinations(range(len(rows)), size):
            checkpoint()
            if rank([rows[i] for i in chosen], PRIME) < size:
                names = ", ".join(s.words[i] if s.stand_ins else leg_text(s.oriented[i]) for i in chosen)
                reason = say("the {} legs {} are dependent for {}", str(size), names, where)
                return Degeneracy(reason, tuple(s.oriented[i] for i in chosen))
    return None


_RULES: tuple[Callable[[Structure], Degeneracy | None], ...] = (
    _equal_legs,
    _same_line,
    _few_dimensions,
    _common_line,
    _crowded_joint,
    _dependent_legs,
)
_OTHER_RANKS = (_equal_legs, _same_line, _dependent_legs)


def _busiest(s: Structure) -> list[str]:
    """Joints with the most legs first."""
    number = Counter(n for leg in s.legs for n in leg)
    return sorted(s.names, key=lambda n: (-number[n], s.names.index(n)))
