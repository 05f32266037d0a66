"""Choosing the form: the order of the legs, the 24-term or the 16-term form, the shortest."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from gcrules.algebra.language.legs_text import Structure, leg_text, read_order
from gcrules.algebra.superbrackets.shortest import counts
from gcrules.algebra.superbrackets.superbracket import FORMS
from gcrules.conditions.manual.automatic import best_form
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.outcome import ProposalOutcome, confirmed
from gcrules.conditions.manual.words import CommandWords, relocated
from gcrules.core.errors import GcrulesError
from gcrules.core.frozen import FrozenMap

__all__ = ["choose_form", "choose_order", "form_text", "orders", "orders_text", "take_shortest"]


def choose_order(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """order 2 1 3 4 6 5, or the legs themselves. Raises InputError for anything that is no order."""
    if not words.text:
        raise words.fault("which order?", "for example: order 2 1 3 4 6 5")
    try:
        order = read_order(words.text, board.structure)
    except GcrulesError as fault:
        fault.hint = fault.hint and "for example: order 2 1 3 4 6 5"
        raise relocated(fault, words.source, words.start) from None
    return _taken(board, order, board.form.form)


def choose_form(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """form 16. Raises InputError for other numbers than 24 and 16."""
    if words.text not in map(str, FORMS):
        raise words.fault(f"there is no form {words.text}".rstrip(), "form 24 or form 16")
    return _taken(board, board.form.order, int(words.text))


def take_shortest(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """The shortest form; of several, the one in which the automatic procedure recognises most."""
    words.nothing("shortest")
    form = best_form(board.structure)
    new, outcome = _taken(board, form.order, form.form)
    data = {**outcome.data, "orders": orders(board.structure)}
    return new, replace(outcome, words=(*outcome.words, *orders_text(board.structure)), data=FrozenMap(data))


def _taken(board: Board, order: tuple[int, ...], form: int) -> tuple[Board, ProposalOutcome]:
    new = replace(Board.of(board.structure, order, form), chosen=True)
    said = [form_text(new)]
    if board.entities and new.form != board.form:
        said.append("the entities belonged to the other form; undo brings them back")
    data: dict[str, Any] = {"form": form, "order": [i + 1 for i in order], "terms": len(new.polynomial)}
    return new, confirmed("form", *said, **data)


def form_text(board: Board) -> str:
    """ "24-term form, legs in the order ab, cb: 2 terms"."""
    legs = ", ".join(leg_text(board.structure.legs[i]) for i in board.form.order)
    n = len(board.polynomial)
    return f"{board.form.form}-term form, legs in the order {legs}: {n} term{'s' * (n != 1)}"


def orders_text(structure: Structure) -> list[str]:
    """The numbers of terms over all orders in words, one line for each form."""
    return [f"{form}-term form, 720 orders: {_listed(table)}" for form, table in orders(structure).items()]


def orders(structure: Structure) -> dict[int, dict[int, int]]:
    """For both forms: number of terms -> how many of the 720 orders of the legs give so many."""
    found = counts(structure.neutral, points=structure.points, ideal=structure.ideal)
    return {form: dict(numbers) for form, numbers in found.items()}


def _listed(table: dict[int, int]) -> str:
    return ", ".join(f"{terms} term{'s' * (terms != 1)} in {number}" for terms, number in table.items())
