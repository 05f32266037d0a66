"""The analysis that a session ends with."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.manual.automatic import automatic, oracle_of
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.follow import LEFT_OVER, follow
from gcrules.conditions.manual.session import ManualSession
from gcrules.core.errors import InputError
from gcrules.rules.condition import Condition
from gcrules.rules.condition_rule import ConditionClaim
from gcrules.rules.derivation import Derivation
from gcrules.rules.deriving import from_claim, terms_of
from gcrules.rules.entities import LINES, PLANES, TETRAHEDRA
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.rule import EntityRule

__all__ = ["analysis_of"]


def analysis_of(session: ManualSession) -> Analysis:
    """The automatic analysis with the form, the entities, the derivation and the condition of the session in place of
    its own, which becomes another reading. Raises InputError before a condition is confirmed.
    """
    board, condition = session.board, session.confirmed
    if condition is None:
        raise InputError("no condition is confirmed yet", hint="propose one: condition")
    found = automatic(session.structure)
    if condition.kind == "always-singular":
        return found
    claim = next((c for c in follow(board).claims if str(c.expression) == str(condition.expression)), None)
    others = (found.condition, *found.readings)
    return replace(
        found,
        shortest=SuperbracketForm(board.form.form, board.form.order, board.form.polynomial * session.structure.sign),
        condition=condition,
        readings=tuple(r for r in others if str(r.expression) != str(condition.expression)),
        derivation=_derivation(board, claim, condition),
        claim=claim,
        notes=(*found.notes, "form, entities and condition were proposed by hand"),
    )


def _derivation(board: Board, claim: ConditionClaim | None, condition: Condition) -> Derivation:
    """From the superbracket by way of the form and the entities to coefficient · expression."""
    structure, own = board.structure, board.chosen
    if claim is not None:
        found = replace(claim, state=replace(claim.state, trail=tuple(_trail(claim.state))))
        return from_claim(structure, found, condition, oracle_of(structure), own_order=own)
    steps = terms_of(structure, board.form, condition.cofactor, own_order=own)
    if condition.right_side in (steps.after, steps.before):
        return steps
    return steps.then("straightening", condition.right_side, condition.certificate.detail)


def _trail(state: RecognitionState) -> Iterator[tuple[EntityRule, RecognitionState]]:
    """The rules of what is confirmed, each with the state after it."""
    start = replace(state, planes=(), lines=(), taken=(), homes=((),) * len(state.rest))
    if state.tetrahedra or not (state.planes or state.lines):
        yield TETRAHEDRA, start
    planes = tuple(homes[: len(state.planes)] for homes in state.homes)
    if state.planes:
        yield PLANES, replace(start, planes=state.planes, homes=planes)
    if state.lines:
        yield LINES, replace(state, taken=())
    if state.taken:
        yield LEFT_OVER[tuple(map(len, state.taken))], state
