"""What follows from the entities of a board: the incidence rules that they fit, and what is missing for others."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gcrules.algebra.expr import Expr
from gcrules.conditions.manual.automatic import oracle_of, strategy
from gcrules.conditions.manual.board import KINDS, Board
from gcrules.conditions.manual.words import counted
from gcrules.core.dataclass import dataclass
from gcrules.rules.condition_rule import ConditionClaim, claims
from gcrules.rules.entities import LEFT_OVER_LINE, LEFT_OVER_LINES, LEFT_OVER_PLANE, LINES, PLANES
from gcrules.rules.rule import ConditionRule, EntityRule

__all__ = ["LEFT_OVER", "Following", "follow"]

_ENTITIES = {PLANES.id: 3, LINES.id: 2}

LEFT_OVER: Mapping[tuple[int, ...], EntityRule] = {
    (3,): LEFT_OVER_PLANE,
    (2,): LEFT_OVER_LINE,
    (2, 2): LEFT_OVER_LINES,
}
"""Numbers of left-over points that are taken together -> the rule that takes them."""

_SIZES = {rule.id: sizes for sizes, rule in LEFT_OVER.items()}


@dataclass(frozen=True)
class Following:
    """`claims` that hold, `wrong` expressions of rules whose entities are all there but that do not hold, and what is
    `missing` for the other rules that the entities fit (rule, what in words).
    """

    claims: tuple[ConditionClaim, ...] = ()
    wrong: tuple[Expr, ...] = ()
    missing: tuple[tuple[str, str], ...] = ()


def follow(board: Board) -> Following:
    """What the incidence rules make of the entities."""
    state, oracle = board.state, oracle_of(board.structure)
    found: list[ConditionClaim] = []
    wrong: list[Expr] = []
    missing: list[tuple[str, str]] = []
    for rule in strategy().incidences:
        lacking = _lacking(rule, board)
        if lacking is None:
            continue
        if lacking:
            missing.append((rule.id, lacking))
            continue
        here = list(claims(replace(rule, uses=()), [state], oracle))
        expression = rule.expression(state)
        found += here
        if not here and expression is not None:
            wrong.append(expression)
    return Following(tuple(found), tuple(wrong), tuple(missing))


def _lacking(rule: ConditionRule, board: Board) -> str | None:
    """What the board lacks for a rule, in words ("" for nothing); None where its entities do not fit the rule."""
    wanted = {3: 0, 2: 0}
    left: tuple[int, ...] = ()
    for used, number in rule.uses:
        if used.id in _ENTITIES:
            wanted[_ENTITIES[used.id]] += number
        elif used.id in _SIZES:
            left = _SIZES[used.id]
        else:
            return None
    tetrahedra = 0 if rule.degree is None else 3 - rule.degree
    numbers = {4: tetrahedra, **wanted}
    parts = []
    if tetrahedra > board.common:
        return None
    for size, number in numbers.items():
        have = len(board.of_size(size))
        if have > number:
            return None
        if have < number:
            parts.append(_more(number - have, KINDS[size]))
    sizes = sorted((len(row) for row in board.taken), reverse=True)
    if sizes != list(left[: len(sizes)]):
        return None
    open_points = left[len(sizes) :]
    if open_points:
        noun = KINDS[open_points[0]]
        parts.append(f"the left-over points as {counted(len(open_points), noun).replace('one ', 'a ')}")
    return ", ".join(parts)


def _more(number: int, noun: str) -> str:
    plural = {"tetrahedron": "tetrahedra"}.get(noun, f"{noun}s")
    return f"one {noun}" if number == 1 else f"{counted(number, noun).split()[0]} {plural}"
