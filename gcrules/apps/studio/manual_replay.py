"""Manual mode: the commands of a session by hand, replayed from the start; the server keeps nothing of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.formulas import monomials
from gcrules.apps.studio.protocol.answer_views import ExactPoint, FormView, HintView, Manual, ManualStep
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.study import condition_view
from gcrules.apps.studio.subject import Subject
from gcrules.conditions.manual import ManualSession, ProposalOutcome, Record
from gcrules.core.budget import report
from gcrules.core.errors import GcrulesError, InputError
from gcrules.views.report.scene_json import entity_data
from gcrules.views.scene_data import EntityView

__all__ = ["replayed"]


def replayed(subject: Subject, commands: Sequence[str]) -> Manual:
    """What the commands lead to; the first one at fault stops them. Raises InputError where there are no six legs."""
    s = subject.structure
    if s is None or s.rank != 4 or s.stand_ins:
        raise InputError("manual mode is for six lines in space, each through two points")
    session = ManualSession.start(s)
    fault: FaultView | None = None
    for n, command in enumerate(commands, 1):
        report(f"step {n} of {len(commands)}")
        try:
            session = session.do(command)
        except GcrulesError as wrong:
            fault = fault_view(wrong)
            break
    last = session.outcome
    confirmed = session.confirmed
    return {
        "history": [_record(r) for r in session.history],
        "form": _form(session),
        "entities": _entities(session),
        "left": list(session.left),
        "hint": _hint(session) if confirmed is None else None,
        "counterexample": _points(last) if last is not None and last.refused and fault is None else None,
        "condition": None if confirmed is None else condition_view(session.structure, confirmed),
        "fault": fault,
    }


def _record(r: Record) -> ManualStep:
    term = r.outcome.data.get("term")
    return {
        "command": r.command,
        "answer": r.outcome.answer,
        "words": "\n".join(r.outcome.words),
        "monomial": term - 1 if isinstance(term, int) else None,
    }


def _form(session: ManualSession) -> FormView:
    board = session.board
    return {
        "name": f"{board.form.form}-term form",
        "order": ", ".join(session.structure.words[i] for i in board.form.order),
        "monomials": monomials(board.polynomial),
    }


def _entities(session: ManualSession) -> list[EntityView]:
    return [entity_data(e, i) for i, e in enumerate(session.board.starred)]


def _hint(session: ManualSession) -> HintView | None:
    hint = session.hint()
    return {"command": hint.command, "words": hint.why} if hint.command else None


def _points(outcome: ProposalOutcome) -> dict[str, ExactPoint] | None:
    """The exact points that refute a proposal; None where one of them is at infinity."""
    given: Mapping[str, Any] = outcome.data.get("points", {})
    if not given or not all(len(p) == 4 and p[3] for p in given.values()):
        return None
    places = {n: [Fraction(c) / p[3] for c in p[:3]] for n, p in given.items()}
    return {n: {"at": [float(c) for c in p], "exactly": [str(c) for c in p]} for n, p in places.items()}
