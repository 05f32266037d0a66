"""Proposing what the left-over points make: a plane, or lines by the test P(x,y) + P(y,x) = 0."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms, sorted_row
from gcrules.algebra.expr import Expr, Number, mul
from gcrules.algebra.straightening.straighten import straighten
from gcrules.conditions.manual.automatic import oracle_of
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.follow import follow
from gcrules.conditions.manual.outcome import NamedValue, ProposalOutcome, confirmed, possible, refused
from gcrules.conditions.manual.words import CommandWords
from gcrules.core.dataclass import dataclass
from gcrules.rules.recognition_state import RecognitionState

__all__ = ["left_over_plane", "propose_lines", "propose_pair"]


def left_over_plane(board: Board, row: Row, fault: ProposalOutcome) -> tuple[Board, ProposalOutcome]:
    """The three left-over points, shared out among the brackets of three planes: confirmed if an incidence follows."""
    new = replace(board, taken=(*board.taken, row))
    if follow(new).claims:
        dotted = _signed(new, new.state.dotted())
        said = f"plane {board.label(row)}: the left-over points {_listed(board, row)} are shared out among the brackets"
        return new, confirmed("left-over", said, formulas=(NamedValue("superbracket", dotted),))
    said = f"the left-over points {_listed(board, row)} do not make a plane"
    if any(len(r) != 3 for r in board.entities):
        said = "left-over points make a plane where three planes have taken a bracket each"
    return board, replace(fault, reason="no-plane", words=(*fault.words, said))


def _signed(board: Board, dotted: Expr) -> Expr:
    return mul(Number(oracle_of(board.structure).coefficient(dotted) or 1), dotted)


def propose_pair(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """pair C c"""
    names = words.points(board.structure, 2, "a pair", "for example: pair C c")
    words.different(names, "a pair")
    return _propose(board, (board.row(names),), words)


def propose_lines(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """lines Cc Dd"""
    names = words.points(board.structure, 4, "two lines", "for example: lines Cc Dd")
    for pair in (names[:2], names[2:]):
        words.different(pair, "a line")
    return _propose(board, (board.row(names[:2]), board.row(names[2:])), words)


def _propose(board: Board, pairs: tuple[Row, ...], words: CommandWords) -> tuple[Board, ProposalOutcome]:
    for row in pairs:
        if row in board.taken:
            raise words.fault(f"line {board.label(row)} is already on the board")
    data: dict[str, Any] = {"proposed": [board.named(row) for row in pairs]}
    gone = Counter(i for row in pairs for i in row) - Counter(board.left)
    if gone:
        left = ", ".join(board.named(board.left)) or "none"
        points = ", ".join(board.named(tuple(gone)))
        why = f"{points}: not among the left-over points ({left})"
        return board, refused("points-taken", why, **data, left=board.named(board.left))
    new = replace(board, taken=(*board.taken, *pairs))
    tests = [_test(board, *row) for row in pairs]
    said = [t.words for t in tests]
    failed = [t for t in tests if not t.passed]
    if not failed:
        return new, confirmed("swapped", *said, **data)
    undecided = all(t.hidden for t in failed)
    if undecided and len(new.left) >= 2:
        why = "a repeated point can hide a vanished term; a condition made of it is proved or refused"
        said = [t.words if t.passed else f"{t.words}, but {why}" for t in tests]
        return new, possible("trial", *said, **data)
    if undecided and follow(new).claims:
        said.append("found by trial: a repeated point hides a vanished term, and the incidence of the entities holds")
        return new, confirmed("trial", *said, **data)
    if undecided:
        said.append("a repeated point could hide a vanished term, but no incidence of these entities holds either")
    formulas = tuple(f for t in failed for f in t.formulas)
    return board, refused("not-swapped", *said, formulas=formulas, **data)


@dataclass(frozen=True)
class _Test:
    """P(x,y) + P(y,x): whether it is zero; `hidden` if x or y is repeated, so that the test does not decide."""

    passed: bool
    hidden: bool
    words: str
    formulas: tuple[NamedValue, ...]


def _test(board: Board, x: int, y: int) -> _Test:
    a, b = board.named((x, y))
    first: tuple[BracketPolynomial, BracketPolynomial] | None = None
    name = f"P({a},{b}) + P({b},{a})"
    for state in board.states():
        swapped = _swapped(state, x, y)
        if not state.rest + swapped:
            return _Test(True, False, f"line {board.label((x, y))}: {name} = 0", ())
        first = first or (state.rest, swapped)
    assert first is not None, "the entities fit the form"
    total = first[0] + first[1]
    content = Counter(i for row in next(iter(first[0].terms)) for i in row)
    hidden = content[x] > 1 or content[y] > 1
    if not hidden and not straighten(total):
        return _Test(True, False, f"line {board.label((x, y))}: {name} = 0 (its normal form)", ())
    shown = ((f"P({a},{b})", first[0]), (f"P({b},{a})", first[1]), ("their sum", total))
    formulas = tuple(NamedValue(what, p.to_expr()) for what, p in shown)
    return _Test(False, hidden, f"line {board.label((x, y))}: {name} is not zero", formulas)


def _swapped(state: RecognitionState, x: int, y: int) -> BracketPolynomial:
    """The rest with the left-over points x and y exchanged; points of entities (which bear stars) stay."""
    exchange = {x: y, y: x}
    terms: Terms = {}
    for (monomial, c), homes in zip(state.rest.terms.items(), state.homes, strict=True):
        entity_of = dict(zip(homes, (*state.planes, *state.lines), strict=True))
        sign, rows = 1, []
        for i, row in enumerate(monomial):
            fixed = entity_of.get(i, ())
            plain = [p for p in row if p not in fixed]
            s, _ = sorted_row((*fixed, *plain))
            t, new = sorted_row((*fixed, *(exchange.get(p, p) for p in plain)))
            sign *= s * t
            rows.append(new)
        key: Monomial = tuple(sorted(rows))
        terms[key] = terms.get(key, 0) + sign * c
    return state.rest.with_terms(terms)


def _listed(board: Board, row: Row) -> str:
    return ", ".join(board.named(row))
