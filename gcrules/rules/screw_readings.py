"""Conditions of general lines with screws in their place.

An identity that is linear in a line holds for screws where it holds for lines, since every screw is a sum of lines. One
with a cofactor in which the line stands is of a higher degree, and may need the quadratic relation of lines: it is
proved of the screw itself, or dropped.
"""

from __future__ import annotations

from dataclasses import replace

from gcrules.algebra import expr as ex
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.screw_letters import Screw
from gcrules.rules.claims import certify
from gcrules.rules.condition import Condition
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.screw_words import has_screw
from gcrules.rules.sentences import comparison, factors_of, sentence
from gcrules.rules.statement import Statement

__all__ = ["meaning_with_screws", "of_screws"]


def of_screws(condition: Condition, structure: Structure, oracle: RandomWitness) -> Condition | None:
    """A condition in which screws stand for lines, proved of them and in their words; None where it does not hold."""
    meant = replace(
        condition,
        meaning=meaning_with_screws(condition, structure, oracle),
        statement_source="",
        entities=(),
        group=None,
    )
    if not has_screw(condition.cofactor):
        c = condition.certificate
        detail = f"{c.detail}; it is linear in each of them, and so holds for screws"
        return replace(meant, certificate=Certificate(c.method, detail, c.data))
    if oracle.coefficient(condition.expression, condition.cofactor) != condition.coefficient:
        return None
    proved = certify(meant, structure)
    c, data = proved.certificate, condition.certificate.data
    return replace(proved, certificate=Certificate(c.method, c.detail, {k: data[k] for k in ("rule",) if k in data}))


def meaning_with_screws(condition: Condition, structure: Structure, oracle: RandomWitness) -> Statement:
    """The sentence of a condition with screws: of the turns that two legs allow, or of each factor."""
    e, lines = condition.expression, tuple(line for name, line in condition.lines if name in ("p", "q"))
    single = _single(lines, structure, oracle) if len(lines) == 2 else ()
    if len(single) == 2 and sum(isinstance(f, ex.Sum) for f in factors_of(e)) == 1:
        return comparison(e, lines, single, structure, oracle, condition.cofactor)
    return sentence(e, structure, oracle, condition.cofactor)


def _single(lines: tuple[Expr, ...], structure: Structure, oracle: RandomWitness) -> tuple[Expr, ...]:
    """The legs that are reciprocal to neither of two lines; none where a leg is reciprocal to one of them only."""
    crossed = {leg: [oracle.zero(ex.meet(line, leg)) for line in lines] for leg in structure.lines}
    if any(isinstance(line, Screw) for line in lines) or any(len(set(both)) > 1 for both in crossed.values()):
        return ()
    return tuple(leg for leg, both in crossed.items() if not any(both))
