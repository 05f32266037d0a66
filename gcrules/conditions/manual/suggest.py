"""Hints: the next command of the automatic procedure from a board."""

from __future__ import annotations

from collections import Counter

from gcrules.algebra.expr import ONE
from gcrules.algebra.language.text import text
from gcrules.conditions.manual.automatic import automatic, best_form, claims_in
from gcrules.conditions.manual.board import KINDS, Board
from gcrules.conditions.manual.outcome import Hint
from gcrules.conditions.manual.words import counted
from gcrules.rules.condition import Condition
from gcrules.rules.condition_rule import ConditionClaim

__all__ = ["suggest"]

_WHY = {
    4: "a bracket common to all terms",
    3: "three points that stay together in one bracket of every term",
    2: "two points that stay together in one bracket of every term",
}


def suggest(board: Board) -> Hint:
    """The next step of the way that the automatic procedure takes: the form, an entity, or the condition."""
    if board.condition is not None:
        return Hint(None, "the condition is confirmed; nothing is left to do")
    analysis, target = automatic(board.structure), best_form(board.structure)
    elsewhere = analysis.claim is not None and target.polynomial != board.form.polynomial
    nothing_yet = not board.entities and not board.taken
    now, then = len(board.polynomial), len(target.polynomial)
    why = f"the shortest form has {counted(then, 'term')}, this one {now}" if then < now else "another form shows more"
    shorter = Hint("shortest", why)
    if elsewhere and nothing_yet and not board.chosen:
        return shorter
    for claim in claims_in(board.form, board.structure):
        if _fits(board, claim):
            return _next(board, claim)
    if analysis.claim is None:
        return Hint(_condition(analysis.condition, board), "no incidence follows from the entities; this one is proved")
    if elsewhere and nothing_yet:
        return shorter
    return Hint("undo", "no condition of the procedure has all these entities")


def _fits(board: Board, claim: ConditionClaim) -> bool:
    """Whether everything on the board stands in the claim."""
    state = claim.state
    known = Counter((*state.tetrahedra, *state.planes, *state.lines))
    return not Counter(board.entities) - known and not Counter(board.taken) - Counter(state.taken)


def _next(board: Board, claim: ConditionClaim) -> Hint:
    state = claim.state
    known = Counter(board.entities)
    for row in (*state.tetrahedra, *state.planes, *state.lines):
        if known[row]:
            known[row] -= 1
            continue
        return Hint(f"{KINDS[len(row)]} {board.label(row)}", _WHY[len(row)])
    done = Counter(board.taken)
    left = [row for row in state.taken if not done[row]]
    if not left:
        return Hint("condition", "all entities are there")
    names = [" ".join(board.named(row)) for row in left]
    if len(left) == 2:
        labels = ", ".join(board.label(row) for row in left)
        return Hint(f"lines {labels}", "the left-over points as two lines")
    if len(left[0]) == 3:
        return Hint(f"plane {board.label(left[0])}", "the left-over points, shared out among the planes")
    return Hint(f"pair {names[0]}", "the left-over points as a line")


def _condition(condition: Condition, board: Board) -> str:
    names = board.structure.names
    cofactor = "" if condition.cofactor == ONE else f" cofactor {text(condition.cofactor, names=names)}"
    return f"condition {text(condition.expression, names=names)}{cofactor}"
