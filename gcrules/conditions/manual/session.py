r"""Sessions: what was proposed, what was answered, and the board that it led to.

>>> s = ManualSession.start("ab af cb cd ed ef").plane("abc").plane("abd")
>>> s.outcome.answer, s.outcome.reason, s.outcome.data["term"]
('refused', 'apart', 2)
>>> s.plane("bdf").plane("cde").plane("aef").condition().board.condition.kind
'four-planes'
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure, read_legs, read_order
from gcrules.algebra.language.text import Names, text
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.conditions.manual.automatic import automatic
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.conditions import propose_condition
from gcrules.conditions.manual.entities import propose_line, propose_plane, propose_tetrahedron
from gcrules.conditions.manual.forms import choose_form, choose_order, orders, take_shortest
from gcrules.conditions.manual.left_over import propose_lines, propose_pair
from gcrules.conditions.manual.outcome import Hint, ProposalOutcome, refused
from gcrules.conditions.manual.suggest import suggest
from gcrules.conditions.manual.words import CommandWords
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, Span
from gcrules.core.hints import near
from gcrules.core.shown import Shown
from gcrules.rules.condition import Condition

__all__ = ["MOVES", "PROPOSALS", "ManualSession", "Record"]

PROPOSALS: Mapping[str, Callable[[Board, CommandWords], tuple[Board, ProposalOutcome]]] = {
    "order": choose_order,
    "form": choose_form,
    "shortest": take_shortest,
    "tetrahedron": propose_tetrahedron,
    "plane": propose_plane,
    "line": propose_line,
    "pair": propose_pair,
    "lines": propose_lines,
    "condition": propose_condition,
}
"""The commands that are recorded: verb -> what makes a new board and an outcome of a board and the argument."""

MOVES = ("undo", "redo", "auto")
"""The other commands that `ManualSession.do` takes."""

_MOST_STEPS = 30  # of `auto`


@dataclass(frozen=True)
class Record:
    """One proposal: the command as it can be given again, its outcome, and the board afterwards."""

    command: str
    outcome: ProposalOutcome
    board: Board

    def to_json(self) -> dict[str, Any]:
        return {"command": self.command, **self.outcome.to_json(self.board.structure.names)}


@dataclass(frozen=True)
class ManualSession(Shown):
    """A sequence of proposals on six legs; every method returns a new session.

    `first` is the board at the start, `history` the proposals with their outcomes, refused ones among them. `undone`
    holds what `redo` brings back, the latest first: each time a confirmed or possible proposal with the
    refusals that followed it.
    Methods raise InputError (with place) where a proposal makes no sense, LimitReached where it could not be decided.
    """

    first: Board
    history: tuple[Record, ...] = ()
    undone: tuple[tuple[Record, ...], ...] = ()

    @classmethod
    def start(
        cls,
        legs: str | Iterable[str | Sequence[str]] | Structure,
        *,
        order: str | Sequence[int | str] | None = None,
        form: int = 24,
        points: Names = (),
        ideal: Names = (),
    ) -> ManualSession:
        """A session on six legs (as for `gcrules.analyze`) in the order and form given. Raises InputError."""
        structure = legs if isinstance(legs, Structure) else read_legs(legs, points=points, ideal=ideal)
        first = tuple(range(6))
        legs_in = first if order is None else read_order(order, structure)
        board = replace(Board.of(structure, legs_in, form), chosen=(legs_in, form) != (first, 24))
        analysis = automatic(structure)
        if analysis.condition.kind == "always-singular":
            board = replace(board, condition=analysis.condition)
        return cls(board)

    # --- what is known ---------------------------------------------------------------------------------------------

    @property
    def structure(self) -> Structure:
        return self.first.structure

    @property
    def board(self) -> Board:
        """The form, the entities and the condition as they stand."""
        return self.history[-1].board if self.history else self.first

    @property
    def outcome(self) -> ProposalOutcome | None:
        """The answer to the last proposal."""
        return self.history[-1].outcome if self.history else None

    @property
    def confirmed(self) -> Condition | None:
        """The condition, once it is confirmed."""
        return self.board.condition

    @property
    def left(self) -> tuple[str, ...]:
        """The points that nothing has taken yet."""
        return self.board.named(self.board.left)

    @property
    def statement(self) -> str:
        """The condition in words. Raises InputError before it is confirmed."""
        if self.confirmed is None:
            raise InputError("no condition is confirmed yet", hint="propose one: condition")
        return self.confirmed.sentence

    def hint(self) -> Hint:
        """The next step of the automatic procedure from here."""
        return suggest(self.board)

    def orders(self) -> dict[int, dict[int, int]]:
        """For both forms: number of terms -> how many of the 720 orders of the legs give so many."""
        return orders(self.structure)

    # --- proposals -------------------------------------------------------------------------------------------------

    def order(self, order: str | Sequence[int | str]) -> ManualSession:
        """Write the superbracket with the legs in this order; entities are given up."""
        words = order if isinstance(order, str) else " ".join(str(i + 1) if isinstance(i, int) else i for i in order)
        return self._propose("order", words)

    def form(self, form: int) -> ManualSession:
        """Take the 24-term or the 16-term form; entities are given up."""
        return self._propose("form", str(form))

    def shortest(self) -> ManualSession:
        """Take the shortest form."""
        return self._propose("shortest", "")

    def tetrahedron(self, points: str | Sequence[str]) -> ManualSession:
        """Four points whose bracket stands in every term."""
        return self._propose("tetrahedron", _spelt(points))

    def plane(self, points: str | Sequence[str]) -> ManualSession:
        """Three points that stay together in a bracket of their own in every term, or the three left over."""
        return self._propose("plane", _spelt(points))

    def line(self, points: str | Sequence[str]) -> ManualSession:
        """Two points that stay together in a bracket of their own in every term."""
        return self._propose("line", _spelt(points))

    def pair(self, points: str | Sequence[str]) -> ManualSession:
        """Two left-over points x, y with P(x,y) + P(y,x) = 0, a line."""
        return self._propose("pair", _spelt(points))

    def lines(self, points: str | Sequence[str]) -> ManualSession:
        """Four left-over points as two lines, "Cc Dd"."""
        return self._propose("lines", _spelt(points))

    def condition(self, expression: str | Expr | None = None, cofactor: str | Expr | None = None) -> ManualSession:
        """cofactor · superbracket = c · expression; without an expression the incidence of the entities."""
        parts = [self._written(e) for e in (expression, cofactor) if e is not None]
        return self._propose("condition", " cofactor ".join(parts))

    def undo(self) -> ManualSession:
        """Take back the last proposal that was not refused and the refusals after it. Raises InputError without one."""
        at = next((i for i in reversed(range(len(self.history))) if not self.history[i].outcome.refused), None)
        if at is None:
            raise InputError("nothing to undo: no proposal stands")
        return ManualSession(self.first, self.history[:at], (self.history[at:], *self.undone))

    def redo(self) -> ManualSession:
        """Bring back what the last `undo` took. Raises InputError where there is nothing."""
        if not self.undone:
            raise InputError("nothing to redo")
        return ManualSession(self.first, (*self.history, *self.undone[0]), self.undone[1:])

    def auto(self) -> ManualSession:
        """Follow the hints until the condition is confirmed; refused where they lead nowhere."""
        session = self
        self._check_open("auto")
        for _ in range(_MOST_STEPS):
            if session.confirmed is not None:
                return session
            hint = session.hint()
            if hint.command is None or hint.command == "undo":
                return session._recorded("auto", session.board, refused("no-way", hint.why, "undo goes back a step"))
            session = session.do(hint.command)
        raise AssertionError("the hints do not come to an end")

    def do(self, command: str) -> ManualSession:
        """One command as text: a proposal, undo, redo or auto. Raises InputError with its place in the text."""
        verb, start = _verb(command)
        argument = command[start:].strip()
        if verb in PROPOSALS:
            return self._propose(verb, argument, CommandWords(argument, command, start))
        if verb not in MOVES:
            hint = near(verb, (*PROPOSALS, *MOVES)) or f"there are {', '.join((*PROPOSALS, *MOVES))}"
            at = command.find(verb)
            what = f"there is no command {verb}" if verb else "a command is missing"
            raise InputError(what, source=command, span=Span(at, at + max(1, len(verb))), hint=hint)
        CommandWords(argument, command, start).nothing(verb)
        moves: Mapping[str, Callable[[], ManualSession]] = {"undo": self.undo, "redo": self.redo, "auto": self.auto}
        return moves[verb]()

    def _propose(self, verb: str, argument: str, words: CommandWords | None = None) -> ManualSession:
        command = f"{verb} {' '.join(argument.split())}".rstrip()
        words = words or CommandWords(command[len(verb) :].strip(), command, min(len(verb) + 1, len(command)))
        self._check_open(words.source)
        board, outcome = PROPOSALS[verb](self.board, words)
        return self._recorded(command, board, outcome)

    def _recorded(self, command: str, board: Board, outcome: ProposalOutcome) -> ManualSession:
        undone = self.undone if outcome.refused else ()
        return ManualSession(self.first, (*self.history, Record(command, outcome, board)), undone)

    def _check_open(self, command: str) -> None:
        if self.confirmed is None:
            return
        span = Span(0, len(command))
        if self.confirmed.kind == "always-singular":
            hint = self.confirmed.sentence
            raise InputError("nothing can be proposed", source=command, span=span, hint=hint)
        raise InputError("the condition is already confirmed", source=command, span=span, hint="undo takes it back")

    def _written(self, e: str | Expr) -> str:
        return text(e, names=self.structure.names) if isinstance(e, Expr) else e

    def to_json(self) -> dict[str, Any]:
        """`{schema, legs, points, base, platform, form {form, order, terms, polynomial}, entities, left, condition,
        hint, history, undone}`; the order of the legs counts from 0, as in the object of `analyze`.
        """
        board, s = self.board, self.structure
        shown = SuperbracketForm(board.form.form, board.form.order, board.polynomial)
        return {
            "schema": 1,
            "legs": [list(leg) for leg in s.legs],
            "points": list(s.names),
            "ideal": list(s.ideal),
            "base": list(s.base),
            "platform": list(s.platform),
            "form": shown.to_json(),
            "entities": [e.to_json() for e in board.starred],
            "left": list(self.left),
            "condition": self.confirmed.to_json(s.names) if self.confirmed else None,
            "hint": self.hint().to_json(),
            "history": [r.to_json() for r in self.history],
            "undone": [r.command for chunk in self.undone for r in chunk],
        }


def _spelt(points: str | Sequence[str]) -> str:
    return points if isinstance(points, str) else " ".join(points)


def _verb(command: str) -> tuple[str, int]:
    """The first word and where what follows begins."""
    bare = command.lstrip()
    verb = bare.split(None, 1)[0] if bare else ""
    rest = bare[len(verb) :]
    start = len(command) - len(bare) + len(verb) + len(rest) - len(rest.lstrip())
    return verb, start
