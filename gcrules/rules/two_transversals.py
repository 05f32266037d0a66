r"""The condition that follows from two lines p and q that meet four legs, and from the other two legs g and h.

Without g and h the platform can turn about p and about q. Each of g and h allows these two turns in one ratio only. A
leg that crosses p in every pose does not hinder the turn about p: then the comparison of the ratios is one product.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Bracket, Expr, Meet, meet
from gcrules.algebra.for_two_points import written_back
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.algebra.letters import wholes
from gcrules.core.dataclass import dataclass
from gcrules.rules.common_lines import CommonLine
from gcrules.rules.condition import Condition
from gcrules.rules.generic_lines import alive, statement_of_lines
from gcrules.rules.line_cofactors import Balance, compared, quotient
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor
from gcrules.rules.screw_readings import meaning_with_screws
from gcrules.rules.screw_words import has_screw
from gcrules.rules.sentences import described, sentence
from gcrules.rules.statement import Part, Statement, listing, say

__all__ = ["KIND", "TransversalCondition", "reading_of", "written_into"]

KIND = "transversals"
_TESTED = Certificate("random-points", "holds at exact random points")


@dataclass(frozen=True)
class TransversalCondition:
    """A transversal condition, with the legs g and h and the lines p and q that it compares."""

    condition: Condition
    single: tuple[Leg, Leg]
    lines: tuple[CommonLine, CommonLine]


def reading_of(
    structure: Structure,
    single: tuple[Leg, Leg],
    lines: tuple[CommonLine, CommonLine],
    factors: Balance,
    oracle: RandomWitness,
) -> TransversalCondition | None:
    """The condition for the single legs g, h and the lines p, q, not yet proved; None where both sides vanish."""
    p, q = (line.expression for line in lines)
    found = _Comparison.made(structure, single, (p, q), factors, oracle)
    if found is None:
        return None
    expression = ex.mul(*found.tetrahedra, *found.turns)
    coefficient = oracle.coefficient(expression, ex.mul(*found.cofactor))
    if coefficient is None:
        return None
    condition = Condition(
        kind=KIND,
        expression=expression,
        cofactor=ex.mul(*found.cofactor),
        coefficient=coefficient,
        meaning=_meaning(structure, single, lines, found),
        certificate=_TESTED,
        lines=(("p", p), ("q", q)),
    )
    return TransversalCondition(condition, single, lines)


def written_into(
    reading: TransversalCondition, structure: Structure, oracle: RandomWitness
) -> TransversalCondition | None:
    """A reading of the lifted structure with the lines in the place of their stand-ins; None where these occur apart or
    both sides vanish.
    """

    def write(e: Expr) -> Expr | None:
        return written_back(e, structure.stand_ins)

    def words(e: Expr, meaning: Statement) -> Statement | None:
        if has_screw(e):
            return described(e, structure, oracle)
        return statement_of_lines(meaning, structure.stand_ins)

    lines = [
        CommonLine(e, meaning)
        for line in reading.lines
        if (e := write(line.expression)) is not None and (meaning := words(e, line.meaning)) is not None
    ]
    old = reading.condition
    expression, cofactor = map(write, (old.expression, old.cofactor))
    if expression is None or cofactor is None or len(lines) < 2:
        return None
    whole, expression = expression, alive(expression, structure)
    coefficient = oracle.coefficient(expression, cofactor)
    if coefficient is None:
        return None
    p, q = lines
    meaning = statement_of_lines(old.meaning, structure.stand_ins) if expression == whole else None
    condition = replace(
        old,
        expression=expression,
        cofactor=cofactor,
        coefficient=coefficient,
        meaning=meaning or sentence(expression, structure, oracle, cofactor),
        lines=(("p", p.expression), ("q", q.expression)),
    )
    if has_screw(expression, cofactor):
        condition = replace(condition, meaning=meaning_with_screws(condition, structure, oracle))
    return TransversalCondition(condition, reading.single, (p, q))


@dataclass(frozen=True)
class _Comparison:
    """cofactor · superbracket = c · tetrahedra · turns; `crossing` holds the (line, leg) that meet in every pose, and
    `decisive` the (line, leg) that meet only where the product vanishes.
    """

    cofactor: tuple[Expr, ...]
    tetrahedra: tuple[Expr, ...]
    turns: tuple[Expr, ...]
    crossing: tuple[tuple[str, str], ...] = ()
    decisive: tuple[tuple[str, str], ...] = ()

    @classmethod
    def made(
        cls,
        structure: Structure,
        single: tuple[Leg, Leg],
        lines: tuple[Expr, Expr],
        factors: Balance,
        oracle: RandomWitness,
    ) -> _Comparison | None:
        legs = dict(zip("gh", map(extensor, single), strict=True))
        named = dict(zip("pq", lines, strict=True))
        crossing = tuple((x, g) for x in "pq" for g in "gh" if oracle.zero(meet(named[x], legs[g])))
        products = [t for t in _PRODUCTS if not set(t) & set(crossing)]
        if not products:
            return None
        if len(products) == 2:
            return cls(factors.cofactor, factors.tetrahedra, (compared(*lines, *legs.values()),))
        cofactor, tetrahedra = list(factors.cofactor), list(factors.tetrahedra)
        turns, decisive = [], []
        for x, g in products[0]:
            e = meet(named[x], legs[g])
            cancelled = ((d, quotient(e, d, oracle, structure.names)) for d in cofactor)
            divisor, brackets = next((found for found in cancelled if found[1] is not None), (None, None))
            if divisor is not None and brackets is not None:
                cofactor.remove(divisor)
                tetrahedra += brackets
            else:
                turns.append(e)
                decisive.append((x, g))
        return cls(tuple(cofactor), tuple(tetrahedra), tuple(turns), crossing, tuple(decisive))


_PRODUCTS = ((("p", "g"), ("q", "h")), (("p", "h"), ("q", "g")))


# --- in words --------------------------------------------------------------------------------------------------------


def _meaning(
    structure: Structure, single: tuple[Leg, Leg], lines: tuple[CommonLine, CommonLine], found: _Comparison
) -> Statement:
    legs = dict(zip("gh", map(extensor, single), strict=True))
    turns = say(
        "Without the legs {} and {} the platform can turn, to first order, about p, {}, and about q, {}.",
        *legs.values(),
        *(line.meaning for line in lines),
    )
    exception: Part = ""
    if found.cofactor:
        vanishing = [_vanishing(f, lines, structure) for f in found.cofactor]
        where = say(" or ".join(["{}"] * len(vanishing)), *vanishing)
        exception = say("outside the poses where the cofactor vanishes ({}), ", where)
    conditions = listing(_alternatives(legs, found, structure.ideal), ", or ")
    reason = _reason(legs, found)
    return say("{} {}{}the robot is singular exactly when {}.", turns, reason, exception, conditions)


def _reason(legs: dict[str, Expr], found: _Comparison) -> Statement:
    if not found.crossing:
        return say("Each of {} and {} allows these two turns in one ratio only; ", *legs.values())
    always = [say("{} crosses {}", legs[g], x) for x, g in found.crossing]
    return say("{} in every pose; ", say(" and ".join(["{}"] * len(always)), *always))


def _alternatives(legs: dict[str, Expr], found: _Comparison, ideal: tuple[str, ...]) -> Iterator[Part]:
    """What makes the right side vanish."""
    for t in found.tetrahedra:
        if sum(str(p) in ideal for p in t.children) > 1:
            yield say("the points {} lie in one plane", listing(t.children))
        elif len(parts := wholes(t.children)) < len(t.children):
            yield say("{} lie in one plane", listing(parts))
        else:
            yield say("the tetrahedron {} is flat (its four points lie in one plane)", ex.join(*t.children))
    if not found.crossing:
        yield "the two ratios agree"
    for x, g in found.decisive:
        too = " too" if any(x == line for line, _ in found.crossing) else ""
        yield say("{} crosses {}{}", legs[g], x, too)


def _vanishing(factor: Expr, lines: Sequence[CommonLine], structure: Structure) -> Statement:
    """What it means that a factor of the cofactor is 0."""
    if isinstance(factor, Bracket):
        points = {str(a) for a in factor.args}
        for g, h in combinations(structure.neutral, 2):
            if {*g, *h} == points:
                return say("the legs {} and {} then lie in one plane", extensor(g), extensor(h))
        return say("the points {} then lie in one plane", listing(factor.args))
    ends = factor.children[-1]
    name, line = next((n, x.expression) for n, x in zip("pq", lines, strict=True) if meet(x.expression, ends) == factor)
    through = set.intersection(*(set(ex.points_of(x)) for x in line.children)) if isinstance(line, Meet) else set()
    if len(through) == 1:
        plane = sorted({*through, *ex.points_of(ends)}, key=structure.names.index)
        if set(plane) <= set(structure.ideal):
            return say("{} then lies at infinity, or is not determined", name)
        return say("{} then lies in the plane {}, or is not determined", name, extensor(tuple(plane)))
    return say("{} then meets the line {}, or is not determined", name, ends)
