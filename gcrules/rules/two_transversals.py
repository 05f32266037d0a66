r"""The condition that follows from two lines p and q that meet four legs, and from the other two legs g and h.

Without g and h the platform can turn about p and about q. Each of g and h allows these two turns in one ratio only. A
leg that crosses p in every pose does not hinder the turn about p: then the comparison of the ratios is one product.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Bracket, Expr, Meet, meet
from gcrules.algebra.language.legs_text import Leg, Structure, leg_text
from gcrules.core.english import listed
from gcrules.rules.common_lines import CommonLine
from gcrules.rules.condition import Condition
from gcrules.rules.generic_lines import alive, written_back
from gcrules.rules.line_cofactors import Balance, compared, quotient
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor
from gcrules.rules.sentences import sentence

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
        statement=_statement(structure, single, lines, found),
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
    lines = [
        CommonLine(e, _with_words(line.words, structure))
        for line in reading.lines
        if (e := written_back(line.expression, structure.stand_ins)) is not None
    ]
    old = reading.condition
    expression, cofactor = (written_back(e, structure.stand_ins) for e in (old.expression, old.cofactor))
    if expression is None or cofactor is None or len(lines) < 2:
        return None
    whole, expression = expression, alive(expression, structure)
    coefficient = oracle.coefficient(expression, cofactor)
    if coefficient is None:
        return None
    ratios = expression == whole
    p, q = lines
    condition = replace(
        old,
        expression=expression,
        cofactor=cofactor,
        coefficient=coefficient,
        statement=_with_words(old.statement, structure)
        if ratios
        else sentence(expression, structure, oracle, cofactor),
        lines=(("p", p.expression), ("q", q.expression)),
    )
    return TransversalCondition(condition, reading.single, (p, q))


def _with_words(text: str, structure: Structure) -> str:
    for ends, line in structure.stand_ins:
        text = text.replace(leg_text(ends), f"({line})")
    return text


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


def _statement(
    structure: Structure, single: tuple[Leg, Leg], lines: tuple[CommonLine, CommonLine], found: _Comparison
) -> str:
    g, h = map(leg_text, single)
    p, q = (line.words for line in lines)
    turns = f"Without the legs {g} and {h} the platform can turn, to first order, about p, {p}, and about q, {q}."
    exception = ""
    if found.cofactor:
        vanishing = " or ".join(_vanishing(f, lines, structure) for f in found.cofactor)
        exception = f"outside the poses where the cofactor vanishes ({vanishing}), "
    *first, last = _alternatives({"g": g, "h": h}, found, structure.ideal)
    conditions = f"{', '.join(first)}, or {last}" if first else last
    sentence = f"{_reason({'g': g, 'h': h}, found)}{exception}the robot is singular exactly when {conditions}."
    return f"{turns} {sentence}"


def _reason(legs: dict[str, str], found: _Comparison) -> str:
    if not found.crossing:
        return f"Each of {legs['g']} and {legs['h']} allows these two turns in one ratio only; "
    always = " and ".join(f"{legs[g]} crosses {x}" for x, g in found.crossing)
    return f"{always} in every pose; "


def _alternatives(legs: dict[str, str], found: _Comparison, ideal: tuple[str, ...]) -> Iterator[str]:
    """What makes the right side vanish."""
    for t in found.tetrahedra:
        names = [str(p) for p in t.children]
        if sum(n in ideal for n in names) > 1:
            yield f"the points {listed(names)} lie in one plane"
        else:
            yield f"the tetrahedron {ex.join(*t.children)} is flat (its four points lie in one plane)"
    if not found.crossing:
        yield "the two ratios agree"
    for x, g in found.decisive:
        too = " too" if any(x == line for line, _ in found.crossing) else ""
        yield f"{legs[g]} crosses {x}{too}"


def _vanishing(factor: Expr, lines: Sequence[CommonLine], structure: Structure) -> str:
    """What it means that a factor of the cofactor is 0."""
    if isinstance(factor, Bracket):
        points = {str(a) for a in factor.args}
        for g, h in combinations(structure.neutral, 2):
            if {*g, *h} == points:
                return f"the legs {leg_text(g)} and {leg_text(h)} then lie in one plane"
        return f"the points {listed(list(map(str, factor.args)))} then lie in one plane"
    ends = factor.children[-1]
    name, line = next((n, x.expression) for n, x in zip("pq", lines, strict=True) if meet(x.expression, ends) == factor)
    through = set.intersection(*(set(ex.points_of(x)) for x in line.children)) if isinstance(line, Meet) else set()
    if len(through) == 1:
        plane = sorted({*through, *ex.points_of(ends)}, key=structure.names.index)
        if set(plane) <= set(structure.ideal):
            return f"{name} then lies at infinity, or is not determined"
        return f"{name} then lies in the plane {extensor(tuple(plane))}, or is not determined"
    return f"{name} then meets the line {ends}, or is not determined"
