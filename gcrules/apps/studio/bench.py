r"""The expression bench: statements and expressions of the language, their results in formulas and in space.

>>> view = bench("let p = ab /\\ cde\n[abcd] [efgh] == [efgh] [abcd]\nab /\\", None, None)
>>> [(r["name"], r["verdict"], r["step"], r["start"], r["end"]) for r in view["results"]]
[('p', 'value', 1, 0, 17), (None, 'proved', None, 18, 48)]
>>> view["fault"]["place"]
{'start': 54, 'end': 54, 'line': 3, 'column': 6}
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Literal

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.apps.repl.answers import Answer, bound_text
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import InputPiece as Input
from gcrules.apps.repl.reading import Source, first_word, pieces, split_command
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.apps.repl.tables import STATEMENTS, meant
from gcrules.apps.studio.faults import fault_view, units
from gcrules.apps.studio.formulas import pieces as in_pieces
from gcrules.apps.studio.places import homogeneous_at
from gcrules.apps.studio.protocol.answer_views import Bench, BenchResult, DrawnPlane
from gcrules.apps.studio.protocol.bench_words import BENCH_COMMANDS
from gcrules.apps.studio.protocol.requests import HOME, PoseJson
from gcrules.apps.studio.protocol.study_views import Piece
from gcrules.apps.studio.subject import Subject
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.poses.numbers.extensors import coordinates, line_vectors, plane_equation
from gcrules.views.scene_data import Constructed, NamedLineView, NamedPointView

__all__ = ["bench", "context_of"]

_MOST_PIECES = 2_000
_MOST_TERMS = 20_000
_FAR = 1e-9  # of the size of a homogeneous coordinate: what is nearer to 0 counts as at infinity
_VERDICTS: Mapping[str, Literal["value", "proved", "refuted", "undecided", "done"]] = {
    "proved": "proved",
    "refuted": "refuted",
    "undecided": "undecided",
    "shown": "value",
    "done": "done",
}


def bench(text: str, subject: Subject | None, pose: PoseJson | None) -> Bench:
    """The results of all inputs of a text up to the first fault. Extensors of points of the subject are drawn at the
    pose.
    """
    interpreter = Interpreter(PromptState(context_of(subject)), Settings(limit=_MOST_TERMS))
    at = _places(subject, pose or HOME)
    results: list[BenchResult] = []
    lines = text.split("\n")
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)
    for given in pieces(lines):
        start = starts[given.line - 1]
        place = Span(units(text[:start]), units(text[:start]) + units(given.text.rstrip()))
        try:
            results += _results(interpreter, given, place, at if interpreter.state.context.rank == 4 else {})
        except GcrulesError as fault:
            _in_text(fault, text, starts)
            return {"results": results, "fault": fault_view(fault)}
    return {"results": results, "fault": None}


def _places(subject: Subject | None, pose: PoseJson) -> Mapping[str, Any]:
    """Where the points are; nowhere in a pose that cannot be, in which formulas are as good as elsewhere."""
    if subject is None:
        return {}
    try:
        return homogeneous_at(subject, pose)
    except InputError:
        return {}


def context_of(subject: Subject | None) -> Context:
    """The points of the subject that have to be declared: long names, and points at infinity."""
    s = subject.structure if subject else None
    if s is None:
        return Context()
    return Context(s.rank, tuple(n for n in s.names if not SHORT_NAME.fullmatch(n)), s.ideal)


def _results(interpreter: Interpreter, given: Input, place: Span, at: Mapping[str, Any]) -> Iterator[BenchResult]:
    called = split_command(given.text)
    if called is not None:
        yield from _asked(interpreter, given, place, *called)
        return
    source = Source.of(given.text, "<bench>", given.line)
    if first_word(given.text) in STATEMENTS:
        known = set(interpreter.state.context.bound)
        answers = [a for a in interpreter.run(source) if " = " not in a.text or a.verdict != "done"]
        context = interpreter.state.context
        for name in [n for n in context.bound if n not in known]:
            e = context.bound[name]
            words = bound_text(name, context, interpreter.settings)
            yield _result(place, words, "value", name, in_pieces(e), e.step, _drawn(e, name, at))
        yield from (_said(place, a) for a in answers)
    elif "==" in given.text:
        yield from (_said(place, a) for a in interpreter.equation(source))
    else:
        yield from _expression(interpreter, source, place, at)


def _asked(interpreter: Interpreter, given: Input, place: Span, name: str, at: int) -> Iterator[BenchResult]:
    """What a command of the prompt answers, if it asks something of algebra; files and a session are none here."""
    if not set(meant(name)) <= {*BENCH_COMMANDS}:
        span = Span(given.line - 1, given.line - 1 + len(given.text))
        known = ", ".join(f":{n}" for n in BENCH_COMMANDS)
        hint = f"write {known}; or statements (let, points, claim, show …), expressions and equations"
        source = Source.of(given.text, "<bench>", given.line)
        raise InputError("this command of the prompt does not work here", span=span, source=source.text, hint=hint)
    before = interpreter.state.results
    for answer in interpreter.command(given, "<bench>", name, at):
        after = interpreter.state.results
        shown = in_pieces(after[0])[:_MOST_PIECES] if after is not before else []
        verdict = _VERDICTS.get(answer.verdict, "done")
        asked = next(iter(meant(name)), name)
        yield _result(place, answer.text, verdict, shown=shown, command=asked)


def _said(place: Span, answer: Answer) -> BenchResult:
    return _result(place, answer.text, _VERDICTS.get(answer.verdict, "done"))


def _expression(interpreter: Interpreter, source: Source, place: Span, at: Mapping[str, Any]) -> Iterator[BenchResult]:
    """The expansion of an expression."""
    e = interpreter.expression(source)
    before = interpreter.state.results
    for answer in interpreter.shown(e, source):
        after = interpreter.state.results
        shown: list[Piece] = []
        if after is not before:
            shown = in_pieces(after[0])[:_MOST_PIECES]
        words = str(e) if e.step else answer.text
        yield _result(
            place, answer.text, _VERDICTS.get(answer.verdict, "done"), None, shown, e.step, _drawn(e, words, at)
        )


def _result(
    place: Span,
    text: str,
    verdict: Literal["value", "proved", "refuted", "undecided", "done"],
    name: str | None = None,
    shown: list[Piece] | None = None,
    step: int | None = None,
    drawn: Constructed | DrawnPlane | None = None,
    command: str | None = None,
) -> BenchResult:
    return {
        "start": place.start,
        "end": place.end,
        "name": name,
        "command": command,
        "verdict": verdict,
        "text": text,
        "pieces": shown or [],
        "step": step,
        "drawn": drawn,
    }


def _in_text(fault: GcrulesError, text: str, starts: list[int]) -> None:
    """The place of a fault in the whole text, which the interpreter reads input by input."""
    if fault.span is None or fault.source is None:
        return
    line, column = fault.span.line_column(fault.source)
    start = min(starts[min(line, len(starts)) - 1] + column - 1, len(text))
    fault.span = Span(start, min(start + fault.span.end - fault.span.start, len(text)))
    fault.source = text


# --- in space ------------------------------------------------------------------------------------------------------


def _drawn(e: Expr, label: str, at: Mapping[str, Any]) -> Constructed | DrawnPlane | None:
    """A point, line or plane through points of the subject; None for anything else, and at infinity."""
    if e.step not in _SHOWN or not points_of(e) or not set(points_of(e)) <= set(at):
        return None
    found = coordinates(e, at)
    size = float(abs(found).max())
    return _SHOWN[e.step](found / size, label) if size else None


def _point(found: Any, label: str) -> NamedPointView | None:
    *xyz, w = map(float, found[0])
    if abs(w) <= _FAR:
        return None
    return {"kind": "point", "label": label, "at": [c / w for c in xyz], "entities": []}


def _line(found: Any, label: str) -> NamedLineView | None:
    import numpy as np

    (d,), (m,) = line_vectors(found)
    size = float(np.linalg.norm(d))
    if size <= _FAR:
        return None
    foot = np.cross(d, m) / size**2
    return {"kind": "line", "label": label, "at": foot.tolist(), "direction": (d / size).tolist(), "entities": []}


def _plane(found: Any, label: str) -> DrawnPlane | None:
    import numpy as np

    *normal, d = plane_equation(found)[0]
    size = float(np.linalg.norm(normal))
    if size <= _FAR:
        return None
    return {"kind": "plane", "label": label, "normal": [float(c) / size for c in normal], "offset": -float(d) / size}


_SHOWN: Mapping[int, Callable[[Any, str], Constructed | DrawnPlane | None]] = {1: _point, 2: _line, 3: _plane}
"""What draws an extensor of each step."""
