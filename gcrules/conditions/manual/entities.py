"""Proposing tetrahedra, planes and lines: points that stay together in one bracket of every term."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

from gcrules.algebra.bracket import Row
from gcrules.conditions.manual.automatic import form_showing
from gcrules.conditions.manual.board import KINDS, Board
from gcrules.conditions.manual.evidence import bracket_divides, dividing_brackets, flat
from gcrules.conditions.manual.left_over import left_over_plane
from gcrules.conditions.manual.outcome import ProposalOutcome, confirmed, refused
from gcrules.conditions.manual.words import CommandWords
from gcrules.core.english import agreeing, listed

__all__ = ["propose_line", "propose_plane", "propose_tetrahedron"]


def propose_tetrahedron(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """tetrahedron Aabc. Raises InputError where the points make no sense or are confirmed already."""
    row = _row(board, words, 4, "for example: tetrahedron Aabc")
    label = f"[{board.label(row)}]"
    fault = _broken(board, row)
    if fault is None:
        return _with(board, row, confirmed("common", f"tetrahedron {board.label(row)}: {label} occurs in every term"))
    if row in board.entities:
        raise words.fault(f"tetrahedron {board.label(row)} is already confirmed; no term contains it a second time")
    if fault.reason != "apart":
        return board, fault
    return board, _no_tetrahedron(board, row, label, fault)


def propose_plane(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """plane Aab. Raises InputError as for a tetrahedron."""
    row = _row(board, words, 3, "for example: plane Aab")
    _not_twice(board, row, words)
    fault = _broken(board, row)
    if fault is None:
        return _with(board, row, _together(board, row))
    if row == board.left and not board.free:
        return left_over_plane(board, row, fault)
    return board, fault


def propose_line(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """line AB. Raises InputError as for a tetrahedron."""
    row = _row(board, words, 2, "for example: line AB")
    _not_twice(board, row, words)
    fault = _broken(board, row)
    if fault is None:
        return _with(board, row, _together(board, row))
    if not Counter(row) - Counter(board.left):
        names = " ".join(board.named(row))
        words_too = (*fault.words, f"left-over points are proposed as: pair {names}")
        fault = replace(fault, words=words_too)
    return board, fault


def _row(board: Board, words: CommandWords, size: int, hint: str) -> Row:
    noun = f"a {KINDS[size]}"
    names = words.points(board.structure, size, noun, hint)
    words.different(names, noun)
    return board.row(names)


def _not_twice(board: Board, row: Row, words: CommandWords) -> None:
    if row in (*board.entities, *board.taken):
        raise words.fault(f"{board.entity_text(row)} is already confirmed")


def _with(board: Board, row: Row, outcome: ProposalOutcome) -> tuple[Board, ProposalOutcome]:
    return replace(board, entities=(*board.entities, row)), outcome


def _together(board: Board, row: Row) -> ProposalOutcome:
    where = "a bracket of its own in every term" if board.entities else "one bracket of every term"
    return confirmed("together", f"{board.entity_text(row)}: together in {where}")


def _broken(board: Board, row: Row) -> ProposalOutcome | None:
    """Why the entities and `row` cannot have brackets of their own in every term; None if they can."""
    data: dict[str, Any] = {"proposed": board.named(row)}
    lacking = Counter(row) - Counter(board.left)
    number = board.broken(row)
    if number is None:
        if not lacking:
            return None
        takers = [r for r in board.taken if set(r) & set(lacking)]
        by = listed([board.label(r) for r in takers])
        points = ", ".join(board.named(tuple(lacking)))
        return refused("points-taken", f"{points}: already taken by {by}", **data, by=[board.named(r) for r in takers])
    monomial, _ = board.terms[number - 1]
    term = board.term_text(number)
    data |= {"term": number, "brackets": [board.named(b) for b in monomial]}
    holding = [b for b in monomial if set(row) <= set(b)]
    if not holding:
        what = f"[{board.label(row)}]" if len(row) == 4 else f"bracket with {listed(board.named(row))}"
        return refused("apart", f"{term}, has no {what}", **data)
    if not board.free:
        return refused("bracket-taken", f"{term}: each of its brackets already has an entity", **data, by=[])
    takers = [r for r in board.entities if any(set(r) <= set(b) for b in holding)]
    brackets = [f"[{board.label(b)}]" for b in dict.fromkeys(holding)]
    only = agreeing(brackets, "holds", "hold")
    by = agreeing([board.entity_text(r) for r in takers], "has", "have")
    it = "it" if len(brackets) == 1 else "them"
    said = f"{term}: only {only} {listed(board.named(row))}, and {by} taken {it}"
    return refused("bracket-taken", said, **data, by=[board.named(r) for r in takers])


def _no_tetrahedron(board: Board, row: Row, label: str, fault: ProposalOutcome) -> ProposalOutcome:
    """Says besides whether the bracket divides the superbracket, and which ones do."""
    structure, names = board.structure, board.named(row)
    if bracket_divides(structure, names):
        said = [*fault.words, f"{label} divides the superbracket all the same; this form hides it"]
        form = form_showing(structure, row)
        if form is not None:
            order = " ".join(str(i + 1) for i in form.order)
            said.append(f"the {form.form}-term form shows it with the legs in the order {order}")
        data = {**fault.data, "order": [i + 1 for i in form.order] if form else None, "form": form and form.form}
        return refused("hidden-factor", *said, **data)
    others = dividing_brackets(structure)
    which = " ".join(f"[{board.label(board.row(n))}]" for n in others)
    which = f"only {which} {'does' if len(others) == 1 else 'do'}" if others else "no bracket does"
    said = [*fault.words, f"it does not divide the superbracket: {which}"]
    data = {**fault.data, "dividing": others}
    seen = flat(structure, names)
    if seen is not None:
        said.append(f"at these points its four points lie in a plane, but the superbracket is {seen.superbracket}")
        data |= {"points": seen.points, "superbracket": seen.superbracket}
    return refused("no-factor", *said, **data)
